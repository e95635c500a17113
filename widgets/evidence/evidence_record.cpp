#include "widgets/evidence/evidence_record.h"

#include <QRegularExpression>

#include "base/files.h"
#include "base/json.h"

namespace glisson::widgets {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t maximum_bytes = std::uint64_t{64} << 20;

Failure not_a_report(const fs::path& folder, const std::string& why) {
  return failure(
      Error{"not-a-report",
            GLISSON_TEXT("{0} does not hold a report of measurements: {1}."),
            {folder.string(), why},
            GLISSON_TEXT("Open an experiment to make one; it holds report.json, report.html and model.json."),
            folder});
}

// "rms_mm" where the unit is a length, "rms" elsewhere.
class Reader {
 public:
  explicit Reader(const Json& report) : suffix_(report.at("unit").get<std::string>() == "mm" ? "_mm" : "") {}

  [[nodiscard]] std::optional<double> number(const Json& json, const std::string& name) const {
    for (const std::string& each : {name + suffix_, name}) {
      if (json.contains(each) && json[each].is_number()) return json[each].get<double>();
    }
    return {};
  }

  [[nodiscard]] EvidenceErrors errors(const Json& json) const {
    EvidenceErrors errors{number(json, "rms").value(),
                          number(json, "mean").value_or(0),
                          number(json, "p95").value_or(0),
                          number(json, "noise").value_or(0),
                          number(json, "reduced_chi2").value_or(0),
                          {},
                          {},
                          {},
                          {}};
    errors.held_out_rms = number(json, "held_out_rms");
    const std::string interval = "held_out_interval" + suffix_;
    if (json.contains(interval)) {
      errors.held_out_low = json[interval].at(0).get<double>();
      errors.held_out_high = json[interval].at(1).get<double>();
    }
    return errors;
  }

