#pragma once
// A label map made ready for meshing: the body taken out of its image, whole, and cut into pieces that hang together.

#include <cstdint>
#include <string>
#include <vector>

#include "base/result.h"
#include "base/sentence.h"
#include "imaging/image.h"

namespace glisson::meshing {

// What hangs together by voxel faces and has one label.
struct Piece {
  std::uint16_t label = 0;
  std::int64_t voxels = 0;
  double volume_mm3 = 0;
  double face_area_mm2 = 0;  // of the voxel faces towards other pieces and the outside

  // About the radius of a long piece, two thirds of the radius of a round one. A cylinder has volume/area = r/2 and a
  // sphere r/3. Voxel faces have 1.5 times the area of a smooth surface, on average over its directions.
  [[nodiscard]] double thickness_mm() const { return 3.0 * volume_mm3 / face_area_mm2; }
};

struct PieceMap {
  imaging::Grid grid;                // the part of the image that holds the body, and `margin` voxels around it
  std::vector<std::uint16_t> piece;  // a voxel: 0 outside, else 1 + the index of its piece
  std::vector<Piece> pieces;         // the first is the largest piece of the largest label: the liver itself
  std::vector<Sentence> notes;       // one sentence each, on what was left out, filled or cut

  static constexpr int margin = 4;
};

// How a label is called in notes: "tumour-1 (label 3)", or "label 3" where it has no name.
struct LabelName {
  std::uint16_t label = 0;
  std::string name;
};

struct PieceOptions {
  std::vector<LabelName> names = {};
  // Fewer voxels than this are a speck left by the segmentation, and become part of what they touch most.
  int speck_voxels = 8;
};

// All labels other than 0 together are the body; its largest part is kept, and closed by a flat cap where the image
// cuts it. Holes without a label inside it are given to the liver. Fails with labels-empty, labels-grid.
Result<PieceMap> find_pieces(const imaging::LabelMap& labels, const PieceOptions& options);

// Makes a piece other than the first a part of the piece which it shares the largest area with.
void dissolve_piece(PieceMap& map, std::size_t piece);

[[nodiscard]] std::string display_name(std::uint16_t label, const std::vector<LabelName>& names);

}  // namespace glisson::meshing
