#pragma once
// Orders of steps side by side: retract first or cut first? Of each recording of a session, what it asked of the liver
// at its worst, and step by step. At rest: at large strain every state is settled before it counts.

#include <optional>
#include <string>
#include <vector>

#include "base/json_forward.h"
#include "rehearsal/session.h"

namespace glisson::rehearsal {

// A figure of one state of a session, and of which: its number among the recording's commands, from 1.
struct Worst {
  double value = 0;
  std::size_t step = 0;
};

struct LandmarkMove {
  std::string id;
  Worst largest_mm;
  double end_mm = 0;  // in the last state
};

struct OrderOfSteps {
  std::string name;
  std::vector<LandmarkMove> landmarks;
  Worst largest_force_N;  // of any one tool
  Worst largest_strain;   // principal, at the corners of all cells
  // The strain of the vessels' walls: the 95th percentile, by area, of how much a principal stretch within the surface
  // differs from 1. Absent where no vessel was given.
  std::optional<Worst> vessel_strain;
  double open_mm2 = 0;  // of the cut, at the end
  double bridge_mm2 = 0;
  std::vector<std::size_t> refused;   // commands that could not be carried out
  std::vector<std::size_t> unusable;  // states that may not be used; no figure is taken from them
  // A number a state, NaN where it is unusable.
  std::vector<double> largest_move_mm;  // of all landmarks
  std::vector<double> force_N;
};

// `vessels` says which of the setup's structures are vessels. Failures: those of SessionEngine::create; "cancelled".
Result<OrderOfSteps> run_order(const RehearsalSetup& setup, const std::vector<std::size_t>& vessels, std::string name,
                               const Recording& recording, const Progress& progress = {});

struct NamedRecording {
  std::string name;
  Recording recording;
};
// One after the other, each from the liver at rest, on the same factors. Failures: as above.
Result<std::vector<OrderOfSteps>> run_orders(RehearsalSetup setup, const std::vector<std::size_t>& vessels,
                                             const std::vector<NamedRecording>& orders, const Progress& progress = {});

// The keys: name, steps, landmarks[], largest_force_N, largest_strain, vessel_strain (null where no vessel is known).
// Then open_mm2, bridge_mm2, refused[], unusable[]. Then moves_mm[] and forces_N[]: a number a state, null where it is
// unusable. A landmark is {id, largest_mm, at_step, end_mm}.
[[nodiscard]] Json json_of(const OrderOfSteps& order);
// Back, from whatever stands there: to be called within reading() (base/json_reading.h).
[[nodiscard]] OrderOfSteps order_from(const Json& json, const std::string& where);

// Of a surface at rest and displaced; zero where it has no area. Triangles without area at rest are left out.
[[nodiscard]] double wall_strain(const geometry::Surface& rest, const std::vector<Eigen::Vector3d>& displaced_mm);

}  // namespace glisson::rehearsal
