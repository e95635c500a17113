#pragma once
// What was done in a rehearsal, moment by moment, with the figures that a plot shows of it.

#include <memory>
#include <optional>
#include <QString>
#include <vector>

#include "widgets/session/rigid_tools.h"

namespace glisson::widgets {

struct Moment {
  double time_s = 0;  // since the first; rests longer than RehearsalTrack::longest_rest_s are cut short
  std::vector<PlacedTool> tools;
  double force_N = 0;  // the length of the sum of all tools' forces
  double max_displacement_mm = 0;
  std::optional<double> reference_off_mm =
      {};                             // the largest over the liver's surface, where there is an atlas to compare with
  std::vector<double> landmarks_mm;   // how far each one moves
  mechanics::Validity validity = {};  // what these figures are worth
  // With rigid tools and at large deformations the shape depends on the way to it and is kept. Else it is answered
  // anew, to the same bit.
  std::shared_ptr<const rehearsal::SessionState> contact;
};

class RehearsalTrack {
 public:
  static constexpr double longest_rest_s = 1.0;
  static constexpr std::size_t maximum_contacts = 400;  // shapes kept, about 1 MB each; the oldest moments go first

  void clear();
  // `clock_s` runs from anywhere and never back.
  void add(Moment moment, double clock_s);
  // The last one is replaced, at its time; there must be one.
  void replace_last(Moment moment);

  [[nodiscard]] const std::vector<Moment>& moments() const { return moments_; }
  [[nodiscard]] bool empty() const { return moments_.empty(); }
  [[nodiscard]] double length_s() const { return moments_.empty() ? 0 : moments_.back().time_s; }
  // The last one at or before that time; there must be one.
  [[nodiscard]] std::size_t at(double time_s) const;

  // One line a moment: time, tools with places and forces, figures, landmarks, and what they are worth. At large
  // deformations the bound of its error stands there. An answer that is not usable has no figures.
  [[nodiscard]] std::string csv(const std::vector<std::string>& landmark_ids) const;

 private:
  std::vector<Moment> moments_;
  double last_clock_s_ = 0;
};

[[nodiscard]] Moment moment_of(std::vector<PlacedTool> tools, const rehearsal::RehearsalState& state);

}  // namespace glisson::widgets
