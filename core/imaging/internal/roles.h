#pragma once
// What a series is for, from what vendors really write in its headers.

#include <string>
#include <vector>

#include "imaging/study.h"

namespace glisson::imaging {

// The header fields that a role is judged by.
struct RoleClues {
  std::string modality, manufacturer;
  std::vector<std::string> image_type;
  std::string description, protocol, sequence_name, comments;
  std::string ge_pulse_sequence;
  std::string unit;       // as in Series
  std::string component;  // "M", "P", "R", "I" or empty
  bool is_colour = false;
  int volumes = 1;
  int series_number = 0;
  double window_center = 0, window_width = 0;
};

struct RoleFinding {
  Role role = Role::other;
  std::string evidence;
};

[[nodiscard]] RoleFinding role_of(const RoleClues& clues);

// For NIfTI, NRRD and MetaImage, which have no such fields: by the name of the file and the kind of its values.
[[nodiscard]] RoleFinding role_of_volume_file(const std::string& file_name, bool holds_bytes);

}  // namespace glisson::imaging
