// Waves to stiffness, and stiffness to cells.

#include <pybind11/eigen.h>
#include <pybind11/stl.h>

#include "elastography/cell_stiffness.h"
#include "elastography/inversion.h"
#include "geometry/tetrahedra.h"
#include "image_grid.h"
#include "long_call.h"
#include "rooms.h"

namespace py = pybind11;
using namespace py::literals;

namespace glisson::python {
namespace {

using namespace elastography;
using imaging::Mask;
using imaging::Volume;

py::dict stiffness_of(const geometry::TetMesh& mesh, const Volume& shear_kPa, const Mask* confident, const Mask* organ,
                      double poisson_ratio, double unreliable_border_mm) {
  Reliability reliability;
  if (confident != nullptr) reliability.confident = *confident;
  if (organ != nullptr) reliability.organ = *organ;
  StiffnessOptions options;
  options.poisson_ratio = poisson_ratio;
  options.unreliable_border_mm = unreliable_border_mm;
  CellStiffness found = short_call([&] {
    std::vector<Eigen::Vector3d> centroids;
    for (std::size_t c = 0; c < mesh.cells.size(); ++c) centroids.push_back(geometry::cell_centroid_mm(mesh, c));
    return cell_stiffness(centroids, shear_kPa, reliability, options);
  });
  std::vector<std::uint8_t> measured;
  for (const StiffnessSource source : found.source) measured.push_back(source == StiffnessSource::measured);
  return py::dict("youngs_kPa"_a = handed_over(std::move(found.youngs_kPa)),
                  "measured"_a = handed_over(std::move(measured)).attr("astype")(py::dtype::of<bool>()),
                  "mean_kPa"_a = found.mean_kPa, "sd_kPa"_a = found.sd_kPa, "min_kPa"_a = found.min_kPa,
                  "max_kPa"_a = found.max_kPa, "cells_without_data"_a = found.cells_without_data,
                  "filled_fraction"_a = found.filled_fraction);
}

// phase_rad is (directions, instants, i, j, k).
WaveImages wave_images(const py::array_t<float>& phase_rad, double frequency_Hz, const Eigen::Vector3d& spacing_mm,
                       const Eigen::Vector3d& origin_mm, const Eigen::Matrix3d& direction, const Numbers& along) {
  if (phase_rad.ndim() != 5) {
    raise("array-shape", "phase_rad must be an array of directions x instants x i x j x k; it has {0}.",
          {shape_in_words(phase_rad)});
  }
  WaveImages images;
  images.frequency_Hz = frequency_Hz;
  images.grid =
      grid_from({phase_rad.shape(2), phase_rad.shape(3), phase_rad.shape(4)}, spacing_mm, origin_mm, direction);
  if (along.size() > 0) images.along = points_from(along, "along");
  if (!images.along.empty() && images.along.size() != std::size_t(phase_rad.shape(0))) {
    raise("array-shape", "along must have as many rows as there are directions, {0}; it has {1}.",
          {std::to_string(phase_rad.shape(0)), shape_in_words(along)});
  }
  for (py::ssize_t d = 0; d < phase_rad.shape(0); ++d) {
    auto& instants = images.phase_rad.emplace_back();
    for (py::ssize_t t = 0; t < phase_rad.shape(1); ++t) {
      const py::array one = phase_rad[py::make_tuple(d, t)];
      const auto ordered = py::array_t<float, py::array::f_style | py::array::forcecast>::ensure(one);
      instants.emplace_back(ordered.data(), ordered.data() + ordered.size());
    }
  }
  return images;
}

py::dict inverted(const py::array_t<float>& phase_rad, double frequency_Hz, const Eigen::Vector3d& spacing_mm,
                  const Eigen::Vector3d& origin_mm, const Eigen::Matrix3d& direction, const Numbers& along,
                  const Mask* organ, const std::string& method, const py::object& progress) {
  if (method != "direct" && method != "lfe") {
    raise("method-unknown", "Waves are not inverted by \"{0}\".", {method}, "The methods are \"direct\" and \"lfe\".");
  }
  if (phase_rad.ndim() == 5 && phase_rad.shape(1) < 4) {
    raise("waves-too-few-offsets", "There are {0} instants in a period; four are needed to tell noise from waves.",
          {std::to_string(phase_rad.shape(1))});
  }
  if (!(frequency_Hz > 0)) raise("waves-no-frequency", "The frequency (Hz) must be above 0.");
  const WaveImages images = wave_images(phase_rad, frequency_Hz, spacing_mm, origin_mm, direction, along);
  InversionOptions options;
  if (method == "lfe") options.method = InversionMethod::local_frequency;
  const auto within = organ == nullptr ? std::optional<Mask>() : *organ;
  ModulusMap map = long_call(progress, [&](const Progress& told) { return invert({images}, within, options, told); });
  py::dict dict;
  dict["magnitude_kPa"] = std::make_shared<Volume>(std::move(map.magnitude_kPa));
  if (map.storage_kPa) dict["storage_kPa"] = std::make_shared<Volume>(*std::move(map.storage_kPa));
  if (map.loss_kPa) dict["loss_kPa"] = std::make_shared<Volume>(*std::move(map.loss_kPa));
  dict["confidence"] = std::make_shared<Volume>(std::move(map.confidence));
  dict["region"] = std::make_shared<Mask>(std::move(map.region));
  dict["mean_kPa"] = map.mean_kPa;
  dict["confident_fraction"] = map.confident_fraction;
  dict["notes"] = messages(map.notes);
  return dict;
}

}  // namespace

void add_elastography(py::module_& module) {
  module.def(
      "cell_stiffness", &stiffness_of, py::arg("mesh"), py::arg("shear_kPa"), py::kw_only(),
      py::arg("confident") = nullptr, py::arg("organ") = nullptr, py::arg("poisson_ratio") = usual_poisson_ratio,
      py::arg("unreliable_border_mm") = StiffnessOptions{}.unreliable_border_mm,
      R"(Young's modulus of each cell of a TetMesh from a map of the shear modulus (a Volume, kPa), E = 2 G (1 + nu).

Each cell takes the voxel nearest to its centroid; cells without a reliable voxel are filled from around. Not reliable
is what is not positive, not in the mask `confident`, outside of the mask `organ` or within unreliable_border_mm of its
border.
A dict: youngs_kPa (float64, (cells,)), measured (bool, (cells,)), mean_kPa, sd_kPa, min_kPa, max_kPa,
cells_without_data, filled_fraction.

Raises glisson.Error: stiffness-no-cells, stiffness-empty-map, stiffness-bad-grid, stiffness-bad-options,
stiffness-no-overlap, stiffness-nothing-reliable.)");
  module.def("invert", &inverted, py::arg("phase_rad"), py::kw_only(), py::arg("frequency_Hz"),
             py::arg_v("spacing_mm", Eigen::Vector3d(1, 1, 1), "(1, 1, 1)"),
             py::arg_v("origin_mm", Eigen::Vector3d(0, 0, 0), "(0, 0, 0)"),
             py::arg_v("direction", Eigen::Matrix3d(Eigen::Matrix3d::Identity()), "((1, 0, 0), (0, 1, 0), (0, 0, 1))"),
             py::arg_v("along", py::array_t<double>(std::vector<py::ssize_t>{0, 3}), "()"), py::arg("organ") = nullptr,
             py::arg("method") = "direct", py::arg("progress") = py::none(),
             R"(The shear modulus from phase images of one vibration.

phase_rad     float32, shape (directions, instants, i, j, k): wrapped phase, instants evenly spread over one period
frequency_Hz  of the vibration
along         (directions, 3): unit vectors of the directions in LPS, or empty where they are not known
organ         a Mask: only its voxels are inverted
method        "direct" (the complex modulus) or "lfe" (local frequency estimation)

A dict: magnitude_kPa, storage_kPa, loss_kPa, confidence (0 to 1): Volumes; region: the Mask of what could be inverted;
mean_kPa, confident_fraction, notes.

Raises glisson.Error: array-shape, waves-none, waves-no-frequency, waves-too-few-offsets, waves-empty-organ,
waves-nothing-confident.)");
}

}  // namespace glisson::python
