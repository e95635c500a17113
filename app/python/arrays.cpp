#include "arrays.h"

#include <limits>

#include "errors.h"

namespace py = pybind11;

namespace glisson::python {
namespace {

[[noreturn]] void refuse_shape(const std::string& name, const std::string& wanted, const py::array& array) {
  raise("array-shape", "{0} must be an array of {1}; it has {2}.", {name, wanted, shape_in_words(array)});
}

// Whole numbers of any width, as they are or refused.
py::array_t<std::int64_t, py::array::c_style> wide(const py::array& array, const std::string& name) {
  const char kind = array.dtype().kind();
  if (kind != 'i' && kind != 'u') {
    raise("array-not-whole", "{0} must be whole numbers (int32); its type is {1}.",
          {name, py::str(array.dtype()).cast<std::string>()});
  }
  return py::array_t<std::int64_t, py::array::c_style | py::array::forcecast>::ensure(array);
}

int narrow(std::int64_t number, const std::string& name) {
  if (number < std::numeric_limits<int>::min() || number > std::numeric_limits<int>::max()) {
    raise("array-not-whole", "{0} holds {1}, which 32 bits do not.", {name, std::to_string(number)});
  }
  return static_cast<int>(number);
}

}  // namespace

py::array array_from(const py::object& like, const std::string& name) {
  const auto array = py::array::ensure(like);
  if (array && std::string("biuf").find(array.dtype().kind()) != std::string::npos) return array;
  PyErr_Clear();
  raise("array-shape", "{0} must be an array of numbers.", {name});
}

std::string shape_in_words(const py::array& array) {
  if (array.ndim() == 0) return "a single number";
  std::string words;
  for (py::ssize_t axis = 0; axis < array.ndim(); ++axis)
    words += (axis == 0 ? "" : " x ") + std::to_string(array.shape(axis));
  return words;
}

py::dict views(const geometry::Fields& fields, py::handle owner) {
  py::dict all;
  for (const geometry::Field& field : fields) {
    std::vector<py::ssize_t> shape{py::ssize_t(field.items())};
    if (field.components != 1) shape.push_back(field.components);
    all[py::str(field.name)] = view(field.values.data(), shape, owner);
  }
  return all;
}

std::vector<Eigen::Vector3d> points_or_none(const Numbers& array, const std::string& name) {
  return array.size() == 0 ? std::vector<Eigen::Vector3d>() : points_from(array, name);
}

std::vector<Eigen::Vector3d> points_from(const Numbers& array, const std::string& name) {
  if (array.ndim() != 2 || array.shape(1) != 3) refuse_shape(name, "n x 3", array);
  std::vector<Eigen::Vector3d> points(static_cast<std::size_t>(array.shape(0)));
  for (std::size_t n = 0; n < points.size(); ++n) points[n] = Eigen::Map<const Eigen::Vector3d>(array.data() + 3 * n);
  return points;
}

template <std::size_t N>
std::vector<std::array<int, N>> cells_from(const ArrayLike& like, const std::string& name) {
  const py::array array = array_from(like, name);
  if (array.ndim() != 2 || array.shape(1) != py::ssize_t(N)) refuse_shape(name, "n x " + std::to_string(N), array);
  const auto numbers = wide(array, name);
  std::vector<std::array<int, N>> cells(static_cast<std::size_t>(array.shape(0)));
  for (std::size_t c = 0; c < cells.size(); ++c)
    for (std::size_t k = 0; k < N; ++k) cells[c][k] = narrow(numbers.data()[N * c + k], name);
  return cells;
}
template std::vector<std::array<int, 3>> cells_from<3>(const ArrayLike&, const std::string&);
template std::vector<std::array<int, 4>> cells_from<4>(const ArrayLike&, const std::string&);

std::vector<int> whole_numbers_from(const ArrayLike& like, const std::string& name) {
  const py::array array = array_from(like, name);
  if (array.ndim() != 1) refuse_shape(name, "n", array);
  const auto wider = wide(array, name);
  std::vector<int> numbers;
  for (py::ssize_t n = 0; n < wider.size(); ++n) numbers.push_back(narrow(wider.data()[n], name));
  return numbers;
}

geometry::Fields fields_from(const py::dict& arrays, std::size_t items, const std::string& name) {
  geometry::Fields fields;
  for (const auto& [key, value] : arrays) {
    const auto called = name + "[\"" + py::str(key).cast<std::string>() + "\"]";
    const auto array = Numbers::ensure(value);
    if (!array) {
      PyErr_Clear();
      raise("array-shape", "{0} must be an array of numbers.", {called});
    }
    if (array.ndim() < 1 || array.ndim() > 2 || array.shape(0) != py::ssize_t(items) ||
        (array.ndim() == 2 && array.shape(1) < 1))
      refuse_shape(called, std::to_string(items) + ", or " + std::to_string(items) + " x components", array);
    geometry::Field field{py::str(key), array.ndim() == 1 ? 1 : static_cast<int>(array.shape(1)), {}};
    field.values.assign(array.data(), array.data() + array.size());
    geometry::set_field(fields, std::move(field));
  }
  return fields;
}

Eigen::Vector3d vector_from(const Numbers& array, const std::string& name) {
  if (array.ndim() != 1 || array.shape(0) != 3) refuse_shape(name, "3", array);
  const Eigen::Vector3d vector = Eigen::Map<const Eigen::Vector3d>(array.data());
  if (!vector.allFinite()) raise("array-not-finite", "{0} holds a number that is not finite.", {name});
  return vector;
}

std::vector<double> numbers_from(const Numbers& array, const std::string& name) {
  if (array.ndim() != 1) refuse_shape(name, "n", array);
  return {array.data(), array.data() + array.size()};
}

}  // namespace glisson::python
