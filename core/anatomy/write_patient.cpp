#include "anatomy/write_patient.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "base/files.h"
#include "base/json.h"
#include "base/write_file.h"
#include "geometry/mesh_file.h"
#include "imaging/volume_file.h"
#include "segmentation/rasterise.h"
#include "segmentation/structures.h"

namespace glisson::anatomy {
namespace fs = std::filesystem;
namespace {

using Eigen::Vector3d;
using imaging::Grid;
using imaging::Mask;

double rounded(double value) { return std::round(value * 1000) / 1000; }
Json rounded(const Vector3d& position_mm) {
  return json_of(Vector3d(rounded(position_mm.x()), rounded(position_mm.y()), rounded(position_mm.z())));
}

Json tree_document(const Patient& patient, const VesselTree& tree) {
  Json nodes = Json::array();
  for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
    const VesselNode& node = tree.nodes[i];
    nodes.push_back({{"id", i},
                     {"position_mm", rounded(placed(patient, node.position_mm))},
                     {"parent", node.parent},
                     {"radius_mm", rounded(node.radius_mm)},
                     {"segment", node.segment},
                     {"generation", node.generation},
                     {"trunk", node.trunk}});
  }
  return {{"format", "glisson-vessel-tree/1"},
          {"simulated", is_simulated},
          {"system", system_name(tree.system)},
          {"nodes", std::move(nodes)}};
}

Result<void> write_surfaces(const fs::path& folder, const std::vector<NamedSurface>& surfaces) {
  for (const auto& [name, surface] : surfaces) {
    if (auto written = geometry::write_surface(folder / (name + ".vtp"), surface); !written) return written;
  }
  return {};
}

// Around the liver and what lies in it and at it.
Grid label_grid(const std::vector<NamedSurface>& surfaces, double spacing_mm) {
  std::vector<Vector3d> points;
  for (const auto& [name, surface] : surfaces) {
    if (name != "vena-cava") points.insert(points.end(), surface.points_mm.begin(), surface.points_mm.end());
  }
  geometry::Box box = geometry::bounding_box(points);
  box.min_mm.array() -= 10;
  box.max_mm.array() += 10;
  return grid_over(box, spacing_mm);
}

Result<void> write_labels(const fs::path& folder, const Patient& patient, const std::vector<NamedSurface>& surfaces,
                          double spacing_mm) {
  const Grid grid = label_grid(surfaces, spacing_mm);
  for (const auto& [name, surface] : surfaces) {
    const Mask mask = segmentation::rasterise(surface, grid);
    const imaging::SegmentInfo info{name, 1, segmentation::known_structure(name).color_rgb};
    if (auto written = imaging::write_mask_file(folder / (name + ".nrrd"), mask, info); !written) return written;
    if (name != "liver") continue;
    imaging::Volume segments;
    segments.grid = grid;
    segments.values.resize(grid.voxels(), 0);
    for (int k = 0; k < grid.size[2]; ++k) {
      for (int j = 0; j < grid.size[1]; ++j) {
        for (int i = 0; i < grid.size[0]; ++i) {
          if (mask.at(i, j, k) == 0) continue;
          segments.at(i, j, k) = static_cast<float>(segment_at(patient, grid.position_mm(i, j, k)));
        }
      }
    }
    if (auto written = imaging::write_volume_file(folder / "couinaud.nrrd", segments); !written) return written;
  }
  return {};
}

Result<void> write_all(const fs::path& folder, const Patient& patient, const std::vector<NamedSurface>& surfaces,
                       const WriteOptions& options) {
  if (auto written = write_surfaces(folder / "surfaces", surfaces); !written) return written;
  if (options.labels) {
    auto written = write_labels(folder / "labels", patient, surfaces, options.label_spacing_mm);
    if (!written) return written;
  }
  for (const VesselTree* tree : {&patient.portal_vein, &patient.hepatic_vein, &patient.artery}) {
    const fs::path file = folder / "trees" / (std::string(system_name(tree->system)) + ".json");
    if (auto written = write_json_file(file, tree_document(patient, *tree)); !written) return written;
  }
  return write_text_file(folder / "truth.json", truth_text(patient));
}

// A structure of another patient's, as a second tumour, that this one has not.
Result<void> remove_others(const fs::path& folder, const std::vector<NamedSurface>& surfaces, bool labels) {
  std::set<std::string> mine;
  for (const auto& [name, surface] : surfaces) mine.insert(name + ".vtp");
  for (const auto& [name, surface] : surfaces) {
    if (labels) mine.insert(name + ".nrrd");
  }
  if (labels) mine.insert("couinaud.nrrd");
  constexpr std::array<const char*, 9> kinds = {"liver",     "portal-vein", "hepatic-vein", "artery", "gallbladder",
                                                "vena-cava", "couinaud",    "tumour-",      "cyst-"};
  std::error_code problem;
  for (const char* part : {"surfaces", "labels"}) {
    for (fs::directory_iterator file(folder / part, problem), end; !problem && file != end; file.increment(problem)) {
      const std::string name = file->path().filename().string();
      const bool generated = std::any_of(kinds.begin(), kinds.end(), [&](const char* kind) {
        return name.starts_with(kind) && (name.ends_with(".vtp") || name.ends_with(".nrrd"));
      });
      if (!generated || mine.contains(name)) continue;
      if (auto removed = remove_file(file->path()); !removed) return removed;
    }
  }
  return {};
}

}  // namespace

