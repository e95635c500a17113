#include "report/plain_names.h"

#include <algorithm>
#include <cctype>
#include <map>

namespace glisson::report {

std::string plain_name(const std::string& id) {
  std::string name = id;
  std::replace(name.begin(), name.end(), '-', ' ');
  if (!name.empty()) name.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(name.front())));
  return name;
}

std::string plain_entry(const std::string& id) {
  if (id == "meshes/liver") return "Cells of the liver";
  if (id == "meshes/model") return "Model: stiffness of each cell";
  if (id == "evidence/model") return "Evidence accepted";
  static const std::map<std::string, std::string> kinds{
      {"volumes", "Images"}, {"labels", "Outline"}, {"surfaces", "Smooth surface"}};
  const auto slash = id.find('/');
  const auto kind = kinds.find(id.substr(0, slash));
  if (slash == std::string::npos || kind == kinds.end()) return plain_name(id);
  std::string name = id.substr(slash + 1);
  std::replace(name.begin(), name.end(), '-', ' ');
  return kind->second + ": " + name;
}

std::string plain_way(const std::string& command) {
  static const std::map<std::string, std::string> ways{{"import", "imported"},       {"segment", "outlined"},
                                                       {"mesh", "made into cells"},  {"stiffness", "stiffness given"},
                                                       {"invert", "waves inverted"}, {"accept", "accepted"}};
  const auto way = ways.find(command);
  return way == ways.end() ? command : way->second;
}

}  // namespace glisson::report
