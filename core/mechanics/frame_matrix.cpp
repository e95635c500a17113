#include "mechanics/frame_matrix.h"

#include <cmath>

#include "base/parallel.h"

namespace glisson::mechanics {
namespace {

using Share = FrameBasis::Share;
using Eigen::Vector3d;

// Which of the frames around are wanted.
enum class Around { all, frames_of_the_point };

// The 12 rows of K P that belong to the affine field of one point of the mesh: for each frame around, a 12x12 block.
class RowsOfPoint {
 public:
  void make(const BlockMatrix<double>& stiffness, const FrameBasis& basis, int point, Around around,
            std::vector<int>& slot_of_frame);

  std::vector<int> frames;
  std::vector<FrameBlock> blocks;

 private:
  void couple_points(const BlockMatrix<double>& stiffness, const FrameBasis& basis, int point);

  std::vector<int> points_;          // those that share a cell with the point
  std::vector<FrameBlock> coupled_;  // how their fields push on the point's
};

constexpr int points_at_once = 256;

}  // namespace

Lists frames_that_meet(const FrameBasis& basis) {
  std::vector<std::vector<int>> meet(static_cast<std::size_t>(basis.frames()));
  parallel_for(meet.size(), 64, [&](std::size_t begin, std::size_t end) {
    std::vector<int> point_seen_by(static_cast<std::size_t>(basis.points()), -1);
    std::vector<int> frame_seen_by(meet.size(), -1);
    for (auto frame = static_cast<int>(begin); frame < static_cast<int>(end); ++frame) {
      std::vector<int>& list = meet[frame];
      list.push_back(frame);  // a frame that acts nowhere still has its own block
      frame_seen_by[frame] = frame;
      const auto look_at = [&](int point) {
        if (point < 0 || point_seen_by[point] == frame) return;
        point_seen_by[point] = frame;
        for (const Share* share = basis.shares_begin(point); share != basis.shares_end(point); ++share) {
          if (frame_seen_by[share->frame] == frame) continue;
          frame_seen_by[share->frame] = frame;
          list.push_back(share->frame);
        }
      };
      for (const auto& reach : basis.points_of(frame)) {
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

Eigen::VectorXd FrameMatrix::operator*(const Eigen::VectorXd& x) const {
  Eigen::VectorXd y(x.size());
  parallel_for(static_cast<std::size_t>(rows()), 32, [&](std::size_t begin, std::size_t end) {
    for (auto row = static_cast<int>(begin); row < static_cast<int>(end); ++row) {
      Eigen::Matrix<double, frame_size, 1> sum = Eigen::Matrix<double, frame_size, 1>::Zero();
      for (std::size_t k = columns_.starts[row]; k < columns_.starts[row + 1]; ++k) {
        sum.noalias() += blocks_[k] * x.segment<frame_size>(frame_size * columns_.items[k]);
      }
      y.segment<frame_size>(frame_size * row) = sum;
    }
  });
  return y;
}

Eigen::SparseMatrix<double> FrameMatrix::lower() const {
  const Eigen::Index size = Eigen::Index{frame_size} * rows();
  Eigen::SparseMatrix<double> matrix(size, size);
  Eigen::VectorXi counts(size);
  for (int row = 0; row < rows(); ++row) {
    const auto below =
        static_cast<int>(columns_.end(row) - std::lower_bound(columns_.begin(row), columns_.end(row), row));
    for (int c = 0; c < frame_size; ++c) counts[frame_size * row + c] = frame_size * below - c;
  }
  matrix.reserve(counts);
  // Column j of the lower triangle is row j of the upper one.
  for (int row = 0; row < rows(); ++row) {
    for (int c = 0; c < frame_size; ++c) {
      for (std::size_t k = position(row, row); k < columns_.starts[row + 1]; ++k) {
        const int other = columns_.items[k];
        for (int r = other == row ? c : 0; r < frame_size; ++r) {
          matrix.insert(frame_size * other + r, frame_size * row + c) = blocks_[k](c, r);
        }
      }
    }
  }
  matrix.makeCompressed();
  return matrix;
}

FrameMatrix FrameMatrix::sum(double a, const FrameMatrix& first, double b, const FrameMatrix& second) {
  FrameMatrix result = first;
  for (std::size_t k = 0; k < result.blocks_.size(); ++k) {
    result.blocks_[k] = a * first.blocks_[k] + b * second.blocks_[k];
  }
  return result;
}

namespace {

// Makes the rows of all points, a stretch of them at a time on all cores, and then lets the rows of each frame take
// what its points have for it: each frame takes its points in one order, so that sums do not depend on the threads.
// `take(frame, share, rows)` is given every point of a frame in turn.
template <typename Take>
void visit_rows(const BlockMatrix<double>& stiffness, const FrameBasis& basis, Around around, const Take& take) {
  const auto frames = static_cast<std::size_t>(basis.frames());
  std::vector<RowsOfPoint> rows(static_cast<std::size_t>(std::min(basis.points(), points_at_once)));
  std::vector<std::size_t> next(frames, 0);  // of each frame's points, the first that is still to come
  for (int first = 0; first < basis.points(); first += points_at_once) {
    const int last = std::min(first + points_at_once, basis.points());
    parallel_for(static_cast<std::size_t>(last - first), 8, [&](std::size_t begin, std::size_t end) {
      std::vector<int> slot_of_frame(frames, -1);
      for (std::size_t k = begin; k < end; ++k) {
        rows[k].make(stiffness, basis, first + static_cast<int>(k), around, slot_of_frame);
      }
    });
    parallel_for(frames, 64, [&](std::size_t begin, std::size_t end) {
      take(begin, end, [&](std::size_t frame, const auto& with) {
        const auto& own = basis.points_of(static_cast<int>(frame));
        for (; next[frame] < own.size() && own[next[frame]].point < last; ++next[frame]) {
          const FrameBasis::Reach& at = own[next[frame]];
          with(basis.shares_begin(at.point)[at.share], rows[static_cast<std::size_t>(at.point - first)]);
        }
      });
    });
  }
}

// target += T^T block, T being how the point's field follows the frame.
void add_seen_from_frame(const Share& share, const FrameBlock& block, FrameBlock& target) {
  target.topRows<3>() += share.weight * block.topRows<3>();
  for (int k = 0; k < 3; ++k) {
    target.middleRows<3>(3 * k + 3) +=
        share.arm[k] * block.topRows<3>() + share.slope_per_mm * block.middleRows<3>(3 * k + 3);
  }
}

}  // namespace

FrameMatrix reduced(const BlockMatrix<double>& stiffness, const FrameBasis& basis) {
  return reduced(stiffness, basis, frames_that_meet(basis));
}

FrameMatrix reduced(const BlockMatrix<double>& stiffness, const FrameBasis& basis, Lists frames_meeting) {
  FrameMatrix matrix(std::move(frames_meeting));
  const auto frames = static_cast<std::size_t>(basis.frames());
  visit_rows(stiffness, basis, Around::all, [&](std::size_t begin, std::size_t end, const auto& points_of) {
    std::vector<FrameBlock*> block_of(frames, nullptr);
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
        for (std::size_t k = 0; k < rows.frames.size(); ++k) {
          if (rows.frames[k] < row) continue;  // the other triangle
          add_seen_from_frame(share, rows.blocks[k], *block_of[static_cast<std::size_t>(rows.frames[k])]);
        }
      });
    }
  });
  for (int row = 0; row < basis.frames(); ++row) {
    for (std::size_t k = matrix.columns().starts[row]; matrix.columns().items[k] < row; ++k) {
      matrix.blocks()[k] = matrix.blocks()[matrix.position(matrix.columns().items[k], row)].transpose();
    }
  }
  return matrix;
}

std::vector<FrameBlock> diagonal_reduced(const BlockMatrix<double>& stiffness, const FrameBasis& basis) {
  std::vector<FrameBlock> diagonal(static_cast<std::size_t>(basis.frames()), FrameBlock::Zero());
  visit_rows(
      stiffness, basis, Around::frames_of_the_point, [&](std::size_t begin, std::size_t end, const auto& points_of) {
        for (std::size_t i = begin; i < end; ++i) {
          points_of(i, [&](const Share& share, const RowsOfPoint& rows) {
            const auto own = std::find(rows.frames.begin(), rows.frames.end(), share.frame);
            add_seen_from_frame(share, rows.blocks[static_cast<std::size_t>(own - rows.frames.begin())], diagonal[i]);
          });
        }
      });
  return diagonal;
}

namespace {

void RowsOfPoint::make(const BlockMatrix<double>& stiffness, const FrameBasis& basis, int point, Around around,
                       std::vector<int>& slot_of_frame) {
  couple_points(stiffness, basis, point);
  frames.clear();
  const auto want_frames_of = [&](int p) {
    for (const Share* share = basis.shares_begin(p); share != basis.shares_end(p); ++share) {
      if (slot_of_frame[share->frame] >= 0) continue;
      slot_of_frame[share->frame] = static_cast<int>(frames.size());
      frames.push_back(share->frame);
    }
  };
  if (around == Around::frames_of_the_point) {
    want_frames_of(point);
  } else {
    for (const int p : points_) want_frames_of(p);
  }
  blocks.assign(frames.size(), FrameBlock::Zero());
  for (std::size_t q = 0; q < points_.size(); ++q) {
    const FrameBlock& block = coupled_[q];
    for (const Share* share = basis.shares_begin(points_[q]); share != basis.shares_end(points_[q]); ++share) {
      const int slot = slot_of_frame[share->frame];
      if (slot < 0) continue;
      FrameBlock& target = blocks[static_cast<std::size_t>(slot)];
      target.leftCols<3>() += share->weight * block.leftCols<3>();
      for (int k = 0; k < 3; ++k) {
        target.middleCols<3>(3 * k + 3) +=
            share->arm[k] * block.leftCols<3>() + share->slope_per_mm * block.middleCols<3>(3 * k + 3);
      }
    }
  }
  for (const int frame : frames) slot_of_frame[frame] = -1;
}

void RowsOfPoint::couple_points(const BlockMatrix<double>& stiffness, const FrameBasis& basis, int point) {
  using Strip = Eigen::Matrix<double, 3, frame_size>;
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
  coupled_.assign(points_.size(), FrameBlock::Zero());
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
