#pragma once
// What an effect of the closed loop is called in the window, in a surgeon's words.

#include <QString>
#include <string>

namespace glisson::widgets {

// "support-compliance" -> "The support gives way". A kind that is not known stays as it is.
[[nodiscard]] QString effect_label(const std::string& kind);

// Several, joined by commas; a dash for none.
[[nodiscard]] QString effect_labels(const std::vector<std::string>& kinds);

// What a sentence of the core names: a kind, a parameter (it ends in a unit), or anything else, which stays.
[[nodiscard]] QString effect_or_parameter_label(const std::string& name);

// "foundation_kPa_per_mm" -> "foundation, kPa/mm".
[[nodiscard]] QString parameter_label(const std::string& name);

}  // namespace glisson::widgets
