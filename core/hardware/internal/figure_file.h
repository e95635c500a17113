#pragma once
// Reading numbers with their sources out of JSON that may hold anything.

#include <filesystem>
#include <string>

#include "base/json.h"
#include "hardware/figure.h"

namespace glisson::hardware {

struct Limits {
  double minimum;
  double maximum;
};

class FigureReader {
 public:
  // Refuses a document that is not of this format.
  static Result<FigureReader> open(const Json& document, const std::string& format, const std::filesystem::path& file);

  // `where` is how the object is called in the error: "Device tx2-gpu".
  [[nodiscard]] Result<double> number(const Json& object, const char* key, Limits limits,
                                      const std::string& where) const;
  [[nodiscard]] Result<std::string> text(const Json& object, const char* key, const std::string& where) const;
  [[nodiscard]] Result<Source> source(const Json& object, const std::string& where) const;
  [[nodiscard]] Result<Figure> figure(const Json& object, const char* key, Limits limits,
                                      const std::string& where) const;

  [[nodiscard]] Failure missing(const char* key, const std::string& where) const;
  [[nodiscard]] const std::filesystem::path& file() const { return file_; }

 private:
  explicit FigureReader(std::filesystem::path file) : file_(std::move(file)) {}
  std::filesystem::path file_;
};

}  // namespace glisson::hardware
