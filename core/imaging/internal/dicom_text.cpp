#include "imaging/internal/dicom_text.h"

#include <fmt/format.h>

namespace glisson::imaging {

std::string decimal_string(double number) {
  constexpr std::size_t longest = 16;  // DICOM PS3.5 6.2
  if (number == 0) return "0";         // never "-0"
  std::string text = fmt::format("{}", number);
  for (int digits = 16; text.size() > longest; --digits) text = fmt::format("{:.{}g}", number, digits);
  return text;
}

std::string decimal_strings(std::initializer_list<double> numbers) {
  std::string text;
  for (const double number : numbers) text += (text.empty() ? "" : "\\") + decimal_string(number);
  return text;
}

}  // namespace glisson::imaging
