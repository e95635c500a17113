#pragma once
// A matrix over handles, P^T K P, in either of two forms. Few handles: assembled, to be factorised. Many: never formed.
// A handle meets some 170 others, in blocks of 1.2 kB. So 20,000 handles would take 3.9 GB, and each product would read
// all of it. K over the places of the mesh below them takes a tenth of that, and P next to nothing. The sum of a
// conjugate gradient's products may be rough, in single precision, since residuals are formed in double. Inside of this
// room.

#include <cstdint>
#include <memory>
#include <optional>

#include "mechanics/meshfree/internal/reduced_matrix.h"

namespace glisson::mechanics {

class ReducedOperator {
 public:
  enum class Form { assembled, product };
  // Assembled where the factor would fit the memory and takes no more than seconds.
  static Form form_for(const Lists& handles_meeting, std::uint64_t memory_limit_bytes);

  // `lower` is the lower triangle of K over the places.
  ReducedOperator(Form form, std::shared_ptr<const AffineBasis> basis, const Eigen::SparseMatrix<double>& lower,
                  const Lists& handles_meeting);

  [[nodiscard]] Eigen::VectorXd operator*(const Eigen::VectorXd& q) const;
  [[nodiscard]] Eigen::VectorXd rough(const Eigen::VectorXd& q) const;
  [[nodiscard]] std::vector<HandleBlock> diagonal() const;

  // a A + b B, of one form and pattern.
  [[nodiscard]] static ReducedOperator sum(double a, const ReducedOperator& first, double b,
                                           const ReducedOperator& second);

  [[nodiscard]] const ReducedMatrix* assembled() const { return assembled_ ? &*assembled_ : nullptr; }
  // K, where not assembled.
  [[nodiscard]] const BlockMatrix<double>* of_places() const { return places_ ? &*places_ : nullptr; }
  [[nodiscard]] const std::shared_ptr<const AffineBasis>& basis() const { return basis_; }
  [[nodiscard]] std::uint64_t bytes() const;

 private:
  ReducedOperator() = default;
  void make_rough();

  std::shared_ptr<const AffineBasis> basis_;
  std::optional<ReducedMatrix> assembled_;
  std::optional<BlockMatrix<double>> places_;
  std::optional<BlockCsr> rough_places_;
};

}  // namespace glisson::mechanics
