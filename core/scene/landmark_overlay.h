#pragma once
// Predicted landmarks over the grey scan: circles where the scan has them and where a simulation brings them. They are
// drawn with the patient's stiffness and with an atlas's. The dissertation's figure 4.16d projects its simulation onto
// a grey scan of what was pressed. Here the scan is the one before the operation, so that it shows the liver at rest.
//
// Each group of landmarks ("tumour", "hepatic-vein") has a picture: the slice through one of the group. That is the one
// which the atlas misplaces most, or which moves most. The slice lies across the patient axis along which it moves
// least. Circles are projected onto the slice along that axis; landmarks farther than `slab_mm` from it at rest are
// left out, and counted.

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "scene/scene.h"

namespace glisson::scene {

inline constexpr double slab_mm = 8;  // to either side

struct PredictedLandmark {
  std::string id;
  Eigen::Vector3d rest_mm{0, 0, 0};  // patient LPS, as are the others
  Eigen::Vector3d patient_mm{0, 0, 0};
  std::optional<Eigen::Vector3d> reference_mm;
};

struct LandmarkOverlay {
  std::string group;
  Scene scene;
  int shown = 0, of = 0;  // landmarks of the group
};

// The colours of the three circles.
inline constexpr Colour rest_yellow{1.0, 0.88, 0.15}, patient_blue{0.25, 0.65, 1.0}, reference_red{1.0, 0.3, 0.25};

// Groups in the order in which they come.
[[nodiscard]] std::vector<LandmarkOverlay> landmark_overlays(const std::shared_ptr<const imaging::Volume>& scan,
                                                             const std::vector<MaskLine>& outlines,
                                                             const std::vector<PredictedLandmark>& landmarks);

// Of a result in a case's results/ and, where given, the atlas's result of the same question.
// Fails as read_result does, and with "overlay-needs-case" where the result lies in no case with a scan.
Result<std::vector<LandmarkOverlay>> landmark_overlays(const std::filesystem::path& result,
                                                       const std::optional<std::filesystem::path>& reference);

}  // namespace glisson::scene
