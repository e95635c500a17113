#pragma once
// A case on a laparoscope's video: what guidance needs of both, so that the patient's own tumours and vessels are
// found, and drawn, on each frame.

#include <Eigen/Geometry>
#include <optional>
#include <vector>

#include "base/result.h"
#include "casefile/model.h"
#include "guidance/guidance_file.h"
#include "guidance/overlay.h"
#include "registration_quality/sequence_file.h"

namespace glisson::casefile {

struct GuidedSequence {
  guidance::GuidanceCase guidance;                      // a frame a cloud, f000 on; targets are the case's landmarks
  std::vector<guidance::EmbeddedStructure> structures;  // the liver, then what lies inside of it
};

// `first_pose` takes the scan to the camera in the first frame, about; without it the pose is searched for. Later
// frames follow the one before, and the landmarks that were tracked. `noise_mm`: standard deviation of each coordinate
// of the clouds. Failures: those of reading the clouds.
Result<GuidedSequence> guided_sequence(const PatientModel& model, const registration_quality::SequenceFiles& sequence,
                                       const std::optional<Eigen::Isometry3d>& first_pose, double noise_mm = 0.5);

// f000.png and on: the sequence's pictures with the structures drawn where the answer says that they are. A frame
// without a picture, without a camera or without an answer is left out. Failures: those of reading and writing
// pictures.
Result<std::vector<std::filesystem::path>> write_overlays(const std::filesystem::path& folder,
                                                          const GuidedSequence& guided,
                                                          const registration_quality::SequenceFiles& sequence,
                                                          const std::vector<guidance::ElasticPlacement>& placements);

}  // namespace glisson::casefile
