#include "geometry/fields.h"

#include "base/result.h"

namespace glisson::geometry {

Fields select(const Fields& fields, const std::vector<int>& items) {
  Fields selected;
  for (const Field& field : fields) {
    Field part{field.name, field.components, {}};
    const auto components = static_cast<std::size_t>(field.components);
    part.values.reserve(items.size() * components);
    for (const int item : items) {
      const std::size_t first = static_cast<std::size_t>(item) * components;
      GLISSON_ASSERT(first + components <= field.values.size());
      for (std::size_t i = 0; i < components; ++i) part.values.push_back(field.values[first + i]);
    }
    selected.push_back(std::move(part));
  }
  return selected;
}

std::string names_of(const Fields& fields) {
  std::string names;
  for (const Field& field : fields) names += (names.empty() ? "" : ", ") + field.name;
  return names.empty() ? "none" : names;
}

}  // namespace glisson::geometry
