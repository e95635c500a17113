#include "casefile/history.h"

#include <algorithm>
#include <set>
#include <system_error>
#include <utility>

#include "base/files.h"
#include "base/folder_contents.h"
#include "base/json.h"
#include "casefile/internal/case_links.h"
#include "casefile/internal/entry_record.h"
#include "casefile/internal/folder_lock.h"
#include "casefile/internal/history_journal.h"

namespace glisson::casefile {
namespace fs = std::filesystem;
namespace {

Towards towards(bool before) { return before ? Towards::before : Towards::after; }

std::string content_of(const std::optional<Entry>& entry) { return entry ? entry->sha256 : std::string(); }

std::optional<Entry> find(const std::vector<Entry>& entries, const std::string& id) {
  const auto found = std::find_if(entries.begin(), entries.end(), [&](const Entry& entry) { return entry.id == id; });
  return found == entries.end() ? std::nullopt : std::optional(*found);
}

}  // namespace

struct History::Impl {
  Impl(fs::path of_case, HistoryCaps limits)
      : case_folder(std::move(of_case)),
        folder(case_folder / "history"),
        caps(limits),
        kept(folder / "kept"),
        in_use(made(folder), FolderLock::Wait::not_at_all) {}

  static const fs::path& made(const fs::path& folder) {
    std::error_code ignored;
    fs::create_directories(folder / "steps", ignored);
    return folder;
  }
  [[nodiscard]] fs::path journal_file() const { return folder / "journal.json"; }
  [[nodiscard]] fs::path begun_file() const { return folder / "begun.json"; }
  [[nodiscard]] fs::path step_file(int number) const { return file_of_step(case_folder, number); }
  [[nodiscard]] fs::path runs_file(int number, const std::string& id) const {
    return file_of_runs(case_folder, number, id);
  }

  Result<void> take_up();
  Result<void> begin(const Sentence& name, const std::vector<std::string>& touches);
  Result<void> finish();
  [[nodiscard]] Result<std::vector<EntryChange>> changes_since(const BegunStep& begun,
                                                               std::vector<std::string>& needed) const;
  Result<Moved> move(const Step& step, Side to);
  Result<Moved> move_entries(const Step& step, Side to);
  Failure overtaken(const std::string& what);
  Result<void> append(Listing next, Step step);
  Result<void> install(Listing next);
  Result<void> forget_all();
  void forget_beyond_caps(Listing& next) const;
  void sweep() const;

