#pragma once
// Brightness and contrast of slices: the presets that radiology departments set for CT, and what an image opens with.

#include <array>
#include <optional>

#include "imaging/image.h"

namespace glisson::widgets {

// Grey values, in the volume's unit: the value shown mid-way, and from darkest to brightest.
struct GreyWindow {
  double center = 0;
  double width = 1;
  bool operator==(const GreyWindow&) const = default;
};

enum class WindowPreset { automatic, abdomen, liver, lung, bone, own };

// In Hounsfield units: abdomen, liver, lung, bone.
[[nodiscard]] const std::array<GreyWindow, 4>& ct_windows();

// From the 1st to the 99th hundredth of the values.
[[nodiscard]] GreyWindow automatic_window(const imaging::Volume& volume);

// The liver's for Hounsfield units, else the automatic one.
[[nodiscard]] GreyWindow first_window(const imaging::Volume& volume);

// As the volume says. NIfTI and NRRD say no unit; then the values decide. Some of an image in Hounsfield units are air
// (-1100 to -800), and many are soft tissue (-150 to 250). No other image of a body has both.
[[nodiscard]] bool in_hounsfield_units(const imaging::Volume& volume);

// Which preset a window is, to half a unit of the last digit shown; `own` where it is none.
[[nodiscard]] WindowPreset preset_of(const GreyWindow& window, const imaging::Volume& volume);

// What a preset is for that volume; nothing for `own`.
[[nodiscard]] std::optional<GreyWindow> window_of(WindowPreset preset, const imaging::Volume& volume);

}  // namespace glisson::widgets
