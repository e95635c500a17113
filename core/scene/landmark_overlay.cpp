#include "scene/landmark_overlay.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "casefile/result_folder.h"
#include "casefile/structures.h"
#include "scene/anatomy.h"
#include "scene/case_scenes.h"
#include "scene/internal/slices.h"

namespace glisson::scene {
namespace {

using Eigen::Vector3d;
namespace fs = std::filesystem;

constexpr double circle_radius_mm = 4, circle_width_mm = 0.9, above_slice_mm = 1;
constexpr int circle_corners = 48;

// "hepatic-vein-3" is of the group "hepatic-vein".
std::string group_of(const std::string& id) {
  const std::size_t dash = id.rfind('-');
  const bool numbered = dash != std::string::npos && dash + 1 < id.size() &&
                        id.find_first_not_of("0123456789", dash + 1) == std::string::npos;
  return numbered ? id.substr(0, dash) : id;
}

// How much of a reason to look at it there is: how far the atlas is off, else how far it moves.
double weight_of(const PredictedLandmark& landmark) {
  return landmark.reference_mm ? (*landmark.reference_mm - landmark.patient_mm).norm()
                               : (landmark.patient_mm - landmark.rest_mm).norm();
}

int axis_of_least_motion(const PredictedLandmark& landmark) {
  Vector3d motion = (landmark.patient_mm - landmark.rest_mm).cwiseAbs();
  if (landmark.reference_mm) motion = motion.cwiseMax((*landmark.reference_mm - landmark.rest_mm).cwiseAbs());
  int axis = 0;
  motion.minCoeff(&axis);
  return axis;
}

// A flat ring in the slice, a little towards the eye.
SurfaceItem circle(const std::string& name, const Vector3d& center_mm, const Camera& camera, const Colour& colour) {
  geometry::Surface ring;
  const Vector3d right = camera.sight.cross(camera.up);
  for (int corner = 0; corner < circle_corners; ++corner) {
    const double angle = 2 * std::numbers::pi * corner / circle_corners;
    const Vector3d out = std::cos(angle) * right + std::sin(angle) * camera.up;
    for (const double radius_mm : {circle_radius_mm, circle_radius_mm + circle_width_mm})
      ring.points_mm.emplace_back(center_mm + radius_mm * out - above_slice_mm * camera.sight);
    const int here = 2 * corner, next = 2 * ((corner + 1) % circle_corners);
    ring.triangles.push_back({here, here + 1, next});
    ring.triangles.push_back({here + 1, next + 1, next});
  }
  return {name, std::make_shared<const geometry::Surface>(std::move(ring)), colour, 1, Finish::solid, {}, false};
}

LandmarkOverlay overlay_of(const std::string& group, const std::vector<PredictedLandmark>& landmarks,
                           const std::shared_ptr<const imaging::Volume>& scan, const std::vector<MaskLine>& outlines) {
  const auto main = std::max_element(landmarks.begin(), landmarks.end(),
                                     [](const auto& a, const auto& b) { return weight_of(a) < weight_of(b); });
  const Vector3d normal = Vector3d::Unit(axis_of_least_motion(*main));
  LandmarkOverlay overlay{group, {}, 0, static_cast<int>(landmarks.size())};
  SliceItem slice;
  slice.volume = scan;
  slice.center_mm = main->rest_mm;
  slice.normal = normal;
  slice.masks = outlines;
  set_grey_window(slice);

  std::vector<Vector3d> seen;
  const auto in_slice = [&](const Vector3d& position_mm) -> Vector3d {
    return position_mm - normal.dot(position_mm - main->rest_mm) * normal;
  };
  const auto is_near = [&](const PredictedLandmark& landmark) {
    return std::abs(normal.dot(landmark.rest_mm - main->rest_mm)) <= slab_mm;
  };
  for (const PredictedLandmark& landmark : landmarks) {
    if (!is_near(landmark)) continue;
    for (const Vector3d& place :
         {landmark.rest_mm, landmark.patient_mm, landmark.reference_mm.value_or(landmark.rest_mm)})
      seen.push_back(in_slice(place));
  }
  constexpr double around_mm = 70, at_least_mm = 110;
  const geometry::Box box = geometry::bounding_box(seen);
  const double height_mm = std::max(at_least_mm, (box.max_mm - box.min_mm).maxCoeff() + around_mm);
  const Camera camera = look_at_slice(in_slice(box.center_mm()), normal, height_mm);
  for (const PredictedLandmark& landmark : landmarks) {
    if (!is_near(landmark)) continue;
    ++overlay.shown;
    const Vector3d moved_mm = in_slice(landmark.patient_mm);
    overlay.scene.surfaces.push_back(circle("rest", in_slice(landmark.rest_mm), camera, rest_yellow));
    if (landmark.reference_mm)
      overlay.scene.surfaces.push_back(circle("atlas", in_slice(*landmark.reference_mm), camera, reference_red));
    overlay.scene.surfaces.push_back(circle("patient", moved_mm, camera, patient_blue));
    const double moves_mm = (landmark.patient_mm - landmark.rest_mm).norm();
    std::string label = fmt::format("{} moves {:.1f} mm", landmark.id, moves_mm);
    if (landmark.reference_mm)
      label += fmt::format(", atlas {:.1f} mm off", (*landmark.reference_mm - landmark.patient_mm).norm());
    overlay.scene.landmarks.push_back({label, moved_mm - above_slice_mm * camera.sight, 0.5, patient_blue});
  }
  overlay.scene.slices.push_back(std::move(slice));
  overlay.scene.camera = camera;
  Annotations& notes = overlay.scene.annotations;
  notes.orientation = Annotations::Orientation::letters;
  notes.title = "Predicted landmarks over the scan: " + group;
  notes.subtitle =
      fmt::format("Projected onto the slice: {} of {}. The scan shows the liver at rest.", overlay.shown, overlay.of);
  notes.key = {{rest_yellow, "In the scan"}, {patient_blue, "Predicted, the patient's stiffness"}};
  if (main->reference_mm) notes.key.push_back({reference_red, "Predicted, the atlas's stiffness"});
  return overlay;
}

}  // namespace

std::vector<LandmarkOverlay> landmark_overlays(const std::shared_ptr<const imaging::Volume>& scan,
                                               const std::vector<MaskLine>& outlines,
                                               const std::vector<PredictedLandmark>& landmarks) {
  std::vector<std::pair<std::string, std::vector<PredictedLandmark>>> groups;
  for (const PredictedLandmark& landmark : landmarks) {
    const std::string group = group_of(landmark.id);
    auto known = std::find_if(groups.begin(), groups.end(), [&](const auto& entry) { return entry.first == group; });
    if (known == groups.end()) known = groups.insert(groups.end(), {group, {}});
    known->second.push_back(landmark);
  }
  std::vector<LandmarkOverlay> overlays;
  for (const auto& [group, members] : groups) overlays.push_back(overlay_of(group, members, scan, outlines));
  return overlays;
}

Result<std::vector<LandmarkOverlay>> landmark_overlays(const fs::path& result,
                                                       const std::optional<fs::path>& reference) {
  const auto patients = casefile::read_result(result);
  if (!patients) return failure(patients.error());
  std::vector<PredictedLandmark> landmarks;
  for (const auto& landmark : patients->landmarks)
    landmarks.push_back({landmark.id, landmark.rest_mm, landmark.displaced_mm, {}});
  if (reference) {
    const auto references = casefile::read_result(*reference);
    if (!references) return failure(references.error());
    for (PredictedLandmark& landmark : landmarks) {
      for (const auto& other : references->landmarks) {
        if (other.id == landmark.id) landmark.reference_mm = other.displaced_mm;
      }
    }
  }
  std::error_code problem;
  const fs::path above = fs::absolute(result, problem).lexically_normal().parent_path().parent_path();
  if (!fs::exists(above / "case.json", problem)) {
    return failure(Error{"overlay-needs-case",
                         GLISSON_TEXT("{0} lies in no case, so that there is no scan to draw over."),
                         {result.string()},
                         GLISSON_TEXT("Give a result in the folder results of a case."),
                         result});
  }
  const auto patient = casefile::Case::open(above);
  if (!patient) return failure(patient.error());
  auto scan = patient->volume("volumes/anatomy");
  if (!scan) return failure(scan.error());
  auto structures = casefile::read_structures(*patient);
  if (!structures) return failure(structures.error());
  std::vector<MaskLine> outlines;
  for (auto& structure : *structures) outlines.push_back(outline_of(std::move(structure)));
  auto overlays = landmark_overlays(std::make_shared<const imaging::Volume>(std::move(*scan)), outlines, landmarks);
  for (LandmarkOverlay& overlay : overlays) overlay.scene.annotations.warning = warning_of(*patient);
  return overlays;
}

}  // namespace glisson::scene
