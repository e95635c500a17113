#pragma once
// The voxels of a series that scan() found.

#include "base/progress.h"
#include "base/result.h"
#include "imaging/image.h"
#include "imaging/study.h"

namespace glisson::imaging {

// One volume of a series (0 .. series.volumes - 1), on series.grid, with rescale and real-world-value mapping applied
// and its unit as series.unit says. Slices are decoded one by one into the volume, on all threads: never more than
// one copy of it is held. Values that are no numbers (NaN in float pixels) become 0. Where a slice is missing or the
// spacing is uneven, the values in between are interpolated linearly along the normal, as series.problems says.
//
// Fails, naming the file, when one has vanished, shrunk or changed since the scan ("file-not-readable",
// "dicom-truncated", "dicom-changed"). Fails when its pixels cannot be decoded ("dicom-pixels-damaged",
// "dicom-compression-unknown") or hold colour ("dicom-colour"). Fails with "cancelled".
[[nodiscard]] Result<Volume> read_series(const Series& series, int volume = 0, const Progress& progress = {});

}  // namespace glisson::imaging
