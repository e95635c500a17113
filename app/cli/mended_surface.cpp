#include "mended_surface.h"

#include "geometry/mesh_file.h"
#include "shared_options.h"

namespace glisson::cli {

Result<MendedFile> read_mended(const std::filesystem::path& file, geometry::Pieces pieces) {
  auto given = geometry::read_surface(file);
  if (!given) return failure(std::move(given.error()));
  auto mended = geometry::mended(*given, pieces);
  if (!mended) return failure(std::move(mended.error()).in_file(file));
  MendedFile read{*std::move(given), *std::move(mended), {}};
  for (const Sentence& remark : read.mended.remarks) {
    read.notes.push_back(file.filename().string() + ": " + remark.message());
  }
  return read;
}

void tell_mending(const MendedFile& file, Outcome& outcome) {
  for (const std::string& note : file.notes) outcome.document["notes"].push_back(note);
  outcome.text += bullet_list(file.notes);
}

}  // namespace glisson::cli
