#include "casefile/internal/vessel_masks.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <functional>

#include "casefile/vascular.h"
#include "imaging/volume_file.h"
#include "vasculature/center_lines.h"

namespace glisson::casefile {
namespace {

using imaging::Mask;
using vasculature::System;

constexpr std::string_view labels_folder = "labels/";

// All outlines of one system in one; empty where there are none. Each is held apart from `others`.
Result<NamedMask> united(const Case& patient, System system, const Mask& liver,
                         const std::vector<std::reference_wrapper<const NamedMask>>& others);

}  // namespace

std::vector<std::string> structures_beside_veins(const Case& patient, System system) {
  static constexpr std::array<std::string_view, 2> arteries{"arter", "hepatic-arter"}, ducts{"biliary", "bile"};
  std::vector<std::string> names;
  for (const Entry& entry : patient.entries()) {
    if (vasculature::is_vein(system) || !entry.id.starts_with(labels_folder)) continue;
    const std::string name = entry.id.substr(labels_folder.size());
    const auto& beginnings = system == System::artery ? arteries : ducts;
    const bool is_one = std::any_of(beginnings.begin(), beginnings.end(),
                                    [&](std::string_view beginning) { return name.starts_with(beginning); });
    if (is_one) names.push_back(name);
  }
  return names;
}

std::vector<std::string> missing_from_trees(const Case& patient) {
  std::vector<std::string> missing;
  const Entry* trees = patient.find(trees_id);
  if (trees == nullptr) return missing;
  for (const System system : {System::artery, System::biliary_tract}) {
    for (const std::string& name : structures_beside_veins(patient, system)) {
      const auto& from = trees->made.from;
      if (std::find(from.begin(), from.end(), std::string(labels_folder) + name) == from.end()) missing.push_back(name);
    }
  }
  return missing;
}

Result<Mask> structure_mask(const Case& patient, const std::string& name) {
  const auto file = patient.file_of(std::string(labels_folder) + name);
  if (!file) return failure(file.error());
  return imaging::read_mask_file(*file).map([](imaging::SegmentedMask read) { return std::move(read.mask); });
}

Result<NamedMask> vessel_mask(const Case& patient, const std::string& name, const Mask& liver) {
  auto mask = structure_mask(patient, name);
  if (!mask) return failure(std::move(mask.error()));
  if (!imaging::same_grid(mask->grid, liver.grid)) {
    return failure(Error{"labels-grids-differ",
                         GLISSON_TEXT("{0} and the liver lie on different grids."),
                         {name},
                         GLISSON_TEXT("Import one of them again: a case carries what it imports to one grid."),
                         patient.folder()});
  }
  return NamedMask{name, std::move(*mask)};
}

Result<void> hold_apart(const NamedMask& a, const NamedMask& b, const std::filesystem::path& folder) {
  std::array<double, 3> voxels{};  // of each, and of both
  for (std::size_t i = 0; i < a.mask.values.size(); ++i) {
    const bool in_a = a.mask.values[i] != 0, in_b = b.mask.values[i] != 0;
    voxels[0] += in_a ? 1 : 0, voxels[1] += in_b ? 1 : 0, voxels[2] += in_a && in_b ? 1 : 0;
  }
  const double share = voxels[2] / std::max(1.0, std::min(voxels[0], voxels[1]));
  if (share < 0.5) return {};
  const bool veins = a.name == "portal-vein" && b.name == "hepatic-vein";
  return failure(Error{"vessels-overlap",
                       GLISSON_TEXT("{1} and {2} hold the same vessels: {0} % of the smaller one."),
                       {fmt::format("{:.0f}", 100 * share), a.name, b.name},
                       veins ? GLISSON_TEXT("Unite them in one structure, vessels: its systems are told apart.")
                             : GLISSON_TEXT("Take the one out of the other: glisson-cli segment --subtract."),
                       folder});
}

Result<void> add_arteries_and_ducts(const Case& patient, const Mask& liver, const std::vector<NamedMask>& veins,
                                    vasculature::LiverAnatomy& anatomy, const Progress& progress) {
  std::vector<std::reference_wrapper<const NamedMask>> others(veins.begin(), veins.end());
  NamedMask arteries;
  for (const System system : {System::artery, System::biliary_tract}) {
    auto outlined = united(patient, system, liver, others);
    if (!outlined) return failure(std::move(outlined.error()));
    const auto& values = outlined->mask.values;
    if (std::all_of(values.begin(), values.end(), [](std::uint8_t value) { return value == 0; })) continue;
    auto graph = vasculature::center_lines(outlined->mask, {}, progress);
    if (!graph && graph.error().code == "vessels-one-blob") {
      return failure(Error{"vessels-one-blob",
                           GLISSON_TEXT("{0} holds a piece as wide as it is long, which is no vessel."),
                           {outlined->name},
                           GLISSON_TEXT("Outline vessels and ducts alone, the gall bladder by itself."),
                           patient.folder()});
    }
    if (!graph) return failure(std::move(graph.error()));
    vasculature::add_known_vessels(*graph, system, liver, anatomy.trees);
    if (system == System::artery) others.emplace_back(arteries = std::move(*outlined));
  }
  vasculature::name_branches(anatomy.trees, anatomy.segments);
  return {};
}

namespace {

Result<NamedMask> united(const Case& patient, System system, const Mask& liver,
                         const std::vector<std::reference_wrapper<const NamedMask>>& others) {
  NamedMask all;
  for (const std::string& name : structures_beside_veins(patient, system)) {
    // The structure that somebody took for both systems of veins.
    if (std::any_of(others.begin(), others.end(), [&](const NamedMask& other) { return other.name == name; })) continue;
    auto one = vessel_mask(patient, name, liver);
    if (!one) return one;
    for (const NamedMask& other : others) {
      if (auto apart = hold_apart(other, *one, patient.folder()); !apart) return failure(std::move(apart.error()));
    }
    if (all.name.empty()) {
      all = std::move(*one);
      continue;
    }
    for (std::size_t v = 0; v < all.mask.values.size(); ++v) all.mask.values[v] |= one->mask.values[v];
  }
  return all;
}

}  // namespace
}  // namespace glisson::casefile
