#include "imaging/dicom_uid.h"

#include <algorithm>

#include "base/files.h"

namespace glisson::imaging {

std::string uid_from_name(std::string_view name) {
  // The first 32 hexadecimal digits as a UUID of version 8 (made by its own rule, RFC 9562), then to decimal by hand:
  // no integer type holds it.
  std::string digits = sha256_of_text(name).substr(0, 32);
  digits[12] = '8';
  digits[16] = '8';
  std::string decimal = "0";  // least significant digit first
  for (const char digit : digits) {
    int carry = digit <= '9' ? digit - '0' : digit - 'a' + 10;
    for (char& place : decimal) {
      const int value = (place - '0') * 16 + carry;
      place = static_cast<char>('0' + value % 10);
      carry = value / 10;
    }
    for (; carry > 0; carry /= 10) decimal += static_cast<char>('0' + carry % 10);
  }
  std::reverse(decimal.begin(), decimal.end());
  return "2.25." + decimal;
}

}  // namespace glisson::imaging
