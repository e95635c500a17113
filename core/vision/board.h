#pragma once
// Flat boards that cameras are calibrated with, and finding them in a picture.

#include <array>
#include <Eigen/Core>
#include <vector>

#include "base/result.h"
#include "vision/frame.h"

namespace glisson::vision {

struct Board {
  enum class Pattern {
    chessboard,  // columns x rows are its inner corners
    circles,     // a plain grid of circles, all of which must be seen
    dots         // a grid of circles of which four are larger: parts of it are recognised by them
  };
  Pattern pattern = Pattern::chessboard;
  int columns = 9;
  int rows = 6;
  double spacing_mm = 0;  // between neighbours
  // Column and row of the larger dots, as on UCL's board of 25 x 18: left to right, then down.
  std::array<std::array<int, 2>, 4> large{{{8, 5}, {16, 5}, {8, 12}, {16, 12}}};

  [[nodiscard]] int points() const { return columns * rows; }
  // Of point i = column + columns * row, on the board (z = 0).
  [[nodiscard]] Eigen::Vector3d position_mm(int point) const {
    const int row = point / columns;
    return {spacing_mm * (point % columns), spacing_mm * row, 0};
  }
};

// What was seen of a board: some of its points, in the picture.
struct BoardView {
  std::vector<int> points;
  std::vector<Eigen::Vector2d> pixels;
};

// Refuses boards of fewer than 3 x 3 points or more than 100 x 100, and spacings that are not positive
// ("board-invalid").
Result<void> check(const Board& board);

// A grid looks the same turned by half a turn. Of the two, the one whose columns run to the right in the picture is
// taken. So the camera may be turned by less than a right angle from picture to picture, and both eyes agree. Failures:
// those of check(); "board-not-found".
Result<BoardView> find_board(const Frame& frame, const Board& board);

}  // namespace glisson::vision
