#include "mechanics/meshfree/internal/reduced_matrix.h"

#include <cmath>

#include "base/parallel.h"

namespace glisson::mechanics {
namespace {

using Share = AffineBasis::Share;
using Eigen::Vector3d;

// Which of the handles around are wanted.
enum class Around { all, handles_of_the_point };

// The 12 rows of K P that belong to the affine field of one point of the mesh: for each handle around, a 12x12 block.
class RowsOfPoint {
 public:
  void make(const BlockMatrix<double>& stiffness, const AffineBasis& basis, int point, Around around,
            std::vector<int>& slot_of_handle);

  std::vector<int> handles;
  std::vector<HandleBlock> blocks;

 private:
  void couple_points(const BlockMatrix<double>& stiffness, const AffineBasis& basis, int point);

  std::vector<int> points_;           // those that share a cell with the point
  std::vector<HandleBlock> coupled_;  // how their fields push on the point's
};

constexpr int points_at_once = 256;

}  // namespace

Lists handles_that_meet(const AffineBasis& basis) {
  std::vector<std::vector<int>> meet(static_cast<std::size_t>(basis.handles()));
  parallel_for(meet.size(), 64, [&](std::size_t begin, std::size_t end) {
    std::vector<int> point_seen_by(static_cast<std::size_t>(basis.points()), -1);
    std::vector<int> handle_seen_by(meet.size(), -1);
    for (auto handle = static_cast<int>(begin); handle < static_cast<int>(end); ++handle) {
      std::vector<int>& list = meet[handle];
      list.push_back(handle);  // a handle that acts nowhere still has its own block
      handle_seen_by[handle] = handle;
      const auto look_at = [&](int point) {
        if (point < 0 || point_seen_by[point] == handle) return;
        point_seen_by[point] = handle;
        for (const Share* share = basis.shares_begin(point); share != basis.shares_end(point); ++share) {
          if (handle_seen_by[share->handle] == handle) continue;
          handle_seen_by[share->handle] = handle;
          list.push_back(share->handle);
        }
      };
      for (const auto& reach : basis.points_of(handle)) {
        const Lists& places = basis.places_of_point();  // points that share a cell share an edge
        for (const int* place = places.begin(reach.point); place != places.end(reach.point); ++place) {
          for (const auto& at : basis.ends_of(*place)) look_at(at.point);
        }
      }
      std::sort(list.begin(), list.end());
    }
  });
  Lists lists;
  lists.starts.push_back(0);
  for (const auto& list : meet) {
    lists.items.insert(lists.items.end(), list.begin(), list.end());
    lists.starts.push_back(lists.items.size());
  }
  return lists;
}

Eigen::VectorXd ReducedMatrix::operator*(const Eigen::VectorXd& x) const {
  Eigen::VectorXd y(x.size());
  parallel_for(static_cast<std::size_t>(rows()), 32, [&](std::size_t begin, std::size_t end) {
    for (auto row = static_cast<int>(begin); row < static_cast<int>(end); ++row) {
      Eigen::Matrix<double, handle_size, 1> sum = Eigen::Matrix<double, handle_size, 1>::Zero();
      for (std::size_t k = columns_.starts[row]; k < columns_.starts[row + 1]; ++k) {
        sum.noalias() += blocks_[k] * x.segment<handle_size>(handle_size * columns_.items[k]);
      }
      y.segment<handle_size>(handle_size * row) = sum;
    }
  });
  return y;
}

Eigen::MatrixXd ReducedMatrix::times_columns(const Eigen::MatrixXd& x) const {
  using Rows = Eigen::Matrix<double, handle_size, Eigen::Dynamic>;
  Eigen::MatrixXd y(x.rows(), x.cols());
  parallel_for(static_cast<std::size_t>(rows()), 8, [&](std::size_t begin, std::size_t end) {
    for (auto row = static_cast<int>(begin); row < static_cast<int>(end); ++row) {
      Rows sum = Rows::Zero(handle_size, x.cols());
      for (std::size_t k = columns_.starts[row]; k < columns_.starts[row + 1]; ++k) {
        sum.noalias() += blocks_[k] * x.middleRows<handle_size>(handle_size * columns_.items[k]);
      }
      y.middleRows<handle_size>(handle_size * row) = sum;
    }
  });
  return y;
}

Eigen::SparseMatrix<double> ReducedMatrix::lower() const {
  const Eigen::Index size = Eigen::Index{handle_size} * rows();
  Eigen::SparseMatrix<double> matrix(size, size);
  Eigen::VectorXi counts(size);
  for (int row = 0; row < rows(); ++row) {
    const auto below =
        static_cast<int>(columns_.end(row) - std::lower_bound(columns_.begin(row), columns_.end(row), row));
    for (int c = 0; c < handle_size; ++c) counts[handle_size * row + c] = handle_size * below - c;
  }
  matrix.reserve(counts);
  // Column j of the lower triangle is row j of the upper one.
  for (int row = 0; row < rows(); ++row) {
    for (int c = 0; c < handle_size; ++c) {
      for (std::size_t k = position(row, row); k < columns_.starts[row + 1]; ++k) {
        const int other = columns_.items[k];
        for (int r = other == row ? c : 0; r < handle_size; ++r) {
          matrix.insert(handle_size * other + r, handle_size * row + c) = blocks_[k](c, r);
        }
      }
    }
  }
  matrix.makeCompressed();
  return matrix;
}

ReducedMatrix ReducedMatrix::sum(double a, const ReducedMatrix& first, double b, const ReducedMatrix& second) {
  ReducedMatrix result = first;
  for (std::size_t k = 0; k < result.blocks_.size(); ++k) {
    result.blocks_[k] = a * first.blocks_[k] + b * second.blocks_[k];
  }
  return result;
}

namespace {

// Makes the rows of all points, a stretch of them at a time on all cores, and then lets the rows of each handle take
// what its points have for it: each handle takes its points in one order, so that sums do not depend on the threads.
// `take(handle, share, rows)` is given every point of a handle in turn.
template <typename Take>
void visit_rows(const BlockMatrix<double>& stiffness, const AffineBasis& basis, Around around, const Take& take) {
  const auto handles = static_cast<std::size_t>(basis.handles());
  std::vector<RowsOfPoint> rows(static_cast<std::size_t>(std::min(basis.points(), points_at_once)));
  std::vector<std::size_t> next(handles, 0);  // of each handle's points, the first that is still to come
  for (int first = 0; first < basis.points(); first += points_at_once) {
    const int last = std::min(first + points_at_once, basis.points());
    parallel_for(static_cast<std::size_t>(last - first), 8, [&](std::size_t begin, std::size_t end) {
      std::vector<int> slot_of_handle(handles, -1);
      for (std::size_t k = begin; k < end; ++k) {
        rows[k].make(stiffness, basis, first + static_cast<int>(k), around, slot_of_handle);
      }
    });
    parallel_for(handles, 64, [&](std::size_t begin, std::size_t end) {
      take(begin, end, [&](std::size_t handle, const auto& with) {
        const auto& own = basis.points_of(static_cast<int>(handle));
        for (; next[handle] < own.size() && own[next[handle]].point < last; ++next[handle]) {
          const AffineBasis::Reach& at = own[next[handle]];
          with(basis.shares_begin(at.point)[at.share], rows[static_cast<std::size_t>(at.point - first)]);
        }
      });
    });
  }
}

// target += T^T block, T being how the point's field follows the handle.
void add_seen_from_handle(const Share& share, const HandleBlock& block, HandleBlock& target) {
  target.topRows<3>() += share.weight * block.topRows<3>();
  for (int k = 0; k < 3; ++k) {
    target.middleRows<3>(3 * k + 3) +=
        share.arm[k] * block.topRows<3>() + share.slope_per_mm * block.middleRows<3>(3 * k + 3);
  }
}

}  // namespace

ReducedMatrix reduced(const BlockMatrix<double>& stiffness, const AffineBasis& basis) {
  return reduced(stiffness, basis, handles_that_meet(basis));
}

ReducedMatrix reduced(const BlockMatrix<double>& stiffness, const AffineBasis& basis, Lists handles_meeting) {
  ReducedMatrix matrix(std::move(handles_meeting));
  const auto handles = static_cast<std::size_t>(basis.handles());
  visit_rows(stiffness, basis, Around::all, [&](std::size_t begin, std::size_t end, const auto& points_of) {
    std::vector<HandleBlock*> block_of(handles, nullptr);
    for (std::size_t i = begin; i < end; ++i) {
      const auto row = static_cast<int>(i);
      bool ready = false;
      points_of(i, [&](const Share& share, const RowsOfPoint& rows) {
        if (!ready) {
          for (std::size_t k = matrix.position(row, row); k < matrix.columns().starts[i + 1]; ++k) {
            block_of[static_cast<std::size_t>(matrix.columns().items[k])] = &matrix.blocks()[k];
          }
          ready = true;
        }
        for (std::size_t k = 0; k < rows.handles.size(); ++k) {
          if (rows.handles[k] < row) continue;  // the other triangle
          add_seen_from_handle(share, rows.blocks[k], *block_of[static_cast<std::size_t>(rows.handles[k])]);
        }
      });
    }
  });
  for (int row = 0; row < basis.handles(); ++row) {
    for (std::size_t k = matrix.columns().starts[row]; matrix.columns().items[k] < row; ++k) {
      matrix.blocks()[k] = matrix.blocks()[matrix.position(matrix.columns().items[k], row)].transpose();
    }
  }
  return matrix;
}

std::vector<HandleBlock> diagonal_reduced(const BlockMatrix<double>& stiffness, const AffineBasis& basis) {
  std::vector<HandleBlock> diagonal(static_cast<std::size_t>(basis.handles()), HandleBlock::Zero());
  visit_rows(
      stiffness, basis, Around::handles_of_the_point, [&](std::size_t begin, std::size_t end, const auto& points_of) {
        for (std::size_t i = begin; i < end; ++i) {
          points_of(i, [&](const Share& share, const RowsOfPoint& rows) {
            const auto own = std::find(rows.handles.begin(), rows.handles.end(), share.handle);
            add_seen_from_handle(share, rows.blocks[static_cast<std::size_t>(own - rows.handles.begin())], diagonal[i]);
          });
        }
      });
  return diagonal;
}

namespace {

void RowsOfPoint::make(const BlockMatrix<double>& stiffness, const AffineBasis& basis, int point, Around around,
                       std::vector<int>& slot_of_handle) {
  couple_points(stiffness, basis, point);
  handles.clear();
  const auto want_handles_of = [&](int p) {
    for (const Share* share = basis.shares_begin(p); share != basis.shares_end(p); ++share) {
      if (slot_of_handle[share->handle] >= 0) continue;
      slot_of_handle[share->handle] = static_cast<int>(handles.size());
      handles.push_back(share->handle);
    }
  };
  if (around == Around::handles_of_the_point) {
    want_handles_of(point);
  } else {
    for (const int p : points_) want_handles_of(p);
  }
  blocks.assign(handles.size(), HandleBlock::Zero());
  for (std::size_t q = 0; q < points_.size(); ++q) {
    const HandleBlock& block = coupled_[q];
    for (const Share* share = basis.shares_begin(points_[q]); share != basis.shares_end(points_[q]); ++share) {
      const int slot = slot_of_handle[share->handle];
      if (slot < 0) continue;
      HandleBlock& target = blocks[static_cast<std::size_t>(slot)];
      target.leftCols<3>() += share->weight * block.leftCols<3>();
      for (int k = 0; k < 3; ++k) {
        target.middleCols<3>(3 * k + 3) +=
            share->arm[k] * block.leftCols<3>() + share->slope_per_mm * block.middleCols<3>(3 * k + 3);
      }
    }
  }
  for (const int handle : handles) slot_of_handle[handle] = -1;
}

void RowsOfPoint::couple_points(const BlockMatrix<double>& stiffness, const AffineBasis& basis, int point) {
  using Strip = Eigen::Matrix<double, 3, handle_size>;
  const Lists& places = basis.places_of_point();
  points_.clear();
  for (const int* place = places.begin(point); place != places.end(point); ++place) {
    for (const int* other = stiffness.columns().begin(*place); other != stiffness.columns().end(*place); ++other) {
      for (const auto& end : basis.ends_of(*other)) {
        if (end.point >= 0) points_.push_back(end.point);
      }
    }
  }
  std::sort(points_.begin(), points_.end());
  points_.erase(std::unique(points_.begin(), points_.end()), points_.end());
  coupled_.assign(points_.size(), HandleBlock::Zero());
  std::vector<Strip> strips(points_.size());  // of one place of the point: its three rows
  for (const int* place = places.begin(point); place != places.end(point); ++place) {
    std::fill(strips.begin(), strips.end(), Strip::Zero());
    for (std::size_t k = stiffness.columns().starts[*place]; k < stiffness.columns().starts[*place + 1]; ++k) {
      const Eigen::Map<const Eigen::Matrix3d> block(stiffness.block(k));
      for (const auto& end : basis.ends_of(stiffness.columns().items[k])) {
        if (end.point < 0) break;
        const auto q = std::lower_bound(points_.begin(), points_.end(), end.point) - points_.begin();
        Strip& strip = strips[static_cast<std::size_t>(q)];
        strip.leftCols<3>() += end.part * block;
        for (int l = 0; l < 3; ++l) strip.middleCols<3>(3 * l + 3) += end.part * end.away_mm[l] * block;
      }
    }
    const auto& ends = basis.ends_of(*place);
    const auto& own = ends[ends[0].point == point ? 0 : 1];
    for (std::size_t q = 0; q < points_.size(); ++q) {
      coupled_[q].topRows<3>() += own.part * strips[q];
      for (int k = 0; k < 3; ++k) coupled_[q].middleRows<3>(3 * k + 3) += own.part * own.away_mm[k] * strips[q];
    }
  }
}

}  // namespace
}  // namespace glisson::mechanics