Result<void> write_patient(const fs::path& folder, const Patient& patient, const WriteOptions& options) {
  const std::vector<NamedSurface> surfaces = surfaces_of(patient);
  return write_together([&] {
    return write_all(folder, patient, surfaces, options).and_then([&] {
      return remove_others(folder, surfaces, options.labels);
    });
  });
}

std::string truth_text(const Patient& patient) {
  const PatientOptions& options = patient.options;
  constexpr std::array<const char*, 4> lobes = {"usual", "no-left-lobe", "small-right-lobe", "turned"};
  Json truth;
  truth["format"] = "glisson-anatomy/1";
  truth["simulated"] = is_simulated;
  truth["seed"] = options.seed;
  truth["frame"] = "patient coordinates, LPS, mm";
  truth["volume_ml"] = rounded(options.volume_ml);
  truth["lobes"] = lobes[static_cast<std::size_t>(options.lobes)];
  const ShapeModes& m = options.modes;
  truth["shape_modes"] = {{"right_length", rounded(m.right_length)},
                          {"left_extent", rounded(m.left_extent)},
                          {"left_thickness", rounded(m.left_thickness)},
                          {"depth", rounded(m.depth)},
                          {"dome", rounded(m.dome)},
                          {"quadrate", rounded(m.quadrate)},
                          {"caudate", rounded(m.caudate)},
                          {"margin", rounded(m.margin)}};
  truth["tissue"] = {{"fat_fraction", options.tissue.fat_fraction},
                     {"fibrosis_stage", options.tissue.fibrosis_stage},
                     {"shear_kPa", shear_kPa_of(options.tissue.fibrosis_stage)},
                     {"relative_t1", rounded(relative_t1_of(options.tissue.fat_fraction))}};
  truth["segments"] = Json::array();
  for (int segment = 1; segment <= 8; ++segment) {
    truth["segments"].push_back({{"number", segment}, {"volume_ml", rounded(patient.segments->volume_ml(segment))}});
  }
  truth["lesions"] = Json::array();
  for (const Lesion& lesion : patient.lesions) {
    truth["lesions"].push_back({{"name", lesion.name},
                                {"center_mm", rounded(placed(patient, lesion.center_mm))},
                                {"diameter_mm", rounded(2 * lesion.radius_mm)},
                                {"segment", lesion.segment}});
  }
  truth["vessels"] = Json::array();
  for (const VesselTree* tree : {&patient.portal_vein, &patient.hepatic_vein, &patient.artery}) {
    double terminals = 0, widest = 0, length = 0;
    for (const VesselNode& node : tree->nodes) {
      if (node.parent < 0) terminals += node.flow;
      widest = std::max(widest, node.radius_mm);
    }
    const std::vector<VesselBranch> branches = branches_of(*tree);
    for (const VesselBranch& branch : branches) length += branch.length_mm;
    truth["vessels"].push_back({{"system", system_name(tree->system)},
                                {"file", std::string("trees/") + system_name(tree->system) + ".json"},
                                {"entry_radius_mm", rounded(widest)},
                                {"branches", branches.size()},
                                {"terminals", static_cast<int>(terminals)},
                                {"length_mm", rounded(length)}});
  }
  return truth.dump(2) + "\n";
}

}  // namespace glisson::anatomy
