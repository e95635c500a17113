#pragma once
// Colours as DICOM's RecommendedDisplayCIELabValue has them.

#include <array>
#include <cstdint>

namespace glisson::imaging {

// sRGB 0..1 to CIELab under D50 (PS3.3 C.10.7.1.1): L* 0..100 and a*, b* -128..127, each spread over 0..65535.
[[nodiscard]] std::array<std::uint16_t, 3> cielab_from_srgb(const std::array<double, 3>& srgb);

// The nearest colour that sRGB has.
[[nodiscard]] std::array<double, 3> srgb_from_cielab(const std::array<std::uint16_t, 3>& lab);

}  // namespace glisson::imaging
