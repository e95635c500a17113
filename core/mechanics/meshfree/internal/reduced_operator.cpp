#include "mechanics/meshfree/internal/reduced_operator.h"

#include "base/parallel.h"
#include "mechanics/solvers/internal/fill_in.h"

namespace glisson::mechanics {
namespace {

template <typename Scalar>
Eigen::VectorXd times(const BlockMatrix<Scalar>& matrix, const Eigen::VectorXd& u) {
  const auto values = static_cast<std::size_t>(u.size());
  std::vector<Scalar> x(values + 1, Scalar{0}), y(values + 1, Scalar{0});
  Eigen::Map<Eigen::Matrix<Scalar, Eigen::Dynamic, 1>>(x.data(), u.size()) = u.cast<Scalar>();
  const std::vector<Scalar> all(values + 1, Scalar{1});
  matrix.multiply(x, all, y);
  return Eigen::Map<const Eigen::Matrix<Scalar, Eigen::Dynamic, 1>>(y.data(), u.size()).template cast<double>();
}

}  // namespace

ReducedOperator::Form ReducedOperator::form_for(const Lists& handles_meeting, std::uint64_t memory_limit_bytes) {
  constexpr double maximum_operations = 4e11;  // some 15 seconds of one core, which five steps in time repay
  const auto handles = static_cast<int>(handles_meeting.starts.size()) - 1;
  std::vector<Eigen::Triplet<double>> entries;
  for (int row = 0; row < handles; ++row) {
    for (const int* column = handles_meeting.begin(row); column != handles_meeting.end(row); ++column) {
      if (*column <= row) entries.emplace_back(row, *column, 1.0);
    }
  }
  Eigen::SparseMatrix<double> pattern(handles, handles);
  pattern.setFromTriplets(entries.begin(), entries.end());
  const FillIn of_handles = fill_in_of(pattern);  // each of its entries is a block
  constexpr double block = handle_size * handle_size;
  const bool fits = 8.0 * block * of_handles.entries <= static_cast<double>(memory_limit_bytes) &&
                    handle_size * block * of_handles.operations <= maximum_operations;
  return fits ? Form::assembled : Form::product;
}

ReducedOperator::ReducedOperator(Form form, std::shared_ptr<const AffineBasis> basis,
                                 const Eigen::SparseMatrix<double>& lower, const Lists& handles_meeting)
    : basis_(std::move(basis)) {
  BlockMatrix<double> places = both_triangles(lower);
  if (form == Form::assembled) {
    assembled_ = reduced(places, *basis_, handles_meeting);
  } else {
    places_ = std::move(places);
    make_rough();
  }
}

void ReducedOperator::make_rough() {
  rough_places_.emplace(places_->columns());
  std::vector<float>& values = rough_places_->values();
  parallel_for(values.size(), 65536, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) values[i] = static_cast<float>(places_->values()[i]);
  });
}

Eigen::VectorXd ReducedOperator::operator*(const Eigen::VectorXd& q) const {
  return assembled_ ? *assembled_ * q : basis_->reduce(times(*places_, basis_->displacement(q)));
}

Eigen::VectorXd ReducedOperator::rough(const Eigen::VectorXd& q) const {
  return assembled_ ? *assembled_ * q : basis_->reduce(times(*rough_places_, basis_->displacement(q)));
}

std::vector<HandleBlock> ReducedOperator::diagonal() const {
  if (!assembled_) return diagonal_reduced(*places_, *basis_);
  std::vector<HandleBlock> blocks;
  for (int row = 0; row < assembled_->rows(); ++row) {
    blocks.push_back(assembled_->blocks()[assembled_->position(row, row)]);
  }
  return blocks;
}

ReducedOperator ReducedOperator::sum(double a, const ReducedOperator& first, double b, const ReducedOperator& second) {
  ReducedOperator result;
  result.basis_ = first.basis_;
  if (first.assembled_) {
    result.assembled_ = ReducedMatrix::sum(a, *first.assembled_, b, *second.assembled_);
    return result;
  }
  GLISSON_ASSERT(first.places_->values().size() == second.places_->values().size());
  result.places_ = first.places_;
  std::vector<double>& values = result.places_->values();
  parallel_for(values.size(), 65536, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) values[i] = a * values[i] + b * second.places_->values()[i];
  });
  result.make_rough();
  return result;
}

std::uint64_t ReducedOperator::bytes() const {
  if (assembled_) return assembled_->blocks().size() * sizeof(HandleBlock);
  return places_->values().size() * sizeof(double) + rough_places_->values().size() * sizeof(float) +
         2 * places_->columns().items.size() * sizeof(int);
}

}  // namespace glisson::mechanics
