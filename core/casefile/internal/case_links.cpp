#include "casefile/internal/case_links.h"

#include <system_error>

namespace glisson::casefile {
namespace fs = std::filesystem;

Result<void> refuse_links(const fs::path& case_folder, const fs::path& file) {
  fs::path place = case_folder;
  std::error_code problem;
  for (const fs::path& part : file.parent_path()) {
    place /= part;
    if (!fs::is_symlink(fs::symlink_status(place, problem))) continue;
    return failure(Error{"case-link",
                         GLISSON_TEXT("{0} is a link to another place, where nothing is written."),
                         {place.string()},
                         GLISSON_TEXT("Put the folder itself there."),
                         place});
  }
  return {};
}

Result<void> refuse_links_on_the_way_to(const fs::path& folder) {
  std::error_code problem;
  const fs::path whole = fs::absolute(folder, problem).lexically_normal();
  for (fs::path above = whole.parent_path(); above.has_relative_path(); above = above.parent_path()) {
    if (!fs::exists(above / "case.json", problem)) continue;
    if (auto inside = refuse_links(above, whole.lexically_relative(above) / "file"); !inside) return inside;
  }
  return {};
}

}  // namespace glisson::casefile
