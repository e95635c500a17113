#include "image_grid.h"

#include <Eigen/LU>

#include "errors.h"

namespace py = pybind11;

namespace glisson::python {

Sizes sizes_of(const py::array& array) {
  if (array.ndim() != 3) {
    raise("array-shape", "An image is an array of three axes, [i, j, k]; this one has {0}.", {shape_in_words(array)});
  }
  return {array.shape(0), array.shape(1), array.shape(2)};
}

imaging::Grid grid_from(const Sizes& size, const Eigen::Vector3d& spacing_mm, const Eigen::Vector3d& origin_mm,
                        const Eigen::Matrix3d& direction) {
  constexpr py::ssize_t most_voxels = py::ssize_t{1} << 29;  // as files may have
  py::ssize_t voxels = 1;
  for (const py::ssize_t axis : size) {
    if (axis < 1 || axis > most_voxels / voxels) {
      raise("grid-size", "An image of {0} x {1} x {2} voxels cannot be made.",
            {std::to_string(size[0]), std::to_string(size[1]), std::to_string(size[2])},
            "Each axis needs a voxel, and all together may have 536870912.");
    }
    voxels *= axis;
  }
  if (!spacing_mm.allFinite() || spacing_mm.minCoeff() <= 0)
    raise("grid-spacing", "The spacing (mm) must be three numbers above 0.");
  if (!origin_mm.allFinite()) raise("grid-origin", "The origin (mm) must be three finite numbers.");
  constexpr double tolerance = 1e-3;
  const bool are_unit = direction.allFinite() && ((direction.colwise().norm().array() - 1).abs() < tolerance).all();
  if (!are_unit || std::abs(direction.determinant()) < tolerance) {
    raise("grid-direction", "The columns of the direction must be unit vectors: those of the axes i, j and k.");
  }
  return {{int(size[0]), int(size[1]), int(size[2])}, spacing_mm, origin_mm, direction};
}

void require_same_grid(const imaging::Grid& a, const std::string& a_name, const imaging::Grid& b,
                       const std::string& b_name) {
  if (imaging::same_grid(a, b)) return;
  raise("grids-differ", "{0} and {1} lie on different grids.", {a_name, b_name});
}

}  // namespace glisson::python
