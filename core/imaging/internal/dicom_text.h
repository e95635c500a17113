#pragma once
// Numbers as DICOM writes them.

#include <initializer_list>
#include <string>

namespace glisson::imaging {

// The shortest decimal that comes nearest to the number in the 16 characters that a DS value may have.
[[nodiscard]] std::string decimal_string(double number);

// Several of them, joined by backslashes.
[[nodiscard]] std::string decimal_strings(std::initializer_list<double> numbers);

}  // namespace glisson::imaging
