#pragma once
// A cut drawn freehand over the liver: places under the hand become a line, and the line's advances.
//
// A stroke goes in one way, wherever it leads: straight away from the eye where it begins, as a knife is held, and as a
// line drawn in Resect parts the liver. At rest that way and the places are the tissue's, whatever tools do to it
// meanwhile. Places are kept some way apart, so that a hand's trembling turns nothing. The front follows the hand at a
// short distance, so that cells about to open are led by where the hand went, not by where it seemed to go.
//
// Patient LPS, mm, at rest.

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "base/result.h"
#include "mechanics/cutting/cut_strip.h"

namespace glisson::rehearsal {

class Stroke {
 public:
  static constexpr double apart_mm = 2.5;  // places of the line, across the way in
  static constexpr double shortest_advance_mm = 2.5;
  static constexpr double longest_advance_mm = 8;
  static constexpr double behind_mm = 5;  // the front behind the hand, while it draws

  // From a place of the surface; `into_mm` is as long as the cut is deep, and not zero.
  Stroke(const Eigen::Vector3d& begin_mm, const Eigen::Vector3d& into_mm);

  // The line of the last advance, drawn further in the way that it went.
  [[nodiscard]] static Stroke going_on(const mechanics::CutStrip& last);

  // The hand went on. Nearer than `apart_mm` it changes nothing. Fails with "stroke-turns" (by more than 60 degrees) or
  // "stroke-leaves" (the surface drops away along the way in, as at the liver's rim); the line stays as it was.
  Result<void> draw_to(const Eigen::Vector3d& place_mm);

  // The next advance, if the hand is far enough ahead. Once the stroke has ended, to its end.
  enum class Hand { draws, lifted };
  [[nodiscard]] std::optional<mechanics::CutStrip> next_advance(Hand hand);

  [[nodiscard]] double length_mm() const { return along_mm_.back(); }  // across the way in
  [[nodiscard]] double cut_mm() const { return cut_mm_; }              // of it, by the advances that were taken
  [[nodiscard]] const std::vector<Eigen::Vector3d>& line_mm() const { return line_mm_; }

 private:
  [[nodiscard]] Eigen::Vector3d across(const Eigen::Vector3d& way_mm) const;
  [[nodiscard]] Eigen::Vector3d at(double along_mm) const;

  Eigen::Vector3d into_mm_;
  std::vector<Eigen::Vector3d> line_mm_;
  std::vector<double> along_mm_;
  double cut_mm_ = 0;
};

}  // namespace glisson::rehearsal
