#include "vision/calibrate.h"

#include <fmt/format.h>
#include <cmath>
#include <map>
#include <opencv2/calib3d.hpp>
#include <opencv2/core/eigen.hpp>

namespace glisson::vision {
namespace {

// What one eye saw, as OpenCV wants it: a list of views, each of points on the board and in the picture.
struct Seen {
  std::vector<std::vector<cv::Point3f>> on_board;
  std::vector<std::vector<cv::Point2f>> in_picture;

  void add(const BoardView& view, const Board& board);
  [[nodiscard]] int points() const;
};

struct Lens {
  cv::Mat matrix, distortion;
  CameraFit fit;
};

Lens fit_lens(const Seen& seen, const cv::Size& size);
Camera to_camera(const Lens& lens);
std::pair<BoardView, BoardView> in_both(const BoardView& left, const BoardView& right);

}  // namespace

Result<CalibrationFit> calibrate(const std::vector<BoardPair>& pairs, const Board& board) {
  constexpr int fewest_views = 3, fewest_points = 12;
  if (auto good = check(board); !good) return failure(good.error());
  CalibrationFit fit;
  Seen left, right, left_of_both, right_of_both;
  for (const BoardPair& pair : pairs) {
    for (const Frame* frame : {&pair.left, &pair.right}) {
      if (frame->width == pairs.front().left.width && frame->height == pairs.front().left.height) continue;
      return failure("stereo-image-sizes", GLISSON_TEXT("{0} has {1} x {2} pixels, the first picture has {3} x {4}."),
                     {pair.name, std::to_string(frame->width), std::to_string(frame->height),
                      std::to_string(pairs.front().left.width), std::to_string(pairs.front().left.height)});
    }
    const auto in_left = find_board(pair.left, board), in_right = find_board(pair.right, board);
    if (!in_left || !in_right) {
      fit.notes.push_back(fmt::format("{}: the {} picture shows no board", pair.name, in_left ? "right" : "left"));
      continue;
    }
    const auto [both_left, both_right] = in_both(*in_left, *in_right);
    if (static_cast<int>(both_left.points.size()) < fewest_points) {
      fit.notes.push_back(fmt::format("{}: both eyes see only {} points", pair.name, both_left.points.size()));
      continue;
    }
    left.add(*in_left, board);
    right.add(*in_right, board);
    left_of_both.add(both_left, board);
    right_of_both.add(both_right, board);
  }
  fit.pairs = static_cast<int>(left.on_board.size());
  fit.points = left_of_both.points();
  if (fit.pairs < fewest_views) {
    return failure(Error{"calibration-too-few-views",
                         GLISSON_TEXT("{0} of {1} pairs show the board to both eyes; {2} are needed."),
                         {std::to_string(fit.pairs), std::to_string(pairs.size()), std::to_string(fewest_views)},
                         GLISSON_TEXT("Check the board's kind, its columns and rows; take it from several sides."),
                         {}});
  }
  try {
    const cv::Size size(pairs.front().left.width, pairs.front().left.height);
    Lens left_lens = fit_lens(left, size), right_lens = fit_lens(right, size);
    cv::Mat rotation, translation, essential, fundamental, each_rms;
    fit.stereo_rms_px =
        cv::stereoCalibrate(left_of_both.on_board, left_of_both.in_picture, right_of_both.in_picture, left_lens.matrix,
                            left_lens.distortion, right_lens.matrix, right_lens.distortion, size, rotation, translation,
                            essential, fundamental, each_rms, cv::CALIB_FIX_INTRINSIC);
    for (int view = 0; view < each_rms.rows; ++view) {
      fit.pair_rms_px.push_back(std::hypot(each_rms.at<double>(view, 0), each_rms.at<double>(view, 1)) /
                                std::sqrt(2.0));
    }
    fit.left = left_lens.fit;
    fit.right = right_lens.fit;
    fit.calibration.left = to_camera(left_lens);
    fit.calibration.right = to_camera(right_lens);
    Eigen::Matrix3d turn;
    Eigen::Vector3d move;
    cv::cv2eigen(rotation, turn);
    cv::cv2eigen(translation, move);
    fit.calibration.left_to_right.linear() = turn;
    fit.calibration.left_to_right.translation() = move;
  } catch (const cv::Exception& problem) {
    return failure("calibration-failed", GLISSON_TEXT("The calibration did not converge: {0}."), {problem.err});
  }
  auto good = checked(fit.calibration);
  if (!good) return failure(good.error());
  if (!good->notes.empty()) {
    return failure(Error{"stereo-eyes-exchanged",
                         GLISSON_TEXT("By these pictures the right eye lies to the left of the left one."),
                         {},
                         GLISSON_TEXT("Exchange the left and the right pictures."),
                         {}});
  }
  return fit;
}

Result<double> reprojection_rms_px(const Camera& known, const std::vector<Frame>& frames, const Board& board) {
  cv::Mat matrix;
  cv::eigen2cv(known.matrix, matrix);
  const cv::Mat distortion(known.distortion, true);
  double sum_px2 = 0, points = 0;
  for (const Frame& frame : frames) {
    const auto view = find_board(frame, board);
    if (!view) return failure(view.error());
    Seen seen;
    seen.add(*view, board);
    try {
      cv::Mat turn, move;
      cv::solvePnP(seen.on_board.front(), seen.in_picture.front(), matrix, distortion, turn, move);
      std::vector<cv::Point2f> shown;
      cv::projectPoints(seen.on_board.front(), turn, move, matrix, distortion, shown);
      for (std::size_t i = 0; i < shown.size(); ++i) {
        const cv::Point2f off = shown[i] - seen.in_picture.front()[i];
        sum_px2 += static_cast<double>(off.dot(off));
        ++points;
      }
    } catch (const cv::Exception& problem) {
      return failure("calibration-failed", GLISSON_TEXT("The calibration did not converge: {0}."), {problem.err});
    }
  }
  return points > 0 ? std::sqrt(sum_px2 / points) : 0;
}

namespace {

void Seen::add(const BoardView& view, const Board& board) {
  auto& positions = on_board.emplace_back();
  auto& pixels = in_picture.emplace_back();
  for (std::size_t i = 0; i < view.points.size(); ++i) {
    const Eigen::Vector3f position = board.position_mm(view.points[i]).cast<float>();
    positions.emplace_back(position.x(), position.y(), position.z());
    pixels.emplace_back(static_cast<float>(view.pixels[i].x()), static_cast<float>(view.pixels[i].y()));
  }
}

int Seen::points() const {
  std::size_t sum = 0;
  for (const auto& view : on_board) sum += view.size();
  return static_cast<int>(sum);
}

Lens fit_lens(const Seen& seen, const cv::Size& size) {
  Lens lens;
  std::vector<cv::Mat> turns, moves;
  cv::Mat deviations, pose_deviations, each_rms;
  lens.fit.rms_px = cv::calibrateCamera(seen.on_board, seen.in_picture, size, lens.matrix, lens.distortion, turns,
                                        moves, deviations, pose_deviations, each_rms);
  // fx, fy, cx, cy come first.
  lens.fit.focal_sd_px = std::max(deviations.at<double>(0), deviations.at<double>(1));
  lens.fit.principal_point_sd_px = std::max(deviations.at<double>(2), deviations.at<double>(3));
  return lens;
}

Camera to_camera(const Lens& lens) {
  Camera camera;
  cv::cv2eigen(lens.matrix, camera.matrix);
  for (int i = 0; i < static_cast<int>(lens.distortion.total()); ++i) {
    camera.distortion.push_back(lens.distortion.at<double>(i));
  }
  return camera;
}

// The points that both views hold, in one order.
std::pair<BoardView, BoardView> in_both(const BoardView& left, const BoardView& right) {
  std::map<int, Eigen::Vector2d> known;
  for (std::size_t i = 0; i < right.points.size(); ++i) known.emplace(right.points[i], right.pixels[i]);
  std::pair<BoardView, BoardView> both;
  for (std::size_t i = 0; i < left.points.size(); ++i) {
    const auto found = known.find(left.points[i]);
    if (found == known.end()) continue;
    both.first.points.push_back(left.points[i]);
    both.first.pixels.push_back(left.pixels[i]);
    both.second.points.push_back(left.points[i]);
    both.second.pixels.push_back(found->second);
  }
  return both;
}

}  // namespace
}  // namespace glisson::vision
