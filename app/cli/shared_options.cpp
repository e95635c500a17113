#include "shared_options.h"

#include "base/text.h"

namespace glisson::cli {
Result<Eigen::Vector3d> parse_position(const std::string& text, const std::string& option) {
  Eigen::Vector3d position;
  std::string_view rest = text;
  for (int axis = 0; axis < 3; ++axis) {
    const std::size_t comma = axis < 2 ? rest.find(',') : rest.size();
    const auto number = comma == std::string_view::npos ? std::nullopt : read_number(rest.substr(0, comma));
    if (!number) {
      return failure("position-invalid", GLISSON_TEXT("{0} wants a position X,Y,Z in mm, not \"{1}\"."),
                     {option, text});
    }
    position[axis] = *number;
    if (axis < 2) rest.remove_prefix(comma + 1);
  }
  return position;
}

Result<PictureSize> parse_size(const std::string& text) {
  constexpr double largest = 16384;  // what OpenGL implementations draw at once
  const std::size_t cross = text.find('x');
  double width = 0, height = 0;
  if (cross != std::string::npos) {
    width = read_number(std::string_view(text).substr(0, cross)).value_or(0);
    height = read_number(std::string_view(text).substr(cross + 1)).value_or(0);
  }
  if (width < 16 || height < 16 || width > largest || height > largest) {
    return failure("size-invalid", GLISSON_TEXT("--size wants WxH in pixels, 16 to 16384 each, not \"{0}\"."), {text});
  }
  return PictureSize{static_cast<int>(width), static_cast<int>(height)};
}

Json direction_json(const Eigen::Matrix3d& direction) {
  Json json = Json::array();
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) json.push_back(direction(row, column));
  }
  return json;
}

void add_border_option(CLI::App& command, std::vector<std::string>& borders) {
  command
      .add_option("--border", borders,
                  "BORDER=X,Y,Z in mm (LPS): through this place runs the border of two segments; " +
                      vasculature::names_of_borders())
      ->allow_extra_args(false);
}

Result<vasculature::BorderPlaces> parse_borders(const std::vector<std::string>& texts) {
  vasculature::BorderPlaces borders;
  for (const std::string& text : texts) {
    const auto place = vasculature::border_of_text(text);
    if (!place) {
      return failure("border-invalid", GLISSON_TEXT("--border wants BORDER=X,Y,Z with one of {0}, not \"{1}\"."),
                     {vasculature::names_of_borders(), text});
    }
    borders.push_back(*place);
  }
  return borders;
}

void add_opencl(CLI::App& command, std::optional<std::string>& device) {
  command
      .add_option_function<std::string>(
          "--opencl", [&device](const std::string& name) { device = name; },
          "On an OpenCL device, the first or one with NAME in its name, in place of the processors")
      ->expected(0, 1)
      ->option_text("[NAME]");
}

std::string bullet_list(const std::vector<std::string>& sentences) {
  std::string list;
  for (const std::string& sentence : sentences) list += "  - " + sentence + "\n";
  return list;
}

}  // namespace glisson::cli
