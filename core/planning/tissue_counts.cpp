#include "planning/internal/tissue_counts.h"

#include <mutex>

#include "base/parallel.h"

namespace glisson::planning {
namespace {

// What of one stretch goes, and what becomes of the rest.
void count(const Stretch& stretch, const std::uint8_t* goes, const float* trusted_kPa,
           const std::vector<std::uint32_t>& cause, Counts& counts);

void add(const Counts& other, Counts& counts) {
  for (std::size_t n = 0; n < counts.voxels.size(); ++n) counts.voxels[n] += other.voxels[n];
  for (std::size_t s = 0; s < segments_and_none; ++s) {
    counts.kPa[s] += other.kPa[s];
    counts.trusted[s] += other.trusted[s];
  }
  for (std::size_t n = 0; n < counts.affected.size(); ++n) counts.affected[n] += other.affected[n];
}

}  // namespace

std::vector<Stretch> stretches_of(const VoxelPlaces& voxels) {
  constexpr std::size_t longest = 1000;
  std::vector<Stretch> stretches;
  const auto point = [&](std::size_t system, std::size_t v) {
    return voxels.point[system].empty() ? static_cast<std::uint32_t>(voxels.points) : voxels.point[system][v];
  };
  for (std::size_t v = 0; v < voxels.segment.size(); ++v) {
    const std::size_t place = voxels.segment[v] * Counts::segment + (voxels.tumour[v] != 0 ? Counts::tumour : 0);
    const Stretch here{static_cast<std::uint32_t>(v),   {point(0, v), point(1, v)}, 0, 0, 0,
                       static_cast<std::uint8_t>(place)};
    if (stretches.empty() || stretches.back().point != here.point || stretches.back().place != here.place ||
        stretches.back().voxels == longest) {
      stretches.push_back(here);
    }
    const float kPa = voxels.trusted_kPa.empty() ? 0.0F : voxels.trusted_kPa[v];
    ++stretches.back().voxels;
    stretches.back().kPa += kPa;
    stretches.back().trusted += kPa > 0 ? 1 : 0;
  }
  return stretches;
}

Counts counted(const std::vector<Stretch>& stretches, const std::vector<std::uint8_t>& removed, const CutOff& off,
               const std::vector<float>& trusted_kPa) {
  Counts counts;
  counts.affected.assign(off.cut.size() + 1, 0);
  std::vector<std::uint32_t> cause;  // of each point, the number of cuts where none
  for (const std::int32_t one : off.cause) {
    cause.push_back(static_cast<std::uint32_t>(one < 0 ? static_cast<std::int32_t>(off.cut.size()) : one));
  }
  std::mutex adding;
  parallel_for(stretches.size(), 1 << 14, [&](std::size_t begin, std::size_t end) {
    Counts here;
    here.affected.assign(counts.affected.size(), 0);
    for (std::size_t n = begin; n < end; ++n) {
      const std::size_t first = stretches[n].first;
      count(stretches[n], removed.data() + first, trusted_kPa.data() + (trusted_kPa.empty() ? 0 : first), cause, here);
    }
    const std::lock_guard lock(adding);
    add(here, counts);
  });
  return counts;
}

Tissue TissueSum::tissue(double voxel_ml) const {
  Tissue made{static_cast<double>(voxels) * voxel_ml, {}, 0};
  if (trusted == 0) return made;
  made.mean_kPa = kPa / static_cast<double>(trusted);
  made.confident_share = static_cast<double>(trusted) / static_cast<double>(voxels);
  return made;
}

namespace {

void count(const Stretch& stretch, const std::uint8_t* goes, const float* trusted_kPa,
           const std::vector<std::uint32_t>& cause, Counts& counts) {
  std::size_t gone = 0;
  for (std::size_t v = 0; v < stretch.voxels; ++v) gone += goes[v] != 0 ? 1 : 0;
  counts.voxels[stretch.place | Counts::removed] += gone;
  if (gone == stretch.voxels) return;

  const std::size_t left = stretch.voxels - gone, nowhere = counts.affected.size() - 1;
  const std::uint32_t starved = cause[stretch.point[0]], held_up = cause[stretch.point[1]];
  counts.affected[starved] += left;
  counts.affected[held_up] += left;
  counts.voxels[stretch.place | (starved != nowhere ? Counts::starved : 0) |
                (held_up != nowhere ? Counts::held_up : 0)] += left;
  const std::size_t segment = stretch.place / Counts::segment;
  if (gone == 0) {
    counts.kPa[segment] += static_cast<double>(stretch.kPa);
    counts.trusted[segment] += stretch.trusted;
    return;
  }
  for (std::size_t v = 0; v < stretch.voxels && stretch.trusted > 0; ++v) {
    const float kPa = goes[v] != 0 ? 0 : trusted_kPa[v];
    counts.kPa[segment] += static_cast<double>(kPa);
    counts.trusted[segment] += kPa > 0 ? 1 : 0;
  }
}

}  // namespace
}  // namespace glisson::planning
