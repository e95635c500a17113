#pragma once
// numpy arrays and the core's vectors. A view shares the memory of the object that owns it, and keeps that alive. What
// a core function made anew is handed over whole. What comes in is copied, since the core owns what it works on.

#include <pybind11/numpy.h>
#include <array>
#include <Eigen/Core>
#include <string>
#include <vector>

#include "geometry/field.h"

namespace glisson::python {

// ---- out

// Memory of `owner`, which lives as long as the array does.
template <typename T>
pybind11::array view(const T* values, std::vector<pybind11::ssize_t> shape, pybind11::handle owner) {
  pybind11::array_t<T> array(std::move(shape), values, owner);
  pybind11::detail::array_proxy(array.ptr())->flags &= ~pybind11::detail::npy_api::NPY_ARRAY_WRITEABLE_;
  return array;
}

inline pybind11::array view(const std::vector<double>& values, pybind11::handle owner) {
  return view(values.data(), {pybind11::ssize_t(values.size())}, owner);
}

// float64, n x 3.
inline pybind11::array view(const std::vector<Eigen::Vector3d>& points, pybind11::handle owner) {
  return view(reinterpret_cast<const double*>(points.data()), {pybind11::ssize_t(points.size()), 3}, owner);
}

// int32, n x N.
template <std::size_t N>
pybind11::array view(const std::vector<std::array<int, N>>& cells, pybind11::handle owner) {
  return view(reinterpret_cast<const int*>(cells.data()), {pybind11::ssize_t(cells.size()), pybind11::ssize_t(N)},
              owner);
}

// Each field by its name: float64, n, or n x components.
pybind11::dict views(const geometry::Fields& fields, pybind11::handle owner);

// An array that owns what was a vector, without a copy.
template <typename T>
pybind11::array handed_over(std::vector<T> values) {
  auto* kept = new std::vector<T>(std::move(values));
  const pybind11::capsule owner(kept, [](void* memory) { delete static_cast<std::vector<T>*>(memory); });
  if constexpr (std::is_arithmetic_v<T>) {
    return pybind11::array_t<T>({pybind11::ssize_t(kept->size())}, kept->data(), owner);
  } else {
    return pybind11::array_t<double>({pybind11::ssize_t(kept->size()), pybind11::ssize_t(3)},
                                     reinterpret_cast<const double*>(kept->data()), owner);
  }
}

// ---- in: numbers of any type and order; `name` is that of the argument, for the error

// Whatever numpy makes an array of; array_from does.
inline bool is_anything(PyObject*) { return true; }
class ArrayLike : public pybind11::object {
  PYBIND11_OBJECT_DEFAULT(ArrayLike, pybind11::object, is_anything)
};
// Failure: "array-shape".
pybind11::array array_from(const pybind11::object& like, const std::string& name);

using Numbers = pybind11::array_t<double, pybind11::array::c_style | pybind11::array::forcecast>;

// n x 3, finite or not. Failure: "array-shape".
std::vector<Eigen::Vector3d> points_from(const Numbers& array, const std::string& name);
// The same, or none of an array that holds nothing, as [] does.
std::vector<Eigen::Vector3d> points_or_none(const Numbers& array, const std::string& name);

// n x N whole numbers. Failures: "array-shape", "array-not-whole" (of floats or beyond 32 bits).
template <std::size_t N>
std::vector<std::array<int, N>> cells_from(const ArrayLike& like, const std::string& name);
std::vector<int> whole_numbers_from(const ArrayLike& like, const std::string& name);

// name -> array of n, or n x components, for `items` points or cells. Failure: "array-shape".
geometry::Fields fields_from(const pybind11::dict& arrays, std::size_t items, const std::string& name);

// A position or a force: three finite numbers. Failure: "array-shape", "array-not-finite".
Eigen::Vector3d vector_from(const Numbers& array, const std::string& name);
std::vector<double> numbers_from(const Numbers& array, const std::string& name);

// "4 x 3"
std::string shape_in_words(const pybind11::array& array);

}  // namespace glisson::python

template <>
struct pybind11::detail::handle_type_name<glisson::python::ArrayLike> {
  static constexpr auto name = const_name("numpy.ndarray");
};
