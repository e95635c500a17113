#pragma once
// Chapter 5 of the dissertation on a case: the liver retracted straight from measured strain and stress
// (mechanics/statics/data_driven.h), beside the same retraction by the model's own stiffness. Small strain, both.

#include <filesystem>
#include <string>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "casefile/model.h"
#include "mechanics/materials/material_data.h"
#include "mechanics/statics/validity.h"

namespace glisson::casefile {

// Of each point: how far the two answers put it apart (mm).
inline const std::string apart_field = "apart_mm";

struct RetractionFromData {
  std::vector<mechanics::StressStrain> measured;
  double slope_kPa = 0;          // of the line through all measurements and the origin
  double from_data_mm = 0;       // the largest displacement straight from the data
  double by_model_mm = 0;        // and by the model's own stiffness
  double apart_mean_mm = 0;      // over the points of the body
  double apart_largest_mm = 0;   // over the same
  double beyond_data = 0;        // share of the body's volume that is strained farther than was measured
  mechanics::Validity validity;  // the worse one of the two
  struct LandmarkApart {
    std::string id;
    double from_data_mm = 0, by_model_mm = 0;  // displacements
    double apart_mm = 0;
  };
  std::vector<LandmarkApart> landmarks;
  geometry::Surface surface;  // of the liver where the data put it, with the point field apart_field
};

// `file`: as closedloop/material/stress_strain_file.h reads it. The tool is that of rehearsal/tool_presets.h, at
// segment VI, with `force_N`; supports, landmarks and Poisson's ratio are the model's. Failures: those of reading the
// case and the file, of MaterialData and mechanics::simulate; "not-converged" for either answer.
Result<RetractionFromData> retract_from_data(const Case& patient, const std::filesystem::path& file, double force_N,
                                             const Progress& progress = {});

}  // namespace glisson::casefile
