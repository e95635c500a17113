#pragma once
// Real livers as a shape model, and what it is worth. That is generalisation, specificity, compactness, and how well it
// completes a liver of which a third is missing. The population that section 4.4 of the dissertation asks for.
//
// A liver is one label map: ID_couinaud.*, or else ID_liver.*, or any other label map of the folder by its own name;
// ID_vessels.* and ID_couinaud2.* are passed over. The livers are taken in ascending order of their names' bytes, and
// counted from 0. Those of even number are for tuning, those of odd number for judging. This rule stood before anything
// was tuned.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "shapes/shape_fit.h"
#include "shapes/shape_model.h"
#include "studies/dissertation/batch.h"

namespace glisson::studies {

enum class ShapesJudged {
  tuning,   // those for tuning alone are read, and judged by models of the others for tuning
  judging,  // all are read; those for judging are judged by models of all others
  all,      // all by models of all others
  none
};

struct ShapesOptions {
  ShapesJudged judged = ShapesJudged::judging;
  bool believe_unit_spacing = false;
  double reference_spacing_mm = 7;  // of the surface that every liver is described by
  shapes::FitOptions fit;
  std::optional<std::string> only;  // this liver's correspondence alone, one job of many that share the folder
};

// Over the livers judged. Distances are mean surface distances, both ways, to the liver's own outline.
struct ShapesScore {
  std::string column, says;
  double mean = 0, median = 0, worst = 0;
};

struct ShapesStudy {
  std::vector<BatchRow> livers;  // a liver each: volume, how well the reference lies on it
  std::vector<BatchRow> judged;  // a liver each: generalisation and completions
  std::size_t used = 0, refused = 0;
  shapes::RanksJudged ranks;
  double specificity_mm = 0, spread_mm = 0;  // spread: mean distance of a liver's points from the mean's
  std::vector<ShapesScore> scores;
};

// Into `out`: patients/ID.json and livers/ID.vtp (the reference's points on it), outlines/ID.vtp, judged/, model.vtp,
// livers.csv, judged.csv, summary.json. Livers that are there whole are taken from there.
// Failures: "shapes-no-livers" where the folder has none or cannot be read, those of align_shapes; "cancelled".
Result<ShapesStudy> run_shapes(const std::filesystem::path& folder, const std::filesystem::path& out,
                               const ShapesOptions& options = {}, const Progress& progress = {});

// A liver's label map, and which half it belongs to.
struct ShapesLiver {
  std::string id;
  std::filesystem::path file;
  bool for_tuning = true;
};
[[nodiscard]] std::vector<ShapesLiver> shapes_livers(const std::filesystem::path& folder);

}  // namespace glisson::studies
