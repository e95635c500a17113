#include "casefile/internal/new_case.h"

#include <system_error>

#include "casefile/internal/folder_lock.h"

namespace glisson::casefile {
namespace fs = std::filesystem;
namespace {

Failure not_made(const fs::path& folder, const std::error_code& problem) {
  return failure(Error{"case-not-writable",
                       GLISSON_TEXT("The folder {0} cannot be made: {1}."),
                       {folder.string(), problem.message()},
                       {},
                       folder});
}

}  // namespace

Result<Case> make_case(const fs::path& folder, const std::function<Result<void>(Case&)>& fill) {
  std::error_code problem, ignored;
  const fs::path whole = fs::absolute(folder, problem).lexically_normal();
  const fs::path place = whole.has_filename() ? whole : whole.parent_path();
  if (fs::exists(place, problem) && !(fs::is_directory(place, problem) && fs::is_empty(place, problem))) {
    return Case::create(folder);  // which says that it is there already
  }
  const fs::path workshop = place.parent_path() / (".part-" + place.filename().string());
  fs::create_directories(workshop, problem);
  if (problem) return not_made(folder, problem);
  const FolderLock lock(workshop, FolderLock::Wait::not_at_all);
  if (lock.taken()) {
    return failure(Error{"case-being-made",
                         GLISSON_TEXT("{0} is being made by another program."),
                         {folder.string()},
                         GLISSON_TEXT("Wait until it has finished, or choose another name."),
                         folder});
  }
  const fs::path beside = workshop / place.filename();
  fs::remove_all(beside, ignored);  // of one that was killed
  auto outcome = Case::create(beside).and_then([&](Case made) { return fill(made); });
  if (outcome) {
    fs::rename(beside, place, problem);
    if (problem) outcome = not_made(folder, problem);
  }
  fs::remove_all(workshop, ignored);
  return outcome.and_then([&] { return Case::open(folder); });
}

}  // namespace glisson::casefile
