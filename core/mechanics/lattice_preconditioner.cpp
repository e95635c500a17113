#include "mechanics/lattice_preconditioner.h"

#include <cmath>
#include <Eigen/LU>
#include <map>
#include <numeric>

#include "base/parallel.h"

namespace glisson::mechanics {
namespace {

constexpr int rows_in_chunk = BlockCsr::rows_in_chunk;

// A block of A between two nodes couples the lattice points around them, at most two cells apart along each axis.
struct Stencil {
  std::array<Eigen::Matrix3d, 125> blocks;
  Stencil() { blocks.fill(Eigen::Matrix3d::Zero()); }
  static int slot(const Eigen::Vector3i& apart) { return ((apart.z() + 2) * 5 + apart.y() + 2) * 5 + apart.x() + 2; }
};

Eigen::Vector3i corner_offset(int k) { return {k & 1, (k >> 1) & 1, k >> 2}; }

}  // namespace

LatticePreconditioner::LatticePreconditioner(const std::vector<Eigen::Vector3d>& positions_mm, std::vector<float> mask,
                                             double spacing_mm)
    : mask_(std::move(mask)), corners_(positions_mm.size()), inverse_diagonal_(9 * positions_mm.size()) {
  const Eigen::Vector3d origin_mm = geometry::bounding_box(positions_mm).min_mm;
  std::map<std::array<int, 3>, int> numbers;
  for (std::size_t n = 0; n < positions_mm.size(); ++n) {
    const Eigen::Vector3d place = (positions_mm[n] - origin_mm) / spacing_mm;
    const Eigen::Vector3d floor = place.array().floor();
    const Eigen::Vector3d within = place - floor;
    cell_.emplace_back(floor.cast<int>());
    for (int k = 0; k < 8; ++k) {
      const Eigen::Vector3i offset = corner_offset(k), at = cell_.back() + offset;
      double weight = 1.0;
      for (int d = 0; d < 3; ++d) weight *= offset[d] ? within[d] : 1.0 - within[d];
      const auto [found, isnew] = numbers.try_emplace({at.x(), at.y(), at.z()}, static_cast<int>(lattice_.size()));
      if (isnew) {
        lattice_.push_back(at);
        shares_.emplace_back();
      }
      corners_[n][k] = {found->second, static_cast<float>(weight)};
      if (weight > 0) shares_[found->second].push_back({static_cast<int>(n), static_cast<float>(weight)});
    }
  }
}

void LatticePreconditioner::refresh_diagonal(const BlockCsr& matrix) {
  parallel_for(static_cast<std::size_t>(matrix.rows()), rows_in_chunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n) {
      const int row = static_cast<int>(n);
      Eigen::Matrix3d block = Eigen::Map<const Eigen::Matrix3f>(matrix.block(matrix.position(row, row))).cast<double>();
      for (int d = 0; d < 3; ++d) {
        if (mask_[3 * n + d] != 0) continue;
        block.row(d).setZero();
        block.col(d).setZero();
        block(d, d) = 1.0;
      }
      Eigen::Map<Eigen::Matrix3f>(inverse_diagonal_.data() + 9 * n) = block.inverse().cast<float>();
    }
  });
}

