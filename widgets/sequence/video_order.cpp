#include "widgets/sequence/video_order.h"

#include <chrono>

#include "scene/depth_picture.h"

namespace glisson::widgets {
namespace {

using registration_quality::MatchedFrame;
using registration_quality::VideoSequence;

Result<vision::StereoCalibration> calibration_of(const VideoOrder& order, const Progress& progress,
                                                 const SequenceHeard& heard) {
  if (!order.calibration.empty()) {
    auto calibration = vision::read_stereo_calibration(order.calibration);
    if (calibration) heard.calibrated({false, 0, 0, 0, calibration->baseline_mm()});
    return calibration;
  }
  constexpr int most_pairs = 60;  // more make it slower, not better
  vision::BoardPictures pictures = order.board;
  int count = 0;
  for (const auto& source : pictures.left) {
    const auto opened = vision::FrameSource::open(source);
    if (!opened) return failure(opened.error());
    count += opened->count().value_or(0);
  }
  pictures.every = std::max(1, (count + most_pairs - 1) / most_pairs);
  auto fit = vision::calibrate(pictures, progress);
  if (!fit) return failure(fit.error());
  heard.calibrated({true, fit->stereo_rms_px, fit->pairs, fit->looked_at, fit->calibration.baseline_mm()});
  return std::move(fit->calibration);
}

QImage picture_of(const vision::StereoCloud& cloud, int step_px) {
  constexpr int widest = 1400;
  const vision::Frame both = scene::depth_picture(cloud, step_px);
  const QImage seen(both.rgb.data(), both.width, both.height, 3 * both.width, QImage::Format_RGB888);
  return both.width > widest ? seen.scaledToWidth(widest, Qt::SmoothTransformation) : seen.copy();
}

}  // namespace

Result<VideoSequence> make_from_video(const VideoOrder& order, const Progress& progress, const SequenceHeard& heard) {
  // What is wrong with the video is said before a board is looked for.
  auto video = vision::StereoSource::open(order.video);
  if (!video) return failure(video.error());
  if (auto enough = video->has(order.options.needed()); !enough) return failure(enough.error());
  const bool from_board = order.calibration.empty();
  const auto calibration = calibration_of(order, progress.part(0, from_board ? 0.3 : 0), heard);
  if (!calibration) return failure(calibration.error());
  using Clock = std::chrono::steady_clock;
  constexpr auto between_pictures = std::chrono::milliseconds(400);
  std::optional<Clock::time_point> shown;
  const auto matched = [&](const MatchedFrame& frame) {
    FrameReport told{frame.number, frame.cloud.points_mm.size(), frame.cloud.valid_fraction, frame.followed, true, {}};
    const vision::Frame& seen = frame.cloud.picture;
    told.may_be_of_size = vision::may_be_of_size(*calibration, seen.width, seen.height);
    if (!shown || Clock::now() - *shown > between_pictures) {
      told.picture = picture_of(frame.cloud, order.options.stereo.step_px);
      shown = Clock::now();
    }
    heard.matched(told);
  };
  return registration_quality::make_sequence(*video, *calibration, order.folder, order.options,
                                             progress.part(from_board ? 0.3 : 0, 1), matched);
}

}  // namespace glisson::widgets
