#pragma once
// From the headers of one DICOM series to the Series that people see.

#include <vector>

#include "imaging/internal/dicom_image.h"
#include "imaging/study.h"

namespace glisson::imaging {

// All with the same SeriesInstanceUID; at least one. One Series for each stack in it.
[[nodiscard]] std::vector<Series> assemble_series(std::vector<DicomImage> images);

}  // namespace glisson::imaging