 private:
  std::string suffix_;
};

std::string figure_of_record(double value) { return QString::number(value, 'g', 3).toStdString(); }

// A number, or a vector as (1, 2, 3); a law's name as it is.
std::string shown(const Json& json) {
  if (json.is_string()) return json.get<std::string>();
  if (json.is_number()) return figure_of_record(json.get<double>());
  if (!json.is_array()) return {};
  std::string text;
  for (const Json& each : json) text += (text.empty() ? "(" : ", ") + shown(each);
  return text + ")";
}

std::vector<std::string> strings(const Json& json, const char* key) {
  return json.contains(key) ? json[key].get<std::vector<std::string>>() : std::vector<std::string>();
}

Sentence sentence_in(const Json& pieces) {
  return {pieces.at("text").get<std::string>(), strings(pieces, "arguments")};
}

std::vector<EvidenceParameter> parameters_in(const Json& json) {
  std::vector<EvidenceParameter> parameters;
  for (const auto& [name, found] : json.items()) {
    if (name == "law") continue;
    EvidenceParameter parameter{name, shown(found.at("value")), {}, {}, {}, true};
    if (found.contains("std")) parameter.std = shown(found["std"]);
    // Of a vector every component has an interval of its own; its standard deviations say enough.
    if (found.contains("interval") && found["interval"].at(0).is_number()) {
      parameter.low = shown(found["interval"].at(0));
      parameter.high = shown(found["interval"].at(1));
    }
    if (found.contains("determined")) {
      const Json& determined = found["determined"];
      parameter.determined = determined.is_array() ? std::all_of(determined.begin(), determined.end(),
                                                                 [](const Json& each) { return each.get<bool>(); })
                                                   : determined.get<bool>();
    }
    parameters.push_back(std::move(parameter));
  }
  return parameters;
}

std::vector<EvidenceVisible> visible_in(const Json& list) {
  std::vector<EvidenceVisible> visible;
  for (const Json& json : list) {
    EvidenceVisible one{json.at("kind").get<std::string>(),      json.value("law", std::string()),
                        json.at("parameter").get<std::string>(), json.value("component", 0),
                        json.at("no_effect").get<double>(),      {}};
    if (json.at("value").is_number()) one.value = json["value"].get<double>();
    visible.push_back(std::move(one));
  }
  return visible;
}

EvidenceRecord record_in(const Json& said, const Json& model) {
  const Reader reader(said);
  EvidenceRecord record;
  record.verdict = said.at("verdict").get<std::string>();
  record.unit = said.at("unit").get<std::string>();
  record.experiment_kind = model.at("kind").get<std::string>();
  record.learnt_from = model.value("learnt_from", std::string());
  record.title = model.value("title", record.learnt_from);
  record.before = reader.errors(said.at("before"));
  record.after = reader.errors(said.at("after"));
  if (said.contains("hidden_targets")) {
    record.before.hidden_target_mm = said["hidden_targets"].at("before").at("mean_mm").get<double>();
    record.after.hidden_target_mm = said["hidden_targets"].at("after").at("mean_mm").get<double>();
  }
  if (said.contains("residual")) {
    record.shape_before = strings(said["residual"].at("before"), "shape");
    record.shape_after = strings(said["residual"].at("after"), "shape");
  }
  for (const Json& json : said.at("effects")) {
    EvidenceEffect effect{json.at("kind").get<std::string>(),
                          {},
                          json.value("sentence", std::string()),
                          parameters_in(json.at("parameters")),
                          {},
                          {},
                          {},
                          strings(json, "alike")};
    if (json["parameters"].contains("law")) effect.law = shown(json["parameters"]["law"].at("value"));
    if (json.contains("evidence")) {
      effect.delta_bic = reader.number(json["evidence"], "delta_bic");
      effect.held_out_rms = reader.number(json["evidence"], "held_out_rms");
      effect.held_out_rms_without = reader.number(json["evidence"], "held_out_rms_without");
    }
    record.effects.push_back(std::move(effect));
  }
  for (const Json& json : said.at("ranking")) {
    record.ranking.push_back({json.at("kind").get<std::string>(), json.value("law", std::string()),
                              reader.number(json, "rms"), reader.number(json, "held_out_rms"),
                              reader.number(json, "delta_bic"), strings(json, "alike"),
                              json.value("removed", std::string())});
  }
  if (said.contains("posterior")) {
    for (const Json& one : said["posterior"].at("explanations")) {
      EvidenceProbability read{{}, one.at("probability").get<double>()};
      if (!one.at("kinds").is_null()) read.kinds = one["kinds"].get<std::vector<std::string>>();
      record.probabilities.push_back(std::move(read));
    }
  }
  record.visible = visible_in(said.value("smallest_visible", Json::array()));
  if (said.contains("next_trials")) {
    for (const Json& pieces : said["next_trials"])
      record.next.push_back(
          {sentence_in(pieces), strings(pieces, "alternatives"), reader.number(pieces, "doubt_removed")});
  } else if (said.contains("next_measurement_pieces")) {
    const Json& pieces = said["next_measurement_pieces"];
    record.next.push_back({sentence_in(pieces), strings(pieces, "alternatives"), {}});
  } else if (said.contains("next_measurement") && said["next_measurement"].is_string()) {
    record.next.push_back({{said["next_measurement"].get<std::string>(), {}}, {}, {}});
  }
  for (const Json& pieces : said.value("note_pieces", Json::array())) record.notes.push_back(sentence_in(pieces));
  if (!said.contains("note_pieces")) {  // of an older version, in English
    for (std::string& note : strings(said, "notes")) record.notes.push_back({std::move(note), {}});
  }
  return record;
}

// The page's drawings, each with the caption below it; probabilities are shown as what they are (probability_bars.h).
std::vector<EvidenceDrawing> drawings_in(const QString& html) {
  static const QRegularExpression drawing("<figure[^>]*>(<svg.*?</svg>)\\s*<figcaption>(.*?)</figcaption>",
                                          QRegularExpression::DotMatchesEverythingOption);
  std::vector<EvidenceDrawing> drawings;
  for (auto found = drawing.globalMatch(html); found.hasNext();) {
    const auto match = found.next();
    if (match.captured(1).contains("class=\"probabilities\"")) continue;
    drawings.push_back({match.captured(1).toStdString(), match.captured(2)});
  }
  return drawings;
}

}  // namespace

Result<EvidenceRecord> read_evidence(const fs::path& folder) {
  const auto report = read_json_file(folder / "report.json");
  if (!report) return not_a_report(folder, report.error().message());
  const auto model = read_json_file(folder / "model.json");
  if (!model) return not_a_report(folder, model.error().message());
  try {
    EvidenceRecord record = record_in(*report, *model);
    record.folder = folder;
    // Without the page there are no pictures; all else is there.
    if (const auto page = read_text_file(folder / "report.html", maximum_bytes)) {
      record.drawings = drawings_in(QString::fromStdString(*page));
    }
    return record;
  } catch (const std::exception& problem) {
    return not_a_report(folder, problem.what());
  }
}

}  // namespace glisson::widgets
