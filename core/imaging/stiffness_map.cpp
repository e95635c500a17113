// Pa or kPa? The header's word and the size of the values must agree.

#include "imaging/stiffness_map.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/units.h"

namespace glisson::imaging {
namespace {

constexpr double softest_kPa = 0.2;
constexpr double stiffest_kPa = 100;

bool plausible(double shear_kPa) { return shear_kPa >= softest_kPa && shear_kPa <= stiffest_kPa; }

// Of the finite positive values: in maps of the whole field of view everything outside the wave's reach is 0.
double median_of_positive(const std::vector<float>& values) {
  std::vector<float> positive;
  std::copy_if(values.begin(), values.end(), std::back_inserter(positive),
               [](float value) { return std::isfinite(value) && value > 0; });
  if (positive.empty()) return 0;
  const auto middle = positive.begin() + static_cast<std::ptrdiff_t>(positive.size() / 2);
  std::nth_element(positive.begin(), middle, positive.end());
  return *middle;
}

}  // namespace

Result<StiffnessMap> stiffness_in_kPa(Volume stored, const std::string& unit_evidence) {
  const std::string unit = stored.unit;
  if (!unit.empty() && unit != "Pa" && unit != "kPa") {
    return failure("stiffness-unit-foreign", GLISSON_TEXT("The map is in {0}, which is no unit of stiffness."), {unit});
  }
  const double median = median_of_positive(stored.values);
  if (median <= 0) return failure("stiffness-empty", GLISSON_TEXT("The stiffness map holds no value above zero."));

  const bool plausible_in_kPa = plausible(median);
  const bool plausible_in_Pa = plausible(units::kPa_from_Pa(median));
  const std::string size = fmt::format("the median of its values is {:.4g}", median);
  if (!plausible_in_kPa && !plausible_in_Pa) {
    return failure(
        "stiffness-unit-unknown",
        GLISSON_TEXT("It cannot be decided whether the stiffness map is in Pa or kPa: its median, {0}, is no "
                     "stiffness of soft tissue in either."),
        {fmt::format("{:.4g}", median)});
  }
  const std::string by_size = plausible_in_kPa ? "kPa" : "Pa";
  if (!unit.empty() && unit != by_size) {
    return failure(Error{"stiffness-unit-contradicted",
                         GLISSON_TEXT("The stiffness map is marked as {0}, but its median, {1}, is a stiffness of soft "
                                      "tissue only in {2}."),
                         {unit, fmt::format("{:.4g}", median), by_size},
                         GLISSON_TEXT("Correct the unit in the file after asking where it came from."),
                         {}});
  }
  StiffnessMap map;
  const std::string field = unit_evidence.empty() ? "the file says " + unit : unit_evidence;
  map.evidence = unit.empty()
                     ? fmt::format("No unit is given; {}, plausible for soft tissue only in {}.", size, by_size)
                     : fmt::format("{}, and {}, plausible for soft tissue in {}.", field, size, by_size);
  map.evidence.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(map.evidence.front())));
  const auto to_kPa = static_cast<float>(by_size == "Pa" ? units::kPa_from_Pa(1) : 1);
  for (float& value : stored.values) value = std::isfinite(value) && value > 0 ? value * to_kPa : 0.0F;
  stored.unit = "kPa";
  map.shear_kPa = std::move(stored);
  return map;
}

}  // namespace glisson::imaging
