#pragma once
// TRWL-S: the matching field solved without ever being written out (algorithm 1 of the dissertation). The passes are
// those of `trws`, with the widest vectors that the machine has, on all threads. A slice of the field is all costs of
// one pair of nodes. It is made from the two matrices of distances at the moment when a message needs it. It takes the
// maximum of precomputed exponentials (eq. 3.2), in 16-bit fixed point.
//
// What differs from `trws` is rounding alone. Costs are quantised to about tau / 16000, or more coarsely where the
// largest distance exceeds three times tau. A belief is divided among messages in whole steps, and what is left over
// goes to the last of them. Answers do not depend on the number of threads nor on the instructions.

#include <optional>
#include <string>

#include "base/progress.h"
#include "registration/mrf.h"

namespace glisson::registration {

// The numbers that costs and messages are kept in (figure 3.8). All but bits_16 are there to show what a width costs:
// plain code on the same threads.
enum class WordWidth { bits_8, bits_16, bits_32, double_precision };

enum class Instructions {
  widest,  // of those that the machine has: AVX-512, AVX2, SSE4, SSSE3, SSE2; NEON
  plain    // portable C++, which says what the vectors must answer
};

// When the next node's belief is gathered (section 3.2.2). The answer is the same.
enum class Order {
  head_first,  // once the one message to it is there, while the rest of this node's are on their way
  naive        // once all messages of this node are there
};

// What becomes of the labelling that is read from the messages after each pass.
enum class Polish {
  none,         // it is taken as it is, as in `trws`
  single_nodes  // then one node at a time takes the label that is cheapest given all others, until none changes
};

// From where the least is looked for.
enum class Starts {
  one,     // from nothing, as `trws`
  several  // and at the end, where the bound was not met, from a few rough matchings of nodes far apart, polished
};

struct TrwlsOptions : SolverOptions {
  Polish polish = Polish::single_nodes;  // a tenth of a pass, and fewer passes are needed
  Starts starts = Starts::several;       // what one or two passes take; only with dynamic stopping and polish
  WordWidth width = WordWidth::bits_16;
  Instructions instructions = Instructions::widest;
  Order order = Order::head_first;
  // Passes run on the first OpenCL device whose name contains this, "" for any, in 16 bits: the same answer, to the
  // bit.
  std::optional<std::string> device = std::nullopt;
};

// Energies are evaluated in double precision by eq. 3.2 for each pass's labelling. The lower bound is the fixed-point
// one less all that rounding may have added to it, so that it is below the true least energy. Fails as check() does,
// and where a device is asked for as opencl::Session::open does. Fails with "opencl-failed" where the device's memory
// does not suffice (2 nodes^2 labels bytes). Cancelling ends it in the midst of a pass, with the best labelling of the
// passes that were done. Before the first pass it ends with each node's cheapest seed.
Result<MatchingSolution> trwls(const MatchingProblem& problem, const TrwlsOptions& options = {},
                               const Progress& progress = {});

// "AVX3" and the like: what Instructions::widest means here.
[[nodiscard]] const char* widest_instructions();

}  // namespace glisson::registration
