#pragma once
// Where else a solver of the matching field may begin. These are matchings of a few nodes that lie as far apart as can
// be, good in different ways. Passes that begin from nothing may settle on the body turned the wrong way round, and no
// number of further passes leaves that again.

#include <vector>

#include "registration/mrf.h"

namespace glisson::registration {

// A matching of a few of the nodes.
struct RoughStart {
  std::vector<int> nodes;
  Labelling labels;  // one for each of these nodes
};

// The same each time. A few thousandths of the work of solving the whole field.
[[nodiscard]] std::vector<RoughStart> rough_starts(const MatchingProblem& problem);

}  // namespace glisson::registration
