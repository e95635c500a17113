#include <algorithm>
#include <cmath>
#include <deque>
#include <numbers>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>
#include <optional>

#include "vision/internal/dots.h"

namespace glisson::vision {
namespace {

struct Dot {
  cv::Point2d center;
  double area_px = 0;
};

std::vector<Dot> round_dark_spots(const cv::Mat& grey);
std::vector<cv::Point2d> four_large(const std::vector<Dot>& dots);

// The grid in the picture: which dot each of its points is, -1 for none.
class Grid {
 public:
  Grid(const Board& board, const std::vector<Dot>& dots)
      : board_(board), dots_(dots), dot_of_(static_cast<std::size_t>(board.points()), -1), taken_(dots.size(), false) {}

  // Where the large dots are says roughly where the dots between them are; the rest follows from neighbours, which
  // the lens bends as it bends them.
  void lay(const std::array<cv::Point2d, 4>& large) {
    place_between(large);
    grow();
  }

  [[nodiscard]] int found() const {
    return static_cast<int>(std::count_if(dot_of_.begin(), dot_of_.end(), [](int dot) { return dot >= 0; }));
  }
  [[nodiscard]] BoardView view() const {
    BoardView view;
    for (int point = 0; point < board_.points(); ++point) {
      if (const auto at = place(point)) {
        view.points.push_back(point);
        view.pixels.emplace_back(at->x, at->y);
      }
    }
    return view;
  }
  [[nodiscard]] double run_of_columns() const {  // to the right, in pixels a column
    double sum = 0;
    for (int row = 0; row < board_.rows; ++row) {
      for (int column = 1; column < board_.columns; ++column) {
        const auto here = place(column + board_.columns * row), before = place(column - 1 + board_.columns * row);
        if (here && before) sum += here->x - before->x;
      }
    }
    return sum;
  }

 private:
  void place_between(const std::array<cv::Point2d, 4>& large) {
    std::vector<cv::Point2d> on_board, in_picture(large.begin(), large.end());
    for (const auto& [column, row] : board_.large) on_board.emplace_back(column, row);
    const cv::Mat homography =
        cv::getPerspectiveTransform(std::vector<cv::Point2f>(on_board.begin(), on_board.end()),
                                    std::vector<cv::Point2f>(in_picture.begin(), in_picture.end()));
    const auto [first, last] = std::pair(board_.large.front(), board_.large.back());
    for (int row = first[1]; row <= last[1]; ++row) {
      for (int column = first[0]; column <= last[0]; ++column) {
        const auto at = [&](double x, double y) {
          std::vector<cv::Point2d> point{{x, y}};
          cv::perspectiveTransform(point, point, homography);
          return point.front();
        };
        const cv::Point2d expected = at(column, row);
        take(column + board_.columns * row, expected,
             std::min(cv::norm(at(column + 1, row) - expected), cv::norm(at(column, row + 1) - expected)));
      }
    }
  }

  void grow() {
    std::deque<int> from;
    for (int point = 0; point < board_.points(); ++point) {
      if (place(point)) from.push_back(point);
    }
    while (!from.empty()) {
      const int point = from.front();
      from.pop_front();
      for (const auto& [right, down] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
        const auto before = neighbour(point, -right, -down), next = neighbour(point, right, down);
        if (!before || !next || !place(*before) || place(*next)) continue;
        const cv::Point2d step = *place(point) - *place(*before);
        if (take(*next, *place(point) + step, cv::norm(step))) from.push_back(*next);
      }
    }
  }

  // The free dot nearest to where the point is expected, within a third of a step.
  bool take(int point, const cv::Point2d& expected, double step_px) {
    int best = -1;
    double minimum_px = step_px / 3;
    for (std::size_t i = 0; i < dots_.size(); ++i) {
      const double off_px = cv::norm(dots_[i].center - expected);
      if (taken_[i] || off_px >= minimum_px) continue;
      minimum_px = off_px;
      best = static_cast<int>(i);
    }
    if (best < 0) return false;
    dot_of_[static_cast<std::size_t>(point)] = best;
    taken_[static_cast<std::size_t>(best)] = true;
    return true;
  }

  [[nodiscard]] std::optional<cv::Point2d> place(int point) const {
    const int dot = dot_of_[static_cast<std::size_t>(point)];
    if (dot < 0) return std::nullopt;
    return dots_[static_cast<std::size_t>(dot)].center;
  }
  [[nodiscard]] std::optional<int> neighbour(int point, int right, int down) const {
    const int column = point % board_.columns + right, row = point / board_.columns + down;
    if (column < 0 || column >= board_.columns || row < 0 || row >= board_.rows) return std::nullopt;
    return column + board_.columns * row;
  }

