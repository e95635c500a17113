#include "anatomy/lesions.h"

#include <fmt/format.h>

#include "anatomy/implicit.h"
#include "anatomy/internal/capsules.h"
#include "base/noise.h"

namespace glisson::anatomy {

using Eigen::Vector3d;

namespace {

constexpr double lobulation = 0.1;

double distance_to_walls(const std::vector<const VesselTree*>& trees, const Vector3d& p) {
  double nearest = 1e9;
  for (const VesselTree* tree : trees) {
    for (const VesselNode& node : tree->nodes) {
      if (node.parent < 0 || node.segment != 0) continue;
      const Vector3d& from = tree->nodes[static_cast<std::size_t>(node.parent)].position_mm;
      nearest = std::min(nearest, on_stretch(from, node.position_mm, p).distance_mm - node.radius_mm);
    }
  }
  return nearest;
}

}  // namespace

VesselTree cut_at_lesions(const VesselTree& tree, const std::vector<Lesion>& lesions) {
  std::vector<bool> cut(tree.nodes.size(), false);
  for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
    if (tree.nodes[i].parent < 0) continue;
    const Capsule piece = capsule_of(tree, i);
    for (const Lesion& lesion : lesions) {
      const double from_middle = on_stretch(piece.from_mm, piece.to_mm, lesion.center_mm).distance_mm;
      if (from_middle < lesion.radius_mm * (1 + lobulation) + piece.radius_mm + 0.5) cut[i] = true;
    }
  }
  return pruned(tree, std::move(cut));
}

double Lesion::distance_mm(const Vector3d& p) const {
  const Vector3d from = p - center_mm;
  const double distance = from.norm();
  if (kind == LesionKind::cyst || distance < 1e-6) return distance - radius_mm;
  const double bump = smooth_noise(seed, from / distance, 0.8) + 0.5 * smooth_noise(seed + 1, from / distance, 0.35);
  return distance - radius_mm * (1 + lobulation * bump);
}

Result<std::vector<Lesion>> place_lesions(const std::vector<LesionWish>& wishes, const LiverBody& liver,
                                          const Segments& segments, const std::vector<const VesselTree*>& trunks,
                                          std::uint64_t seed) {
  constexpr double apart_mm = 3, off_vessels_mm = 1, under_surface_mm = 3;
  constexpr int tries = 60000;
  const geometry::Box box = geometry::bounding_box(liver.surface.points_mm);
  Random random(seed);
  std::vector<Lesion> lesions;
  std::array<int, 2> numbers{0, 0};
  for (const LesionWish& wish : wishes) {
    const int number = ++numbers[static_cast<std::size_t>(wish.kind)];
    Lesion lesion{fmt::format("{}-{}", wish.kind == LesionKind::tumour ? "tumour" : "cyst", number),
                  wish.kind,
                  {},
                  0.5 * wish.diameter_mm,
                  0,
                  mixed(seed, lesions.size())};
    const double reach = lesion.radius_mm * (wish.kind == LesionKind::tumour ? 1 + lobulation : 1);
    const auto fits = [&](const Vector3d& p) {
      if (liver.depth_mm(p) < reach + under_surface_mm) return false;
      for (const Lesion& other : lesions) {
        if ((other.center_mm - p).norm() < reach + other.radius_mm * (1 + lobulation) + apart_mm) return false;
      }
      return true;
    };
    const auto placed = [&]() -> std::optional<Vector3d> {
      if (wish.position_mm) return fits(*wish.position_mm) ? wish.position_mm : std::nullopt;
      for (int attempt = 0; attempt < tries; ++attempt) {
        Vector3d p;
        for (int a = 0; a < 3; ++a) p[a] = random.uniform(box.min_mm[a], box.max_mm[a]);
        if (wish.segment && segments.at(p) != *wish.segment) continue;
        if (fits(p) && distance_to_walls(trunks, p) >= reach + off_vessels_mm) return p;
      }
      return std::nullopt;
    };
    const auto place = placed();
    if (!place) {
      return failure(
          "anatomy-lesion-no-room",
          GLISSON_TEXT("There is no room in the liver for {0} of {1} mm: make it smaller, or let it lie elsewhere."),
          {lesion.name, fmt::format("{:g}", wish.diameter_mm)});
    }
    lesion.center_mm = *place;
    lesion.segment = segments.at(*place);
    lesions.push_back(std::move(lesion));
  }
  return lesions;
}

}  // namespace glisson::anatomy
