#pragma once
// The pictures of one DICOM series, parted into stacks of parallel slices and each stack into its volumes. Inside this
// room only.

#include <string>
#include <vector>

#include "imaging/internal/dicom_image.h"

namespace glisson::imaging {

// A picture of a series: of which file, and which of its pictures.
struct PictureRef {
  std::size_t image = 0;
  std::size_t picture = 0;
};

// Pictures of one size, orientation and kind, whose positions along the normal leave no wide gap.
struct Stack {
  std::vector<PictureRef> pictures;
  std::string kind;  // what may tell it from the others of the series: "echo 2", "phase"; may be empty
};

// The first stack is the one with most pictures. A series with more kinds of picture than any real one is no series of
// slices: what goes beyond 512 kinds is left out.
struct Stacks {
  std::vector<Stack> stacks;  // at least one for a series with pictures
  std::size_t pictures_left_out = 0;
};
[[nodiscard]] Stacks part_into_stacks(const std::vector<DicomImage>& images);

// The volumes of one stack: pictures at the same positions. What tells them apart is a header field with as many values
// as there are pictures at each position. Where there is none, it is their order of acquisition.
struct Volumes {
  std::vector<double> positions_mm;                // along the normal, ascending
  std::vector<std::vector<PictureRef>> of_volume;  // [volume][position]
  std::vector<std::string> labels;                 // one a volume where there are several
  std::vector<std::string> problems;               // doubled pictures, incomplete volumes
};
[[nodiscard]] Volumes part_into_volumes(const std::vector<DicomImage>& images, const Stack& stack);

// Where a picture stands along the normal of its own plane.
[[nodiscard]] double position_along_normal_mm(const Picture& picture);

[[nodiscard]] inline const Picture& picture_of(const std::vector<DicomImage>& images, const PictureRef& ref) {
  return images[ref.image].pictures[ref.picture];
}

// "IM_0004.dcm", or "enhanced.dcm, frame 7".
[[nodiscard]] std::string name_of(const std::vector<DicomImage>& images, const PictureRef& ref);

}  // namespace glisson::imaging
