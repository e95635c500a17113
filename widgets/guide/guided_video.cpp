#include "widgets/guide/guided_video.h"

#include <QJsonArray>
#include <QJsonObject>

#include "base/files.h"

namespace glisson::widgets {

namespace fs = std::filesystem;

Result<std::shared_ptr<const GuidedVideo>> open_guided_video(const fs::path& case_folder, const fs::path& sequence,
                                                             const Progress& progress) {
  progress.report(0, GLISSON_TEXT("Reading the sequence"));
  auto files = registration_quality::read_sequence(sequence);
  if (!files) return failure(files.error());
  const auto content = sha256_of_file(sequence);
  if (!content) return failure(content.error());
  progress.report(0.2, GLISSON_TEXT("Reading the case"));
  const auto patient = casefile::Case::open(case_folder);
  if (!patient) return failure(patient.error());
  auto model = casefile::read_model(*patient);
  if (!model) return failure(model.error());
  if (progress.cancelled()) return cancelled();
  progress.report(0.5, GLISSON_TEXT("Reading the clouds"));
  auto guided = casefile::guided_sequence(*model, *files, std::nullopt);
  if (!guided) return failure(guided.error());
  casefile::add_plans(*guided, *patient);
  return std::make_shared<const GuidedVideo>(
      GuidedVideo{case_folder, sequence, *content, model_content(case_folder), *std::move(files), *std::move(guided)});
}

std::string model_content(const fs::path& case_folder) {
  std::string content;
  const auto patient = casefile::Case::open(case_folder);
  if (!patient) return content;
  for (const char* id : {"meshes/model", "evidence/model"}) {
    if (const casefile::Entry* entry = patient->find(id)) content += entry->sha256;
  }
  return content;
}

QJsonValue json_of(const std::optional<HandPose>& pose) {
  if (!pose) return QJsonValue::Null;
  QJsonArray numbers;
  for (int k = 0; k < 16; ++k) numbers.append(pose->pose.matrix()(k / 4, k % 4));
  return QJsonObject{{"sequence", QString::fromStdString(pose->sequence)},
                     {"frame", static_cast<int>(pose->frame)},
                     {"pose", numbers}};
}

std::optional<HandPose> hand_pose_of(const QJsonValue& json) {
  std::vector<double> numbers;
  for (const auto& number : json["pose"].toArray()) numbers.push_back(number.toDouble());
  const auto pose = guidance::rigid_pose(numbers);
  const int frame = json["frame"].toInt(-1);
  if (!pose || frame < 0) return std::nullopt;
  return HandPose{json["sequence"].toString().toStdString(), static_cast<std::size_t>(frame), *pose};
}

Result<std::shared_ptr<const guidance::ForceModes>> place_liver(
    const GuidedVideo& video, std::shared_ptr<const guidance::ForceModes> modes, const std::optional<HandPose>& from,
    const casefile::MarkedLines& lines, std::size_t frames, const Progress& progress, const GuidedFrameHeard& heard) {
  std::optional<Eigen::Isometry3d> first_pose;
  if (from) first_pose = from->pose;
  const std::size_t marked = casefile::first_marked_frame(lines).value_or(0);
  casefile::GuidedSequence guided = casefile::begun_at(video.guided, from ? from->frame : marked, first_pose);
  casefile::add_lines(guided, lines);
  guided.guidance.frames.resize(std::min(frames, guided.guidance.frames.size()));
  const guidance::GuidanceCase& asked = guided.guidance;
  if (!modes) {
    const auto made =
        guidance::ForceModes::create(asked.mesh, asked.youngs_kPa, asked.poisson_ratio, {}, progress.part(0, 0.25));
    if (!made) return failure(made.error());
    modes = std::make_shared<const guidance::ForceModes>(*made);
  }
  std::optional<Error> problem;
  const auto answered =
      guidance::answer(*modes, asked, progress.part(0.25, 1), [&](std::size_t k, const guidance::FrameAnswer& answer) {
        const std::size_t frame = guided.frame_of[k];
        auto overlay = casefile::overlay_of(guided, video.sequence, frame, answer.placement);
        if (!overlay) problem = overlay.error();
        heard(frame, std::make_shared<const GuidedFrame>(
                         GuidedFrame{answer.placement, overlay ? *std::move(overlay) : casefile::FrameOverlay{}}));
      });
  if (!answered) return failure(answered.error());
  if (problem) return failure(*problem);
  return modes;
}

}  // namespace glisson::widgets
