#pragma once
// Grids and images made of what Python gives, and refused where they are none.

#include <pybind11/numpy.h>
#include <string>

#include "arrays.h"
#include "imaging/image.h"

namespace glisson::python {

using Sizes = std::array<pybind11::ssize_t, 3>;
using Rows = std::array<std::array<double, 3>, 3>;

// Fails with "grid-size" (an axis that is empty, or more than 2^29 voxels), "grid-spacing" (not positive) or
// "grid-origin". Fails with "grid-direction" where columns are no unit vectors, or lie in a plane.
imaging::Grid grid_from(const Sizes& size, const Eigen::Vector3d& spacing_mm, const Eigen::Vector3d& origin_mm,
                        const Eigen::Matrix3d& direction);

// "i x j x k", or "array-shape".
Sizes sizes_of(const pybind11::array& array);

// Failure: "grids-differ", naming both.
void require_same_grid(const imaging::Grid& a, const std::string& a_name, const imaging::Grid& b,
                       const std::string& b_name);

}  // namespace glisson::python
