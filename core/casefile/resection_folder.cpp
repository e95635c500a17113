#include "casefile/resection_folder.h"

#include <cmath>
#include <utility>

#include "base/json.h"
#include "base/write_file.h"
#include "casefile/internal/case_links.h"
#include "casefile/structure_landmarks.h"
#include "geometry/mesh_file.h"

namespace glisson::casefile {
namespace fs = std::filesystem;
namespace {

Json json_of_cut(const PlannedCut& cut, const rehearsal::Resection& plan);
Json json_of_plan(const rehearsal::Resection& plan);
Eigen::Vector3d vector_in(const Json& json);

}  // namespace

Result<geometry::CutSurface> surface_of(const PlannedCut& cut) {
  return cut.through_mm.empty() ? geometry::CutSurface::plane(cut.point_mm, cut.normal)
                                : geometry::CutSurface::through(cut.through_mm);
}

Result<rehearsal::Resection> plan_resection(const geometry::TetMesh& liver, const PlannedCut& cut,
                                            const std::vector<rehearsal::NamedStructure>& structures) {
  return plan_resection(rehearsal::at_rest(liver), cut, structures);
}

Result<rehearsal::Resection> plan_resection(const rehearsal::LyingLiver& liver, const PlannedCut& cut,
                                            const std::vector<rehearsal::NamedStructure>& structures) {
  const auto surface = surface_of(cut);
  if (!surface) return failure(surface.error());
  std::optional<Eigen::Vector3d> specimen_mm;
  if (cut.removed == PlannedCut::Removed::larger) {
    const geometry::DividedVolume volume = geometry::divided_volume(liver.mesh, *surface, liver.rest_volumes_mm3);
    // Just beside the sheet, on the wanted side of it at this place.
    const Eigen::Vector3d on_cut_mm = surface->point_mm() - surface->height_mm(surface->point_mm()) * surface->normal();
    specimen_mm = on_cut_mm + (volume.above_mm3 < volume.below_mm3 ? -1.0 : 1.0) * surface->normal();
  }
  return rehearsal::plan_resection(liver, *surface, structures, specimen_mm);
}

void measure_as_outlined(rehearsal::Resection& plan, double outline_ml) {
  const double meshed_ml = plan.specimen_ml + plan.remnant_ml;
  if (std::abs(outline_ml / meshed_ml - 1) <= 0.2) rehearsal::measure_as(plan, outline_ml);
}

rehearsal::StructureKind resection_kind(const std::string& structure) {
  if (is_vessel(structure)) return rehearsal::StructureKind::vessel;
  return structure.starts_with("cyst") ? rehearsal::StructureKind::cyst : rehearsal::StructureKind::tumour;
}

Json resection_json(const PlannedCut& cut, const rehearsal::Resection& plan) {
  Json document{{"format", "glisson-resection/1"}, {"cut", json_of_cut(cut, plan)}};
  document.update(json_of_plan(plan));
  if (plan.retraction) {
    document["retraction"] = {{"state", to_string(plan.retraction->state())},
                              {"largest_strain", plan.retraction->largest_strain},
                              {"inverted_cells", plan.retraction->inverted_cells}};
  }
  return null_where_not_finite(std::move(document));
}

Result<void> write_resection(const fs::path& folder, const PlannedCut& cut, const rehearsal::Resection& plan) {
  if (auto inside = refuse_links_on_the_way_to(folder); !inside) return inside;
  const bool at_rest = cut.liver == PlannedCut::Liver::at_rest;
  return write_together([&] {
    return geometry::write_tetrahedra(folder / "parts.vtu",
                                      at_rest ? plan.split.mesh : rehearsal::put_to_rest(plan.split.mesh))
        .and_then([&] {
          return geometry::write_surface(folder / "cut.vtp", at_rest ? plan.cut : rehearsal::put_to_rest(plan.cut));
        })
        .and_then([&] { return write_file(folder / "resection.json", resection_json(cut, plan).dump(2) + "\n"); });
  });
}

Result<void> remove_resection(const fs::path& folder) {
  if (auto inside = refuse_links_on_the_way_to(folder); !inside) return inside;
  for (const char* name : {"resection.json", "cut.vtp", "parts.vtu"}) {  // without the first it is no resection
    std::error_code problem;
    fs::remove(folder / name, problem);
    if (problem) return file_not_writable(folder / name, problem.message());
  }
  std::error_code other_files_stay;
  fs::remove(folder, other_files_stay);
  return {};
}

Result<PlannedCut> read_planned_cut(const fs::path& folder) {
  const auto refused = [&](const std::string& why) {
    return failure(Error{"not-a-resection",
                         GLISSON_TEXT("{0} does not hold a planned resection: {1}."),
                         {folder.string(), why},
                         GLISSON_TEXT("Plan it again, or make one with glisson-cli resect."),
                         folder});
  };
  const auto document = read_json_file(folder / "resection.json");
  if (!document) return refused(document.error().message());
  try {
    const Json& json = document->at("cut");
    PlannedCut cut;
    if (json.contains("through_mm")) {
      for (const Json& point : json["through_mm"]) cut.through_mm.push_back(vector_in(point));
    } else {
      cut.point_mm = vector_in(json.at("point_mm"));
      cut.normal = vector_in(json.at("normal"));
    }
    if (json.value("liver", "at-rest") == "held-aside") cut.liver = PlannedCut::Liver::held_aside;
    cut.removed = json.at("removed") == "larger" ? PlannedCut::Removed::larger : PlannedCut::Removed::smaller;
    return cut;
  } catch (const Json::exception& problem) {
    return refused(problem.what());
  }
}

namespace {

Json json_of_cut(const PlannedCut& cut, const rehearsal::Resection& plan) {
  Json json;
  if (cut.through_mm.empty()) {
    json = {{"point_mm", json_of(cut.point_mm)}, {"normal", json_of(cut.normal)}};
  } else {
    json["through_mm"] = Json::array();
    for (const Eigen::Vector3d& point : cut.through_mm) json["through_mm"].push_back(json_of(point));
  }
  if (cut.liver == PlannedCut::Liver::held_aside) json["liver"] = "held-aside";
  json["removed"] = plan.specimen_ml <= plan.remnant_ml ? "smaller" : "larger";
  return json;
}

Json json_of_plan(const rehearsal::Resection& plan) {
  Json document{{"specimen_ml", plan.specimen_ml},
                {"remnant_ml", plan.remnant_ml},
                {"remnant_percent", plan.remnant_percent()},
                {"volume_error_ml", plan.volume_error_ml},
                {"cut_area_mm2", plan.cut_area_mm2},
                {"tumours", Json::array()},
                {"cysts", Json::array()},
                {"vessels", Json::array()},
                {"crossings", Json::array()},
                {"notes", plan.notes}};
  for (const auto& tumour : plan.tumours) {
    document["tumours"].push_back({{"name", tumour.name},
                                   {"side", to_string(tumour.side)},
                                   {"margin_mm", tumour.margin_mm},
                                   {"r1", tumour.r1()},
                                   {"narrow", tumour.narrow()}});
    if (tumour.shift_mm > 0) document["tumours"].back()["shift_mm"] = tumour.shift_mm;
  }
  for (const auto& cyst : plan.cysts) {
    document["cysts"].push_back({{"name", cyst.name}, {"side", to_string(cyst.side)}});
  }
  for (const auto& vessel : plan.vessels) {
    document["vessels"].push_back({{"name", vessel.name}, {"side", to_string(vessel.side)}});
  }
  for (const auto& crossing : plan.crossings) {
    document["crossings"].push_back({{"name", crossing.name},
                                     {"center_mm", json_of(crossing.center_mm)},
                                     {"diameter_mm", crossing.diameter_mm},
                                     {"area_mm2", crossing.area_mm2}});
    if (crossing.vena_cava_by_calibre()) document["crossings"].back()["by_calibre"] = "vena-cava";
  }
  return document;
}

Eigen::Vector3d vector_in(const Json& json) {
  return {json.at(0).get<double>(), json.at(1).get<double>(), json.at(2).get<double>()};
}

}  // namespace
}  // namespace glisson::casefile
