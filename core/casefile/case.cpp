#include "casefile/case.h"

#include <fmt/chrono.h>
#include <algorithm>
#include <chrono>
#include <system_error>

#include "base/files.h"
#include "base/json.h"
#include "imaging/volume_file.h"

namespace glisson::casefile {
namespace fs = std::filesystem;
namespace {

constexpr const char* format_name = "glisson-case/1";

Json to_json(const Entry& entry);
Result<Entry> entry_from_json(const Json& json, const fs::path& case_json);
Failure not_a_case(const fs::path& folder, const std::string& why);

// Where a new file waits until case.json knows it.
fs::path waiting_place(const fs::path& file) { return file.parent_path() / (".next-" + file.filename().string()); }

std::string utc_now() {
  return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}",
                     fmt::gmtime(std::chrono::system_clock::to_time_t(std::chrono::system_clock::now())));
}

}  // namespace

Result<Case> Case::create(const fs::path& folder) {
  std::error_code problem;
  if (fs::exists(folder, problem) && !(fs::is_directory(folder, problem) && fs::is_empty(folder, problem))) {
    return failure(Error{"case-exists",
                         GLISSON_TEXT("{0} is there already."),
                         {folder.string()},
                         GLISSON_TEXT("Choose another name, or remove it first."),
                         folder});
  }
  fs::create_directories(folder, problem);
  if (problem) {
    return failure(Error{"case-not-writable",
                         GLISSON_TEXT("The folder {0} cannot be made: {1}."),
                         {folder.string(), problem.message()},
                         {},
                         folder});
  }
  Case made;
  made.folder_ = folder;
  if (auto saved = made.save(); !saved) return failure(saved.error());
  return made;
}

Result<Case> Case::open(const fs::path& folder) {
  const fs::path case_json = folder / "case.json";
  std::error_code problem;
  if (!fs::exists(case_json, problem)) return not_a_case(folder, GLISSON_TEXT("it holds no case.json"));
  const auto document = read_json_file(case_json);
  if (!document) return failure(document.error());
  if (!document->is_object() || document->value("format", Json()) != format_name) {
    return not_a_case(folder, GLISSON_TEXT("case.json does not say \"format\": \"glisson-case/1\""));
  }
  Case opened;
  opened.folder_ = folder;
  if (const auto origin = document->find("origin"); origin != document->end() && origin->is_string()) {
    opened.origin_ = origin->get<std::string>();
  }
  for (const Json& json : document->value("entries", Json::array())) {
    auto entry = entry_from_json(json, case_json);
    if (!entry) return failure(entry.error());
    opened.entries_.push_back(std::move(*entry));
  }
  if (auto finished = opened.finish_interrupted_addition(); !finished) return failure(finished.error());
  return opened;
}

const Entry* Case::find(const std::string& id) const {
  const auto found = std::find_if(entries_.begin(), entries_.end(), [&](const Entry& entry) { return entry.id == id; });
  return found == entries_.end() ? nullptr : &*found;
}

Result<fs::path> Case::file_of(const std::string& id) const {
  const Entry* entry = find(id);
  if (!entry) {
    return failure(Error{"case-lacks-entry",
                         GLISSON_TEXT("The case {0} has no {1} yet."),
                         {folder_.string(), id},
                         id.starts_with("volumes/")  ? GLISSON_TEXT("Import a study first (glisson-cli import).")
                         : id.starts_with("labels/") ? GLISSON_TEXT("Segment it first (glisson-cli segment).")
                                                     : GLISSON_TEXT("Mesh the liver first (glisson-cli mesh)."),
                         folder_});
  }
  return folder_ / entry->file;
}

Result<imaging::Volume> Case::volume(const std::string& id) const {
  return file_of(id).and_then([](const fs::path& file) { return imaging::read_volume_file(file); });
}

Result<void> Case::set_origin(std::string origin) {
  std::swap(origin_, origin);
  auto saved = save();
  if (!saved) std::swap(origin_, origin);
  return saved;
}

Result<void> Case::add(const std::string& id, const std::string& extension, Made made,
                       const std::function<Result<void>(const fs::path&)>& write) {
  Entry entry{id, fs::path(id + extension), {}, std::move(made), {}, version(), utc_now()};
  for (const std::string& source : entry.made.from) {
    const Entry* known = find(source);
    GLISSON_ASSERT(known != nullptr);
    // Another program may have edited a label since: what counts is the content that was used.
    auto content = sha256_of_file(folder_ / known->file);
    if (!content) return failure(content.error());
    entry.from_sha256[source] = std::move(*content);
  }

  const fs::path target = folder_ / entry.file;
  const fs::path waiting = waiting_place(target);
  std::error_code problem;
  fs::create_directories(target.parent_path(), problem);
  if (auto written = write(waiting); !written) {
    fs::remove(waiting, problem);
    return written;
  }
  auto content = sha256_of_file(waiting);
  if (!content) return failure(content.error());
  entry.sha256 = std::move(*content);

  const std::vector<Entry> before = entries_;
  std::erase_if(entries_, [&](const Entry& present) { return present.id == id; });
  entries_.push_back(std::move(entry));
  if (auto saved = save(); !saved) {
    entries_ = before;
    fs::remove(waiting, problem);
    return saved;
  }
  return finish_interrupted_addition();
}

