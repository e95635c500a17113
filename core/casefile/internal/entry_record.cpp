#include "casefile/internal/entry_record.h"

#include <fmt/format.h>

#include "base/json.h"
#include "casefile/internal/sentence_record.h"

namespace glisson::casefile {
namespace fs = std::filesystem;

namespace {

// "labels/liver" lies in labels/liver.nrrd or the like, and nowhere else: not outside of the case, and never where the
// case's own records lie.
bool is_the_place_of(const std::string& id, const std::string& file) {
  const std::size_t slash = id.find('/');
  if (slash == 0 || slash == std::string::npos || slash + 1 == id.size() ||
      id.find('/', slash + 1) != std::string::npos)
    return false;
  if (id.front() == '.' || id[slash + 1] == '.' || id.find('\0') != std::string::npos) return false;
  if (!file.starts_with(id + ".")) return false;
  return file.find('/', slash + 1) == std::string::npos && file.find('\0') == std::string::npos;
}

// Earlier versions kept the series' description and the names of its files, where patients are often named.
void forget_names(Provenance& made) {
  made.options.erase("description");
  std::map<std::string, std::string> numbered;
  for (const auto& [name, content] : made.sources) {
    numbered[name.starts_with("file-") ? name : fmt::format("file-{:05}", numbered.size() + 1)] = content;
  }
  made.sources = std::move(numbered);
}

}  // namespace

std::string record_of(const Entry& entry) {
  Json made{{"by", entry.made.by}, {"version", entry.version}, {"when", entry.when_utc}};
  if (!entry.made.options.empty()) made["options"] = entry.made.options;
  if (!entry.from_sha256.empty()) made["from"] = entry.from_sha256;
  if (!entry.made.sources.empty()) made["sources"] = entry.made.sources;
  if (!entry.made.notes.empty()) {
    // For whoever reads the file, and apart from it in the pieces that other languages need.
    made["notes"] = messages(entry.made.notes);
    for (const Sentence& note : entry.made.notes) made["note_pieces"].push_back(json_of(note));
  }
  return Json{{"id", entry.id}, {"file", entry.file.generic_string()}, {"sha256", entry.sha256}, {"made", made}}.dump(
      -1, ' ', false, Json::error_handler_t::replace);
}

Result<Entry> entry_of(std::string_view text, const fs::path& file) {
  try {
    const Json json = Json::parse(text);
    Entry entry;
    entry.id = json.at("id").get<std::string>();
    entry.file = json.at("file").get<std::string>();
    entry.sha256 = json.at("sha256").get<std::string>();
    const Json& made = json.at("made");
    entry.made.by = made.at("by").get<std::string>();
    entry.version = made.value("version", "");
    entry.when_utc = made.value("when", "");
    entry.made.options = made.value("options", std::map<std::string, std::string>{});
    entry.made.sources = made.value("sources", std::map<std::string, std::string>{});
    forget_names(entry.made);
    if (made.contains("note_pieces")) {
      for (const Json& note : made.at("note_pieces")) entry.made.notes.push_back(sentence_from(note));
    } else {
      for (std::string& note : made.value("notes", std::vector<std::string>{})) {
        entry.made.notes.push_back({std::move(note), {}});
      }
    }
    entry.from_sha256 = made.value("from", std::map<std::string, std::string>{});
    for (const auto& [source, content] : entry.from_sha256) entry.made.from.push_back(source);
    if (is_the_place_of(entry.id, entry.file.generic_string())) return entry;
    return failure(Error{"case-path-outside",
                         GLISSON_TEXT("{0} names a file outside its place in the case folder: {1}."),
                         {file.string(), entry.file.string()},
                         {},
                         file});
  } catch (const Json::exception& problem) {
    return failure(
        Error{"case-invalid", GLISSON_TEXT("{0} is damaged: {1}."), {file.string(), problem.what()}, {}, file});
  }
}

}  // namespace glisson::casefile
