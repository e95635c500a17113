#pragma once
// The named structures of a liver: their usual colours, what lies inside the organ, and how masks become one label map.

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "imaging/image.h"

namespace glisson::segmentation {

struct Structure {
  std::string name;                                // "liver", "tumour-1", "portal-vein", ...
  std::array<double, 3> color_rgb{0.9, 0.4, 0.3};  // sRGB, each 0..1
  imaging::Mask mask;
};

// Where a structure belongs with respect to the liver.
enum class Place { liver, inside, beside, unknown };

// What is known of a structure by its name, with or without a number or a side at the end ("tumour-2", "kidney-left").
// The names are "liver", "tumour", "cyst", "portal-vein", "hepatic-vein", "artery", "biliary-tract", "gallbladder",
// "gastric-vein" and a few organs around. Vessels count as inside, since their greater part runs in the liver. The
// colours are those of 3D Slicer's table GenericAnatomyColors; an unknown name gets that table's grey-blue for
// "unknown".
struct KnownStructure {
  std::array<double, 3> color_rgb;
  Place place;
};
[[nodiscard]] KnownStructure known_structure(std::string_view name);

// The names that known_structure knows, without numbers, for a list to choose from.
[[nodiscard]] std::vector<std::string> known_structure_names();

// A structure with the colour that goes with its name.
[[nodiscard]] Structure make_structure(std::string name, imaging::Mask mask);

// What a label map is made of.
enum class Extent {
  liver,  // the liver and, cut to it, what lies inside: what is meshed
  all     // every voxel of every structure: what is exported
};

struct ComposedLabels {
  imaging::LabelMap labels;
  std::vector<std::string> names;  // names[label - 1]; the liver, where there is one, is label 1
};

// One label map of several masks. The liver is label 1 and gives way to all others. Where two others share a voxel the
// smaller structure wins, so that a small tumour at a vessel is not lost. The remaining labels follow the order given.
// A structure that keeps no voxel still has its label. Fails with labels-no-structures, labels-grids-differ,
// labels-no-liver (Extent::liver) and labels-liver-empty.
Result<ComposedLabels> compose_labels(const std::vector<Structure>& structures, Extent extent);

// The voxels with one label, or with any.
[[nodiscard]] imaging::Mask mask_of_label(const imaging::LabelMap& labels, int label);
[[nodiscard]] imaging::Mask mask_of_any_label(const imaging::LabelMap& labels);

[[nodiscard]] std::size_t voxel_count(const imaging::Mask& mask);
[[nodiscard]] double volume_ml(const imaging::Mask& mask);

// Dice's overlap 2 |A and B| / (|A| + |B|): 1 the same, 0 apart; two empty masks are the same. Fails with
// masks-grids-differ.
Result<double> dice(const imaging::Mask& a, const imaging::Mask& b);

// A piece that hangs together by faces, edges or corners of voxels (26 neighbours).
struct Piece {
  std::size_t voxels = 0;
  double volume_ml = 0;
  Eigen::Vector3d centroid_mm{0, 0, 0};  // patient LPS
  bool touches_border = false;           // of the image: the structure is probably cut
};

// The pieces of a mask, the largest first (equal ones in the order of their first voxel).
[[nodiscard]] std::vector<Piece> pieces(const imaging::Mask& mask);

}  // namespace glisson::segmentation
