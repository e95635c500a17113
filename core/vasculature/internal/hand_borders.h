#pragma once
// Borders that a hand set, and how what parts the segments bends to them.
//
// A drawn border strays from the model's (segment_planes.h) by a Gaussian process. Its values at the hand's places are
// known: the border passes there, and elsewhere strays as is then most probable (Rasmussen and Williams 2006, Gaussian
// Processes for Machine Learning, chapter 2).

#include <Eigen/Cholesky>
#include <vector>

#include "vasculature/borders.h"
#include "vasculature/internal/segment_planes.h"

namespace glisson::vasculature {

// Of a drawn border from the model's that is fitted to all of that liver's segments, over the 35 livers of the tuning
// half: standard deviation, and how far along the border it reaches (docs/territories.md). In mm at scale 1.
inline constexpr double strays_mm = 6, strays_along_mm = 30;

class HandBorders {
 public:
  HandBorders() = default;
  // Other borders than the one named keep clear of its place by clear_mm.
  HandBorders(const BorderPlaces& places, double scale, double clear_mm);

  // Minus the logarithm of the probability that borders which stray from these pass there, but for a constant.
  [[nodiscard]] double energy(const SegmentPlanes& planes) const;

  // Fails with border-far: a place lies where that border runs in no liver, by these mean planes.
  [[nodiscard]] Result<void> may_pass(const SegmentPlanes& mean) const;
  // Whether these planes, bent, pass where the hand set them, to half a voxel of a grid. Fails with borders-contradict:
  // they do not, or four segments were told to meet in one place.
  [[nodiscard]] Result<void> pass(const SegmentPlanes& planes, const imaging::Grid& grid) const;

 private:
  friend class BentPlanes;
  struct Side {
    Surface surface;
    double sign;  // of the level that the place must have
  };
  struct Place {
    BorderPlace told;
    Surface passes;
    std::vector<Side> sides;
  };
  std::vector<Place> places_;
  double scale_ = 1, clear_mm_ = 0;
  std::array<std::vector<Eigen::Vector3d>, surface_count> on_mm_;
  std::array<Eigen::LLT<Eigen::MatrixXd>, surface_count> factors_;  // of the covariance between the places on each
};

// The surfaces of one answer, bent so that they pass through the hand's places.
class BentPlanes {
 public:
  BentPlanes(SegmentPlanes planes, const HandBorders& hand);
  [[nodiscard]] int at(const Eigen::Vector3d& patient_mm) const;

 private:
  struct Bend {
    std::vector<Eigen::Vector3d> places_mm;
    Eigen::VectorXd weights;
  };
  [[nodiscard]] double bent_mm(const Bend& bend, const Eigen::Vector3d& patient_mm) const;

  SegmentPlanes planes_;
  double scale_;
  std::array<Bend, surface_count> bends_;
  bool bent_ = false;
};

}  // namespace glisson::vasculature
