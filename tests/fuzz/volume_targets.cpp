// Volumes in every format that is read, packed and not. Seeds come from our own writer.

#include <zlib.h>
#include <cmath>

#include "base/files.h"
#include "fuzz/target.h"
#include "imaging/volume_file.h"

namespace glisson::fuzz {
namespace {

namespace fs = std::filesystem;

imaging::Volume small_volume() {
  imaging::Volume volume;
  volume.grid.size = {6, 5, 4};
  volume.grid.spacing_mm = {1.5, 2.0, 4.0};
  volume.grid.origin_mm = {-31.25, 12.5, -208.0};
  for (std::size_t i = 0; i < volume.grid.voxels(); ++i) {
    volume.values.push_back(static_cast<float>(i * i * 7919 % 251));
  }
  return volume;
}

Target volumes(const std::string& extension) {
  const auto seeds = [=](const fs::path& folder) {
    const fs::path file = folder / ("good" + extension);
    promise(bool(imaging::write_volume_file(file, small_volume())), "a volume is written");
    return std::vector<std::string>{read_text_file(file).value()};
  };
  const auto run = [=](const std::string& bytes, const fs::path& folder) {
    const fs::path file = file_of(bytes, folder, "broken" + extension);
    const auto volume = imaging::read_volume_file(file);
    if (!volume) return promise(!volume.error().message().empty(), "a refusal says why");
    promise(volume->values.size() == volume->grid.voxels(), "a value a voxel");
    promise(volume->grid.direction.allFinite() && volume->grid.origin_mm.allFinite(), "a grid in a place");
    promise((volume->grid.spacing_mm.array() > 0).all(), "a spacing above zero");
    static_cast<void>(imaging::read_labels_file(file));
    static_cast<void>(imaging::read_mask_file(file));
  };
  return {extension.substr(1), seeds, run};
}

// Broken, and packed then: else the checksum refuses nearly all.
Target packed_volumes() {
  Target whole = volumes(".nii");
  const auto packed = [](const std::string& bytes) {
    std::string stream(compressBound(uLong(bytes.size())) + 64, '\0');
    z_stream state{};
    promise(deflateInit2(&state, 1, Z_DEFLATED, 15 + 16, 8, Z_DEFAULT_STRATEGY) == Z_OK, "a packer begins");
    state.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
    state.avail_in = uInt(bytes.size());
    state.next_out = reinterpret_cast<Bytef*>(stream.data());
    state.avail_out = uInt(stream.size());
    promise(deflate(&state, Z_FINISH) == Z_STREAM_END, "all of it is packed");
    stream.resize(state.total_out);
    deflateEnd(&state);
    return stream;
  };
  const auto run = [packed, read = volumes(".nii.gz").run](const std::string& bytes, const fs::path& folder) {
    read(packed(bytes), folder);
  };
  return {"packed-nii", whole.seeds, run};
}

}  // namespace

std::vector<Target> targets() {
  return {volumes(".nii"), volumes(".nii.gz"), packed_volumes(), volumes(".nrrd"), volumes(".mha")};
}

}  // namespace glisson::fuzz
