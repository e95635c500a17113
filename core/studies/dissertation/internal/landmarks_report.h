#pragma once
// The landmark studies as a page. It has box plots with the 5 mm line (figures 4.10 and 4.13), and red and blue
// pictures of typical and extreme patients (figure 4.12). It shows beams of patients in whom one region alone agrees
// (figure 4.14), and a table.

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "report/html.h"
#include "studies/dissertation/landmarks.h"

namespace glisson::studies {

// How columns of the three regions begin, in the order of BeamRegion.
inline constexpr std::array<const char*, 3> region_columns{"soft", "stiff", "uneven"};

struct LandmarksPictures {
  std::vector<report::Figure> between;  // livers in red and blue
  std::vector<report::Figure> within;   // beams, coloured by how far they are from the control
};

[[nodiscard]] report::Page landmarks_page(const LandmarksSummary& summary, const LandmarksOptions& options,
                                          const LandmarksPictures& pictures);

}  // namespace glisson::studies
