// Where does a tumour go when the liver is lifted?
//
//   retract_liver labels/liver.nrrd X Y Z        the tumour's place in patient coordinates (LPS), mm
//
// The liver is meshed, held as a liver is held, and hoisted at segment VI with 2 N.

#include <cstdlib>

#include "imaging/volume_file.h"
#include "mechanics/simulation.h"
#include "meshing/mesh_labels.h"
#include "or_stop.h"
#include "rehearsal/liver_supports.h"
#include "rehearsal/tool_presets.h"

using namespace glisson;

int main(int count, char** words) {
  if (count != 5) {
    fmt::print(stderr, "usage: retract_liver LIVER.nrrd X Y Z\n");
    return 2;
  }
  const Eigen::Vector3d tumour_mm(std::atof(words[2]), std::atof(words[3]), std::atof(words[4]));

  auto liver = or_stop(meshing::mesh_labels(or_stop(imaging::read_labels_file(words[1])), {.target_cells = 4000})).body;
  or_stop(rehearsal::mark_attachments(liver));
  const auto retractor = or_stop(rehearsal::hoist_segment_vi(liver));

  mechanics::Scenario scenario;
  scenario.youngs_modulus = 6.1;                            // kPa: 2.1 kPa in shear
  scenario.supports = rehearsal::usual_supports();          // bare area and diaphragm
  scenario.loads = {rehearsal::tool_load(retractor, 2.0)};  // N
  scenario.landmarks = {{"tumour", tumour_mm}, {"tool", retractor.center_mm}};
  const auto lifted = or_stop(mechanics::simulate(liver, scenario));
  for (const auto& landmark : lifted.landmarks)
    fmt::print("{} moves by {:.1f} mm\n", landmark.id, landmark.displacement_mm);

  fmt::print("{} tetrahedra, {}: relative residual {:.0e}.\n", liver.cells.size(),
             lifted.result.may_be_used() ? "in equilibrium" : "NOT in equilibrium", lifted.result.relative_residual);
  return lifted.result.may_be_used() ? 0 : 1;
}
