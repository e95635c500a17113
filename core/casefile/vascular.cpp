#include "casefile/vascular.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>

#include "casefile/used_entries.h"
#include "imaging/segments_file.h"
#include "imaging/volume_file.h"
#include "vasculature/center_lines.h"
#include "vasculature/tree_file.h"

namespace glisson::casefile {
namespace {

using imaging::Mask;
using vasculature::System;
using vasculature::VesselTrees;

constexpr const char* trees_id = "vessels/trees";

Result<Mask> structure_mask(const Case& patient, const std::string& name) {
  const auto file = patient.file_of("labels/" + name);
  if (!file) return failure(file.error());
  return imaging::read_mask_file(*file).map([](imaging::SegmentedMask read) { return std::move(read.mask); });
}

Result<Mask> vessel_mask(const Case& patient, const std::string& name, const Mask& liver) {
  auto mask = structure_mask(patient, name);
  if (mask && !imaging::same_grid(mask->grid, liver.grid)) {
    return failure(Error{"labels-grids-differ",
                         GLISSON_TEXT("{0} and the liver lie on different grids."),
                         {name},
                         GLISSON_TEXT("Import one of them again: a case carries what it imports to one grid."),
                         patient.folder()});
  }
  return mask;
}

// Portal and hepatic veins where each has a structure of its own.
Result<VesselTrees> known_trees(const Case& patient, const Mask& liver, const vasculature::Clicks& clicks,
                                const Progress& progress) {
  std::array<vasculature::VesselGraph, 2> graphs;
  for (const System system : {System::portal_vein, System::hepatic_vein}) {
    const auto n = static_cast<std::size_t>(system);
    const auto mask = vessel_mask(patient, vasculature::system_name(system), liver);
    if (!mask) return failure(mask.error());
    auto graph = vasculature::center_lines(
        *mask, {}, progress.part(0.4 * static_cast<double>(n), 0.4 + 0.4 * static_cast<double>(n)));
    if (!graph) return failure(std::move(graph.error()));
    graphs.at(n) = std::move(*graph);
  }
  const auto expected = vasculature::expected_entries(liver);
  if (!expected) return failure(expected.error());
  vasculature::VesselEntries entries = vasculature::possible_entries(graphs[0], *expected, clicks, 1).front();
  entries.hepatic_mm = vasculature::possible_entries(graphs[1], *expected, clicks, 1).front().hepatic_mm;
  VesselTrees trees = vasculature::known_vessels(graphs[0], graphs[1], entries);
  const auto segments = vasculature::couinaud_segments(liver, &trees, progress.part(0.8, 1));
  if (!segments) return failure(segments.error());
  vasculature::name_branches(trees, *segments);
  return trees;
}

Error no_vessels() {
  return Error{"vessels-missing",
               GLISSON_TEXT("The case has no vessels to make trees of."),
               {},
               GLISSON_TEXT("Mark the structures portal-vein and hepatic-vein, or both as one structure, vessels."),
               {}};
}

std::vector<imaging::SegmentInfo> couinaud_segment_infos() {
  static constexpr std::array<const char*, 8> names = {"I", "II", "III", "IV", "V", "VI", "VII", "VIII"};
  static constexpr std::array<std::array<double, 3>, 8> colors = {{{0.55, 0.55, 0.55},
                                                                   {0.90, 0.62, 0.00},
                                                                   {0.34, 0.71, 0.91},
                                                                   {0.00, 0.62, 0.45},
                                                                   {0.94, 0.89, 0.26},
                                                                   {0.00, 0.45, 0.70},
                                                                   {0.84, 0.37, 0.00},
                                                                   {0.80, 0.47, 0.65}}};
  std::vector<imaging::SegmentInfo> infos;
  for (std::size_t n = 0; n < names.size(); ++n) {
    infos.push_back({fmt::format("segment {}", names.at(n)), static_cast<int>(n) + 1, colors.at(n)});
  }
  return infos;
}

}  // namespace

Result<VesselTrees> find_vessels(Case& patient, const std::optional<std::string>& structure,
                                 const vasculature::Clicks& clicks, const Progress& progress) {
  const auto liver = structure_mask(patient, "liver");
  if (!liver) return failure(liver.error());
  const bool apart =
      !structure && patient.find("labels/portal-vein") != nullptr && patient.find("labels/hepatic-vein") != nullptr;
  Provenance made{"vessels", {}, {"labels/liver"}, {}, {}};
  Result<VesselTrees> trees = failure(no_vessels());
  if (apart) {
    made.from.insert(made.from.end(), {"labels/portal-vein", "labels/hepatic-vein"});
    trees = known_trees(patient, *liver, clicks, progress);
  } else {
    const std::string name = structure.value_or("vessels");
    if (patient.find("labels/" + name) == nullptr) return failure(no_vessels());
    made.from.push_back("labels/" + name);
    const auto mask = vessel_mask(patient, name, *liver);
    if (!mask) return failure(mask.error());
    const auto graph = vasculature::center_lines(*mask, {}, progress.part(0, 0.5));
    if (!graph) return failure(graph.error());
    auto anatomy = vasculature::explain_vessels(*graph, *liver, clicks, progress.part(0.5, 1));
    if (!anatomy) return failure(std::move(anatomy.error()));
    trees = std::move(anatomy->trees);
  }
  if (!trees) return trees;
  const auto told = [&](const char* option, const std::optional<Eigen::Vector3d>& click) {
    if (click) made.options[option] = fmt::format("{:.2f},{:.2f},{:.2f}", click->x(), click->y(), click->z());
  };
  told("portal-click_mm", clicks.portal_mm);
  told("hepatic-click_mm", clicks.hepatic_mm);
  auto added = patient.add(trees_id, ".json", std::move(made),
                           [&](const std::filesystem::path& file) { return vasculature::write_trees(file, *trees); });
  if (!added) return failure(std::move(added.error()));
  return trees;
}

Result<FoundTerritories> find_territories(Case& patient, SegmentsBy by, const Progress& progress) {
  const auto liver = structure_mask(patient, "liver");
  if (!liver) return failure(liver.error());
  FoundTerritories found;
  Provenance made{"territories", {{"from", by == SegmentsBy::trees ? "tree" : "prior"}}, {"labels/liver"}, {}, {}};
  if (by == SegmentsBy::trees) {
    const auto file = patient.file_of(trees_id);
    if (!file) {
      return failure(Error{"vessels-missing",
                           GLISSON_TEXT("The case has no vessel trees."),
                           {},
                           GLISSON_TEXT("Find them first (vessels), or take the liver's shape alone (--from prior)."),
                           patient.folder()});
    }
    auto trees = vasculature::read_trees(*file);
    if (!trees) return failure(std::move(trees.error()));
    found.trees = std::move(*trees);
    made.from.emplace_back(trees_id);
    found.own_ml.assign(found.trees.branches.size(), 0);
    found.beyond_ml = found.own_ml;
    for (const System system : {System::portal_vein, System::hepatic_vein}) {
      const auto& branches = found.trees.branches;
      if (std::none_of(branches.begin(), branches.end(), [&](const auto& b) { return b.system == system; })) continue;
      const auto territories = vasculature::territories_of(found.trees, system, *liver);
      if (!territories) return failure(territories.error());
      const std::vector<double> beyond = vasculature::volumes_beyond_ml(found.trees, *territories);
      for (std::size_t b = 0; b < branches.size(); ++b) {
        if (branches[b].system != system) continue;
        found.own_ml[b] = territories->volume_ml[b];
        found.beyond_ml[b] = beyond[b];
      }
    }
  }
  auto segments = vasculature::couinaud_segments(*liver, by == SegmentsBy::trees ? &found.trees : nullptr, progress);
  if (!segments) return failure(std::move(segments.error()));
  found.couinaud = std::move(*segments);
  auto added = patient.add("territories/couinaud", ".nrrd", std::move(made), [&](const std::filesystem::path& file) {
    return imaging::write_segments_file(file, found.couinaud.segment, couinaud_segment_infos());
  });
  if (!added) return failure(std::move(added.error()));
  return found;
}

Result<std::optional<LivingRemnant>> living_remnant(const Case& patient, const geometry::CutSurface& cut,
                                                    bool specimen_is_above) {
  if (patient.find(trees_id) == nullptr) return std::nullopt;
  const auto file = patient.file_of(trees_id);
  if (!file) return failure(file.error());
  auto trees = vasculature::read_trees(*file);
  if (!trees) return failure(std::move(trees.error()));
  const auto liver = structure_mask(patient, "liver");
  if (!liver) return failure(liver.error());
  std::array<vasculature::Territories, 2> territories;
  for (const System system : {System::portal_vein, System::hepatic_vein}) {
    const auto& branches = trees->branches;
    if (std::none_of(branches.begin(), branches.end(), [&](const auto& b) { return b.system == system; })) {
      return std::nullopt;
    }
    auto found = vasculature::territories_of(*trees, system, *liver);
    if (!found) return failure(std::move(found.error()));
    territories.at(static_cast<std::size_t>(system)) = std::move(*found);
  }
  Mask removed = *liver;
  const auto& size = removed.grid.size;
  for (int k = 0; k < size[2]; ++k) {
    for (int j = 0; j < size[1]; ++j) {
      for (int i = 0; i < size[0]; ++i) {
        std::uint8_t& value = removed.values[removed.grid.offset(i, j, k)];
        if (value != 0 && (cut.height_mm(removed.grid.position_mm(i, j, k)) > 0) != specimen_is_above) value = 0;
      }
    }
  }
  auto remnant = vasculature::remnant_of(*trees, territories[0], territories[1], removed);
  if (!remnant) return failure(std::move(remnant.error()));
  return LivingRemnant{std::move(*remnant), std::move(*trees), remarks_on(patient, {trees_id})};
}

}  // namespace glisson::casefile
