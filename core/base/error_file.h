#pragma once
// The file that an error is about, for whoever shows its sentence.

#include <string>
#include <string_view>

#include "base/result.h"

namespace glisson {

// " (FOLDER/FILE)", to be put behind the sentence, in whatever language it is. Empty where the sentence already names
// the file, or the error is about none.
[[nodiscard]] inline std::string file_behind(std::string_view sentence, const Error& error) {
  const bool is_named = sentence.find(error.file.filename().string()) != std::string_view::npos;
  return is_named ? std::string() : " (" + error.file.string() + ")";
}

}  // namespace glisson
