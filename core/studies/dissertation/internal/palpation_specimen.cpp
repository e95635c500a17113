#include "studies/dissertation/internal/palpation_specimen.h"

namespace glisson::studies {

const std::vector<PalpationSpecimen>& palpation_specimens() {
  constexpr double ball_mm = 9;
  static const std::vector<PalpationSpecimen> specimens{
      {"A", machine_soft_kPa, machine_soft_kPa},
      {"B", machine_stiff_kPa, machine_stiff_kPa},
      {"AB", machine_soft_kPa, machine_stiff_kPa},
      {"A+b", machine_soft_kPa, machine_soft_kPa, machine_stiff_kPa, ball_mm},
      {"B+a", machine_stiff_kPa, machine_stiff_kPa, machine_soft_kPa, ball_mm},
  };
  return specimens;
}

}  // namespace glisson::studies