Result<void> Case::remove(const std::string& id) {
  const Entry* entry = find(id);
  if (!entry) return {};
  const fs::path file = folder_ / entry->file;
  const std::vector<Entry> before = entries_;
  std::erase_if(entries_, [&](const Entry& present) { return present.id == id; });
  if (auto saved = save(); !saved) {
    entries_ = before;
    return saved;
  }
  std::error_code ignored;
  fs::remove(file, ignored);
  return {};
}

Freshness Case::freshness(const std::string& id) const {
  const Entry* entry = find(id);
  std::error_code problem;
  if (!entry || !fs::exists(folder_ / entry->file, problem)) return Freshness::missing;
  if (sha256_of_file(folder_ / entry->file).value_or("") != entry->sha256) return Freshness::changed_outside;
  for (const auto& [source, content] : entry->from_sha256) {
    const Entry* known = find(source);
    if (!known || sha256_of_file(folder_ / known->file).value_or("") != content) return Freshness::stale;
    if (freshness(source) == Freshness::stale) return Freshness::stale;
  }
  return Freshness::current;
}

Result<void> Case::save() const {
  Json document{{"format", format_name}, {"version", version()}};
  if (!origin_.empty()) document["origin"] = origin_;
  document["entries"] = Json::array();
  for (const Entry& entry : entries_) document["entries"].push_back(to_json(entry));
  return write_json_file(folder_ / "case.json", document);
}

// A file that waits and is the one that case.json names was interrupted after its record was saved: it takes its
// place now. Any other waiting file was interrupted before: it goes.
Result<void> Case::finish_interrupted_addition() const {
  for (const Entry& entry : entries_) {
    const fs::path target = folder_ / entry.file;
    const fs::path waiting = waiting_place(target);
    std::error_code problem;
    if (!fs::exists(waiting, problem)) continue;
    if (sha256_of_file(waiting).value_or("") == entry.sha256) {
      fs::rename(waiting, target, problem);
    } else {
      fs::remove(waiting, problem);
    }
    if (problem) {
      return failure(Error{"case-not-writable",
                           GLISSON_TEXT("{0} cannot be put in its place: {1}."),
                           {waiting.string(), problem.message()},
                           {},
                           waiting});
    }
  }
  return {};
}

namespace {

Json to_json(const Entry& entry) {
  Json made{{"by", entry.made.by}, {"version", entry.version}, {"when", entry.when_utc}};
  if (!entry.made.options.empty()) made["options"] = entry.made.options;
  if (!entry.from_sha256.empty()) made["from"] = entry.from_sha256;
  if (!entry.made.sources.empty()) made["sources"] = entry.made.sources;
  if (!entry.made.notes.empty()) made["notes"] = entry.made.notes;
  return Json{{"id", entry.id}, {"file", entry.file.generic_string()}, {"sha256", entry.sha256}, {"made", made}};
}

Result<Entry> entry_from_json(const Json& json, const fs::path& case_json) {
  try {
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
    entry.made.notes = made.value("notes", std::vector<std::string>{});
    entry.from_sha256 = made.value("from", std::map<std::string, std::string>{});
    for (const auto& [source, content] : entry.from_sha256) entry.made.from.push_back(source);
    // A case may come from anywhere; it must not reach for files outside its own folder.
    const bool escapes = entry.file.is_absolute() || std::any_of(entry.file.begin(), entry.file.end(),
                                                                 [](const fs::path& part) { return part == ".."; });
    if (!escapes) return entry;
    return failure(Error{"case-path-outside",
                         GLISSON_TEXT("{0} names a file outside the case folder: {1}."),
                         {case_json.string(), entry.file.string()},
                         {},
                         case_json});
  } catch (const Json::exception& problem) {
    return failure(Error{
        "case-invalid", GLISSON_TEXT("{0} is damaged: {1}."), {case_json.string(), problem.what()}, {}, case_json});
  }
}

Failure not_a_case(const fs::path& folder, const std::string& why) {
  return failure(Error{"not-a-case",
                       GLISSON_TEXT("{0} is not a Glisson case: {1}."),
                       {folder.string(), why},
                       GLISSON_TEXT("Make one with: glisson-cli import STUDY --case NAME.glisson"),
                       folder});
}

}  // namespace
}  // namespace glisson::casefile