  const Board& board_;
  const std::vector<Dot>& dots_;
  std::vector<int> dot_of_;
  std::vector<bool> taken_;
};

}  // namespace

BoardView find_dots(const cv::Mat& grey, const Board& board) {
  const std::vector<Dot> dots = round_dark_spots(grey);
  std::vector<cv::Point2d> large = four_large(dots);
  if (large.size() != 4) return {};
  // Around their middle, and each of the four ways in which they may be the board's.
  const cv::Point2d middle = (large[0] + large[1] + large[2] + large[3]) / 4;
  std::sort(large.begin(), large.end(), [&](const cv::Point2d& a, const cv::Point2d& b) {
    return std::atan2(a.y - middle.y, a.x - middle.x) < std::atan2(b.y - middle.y, b.x - middle.x);
  });
  std::optional<Grid> best;
  for (std::size_t turn = 0; turn < 4; ++turn) {
    const auto corner = [&](std::size_t i) { return large[(turn + i) % 4]; };
    Grid grid(board, dots);
    grid.lay({corner(0), corner(1), corner(3), corner(2)});  // clockwise in the picture; the board's go row by row
    const bool better = !best || grid.found() > best->found() ||
                        (grid.found() == best->found() && grid.run_of_columns() > best->run_of_columns());
    if (better && grid.run_of_columns() > 0) best.emplace(grid);
  }
  if (!best || best->found() < board.points() / 5) return {};
  return best->view();
}

namespace {

std::vector<Dot> round_dark_spots(const cv::Mat& grey) {
  constexpr double smallest_px = 20, roundest = 0.8;
  cv::Mat smooth, background, dark;
  cv::GaussianBlur(grey, smooth, {}, std::max(0.8, grey.rows / 700.0));
  const int window_px = std::max(31, grey.rows / 8) | 1;  // wider than the largest dot
  cv::blur(smooth, background, {window_px, window_px});
  cv::Mat depth;
  cv::subtract(background, smooth, depth, {}, CV_32F);
  const double threshold = 0.12;  // of the background's brightness
  cv::Mat scaled;
  background.convertTo(scaled, CV_32F, threshold);
  dark = depth > scaled;

  std::vector<std::vector<cv::Point>> outlines;
  cv::findContours(dark, outlines, cv::RETR_EXTERNAL, cv::CHAIN_APPROX_NONE);
  std::vector<Dot> dots;
  for (const auto& outline : outlines) {
    if (outline.size() < 10) continue;
    const double area_px = cv::contourArea(outline);
    if (area_px < smallest_px || area_px > static_cast<double>(grey.total()) / 50) continue;
    const cv::Rect box = cv::boundingRect(outline);
    if (box.x <= 1 || box.y <= 1 || box.x + box.width >= grey.cols - 1 || box.y + box.height >= grey.rows - 1) continue;
    const cv::RotatedRect ellipse = cv::fitEllipse(outline);
    const double ellipse_px = std::numbers::pi / 4 * static_cast<double>(ellipse.size.area());
    if (ellipse.size.aspectRatio() > 4 || ellipse.size.aspectRatio() < 0.25) continue;
    if (area_px < roundest * ellipse_px || ellipse_px < roundest * area_px) continue;
    // The centre of darkness, which uses more of the picture than the outline does.
    cv::Mat inside = cv::Mat::zeros(box.size(), CV_32F);
    cv::drawContours(inside, std::vector<std::vector<cv::Point>>{outline}, 0, cv::Scalar(1), cv::FILLED, cv::LINE_8, {},
                     0, -box.tl());
    const cv::Mat weight = inside.mul(cv::max(depth(box), 0));
    const cv::Moments moments = cv::moments(weight);
    if (!(moments.m00 > 0)) continue;
    dots.push_back({{box.x + moments.m10 / moments.m00, box.y + moments.m01 / moments.m00}, area_px});
  }
  return dots;
}

// Larger than twice what dots around them are; nothing unless they are four.
std::vector<cv::Point2d> four_large(const std::vector<Dot>& dots) {
  std::vector<Dot> sorted = dots;
  std::sort(sorted.begin(), sorted.end(), [](const Dot& a, const Dot& b) { return a.area_px > b.area_px; });
  if (sorted.size() < 20 || sorted[3].area_px < 2 * sorted[sorted.size() / 2].area_px ||
      sorted[4].area_px > 0.7 * sorted[3].area_px) {
    return {};
  }
  return {sorted[0].center, sorted[1].center, sorted[2].center, sorted[3].center};
}

}  // namespace
}  // namespace glisson::vision
