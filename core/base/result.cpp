#include "base/result.h"

#include <cstdio>
#include <cstdlib>

namespace glisson {

std::string Error::message() const { return fill_in(text, arguments); }

std::string Error::advice() const { return fill_in(hint, arguments); }

Failure failure(std::string code, std::string text, std::vector<std::string> arguments) {
  return Failure(Error{std::move(code), std::move(text), std::move(arguments), {}, {}});
}

Failure failure(Error error) { return Failure(std::move(error)); }

Failure cancelled() { return failure("cancelled", GLISSON_TEXT("Cancelled.")); }

std::string fill_in(const std::string& sentence, const std::vector<std::string>& arguments) {
  std::string filled;
  for (std::size_t i = 0; i < sentence.size(); ++i) {
    const bool placeholder = sentence[i] == '{' && i + 2 < sentence.size() && sentence[i + 2] == '}' &&
                             sentence[i + 1] >= '0' && sentence[i + 1] <= '9';
    const auto argument = placeholder ? static_cast<std::size_t>(sentence[i + 1] - '0') : arguments.size();
    if (argument < arguments.size()) {
      filled += arguments[argument];
      i += 2;
    } else {
      filled += sentence[i];
    }
  }
  return filled;
}

void assertion_failed(const char* condition, const char* file, int line) {
  std::fprintf(stderr, "%s:%d: a defect in Glisson: %s does not hold\n", file, line, condition);
  std::abort();
}

}  // namespace glisson
