#pragma once
// Grids of dots of which four are larger, seen whole or in part.

#include <opencv2/core.hpp>

#include "vision/board.h"

namespace glisson::vision {

// Nothing where the four large dots are not found or fewer than a fifth of the grid fits them.
BoardView find_dots(const cv::Mat& grey, const Board& board);

}  // namespace glisson::vision
