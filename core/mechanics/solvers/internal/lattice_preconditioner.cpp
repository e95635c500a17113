#include "mechanics/solvers/internal/lattice_preconditioner.h"

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

// Of the eight corners of a cell, for a place within it.
template <typename Scalar>
std::array<Scalar, 8> trilinear(const Eigen::Vector3d& within) {
  std::array<Scalar, 8> weights;
  for (int k = 0; k < 8; ++k) {
    double weight = 1.0;
    for (int d = 0; d < 3; ++d) weight *= corner_offset(k)[d] ? within[d] : 1.0 - within[d];
    weights[k] = static_cast<Scalar>(weight);
  }
  return weights;
}

// Numbers of places on a lattice, in the order in which they are first asked for.
class Numbers {
 public:
  int of(const Eigen::Vector3i& at, std::vector<Eigen::Vector3i>& places) {
    const auto [found, is_new] = numbers_.try_emplace({at.x(), at.y(), at.z()}, static_cast<int>(places.size()));
    if (is_new) places.push_back(at);
    return found->second;
  }
  // -1 where nobody asked for it.
  [[nodiscard]] int find(const Eigen::Vector3i& at) const {
    const auto found = numbers_.find({at.x(), at.y(), at.z()});
    return found == numbers_.end() ? -1 : found->second;
  }

 private:
  std::map<std::array<int, 3>, int> numbers_;
};

// Places on the narrow lattice are never below zero.
Eigen::Vector3i wide_cell(const Eigen::Vector3i& narrow) { return narrow / 2; }
Eigen::Vector3d within_wide_cell(const Eigen::Vector3i& narrow, const Eigen::Vector3d& within) {
  return 0.5 * ((narrow - 2 * wide_cell(narrow)).cast<double>() + within);
}

// One of the matrix's blocks, without the rows and columns of what is held.
Eigen::Matrix3d free_block(const BlockCsr& matrix, std::size_t position, const float* row_mask,
                           const float* column_mask) {
  return Eigen::Map<const Eigen::Vector3f>(row_mask).cast<double>().asDiagonal() *
         Eigen::Map<const Eigen::Matrix3f>(matrix.block(position)).cast<double>() *
         Eigen::Map<const Eigen::Vector3f>(column_mask).cast<double>().asDiagonal();
}

}  // namespace

