#pragma once
// Text within HTML and XML.

#include <string>

namespace glisson {

// Safe as content and in an attribute: & < > " and ' become entities.
[[nodiscard]] std::string escaped_markup(const std::string& text);

}  // namespace glisson
