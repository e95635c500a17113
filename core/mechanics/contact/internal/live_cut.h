#pragma once
// What a live body has more of where a cut has opened: its jumps' cells, a level for conjugate gradients, and answers
// to unit forces. The answers are those of the judged places at small strain, and weight the bound. Made anew with each
// advance; the body's other parts stay.

#include <cstdint>
#include <Eigen/Core>
#include <memory>
#include <mutex>
#include <vector>

#include "mechanics/contact/internal/cut_level.h"
#include "mechanics/contact/internal/open_cells.h"
#include "mechanics/contact/internal/quadratic_cells.h"
#include "mechanics/cutting/opening.h"

namespace glisson::mechanics {

struct LiveParts;
struct LiveState;

struct LiveCut {
  Opening opening;  // at small strain, on the model's factor
  std::size_t advances;
  OpenCells open;
  QuadraticCells others;  // the cells that are not open
  CutLevel level;
  Eigen::VectorXd standing_mN;                  // dead loads on the jumps
  std::vector<Opening::JumpValues> of_watched;  // the jumps that each watched place sees

  LiveCut(const LiveParts& parts, Opening opened, std::size_t advances);

  // What of a whole result, as of the nodes alone, is not that of the cut body.
  void correct(StaticResult& result, const LiveParts& parts, const LiveState& state) const;

  // As LiveParts', with the jumps. Failure: "not-converged".
  [[nodiscard]] Result<std::shared_ptr<const Eigen::MatrixXf>> adjoints(const LiveParts& parts) const;

 private:
  std::uint64_t number_;  // of all that were made of a body
};

// The answers of one cut, that of the last step: some 15 MB of a liver. Advances that undo goes back to need not hold
// each. Solved for again they are the same bits.
struct KeptAdjoints {
  std::mutex mutex;
  std::uint64_t cuts = 0, of_cut = 0;
  std::shared_ptr<const Eigen::MatrixXf> values;
};

// Where the judged places are what is seen of an opening.
[[nodiscard]] SeenPart judged_places(const LiveParts& parts);

}  // namespace glisson::mechanics
