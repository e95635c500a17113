#pragma once
// A planned resection in files. In resection.json stands the cut, so that it can be set again, and what came of it. The
// liver in its parts is parts.vtu, and the cut cut.vtp.

#include <filesystem>
#include <string>
#include <vector>

#include "base/json_forward.h"
#include "base/result.h"
#include "rehearsal/resection.h"

namespace glisson::casefile {

// A cut as somebody set it.
struct PlannedCut {
  enum class Removed { smaller, larger };    // which part is the specimen
  enum class Liver { at_rest, held_aside };  // as it lay when the cut was set: its places are places then

  std::vector<Eigen::Vector3d> through_mm;  // a smooth sheet through these points; none: the plane
  Eigen::Vector3d point_mm{0, 0, 0};
  Eigen::Vector3d normal{0, 0, 1};
  Removed removed = Removed::smaller;
  Liver liver = Liver::at_rest;

  bool operator==(const PlannedCut&) const = default;
};

// The plan of that cut. Failures: those of geometry::CutSurface and rehearsal::plan_resection.
Result<geometry::CutSurface> surface_of(const PlannedCut& cut);
Result<rehearsal::Resection> plan_resection(const geometry::TetMesh& liver, const PlannedCut& cut,
                                            const std::vector<rehearsal::NamedStructure>& structures);
Result<rehearsal::Resection> plan_resection(const rehearsal::LyingLiver& liver, const PlannedCut& cut,
                                            const std::vector<rehearsal::NamedStructure>& structures);

// Gives the plan's parts the volume of the liver's outline. Not where that is another liver than was meshed, by more
// than a fifth: the model is out of date then, and said to be.
void measure_as_outlined(rehearsal::Resection& plan, double outline_ml);

// By its name in a case: "portal-vein" is a vessel, "cyst-2" a cyst, anything else a tumour.
[[nodiscard]] rehearsal::StructureKind resection_kind(const std::string& structure);

// What resection.json holds.
[[nodiscard]] Json resection_json(const PlannedCut& cut, const rehearsal::Resection& plan);

// The folder is made where absent; files of these names are replaced, each whole. Parts and cut are written at rest,
// with the point field "displacement_mm" where the liver was held aside.
Result<void> write_resection(const std::filesystem::path& folder, const PlannedCut& cut,
                             const rehearsal::Resection& plan);

// The three files go, with the folder where it is empty then; none there: nothing.
Result<void> remove_resection(const std::filesystem::path& folder);

// Fails with "not-a-resection", naming what is missing or damaged.
Result<PlannedCut> read_planned_cut(const std::filesystem::path& folder);

}  // namespace glisson::casefile