  fs::path case_folder, folder;
  HistoryCaps caps;
  KeptFiles kept;
  FolderLock in_use;
  Listing listing;
  mutable std::mutex telling;  // held while the listing is replaced, or read beside a change
};

History::History(std::unique_ptr<Impl> parts) : impl_(std::move(parts)) {}
History::~History() = default;

Result<std::unique_ptr<History>> History::open(const fs::path& case_folder, HistoryCaps caps) {
  if (auto there = Case::open(case_folder); !there) return failure(there.error());
  for (const char* file : {"history/steps/1.json", "history/kept/session.json"}) {
    if (auto inside = refuse_links(case_folder, file); !inside) return failure(std::move(inside.error()));
  }
  auto parts = std::make_unique<Impl>(case_folder, caps);
  if (parts->in_use.taken()) {
    return failure(Error{"history-in-use",
                         GLISSON_TEXT("{0} is open in another window: what is done here cannot be undone."),
                         {case_folder.string()},
                         GLISSON_TEXT("Close the other window, then open the case anew."),
                         case_folder});
  }
  if (auto taken_up = parts->take_up(); !taken_up) {
    if (taken_up.error().code != "history-damaged") return failure(taken_up.error());
    std::error_code ignored;
    const fs::path aside = case_folder / "history.damaged";
    fs::remove_all(aside, ignored);
    fs::rename(parts->folder, aside, ignored);
    parts = std::make_unique<Impl>(case_folder, caps);
  }
  return std::unique_ptr<History>(new History(std::move(parts)));
}

Result<void> History::record(const Sentence& name, const std::function<Result<void>()>& change,
                             const std::vector<std::string>& touches) {
  const std::lock_guard one_at_a_time(changing_);
  if (auto begun = impl_->begin(name, touches); !begun) return begun;
  Result<void> outcome;
  try {
    outcome = change();
  } catch (...) {
    (void)impl_->finish();
    throw;
  }
  auto finished = impl_->finish();
  return outcome ? finished : outcome;
}

Result<void> History::record_values(const Sentence& name, const std::vector<ValueChange>& values, Joins joins,
                                    const std::optional<RecordingBeside>& beside) {
  const std::lock_guard one_at_a_time(changing_);
  std::vector<std::string> kept;
  if (beside) {
    const fs::path file = file_of_session(impl_->case_folder, beside->session);
    if (auto written = write_text_file(file, beside->text); !written) return written;
    kept.push_back(file.filename().string());
  }
  Listing next = impl_->listing;
  for (const ValueChange& value : values) next.values[value.key] = value.after;
  if (joins == Joins::last_of_same_keys && next.done > 0 && next.done == next.steps.size()) {
    Step& last = next.steps.back();
    const bool same = std::equal(last.values.begin(), last.values.end(), values.begin(), values.end(),
                                 [](const ValueChange& a, const ValueChange& b) { return a.key == b.key; });
    if (same && !values.empty()) {
      for (std::size_t k = 0; k < values.size(); ++k) last.values[k].after = values[k].after;
      last.kept.insert(last.kept.end(), kept.begin(), kept.end());
      return impl_->install(std::move(next));
    }
  }
  return impl_->append(std::move(next), Step{0, name, values, std::move(kept)});
}

std::string History::value_of(const std::string& key) const {
  const std::lock_guard reading(impl_->telling);
  const auto found = impl_->listing.values.find(key);
  return found == impl_->listing.values.end() ? std::string() : found->second;
}

std::optional<Sentence> History::undo_name() const {
  const std::lock_guard reading(impl_->telling);
  const Listing& listing = impl_->listing;
  return listing.done > 0 ? std::optional(listing.steps[listing.done - 1].name) : std::nullopt;
}

std::optional<Sentence> History::redo_name() const {
  const std::lock_guard reading(impl_->telling);
  const Listing& listing = impl_->listing;
  return listing.done < listing.steps.size() ? std::optional(listing.steps[listing.done].name) : std::nullopt;
}

Result<History::Moved> History::undo() {
  const std::lock_guard one_at_a_time(changing_);
  const Listing& listing = impl_->listing;
  if (listing.done == 0) return failure("history-nothing-left", GLISSON_TEXT("There is nothing left to undo."));
  return impl_->move(Step(listing.steps[listing.done - 1]), Side::before);
}

Result<History::Moved> History::redo() {
  const std::lock_guard one_at_a_time(changing_);
  const Listing& listing = impl_->listing;
  if (listing.done == listing.steps.size()) {
    return failure("history-nothing-left", GLISSON_TEXT("There is nothing left to redo."));
  }
  return impl_->move(Step(listing.steps[listing.done]), Side::after);
}

std::size_t History::steps_to_undo() const {
  const std::lock_guard reading(impl_->telling);
  return impl_->listing.done;
}

std::size_t History::steps_to_redo() const {
  const std::lock_guard reading(impl_->telling);
  return impl_->listing.steps.size() - impl_->listing.done;
}

std::uintmax_t History::disk_bytes() const {
  std::uintmax_t bytes = 0;
  std::error_code ignored;
  std::error_code unreadable;
  for (fs::recursive_directory_iterator file(impl_->folder, unreadable), end; !unreadable && file != end;
       file.increment(unreadable)) {
    if (file->is_regular_file(ignored)) bytes += file->file_size(ignored);
  }
  return bytes;
}

// What a kill may have left: a change under way, an undo under way, files that no step names.
Result<void> History::Impl::take_up() {
  std::error_code ignored;
  auto read = read_listing(case_folder);
  if (!read) return failure(std::move(read.error()));
  listing = *std::move(read);
  if (auto finished = finish(); !finished) return finished;
  if (listing.moving) {
    const auto [number, to] = *listing.moving;
    const auto step = std::find_if(listing.steps.begin(), listing.steps.end(),
                                   [number = number](const Step& each) { return each.number == number; });
    if (step == listing.steps.end()) return history_damaged(journal_file());
    const auto changes = read_changes(step_file(number));
    if (!changes) return failure(changes.error());
    const auto now = Case::open(case_folder);
    if (!now) return failure(now.error());
    Listing next = listing;
    next.moving.reset();
    const bool arrived = std::all_of(changes->begin(), changes->end(), [&, to = to](const EntryChange& change) {
      return content_of(find(now->entries(), change.id)) ==
             content_of(to == Side::before ? change.sides.before : change.sides.after);
    });
    const bool at_before = arrived == (to == Side::before);
    if (auto brought = bring_followed(case_folder, kept, step->followed, towards(at_before)); !brought) return brought;
    if (arrived) next.done = to == Side::before ? listing.done - 1 : listing.done + 1;
    if (next.done > next.steps.size()) return history_damaged(journal_file());
    if (auto installed = install(std::move(next)); !installed) return installed;
  }
  sweep();
  return {};
}

Result<void> History::Impl::begin(const Sentence& name, const std::vector<std::string>& touches) {
  const auto before = Case::open(case_folder);
  if (!before) return failure(before.error());
  BegunStep begun{listing.next, name, touches, {}, {}};
  for (const Entry& entry : before->entries()) {
    if (!touches.empty() && std::find(touches.begin(), touches.end(), entry.id) == touches.end()) continue;
    std::error_code ignored;
    if (fs::exists(case_folder / entry.file, ignored)) {
      if (auto held = kept.keep(case_folder, entry); !held) return held;
    }
    begun.entries.push_back(entry);
  }
  if (touches.empty()) {
    begun.followed = followed_files(case_folder);
    if (auto held = keep_followed(case_folder, kept, *begun.followed); !held) return held;
  }
  return write_json_file(begun_file(), json_of(begun));
}

// Makes a step of what has changed since begin(), by this program or, after a kill, by the one before.
Result<void> History::Impl::finish() {
  std::error_code ignored;
  if (!fs::exists(begun_file(), ignored)) return {};
  const auto begun = read_begun_step(begun_file());
  if (!begun) return failure(begun.error());
  Step step{begun->number, begun->name, {}, {}};
  const auto changes = changes_since(*begun, step.kept);
  if (!changes) return failure(changes.error());
  if (begun->followed) step.followed = changes_between(*begun->followed, followed_files(case_folder));
  for (const FileChange& change : step.followed) {
    for (const std::string& content : {change.before, change.after}) {
      if (!content.empty()) step.kept.push_back(kept.place_of(entry_for(change.file, content)).filename().string());
    }
  }
  if (begun->number == listing.next && !(changes->empty() && step.followed.empty())) {
    if (auto written = write_json_file(step_file(begun->number), json_of(*changes)); !written) return written;
    if (auto appended = append(listing, std::move(step)); !appended) return appended;
  }
  fs::remove(begun_file(), ignored);
  sweep();
  return {};
}

// `needed` gets the names of the kept files that lead back and forth.
Result<std::vector<EntryChange>> History::Impl::changes_since(const BegunStep& begun,
                                                              std::vector<std::string>& needed) const {
  const auto now = Case::open(case_folder);
  if (!now) return failure(now.error());
  std::set<std::string> ids(begun.touches.begin(), begun.touches.end());
  for (const Entry& entry : begun.entries) ids.insert(entry.id);
  if (begun.touches.empty()) {
    for (const Entry& entry : now->entries()) ids.insert(entry.id);
  }
  std::vector<EntryChange> changes;
  for (const std::string& id : ids) {
    EntryChange change{id, {find(begun.entries, id), find(now->entries(), id)}, {}};
    const auto& [was, is] = change.sides;
    if (!was && !is) continue;
    if (was && is && record_of(*was) == record_of(*is)) continue;
    auto content = difference_of(case_folder, kept, change.sides, runs_file(begun.number, id));
    if (!content) return failure(content.error());
    change.content = std::move(*content);
    if (is_whole_file(change.content)) {
      for (const auto& side : {was, is}) {
        if (side) needed.push_back(kept.place_of(*side).filename().string());
      }
    }
    changes.push_back(std::move(change));
  }
  return changes;
}

Result<void> History::Impl::append(Listing next, Step step) {
  next.steps.resize(next.done);
  step.number = next.next++;
  next.steps.push_back(std::move(step));
  next.done = next.steps.size();
  forget_beyond_caps(next);
  return install(std::move(next));
}

Result<History::Moved> History::Impl::move(const Step& step, Side to) {
  if (step.values.empty()) return move_entries(step, to);
  Moved moved{step.name, {}, {}};
  Listing next = listing;
  for (const ValueChange& value : step.values) {
    const bool back = to == Side::before;
    moved.values.push_back({value.key, back ? value.after : value.before, back ? value.before : value.after});
    next.values[value.key] = moved.values.back().after;
  }
  next.done += to == Side::before ? std::size_t(-1) : 1;
  if (auto installed = install(std::move(next)); !installed) return failure(installed.error());
  return moved;
}

Result<History::Moved> History::Impl::move_entries(const Step& step, Side to) {
  auto now = Case::open(case_folder);
  if (!now) return failure(now.error());
  const auto changes = read_changes(step_file(step.number));
  if (!changes) return failure(changes.error());
  Moved moved{step.name, {}, {}};
  const FollowedFiles followed = followed_files(case_folder);
  for (const FileChange& change : step.followed) {
    const auto there = followed.find(change.file);
    const std::string content = there == followed.end() ? std::string() : there->second;
    if (content != change.before && content != change.after) return overtaken(change.file);
    moved.entries.push_back(change.file);
  }
  try {
    std::vector<Replacement> replacements;
    for (const EntryChange& change : *changes) {
      const bool back = to == Side::before;
      const std::optional<Entry>& from = back ? change.sides.after : change.sides.before;
      const std::optional<Entry>& target = back ? change.sides.before : change.sides.after;
      const auto present = find(now->entries(), change.id);
      const bool as_left = content_of(present) == content_of(from) &&
                           (!from || sha256_of_file(case_folder / from->file).value_or("") == from->sha256);
      if (!as_left) return overtaken(change.id);
      if (from && is_whole_file(change.content)) {
        if (auto held = kept.keep(case_folder, *from); !held) return failure(held.error());
      }
      moved.entries.push_back(change.id);
      replacements.push_back({change.id, target, [this, &step, &change, from, target](const fs::path& file) {
                                return write_other_side(case_folder, kept, change.content, from, *target,
                                                        runs_file(step.number, change.id), file);
                              }});
    }
    Listing next = listing;
    next.moving = {step.number, to};
    if (auto installed = install(next); !installed) return failure(installed.error());
    const bool back = to == Side::before;
    auto replaced = keep_followed(case_folder, kept, followed).and_then([&] {
      return bring_followed(case_folder, kept, step.followed, towards(back));
    });
    if (replaced) replaced = now->replace(replacements);
    if (!replaced) (void)bring_followed(case_folder, kept, step.followed, towards(!back));
    next.moving.reset();
    if (replaced) next.done += to == Side::before ? std::size_t(-1) : 1;
    if (auto installed = install(std::move(next)); !installed) return failure(installed.error());
    if (!replaced) return failure(replaced.error());
  } catch (const Json::exception&) {
    return history_damaged(step_file(step.number));
  }
  sweep();
  return moved;
}

// All is forgotten: what came before rests on contents that are no longer there.
Failure History::Impl::overtaken(const std::string& what) {
  if (auto forgotten = forget_all(); !forgotten) return failure(forgotten.error());
  return failure(Error{"history-overtaken",
                       GLISSON_TEXT("{0} has been changed by something else since: what was done before cannot be "
                                    "undone any more."),
                       {what},
                       {},
                       case_folder});
}

Result<void> History::Impl::install(Listing next) {
  if (auto written = write_json_file(journal_file(), json_of(next)); !written) return written;
  const std::lock_guard writing(telling);
  listing = std::move(next);
  return {};
}

Result<void> History::Impl::forget_all() {
  Listing empty;
  empty.next = listing.next;
  empty.values = listing.values;
  empty.forgotten = true;
  auto installed = install(std::move(empty));
  sweep();
  return installed;
}

// The newest step stays, even where it alone takes more than the cap.
void History::Impl::forget_beyond_caps(Listing& next) const {
  std::map<std::string, std::uintmax_t> kept_bytes;
  std::map<int, std::uintmax_t> step_bytes;
  std::error_code ignored;
  for (const fs::path& file : contents_of(folder / "kept")) {
    kept_bytes[file.filename().string()] = fs::file_size(file, ignored);
  }
  for (const fs::path& file : contents_of(folder / "steps")) {
    step_bytes[std::atoi(file.filename().c_str())] += fs::file_size(file, ignored);
  }
  // From the newest on: the first that does not fit ends it.
  std::uintmax_t bytes = 0;
  std::size_t fitting = 0;
  std::set<std::string> counted;
  for (auto step = next.steps.rbegin(); step != next.steps.rend(); ++step, ++fitting) {
    bytes += step_bytes[step->number];
    for (const std::string& name : step->kept) bytes += counted.insert(name).second ? kept_bytes[name] : 0;
    if (fitting > 0 && (bytes > caps.disk_bytes || fitting >= caps.steps)) break;
  }
  const std::size_t forgotten = next.steps.size() - fitting;
  next.steps.erase(next.steps.begin(), next.steps.begin() + static_cast<std::ptrdiff_t>(forgotten));
  next.done -= forgotten;
  next.forgotten = next.forgotten || forgotten > 0;
}

// Files that no step needs go.
void History::Impl::sweep() const {
  std::set<std::string> needed;
  std::set<int> numbers;
  for (const Step& step : listing.steps) {
    needed.insert(step.kept.begin(), step.kept.end());
    numbers.insert(step.number);
  }
  std::error_code ignored;
  std::vector<fs::path> leaving;
  for (const fs::path& file : contents_of(folder / "kept")) {
    if (needed.count(file.filename().string()) == 0) leaving.push_back(file);
  }
  for (const fs::path& file : contents_of(folder / "steps")) {
    if (numbers.count(std::atoi(file.filename().c_str())) == 0) leaving.push_back(file);
  }
  for (const fs::path& file : leaving) fs::remove(file, ignored);
}

}  // namespace glisson::casefile
