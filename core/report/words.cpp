#include "report/words.h"

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

std::string Words::quoted_effect(const std::string& kind) const {
  const std::string said = effect(kind);
  return said == kind ? said : "\"" + said + "\"";
}

std::string Words::entry(const std::string& id) const {
  if (id == "meshes/liver") return say(GLISSON_TEXT("Cells of the liver"));
  if (id == "meshes/model") return say(GLISSON_TEXT("Model: stiffness of each cell"));
  if (id == "results/orders") return say(GLISSON_TEXT("Orders of steps compared"));
  if (id == "evidence/model") return say(GLISSON_TEXT("Evidence accepted"));
  static const std::map<std::string, const char*> kinds{{"volumes", GLISSON_TEXT("Images: {0}")},
                                                        {"labels", GLISSON_TEXT("Outline: {0}")},
                                                        {"surfaces", GLISSON_TEXT("Smooth surface: {0}")},
                                                        {"orders", GLISSON_TEXT("Order of steps: {0}")}};
  const auto slash = id.find('/');
  const auto kind = kinds.find(id.substr(0, slash));
  if (slash == std::string::npos || kind == kinds.end()) return name(id);
  return say(kind->second, {name(id.substr(slash + 1))});
}

std::string Words::way(const std::string& command) const {
  static const std::map<std::string, const char*> ways{
      {"import", GLISSON_TEXT("imported")},       {"segment", GLISSON_TEXT("outlined")},
      {"mesh", GLISSON_TEXT("made into cells")},  {"stiffness", GLISSON_TEXT("stiffness given")},
      {"invert", GLISSON_TEXT("waves inverted")}, {"accept", GLISSON_TEXT("accepted")},
      {"session", GLISSON_TEXT("rehearsed")}};
  const auto way = ways.find(command);
  return way == ways.end() ? command : say(way->second);
}

}  // namespace glisson::report
