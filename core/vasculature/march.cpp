#include "vasculature/internal/march.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace glisson::vasculature {
namespace {

constexpr float never = std::numeric_limits<float>::infinity();

// Voxels by arrival, to within a bucket's width; what comes earlier than the bucket in turn goes into that.
class Buckets {
 public:
  Buckets(double first, double width) : first_(first), width_(width) {}

  void push(float arrival, std::size_t voxel) {
    const double place = std::floor((arrival - first_) / width_);
    const std::size_t bucket = std::max(now_, place > 0 ? static_cast<std::size_t>(place) : 0);
    if (bucket >= buckets_.size()) buckets_.resize(bucket + 64);
    buckets_[bucket].push_back(voxel);
  }
  // The next voxel, or none.
  bool pop(std::size_t& voxel) {
    while (now_ < buckets_.size() && taken_ == buckets_[now_].size()) {
      std::vector<std::size_t>().swap(buckets_[now_++]);
      taken_ = 0;
    }
    if (now_ >= buckets_.size()) return false;
    voxel = buckets_[now_][taken_++];
    return true;
  }

 private:
  double first_, width_;
  std::vector<std::vector<std::size_t>> buckets_;
  std::size_t now_ = 0, taken_ = 0;
};

}  // namespace

Arrivals march(const imaging::Mask& inside, const std::vector<Source>& sources) {
  const imaging::Grid& grid = inside.grid;
  const std::size_t count = inside.values.size();
  Arrivals arrivals{std::vector<float>(count, never), std::vector<std::int32_t>(count, -1)};
  std::vector<char> done(count, 0);
  std::vector<std::int32_t> source_of(count, -1);
  double first = 0;
  for (const Source& source : sources) first = std::min<double>(first, source.arrival_mm);
  Buckets buckets(first, 0.25 * grid.spacing_mm.minCoeff());
  for (std::size_t n = 0; n < sources.size(); ++n) {
    const Source& source = sources[n];
    float& mm = arrivals.mm[source.voxel];
    std::int32_t& label = arrivals.label[source.voxel];
    if (inside.values[source.voxel] == 0 || source.arrival_mm > mm) continue;
    if (source.arrival_mm == mm && label <= source.label) continue;
    mm = source.arrival_mm;
    label = source.label;
    source_of[source.voxel] = static_cast<std::int32_t>(n);
  }
  for (const Source& source : sources) {
    if (arrivals.mm[source.voxel] == source.arrival_mm) buckets.push(source.arrival_mm, source.voxel);
  }

  const std::array<std::size_t, 3> stride = {
      1, static_cast<std::size_t>(grid.size[0]),
      static_cast<std::size_t>(grid.size[0]) * static_cast<std::size_t>(grid.size[1])};
  const auto place = [&](std::size_t voxel, std::size_t axis) {
    return static_cast<int>(voxel / stride[axis] % static_cast<std::size_t>(grid.size[axis]));
  };
  const auto position = [&](std::size_t voxel) {
    return grid.position_mm(place(voxel, 0), place(voxel, 1), place(voxel, 2));
  };
  const auto straight_mm = [&](const Eigen::Vector3d& from, std::int32_t source) {
    const Source& of = sources[static_cast<std::size_t>(source)];
    return (from - of.center_mm).norm() - of.radius_mm;
  };
  // The time at which a plane front through the neighbours that are done arrives, and whose front it is.
  const auto update = [&](std::size_t voxel) {
    std::array<std::pair<double, double>, 3> upwind;  // arrival, spacing
    std::size_t axes = 0;
    double nearest = std::numeric_limits<double>::infinity();
    std::int32_t source = -1;
    const Eigen::Vector3d here = position(voxel);
    for (std::size_t a = 0; a < 3; ++a) {
      float best = never;
      const int at = place(voxel, a);
      const auto look = [&](std::size_t other) {
        if (done[other] == 0) return;
        best = std::min(best, arrivals.mm[other]);
        const double detour = std::max(0.0, arrivals.mm[other] - straight_mm(position(other), source_of[other]));
        const double offered = straight_mm(here, source_of[other]) + detour;
        if (offered < nearest || (offered == nearest && source_of[other] < source)) {
          nearest = offered;
          source = source_of[other];
        }
      };
      if (at > 0) look(voxel - stride[a]);
      if (at + 1 < grid.size[a]) look(voxel + stride[a]);
      if (best < never) upwind.at(axes++) = {best, grid.spacing_mm[static_cast<Eigen::Index>(a)]};
    }
    std::sort(upwind.begin(), upwind.begin() + static_cast<std::ptrdiff_t>(axes));
    // sum over axes of ((t - t_a) / h_a)^2 = 1, taking in one axis after the other while they lie upwind.
    double t = upwind[0].first + upwind[0].second, a = 0, b = 0, c = -1;
    for (std::size_t n = 0; n < axes && (n == 0 || upwind.at(n).first < t); ++n) {
      const double weight = 1 / (upwind.at(n).second * upwind.at(n).second), from = upwind.at(n).first;
      a += weight;
      b += weight * from;
      c += weight * from * from;
      const double root = b * b - a * c;
      if (root < 0) break;
      t = (b + std::sqrt(root)) / a;
    }
    if (static_cast<float>(t) >= arrivals.mm[voxel]) return;
    arrivals.mm[voxel] = static_cast<float>(t);
    arrivals.label[voxel] = sources[static_cast<std::size_t>(source)].label;
    source_of[voxel] = source;
    buckets.push(static_cast<float>(t), voxel);
  };

  std::size_t voxel = 0;
  while (buckets.pop(voxel)) {
    if (done[voxel] != 0) continue;
    done[voxel] = 1;
    for (std::size_t a = 0; a < 3; ++a) {
      const int at = place(voxel, a);
      for (const int way : {-1, 1}) {
        if (at + way < 0 || at + way >= grid.size[a]) continue;
        const std::size_t other = way < 0 ? voxel - stride[a] : voxel + stride[a];
        if (inside.values[other] != 0 && done[other] == 0) update(other);
      }
    }
  }
  return arrivals;
}

}  // namespace glisson::vasculature
