#include "meshing/internal/label_field.h"

#include <algorithm>
#include <cmath>

namespace glisson::meshing {
namespace {

using Eigen::Vector3d;

// The weights of the voxels before, at, after and two after floor(x), for a point the fraction t beyond floor(x).
std::array<double, 4> window_weights(double t) { return {(1 - t) / 4, (2 - t) / 4, (1 + t) / 4, t / 4}; }

// Levels nearer to 0 or 1 than this would let a piece grow or vanish on a hair's breadth of blur.
constexpr double minimum_level = 0.02;

// Values along one axis: the smallest or largest among those at -1, 0, 1, 2.
template <typename Choose>
std::vector<std::uint16_t> over_window(const std::vector<std::uint16_t>& values, const imaging::Grid& grid, int axis,
                                       Choose&& choose) {
  std::size_t stride = 1;
  for (int a = 0; a < axis; ++a) stride *= static_cast<std::size_t>(grid.size[static_cast<std::size_t>(a)]);
  std::vector<std::uint16_t> chosen = values;
  for (std::size_t i = stride; i + 2 * stride < values.size(); ++i) {
    chosen[i] = choose(choose(values[i - stride], values[i]), choose(values[i + stride], values[i + 2 * stride]));
  }
  return chosen;
}

}  // namespace

LabelField::LabelField(const PieceMap& map) : map_(&map), weight_(map.pieces.size() + 1, 1.0) {
  find_uniform_windows();
  weigh_inner_pieces();
}

int LabelField::piece_at(const Vector3d& local_mm) const {
  const imaging::Grid& grid = map_->grid;
  const Vector3d index = local_mm.cwiseQuotient(grid.spacing_mm);
  std::array<int, 3> first{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double at = std::floor(index[static_cast<Eigen::Index>(axis)]);
    if (!(at >= 1 && at + 2 < grid.size[axis])) return 0;  // the margin around the body
    first[axis] = static_cast<int>(at);
  }
  const std::size_t voxel = grid.offset(first[0], first[1], first[2]);
  if (uniform_[voxel] != 0) return map_->piece[voxel];

  const View view = view_from(index);
  std::size_t best = 0;
  for (std::size_t i = 1; i < view.pieces; ++i) {
    if (view.share[i] * weight_[view.piece[i]] > view.share[best] * weight_[view.piece[best]]) best = i;
  }
  return view.piece[best];
}

void LabelField::View::add(std::uint16_t number, double weight) {
  for (std::size_t i = 0; i < pieces; ++i) {
    if (piece[i] == number) {
      share[i] += weight;
      return;
    }
  }
  if (pieces == piece.size()) return;
  piece[pieces] = number;
  share[pieces++] = weight;
}

LabelField::View LabelField::view_from(const Vector3d& index) const {
  const Vector3d floored = index.array().floor();
  const Vector3d fraction = index - floored;
  const auto x = window_weights(fraction.x());
  const auto y = window_weights(fraction.y());
  const auto z = window_weights(fraction.z());
  View view;
  for (std::size_t c = 0; c < 4; ++c) {
    for (std::size_t b = 0; b < 4; ++b) {
      const std::uint16_t* row = &map_->piece[map_->grid.offset(
          static_cast<int>(floored.x()) - 1, static_cast<int>(floored.y()) - 1 + static_cast<int>(b),
          static_cast<int>(floored.z()) - 1 + static_cast<int>(c))];
      for (std::size_t a = 0; a < 4; ++a) view.add(row[a], x[a] * y[b] * z[c]);
    }
  }
  return view;
}

void LabelField::find_uniform_windows() {
  std::vector<std::uint16_t> smallest = map_->piece;
  std::vector<std::uint16_t> largest = map_->piece;
  for (int axis = 0; axis < 3; ++axis) {
    smallest = over_window(smallest, map_->grid, axis, [](auto a, auto b) { return std::min(a, b); });
    largest = over_window(largest, map_->grid, axis, [](auto a, auto b) { return std::max(a, b); });
  }
  uniform_.resize(map_->piece.size());
  for (std::size_t i = 0; i < uniform_.size(); ++i) uniform_[i] = smallest[i] == largest[i] ? 1 : 0;
}

void LabelField::weigh_inner_pieces() {
  // Each voxel near an inner piece is asked at eight points, the centres of its eighths.
  constexpr int points_a_voxel = 8;
  std::vector<std::vector<float>> shares(map_->pieces.size() + 1);
  const auto& size = map_->grid.size;
  for (int k = 2; k + 2 < size[2]; ++k) {
    for (int j = 2; j + 2 < size[1]; ++j) {
      for (int i = 2; i + 2 < size[0]; ++i) {
        bool near_inner = false;
        for (int n = 0; n < 27 && !near_inner; ++n) {
          near_inner = map_->piece[map_->grid.offset(i + n % 3 - 1, j + n / 3 % 3 - 1, k + n / 9 - 1)] > 1;
        }
        if (!near_inner) continue;
        for (int n = 0; n < points_a_voxel; ++n) {
          const Vector3d eighth(n % 2 == 0 ? -0.25 : 0.25, n / 2 % 2 == 0 ? -0.25 : 0.25, n / 4 == 0 ? -0.25 : 0.25);
          const View view = view_from(Vector3d(i, j, k) + eighth);
          for (std::size_t seen = 0; seen < view.pieces; ++seen) {
            if (view.piece[seen] > 1) shares[view.piece[seen]].push_back(static_cast<float>(view.share[seen]));
          }
        }
      }
    }
  }
  for (std::size_t number = 2; number < shares.size(); ++number) {
    auto& of_piece = shares[number];
    const auto inside = static_cast<std::size_t>(map_->pieces[number - 1].voxels) * points_a_voxel;
    if (inside == 0 || inside >= of_piece.size()) continue;
    const auto border = of_piece.begin() + static_cast<std::ptrdiff_t>(inside);
    std::nth_element(of_piece.begin(), border, of_piece.end(), std::greater<>());
    const double level = std::clamp(static_cast<double>(*border), minimum_level, 1 - minimum_level);
    weight_[number] = (1 - level) / level;
  }
}

}  // namespace glisson::meshing
