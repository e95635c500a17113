#pragma once
// Tumours and cysts: where they may lie, and their shapes.

#include <optional>
#include <string>

#include "anatomy/random.h"
#include "anatomy/segments.h"
#include "anatomy/vessel_tree.h"
#include "base/result.h"

namespace glisson::anatomy {

enum class LesionKind { tumour, cyst };

struct LesionWish {
  LesionKind kind = LesionKind::tumour;
  double diameter_mm = 25;
  std::optional<int> segment;                  // anywhere if absent
  std::optional<Eigen::Vector3d> position_mm;  // goes before the segment
};

// A ball, lobulated where it is a tumour: the radius varies by about a tenth.
struct Lesion {
  std::string name;  // "tumour-1", "cyst-2"
  LesionKind kind = LesionKind::tumour;
  Eigen::Vector3d center_mm{0, 0, 0};
  double radius_mm = 0;
  int segment = 0;
  std::uint64_t seed = 0;

  [[nodiscard]] double distance_mm(const Eigen::Vector3d& position_mm) const;  // to its wall, negative inside
};

// Each lies at least 3 mm under the surface (thinner tissue makes flat cells) and 3 mm clear of the others. It is clear
// by 1 mm of the walls of vessels that serve several segments. One wished at a position lies there, whatever vessels
// are near. Fails with anatomy-lesion-no-room.
Result<std::vector<Lesion>> place_lesions(const std::vector<LesionWish>& wishes, const LiverBody& liver,
                                          const Segments& segments, const std::vector<const VesselTree*>& trunks,
                                          std::uint64_t seed);

// The tree without what would run through a lesion: a segment's own branches end before it.
[[nodiscard]] VesselTree cut_at_lesions(const VesselTree& tree, const std::vector<Lesion>& lesions);

}  // namespace glisson::anatomy
