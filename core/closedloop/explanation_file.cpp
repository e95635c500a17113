#include "closedloop/explanation_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/json_reading.h"
#include "closedloop/hardware/effects.h"
#include "closedloop/inference/posterior.h"
#include "closedloop/learnt_organ.h"
#include "closedloop/material/effects.h"

namespace glisson::closedloop {
namespace {

constexpr const char* model_format = "glisson-closedloop-model/1";

// "rms" -> "rms_mm" where the unit is a length; elsewhere the report's "unit" says it.
class Names {
 public:
  explicit Names(const Observations& observations) : suffix_(observations.unit == "mm" ? "_mm" : "") {}
  [[nodiscard]] std::string operator()(const std::string& name) const { return name + suffix_; }

 private:
  std::string suffix_;
};

Json json_of(const Sentence& sentence) { return {{"text", sentence.text}, {"arguments", sentence.arguments}}; }
Json json_of(const ErrorFigures& figures, const Observations& observations);
Json json_of(const ResidualDiagnostics& diagnostics);
Json json_of(const FoundEffect& effect, const Names& named);
Json json_of(const RankedCandidate& candidate, const Names& named);
Json parameters_json(const std::vector<FoundParameter>& parameters);
Json numbers(const Eigen::VectorXd& values);

}  // namespace

BetterModel better_model(const Explanation& explanation) {
  return {explanation.settings, explanation.smooth_correction, explanation.mesh_error_share, explanation.reading};
}

std::string name_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::nothing_missing: return "nothing-missing";
    case Verdict::explained: return "explained";
    default: return "unexplained";
  }
}

std::string kind_of(const Experiment& experiment) {
  constexpr std::array<const char*, 6> kinds{"palpation", "material",   "platform",
                                             "guidance",  "full-field", "elastography"};
  return kinds.at(experiment.setup.index());
}

Json report_json(const Explanation& explanation, const Observations& observations, const PosteriorHistory& history) {
  const Names named(observations);
  Json json{{"verdict", name_of(explanation.verdict)}, {"unit", observations.unit}};
  json["before"] = json_of(explanation.before, observations);
  json["after"] = json_of(explanation.after, observations);
  if (explanation.held_out_before) {
    json["before"][named("held_out_rms")] = explanation.held_out_before->rms;
    json["before"][named("held_out_interval")] = {explanation.held_out_before->low, explanation.held_out_before->high};
  }
  const auto& held_out = explanation.held_out_corrected ? explanation.held_out_corrected : explanation.held_out;
  if (held_out) {
    json["after"][named("held_out_rms")] = held_out->rms;
    json["after"][named("held_out_mean")] = held_out->mean;
    json["after"][named("held_out_p95")] = held_out->p95;
    json["after"][named("held_out_interval")] = {held_out->low, held_out->high};
  } else {
    json["after"]["held_out"] = observations.trial_count() < 2 ? "one trial cannot be left out"
                                                               : "not given: fitted to the others it predicts nothing";
  }
  if (explanation.hidden_targets) {
    const auto figures = [](const ErrorFigures& errors) {
      return Json{{"mean_mm", errors.mean}, {"p95_mm", errors.p95}, {"max_mm", errors.max}};
    };
    json["hidden_targets"] = {{"before", figures(explanation.hidden_targets->before)},
                              {"after", figures(explanation.hidden_targets->after)}};
  }
  json["effects"] = Json::array();
  for (const FoundEffect& effect : explanation.effects) {
    json["effects"].push_back(json_of(effect, named));
    json["effects"].back()["confident"] = explanation.verdict == Verdict::explained;
  }
  if (explanation.smooth_correction) {
    Json smooth{{"kind", "smooth-correction"},
                {"parameters", {{"length_scale", {{"value", explanation.smooth_correction->length_scale}}}}},
                {"sentence", "A smooth correction over load and place: it predicts better, and claims no cause."},
                {"confident", false},
                {"alike", Json::array()}};
    if (explanation.held_out_corrected)
      smooth["evidence"] = {{named("held_out_rms"), explanation.held_out_corrected->rms}};
    if (explanation.held_out) smooth["evidence"][named("held_out_rms_without")] = explanation.held_out->rms;
    json["effects"].push_back(std::move(smooth));
  }
  json["ranking"] = Json::array();
  for (const RankedCandidate& candidate : explanation.ranking) json["ranking"].push_back(json_of(candidate, named));
  json["residual"] = {{"before", json_of(explanation.residual_before)}, {"after", json_of(explanation.residual_after)}};
  json["next_measurement"] = nullptr;
  json["next_trials"] = Json::array();
  for (const NextMeasurement& next : explanation.next.to_make) {
    Json pieces = json_of(next.sentence);
    pieces["alternatives"] = next.alternatives;
    pieces["doubt_removed"] = next.doubt_removed;
    json["next_trials"].push_back(std::move(pieces));
  }
  if (!explanation.next.to_make.empty()) {
    const NextMeasurement& next = explanation.next.to_make.front();
    json["next_measurement"] = next.sentence.message();
    if (!next.alternatives.empty())
      json["next_measurement"] = fmt::format("{} It would tell what is likeliest from: {}.", next.sentence.message(),
                                             fmt::join(next.alternatives, ", "));
  }
  if (!explanation.posterior.empty()) {
    json["posterior"] = {{"explanations", json_of(explanation.posterior)},
                         {"of_effects", explanation.of_effects},
                         {"sentence", posterior_sentence(explanation).message()}};
  }
  if (!history.empty()) json["history"] = json_of(history);
  if (explanation.verdict == Verdict::nothing_missing) {
    Json& visible = json["smallest_visible"] = Json::array();
    for (const SmallestVisible& one : explanation.smallest_visible) {
      visible.push_back({{"kind", one.kind}, {"parameter", one.parameter}, {"no_effect", one.no_effect}});
      if (!one.form.empty()) visible.back()["law"] = one.form;
      if (one.component > 0) visible.back()["component"] = one.component;
      visible.back()["value"] = one.value ? Json(*one.value) : Json(nullptr);
    }
  }
  json["notes"] = messages(explanation.notes);
  json["note_pieces"] = Json::array();
  for (const Sentence& note : explanation.notes) json["note_pieces"].push_back(json_of(note));
  return null_where_not_finite(std::move(json));
}

