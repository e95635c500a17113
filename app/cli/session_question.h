#pragma once
// What a session is asked of: a case, or a mesh with a scenario, and what is to be said of it.

#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "casefile/evidence.h"
#include "rehearsal/session.h"

namespace glisson::cli {

struct SessionQuestion {
  rehearsal::RehearsalSetup setup;
  std::vector<std::size_t> vessels;  // of the setup's structures
  casefile::Evidence evidence;
  std::vector<std::string> remarks;
  std::string origin;  // "SIMULATED ...", or empty
};

struct SessionSource {
  std::optional<std::string> case_folder, mesh_file, scenario_file;
  std::optional<mechanics::Engine> engine;  // absent: what the scenario says, of a case finite elements
  std::optional<int> nodes;                 // of the meshfree engine
  std::optional<mechanics::MaterialLaw> material;
  std::optional<double> strain_stiffening;
  // A step in time, and Rayleigh's damping; absent: what the scenario says, of a case none.
  std::optional<double> step_s, mass_damping_per_s, stiffness_damping_s;
  // Of a case: as the window rehearses it, to the bit.
  bool live = false;
};

// `with_structures`: the setup's structures are those of the case, which cost time at each step. Failures: those of
// reading.
Result<SessionQuestion> question_of(const SessionSource& source, bool with_structures = false);

}  // namespace glisson::cli
