#include "rehearsal/tool_presets.h"

#include <algorithm>
#include <numeric>

#include <Eigen/Geometry>

#include "base/units.h"

namespace glisson::rehearsal {
namespace {

using Eigen::Vector3d;

struct Face {
  Vector3d centroid_mm;
  Vector3d normal;
  double area_mm2;
};

std::vector<Face> faces_of(const geometry::Surface& surface);

}  // namespace

const std::vector<ToolPreset>& tool_presets() {
  static const std::vector<ToolPreset> presets{
      {"nathanson-retractor", GLISSON_TEXT("Nathanson liver retractor"), 35.0, 2.0, 10.0,
       GLISSON_TEXT(
           "A bent rod that lies under the liver as a hook some centimetres across, sold in several sizes. We found no "
           "published drawing and no measured force: that it spreads its pull over a disc of 70 mm is our assumption, "
           "and "
           "2 N is the weight of 190 ml of liver (1.06 kg/l), what lifting the lower part of segment VI takes. On a "
           "real "
           "liver's shape with a uniform 6 kPa, 2 N hoist it by 18 mm; linear elasticity is strained beyond.")},
      {"grasper", GLISSON_TEXT("Grasper"), 6.0, 1.75, 3.4,
       GLISSON_TEXT(
           "Grip forces in porcine laparoscopic liver resection: 1.75 N on average, 3.38 N at most (Minimally Invasive "
           "Therapy & Allied Technologies 31(1):28-33, 2022, doi:10.1080/13645706.2020.1755313). The jaw's patch of "
           "12 mm is our assumption.")},
      {"palpation-probe", GLISSON_TEXT("Palpation probe"), 5.0, 1.0, 3.0,
       GLISSON_TEXT("A sphere of 10 mm pressed lightly; size and force are our assumption.")},
  };
  return presets;
}

Result<ToolPreset> tool_preset(const std::string& id) {
  std::string known;
  for (const ToolPreset& preset : tool_presets()) {
    if (preset.id == id) return preset;
    known += (known.empty() ? "" : ", ") + preset.id;
  }
  return failure(Error{
      "tool-unknown", GLISSON_TEXT("There is no tool {0}."), {id, known}, GLISSON_TEXT("The tools are: {1}."), {}});
}

mechanics::ToolLoad tool_load(const ToolPlacement& placement, double force_N) {
  return {placement.center_mm, placement.preset.radius_mm, units::mN_from_N(force_N) * placement.direction};
}

Result<ToolPlacement> hoist_segment_vi(const geometry::TetMesh& liver) {
  if (auto checked = geometry::check_tetrahedra(liver); !checked) return failure(std::move(checked.error()));
  const std::vector<Face> faces = faces_of(geometry::boundary_surface(liver));
  const geometry::Box box = geometry::bounding_box(liver.points_mm);
  const Vector3d size_mm = (box.max_mm - box.min_mm).cwiseMax(1e-9);

  // How far a place lies towards the right (-x), the back (+y) and the feet (-z): 0 to 3.
  const auto score = [&](const Face& face) {
    const Vector3d unit = (face.centroid_mm - box.min_mm).cwiseQuotient(size_mm);
    return (1.0 - unit.x()) + unit.y() + (1.0 - unit.z());
  };
  std::vector<std::size_t> under;
  double under_area_mm2 = 0;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    if (faces[f].normal.z() >= 0 && faces[f].normal.y() <= 0) continue;
    under.push_back(f);
    under_area_mm2 += faces[f].area_mm2;
  }
  std::sort(under.begin(), under.end(),
            [&](std::size_t a, std::size_t b) { return score(faces[a]) > score(faces[b]); });

  Vector3d mean_mm = Vector3d::Zero();
  double area_mm2 = 0;
  for (const std::size_t f : under) {
    mean_mm += faces[f].area_mm2 * faces[f].centroid_mm;
    area_mm2 += faces[f].area_mm2;
    if (area_mm2 >= 0.05 * under_area_mm2) break;
  }
  mean_mm /= area_mm2;
  const std::size_t nearest = *std::min_element(under.begin(), under.end(), [&](std::size_t a, std::size_t b) {
    return (faces[a].centroid_mm - mean_mm).squaredNorm() < (faces[b].centroid_mm - mean_mm).squaredNorm();
  });
  return ToolPlacement{tool_presets().front(), faces[nearest].centroid_mm, Vector3d(0, -1, 1).normalized()};
}

namespace {

std::vector<Face> faces_of(const geometry::Surface& surface) {
  std::vector<Face> faces;
  faces.reserve(surface.triangles.size());
  for (const auto& [a, b, c] : surface.triangles) {
    const Vector3d &p = surface.points_mm[a], &q = surface.points_mm[b], &r = surface.points_mm[c];
    const Vector3d twice_area = (q - p).cross(r - p);
    faces.push_back({(p + q + r) / 3.0, twice_area.normalized(), 0.5 * twice_area.norm()});
  }
  return faces;
}

}  // namespace
}  // namespace glisson::rehearsal
