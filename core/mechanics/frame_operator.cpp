#include "mechanics/frame_operator.h"

#include "base/parallel.h"
#include "mechanics/fill_in.h"

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

FrameOperator::Form FrameOperator::form_for(const Lists& frames_meeting, std::uint64_t memory_limit_bytes) {
  constexpr double most_operations = 1e11;  // five seconds or so, on one core
  const auto frames = static_cast<int>(frames_meeting.starts.size()) - 1;
  std::vector<Eigen::Triplet<double>> entries;
  for (int row = 0; row < frames; ++row) {
    for (const int* column = frames_meeting.begin(row); column != frames_meeting.end(row); ++column) {
      if (*column <= row) entries.emplace_back(row, *column, 1.0);
    }
  }
  Eigen::SparseMatrix<double> pattern(frames, frames);
  pattern.setFromTriplets(entries.begin(), entries.end());
  const FillIn of_frames = fill_in_of(pattern);  // each of its entries is a block
  constexpr double block = frame_size * frame_size;
  const bool fits = 8.0 * block * of_frames.entries <= static_cast<double>(memory_limit_bytes) &&
                    frame_size * block * of_frames.operations <= most_operations;
  return fits ? Form::assembled : Form::product;
}

FrameOperator::FrameOperator(Form form, std::shared_ptr<const FrameBasis> basis,
                             const Eigen::SparseMatrix<double>& lower, const Lists& frames_meeting)
    : basis_(std::move(basis)) {
  BlockMatrix<double> places = both_triangles(lower);
  if (form == Form::assembled) {
    assembled_ = reduced(places, *basis_, frames_meeting);
  } else {
    places_ = std::move(places);
    make_rough();
  }
}

void FrameOperator::make_rough() {
  rough_places_.emplace(places_->columns());
  std::vector<float>& values = rough_places_->values();
  parallel_for(values.size(), 65536, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) values[i] = static_cast<float>(places_->values()[i]);
  });
}

Eigen::VectorXd FrameOperator::operator*(const Eigen::VectorXd& q) const {
  return assembled_ ? *assembled_ * q : basis_->reduce(times(*places_, basis_->displacement(q)));
}

Eigen::VectorXd FrameOperator::rough(const Eigen::VectorXd& q) const {
  return assembled_ ? *assembled_ * q : basis_->reduce(times(*rough_places_, basis_->displacement(q)));
}

std::vector<FrameBlock> FrameOperator::diagonal() const {
  if (!assembled_) return diagonal_reduced(*places_, *basis_);
  std::vector<FrameBlock> blocks;
  for (int row = 0; row < assembled_->rows(); ++row) {
    blocks.push_back(assembled_->blocks()[assembled_->position(row, row)]);
  }
  return blocks;
}

FrameOperator FrameOperator::sum(double a, const FrameOperator& first, double b, const FrameOperator& second) {
  FrameOperator result;
  result.basis_ = first.basis_;
  if (first.assembled_) {
    result.assembled_ = FrameMatrix::sum(a, *first.assembled_, b, *second.assembled_);
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

std::uint64_t FrameOperator::bytes() const {
  if (assembled_) return assembled_->blocks().size() * sizeof(FrameBlock);
  return places_->values().size() * sizeof(double) + rough_places_->values().size() * sizeof(float) +
         2 * places_->columns().items.size() * sizeof(int);
}

}  // namespace glisson::mechanics
