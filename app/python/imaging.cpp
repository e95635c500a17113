// Images as numpy arrays, their files, and DICOM.

#include <pybind11/eigen.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>
#include <cstring>

#include "image_grid.h"
#include "imaging/dicom_seg.h"
#include "imaging/read_series.h"
#include "imaging/study.h"
#include "imaging/volume_file.h"
#include "long_call.h"
#include "rooms.h"

namespace py = pybind11;

namespace glisson::python {
namespace {

using namespace imaging;

// What numbers each kind of image can be made of.
template <typename Picture>
constexpr const char* refused_code = "";
template <>
constexpr const char* refused_code<Mask> = "mask-values";
template <>
constexpr const char* refused_code<LabelMap> = "labels-values";

template <typename Picture>
using ValueOf = typename decltype(Picture::values)::value_type;

// The array's values in the core's order, i fastest: one copy.
template <typename Value>
std::vector<Value> in_core_order(const py::array& array) {
  const auto ordered = py::array_t<Value, py::array::f_style | py::array::forcecast>::ensure(array);
  if (!ordered) {
    PyErr_Clear();
    raise("array-shape", "An image must be an array of numbers.");
  }
  return {ordered.data(), ordered.data() + ordered.size()};
}

template <typename Picture>
std::vector<ValueOf<Picture>> values_from(const py::array& array) {
  if constexpr (std::is_same_v<Picture, Volume>) {
    return in_core_order<float>(array);
  } else {
    constexpr double largest = std::is_same_v<Picture, Mask> ? 1 : 65535;
    for (const double value : in_core_order<double>(array)) {
      if (value >= 0 && value <= largest && value == std::floor(value)) continue;
      raise(refused_code<Picture>, "The array holds {0}, which is no whole number from 0 to {1}.",
            {py::str(py::float_(value)), std::to_string(int(largest))});
    }
    return in_core_order<ValueOf<Picture>>(array);
  }
}

// The image's own memory, in its own order: array[i, j, k].
template <typename Picture>
py::array array_of(const py::object& self) {
  auto& image = self.cast<Picture&>();
  using Value = ValueOf<Picture>;
  const auto [i, j, k] = image.grid.size;
  constexpr auto width = py::ssize_t(sizeof(Value));
  return py::array(py::dtype::of<Value>(), {i, j, k}, {width, width * i, width * i * j}, image.values.data(), self);
}

std::string in_words(const Grid& grid) {
  const auto& s = grid.spacing_mm;
  return py::str("{} x {} x {} voxels of {:.4g} x {:.4g} x {:.4g} mm")
      .format(grid.size[0], grid.size[1], grid.size[2], s.x(), s.y(), s.z());
}

constexpr const char* about_images = R"(
array       {0}, shape (i, j, k): the image's own memory, without a copy; writing to it changes the image, and it lives
            on when the image is gone. i runs along a row of pixels and is fastest in memory. array.T is [k, j, i], as
            SimpleITK has it.
spacing_mm  (3,): between the centres of voxels along i, j, k, mm
origin_mm   (3,): centre of voxel (0, 0, 0), patient coordinates LPS (x to the left, y to the back, z to the head), mm
direction   (3, 3): its columns are the unit vectors of the axes i, j, k in LPS

Made of an array, whose values are copied once into memory of the core; {1}.empty() makes an image to be filled in
place. numpy.asarray(image) is image.array.

Raises glisson.Error: array-shape, grid-size, grid-spacing, grid-origin, grid-direction{2}.)";

template <typename Picture>
std::string documentation(const char* first, const char* type, const char* name, const char* more_failures) {
  return std::string(first) + "\n" + std::string(py::str(py::str(about_images).format(type, name, more_failures)));
}

template <typename Picture>
py::class_<Picture, std::shared_ptr<Picture>> add_image(py::module_& module, const char* name,
                                                        const std::string& documentation) {
  py::class_<Picture, std::shared_ptr<Picture>> image(module, name, documentation.c_str());
  image
      .def_property_readonly("array", &array_of<Picture>,
                             "The values, shape (i, j, k), in the image's unit (kPa, HU, 0 or 1, ...), without a copy.")
      .def_property_readonly(
          "spacing_mm", [](const Picture& self) { return self.grid.spacing_mm; },
          "(3,): between voxels along i, j, k, mm.")
      .def_property_readonly(
          "origin_mm", [](const Picture& self) { return self.grid.origin_mm; },
          "(3,): centre of voxel (0, 0, 0), LPS, mm.")
      .def_property_readonly(
          "direction", [](const Picture& self) { return self.grid.direction; },
          "(3, 3): its columns are the unit vectors of the axes i, j, k in LPS.")
      .def_property_readonly(
          "voxel_volume_mm3", [](const Picture& self) { return self.grid.voxel_volume_mm3(); }, "mm3.")
      .def(
          "position_mm",
          [](const Picture& self, const Numbers& index) {
            return Eigen::Vector3d(self.grid.position_mm(vector_from(index, "index")));
          },
          py::arg("index"), "(3,): where a voxel index (3,), which may be fractional, lies: LPS, mm.")
      .def(
          "index_of",
          [](const Picture& self, const Numbers& position_mm) {
            return Eigen::Vector3d(self.grid.index_of(vector_from(position_mm, "position_mm")));
          },
          py::arg("position_mm"), "(3,): the voxel index [i, j, k], fractional, at a position (3,), LPS, mm.")
      .def(
          "__array__",
          [](const py::object& self, const py::object& dtype) -> py::object {
            const py::array array = array_of<Picture>(self);
            return dtype.is_none() ? py::object(array) : array.attr("astype")(dtype, py::arg("copy") = false);
          },
          py::arg("dtype") = py::none(), "The values as numpy wants them.")
      .def("__repr__", [called = std::string(name)](const Picture& self) {
        return "<glisson." + called + ", " + in_words(self.grid) + ">";
      });
  return image;
}

const Eigen::Vector3d ones(1, 1, 1), zeros(0, 0, 0);
const Eigen::Matrix3d upright = Eigen::Matrix3d::Identity();

template <typename Picture>
Picture empty(const Sizes& size, const Eigen::Vector3d& spacing_mm, const Eigen::Vector3d& origin_mm,
              const Eigen::Matrix3d& direction) {
  Picture image;
  image.grid = grid_from(size, spacing_mm, origin_mm, direction);
  image.values.resize(image.grid.voxels());
  return image;
}

template <typename Picture>
Picture from_array(const ArrayLike& like, const Eigen::Vector3d& spacing_mm, const Eigen::Vector3d& origin_mm,
                   const Eigen::Matrix3d& direction) {
  const py::array array = array_from(like, "array");
  Picture image;
  image.grid = grid_from(sizes_of(array), spacing_mm, origin_mm, direction);
  image.values = values_from<Picture>(array);
  return image;
}

void add_volume(py::module_& module) {
  auto volume = add_image<Volume>(
      module, "Volume", documentation<Volume>("A measured quantity on a grid in space.", "float32", "Volume", ""));
  volume
      .def(py::init([](const ArrayLike& array, const Eigen::Vector3d& spacing_mm, const Eigen::Vector3d& origin_mm,
                       const Eigen::Matrix3d& direction, const std::string& unit) {
             Volume made = from_array<Volume>(array, spacing_mm, origin_mm, direction);
             made.unit = unit;
             return made;
           }),
           py::arg("array"), py::kw_only(), py::arg_v("spacing_mm", ones, "(1, 1, 1)"),
           py::arg_v("origin_mm", zeros, "(0, 0, 0)"),
           py::arg_v("direction", upright, "((1, 0, 0), (0, 1, 0), (0, 0, 1))"), py::arg("unit") = "")
      .def_static(
          "empty",
          [](const Sizes& size, const Eigen::Vector3d& spacing_mm, const Eigen::Vector3d& origin_mm,
             const Eigen::Matrix3d& direction, const std::string& unit) {
            Volume made = empty<Volume>(size, spacing_mm, origin_mm, direction);
            made.unit = unit;
            return made;
          },
          py::arg("size"), py::kw_only(), py::arg_v("spacing_mm", ones, "(1, 1, 1)"),
          py::arg_v("origin_mm", zeros, "(0, 0, 0)"),
          py::arg_v("direction", upright, "((1, 0, 0), (0, 1, 0), (0, 0, 1))"), py::arg("unit") = "",
          "All zero, to be filled in place through its array; size is (i, j, k).")
      .def_readwrite("unit", &Volume::unit, "\"HU\", \"kPa\", \"Pa\", \"rad\", \"um\", or empty for arbitrary units.");
}

template <typename Picture>
void add_labels(py::module_& module, const char* name, const std::string& documentation) {
  add_image<Picture>(module, name, documentation)
      .def(py::init(&from_array<Picture>), py::arg("array"), py::kw_only(), py::arg_v("spacing_mm", ones, "(1, 1, 1)"),
           py::arg_v("origin_mm", zeros, "(0, 0, 0)"),
           py::arg_v("direction", upright, "((1, 0, 0), (0, 1, 0), (0, 0, 1))"))
      .def_static("empty", &empty<Picture>, py::arg("size"), py::kw_only(), py::arg_v("spacing_mm", ones, "(1, 1, 1)"),
                  py::arg_v("origin_mm", zeros, "(0, 0, 0)"),
                  py::arg_v("direction", upright, "((1, 0, 0), (0, 1, 0), (0, 0, 1))"),
                  "All zero, to be filled in place through its array; size is (i, j, k).");
}

void add_volume_files(py::module_& module) {
  using std::filesystem::path;
  module.def(
      "read_volume_file", [](const path& file) { return short_call([&] { return read_volume_file(file); }); },
      py::arg("file"),
      "A NIfTI, NRRD or MetaImage file as a Volume, in LPS.\n\nRaises glisson.Error: volume-file-unknown-type, "
      "-unreadable, -not-scalar, -not-3d, -bad-grid, -too-large, -truncated, -longer, -damaged.");
  module.def(
      "read_labels_file", [](const path& file) { return short_call([&] { return read_labels_file(file); }); },
      py::arg("file"),
      "The same for whole numbers 0..65535, as a LabelMap.\n\nRaises glisson.Error: as read_volume_file, and "
      "volume-file-not-labels.");
  module.def(
      "write_volume_file",
      [](const path& file, const Volume& volume) { short_call([&] { return write_volume_file(file, volume); }); },
      py::arg("file"), py::arg("volume"), "Writes .nrrd, .nii, .nii.gz or .mha, 32-bit floats, all or nothing.");
  py::class_<SegmentedMask>(module, "SegmentedMask",
                            "A mask with its name, label and colour, as 3D Slicer and DICOM SEG have it.")
      .def_property_readonly(
          "mask", [](const SegmentedMask& self) { return std::make_shared<Mask>(self.mask); },
          "Which voxels belong to it: a copy.")
      .def_property_readonly(
          "name", [](const SegmentedMask& self) { return self.info.name; }, "\"liver\".")
      .def_property_readonly(
          "label_value", [](const SegmentedMask& self) { return self.info.label_value; }, "In the file, 1..255.")
      .def_property_readonly(
          "color_rgb", [](const SegmentedMask& self) { return self.info.color_rgb; }, "sRGB, each 0..1.");
  module.def(
      "read_mask_file", [](const path& file) { return short_call([&] { return read_mask_file(file); }); },
      py::arg("file"),
      "The first segment of a label file; all that is not zero where it names none.\n\nRaises glisson.Error: as "
      "read_labels_file.");
  module.def(
      "write_mask_file",
      [](const path& file, const Mask& mask, const std::string& name, int label_value,
         const std::array<double, 3>& color_rgb) {
        if (label_value < 1 || label_value > 255) {
          raise("label-value", "A label value lies between 1 and 255; {0} does not.", {std::to_string(label_value)});
        }
        short_call([&] { return write_mask_file(file, mask, {name, label_value, color_rgb}); });
      },
      py::arg("file"), py::arg("mask"), py::arg("name"), py::kw_only(), py::arg("label_value") = 1,
      py::arg("color_rgb") = SegmentInfo{}.color_rgb,
      "Writes a .nrrd that 3D Slicer opens as one named, coloured segment, all or nothing.");
  module.def(
      "read_dicom_seg", [](const path& file) { return short_call([&] { return read_dicom_seg(file); }); },
      py::arg("file"), "The segments of a DICOM SEG file: a list of SegmentedMask.");
}

void add_series(py::module_& module) {
  py::class_<Series>(module, "Series", "A stack of parallel slices, taken once or several times; scan() finds them.")
      .def_readonly("uid", &Series::uid, "SeriesInstanceUID; a path for a volume file.")
      .def_readonly("description", &Series::description, "As the scanner called it.")
      .def_readonly("modality", &Series::modality, "\"MR\", \"CT\", ...")
      .def_property_readonly(
          "role", [](const Series& self) { return std::string(role_name(self.role)); },
          "What it is for: \"anatomy\", \"mre-stiffness\", ..., \"other\".")
      .def_readonly("role_evidence", &Series::role_evidence, "The header fields that decided.")
      .def_readonly("unit", &Series::unit, "Of the voxels once read.")
      .def_readonly("files", &Series::files, "Volume after volume, by position along the normal in each.")
      .def_readonly("volumes", &Series::volumes, "How many complete volumes there are.")
      .def_readonly("problems", &Series::problems, "One sentence each.")
      .def_property_readonly(
          "size", [](const Series& self) { return self.grid.size; }, "(i, j, k) of one volume.")
      .def_property_readonly(
          "spacing_mm", [](const Series& self) { return self.grid.spacing_mm; },
          "(3,): between voxels along i, j, k, mm.")
      .def("__repr__", [](const Series& self) {
        return "<glisson.Series " + std::string(role_name(self.role)) + ", " + in_words(self.grid) + ">";
      });
  py::class_<Study>(module, "Study", "What scan() found.")
      .def_readonly("series", &Study::series, "By series number.")
      .def_property_readonly(
          "skipped",
          [](const Study& self) {
            std::vector<std::pair<std::string, std::string>> skipped;
            for (const SkippedFile& file : self.skipped) skipped.emplace_back(file.path.string(), file.reason);
            return skipped;
          },
          "Files that could not be used: (path, reason).");
  module.def(
      "scan",
      [](const std::filesystem::path& path, const py::object& progress) {
        return long_call(progress, [&](const Progress& told) { return scan(path, told); });
      },
      py::arg("path"), py::kw_only(), py::arg("progress") = py::none(),
      "All series under a folder, in the files of a DICOMDIR, or in one file; slices are ordered by where they "
      "stand.\n\nprogress(fraction, stage) is told how far it is.\nRaises glisson.Error: path-not-found, "
      "path-not-readable, dicomdir-damaged.");
  module.def(
      "read_series",
      [](const Series& series, int volume, const py::object& progress) {
        if (volume < 0 || volume >= series.volumes) {
          raise("series-volume", "The series has {0} volumes, from 0; there is no {1}.",
                {std::to_string(series.volumes), std::to_string(volume)});
        }
        return long_call(progress, [&](const Progress& told) { return read_series(series, volume, told); });
      },
      py::arg("series"), py::arg("volume") = 0, py::kw_only(), py::arg("progress") = py::none(),
      "One volume of a series, with its rescaling applied.\n\nRaises glisson.Error: file-not-readable, "
      "dicom-truncated, dicom-changed, dicom-pixels-damaged, dicom-compression-unknown, dicom-colour.");
}

}  // namespace

void add_imaging(py::module_& module) {
  add_volume(module);
  add_labels<Mask>(module, "Mask",
                   documentation<Mask>("Which voxels belong to something: 0 or 1.", "uint8", "Mask", ", mask-values"));
  add_labels<LabelMap>(module, "LabelMap",
                       documentation<LabelMap>("Which of several structures each voxel belongs to; 0 is none.",
                                               "uint16", "LabelMap", ", labels-values"));
  add_volume_files(module);
  add_series(module);
}

}  // namespace glisson::python
