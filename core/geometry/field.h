#pragma once
// A named quantity on the points or cells of a mesh. The name carries the unit: "displacement_mm".

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace glisson::geometry {

struct Field {
  std::string name;
  int components = 1;
  std::vector<double> values;  // values[components * item + component]

  [[nodiscard]] std::size_t items() const { return values.size() / static_cast<std::size_t>(components); }
};

using Fields = std::vector<Field>;

// The field of that name, or nullptr.
[[nodiscard]] inline const Field* find_field(const Fields& fields, std::string_view name) {
  for (const Field& field : fields) {
    if (field.name == name) return &field;
  }
  return nullptr;
}

// Adds the field, in place of one of the same name if there is one.
inline void set_field(Fields& fields, Field field) {
  for (Field& present : fields) {
    if (present.name == field.name) {
      present = std::move(field);
      return;
    }
  }
  fields.push_back(std::move(field));
}

}  // namespace glisson::geometry
