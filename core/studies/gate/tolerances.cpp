#include "studies/gate/gate.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "base/json.h"
#include "base/json_reading.h"

namespace glisson::studies {
namespace {

double share_in(const Json& json, const std::string& where) {
  const double share = number_in(json, where);
  if (share < 0 || share > 1) refuse_at(where, GLISSON_TEXT("{0} must lie between 0 and 1."));
  return share;
}

MetricTolerance tolerance_from(const std::string& metric, const Json& json, const std::string& where) {
  only_keys(json, {"better", "percent", "absolute", "each_case"}, where);
  MetricTolerance tolerance = usual_tolerance(metric);
  if (json.contains("better")) {
    using Better = MetricTolerance::Better;
    tolerance.better = one_of<Better>(json.at("better"), where + ", better",
                                      {{"lower", Better::lower}, {"higher", Better::higher}, {"same", Better::same}});
  }
  if (json.contains("percent")) tolerance.percent = not_negative_in(json.at("percent"), where + ", percent");
  if (json.contains("absolute")) tolerance.absolute = not_negative_in(json.at("absolute"), where + ", absolute");
  if (json.contains("each_case")) tolerance.each_case = truth_in(json.at("each_case"), where + ", each_case");
  return tolerance;
}

}  // namespace

Result<GateOptions> read_tolerances(const std::filesystem::path& file) {
  const auto document = read_json_file(file);
  if (!document) return failure(document.error());
  return reading("tolerances-invalid", file, [&] {
    only_keys(*document, {"metrics", "false_alarms", "similarity", "masks"}, "The tolerances");
    GateOptions options;
    if (document->contains("false_alarms"))
      options.false_alarms = share_in(document->at("false_alarms"), "false_alarms");
    if (document->contains("similarity")) options.similarity = share_in(document->at("similarity"), "similarity");
    for (const char* key : {"metrics", "masks"}) {
      if (document->contains(key) && !document->at(key).is_object())
        refuse_at(key, GLISSON_TEXT("{0} must be an object in braces."));
    }
    const Json metrics = document->value("metrics", Json::object()), masks = document->value("masks", Json::object());
    for (const auto& [name, json] : metrics.items())
      options.metrics[name] = tolerance_from(name, json, "metrics, " + name);
    for (const auto& [name, json] : masks.items())
      options.masks[name] = file.parent_path() / text_in(json, "masks, " + name);
    return options;
  });
}

MetricTolerance usual_tolerance(const std::string& metric) {
  constexpr std::array<std::string_view, 9> of_agreement{"dice", "jaccard", "correlation",  "auc",     "similarity",
                                                         "psnr", "ssim",    "frames_per_s", "accuracy"};
  MetricTolerance tolerance;
  const bool higher = std::any_of(of_agreement.begin(), of_agreement.end(),
                                  [&](std::string_view name) { return metric.find(name) != std::string::npos; });
  if (higher) tolerance.better = MetricTolerance::Better::higher;
  return tolerance;
}

}  // namespace glisson::studies