void LatticePreconditioner::refresh_lattice(const BlockCsr& matrix) {
  std::vector<Stencil> stencils(lattice_.size());
  for (int row = 0; row < matrix.rows(); ++row) {
    const Eigen::Vector3d row_mask = Eigen::Map<const Eigen::Vector3f>(mask_.data() + 3 * row).cast<double>();
    // The row times P, by lattice point: those from one before the node's cell to two after it, along each axis.
    std::array<Eigen::Matrix3d, 64> product;
    product.fill(Eigen::Matrix3d::Zero());
    for (const int* column = matrix.columns().begin(row); column != matrix.columns().end(row); ++column) {
      const auto at = static_cast<std::size_t>(column - matrix.columns().items.data());
      const Eigen::Matrix3d block =
          row_mask.asDiagonal() * Eigen::Map<const Eigen::Matrix3f>(matrix.block(at)).cast<double>() *
          Eigen::Map<const Eigen::Vector3f>(mask_.data() + 3 * *column).cast<double>().asDiagonal();
      const Eigen::Vector3i apart = cell_[*column] - cell_[row] + Eigen::Vector3i::Ones();
      GLISSON_ASSERT((apart.array() >= 0).all() && (apart.array() <= 2).all());
      for (int k = 0; k < 8; ++k) {
        const Eigen::Vector3i slot = apart + corner_offset(k);
        product[(slot.z() * 4 + slot.y()) * 4 + slot.x()] += corners_[*column][k].weight * block;
      }
    }
    for (int slot = 0; slot < 64; ++slot) {
      if (product[slot].isZero(0)) continue;
      const Eigen::Vector3i place = Eigen::Vector3i(slot % 4, slot / 4 % 4, slot / 16) - Eigen::Vector3i::Ones();
      for (int k = 0; k < 8; ++k) {
        stencils[corners_[row][k].point].blocks[Stencil::slot(place - corner_offset(k))] +=
            corners_[row][k].weight * product[slot];
      }
    }
  }

  std::map<std::array<int, 3>, int> numbers;
  for (std::size_t p = 0; p < lattice_.size(); ++p) {
    numbers[{lattice_[p].x(), lattice_[p].y(), lattice_[p].z()}] = static_cast<int>(p);
  }
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t p = 0; p < lattice_.size(); ++p) {
    for (int slot = 0; slot < 125; ++slot) {
      const Eigen::Vector3i other =
          lattice_[p] + Eigen::Vector3i(slot % 5, slot / 5 % 5, slot / 25) - Eigen::Vector3i::Constant(2);
      const auto found = numbers.find({other.x(), other.y(), other.z()});
      if (found == numbers.end() || stencils[p].blocks[slot].isZero(0)) continue;
      for (int r = 0; r < 3; ++r) {
        for (int c = 0; c < 3; ++c) {
          const int row = 3 * static_cast<int>(p) + r, column = 3 * found->second + c;
          if (row > column) entries.emplace_back(row, column, stencils[p].blocks[slot](r, c));
        }
      }
    }
    // A point that only touches what is held has nothing to say; and A is in single precision.
    for (int d = 0; d < 3; ++d) {
      const double diagonal = stencils[p].blocks[Stencil::slot(Eigen::Vector3i::Zero())](d, d);
      const int row = 3 * static_cast<int>(p) + d;
      entries.emplace_back(row, row, diagonal > 0 ? diagonal * (1 + 1e-5) : 1.0);
    }
  }
  const auto size = 3 * static_cast<Eigen::Index>(lattice_.size());
  Eigen::SparseMatrix<double> lower(size, size);
  lower.setFromTriplets(entries.begin(), entries.end());
  auto factor = CholeskyFactor::create(lower, std::uint64_t{1} << 30);
  constexpr Eigen::Index most_unknowns_to_invert = 1536;
  factor_.reset();
  inverse_.resize(0, 0);
  if (!factor) return;
  if (size > most_unknowns_to_invert) {
    factor_ = std::move(*factor);
  } else {
    inverse_ = factor->solve(Eigen::MatrixXd::Identity(size, size)).cast<float>();
  }
}

double LatticePreconditioner::apply(const std::vector<float>& r, std::vector<float>& z) const {
  Eigen::VectorXf coarse = Eigen::VectorXf::Zero(3 * static_cast<Eigen::Index>(lattice_.size()));
  parallel_for(lattice_.size(), 32, [&](std::size_t begin, std::size_t end) {
    for (std::size_t p = begin; p < end; ++p) {
      Eigen::Vector4f sum = Eigen::Vector4f::Zero();  // r is already zero where held; the fourth lane is not used
      for (const Share& share : shares_[p]) {
        sum += share.weight * Eigen::Map<const Eigen::Vector4f>(r.data() + 3 * static_cast<std::size_t>(share.node));
      }
      coarse.segment<3>(3 * static_cast<Eigen::Index>(p)) = sum.head<3>();
    }
  });
  Eigen::VectorXf shift = Eigen::VectorXf::Zero(coarse.size() + 1);
  if (factor_) {
    shift.head(coarse.size()) = factor_->solve(coarse.cast<double>()).cast<float>();
  } else if (inverse_.size() > 0) {
    constexpr std::size_t columns_at_once = 96;  // symmetric: columns are rows, and lie together
    parallel_for(static_cast<std::size_t>(coarse.size()), columns_at_once, [&](std::size_t begin, std::size_t end) {
      const auto first = static_cast<Eigen::Index>(begin), count = static_cast<Eigen::Index>(end - begin);
      for (Eigen::Index k = first; k < first + count; ++k) shift[k] = inverse_.col(k).dot(coarse);
    });
  }
  std::vector<double> partial((corners_.size() + rows_in_chunk - 1) / rows_in_chunk, 0.0);
  parallel_for(partial.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t chunk = begin; chunk < end; ++chunk) {
      double dot = 0;
      const std::size_t last = std::min((chunk + 1) * rows_in_chunk, corners_.size());
      for (std::size_t n = chunk * rows_in_chunk; n < last; ++n) {
        const Eigen::Map<const Eigen::Vector3f> residual(r.data() + 3 * n), mask(mask_.data() + 3 * n);
        Eigen::Vector4f sum = Eigen::Vector4f::Zero();
        for (const Corner& corner : corners_[n]) sum += corner.weight * shift.segment<4>(3 * corner.point);
        const Eigen::Vector3f value = Eigen::Map<const Eigen::Matrix3f>(inverse_diagonal_.data() + 9 * n) * residual +
                                      mask.cwiseProduct(sum.head<3>());
        Eigen::Map<Eigen::Vector3f>(z.data() + 3 * n) = value;
        dot += static_cast<double>(value.dot(residual));
      }
      partial[chunk] = dot;
    }
  });
  return std::accumulate(partial.begin(), partial.end(), 0.0);
}

}  // namespace glisson::mechanics
