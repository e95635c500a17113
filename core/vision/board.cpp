#include "vision/board.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <opencv2/calib3d.hpp>
#include <opencv2/features2d.hpp>

#include "vision/internal/dots.h"
#include "vision/internal/opencv.h"

namespace glisson::vision {
namespace {

std::vector<cv::Point2f> chessboard_corners(const cv::Mat& grey, const Board& board);
std::vector<cv::Point2f> circle_grid(const cv::Mat& grey, const Board& board);
BoardView whole(const std::vector<cv::Point2f>& corners, const Board& board);

}  // namespace

Result<void> check(const Board& board) {
  constexpr int fewest = 3, maximum = 100;
  const auto fits = [](int count) { return count >= fewest && count <= maximum; };
  if (fits(board.columns) && fits(board.rows) && board.spacing_mm > 0 && std::isfinite(board.spacing_mm)) return {};
  return failure("board-invalid",
                 GLISSON_TEXT("A board has from {0} to {1} points a side and a positive spacing; {2} x {3} at {4} mm "
                              "were given."),
                 {std::to_string(fewest), std::to_string(maximum), std::to_string(board.columns),
                  std::to_string(board.rows), fmt::format("{:g}", board.spacing_mm)});
}

Result<BoardView> find_board(const Frame& frame, const Board& board) {
  if (auto good = check(board); !good) return failure(good.error());
  BoardView view;
  try {
    cv::Mat grey;
    cv::cvtColor(to_opencv(frame), grey, cv::COLOR_BGR2GRAY);
    switch (board.pattern) {
      case Board::Pattern::chessboard: view = whole(chessboard_corners(grey, board), board); break;
      case Board::Pattern::circles: view = whole(circle_grid(grey, board), board); break;
      case Board::Pattern::dots: view = find_dots(grey, board); break;
    }
  } catch (const cv::Exception&) {
    view = {};
  }
  if (!view.points.empty()) return view;
  return failure(Error{"board-not-found",
                       GLISSON_TEXT("The picture shows no board of {0} x {1} points."),
                       {std::to_string(board.columns), std::to_string(board.rows)},
                       GLISSON_TEXT("Count inner corners or circles, columns first; the board must be sharp and lit."),
                       {}});
}

namespace {

std::vector<cv::Point2f> chessboard_corners(const cv::Mat& grey, const Board& board) {
  std::vector<cv::Point2f> corners;
  const cv::Size size(board.columns, board.rows);
  if (!cv::findChessboardCorners(grey, size, corners)) return {};
  // A window that reaches less than half way to the next corner.
  double nearest_px = 1e9;
  for (std::size_t i = 1; i < corners.size(); ++i) {
    if (i % static_cast<std::size_t>(board.columns) != 0) {
      nearest_px = std::min(nearest_px, cv::norm(corners[i] - corners[i - 1]));
    }
  }
  const int half_px = std::clamp(static_cast<int>(nearest_px / 3), 2, 11);
  cv::cornerSubPix(grey, corners, {half_px, half_px}, {-1, -1},
                   {cv::TermCriteria::EPS + cv::TermCriteria::COUNT, 50, 1e-3});
  return corners;
}

std::vector<cv::Point2f> circle_grid(const cv::Mat& grey, const Board& board) {
  cv::SimpleBlobDetector::Params blobs;
  blobs.minArea = 15;
  blobs.maxArea = static_cast<float>(grey.total()) / 50;
  blobs.minDistBetweenBlobs = 5;
  std::vector<cv::Point2f> centers;
  if (!cv::findCirclesGrid(grey, {board.columns, board.rows}, centers, cv::CALIB_CB_SYMMETRIC_GRID,
                           cv::SimpleBlobDetector::create(blobs))) {
    return {};
  }
  return centers;
}

// All points, in the order in which columns run to the right.
BoardView whole(const std::vector<cv::Point2f>& corners, const Board& board) {
  BoardView view;
  if (static_cast<int>(corners.size()) != board.points()) return view;
  float to_right = 0;
  for (int row = 0; row < board.rows; ++row) {
    const auto first = static_cast<std::size_t>(row * board.columns);
    to_right += corners[first + static_cast<std::size_t>(board.columns) - 1].x - corners[first].x;
  }
  for (int point = 0; point < board.points(); ++point) {
    const cv::Point2f& corner = corners[static_cast<std::size_t>(to_right >= 0 ? point : board.points() - 1 - point)];
    view.points.push_back(point);
    view.pixels.emplace_back(corner.x, corner.y);
  }
  return view;
}

}  // namespace
}  // namespace glisson::vision
