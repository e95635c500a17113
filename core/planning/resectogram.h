#pragma once
// The surface of a cut unrolled flat, with how near the tumours are at each place of it: a resectogram.

#include <cstddef>
#include <Eigen/Core>
#include <string>
#include <vector>

#include "vasculature/systems.h"

namespace glisson::planning {

// Places step_mm apart along two axes across the surface's normal: u along a row, v from row to row. A sheet's bend is
// not unrolled, so that lengths along it are somewhat short.
struct Resectogram {
  double step_mm = 1;
  int columns = 0, rows = 0;
  Eigen::Vector3d along_row{1, 0, 0}, along_column{0, 1, 0};  // u and v, unit, patient coordinates
  // From the place to the border of the nearest tumour, mm, row by row; NaN beside the liver, 0 in a tumour,
  // largest_margin_mm where there is none that near.
  std::vector<double> margin_mm;

  // Where branches are cut near the surface, in columns and rows.
  struct Vessel {
    std::string name;
    double column = 0, row = 0, radius_mm = 0;
    vasculature::System system = vasculature::System::portal_vein;
  };
  std::vector<Vessel> vessels;

  [[nodiscard]] double at(int column, int row) const {
    return margin_mm[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
                     static_cast<std::size_t>(column)];
  }
};

}  // namespace glisson::planning
