#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/json.h"
#include "casefile/evidence.h"
#include "casefile/model.h"
#include "casefile/orders.h"
#include "casefile/plans.h"
#include "geometry/mesh_file.h"
#include "mechanics/scenario/scenario.h"
#include "report/internal/patient_sections.h"
#include "report/orders_page.h"
#include "report/plan_comparison.h"

namespace glisson::report {
namespace {

using casefile::Case;
using casefile::Entry;

// Whose stiffness the model has, by how it was made.
std::string stiffness_source(const Entry& model, const Words& words) {
  const auto& options = model.made.options;
  if (const auto uniform = options.find("uniform_kPa"); uniform != options.end()) {
    return words.say(GLISSON_TEXT("assumed: one value for all cells, {0} kPa"), {uniform->second});
  }
  if (const auto reference = options.find("atlas_kPa"); reference != options.end()) {
    return words.say(GLISSON_TEXT("assumed: the atlas's one value, {0} kPa"), {reference->second});
  }
  return words.say(GLISSON_TEXT("the patient's own, from MR elastography"));
}

// What a surgeon must not overlook; empty for nothing.
std::string caution(const std::string& side, bool r1, bool narrow, const Words& words) {
  if (side == "both") return words.say(GLISSON_TEXT("cut through: R1 !"));
  if (side == "remnant") return words.say(GLISSON_TEXT("left in place !"));
  if (r1) return "R1 !";
  return narrow ? words.say(GLISSON_TEXT("under 5 mm !")) : "";
}

Table resection_table(const Json& json, const Words& words) {
  Table table{words.say(GLISSON_TEXT(
                  "Smallest distance to the cut. Under 1 mm counts as R1, under 5 mm is narrow; both are marked !.")),
              {words.say(GLISSON_TEXT("Tumour")), words.say(GLISSON_TEXT("Side")),
               words.say(GLISSON_TEXT("Margin (mm)")), words.say(GLISSON_TEXT("Caution"))},
              {}};
  const bool moved = std::any_of(json.at("tumours").begin(), json.at("tumours").end(),
                                 [](const Json& tumour) { return tumour.contains("shift_mm"); });
  if (moved) table.columns.insert(table.columns.begin() + 2, words.say(GLISSON_TEXT("Moved by the tools (mm)")));
  for (const Json& tumour : json.at("tumours")) {
    const auto side = tumour.at("side").get<std::string>();
    const std::string mind = caution(side, tumour.at("r1").get<bool>(), tumour.at("narrow").get<bool>(), words);
    table.rows.push_back({{words.name(tumour.at("name").get<std::string>())},
                          {words.say(side == "both"       ? GLISSON_TEXT("cut through")
                                     : side == "specimen" ? GLISSON_TEXT("removed")
                                                          : GLISSON_TEXT("stays"))},
                          {fmt::format("{:.1f}", tumour.at("margin_mm").get<double>())},
                          {mind, mind.empty() ? Cell::Emphasis::none : Cell::Emphasis::flag}});
    if (!moved) continue;
    auto& row = table.rows.back();
    row.insert(row.begin() + 2, Cell{fmt::format("{:.1f}", tumour.value("shift_mm", 0.0))});
  }
  return table;
}

}  // namespace

Result<void> add_model(Page& page, const Case& patient, const Words& words) {
  page.blocks.push_back(Heading{words.say(GLISSON_TEXT("Model"))});
  const Entry* entry = patient.find("meshes/model");
  if (entry == nullptr) {
    page.blocks.push_back(Paragraph{words.say(GLISSON_TEXT("There is no model yet."))});
    return {};
  }
  const auto mesh =
      patient.file_of("meshes/model").and_then([](const auto& file) { return geometry::read_tetrahedra(file); });
  if (!mesh) return failure(mesh.error());
  const geometry::Field* youngs = geometry::find_field(mesh->cell_fields, mechanics::youngs_modulus_field);
  const geometry::Field* source = geometry::find_field(mesh->cell_fields, "stiffness_source");
  const geometry::TetQuality quality = geometry::quality(*mesh);
  Table table{"", {"", ""}, {}};
  const auto row = [&](std::string name, std::string value) {
    table.rows.push_back({{std::move(name)}, {std::move(value)}});
  };
  row(words.say(GLISSON_TEXT("Cells")), fmt::format("{}", mesh->cells.size()));
  row(words.say(GLISSON_TEXT("Smallest dihedral angle")), fmt::format("{:.1f} deg", quality.min_dihedral_deg));
  row(words.say(GLISSON_TEXT("Stiffness")), stiffness_source(*entry, words));
  if (youngs != nullptr && !youngs->values.empty()) {
    const auto count = static_cast<double>(youngs->values.size());
    const double mean = std::accumulate(youngs->values.begin(), youngs->values.end(), 0.0) / count;
    double square = 0;
    for (const double value : youngs->values) square += (value - mean) * (value - mean);
    row(words.say(GLISSON_TEXT("Young's modulus")),
        words.say(GLISSON_TEXT("{0} kPa on average, sd {1}"),
                  {fmt::format("{:.2f}", mean), fmt::format("{:.2f}", std::sqrt(square / count))}));
  }
  if (source != nullptr && !source->values.empty()) {
    const auto filled = std::count(source->values.begin(), source->values.end(),
                                   static_cast<double>(elastography::StiffnessSource::filled));
    const double percent = 100.0 * static_cast<double>(filled) / static_cast<double>(source->values.size());
    if (filled > 0) {
      row(words.say(GLISSON_TEXT("Cells without data of their own")),
          words.say(GLISSON_TEXT("{0} % (filled from inside)"), {fmt::format("{:.0f}", percent)}));
    }
  }
  row(words.say(GLISSON_TEXT("Held by")),
      words.say(GLISSON_TEXT("the bare area near the vena cava, and springs under the diaphragm (assumed)")));
  page.blocks.push_back(std::move(table));
  for (const char* id : {"meshes/liver", "meshes/model"}) {
    const Entry* made = patient.find(id);
    if (made == nullptr) continue;
    for (const Sentence& note : made->made.notes) page.blocks.push_back(Paragraph{words.sentence(note)});
  }
  return {};
}

void add_resection(Page& page, const Case& patient, const Words& words) {
  page.blocks.push_back(Heading{words.say(GLISSON_TEXT("Planned resection"))});
  const auto json = read_json_file(patient.folder() / "results" / "resection" / "resection.json");
  if (!json) {
    page.blocks.push_back(Paragraph{words.say(GLISSON_TEXT("No resection was saved."))});
    return;
  }
  try {
    const auto figure = [&](const char* key, int decimals) {
      return fmt::format("{:.{}f}", json->at(key).get<double>(), decimals);
    };
    page.blocks.push_back(
        Paragraph{words.say(GLISSON_TEXT("The cut removes {0} ml and leaves {1} ml, {2} % of the liver."),
                            {figure("specimen_ml", 0), figure("remnant_ml", 0), figure("remnant_percent", 1)})});
    if (json->contains("retraction")) {
      const Json& worth = json->at("retraction");
      const std::string strain_percent = fmt::format("{:.0f}", 100 * worth.at("largest_strain").get<double>());
      page.blocks.push_back(Paragraph{words.say(
          worth.at("state") == "within"
              ? GLISSON_TEXT("Planned on the liver as tools hold it, an answer within the model: strains reach {0} %.")
              : GLISSON_TEXT(
                    "Planned on the liver as tools hold it, an answer outside of the model: strains reach {0} %."),
          {strain_percent})});
    }
    if (!json->at("tumours").empty()) page.blocks.push_back(resection_table(*json, words));
    Table crossed{words.say(GLISSON_TEXT("Vessels that the cut crosses.")),
                  {words.say(GLISSON_TEXT("Vessel")), words.say(GLISSON_TEXT("Diameter (mm)"))},
                  {}};
    for (const Json& crossing : json->at("crossings")) {
      const bool cava = crossing.value("by_calibre", "") == "vena-cava";
      crossed.rows.push_back({{cava ? words.say(GLISSON_TEXT("Vena cava, by its width"))
                                    : words.name(crossing.at("name").get<std::string>())},
                              {fmt::format("{:.1f}", crossing.at("diameter_mm").get<double>())}});
    }
    if (!crossed.rows.empty()) page.blocks.push_back(std::move(crossed));
  } catch (const Json::exception&) {
    page.blocks.push_back(
        Paragraph{words.say(GLISSON_TEXT("The saved resection cannot be read: its file is damaged."))});
  }
}

Result<void> add_kept_plans(Page& page, const Case& patient, const Words& words) {
  const auto plans = casefile::kept_plans(patient);
  if (!plans) return failure(plans.error());
  std::vector<Json> described;
  for (const casefile::KeptPlan& kept : *plans) {
    auto answer = casefile::kept_answer(patient, kept.id);
    if (!answer) return failure(std::move(answer.error()));
    Json& plan = described.emplace_back(Json{{"name", kept.plan.name}, {"current", kept.remarks.empty()}});
    plan.update(*answer);
  }
  if (described.empty()) return {};
  page.blocks.push_back(Heading{words.say(GLISSON_TEXT("Plans compared"))});
  add_plans(page, described, words);
  return {};
}

Result<void> add_orders(Page& page, const Case& patient, const Words& words) {
  const auto compared = casefile::kept_comparison(patient);
  if (!compared) return failure(compared.error());
  if (!*compared) return {};
  page.blocks.push_back(Heading{words.say(GLISSON_TEXT("Orders of steps"))});
  const auto& [orders, law, remarks] = **compared;
  std::string told = law == mechanics::MaterialLaw::linear
                         ? words.say(GLISSON_TEXT("Computed with small deformations (linear)."))
                         : words.say(GLISSON_TEXT("Computed with large deformations, at rest after each step."));
  for (const Sentence& remark : remarks) told += " " + words.sentence(remark);
  page.blocks.push_back(Paragraph{told});
  page.blocks.push_back(orders_table(orders, words));
  return {};
}

Result<void> add_evidence(Page& page, const Case& patient, const Words& words) {
  page.blocks.push_back(Heading{words.say(GLISSON_TEXT("Evidence accepted"))});
  if (patient.find("evidence/model") == nullptr) {
    page.blocks.push_back(Paragraph{words.say(GLISSON_TEXT("None: the model is as declared."))});
    return {};
  }
  const auto model = casefile::read_model(patient);
  if (!model) return failure(model.error());
  for (const closedloop::LearntEffect& effect : model->evidence.effects) {
    page.blocks.push_back(Paragraph{
        words.say(effect.carried ? GLISSON_TEXT("Changes the model: {0}") : GLISSON_TEXT("Accepted, but left out: {0}"),
                  {words.sentence(effect.sentence)})});
  }
  for (const Sentence& remark : model->evidence.remarks) page.blocks.push_back(Paragraph{words.sentence(remark)});
  return {};
}

}  // namespace glisson::report
