#include <fmt/format.h>
#include <cmath>

#include "hardware/device.h"
#include "hardware/internal/figure_file.h"

namespace glisson::hardware {
namespace {

constexpr std::size_t longest_text = 2000;

}  // namespace

std::string to_string(Source source) {
  switch (source) {
    case Source::measured: return "measured";
    case Source::computed: return "computed";
    case Source::dissertation: return "dissertation";
    case Source::assumed: return "assumed";
  }
  return "assumed";
}

Result<FigureReader> FigureReader::open(const Json& document, const std::string& format,
                                        const std::filesystem::path& file) {
  const auto stated = document.is_object() ? document.find("format") : document.end();
  if (!document.is_object() || stated == document.end() || *stated != format) {
    return failure(Error{"format-unknown",
                         GLISSON_TEXT("{0} does not say \"format\": \"{1}\"."),
                         {file.string(), format},
                         GLISSON_TEXT("Check that it is the file you meant."),
                         file});
  }
  return FigureReader(file);
}

Failure FigureReader::missing(const char* key, const std::string& where) const {
  return failure(Error{"key-missing",
                       GLISSON_TEXT("{0} has no \"{1}\", or not of the right kind."),
                       {where, key},
                       GLISSON_TEXT("The shipped devices.json shows every key."),
                       file_});
}

Result<double> FigureReader::number(const Json& object, const char* key, Limits limits,
                                    const std::string& where) const {
  const auto found = object.find(key);
  if (found == object.end() || !found->is_number()) return missing(key, where);
  const double value = found->get<double>();
  if (value >= limits.minimum && value <= limits.maximum) return value;
  return failure(Error{"figure-out-of-range",
                       GLISSON_TEXT("{0} has \"{1}\" {2}; it must lie between {3} and {4}."),
                       {where, key, fmt::format("{:g}", value), fmt::format("{:g}", limits.minimum),
                        fmt::format("{:g}", limits.maximum)},
                       {},
                       file_});
}

Result<std::string> FigureReader::text(const Json& object, const char* key, const std::string& where) const {
  const auto found = object.find(key);
  if (found == object.end() || !found->is_string()) return missing(key, where);
  auto value = found->get<std::string>();
  if (!value.empty() && value.size() <= longest_text) return value;
  return failure(Error{"text-invalid",
                       GLISSON_TEXT("{0} has \"{1}\" empty or longer than {2} characters."),
                       {where, key, std::to_string(longest_text)},
                       {},
                       file_});
}

Result<Source> FigureReader::source(const Json& object, const std::string& where) const {
  const auto name = text(object, "source", where);
  if (!name) return failure(name.error());
  for (const Source source : {Source::measured, Source::computed, Source::dissertation, Source::assumed}) {
    if (*name == to_string(source)) return source;
  }
  return failure(
      Error{"source-unknown",
            GLISSON_TEXT("{0} has the source \"{1}\"."),
            {where, *name},
            GLISSON_TEXT("A figure is measured, computed, from the dissertation (dissertation), or assumed."),
            file_});
}

Result<Figure> FigureReader::figure(const Json& object, const char* key, Limits limits,
                                    const std::string& where) const {
  const auto found = object.find(key);
  if (found == object.end() || !found->is_object()) return missing(key, where);
  const std::string here = where + ", " + key;
  if (const auto known = refuse_unknown_keys(*found, {"value", "source", "note"}, here); !known)
    return failure(Error(known.error()).in_file(file_));
  Figure figure;
  const auto value = number(*found, "value", limits, here);
  if (!value) return failure(value.error());
  figure.value = *value;
  const auto stated = source(*found, here);
  if (!stated) return failure(stated.error());
  figure.source = *stated;
  const auto note = text(*found, "note", here);
  if (!note) return failure(note.error());
  figure.note = *note;
  return figure;
}

}  // namespace glisson::hardware
