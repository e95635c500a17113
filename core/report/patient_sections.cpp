#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/json.h"
#include "casefile/evidence.h"
#include "casefile/model.h"
#include "geometry/mesh_file.h"
#include "mechanics/scenario/scenario.h"
#include "report/internal/patient_sections.h"
#include "report/plain_names.h"

namespace glisson::report {
namespace {

using casefile::Case;
using casefile::Entry;

// Whose stiffness the model has, by how it was made.
std::string stiffness_source(const Entry& model) {
  const auto& options = model.made.options;
  if (const auto uniform = options.find("uniform_kPa"); uniform != options.end()) {
    return "assumed: one value for all cells, " + uniform->second + " kPa";
  }
  if (const auto atlas = options.find("atlas_kPa"); atlas != options.end()) {
    return "assumed: the atlas's one value, " + atlas->second + " kPa";
  }
  return "the patient's own, from MR elastography";
}

Table resection_table(const Json& json) {
  Table table{"Smallest distance to the cut. Under 1 mm counts as R1, under 5 mm is narrow; both are marked !.",
              {"Tumour", "Side", "Margin (mm)", "Caution"},
              {}};
  const bool moved = std::any_of(json.at("tumours").begin(), json.at("tumours").end(),
                                 [](const Json& tumour) { return tumour.contains("shift_mm"); });
  if (moved) table.columns.insert(table.columns.begin() + 2, "Moved by the tools (mm)");
  for (const Json& tumour : json.at("tumours")) {
    const auto side = tumour.at("side").get<std::string>();
    const bool r1 = tumour.at("r1").get<bool>(), narrow = tumour.at("narrow").get<bool>();
    const std::string mind = side == "both"      ? "cut through: R1 !"
                             : side == "remnant" ? "left in place !"
                             : r1                ? "R1 !"
                             : narrow            ? "under 5 mm !"
                                                 : "";
    table.rows.push_back({{plain_name(tumour.at("name").get<std::string>())},
                          {side == "both"       ? "cut through"
                           : side == "specimen" ? "removed"
                                                : "stays"},
                          {fmt::format("{:.1f}", tumour.at("margin_mm").get<double>())},
                          {mind, mind.empty() ? Cell::Emphasis::none : Cell::Emphasis::flag}});
    if (!moved) continue;
    auto& row = table.rows.back();
    row.insert(row.begin() + 2, Cell{fmt::format("{:.1f}", tumour.value("shift_mm", 0.0))});
  }
  return table;
}

}  // namespace

Result<void> add_model(Page& page, const Case& patient) {
  page.blocks.push_back(Heading{"Model"});
  const Entry* entry = patient.find("meshes/model");
  if (entry == nullptr) {
    page.blocks.push_back(Paragraph{"There is no model yet."});
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
  row("Cells", fmt::format("{}", mesh->cells.size()));
  row("Smallest dihedral angle", fmt::format("{:.1f} deg", quality.min_dihedral_deg));
  row("Stiffness", stiffness_source(*entry));
  if (youngs != nullptr && !youngs->values.empty()) {
    const auto count = static_cast<double>(youngs->values.size());
    const double mean = std::accumulate(youngs->values.begin(), youngs->values.end(), 0.0) / count;
    double square = 0;
    for (const double value : youngs->values) square += (value - mean) * (value - mean);
    row("Young's modulus", fmt::format("{:.2f} kPa on average, sd {:.2f}", mean, std::sqrt(square / count)));
  }
  if (source != nullptr && !source->values.empty()) {
    const auto filled = std::count(source->values.begin(), source->values.end(),
                                   static_cast<double>(elastography::StiffnessSource::filled));
    if (filled > 0) {
      row("Cells without data of their own",
          fmt::format("{:.0f} % (filled from inside)",
                      100.0 * static_cast<double>(filled) / static_cast<double>(source->values.size())));
    }
  }
  row("Held by", "the bare area near the vena cava, and springs under the diaphragm (assumed)");
  page.blocks.push_back(std::move(table));
  for (const char* id : {"meshes/liver", "meshes/model"}) {
    const Entry* made = patient.find(id);
    if (made == nullptr) continue;
    for (const Sentence& note : made->made.notes) page.blocks.push_back(Paragraph{note.message()});
  }
  return {};
}

void add_resection(Page& page, const Case& patient) {
  page.blocks.push_back(Heading{"Planned resection"});
  const auto json = read_json_file(patient.folder() / "results" / "resection" / "resection.json");
  if (!json) {
    page.blocks.push_back(Paragraph{"No resection was saved."});
    return;
  }
  try {
    page.blocks.push_back(Paragraph{fmt::format(
        "The cut removes {:.0f} ml and leaves {:.0f} ml, {:.1f} % of the liver.", json->at("specimen_ml").get<double>(),
        json->at("remnant_ml").get<double>(), json->at("remnant_percent").get<double>())});
    if (json->contains("retraction")) {
      const Json& worth = json->at("retraction");
      page.blocks.push_back(Paragraph{fmt::format(
          "Planned on the liver as tools hold it, an answer {} the model: strains reach {:.0f} %.",
          worth.at("state") == "within" ? "within" : "outside of", 100 * worth.at("largest_strain").get<double>())});
    }
    if (!json->at("tumours").empty()) page.blocks.push_back(resection_table(*json));
    Table crossed{"Vessels that the cut crosses.", {"Vessel", "Diameter (mm)"}, {}};
    for (const Json& crossing : json->at("crossings")) {
      const bool cava = crossing.value("by_calibre", "") == "vena-cava";
      crossed.rows.push_back({{cava ? "Vena cava, by its width" : plain_name(crossing.at("name").get<std::string>())},
                              {fmt::format("{:.1f}", crossing.at("diameter_mm").get<double>())}});
    }
    if (!crossed.rows.empty()) page.blocks.push_back(std::move(crossed));
  } catch (const Json::exception&) {
    page.blocks.push_back(Paragraph{"The saved resection cannot be read: its file is damaged."});
  }
}

Result<void> add_evidence(Page& page, const Case& patient) {
  page.blocks.push_back(Heading{"Evidence accepted"});
  if (patient.find("evidence/model") == nullptr) {
    page.blocks.push_back(Paragraph{"None: the model is as declared."});
    return {};
  }
  const auto model = casefile::read_model(patient);
  if (!model) return failure(model.error());
  for (const closedloop::LearntEffect& effect : model->evidence.effects) {
    page.blocks.push_back(
        Paragraph{(effect.carried ? "Changes the model: " : "Accepted, but left out: ") + effect.sentence.message()});
  }
  for (const Sentence& remark : model->evidence.remarks) {
    page.blocks.push_back(Paragraph{remark.message()});
  }
  return {};
}

}  // namespace glisson::report
