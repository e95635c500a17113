#pragma once
// The vessel trees of a case, and whose tissue is whose.
//
//   vessels/trees           glisson-vessel-trees/1 (vasculature/tree_file.h)
//   territories/couinaud    .nrrd, segments I to VIII as 3D Slicer names them

#include <optional>
#include <string>

#include "base/progress.h"
#include "casefile/case.h"
#include "geometry/cut_surface.h"
#include "vasculature/couinaud.h"
#include "vasculature/remnant.h"
#include "vasculature/territories.h"

namespace glisson::casefile {

// From labels/liver and one structure of both systems; without its name from portal-vein and hepatic-vein, or where
// these are not there from "vessels". Fails with vessels-missing, labels-grids-differ and as the room vasculature says.
Result<vasculature::VesselTrees> find_vessels(Case& patient, const std::optional<std::string>& structure,
                                              const vasculature::Clicks& clicks = {}, const Progress& progress = {});

enum class SegmentsBy { trees, shape };
struct FoundTerritories {
  vasculature::CouinaudSegments couinaud;
  vasculature::VesselTrees trees;  // empty by shape
  // Tissue of each branch and of all beyond it, ml; 0 for the branches of a system that has none.
  std::vector<double> own_ml, beyond_ml;
};
// By trees: those that find_vessels saved. Fails with vessels-missing and as the room vasculature says.
Result<FoundTerritories> find_territories(Case& patient, SegmentsBy by, const Progress& progress = {});

// What lives after a cut, and the trees that say so.
struct LivingRemnant {
  vasculature::Remnant remnant;
  vasculature::VesselTrees trees;
  std::vector<Sentence> remarks;  // on the trees' file: changed since, or by another program
};
// By the trees that find_vessels saved; nothing where the case has none, or those of one system alone. Fails as the
// room vasculature says.
Result<std::optional<LivingRemnant>> living_remnant(const Case& patient, const geometry::CutSurface& cut,
                                                    bool specimen_is_above);

}  // namespace glisson::casefile
