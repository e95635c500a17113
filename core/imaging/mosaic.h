#pragma once
// Siemens' mosaics: all slices of a volume as tiles of one large picture.

#include <optional>
#include <string_view>
#include <vector>

#include "imaging/internal/dicom_image.h"

class DcmItem;

namespace glisson::imaging {

// What Siemens' private header says of a mosaic.
struct MosaicFacts {
  int tiles = 0;
  std::optional<Eigen::Vector3d> normal;  // from the first tile to the last
  std::vector<double> times_ms;           // when each tile was acquired, after the first; empty where not given
};

// Reads the CSA image header (private (0029,xx10), format "SV10"): NumberOfImagesInMosaic and SliceNormalVector; and,
// without it, (0019,xx0a). The times are (0019,xx29), MosaicRefAcqTimes. Nothing when they say nothing.
[[nodiscard]] std::optional<MosaicFacts> mosaic_facts(DcmItem& data_set);
[[nodiscard]] std::optional<MosaicFacts> mosaic_facts_in_csa_header(std::string_view csa_header);

// The tiles as pictures of their own, given the mosaic as one picture. The tiles lie in a square, row by row. Siemens
// writes the position that the first slice would have if it were as large as the whole mosaic, about the same centre.
// So the first tile begins half the difference of the sizes further in. The next slices follow along the normal.
// Nothing when the square does not divide the picture.
[[nodiscard]] std::optional<std::vector<Picture>> unpack_mosaic(const Picture& mosaic, const MosaicFacts& facts,
                                                                double slice_spacing_mm);

}  // namespace glisson::imaging
