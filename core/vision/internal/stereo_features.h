#pragma once
// Features that both eyes show: found in each picture, paired, and placed in space.

#include <Eigen/Core>
#include <vector>

#include "vision/calibration.h"
#include "vision/frame.h"

namespace glisson::vision {

// Rows are unit vectors (RootSIFT; Arandjelovic and Zisserman 2012), so that a product of rows is a likeness.
using Descriptors = Eigen::Matrix<float, Eigen::Dynamic, 128, Eigen::RowMajor>;

struct Features {
  std::vector<Eigen::Vector2d> pixels;  // in the picture as it came
  Descriptors descriptors;
};

// SIFT (Lowe 2004), the strongest `most` of them.
Features find_features(const Frame& frame, int maximum);

// Pairs (row of a, row of b) of which each is the other's best, clearly better than the second best. The ratio of their
// distances is below `ratio` (Lowe 2004). `may_pair`, where given, says which pairs are possible at all.
struct RowPair {
  int a = 0, b = 0;
};
template <typename MayPair>
std::vector<RowPair> mutual_pairs(const Descriptors& a, const Descriptors& b, double ratio, const MayPair& may_pair);

// A feature pair in space.
struct Sighting {
  Eigen::Vector3d position_mm{0, 0, 0};  // left camera; behind it where the pair contradicts the calibration
  double epipolar_px = 0;                // how far the two are from one another's epipolar lines (Sampson)
};

// Takes lens distortion off and triangulates: the middle of the two rays' shortest link.
class Triangulator {
 public:
  explicit Triangulator(const StereoCalibration& calibration);
  [[nodiscard]] std::vector<Sighting> operator()(const std::vector<Eigen::Vector2d>& left_px,
                                                 const std::vector<Eigen::Vector2d>& right_px) const;

 private:
  StereoCalibration calibration_;
  Eigen::Matrix3d essential_;
};

template <typename MayPair>
std::vector<RowPair> mutual_pairs(const Descriptors& a, const Descriptors& b, double ratio, const MayPair& may_pair) {
  std::vector<RowPair> pairs;
  if (a.rows() == 0 || b.rows() == 0) return pairs;
  const Eigen::MatrixXf likeness = a * b.transpose();
  std::vector<int> best_of_b(static_cast<std::size_t>(b.rows()), -1);
  std::vector<float> best_likeness(best_of_b.size(), -2);
  std::vector<int> best_of_a(static_cast<std::size_t>(a.rows()), -1);
  for (Eigen::Index i = 0; i < a.rows(); ++i) {
    float first = -2, second = -2;
    int best = -1;
    for (Eigen::Index j = 0; j < b.rows(); ++j) {
      const float like = likeness(i, j);
      if (like <= second && like <= best_likeness[static_cast<std::size_t>(j)]) continue;
      if (!may_pair(static_cast<int>(i), static_cast<int>(j))) continue;
      if (like > first) {
        second = first;
        first = like;
        best = static_cast<int>(j);
      } else if (like > second) {
        second = like;
      }
      if (like > best_likeness[static_cast<std::size_t>(j)]) {
        best_likeness[static_cast<std::size_t>(j)] = like;
        best_of_b[static_cast<std::size_t>(j)] = static_cast<int>(i);
      }
    }
    const auto squared_distance = [](float like) { return 2 - 2 * static_cast<double>(like); };
    constexpr double same = 0.5;  // of unit vectors: farther ones are not alike, with a rival or without
    if (best >= 0 && squared_distance(first) < same &&
        squared_distance(first) < ratio * ratio * squared_distance(std::max(second, 0.0F))) {
      best_of_a[static_cast<std::size_t>(i)] = best;
    }
  }
  for (std::size_t i = 0; i < best_of_a.size(); ++i) {
    const int j = best_of_a[i];
    if (j >= 0 && best_of_b[static_cast<std::size_t>(j)] == static_cast<int>(i)) {
      pairs.push_back({static_cast<int>(i), j});
    }
  }
  return pairs;
}

}  // namespace glisson::vision
