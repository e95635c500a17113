#pragma once
// What makes conjugate gradients fast on a body that is nearly incompressible:
//   r -> D^-1 r + P (w B^-1 + Q (Q^T P^T A P Q)^-1 Q^T) P^T r,
// an additive method of three levels (Toselli and Widlund 2005, Domain Decomposition Methods, 2.5 and 3). D is the 3x3
// blocks of A's diagonal. P takes the nodes' displacements from quadratic B-splines over a narrow regular lattice laid
// through the body. Q takes them from splines twice as wide, which narrow ones add up to exactly. B is the diagonal
// blocks of P^T A P; the wide lattice's inverse is kept, dense. Splines of the second degree bend and turn without
// locking, which trilinear ones do not near incompressibility.
//
// Some rows c of stiffness k (contacts, jaws) may stand beside A. They are answered exactly, by what the levels answer
// to them (Sherman, Morrison and Woodbury; e.g. Golub and Van Loan, Matrix Computations, 2.1.4). A live cut joins as
// one level more (cut_level.h): its jumps then follow the nodes, and rows may see them too.

#include <cstdint>
#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <vector>

#include "mechanics/contact/internal/cut_level.h"
#include "mechanics/contact/internal/spline_lattice.h"
#include "mechanics/contact/internal/stiff_rows.h"

namespace glisson::mechanics {

class SplineLevels {
 public:
  SplineLevels(const std::vector<Eigen::Vector3d>& positions_mm, const std::vector<std::uint8_t>& fixed,
               int most_wide_points)
      : lattice_(positions_mm, fixed, most_wide_points) {
    for (int node = 0; node < static_cast<int>(positions_mm.size()); ++node) {
      wide_of_node_.push_back(lattice_.wide_around(node));
    }
  }

  // From A's lower triangle. False where it is not positive definite: the levels then are as they were.
  bool refresh(const Eigen::SparseMatrix<double>& lower);

  [[nodiscard]] const SplineLattice& lattice() const { return lattice_; }
  [[nodiscard]] const std::vector<SplineLattice::Shares<float>>& wide_of_node() const { return wide_of_node_; }

  // What answers forces with the rows beside A; `further` unknowns follow those of the nodes. What is answered to
  // `alone`, the forces without the rows', and to each row is kept: forces that the rows add are answered from that.
  class WithRows {
   public:
    // Which of the rows press is decided by the levels' answer to `alone`.
    WithRows(const SplineLevels& levels, const std::vector<StiffRow>& rows, int further, Eigen::VectorXd alone,
             const CutLevel* cut = nullptr);
    [[nodiscard]] bool presses(std::size_t row) const { return presses_[row] != 0; }

    void apply(const Eigen::VectorXd& r, Eigen::VectorXd& z) const;
    // The same where r is `alone` and so much along each row.
    void apply_along_rows(const Eigen::VectorXd& force_mN, Eigen::VectorXd& z) const;
    // `alone` and so much along each row, without what the rows take of it.
    void rest_of(const Eigen::VectorXd& force_mN, Eigen::VectorXd& rest) const;

   private:
    struct Answer {
      Eigen::VectorXf wide;
      SplineLattice::Values narrow;
      Eigen::VectorXf cut;
    };
    [[nodiscard]] Answer answer_without_rows(const Eigen::VectorXd& r) const;
    [[nodiscard]] Eigen::VectorXd seen_of(const Answer& answer, const Eigen::VectorXd& r) const;
    void find_shares();
    [[nodiscard]] Eigen::MatrixXd compliance() const;
    void add_own(Eigen::MatrixXd& sum) const;
    // The rows that press, and what they see.
    using SeenShares = Eigen::SparseMatrix<double, Eigen::RowMajor>;
    struct Pressing {
      std::vector<Eigen::Index> sees;  // functionals
      SeenShares shares;
      Eigen::VectorXd stiffness, gap_mm;
    };
    void choose(const Eigen::VectorXd& gap_mm);
    [[nodiscard]] Pressing those_that_press(const Eigen::VectorXd& gap_mm) const;
    [[nodiscard]] Eigen::VectorXd left_of(const Eigen::VectorXd& force_mN) const;
    void push(const Eigen::VectorXd& force_mN, Eigen::VectorXd& r) const;
    void add_answers(const Eigen::VectorXd& force_mN, Answer& answer) const;
    void spread(const Answer& answer, const Eigen::VectorXd& r, Eigen::VectorXd& z) const;
    [[nodiscard]] const Eigen::Matrix3d& own_inverse(int unknown) const;

    const SplineLevels& levels_;
    const std::vector<StiffRow>& rows_;
    CondensedRows seen_;
    const CutLevel* cut_;
    int further_;
    double soft_ = 1;                                             // stiffness of a further unknown on its own
    std::vector<int> used_;                                       // wide points that are seen
    Eigen::MatrixXf wide_;                                        // Q^T P^T c^T there, a column a functional c
    std::vector<SplineLattice::Shares<Eigen::Vector3f>> narrow_;  // P^T c^T
    Eigen::MatrixXf of_cut_;                                      // Y^T c^T
    Eigen::VectorXd alone_;
    Answer to_alone_;
    Eigen::MatrixXd compliance_mm_mN_;  // of all functionals, by all levels
    Eigen::VectorXd seen_alone_mm_;
    std::vector<std::uint8_t> presses_;
    Eigen::MatrixXd inverse_;  // times what is seen: what rows that press take off it
  };

 private:
  SplineLattice lattice_;
  std::vector<SplineLattice::Shares<float>> wide_of_node_;
  std::vector<Eigen::Matrix3d> inverse_diagonal_;
  std::vector<Eigen::Matrix3f> narrow_inverse_;
  Eigen::MatrixXf wide_inverse_;  // with padded rows
};

}  // namespace glisson::mechanics
