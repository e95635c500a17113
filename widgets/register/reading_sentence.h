#pragma once
// What a person should conclude of one or two judged registrations, in a sentence or two.

#include <array>
#include <QString>

#include "widgets/register/judged_sequence.h"

namespace glisson::widgets {

struct NamedJudgement {
  QString name;                    // "ICP"
  const Judged* judged = nullptr;  // null: nothing there
};

// Which one is better, and where in the picture of `frame` not to trust it. "ICP follows the tissue better here. Do not
// trust its left edge: landmarks are off by 5 mm or more there." Better is who has the higher mean correlation and no
// larger share of rejected triangles. Neither is where the two disagree, or differ by less than 0.02 and one in twenty.
// The place is where the rejected triangles' middle lies against that of all, by the camera. Empty without a judgement.
[[nodiscard]] QString reading_of(const std::array<NamedJudgement, 2>& sides, double tolerance_mm, std::size_t frame,
                                 const std::optional<vision::Camera>& camera);

}  // namespace glisson::widgets
