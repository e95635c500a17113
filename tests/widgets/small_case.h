#pragma once
// A case for tests of the window: an image of 64 x 56 x 24 voxels with a bright ball as the liver, outlined.

#include <QtGlobal>

#include "casefile/structures.h"
#include "imaging/volume_file.h"
#include "segmentation/edit.h"

namespace glisson::widgets::test {

namespace fs = std::filesystem;

inline imaging::Grid small_grid() {
  imaging::Grid grid;
  grid.size = {64, 56, 24};
  grid.spacing_mm = {1.5, 1.5, 3};
  grid.origin_mm = {-40, -30, 100};
  return grid;
}
inline Eigen::Vector3d small_middle_mm() { return small_grid().position_mm(Eigen::Vector3d(31, 27, 11)); }

inline imaging::Mask ball_mask(double radius_mm) {
  imaging::Mask mask{small_grid(), std::vector<std::uint8_t>(small_grid().voxels())};
  return segmentation::paint(std::move(mask), {small_middle_mm(), radius_mm});
}

inline Result<void> save_ball(const fs::path& folder, const std::string& name, double radius_mm) {
  auto opened = casefile::Case::open(folder);
  if (!opened) return failure(opened.error());
  return casefile::save_structure(*opened, segmentation::make_structure(name, ball_mask(radius_mm)),
                                  {"segment", {}, {"volumes/anatomy"}, {}, {}})
      .map([](const auto&) {});
}

inline std::size_t voxels_of(const fs::path& folder, const std::string& name) {
  const auto opened = casefile::Case::open(folder);
  const auto file = opened->file_of("labels/" + name);
  return file ? segmentation::voxel_count(imaging::read_mask_file(*file)->mask) : 0;
}

// The folder of the case, made within `parent`. The image is 40 outside and 100 in a ball of 16 mm, the liver a ball
// of 12 mm in it.
inline fs::path small_case(const fs::path& parent) {
  const fs::path folder = parent / "small.glisson";
  auto made = casefile::Case::create(folder);
  imaging::Volume volume;
  volume.grid = small_grid();
  for (const std::uint8_t inside : ball_mask(16).values) volume.values.push_back(inside != 0 ? 100.0F : 40.0F);
  auto added = made->add("volumes/anatomy", ".nrrd", {"import", {}, {}, {}, {}},
                         [&](const fs::path& file) { return imaging::write_volume_file(file, volume); });
  if (!added || !save_ball(folder, "liver", 12)) qFatal("no case for the test");
  return folder;
}

}  // namespace glisson::widgets::test
