#pragma once
// The log, on stderr. What a person should know of a computation belongs in its result, not here.

#include <string_view>

namespace glisson {

enum class LogLevel { debug, info, warning, error, off };

void set_log_level(LogLevel level);
void log_debug(std::string_view message);
void log_info(std::string_view message);
void log_warning(std::string_view message);

}  // namespace glisson
