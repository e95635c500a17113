#include "closedloop/experiment/experiment.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "base/files.h"
#include "closedloop/experiment/internal/experiment_source.h"

namespace glisson::closedloop {

namespace fs = std::filesystem;

namespace {

Experiment experiment_from(const Json& json, const Source& source, Needs needs);

}  // namespace

Result<Experiment> read_experiment(const fs::path& file, Needs needs) {
  Source source{file, {}};
  auto text = read_text_file(file, std::uint64_t{64} << 20);
  if (!text) return failure(std::move(text.error()));
  source.text = std::move(*text);
  const auto document = parse_json(source.text, file);
  if (!document) return failure(document.error());
  return reading("experiment-invalid", file, [&] { return experiment_from(*document, source, needs); });
}

namespace {

Experiment experiment_from(const Json& json, const Source& source, Needs needs) {
  if (!json.is_object() || json.value("format", Json()) != "glisson-experiment/1") {
    refuse("experiment-invalid", GLISSON_TEXT("{0} is not an experiment of the format \"glisson-experiment/1\"."),
           {source.file.filename().string()},
           GLISSON_TEXT("An experiment begins with \"format\": \"glisson-experiment/1\" and \"kind\"."));
  }
  Experiment experiment{
      source.file, json.contains("title") ? text_in(json["title"], "title") : source.file.stem().string(), {}};
  const std::string kind = text_in(required(json, "kind", "The experiment"), "kind");
  if (kind == "palpation") {
    experiment.setup = palpation_from(json, source, needs);
  } else if (kind == "material") {
    experiment.setup = material_from(json, source, needs);
  } else if (kind == "platform") {
    experiment.setup = hardware_from(json, source, needs);
  } else if (kind == "guidance") {
    experiment.setup = guidance_from(json, source);
  } else if (kind == "full-field") {
    experiment.setup = full_field_from(json, source, needs);
  } else if (kind == "elastography") {
    experiment.setup = elastography_from(json, source);
  } else {
    refuse("experiment-invalid", GLISSON_TEXT("There is no kind of experiment called \"{0}\"."), {kind},
           GLISSON_TEXT("The kinds are palpation, material, platform, guidance, full-field and elastography."));
  }
  return experiment;
}

}  // namespace

std::size_t Source::line_of(const std::string& quoted) const {
  const std::size_t at = text.find(Json(quoted).dump());
  if (at == std::string::npos) return 1;
  return 1 + static_cast<std::size_t>(
                 std::count(text.begin(), text.begin() + static_cast<std::string::difference_type>(at), '\n'));
}

fs::path Source::named_file(const std::string& name) const {
  const fs::path path = file.parent_path() / name;
  std::error_code problem;
  if (!fs::is_regular_file(path, problem)) {
    refuse("experiment-file-missing", GLISSON_TEXT("Line {0} of {1} names {2}, which is not there."),
           {std::to_string(line_of(name)), file.filename().string(), path.string()},
           GLISSON_TEXT(
               "Files are looked for beside the experiment: was it copied without them, or is the name misspelt?"),
           path);
  }
  return path;
}

std::vector<std::string> trial_ids(const Json& json) {
  const Json& trials = required(json, "trials", "The experiment");
  if (!trials.is_array() || trials.empty())
    refuse("experiment-invalid", GLISSON_TEXT("\"trials\" must be a list with at least one trial."), {});
  std::vector<std::string> ids;
  std::set<std::string> known;
  for (std::size_t t = 0; t < trials.size(); ++t) {
    const std::string where = "trial " + std::to_string(t + 1);
    if (!trials[t].is_object()) refuse_at(where, GLISSON_TEXT("{0} must be an object in braces."));
    ids.push_back(text_in(required(trials[t], "id", where), where + ", id"));
    if (!known.insert(ids.back()).second)
      refuse("experiment-invalid", GLISSON_TEXT("Two trials have the id \"{0}\"."), {ids.back()});
  }
  return ids;
}

Eigen::VectorXd column_of(const CsvTable& table, const std::string& column, const fs::path& file,
                          const std::string& key) {
  const auto index = table.column(column);
  if (!index) {
    std::string known;
    for (const std::string& name : table.names) known += (known.empty() ? "" : ", ") + name;
    refuse("experiment-column-missing",
           GLISSON_TEXT("{0} has no column \"{1}\", which the experiment names for {2}; line {3} has: {4}."),
           {file.filename().string(), column, key,
            std::to_string(table.lines.front() > 1 ? table.lines.front() - 1 : 1), known},
           GLISSON_TEXT("Is the name misspelt, or is this the table of another trial?"), file);
  }
  const std::vector<double>& cells = table.columns[*index];
  for (std::size_t row = 0; row < cells.size(); ++row) {
    if (!std::isfinite(cells[row]))
      refuse("experiment-invalid", GLISSON_TEXT("Line {0} of {1} has no number under \"{2}\"."),
             {std::to_string(table.lines[row]), file.filename().string(), column},
             GLISSON_TEXT("Is the table cut off, or written with decimal commas?"), file);
  }
  return Eigen::VectorXd::Map(cells.data(), static_cast<Eigen::Index>(cells.size()));
}

Eigen::VectorXd times_of(const CsvTable& table, const std::string& column, const fs::path& file) {
  Eigen::VectorXd times = column_of(table, column, file, "time_s");
  for (Eigen::Index row = 1; row < times.size(); ++row) {
    if (times[row] < times[row - 1])
      refuse("experiment-invalid", GLISSON_TEXT("Time goes back at line {0} of {1}: from {2} s to {3} s."),
             {std::to_string(table.lines[static_cast<std::size_t>(row)]), file.filename().string(),
              std::to_string(times[row - 1]), std::to_string(times[row])},
             GLISSON_TEXT("Are two recordings in one table, or is this not the column of times?"), file);
  }
  return times;
}

CsvTable table_of(const fs::path& file) { return taken(read_csv(file)); }

void refuse_unlikely_modulus(double young_kPa, const std::string& where) {
  constexpr double stiffer_than_any_tissue_kPa = 5000;  // soft tissue and silicone phantoms end at a few hundred
  if (young_kPa > stiffer_than_any_tissue_kPa)
    refuse("experiment-unit", GLISSON_TEXT("{0} is {1} kPa, stiffer than any soft tissue."),
           {where, std::to_string(young_kPa)}, GLISSON_TEXT("Was it given in Pa?"));
}

}  // namespace glisson::closedloop