LatticePreconditioner::LatticePreconditioner(const std::vector<Eigen::Vector3d>& positions_mm, std::vector<float> mask,
                                             double spacing_mm)
    : mask_(std::move(mask)), inverse_diagonal_(9 * positions_mm.size() + 1) {
  const Eigen::Vector3d origin_mm = geometry::bounding_box(positions_mm).min_mm;
  Numbers narrow_numbers, wide_numbers, brick_numbers;
  std::vector<Eigen::Vector3i> brick_cells;
  std::vector<std::vector<int>> nodes_of_brick;
  for (std::size_t n = 0; n < positions_mm.size(); ++n) {
    const Eigen::Vector3d place = (positions_mm[n] - origin_mm) / (0.5 * spacing_mm);
    const Eigen::Vector3d floor = place.array().floor();
    const Eigen::Vector3i cell = floor.cast<int>();
    const int brick = brick_numbers.of(cell, brick_cells);
    places_.push_back({cell, place - floor, brick});
    nodes_of_brick.resize(brick_cells.size());
    nodes_of_brick[brick].push_back(static_cast<int>(n));
  }
  for (std::size_t b = 0; b < brick_cells.size(); ++b) {
    Brick brick{{}, members_.size(), members_.size() + nodes_of_brick[b].size()};
    for (int k = 0; k < 8; ++k) {
      brick.corners[k] = narrow_numbers.of(brick_cells[b] + corner_offset(k), narrow_);
      wide_numbers.of(wide_cell(brick_cells[b]) + corner_offset(k), wide_);
    }
    bricks_.push_back(brick);
    for (const int n : nodes_of_brick[b]) members_.push_back({n, trilinear<float>(places_[n].within)});
  }

  std::vector<std::vector<int>> bricks_of_point(narrow_.size());
  for (std::size_t b = 0; b < bricks_.size(); ++b) {
    for (int k = 0; k < 8; ++k) bricks_of_point[bricks_[b].corners[k]].push_back(static_cast<int>(8 * b) + k);
  }
  bricks_of_point_.starts.push_back(0);
  for (std::size_t p = 0; p < narrow_.size(); ++p) {
    bricks_of_point_.items.insert(bricks_of_point_.items.end(), bricks_of_point[p].begin(), bricks_of_point[p].end());
    bricks_of_point_.starts.push_back(bricks_of_point_.items.size());
    const auto weights = trilinear<float>(within_wide_cell(narrow_[p], Eigen::Vector3d::Zero()));
    shares_.emplace_back();
    for (int k = 0; k < 8; ++k) {
      if (weights[k] == 0) continue;
      shares_.back().push_back({wide_numbers.find(wide_cell(narrow_[p]) + corner_offset(k)), weights[k]});
    }
  }
  brick_sums_.resize(8 * bricks_.size());
  narrow_values_.resize(narrow_.size());
  narrow_inverse_.assign(narrow_.size(), Eigen::Matrix3f::Zero());
  wide_values_ = Eigen::VectorXf::Zero(3 * static_cast<Eigen::Index>(wide_.size()));
  wide_shift_ = wide_values_;
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

void LatticePreconditioner::refresh_lattices(const BlockCsr& matrix) {
  refresh_narrow(matrix);
  auto factor = CholeskyFactor::create(wide_matrix(matrix), std::uint64_t{1} << 30);
  constexpr Eigen::Index maximum_unknowns_to_invert = 1536;
  factor_.reset();
  wide_inverse_.resize(0, 0);
  if (!factor) return;
  if (wide_values_.size() > maximum_unknowns_to_invert) {
    factor_ = std::move(*factor);
  } else {
    wide_inverse_ = factor->solve(Eigen::MatrixXd::Identity(wide_values_.size(), wide_values_.size())).cast<float>();
  }
}

void LatticePreconditioner::refresh_narrow(const BlockCsr& matrix) {
  std::vector<Eigen::Matrix3d> diagonal(narrow_.size(), Eigen::Matrix3d::Zero());
  for (int row = 0; row < matrix.rows(); ++row) {
    std::array<Eigen::Matrix3d, 8> product;  // the row times P, at the corners around the node
    product.fill(Eigen::Matrix3d::Zero());
    for (const int* column = matrix.columns().begin(row); column != matrix.columns().end(row); ++column) {
      const Eigen::Vector3i apart = places_[row].cell - places_[*column].cell;
      if ((apart.array().abs() > 1).any()) continue;  // no corner in common
      const Eigen::Matrix3d block = free_block(matrix, static_cast<std::size_t>(column - matrix.columns().items.data()),
                                               mask_.data() + 3 * row, mask_.data() + 3 * *column);
      const auto weights = trilinear<double>(places_[*column].within);
      for (int k = 0; k < 8; ++k) {
        const Eigen::Vector3i at = corner_offset(k) + apart;
        if ((at.array() >= 0).all() && (at.array() <= 1).all()) {
          product[k] += weights[at.x() + 2 * at.y() + 4 * at.z()] * block;
        }
      }
    }
    const auto weights = trilinear<double>(places_[row].within);
    for (int k = 0; k < 8; ++k) diagonal[bricks_[places_[row].brick].corners[k]] += weights[k] * product[k];
  }
  // Neighbouring points move largely the same nodes, so that together they answer a residual several times over: w.
  constexpr double damping = 0.4;
  for (std::size_t p = 0; p < narrow_.size(); ++p) {
    for (int d = 0; d < 3; ++d) {
      double& own = diagonal[p](d, d);
      own = own > 0 ? own * (1 + 1e-5) : 1.0;  // as in wide_matrix
    }
    narrow_inverse_[p] = (damping * diagonal[p].inverse()).cast<float>();
  }
}

// The lower triangle.
Eigen::SparseMatrix<double> LatticePreconditioner::wide_matrix(const BlockCsr& matrix) const {
  Numbers numbers;
  std::vector<Eigen::Vector3i> again;
  for (const Eigen::Vector3i& point : wide_) numbers.of(point, again);
  std::vector<Stencil> stencils(wide_.size());
  for (int row = 0; row < matrix.rows(); ++row) {
    // The row times P Q, by point: those from one before the node's cell to two after it, along each axis.
    const Eigen::Vector3i cell = wide_cell(places_[row].cell);
    std::array<Eigen::Matrix3d, 64> product;
    product.fill(Eigen::Matrix3d::Zero());
    for (const int* column = matrix.columns().begin(row); column != matrix.columns().end(row); ++column) {
      const Place& other = places_[*column];
      const Eigen::Matrix3d block = free_block(matrix, static_cast<std::size_t>(column - matrix.columns().items.data()),
                                               mask_.data() + 3 * row, mask_.data() + 3 * *column);
      const Eigen::Vector3i apart = wide_cell(other.cell) - cell + Eigen::Vector3i::Ones();
      GLISSON_ASSERT((apart.array() >= 0).all() && (apart.array() <= 2).all());
      const auto weights = trilinear<double>(within_wide_cell(other.cell, other.within));
      for (int k = 0; k < 8; ++k) {
        const Eigen::Vector3i slot = apart + corner_offset(k);
        product[(slot.z() * 4 + slot.y()) * 4 + slot.x()] += weights[k] * block;
      }
    }
    const auto weights = trilinear<double>(within_wide_cell(places_[row].cell, places_[row].within));
    for (int k = 0; k < 8; ++k) {
      Stencil& stencil = stencils[numbers.find(cell + corner_offset(k))];
      for (int slot = 0; slot < 64; ++slot) {
        if (product[slot].isZero(0)) continue;
        const Eigen::Vector3i place = Eigen::Vector3i(slot % 4, slot / 4 % 4, slot / 16) - Eigen::Vector3i::Ones();
        stencil.blocks[Stencil::slot(place - corner_offset(k))] += weights[k] * product[slot];
      }
    }
  }

  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t p = 0; p < wide_.size(); ++p) {
    for (int slot = 0; slot < 125; ++slot) {
      if (stencils[p].blocks[slot].isZero(0)) continue;
      const Eigen::Vector3i apart = Eigen::Vector3i(slot % 5, slot / 5 % 5, slot / 25) - Eigen::Vector3i::Constant(2);
      const int other = numbers.find(wide_[p] + apart);
      if (other < 0) continue;
      for (int r = 0; r < 3; ++r) {
        for (int c = 0; c < 3; ++c) {
          const int row = 3 * static_cast<int>(p) + r, column = 3 * other + c;
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
  Eigen::SparseMatrix<double> lower(wide_values_.size(), wide_values_.size());
  lower.setFromTriplets(entries.begin(), entries.end());
  return lower;
}

double LatticePreconditioner::apply(const std::vector<float>& r, std::vector<float>& z) {
  using Vector4 = Eigen::Vector4f;  // the fourth lane is not used
  using Read = Eigen::Map<const Vector4>;
  constexpr std::size_t bricks_in_chunk = 16, points_in_chunk = 512;
  // Down: each brick's nodes are read once for all its corners. r is already zero where held.
  parallel_for(bricks_.size(), bricks_in_chunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t b = begin; b < end; ++b) {
      std::array<Vector4, 8> sums;
      sums.fill(Vector4::Zero());
      for (std::size_t m = bricks_[b].begin; m < bricks_[b].end; ++m) {
        const Vector4 value = Read(r.data() + 3 * static_cast<std::size_t>(members_[m].node));
        for (int k = 0; k < 8; ++k) sums[k] += members_[m].weights[k] * value;
      }
      std::copy(sums.begin(), sums.end(), brick_sums_.begin() + static_cast<std::ptrdiff_t>(8 * b));
    }
  });
  parallel_for(narrow_.size(), points_in_chunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t p = begin; p < end; ++p) {
      Vector4 sum = Vector4::Zero();
      const auto point = static_cast<int>(p);
      for (const int* at = bricks_of_point_.begin(point); at != bricks_of_point_.end(point); ++at) {
        sum += brick_sums_[*at];
      }
      narrow_values_[p] = sum;
    }
  });
  wide_values_.setZero();
  for (std::size_t p = 0; p < narrow_.size(); ++p) {
    for (const Share& share : shares_[p]) {
      wide_values_.segment<3>(3 * share.point) += share.weight * narrow_values_[p].head<3>();
    }
  }

  if (factor_) {
    wide_shift_ = factor_->solve(wide_values_.cast<double>()).cast<float>();
  } else if (wide_inverse_.size() > 0) {
    constexpr std::size_t columns_at_once = 96;  // symmetric: columns are rows, and lie together
    parallel_for(static_cast<std::size_t>(wide_values_.size()), columns_at_once,
                 [&](std::size_t begin, std::size_t end) {
                   for (auto k = static_cast<Eigen::Index>(begin); k < static_cast<Eigen::Index>(end); ++k) {
                     wide_shift_[k] = wide_inverse_.col(k).dot(wide_values_);
                   }
                 });
  } else {
    wide_shift_.setZero();
  }

  // And up again.
  parallel_for(narrow_.size(), points_in_chunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t p = begin; p < end; ++p) {
      Eigen::Vector3f shift = narrow_inverse_[p] * narrow_values_[p].head<3>();
      for (const Share& share : shares_[p]) shift += share.weight * wide_shift_.segment<3>(3 * share.point);
      narrow_values_[p].head<3>() = shift;
    }
  });
  partial_.assign((bricks_.size() + bricks_in_chunk - 1) / bricks_in_chunk, 0.0);
  parallel_for(partial_.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t chunk = begin; chunk < end; ++chunk) {
      double dot = 0;
      for (std::size_t b = chunk * bricks_in_chunk; b < std::min((chunk + 1) * bricks_in_chunk, bricks_.size()); ++b) {
        std::array<Vector4, 8> corners;
        for (int k = 0; k < 8; ++k) corners[k] = narrow_values_[bricks_[b].corners[k]];
        for (std::size_t m = bricks_[b].begin; m < bricks_[b].end; ++m) {
          const auto n = static_cast<std::size_t>(members_[m].node);
          const float* own = inverse_diagonal_.data() + 9 * n;
          const float* residual = r.data() + 3 * n;
          Vector4 sum = Vector4::Zero(), near = Read(own) * residual[0];
          for (int k = 0; k < 8; k += 2) {
            sum += members_[m].weights[k] * corners[k];
            near += members_[m].weights[k + 1] * corners[k + 1];
          }
          near += Read(own + 3) * residual[1];
          sum += Read(own + 6) * residual[2];
          // What is held stays: its residual is zero, and its row of D^-1 takes nothing from the others.
          const Vector4 value = Read(mask_.data() + 3 * n).cwiseProduct(sum + near);
          for (int d = 0; d < 3; ++d) z[3 * n + d] = value[d];
          dot += static_cast<double>(value[0] * residual[0] + value[1] * residual[1] + value[2] * residual[2]);
        }
      }
      partial_[chunk] = dot;
    }
  });
  return std::accumulate(partial_.begin(), partial_.end(), 0.0);
}

}  // namespace glisson::mechanics
