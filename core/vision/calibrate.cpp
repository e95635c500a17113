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

struct Calibrator::Inside {
  Board board;
  cv::Size size;  // of the first picture
  int looked_at = 0;
  Seen left, right, left_of_both, right_of_both;
  std::vector<std::string> notes;
};

Calibrator::Calibrator(std::unique_ptr<Inside> inside) : inside_(std::move(inside)) {}
Calibrator::Calibrator(Calibrator&&) noexcept = default;
Calibrator& Calibrator::operator=(Calibrator&&) noexcept = default;
Calibrator::~Calibrator() = default;

Result<Calibrator> Calibrator::begin(const Board& board) {
  if (auto good = check(board); !good) return failure(good.error());
  auto inside = std::make_unique<Inside>();
  inside->board = board;
  return Calibrator(std::move(inside));
}

Result<void> Calibrator::add(const BoardPair& pair) {
  constexpr std::size_t fewest_points = 12;
  Inside& all = *inside_;
  if (all.looked_at++ == 0) all.size = {pair.left.width, pair.left.height};
  for (const Frame* frame : {&pair.left, &pair.right}) {
    if (frame->width == all.size.width && frame->height == all.size.height) continue;
    return failure("stereo-image-sizes", GLISSON_TEXT("{0} has {1} x {2} pixels, the first picture has {3} x {4}."),
                   {pair.name, std::to_string(frame->width), std::to_string(frame->height),
                    std::to_string(all.size.width), std::to_string(all.size.height)});
  }
  const auto in_left = find_board(pair.left, all.board), in_right = find_board(pair.right, all.board);
  if (!in_left || !in_right) {
    all.notes.push_back(fmt::format("{}: the {} picture shows no board", pair.name, in_left ? "right" : "left"));
    return {};
  }
  const auto [both_left, both_right] = in_both(*in_left, *in_right);
  if (both_left.points.size() < fewest_points) {
    all.notes.push_back(fmt::format("{}: both eyes see only {} points", pair.name, both_left.points.size()));
    return {};
  }
  all.left.add(*in_left, all.board);
  all.right.add(*in_right, all.board);
  all.left_of_both.add(both_left, all.board);
  all.right_of_both.add(both_right, all.board);
  return {};
}

Result<CalibrationFit> Calibrator::fit() const {
  constexpr int fewest_views = 3;
  const Inside& all = *inside_;
  CalibrationFit fit;
  fit.notes = all.notes;
  fit.looked_at = all.looked_at;
  fit.pairs = static_cast<int>(all.left.on_board.size());
  fit.points = all.left_of_both.points();
  if (fit.pairs < fewest_views) {
    return failure(Error{"calibration-too-few-views",
                         GLISSON_TEXT("{0} of {1} pairs show the board to both eyes; {2} are needed."),
                         {std::to_string(fit.pairs), std::to_string(fit.looked_at), std::to_string(fewest_views)},
                         GLISSON_TEXT("Check the board's kind, its columns and rows; take it from several sides."),
                         {}});
  }
  try {
    Lens left_lens = fit_lens(all.left, all.size), right_lens = fit_lens(all.right, all.size);
    cv::Mat rotation, translation, essential, fundamental, each_rms;
    fit.stereo_rms_px =
        cv::stereoCalibrate(all.left_of_both.on_board, all.left_of_both.in_picture, all.right_of_both.in_picture,
                            left_lens.matrix, left_lens.distortion, right_lens.matrix, right_lens.distortion, all.size,
                            rotation, translation, essential, fundamental, each_rms, cv::CALIB_FIX_INTRINSIC);
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
    fit.calibration.width = all.size.width;
    fit.calibration.height = all.size.height;
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

Result<CalibrationFit> calibrate(const std::vector<BoardPair>& pairs, const Board& board) {
  auto calibrator = Calibrator::begin(board);
  if (!calibrator) return failure(calibrator.error());
  for (const BoardPair& pair : pairs) {
    if (auto added = calibrator->add(pair); !added) return failure(added.error());
  }
  return calibrator->fit();
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
