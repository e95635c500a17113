#include "base/json_reading.h"

#include <cmath>

namespace glisson {

void refuse_at(const std::string& where, std::string text, std::vector<std::string> more) {
  more.insert(more.begin(), where);
  refuse({}, std::move(text), std::move(more));
}

void refuse(std::string code, std::string text, std::vector<std::string> arguments, std::string hint,
            std::filesystem::path file) {
  throw Refusal{{std::move(code), std::move(text), std::move(arguments), std::move(hint), std::move(file)}};
}

void only_keys(const Json& json, std::initializer_list<std::string_view> known, const std::string& where) {
  if (!json.is_object()) refuse_at(where, GLISSON_TEXT("{0} must be an object in braces."));
  if (auto checked = refuse_unknown_keys(json, known, where); !checked) {
    checked.error().code.clear();
    throw Refusal{std::move(checked.error())};
  }
}

const Json& required(const Json& json, const char* key, const std::string& where) {
  if (!json.is_object()) refuse_at(where, GLISSON_TEXT("{0} must be an object in braces."));
  const auto found = json.find(key);
  if (found == json.end()) refuse_at(where, GLISSON_TEXT("{0} lacks \"{1}\"."), {key});
  return *found;
}

double number_in(const Json& json, const std::string& where) {
  if (!json.is_number() || !std::isfinite(json.get<double>()))
    refuse_at(where, GLISSON_TEXT("{0} must be a finite number."));
  return json.get<double>();
}

double positive_in(const Json& json, const std::string& where) {
  const double value = number_in(json, where);
  if (value <= 0) refuse_at(where, GLISSON_TEXT("{0} must be above zero."));
  return value;
}

double not_negative_in(const Json& json, const std::string& where) {
  const double value = number_in(json, where);
  if (value < 0) refuse_at(where, GLISSON_TEXT("{0} must not be below zero."));
  return value;
}

bool truth_in(const Json& json, const std::string& where) {
  if (!json.is_boolean()) refuse_at(where, GLISSON_TEXT("{0} must be true or false."));
  return json.get<bool>();
}

std::string text_in(const Json& json, const std::string& where) {
  if (!json.is_string()) refuse_at(where, GLISSON_TEXT("{0} must be a text in quotes."));
  return json.get<std::string>();
}

std::string name_in(const Json& json, const std::string& where) {
  if (!json.is_string() || json.get_ref<const std::string&>().empty())
    refuse_at(where, GLISSON_TEXT("{0} must be a name in quotes."));
  return json.get<std::string>();
}

Eigen::Vector3d vector_in(const Json& json, const std::string& where) {
  if (!json.is_array() || json.size() != 3) refuse_at(where, GLISSON_TEXT("{0} must be three numbers [x, y, z]."));
  return {number_in(json[0], where), number_in(json[1], where), number_in(json[2], where)};
}

std::optional<double> optional_positive(const Json& json, const char* key, const std::string& where) {
  if (!json.contains(key)) return std::nullopt;
  return positive_in(json[key], where + ", " + key);
}

std::string item(const char* each, std::size_t index) { return std::string(each) + " " + std::to_string(index + 1); }

}  // namespace glisson
