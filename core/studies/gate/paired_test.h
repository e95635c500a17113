#pragma once
// Whether paired figures moved, with no assumption on their distribution but that differences are symmetric where
// nothing moved: Wilcoxon's signed-rank test, exact with ties and zeros (Pratt, Journal of the American Statistical
// Association 54, 1959). With it go the estimate and the interval that belong to it (Hodges and Lehmann, Annals of
// Mathematical Statistics 34, 1963).

#include <array>
#include <vector>

namespace glisson::studies {

struct PairedChange {
  int pairs = 0;
  double change = 0;                     // the median of the means of any two differences
  std::array<double, 2> interval{0, 0};  // of 95 %, or as much of it as so few pairs allow
  double p_greater = 1;                  // of so much or more where nothing moved
  double p_less = 1;
};

// Of finite differences, new - base. With more than 200 of them by the normal approximation; the estimate then comes of
// 200 that are evenly spread over their order.
PairedChange paired_change(std::vector<double> differences);

// 0 of none.
double median(std::vector<double> values);

// The smallest p that so many pairs can give.
double smallest_p(int pairs);

// Holm's correction of p-values that are looked at together (Scandinavian Journal of Statistics 6, 1979). Each may be
// compared with the rate of false alarms that all of them together may have.
std::vector<double> holm_corrected(const std::vector<double>& p);

}  // namespace glisson::studies
