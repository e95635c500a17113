#include "casefile/case.h"

#include <fmt/chrono.h>
#include <algorithm>
#include <chrono>
#include <system_error>

#include "base/files.h"
#include "base/json.h"
#include "base/write_file.h"
#include "casefile/internal/case_links.h"
#include "casefile/internal/entry_record.h"
#include "casefile/internal/folder_lock.h"
#include "imaging/volume_file.h"

namespace glisson::casefile {
namespace fs = std::filesystem;
namespace {

constexpr const char* case_format = "glisson-case/1";

Failure not_a_case(const fs::path& folder, const std::string& why);

// Where a new file waits until case.json knows it.
constexpr const char* waiting_prefix = ".next-";
fs::path waiting_place(const fs::path& file) {
  return file.parent_path() / (waiting_prefix + file.filename().string());
}

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
  Case opened;
  opened.folder_ = folder;
  if (auto read = opened.reread(); !read) return failure(read.error());
  // Whoever holds the lock is alive and is changing the case: what lies there is theirs to finish.
  const FolderLock lock(folder, FolderLock::Wait::not_at_all);
  if (lock.taken()) return opened;
  if (auto read = opened.reread(); !read) return failure(read.error());
  if (auto finished = opened.finish_interrupted_addition(); !finished) return failure(finished.error());
  remove_abandoned_parts(folder);
  return opened;
}

Result<void> Case::reread() {
  const fs::path case_json = folder_ / "case.json";
  std::error_code problem;
  if (!fs::exists(case_json, problem)) return not_a_case(folder_, GLISSON_TEXT("it holds no case.json"));
  const auto document = read_json_file(case_json);
  if (!document) return failure(document.error());
  if (!document->is_object() || document->value("format", Json()) != case_format) {
    return not_a_case(folder_, GLISSON_TEXT("case.json does not say \"format\": \"glisson-case/1\""));
  }
  origin_.clear();
  if (const auto origin = document->find("origin"); origin != document->end() && origin->is_string()) {
    origin_ = origin->get<std::string>();
  }
  entries_.clear();
  for (const Json& json : document->value("entries", Json::array())) {
    auto entry = entry_of(json.dump(), case_json);
    if (!entry) return failure(entry.error());
    entries_.push_back(std::move(*entry));
  }
  return {};
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
  const fs::path file = folder_ / entry->file;
  const bool waits = transaction_ && std::find(transaction_->waiting_for.begin(), transaction_->waiting_for.end(),
                                               file) != transaction_->waiting_for.end();
  return waits ? waiting_place(file) : file;
}

Result<imaging::Volume> Case::volume(const std::string& id) const {
  return file_of(id).and_then([](const fs::path& file) { return imaging::read_volume_file(file); });
}

Result<void> Case::together(const std::function<Result<void>()>& change) {
  if (transaction_) return change();
  const FolderLock lock(folder_, FolderLock::Wait::until_free);
  if (auto read = reread(); !read) return read;
  transaction_ = Transaction{entries_, origin_, {}, {}};
  Result<void> changed;
  try {
    changed = change();
  } catch (...) {
    (void)take_back({});
    throw;
  }
  return changed ? commit() : take_back(changed.error());
}

Result<void> Case::set_origin(std::string origin) {
  return together([&]() -> Result<void> {
    origin_ = std::move(origin);
    return {};
  });
}

Result<void> Case::add(const std::string& id, const std::string& extension, Provenance made,
                       const std::function<Result<void>(const fs::path&)>& write) {
  return together([&]() -> Result<void> {
    Entry entry{id, fs::path(id + extension), {}, std::move(made), {}, version(), utc_now()};
    for (const std::string& source : entry.made.from) {
      // Another program may have edited a label since: what counts is the content that was used.
      auto content = file_of(source).and_then(sha256_of_file);
      if (!content) return failure(content.error());
      entry.from_sha256[source] = std::move(*content);
    }
    return stage({{id, std::move(entry), write}});
  });
}

Result<void> Case::remove(const std::string& id) { return replace({{id, std::nullopt, {}}}); }

Result<void> Case::replace(const std::vector<Replacement>& replacements) {
  return together([&] { return stage(replacements); });
}

// An entry without a content is given that of the file written for it.
Result<void> Case::stage(const std::vector<Replacement>& replacements) {
  for (const Replacement& replacement : replacements) {
    const auto present =
        std::find_if(entries_.begin(), entries_.end(), [&](const Entry& entry) { return entry.id == replacement.id; });
    const bool known = present != entries_.end();
    for (const fs::path& file :
         {known ? present->file : fs::path(), replacement.entry ? replacement.entry->file : ""}) {
      if (auto inside = refuse_links(folder_, file); !inside) return inside;
    }
    if (known && (!replacement.entry || replacement.entry->file != present->file)) {
      transaction_->leaving.push_back(folder_ / present->file);
    }
    if (!replacement.entry) {
      if (known) entries_.erase(present);
      continue;
    }
    Entry entry = *replacement.entry;
    const fs::path target = folder_ / entry.file, waiting = waiting_place(target);
    std::erase(transaction_->leaving, target);
    std::erase(transaction_->waiting_for, target);
    transaction_->waiting_for.push_back(target);
    std::error_code ignored;
    fs::create_directories(waiting.parent_path(), ignored);  // what is wrong shows in the writing
    if (auto written = replacement.write(waiting); !written) return written;
    auto content = sha256_of_file(waiting);
    if (!content) return failure(content.error());
    if (!entry.sha256.empty() && entry.sha256 != *content) {
      return failure(Error{
          "case-wrong-content", GLISSON_TEXT("{0} would not come out as it was."), {target.string()}, {}, target});
    }
    entry.sha256 = std::move(*content);
    if (known) {
      *present = std::move(entry);
    } else {
      entries_.push_back(std::move(entry));
    }
  }
  return {};
}

// With case.json it has happened; then the files take their places, the old ones standing by until all have.
Result<void> Case::commit() {
  if (auto saved = save(); !saved) return take_back(saved.error());
  std::vector<fs::path> placed;
  std::error_code ignored;
  for (const fs::path& target : transaction_->waiting_for) {
    if (const int code = exchange_files(waiting_place(target), target); code != 0) {
      for (const fs::path& done : placed) (void)exchange_files(waiting_place(done), done);
      return take_back(Error{"case-not-writable",
                             GLISSON_TEXT("{0} cannot be put in its place: {1}."),
                             {target.string(), std::generic_category().message(code)},
                             {},
                             target},
                       Recorded::yes);
    }
    placed.push_back(target);
  }
  for (const fs::path& target : transaction_->waiting_for) fs::remove(waiting_place(target), ignored);
  for (const fs::path& file : transaction_->leaving) {
    const bool kept =
        std::any_of(entries_.begin(), entries_.end(), [&](const Entry& entry) { return folder_ / entry.file == file; });
    if (!kept) fs::remove(file, ignored);
  }
  transaction_.reset();
  return {};
}

// As it was. Where case.json says otherwise and cannot be written, the files wait for the next who opens the case.
Result<void> Case::take_back(const Error& error, Recorded recorded) {
  entries_ = std::move(transaction_->entries_before);
  origin_ = std::move(transaction_->origin_before);
  const std::vector<fs::path> waiting_for = std::move(transaction_->waiting_for);
  transaction_.reset();
  if (recorded == Recorded::yes && !save()) return failure(error);
  std::error_code ignored;
  for (const fs::path& target : waiting_for) fs::remove(waiting_place(target), ignored);
  return failure(error);
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
  Json document{{"format", case_format}, {"version", version()}};
  if (!origin_.empty()) document["origin"] = origin_;
  document["entries"] = Json::array();
  for (const Entry& entry : entries_) document["entries"].push_back(Json::parse(record_of(entry)));
  return write_json_file(folder_ / "case.json", document);
}

// A file that waits and is the one that case.json names was interrupted after its record was saved: it takes its
// place now. Any other waiting file was interrupted before: it goes, of an entry that never came to be too.
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
  for (const char* room :
       {"volumes", "labels", "surfaces", "meshes", "evidence", "landmarks", "vessels", "territories", "plans"}) {
    std::error_code problem, ignored;
    if (fs::is_symlink(fs::symlink_status(folder_ / room, problem))) continue;
    for (fs::directory_iterator file(folder_ / room, problem), end; !problem && file != end; file.increment(problem)) {
      if (file->path().filename().string().starts_with(waiting_prefix)) fs::remove(file->path(), ignored);
    }
  }
  return {};
}

namespace {

Failure not_a_case(const fs::path& folder, const std::string& why) {
  return failure(Error{"not-a-case",
                       GLISSON_TEXT("{0} is not a Glisson case: {1}."),
                       {folder.string(), why},
                       GLISSON_TEXT("Make one with: glisson-cli import STUDY --case NAME.glisson"),
                       folder});
}

}  // namespace
}  // namespace glisson::casefile
