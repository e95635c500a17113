#pragma once
// From stored pixels to what they measure: rescale, real-world-value mapping and units.

#include <string>

#include "imaging/internal/dicom_image.h"

class DcmItem;

namespace glisson::imaging {

// The mapping that one functional group (or the data set of a classic image) states. A real-world-value mapping wins
// over a rescale when its unit is one that we know. It is the one that was written for measuring (PS3.3 C.7.6.16.2.11).
// Of several, the first with a known unit wins. Tables are not applied: then `stated` stays false.
[[nodiscard]] ValueMapping rescale_of(DcmItem& item);
[[nodiscard]] ValueMapping real_world_mapping_of(DcmItem& item);
[[nodiscard]] ValueMapping preferred(const ValueMapping& rescale, const ValueMapping& real_world);

// What the vendor or the modality implies where the header leaves the unit open: Hounsfield units of a CT, radians of
// Siemens' phase images.
void add_implied_unit(ValueMapping& mapping, const DicomImage& image);

}  // namespace glisson::imaging
