#pragma once
// Trees of two systems over the pieces of a vessel graph, each piece in one of them.
//
// What is likely of a tree of vessels: at a fork the cubes of the radii add up (Murray 1926, PNAS 12:207), and no
// branch turns by more than the least work asks of its calibre (Murray 1926, J Gen Physiol 9:835). A vessel thins out
// on its way, ends thin, passes no neck, and begins where its system enters. All trees together are looked for.

#include <cstdint>
#include <utility>
#include <vector>

#include "vasculature/internal/junctions.h"
#include "vasculature/systems.h"

namespace glisson::vasculature {

struct Forest {
  std::vector<int> parent;     // of each piece; -1 where a tree begins
  std::vector<int> near_end;   // 0 or 1: the end at which the blood of a portal vein comes in
  std::vector<System> system;  // of each piece
  double energy = 0;           // minus the logarithm of its probability, but for a constant
};

// A piece whose system is known, each piece at most once.
using KnownPieces = std::vector<std::pair<int, System>>;

// By a walk that visits forests as often as they are probable, and cools down (Kirkpatrick et al. 1983, Science
// 220:671). It visits none in which a known piece has another system. Another seed may end in another forest; the same
// gives the same.
[[nodiscard]] Forest cooled_forest(const Junctions& junctions, const VesselEntries& entries, const KnownPieces& known,
                                   std::uint64_t seed);

// Of each piece: the share of likely forests around this one that say the same system.
[[nodiscard]] std::vector<double> sure_of(const Junctions& junctions, const VesselEntries& entries,
                                          const KnownPieces& known, const Forest& forest);

}  // namespace glisson::vasculature
