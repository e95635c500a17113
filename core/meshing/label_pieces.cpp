#include "meshing/label_pieces.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <algorithm>
#include <array>
#include <map>
#include <numeric>

#include "base/units.h"
#include "meshing/image_end.h"

namespace glisson::meshing {
namespace {

using imaging::Grid;
using imaging::LabelMap;

struct IndexBox {
  std::array<int, 3> first{0, 0, 0};
  std::array<int, 3> last{-1, -1, -1};  // inclusive
};

Result<void> check_grid(const LabelMap& labels);
IndexBox box_of_labelled(const LabelMap& labels);
std::vector<Sentence> notes_on_cuts(const Grid& grid, const IndexBox& box);
LabelMap cropped(const LabelMap& labels, const IndexBox& box, int margin);

// Voxels of one value that hang together by faces, numbered from 0.
struct Components {
  std::vector<std::int32_t> of_voxel;
  std::vector<std::int64_t> voxels;
  std::vector<std::uint16_t> value;
};
Components components_of(const std::vector<std::uint16_t>& values, const Grid& grid);

// Calls visit(neighbour offset, axis) for the up to six voxels that share a face with the voxel.
template <typename Visit>
void for_each_neighbour(const Grid& grid, std::size_t voxel, Visit&& visit);

void keep_largest_part(LabelMap& body, const std::vector<LabelName>& names, std::vector<Sentence>& notes);
void fill_holes(LabelMap& body, std::uint16_t with, std::vector<Sentence>& notes);
std::uint16_t largest_label(const LabelMap& body);

// The pieces of the body, specks already given to their neighbours.
void cut_into_pieces(const LabelMap& body, std::uint16_t liver, const PieceOptions& options, PieceMap& map);
void measure_pieces(PieceMap& map);

}  // namespace

Result<PieceMap> find_pieces(const LabelMap& labels, const PieceOptions& options) {
  if (auto checked = check_grid(labels); !checked) return failure(checked.error());
  const IndexBox box = box_of_labelled(labels);
  if (box.last[0] < 0) {
    return failure(Error{"labels-empty",
                         GLISSON_TEXT("The label map holds no labelled voxel, so there is no body to mesh."),
                         {},
                         GLISSON_TEXT("Segment the liver first."),
                         {}});
  }
  PieceMap map;
  for (const LabelName& named : options.names) {
    if (std::find(labels.values.begin(), labels.values.end(), named.label) == labels.values.end()) {
      map.notes.push_back({GLISSON_TEXT("{0} holds no voxels."), {display_name(named.label, options.names)}});
    }
  }
  for (Sentence& cut : notes_on_cuts(labels.grid, box)) map.notes.push_back(std::move(cut));

  LabelMap body = cropped(labels, box, PieceMap::margin);
  keep_largest_part(body, options.names, map.notes);
  const std::uint16_t liver = largest_label(body);
  fill_holes(body, liver, map.notes);
  map.grid = body.grid;
  cut_into_pieces(body, liver, options, map);
  return map;
}

void dissolve_piece(PieceMap& map, std::size_t piece) {
  GLISSON_ASSERT(piece > 0 && piece < map.pieces.size());
  const auto number = static_cast<std::uint16_t>(piece + 1);
  std::vector<std::int64_t> shared_faces(map.pieces.size() + 1, 0);
  for (std::size_t voxel = 0; voxel < map.piece.size(); ++voxel) {
    if (map.piece[voxel] != number) continue;
    for_each_neighbour(map.grid, voxel, [&](std::size_t other, int) { ++shared_faces[map.piece[other]]; });
  }
  shared_faces[0] = 0;
  shared_faces[number] = 0;
  const auto host =
      static_cast<std::uint16_t>(std::max_element(shared_faces.begin(), shared_faces.end()) - shared_faces.begin());
  GLISSON_ASSERT(host != 0);  // the body hangs together, so every piece touches another
  for (std::uint16_t& value : map.piece) {
    if (value == number) value = host;
    if (value > number) --value;
  }
  map.pieces.erase(map.pieces.begin() + static_cast<std::ptrdiff_t>(piece));
  measure_pieces(map);
}

std::string display_name(std::uint16_t label, const std::vector<LabelName>& names) {
  for (const LabelName& named : names) {
    if (named.label == label) return fmt::format("{} (label {})", named.name, label);
  }
  return fmt::format("label {}", label);
}

namespace {

Result<void> check_grid(const LabelMap& labels) {
  const Grid& grid = labels.grid;
  const bool sized = grid.size[0] > 0 && grid.size[1] > 0 && grid.size[2] > 0;
  if (!sized || grid.voxels() != labels.values.size()) {
    return failure("labels-grid", GLISSON_TEXT("The label map has {0} values for a grid of {1} x {2} x {3} voxels."),
                   {std::to_string(labels.values.size()), std::to_string(grid.size[0]), std::to_string(grid.size[1]),
                    std::to_string(grid.size[2])});
  }
  const bool placed = grid.origin_mm.allFinite() && grid.spacing_mm.allFinite() && grid.spacing_mm.minCoeff() > 0;
  const double skew = (grid.direction.transpose() * grid.direction - Eigen::Matrix3d::Identity()).norm();
  if (!placed || !(skew < 1e-3)) {
    return failure("labels-grid",
                   GLISSON_TEXT("The label map's axes are not at right angles, or its spacing is not positive."));
  }
  return {};
}

IndexBox box_of_labelled(const LabelMap& labels) {
  const auto& size = labels.grid.size;
  IndexBox box{{size[0], size[1], size[2]}, {-1, -1, -1}};
  std::size_t voxel = 0;
  for (int k = 0; k < size[2]; ++k) {
    for (int j = 0; j < size[1]; ++j) {
      for (int i = 0; i < size[0]; ++i, ++voxel) {
        if (labels.values[voxel] == 0) continue;
        const std::array<int, 3> at{i, j, k};
        for (std::size_t axis = 0; axis < 3; ++axis) {
          box.first[axis] = std::min(box.first[axis], at[axis]);
          box.last[axis] = std::max(box.last[axis], at[axis]);
        }
      }
    }
  }
  return box;
}

std::vector<Sentence> notes_on_cuts(const Grid& grid, const IndexBox& box) {
  std::vector<Sentence> notes;
  for (int axis = 0; axis < 3; ++axis) {
    const Eigen::Vector3d onwards = grid.direction.col(axis);
    const auto add = [&](const Eigen::Vector3d& towards) {
      notes.push_back({GLISSON_TEXT("The image cuts the body off towards {0}; it is closed there by a flat cap."),
                       {side_of_patient(towards)}});
    };
    if (box.first[static_cast<std::size_t>(axis)] == 0) add(-onwards);
    if (box.last[static_cast<std::size_t>(axis)] == grid.size[static_cast<std::size_t>(axis)] - 1) add(onwards);
  }
  return notes;
}

LabelMap cropped(const LabelMap& labels, const IndexBox& box, int margin) {
  LabelMap part;
  part.grid = labels.grid;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    part.grid.size[axis] = box.last[axis] - box.first[axis] + 1 + 2 * margin;
  }
  part.grid.origin_mm = labels.grid.position_mm(box.first[0] - margin, box.first[1] - margin, box.first[2] - margin);
  part.values.assign(part.grid.voxels(), 0);
  for (int k = box.first[2]; k <= box.last[2]; ++k) {
    for (int j = box.first[1]; j <= box.last[1]; ++j) {
      const auto row = labels.values.begin() + static_cast<std::ptrdiff_t>(labels.grid.offset(box.first[0], j, k));
      const int length = box.last[0] - box.first[0] + 1;
      const std::size_t into = part.grid.offset(margin, j - box.first[1] + margin, k - box.first[2] + margin);
      std::copy(row, row + length, part.values.begin() + static_cast<std::ptrdiff_t>(into));
    }
  }
  return part;
}

template <typename Visit>
void for_each_neighbour(const Grid& grid, std::size_t voxel, Visit&& visit) {
  std::size_t stride = 1;
  std::size_t rest = voxel;
  for (int axis = 0; axis < 3; ++axis) {
    const auto length = static_cast<std::size_t>(grid.size[static_cast<std::size_t>(axis)]);
    const std::size_t at = rest % length;
    rest /= length;
    if (at > 0) visit(voxel - stride, axis);
    if (at + 1 < length) visit(voxel + stride, axis);
    stride *= length;
  }
}

Components components_of(const std::vector<std::uint16_t>& values, const Grid& grid) {
  Components found;
  found.of_voxel.assign(values.size(), -1);
  std::vector<std::size_t> front;
  for (std::size_t seed = 0; seed < values.size(); ++seed) {
    if (found.of_voxel[seed] >= 0) continue;
    const auto number = static_cast<std::int32_t>(found.value.size());
    found.value.push_back(values[seed]);
    found.voxels.push_back(0);
    found.of_voxel[seed] = number;
    front.push_back(seed);
    while (!front.empty()) {
      const std::size_t voxel = front.back();
      front.pop_back();
      ++found.voxels.back();
      for_each_neighbour(grid, voxel, [&](std::size_t other, int) {
        if (found.of_voxel[other] >= 0 || values[other] != values[seed]) return;
        found.of_voxel[other] = number;
        front.push_back(other);
      });
    }
  }
  return found;
}

void keep_largest_part(LabelMap& body, const std::vector<LabelName>& names, std::vector<Sentence>& notes) {
  std::vector<std::uint16_t> labelled(body.values.size());
  std::transform(body.values.begin(), body.values.end(), labelled.begin(),
                 [](std::uint16_t label) -> std::uint16_t { return label == 0 ? 0 : 1; });
  const Components parts = components_of(labelled, body.grid);
  std::int32_t largest = -1;
  int count = 0;
  for (std::size_t part = 0; part < parts.value.size(); ++part) {
    if (parts.value[part] == 0) continue;
    ++count;
    if (largest < 0 || parts.voxels[part] > parts.voxels[static_cast<std::size_t>(largest)]) {
      largest = static_cast<std::int32_t>(part);
    }
  }
  if (count == 1) return;

  std::map<std::uint16_t, std::int64_t> left_out;
  for (std::size_t voxel = 0; voxel < body.values.size(); ++voxel) {
    if (body.values[voxel] == 0 || parts.of_voxel[voxel] == largest) continue;
    ++left_out[body.values[voxel]];
    body.values[voxel] = 0;
  }
  std::vector<std::string> volumes;
  for (const auto& [label, voxels] : left_out) {
    const double volume_ml = units::ml_from_mm3(static_cast<double>(voxels) * body.grid.voxel_volume_mm3());
    volumes.push_back(fmt::format("{}: {:.3g} ml", display_name(label, names), volume_ml));
  }
  notes.push_back({GLISSON_TEXT("The body falls in {0} parts; the largest is kept, and the rest is left out: {1}."),
                   {std::to_string(count), fmt::format("{}", fmt::join(volumes, ", "))}});
}

void fill_holes(LabelMap& body, std::uint16_t with, std::vector<Sentence>& notes) {
  std::vector<std::uint16_t> outside(body.values.size());
  std::transform(body.values.begin(), body.values.end(), outside.begin(),
                 [](std::uint16_t label) -> std::uint16_t { return label == 0 ? 1 : 0; });
  const Components parts = components_of(outside, body.grid);
  const std::int32_t around = parts.of_voxel.front();  // the margin's corner
  std::int64_t filled = 0;
  for (std::size_t voxel = 0; voxel < body.values.size(); ++voxel) {
    if (outside[voxel] == 0 || parts.of_voxel[voxel] == around) continue;
    body.values[voxel] = with;
    ++filled;
  }
  if (filled == 0) return;
  const double filled_ml = units::ml_from_mm3(static_cast<double>(filled) * body.grid.voxel_volume_mm3());
  notes.push_back({GLISSON_TEXT("Holes without a label inside the body, {0} ml together, are filled."),
                   {fmt::format("{:.3g}", filled_ml)}});
}

std::uint16_t largest_label(const LabelMap& body) {
  std::vector<std::int64_t> voxels(65536, 0);
  for (const std::uint16_t label : body.values) ++voxels[label];
  voxels[0] = 0;
  return static_cast<std::uint16_t>(std::max_element(voxels.begin(), voxels.end()) - voxels.begin());
}

void cut_into_pieces(const LabelMap& body, std::uint16_t liver, const PieceOptions& options, PieceMap& map) {
  std::vector<std::uint16_t> values = body.values;
  Components parts = components_of(values, body.grid);

  // A speck takes the label that it shares most faces with; one round, since specks do not pile up in practice and
  // what is left is small enough not to matter.
  std::vector<std::map<std::uint16_t, int>> neighbours_of_speck(parts.value.size());
  std::int64_t speck_voxels = 0;
  int specks = 0;
  const auto is_speck = [&](std::int32_t part) {
    const auto index = static_cast<std::size_t>(part);
    return parts.value[index] != 0 && parts.voxels[index] < options.speck_voxels;
  };
  for (std::size_t voxel = 0; voxel < values.size(); ++voxel) {
    const std::int32_t part = parts.of_voxel[voxel];
    if (!is_speck(part)) continue;
    for_each_neighbour(body.grid, voxel, [&](std::size_t other, int) {
      if (parts.of_voxel[other] != part && values[other] != 0) {
        ++neighbours_of_speck[static_cast<std::size_t>(part)][values[other]];
      }
    });
  }
  std::vector<std::uint16_t> new_value = parts.value;
  for (std::size_t part = 0; part < parts.value.size(); ++part) {
    const auto& neighbours = neighbours_of_speck[part];
    if (neighbours.empty()) continue;
    ++specks;
    speck_voxels += parts.voxels[part];
    new_value[part] = std::max_element(neighbours.begin(), neighbours.end(), [](const auto& a, const auto& b) {
                        return a.second < b.second;
                      })->first;
  }
  if (specks > 0) {
    for (std::size_t voxel = 0; voxel < values.size(); ++voxel) {
      values[voxel] = new_value[static_cast<std::size_t>(parts.of_voxel[voxel])];
    }
    parts = components_of(values, body.grid);
    map.notes.push_back(
        {specks == 1
             ? GLISSON_TEXT("{0} speck of fewer than {1} voxels ({2} voxels together) became part of what it touches.")
             : GLISSON_TEXT(
                   "{0} specks of fewer than {1} voxels ({2} voxels together) became part of what they touch."),
         {std::to_string(specks), std::to_string(options.speck_voxels), std::to_string(speck_voxels)}});
  }

  std::vector<std::size_t> order;
  for (std::size_t part = 0; part < parts.value.size(); ++part) {
    if (parts.value[part] != 0) order.push_back(part);
  }
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    const bool a_is_liver = parts.value[a] == liver;
    const bool b_is_liver = parts.value[b] == liver;
    return a_is_liver != b_is_liver ? a_is_liver : parts.voxels[a] > parts.voxels[b];
  });
  // Sixteen bits number the pieces; the smallest beyond them become part of the first.
  constexpr std::size_t maximum_pieces = 65535;
  std::vector<std::uint16_t> number(parts.value.size(), 0);
  for (std::size_t rank = 0; rank < order.size(); ++rank) {
    number[order[rank]] = rank < maximum_pieces ? static_cast<std::uint16_t>(rank + 1) : std::uint16_t{1};
    if (rank < maximum_pieces) map.pieces.push_back({parts.value[order[rank]], 0, 0, 0});
  }
  map.piece.resize(values.size());
  for (std::size_t voxel = 0; voxel < values.size(); ++voxel) {
    map.piece[voxel] = number[static_cast<std::size_t>(parts.of_voxel[voxel])];
  }
  measure_pieces(map);
}

void measure_pieces(PieceMap& map) {
  const Eigen::Vector3d& spacing = map.grid.spacing_mm;
  const Eigen::Vector3d face_area_mm2(spacing.y() * spacing.z(), spacing.z() * spacing.x(), spacing.x() * spacing.y());
  for (Piece& piece : map.pieces) {
    piece.voxels = 0;
    piece.face_area_mm2 = 0;
  }
  for (std::size_t voxel = 0; voxel < map.piece.size(); ++voxel) {
    if (map.piece[voxel] == 0) continue;
    Piece& piece = map.pieces[map.piece[voxel] - 1U];
    ++piece.voxels;
    for_each_neighbour(map.grid, voxel, [&](std::size_t other, int axis) {
      if (map.piece[other] != map.piece[voxel]) piece.face_area_mm2 += face_area_mm2[axis];
    });
  }
  for (Piece& piece : map.pieces) {
    piece.volume_mm3 = static_cast<double>(piece.voxels) * map.grid.voxel_volume_mm3();
  }
}

}  // namespace
}  // namespace glisson::meshing