std::string model_text(const Explanation& explanation, const ForwardModel& model, const Experiment& experiment) {
  Json json{{"format", model_format},
            {"kind", kind_of(experiment)},
            {"title", experiment.title},
            {"verdict", name_of(explanation.verdict)},
            {"learnt_from", experiment.file.filename().string()},
            {"effects", Json::array()}};
  const auto* palpation = std::get_if<Palpation>(&experiment.setup);
  if (const auto* guidance = std::get_if<Guidance>(&experiment.setup)) palpation = &guidance->organ;
  if (palpation != nullptr) {
    const SpecimenPlace place = place_of(palpation->mesh);
    json["specimen"] = {{"min_mm", glisson::json_of(place.min_mm)},
                        {"max_mm", glisson::json_of(place.max_mm)},
                        {"volume_mm3", place.volume_mm3}};
  }
  for (const FoundEffect& effect : explanation.effects) {
    Json one{{"kind", effect.kind}};
    if (!effect.form.empty()) one["law"] = effect.form;
    one["parameters"] = Json::object();
    for (const FoundParameter& found : effect.parameters) {
      Json& value = one["parameters"][found.parameter.name];
      if (value.is_null()) {
        value = found.value;
      } else if (value.is_array()) {
        value.push_back(found.value);
      } else {
        value = Json::array({value, found.value});
      }
    }
    one["sentence"] = effect.sentence;
    json["effects"].push_back(std::move(one));
  }
  if (!explanation.reading.empty()) json["reading"] = explanation.reading;
  if (explanation.mesh_error_share != 0) json["mesh_error_share"] = explanation.mesh_error_share;
  if (const auto& smooth = explanation.smooth_correction) {
    Json rows = Json::array();
    for (Eigen::Index row = 0; row < smooth->features.rows(); ++row) rows.push_back(numbers(smooth->features.row(row)));
    json["smooth_correction"] = {{"directions", model.observations().directions},
                                 {"center", numbers(smooth->center)},
                                 {"spread", numbers(smooth->spread)},
                                 {"length_scale", smooth->length_scale},
                                 {"features", std::move(rows)},
                                 {"direction", smooth->directions},
                                 {"weights", numbers(smooth->weights)}};
  }
  return json.dump(2) + "\n";
}

namespace {

[[noreturn]] void refuse_model(std::string text, std::vector<std::string> arguments) {
  refuse("model-invalid", std::move(text), std::move(arguments),
         GLISSON_TEXT("Use the model.json that glisson-cli explain wrote for an experiment of this kind."));
}

BetterModel better_model_from(const Json& json, const std::string& file, const ForwardModel& model,
                              const Experiment& experiment);

std::vector<Effect> known_effects(const ForwardModel& model, const Experiment& experiment);
Setting setting_from(const Json& json, const std::vector<Effect>& known);
SmoothCorrection smooth_from(const Json& json, const Observations& observations);

}  // namespace

