// Structures grown from points inside them, and masks measured.

#include <pybind11/eigen.h>
#include <pybind11/stl.h>
#include <cmath>

#include "choices.h"
#include "image_grid.h"
#include "long_call.h"
#include "rooms.h"
#include "segmentation/grow.h"
#include "segmentation/grow_contrast.h"
#include "segmentation/segment_vessels.h"
#include "segmentation/structures.h"

namespace py = pybind11;

namespace glisson::python {
namespace {

using namespace segmentation;
using imaging::Mask;
using imaging::Volume;

// What was grown, its mask apart so that Python may keep it alone.
struct Grown {
  std::shared_ptr<Mask> mask;
  double volume_ml = 0;
  double brightness = 0;
  std::vector<std::string> doubts;
  bool probably_leaked = false;
};

Grown grown(GrowResult result) {
  std::vector<std::string> doubts;
  for (const auto& doubt : result.doubts) doubts.push_back(doubt.sentence.message());
  const bool leaked = result.probably_leaked();
  return {std::make_shared<Mask>(std::move(result.mask)), result.volume_ml, result.tissue_mean, doubts, leaked};
}

Grown grown(ContrastGrowth result) {
  return {std::make_shared<Mask>(std::move(result.mask)), result.volume_ml, result.brightness, messages(result.doubts),
          false};
}

Grown grown(SegmentedVessels found, const Volume& image) {
  double sum = 0, count = 0;
  for (std::size_t voxel = 0; voxel < image.values.size(); ++voxel) {
    if (found.mask.values[voxel] == 0 || !std::isfinite(image.values[voxel])) continue;
    sum += static_cast<double>(image.values[voxel]);
    ++count;
  }
  return {std::make_shared<Mask>(std::move(found.mask)), found.volume_ml, sum / count, messages(found.notes), false};
}

Grown grow_what_stands_out(const Volume& image, const Numbers& seeds_mm, const std::string& kind, const Mask* within,
                           const py::object& progress) {
  if (kind != "vessel" && kind != "lesion") {
    raise("kind-unknown", "Nothing is grown as \"{0}\".", {kind}, "The kinds are \"vessel\" and \"lesion\".");
  }
  if (within != nullptr) require_same_grid(image.grid, "The image", within->grid, "within");
  const auto seeds = points_from(seeds_mm, "seeds_mm");
  const Contrast contrast = kind == "vessel" ? Contrast::vessel : Contrast::lesion;
  return grown(long_call(
      progress, [&](const Progress& told) { return grow_contrast(image, seeds, contrast, within, {}, told); }));
}

}  // namespace

void add_segmentation(py::module_& module) {
  py::class_<Grown>(module, "Grown", "A structure grown from seeds.")
      .def_readonly("mask", &Grown::mask, "On the grid of the image.")
      .def_readonly("volume_ml", &Grown::volume_ml, "ml.")
      .def_readonly("brightness", &Grown::brightness, "Mean of the structure, in the image's unit.")
      .def_readonly("doubts", &Grown::doubts, "Why it may not be what was meant, and what to do: one sentence each.")
      .def_readonly("probably_leaked", &Grown::probably_leaked, "Into a neighbour: not to be used unseen.");
  module.def(
      "grow_from_seeds",
      [](const Volume& image, const Numbers& seeds_mm, const py::object& progress) {
        const auto seeds = points_from(seeds_mm, "seeds_mm");
        return grown(
            long_call(progress, [&](const Progress& told) { return grow_from_seeds(image, seeds, {}, told); }));
      },
      py::arg("image"), py::arg("seeds_mm"), py::kw_only(), py::arg("progress") = py::none(),
      R"(The liver from points inside it (n x 3, LPS, mm), in MR or CT.

progress(fraction, stage) is told how far it is; KeyboardInterrupt cancels.
Raises glisson.Error: grow-no-seeds, grow-bad-image, grow-seed-outside, grow-seed-on-nothing, grow-constant-image,
grow-nothing-found.)");
  module.def("grow_contrast", &grow_what_stands_out, py::arg("image"), py::arg("seeds_mm"), py::arg("kind"),
             py::kw_only(), py::arg("within") = nullptr, py::arg("progress") = py::none(),
             R"(A "vessel" or a "lesion" from points inside it (n x 3, LPS, mm): what stands out from the tissue around,
inside of the mask `within` where it is given.

Raises glisson.Error: kind-unknown, grids-differ, grow-no-seeds, grow-bad-image, grow-seed-outside,
grow-seed-on-nothing, grow-no-contrast, grow-only-thick.)");
  module.def(
      "segment_vessels",
      [](const Volume& image, const Mask& organ, const Numbers& seeds_mm, const std::optional<std::string>& brightness,
         const py::object& progress) {
        require_same_grid(image.grid, "The image", organ.grid, "organ");
        const auto seeds = points_or_none(seeds_mm, "seeds_mm");
        SegmentVesselsOptions options;
        options.brightness = brightness_chosen(brightness);
        SegmentedVessels found = long_call(
            progress, [&](const Progress& told) { return segment_vessels(image, organ, seeds, options, told); });
        return grown(std::move(found), image);
      },
      py::arg("image"), py::arg("organ"), py::arg("seeds_mm") = py::list(), py::kw_only(),
      py::arg("brightness") = py::none(), py::arg("progress") = py::none(),
      R"(The vessels of an organ by their shape, without a point; with points (n x 3, LPS, mm) those that hang on one.
brightness "bright" or "dark"; without it, what more of the tubes are.

Raises glisson.Error: choice-unknown, grids-differ, grow-bad-image, grow-seed-outside, vessels-no-organ, vessels-none,
vessels-seed-off.)");
  module.def(
      "dice", [](const Mask& a, const Mask& b) { return short_call([&] { return dice(a, b); }); }, py::arg("a"),
      py::arg("b"), "Dice's overlap of two masks: 1 the same, 0 apart.\n\nRaises glisson.Error: masks-grids-differ.");
  module.def(
      "volume_ml", [](const Mask& mask) { return volume_ml(mask); }, py::arg("mask"), "Of a mask's voxels, ml.");
}

}  // namespace glisson::python
