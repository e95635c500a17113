#pragma once
// Sequential tree-reweighted message passing (TRW-S; V. Kolmogorov, IEEE PAMI 28(10), 2006): the baseline of section
// 3.4 of the dissertation. Plain: double precision, the field written out, one thread. `trwls` is the fast one.

#include "base/progress.h"
#include "registration/mrf.h"

namespace glisson::registration {

// Nodes are visited in their order and back. The lower bound never falls from pass to pass (but for rounding); the
// energy may, hence the best labelling is kept. Cancelling returns the best so far.
MatchingSolution trws(const StoredMrf& mrf, const SolverOptions& options = {}, const Progress& progress = {});

}  // namespace glisson::registration