Result<BetterModel> read_model(const std::filesystem::path& file, const ForwardModel& model,
                               const Experiment& experiment) {
  const auto document = read_json_file(file);
  if (!document) return failure(document.error());
  return reading("model-invalid", file, [&] {
    try {
      return better_model_from(*document, file.filename().string(), model, experiment);
    } catch (const Json::exception&) {
      refuse("model-invalid", GLISSON_TEXT("{0} is not a complete model."), {file.filename().string()});
    }
  });
}

Result<Eigen::VectorXd> predict_with(const ForwardModel& model, const BetterModel& better) {
  auto predicted = model.predict_as(better.reading, better.settings);
  if (predicted && better.mesh_error_share != 0) {
    const Eigen::VectorXd expected = model.systematic_uncertainty().expected;
    if (expected.size() == predicted->size()) *predicted += better.mesh_error_share * expected;
  }
  if (predicted && better.smooth_correction) *predicted += correction(*better.smooth_correction, model.observations());
  return predicted;
}

namespace {

BetterModel better_model_from(const Json& json, const std::string& file, const ForwardModel& model,
                              const Experiment& experiment) {
  if (!json.is_object() || json.value("format", Json()) != model_format)
    refuse_model(GLISSON_TEXT("{0} is not a model of the format {1}."), {file, model_format});
  if (json.value("kind", Json()) != kind_of(experiment))
    refuse_model(GLISSON_TEXT("{0} was not learnt from an experiment of the kind {1}."), {file, kind_of(experiment)});
  BetterModel better;
  const std::vector<Effect> known = known_effects(model, experiment);
  for (const Json& effect : json.at("effects")) better.settings.push_back(setting_from(effect, known));
  better.mesh_error_share = json.value("mesh_error_share", 0.0);
  better.reading = json.value("reading", std::string());
  if (json.contains("smooth_correction"))
    better.smooth_correction = smooth_from(json.at("smooth_correction"), model.observations());
  return better;
}

// What a model of this kind of experiment can be switched to, whether or not these trials could show it.
std::vector<Effect> known_effects(const ForwardModel& model, const Experiment& experiment) {
  std::vector<Effect> known;
  if (const auto* material = std::get_if<Material>(&experiment.setup)) {
    for (MaterialEffect& effect : known_material_effects(*material)) known.push_back(std::move(effect.effect));
  } else if (const auto* hardware = std::get_if<Hardware>(&experiment.setup)) {
    for (HardwareEffect& effect : known_hardware_effects(*hardware)) known.push_back(std::move(effect.effect));
  } else {
    known = model.catalogue();
  }
  return known;
}

Setting setting_from(const Json& json, const std::vector<Effect>& known) {
  const auto kind = json.at("kind").get<std::string>();
  const std::string form = json.value("law", std::string());
  const auto effect =
      std::find_if(known.begin(), known.end(), [&](const Effect& one) { return one.kind == kind && one.form == form; });
  if (effect == known.end())
    refuse_model(GLISSON_TEXT("The effect {0} is unknown to this experiment."),
                 {kind + (form.empty() ? "" : " " + form)});
  Setting setting{kind, form, Eigen::VectorXd(effect->size())};
  const Json& parameters = json.at("parameters");
  std::string last;
  std::size_t component = 0;
  for (Eigen::Index p = 0; p < effect->size(); ++p) {
    const std::string& name = effect->parameters[static_cast<std::size_t>(p)].name;
    component = name == last ? component + 1 : 0;
    last = name;
    const Json& value = parameters.at(name);
    setting.parameters[p] = (value.is_array() ? value.at(component) : value).get<double>();
    if (!std::isfinite(setting.parameters[p])) refuse_model(GLISSON_TEXT("{0} of {1} is no number."), {name, kind});
  }
  return setting;
}

Eigen::VectorXd vector_from(const Json& json) {
  const auto values = json.get<std::vector<double>>();
  return Eigen::VectorXd::Map(values.data(), static_cast<Eigen::Index>(values.size()));
}

SmoothCorrection smooth_from(const Json& json, const Observations& observations) {
  SmoothCorrection smooth;
  const Eigen::Index columns = features_of(observations).cols();
  smooth.center = vector_from(json.at("center")).transpose();
  smooth.spread = vector_from(json.at("spread")).transpose();
  smooth.length_scale = json.at("length_scale").get<double>();
  smooth.directions = json.at("direction").get<std::vector<int>>();
  smooth.weights = vector_from(json.at("weights"));
  const Json& rows = json.at("features");
  smooth.features.resize(static_cast<Eigen::Index>(rows.size()), columns);
  if (json.at("directions").get<std::vector<std::string>>() != observations.directions ||
      smooth.center.size() != columns || smooth.spread.size() != columns ||
      smooth.weights.size() != smooth.features.rows() || smooth.directions.size() != rows.size() ||
      !(smooth.length_scale > 0))
    refuse_model(GLISSON_TEXT("The smooth correction was made for other quantities than this experiment has."), {});
  for (std::size_t row = 0; row < rows.size(); ++row) {
    const Eigen::VectorXd features = vector_from(rows[row]);
    if (features.size() != columns) refuse_model(GLISSON_TEXT("The smooth correction is not complete."), {});
    smooth.features.row(static_cast<Eigen::Index>(row)) = features.transpose();
  }
  return smooth;
}

Json numbers(const Eigen::VectorXd& values) { return std::vector<double>(values.begin(), values.end()); }

Json json_of(const ErrorFigures& figures, const Observations& observations) {
  const Names named(observations);
  Json json{{named("rms"), figures.rms}, {named("mean"), figures.mean},   {named("p95"), figures.p95},
            {named("max"), figures.max}, {named("noise"), figures.noise}, {"reduced_chi2", figures.reduced_chi2}};
  for (std::size_t d = 0; d < figures.rms_of_direction.size(); ++d)
    if (figures.rms_of_direction[d]) json["rms_" + observations.directions[d]] = *figures.rms_of_direction[d];
  return json;
}

Json json_of(const ResidualDiagnostics& diagnostics) {
  Json json{{"is_noise", diagnostics.is_noise}, {"smallest_p", diagnostics.smallest_p}, {"shape", diagnostics.shape()}};
  for (const NoiseTest& test : diagnostics.tests)
    json["tests"].push_back({{"name", test.name}, {"statistic", test.statistic}, {"p_value", test.p_value}});
  return json;
}

// Consecutive parameters of one name become one entry with lists.
Json parameters_json(const std::vector<FoundParameter>& parameters) {
  Json json = Json::object();
  for (std::size_t first = 0; first < parameters.size();) {
    const std::string& name = parameters[first].parameter.name;
    std::size_t end = first;
    while (end < parameters.size() && parameters[end].parameter.name == name) ++end;
    const auto each = [&](auto&& of) {
      if (end == first + 1) return Json(of(parameters[first]));
      Json list = Json::array();
      for (std::size_t i = first; i < end; ++i) list.push_back(of(parameters[i]));
      return list;
    };
    json[name] = {{"value", each([](const FoundParameter& p) { return p.value; })},
                  {"std", each([](const FoundParameter& p) { return p.std; })},
                  {"interval", each([](const FoundParameter& p) {
                     return std::vector<double>{p.low, p.high};
                   })},
                  {"determined", each([](const FoundParameter& p) { return p.determined; })}};
    first = end;
  }
  return json;
}

Json json_of(const FoundEffect& effect, const Names& named) {
  Json json{{"kind", effect.kind}};
  json["parameters"] = parameters_json(effect.parameters);
  if (!effect.form.empty()) json["parameters"]["law"] = {{"value", effect.form}};
  json["evidence"] = {{"delta_bic", effect.delta_bic}, {named("removed_rms"), effect.removed_rms}};
  if (effect.held_out_rms) json["evidence"][named("held_out_rms")] = *effect.held_out_rms;
  if (effect.held_out_rms_without) json["evidence"][named("held_out_rms_without")] = *effect.held_out_rms_without;
  json["alike"] = effect.alike;
  json["sentence"] = effect.sentence;
  return json;
}

Json json_of(const RankedCandidate& candidate, const Names& named) {
  Json json{{"kind", candidate.kind}};
  if (!candidate.form.empty()) json["law"] = candidate.form;
  if (!candidate.removed.empty()) {
    json["removed"] = candidate.removed;
    return json;
  }
  json[named("rms")] = candidate.rms;
  if (candidate.held_out_rms) json[named("held_out_rms")] = *candidate.held_out_rms;
  if (!candidate.predicts) json["held_out"] = "not given: fitted to the others it predicts nothing";
  json["delta_bic"] = candidate.delta_bic;
  json["alike"] = candidate.alike;
  return json;
}

}  // namespace
}  // namespace glisson::closedloop
