#pragma once
// Real livers with their vessels as somebody outlined them (shared data, livers_couinaud), and grey values over them as
// of the portal-venous phase: simulated, blurred and noisy.

#include <random>
#include <string>

#include "imaging/filters.h"
#include "imaging/volume_file.h"
#include "segmentation/structures.h"
#include "support/data.h"

namespace glisson::segmentation {

inline imaging::Mask drawn_mask(const std::string& liver, const char* what) {
  const auto file = test::shared_data() / "livers_couinaud" / (liver + "_" + what + ".nii.gz");
  return mask_of_label(imaging::read_labels_file(file).value(), 1);
}

inline imaging::Volume simulated_ct(const imaging::Mask& liver, const imaging::Mask& vessels) {
  imaging::Volume image{{vessels.grid, std::vector<float>(vessels.values.size())}, "HU"};
  std::mt19937 random(7);
  std::normal_distribution<float> noise(0, 18);
  for (std::size_t n = 0; n < image.values.size(); ++n) {
    image.values[n] = vessels.values[n] != 0 ? 175.0F : liver.values[n] != 0 ? 108.0F : 40.0F;
  }
  image.values = imaging::gaussian_blur(std::move(image.values), image.grid, 0.7);
  for (float& value : image.values) value += noise(random);
  return image;
}

}  // namespace glisson::segmentation
