// Names, colours and label maps of structures.

#include "segmentation/structures.h"

#include <algorithm>
#include <numeric>

#include "base/units.h"
#include "imaging/filters.h"

namespace glisson::segmentation {
namespace {

struct Entry {
  std::string_view name;
  std::array<int, 3> rgb;  // 0..255, from 3D Slicer's GenericAnatomyColors
  Place place;
};

constexpr std::array<Entry, 23> known{{
    {"liver", {221, 130, 101}, Place::liver},          {"tumour", {144, 238, 144}, Place::inside},
    {"cyst", {205, 205, 100}, Place::inside},          {"portal-vein", {0, 151, 206}, Place::inside},
    {"hepatic-vein", {0, 147, 202}, Place::inside},    {"artery", {216, 101, 79}, Place::inside},
    {"biliary-tract", {0, 145, 30}, Place::inside},    {"necrosis", {216, 191, 216}, Place::inside},
    {"gallbladder", {139, 150, 98}, Place::beside},    {"gastric-vein", {0, 122, 171}, Place::beside},
    {"aorta", {224, 97, 76}, Place::beside},           {"heart", {206, 110, 84}, Place::beside},
    {"stomach", {216, 132, 105}, Place::beside},       {"kidney", {185, 102, 83}, Place::beside},
    {"spleen", {157, 108, 162}, Place::beside},        {"pancreas", {249, 180, 111}, Place::beside},
    {"bone", {241, 214, 145}, Place::beside},          {"vena-cava", {0, 151, 206}, Place::beside},
    {"duodenum", {255, 253, 229}, Place::beside},      {"small-bowel", {205, 167, 142}, Place::beside},
    {"colon", {204, 168, 143}, Place::beside},         {"esophagus", {211, 171, 143}, Place::beside},
    {"adrenal-gland", {249, 186, 150}, Place::beside},
}};
constexpr std::array<int, 3> unknown_rgb{100, 100, 130};

std::string_view without_number_or_side(std::string_view name);
std::vector<std::size_t> largest_first(const std::vector<Structure>& structures);
bool counts(const Structure& structure, Extent extent);

}  // namespace

KnownStructure known_structure(std::string_view name) {
  const auto color = [](const std::array<int, 3>& rgb) {
    return std::array<double, 3>{rgb[0] / 255.0, rgb[1] / 255.0, rgb[2] / 255.0};
  };
  for (const Entry& entry : known) {
    if (entry.name == name || entry.name == without_number_or_side(name)) return {color(entry.rgb), entry.place};
  }
  return {color(unknown_rgb), Place::unknown};
}

std::vector<std::string> known_structure_names() {
  std::vector<std::string> names;
  names.reserve(known.size());
  for (const Entry& entry : known) names.emplace_back(entry.name);
  return names;
}

Structure make_structure(std::string name, imaging::Mask mask) {
  const auto color = known_structure(name).color_rgb;
  return {std::move(name), color, std::move(mask)};
}

Result<ComposedLabels> compose_labels(const std::vector<Structure>& structures, Extent extent) {
  if (structures.empty()) return failure("labels-no-structures", GLISSON_TEXT("There is no structure to label."));
  const Structure* liver = nullptr;
  for (const Structure& structure : structures) {
    if (!imaging::same_grid(structure.mask.grid, structures.front().mask.grid)) {
      return failure("labels-grids-differ", GLISSON_TEXT("The structures {0} and {1} lie on different voxel grids."),
                     {structures.front().name, structure.name});
    }
    if (liver == nullptr && known_structure(structure.name).place == Place::liver) liver = &structure;
  }
  if (extent == Extent::liver && liver == nullptr) {
    return failure(Error{"labels-no-liver",
                         GLISSON_TEXT("None of the structures is the liver."),
                         {},
                         GLISSON_TEXT("Segment it first, or name a structure \"liver\"."),
                         {}});
  }
  if (extent == Extent::liver && voxel_count(liver->mask) == 0) {
    return failure("labels-liver-empty", GLISSON_TEXT("The structure {0} holds no voxels."), {liver->name});
  }

  ComposedLabels composed;
  composed.labels.grid = structures.front().mask.grid;
  composed.labels.values.assign(composed.labels.grid.voxels(), 0);
  std::vector<std::uint16_t> label_of(structures.size(), 0);
  const auto add = [&](std::size_t structure) {
    composed.names.push_back(structures[structure].name);
    label_of[structure] = static_cast<std::uint16_t>(composed.names.size());
  };
  if (liver != nullptr) add(static_cast<std::size_t>(liver - structures.data()));
  for (std::size_t s = 0; s < structures.size(); ++s) {
    if (&structures[s] != liver && counts(structures[s], extent)) add(s);
  }

  const auto write = [&](std::size_t structure) {
    const imaging::Mask& mask = structures[structure].mask;
    for (std::size_t voxel = 0; voxel < mask.values.size(); ++voxel) {
      const bool within = extent == Extent::all || liver->mask.values[voxel] != 0;
      if (mask.values[voxel] != 0 && within) composed.labels.values[voxel] = label_of[structure];
    }
  };
  if (liver != nullptr) write(static_cast<std::size_t>(liver - structures.data()));
  for (const std::size_t s : largest_first(structures)) {
    if (&structures[s] != liver && label_of[s] != 0) write(s);
  }
  return composed;
}

imaging::Mask mask_of_label(const imaging::LabelMap& labels, int label) {
  imaging::Mask mask{labels.grid, std::vector<std::uint8_t>(labels.values.size())};
  for (std::size_t voxel = 0; voxel < mask.values.size(); ++voxel) {
    mask.values[voxel] = labels.values[voxel] == label ? 1 : 0;
  }
  return mask;
}

imaging::Mask mask_of_any_label(const imaging::LabelMap& labels) {
  imaging::Mask mask{labels.grid, std::vector<std::uint8_t>(labels.values.size())};
  for (std::size_t voxel = 0; voxel < mask.values.size(); ++voxel) {
    mask.values[voxel] = labels.values[voxel] != 0 ? 1 : 0;
  }
  return mask;
}

std::size_t voxel_count(const imaging::Mask& mask) {
  return static_cast<std::size_t>(
      std::count_if(mask.values.begin(), mask.values.end(), [](std::uint8_t value) { return value != 0; }));
}

double volume_ml(const imaging::Mask& mask) {
  return units::ml_from_mm3(static_cast<double>(voxel_count(mask)) * mask.grid.voxel_volume_mm3());
}

Result<double> dice(const imaging::Mask& a, const imaging::Mask& b) {
  if (!imaging::same_grid(a.grid, b.grid)) {
    return failure("masks-grids-differ", GLISSON_TEXT("The two masks lie on different voxel grids."));
  }
  std::size_t in_both = 0;
  for (std::size_t voxel = 0; voxel < a.values.size(); ++voxel) {
    in_both += a.values[voxel] != 0 && b.values[voxel] != 0 ? 1U : 0U;
  }
  const std::size_t in_sum = voxel_count(a) + voxel_count(b);
  return in_sum == 0 ? 1.0 : 2.0 * static_cast<double>(in_both) / static_cast<double>(in_sum);
}

std::vector<Piece> pieces(const imaging::Mask& mask) {
  const imaging::ConnectedVoxels connected = imaging::connected_voxels(mask, imaging::Neighbours::all);
  const imaging::Grid& grid = mask.grid;
  std::vector<Piece> found(connected.sizes.size());
  for (int k = 0; k < grid.size[2]; ++k) {
    for (int j = 0; j < grid.size[1]; ++j) {
      for (int i = 0; i < grid.size[0]; ++i) {
        Piece& piece = found[connected.piece[grid.offset(i, j, k)]];
        ++piece.voxels;
        piece.centroid_mm += grid.position_mm(i, j, k);
        if (i == 0 || j == 0 || k == 0 || i + 1 == grid.size[0] || j + 1 == grid.size[1] || k + 1 == grid.size[2]) {
          piece.touches_border = true;
        }
      }
    }
  }
  found.erase(found.begin());  // what lies outside the mask
  for (Piece& piece : found) {
    piece.centroid_mm /= static_cast<double>(piece.voxels);
    piece.volume_ml = units::ml_from_mm3(static_cast<double>(piece.voxels) * grid.voxel_volume_mm3());
  }
  std::stable_sort(found.begin(), found.end(), [](const Piece& a, const Piece& b) { return a.voxels > b.voxels; });
  return found;
}

namespace {

// "tumour-12" without "-12", "kidney-left" without "-left".
std::string_view without_number_or_side(std::string_view name) {
  const std::size_t dash = name.rfind('-');
  if (dash == std::string_view::npos || dash + 1 == name.size()) return name;
  const std::string_view number = name.substr(dash + 1);
  if (number == "left" || number == "right") return name.substr(0, dash);
  const bool is_number = std::all_of(number.begin(), number.end(), [](char c) { return c >= '0' && c <= '9'; });
  return is_number ? name.substr(0, dash) : name;
}

std::vector<std::size_t> largest_first(const std::vector<Structure>& structures) {
  std::vector<std::size_t> voxels(structures.size());
  std::transform(structures.begin(), structures.end(), voxels.begin(),
                 [](const Structure& structure) { return voxel_count(structure.mask); });
  std::vector<std::size_t> order(structures.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return voxels[a] > voxels[b]; });
  return order;
}

// Cutting a neighbour to the liver would leave slivers along its surface. What has an unknown name was segmented for
// a reason and may well lie inside.
bool counts(const Structure& structure, Extent extent) {
  return extent == Extent::all || known_structure(structure.name).place != Place::beside;
}

}  // namespace
}  // namespace glisson::segmentation
