#pragma once
// What several commands read from the command line or write to their answers in the same way.

#include <CLI/CLI.hpp>
#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "base/json.h"
#include "base/result.h"
#include "imaging/image.h"
#include "vasculature/borders.h"

namespace glisson::cli {

// "1.5,-2,30" as a position; `option` is named in the error.
Result<Eigen::Vector3d> parse_position(const std::string& text, const std::string& option);

// "1600x1000".
struct PictureSize {
  int width;
  int height;
};
Result<PictureSize> parse_size(const std::string& text);

Json direction_json(const Eigen::Matrix3d& direction);  // nine numbers, row after row

// --border BORDER=X,Y,Z: where a hand sets the border of two segments.
void add_border_option(CLI::App& command, std::vector<std::string>& borders);
Result<vasculature::BorderPlaces> parse_borders(const std::vector<std::string>& texts);

// --opencl [NAME]: on a GPU, where a command can use one.
void add_opencl(CLI::App& command, std::optional<std::string>& device);

// One "- sentence" a line.
std::string bullet_list(const std::vector<std::string>& sentences);

}  // namespace glisson::cli
