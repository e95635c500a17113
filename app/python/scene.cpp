// Pictures with no window, as arrays.

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "arrays.h"
#include "long_call.h"
#include "rooms.h"
#include "scene/case_scenes.h"

namespace py = pybind11;

namespace glisson::python {
namespace {

using namespace scene;

// uint8, height x width x 3, in the memory that it was drawn in.
py::array array_of(Picture picture) {
  const py::ssize_t height = picture.height, width = picture.width;
  return handed_over(std::move(picture.rgb)).reshape({height, width, py::ssize_t(3)});
}

ColourMap map_of(const std::string& name) {
  constexpr std::pair<const char*, ColourMap> maps[] = {{"viridis", ColourMap::viridis},
                                                        {"cividis", ColourMap::cividis},
                                                        {"magma", ColourMap::magma},
                                                        {"plasma", ColourMap::plasma},
                                                        {"grey", ColourMap::grey}};
  for (const auto& [called, map] : maps)
    if (name == called) return map;
  raise("colour-map-unknown", "There is no colour map \"{0}\".", {name},
        "There are viridis, cividis, magma, plasma and grey.");
}

py::array surface_picture(const std::shared_ptr<geometry::Surface>& surface, const std::optional<std::string>& field,
                          const std::array<double, 2>& range, const std::string& title, const std::string& map,
                          const std::array<double, 3>& color_rgb, int width, int height) {
  Scene shown;
  SurfaceItem item;
  item.name = "surface";
  item.surface = surface;
  item.colour = {color_rgb[0], color_rgb[1], color_rgb[2]};
  if (field) item.colouring = Colouring{*field, map_of(map), range, title};
  shown.surfaces.push_back(std::move(item));
  return array_of(short_call([&] { return draw(shown, width, height); }));
}

}  // namespace

void add_scene(py::module_& module) {
  module.def(
      "draw_case",
      [](const casefile::Case& patient, const std::string& name, int width, int height) {
        return array_of(short_call([&] {
          return case_scene(patient, name).and_then([&](const Scene& shown) { return draw(shown, width, height); });
        }));
      },
      py::arg("case"), py::arg("scene"), py::kw_only(), py::arg("width") = 1600, py::arg("height") = 1000,
      R"(A scene of a Case, drawn with no window: uint8, shape (height, width, 3), rows from the top.

scene  "anatomy", "liver", "stiffness", "model"; "waves" and "confidence" where waves were inverted; "resection"

Raises glisson.Error: scene-unknown, case-lacks-entry, picture-size, drawing-unavailable.)");
  module.def(
      "draw_result",
      [](const std::filesystem::path& folder, int width, int height) {
        return array_of(short_call([&] {
          return result_scene(folder).and_then([&](const Scene& shown) { return draw(shown, width, height); });
        }));
      },
      py::arg("folder"), py::kw_only(), py::arg("width") = 1600, py::arg("height") = 1000,
      "The moved liver of a result's folder, coloured by displacement: uint8, shape (height, width, 3), as "
      "draw_case.\n\n"
      "Raises glisson.Error: picture-size, drawing-unavailable, and what is wrong with the folder.");
  module.def(
      "draw_surface", &surface_picture, py::arg("surface"), py::kw_only(), py::arg("field") = py::none(),
      py::arg("range") = std::array<double, 2>{0, 1}, py::arg("title") = "", py::arg("colour_map") = "viridis",
      py::arg("color_rgb") = std::array<double, 3>{0.8, 0.45, 0.4}, py::arg("width") = 800, py::arg("height") = 600,
      R"(A Surface from the surgeon's side, drawn with no window: uint8, shape (height, width, 3), rows from the top.

field  a point or cell field to colour it by, over `range`, with `title` (and the unit) for the legend

Raises glisson.Error: scene-invalid, picture-size, drawing-unavailable, colour-map-unknown.)");
}

}  // namespace glisson::python
