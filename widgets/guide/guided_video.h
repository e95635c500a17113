#pragma once
// What the Guide page shows, as values: the open case's liver, a laparoscope's sequence, and where the liver lies in
// each of its frames.

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <QJsonValue>
#include <string>

#include "casefile/guided_plan.h"
#include "casefile/marked_lines.h"
#include "guidance/guidance_answer.h"

namespace glisson::widgets {

// A case's model and a sequence, ready to be placed by hand or found.
struct GuidedVideo {
  std::filesystem::path case_folder, file;  // file: sequence.json
  std::string content;                      // its SHA-256: what was kept of a sequence is kept of its content
  std::string model_content;                // the same of what the model is made from
  registration_quality::SequenceFiles sequence;
  casefile::GuidedSequence guided;  // nothing of it is answered yet
};

// Long work. Failures: those of reading the case, its model, the sequence and its clouds.
Result<std::shared_ptr<const GuidedVideo>> open_guided_video(const std::filesystem::path& case_folder,
                                                             const std::filesystem::path& sequence,
                                                             const Progress& progress);

// Of what the case's model is made from now: another value is another model. Empty where there is none.
[[nodiscard]] std::string model_content(const std::filesystem::path& case_folder);

// A frame that was answered, or was not and says why.
struct GuidedFrame {
  guidance::ElasticPlacement placement;
  casefile::FrameOverlay overlay;
};
using GuidedFrameHeard = std::function<void(std::size_t frame, std::shared_ptr<const GuidedFrame>)>;

// Where a person laid the liver, and on which frame of which sequence.
struct HandPose {
  std::string sequence;  // GuidedVideo::content
  std::size_t frame = 0;
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();  // scan to camera
};
[[nodiscard]] QJsonValue json_of(const std::optional<HandPose>& pose);
// Nothing where it is none, or damaged.
[[nodiscard]] std::optional<HandPose> hand_pose_of(const QJsonValue& json);

// Long work: the liver in so many frames at most, each told as soon as it is known. Begins where a hand laid it, else
// on the first frame with a marked line. `modes` are made where there are none, and returned for the next time.
// Failures: those of ForceModes::create and of reading pictures; "cancelled".
Result<std::shared_ptr<const guidance::ForceModes>> place_liver(
    const GuidedVideo& video, std::shared_ptr<const guidance::ForceModes> modes, const std::optional<HandPose>& from,
    const casefile::MarkedLines& lines, std::size_t frames, const Progress& progress, const GuidedFrameHeard& heard);

}  // namespace glisson::widgets
