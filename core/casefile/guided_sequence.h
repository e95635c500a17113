#pragma once
// A case on a laparoscope's video: what guidance needs of both. With it the patient's own tumours and vessels are
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
  guidance::GuidanceCase guidance;    // a frame a cloud, in the order of answering; targets are the case's landmarks
  std::vector<std::size_t> frame_of;  // for each of them, which of the sequence it is
  std::vector<guidance::EmbeddedStructure> structures;  // the liver, then what lies inside of it
};

// `first_pose` takes the scan to the camera in `first_frame`, about; without it the pose is searched for. That frame is
// answered first, then those after it, then those before it, backwards. Each follows the one answered before, and the
// landmarks that were tracked. `noise_mm`: standard deviation of each coordinate of the clouds. Failures: those of
// reading the clouds.
Result<GuidedSequence> guided_sequence(const PatientModel& model, const registration_quality::SequenceFiles& sequence,
                                       const std::optional<Eigen::Isometry3d>& first_pose, double noise_mm = 0.5,
                                       std::size_t first_frame = 0);

// The same to be answered from that frame on. `guided` holds the frames in the sequence's order.
[[nodiscard]] GuidedSequence begun_at(GuidedSequence guided, std::size_t first_frame,
                                      const std::optional<Eigen::Isometry3d>& first_pose);

// What is drawn over one frame, as lines in its picture.
struct FrameOverlay {
  int width = 0, height = 0;  // of the picture, px
  std::vector<guidance::PlacedOutline> outlines;
};

// Of a frame of the sequence, below the instruments that its picture shows. Empty without a camera or an answer; where
// the frame names no picture, its size is told by the camera's middle. Failure: "image-not-readable".
Result<FrameOverlay> overlay_of(const GuidedSequence& guided, const registration_quality::SequenceFiles& sequence,
                                std::size_t frame, const guidance::ElasticPlacement& placement);

// f000.png and on: the sequence's pictures with the structures drawn where the answer says that they are. A frame
// without a picture, without a camera or without an answer is left out. Failures: those of reading and writing
// pictures. `placements` are in the order of the guidance's frames.
Result<std::vector<std::filesystem::path>> write_overlays(const std::filesystem::path& folder,
                                                          const GuidedSequence& guided,
                                                          const registration_quality::SequenceFiles& sequence,
                                                          const std::vector<guidance::ElasticPlacement>& placements);

}  // namespace glisson::casefile
