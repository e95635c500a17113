#include "mechanics/simulation.h"
#include "rehearsal/static_rehearsal.h"

namespace glisson::rehearsal {

Result<RehearsalSetup> rehearsal_setup(geometry::TetMesh mesh, const mechanics::Scenario& scenario) {
  const auto not_here = [](const char* what) {
    return failure(Error{"not-available",
                         GLISSON_TEXT("A session does not know \"{0}\" of a scenario."),
                         {what},
                         GLISSON_TEXT("Leave it out; tools are taken by the session's commands."),
                         {}});
  };
  if (!scenario.cuts.empty()) return not_here("cuts");
  if (!scenario.tools.empty()) return not_here("tools");
  auto youngs_kPa = mechanics::youngs_modulus_of_cells(mesh, scenario);
  if (!youngs_kPa) return failure(std::move(youngs_kPa.error()));
  RehearsalSetup setup;
  setup.mesh = std::move(mesh);
  setup.patient_youngs_kPa = std::move(*youngs_kPa);
  setup.supports = scenario.supports;
  setup.standing_loads = scenario.loads;
  setup.landmarks = scenario.landmarks;
  setup.options.poisson_ratio = scenario.poisson_ratio;
  setup.options.density_kg_mm3 = scenario.density_kg_mm3;
  setup.options.capsule = scenario.capsule;
  setup.options.anisotropy = scenario.anisotropy;
  setup.law = {scenario.material, scenario.strain_stiffening};
  setup.motion = scenario.motion;
  setup.relaxation = scenario.relaxation;
  if (scenario.engine == mechanics::Engine::meshfree) setup.meshfree = scenario.meshfree;
  return setup;
}

}  // namespace glisson::rehearsal
