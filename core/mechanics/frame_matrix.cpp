#include "mechanics/frame_matrix.h"

#include <cmath>

#include "base/parallel.h"

namespace glisson::mechanics {
namespace {

using Share = FrameBasis::Share;
using Eigen::Vector3d;

Lists frames_that_meet(const geometry::TetMesh& mesh, const ShapeFunctions& shape);

// The three rows of K P at a place: for each frame that a neighbour of the place follows, 3x12.
struct StripsOfPlace {
  using Strip = Eigen::Matrix<double, 3, frame_size>;
  std::vector<int> frames;
  std::vector<Strip> strips;

  void make(const Eigen::SparseMatrix<double>& full, const FrameBasis& basis, int place);
};

}  // namespace

double frame_length_mm(const ShapeFunctions& shape, int frame) {
  return std::cbrt(std::max(shape.node_volumes_mm3[frame], 1e-9));
}

Eigen::VectorXd affine_frames(const ShapeFunctions& shape, const std::function<Vector3d(const Vector3d&)>& field) {
  Eigen::VectorXd q(frame_size * static_cast<Eigen::Index>(shape.nodes_mm.size()));
  for (int frame = 0; frame < static_cast<int>(shape.nodes_mm.size()); ++frame) {
    const Vector3d here_mm = shape.nodes_mm[frame];
    const Vector3d here = field(here_mm);
    q.segment<3>(frame_size * frame) = here;
    for (int axis = 0; axis < 3; ++axis) {
      q.segment<3>(frame_size * frame + 3 * (axis + 1)) =
          field(here_mm + frame_length_mm(shape, frame) * Vector3d::Unit(axis)) - here;
    }
  }
  return q;
}

FrameBasis::FrameBasis(const geometry::TetMesh& mesh, const NodeLayout& layout, const ShapeFunctions& shape)
    : frames_of_(static_cast<std::size_t>(layout.nodes())),
      places_of_(shape.nodes_mm.size()),
      neighbours_(frames_that_meet(mesh, shape)) {
  const auto add = [&](int place, int point, double part) {
    for (std::size_t k = shape.starts[point]; k < shape.starts[point + 1]; ++k) {
      const int frame = shape.nodes[k];
      const Vector3d arm = (layout.positions_mm[place] - shape.nodes_mm[frame]) / frame_length_mm(shape, frame);
      const double w = part * shape.weights[k];
      const Eigen::Vector4d factor(w, w * arm.x(), w * arm.y(), w * arm.z());
      auto& shares = frames_of_[place];
      const auto known =
          std::find_if(shares.begin(), shares.end(), [&](const Share& share) { return share.place_or_frame == frame; });
      if (known == shares.end()) {
        shares.push_back({frame, factor});
      } else {
        known->factor += factor;
      }
    }
  };
  for (std::size_t p = 0; p < mesh.points_mm.size(); ++p) {
    if (layout.node_of_point[p] >= 0) add(layout.node_of_point[p], static_cast<int>(p), 1.0);
  }
  for (std::size_t e = 0; e < layout.edges.size(); ++e) {
    for (const int end : layout.edges[e]) add(layout.corner_nodes + static_cast<int>(e), end, 0.5);
  }
  for (std::size_t place = 0; place < frames_of_.size(); ++place) {
    for (const Share& share : frames_of_[place]) {
      places_of_[share.place_or_frame].push_back({static_cast<int>(place), share.factor});
    }
  }
}

Eigen::VectorXd FrameBasis::displacement(const Eigen::VectorXd& q) const {
  Eigen::VectorXd u(3 * static_cast<Eigen::Index>(frames_of_.size()));
  parallel_for(frames_of_.size(), 1024, [&](std::size_t begin, std::size_t end) {
    for (std::size_t place = begin; place < end; ++place) {
      Vector3d sum = Vector3d::Zero();
      for (const Share& share : frames_of_[place]) {
        const Eigen::Map<const Eigen::Matrix<double, 3, 4>> frame(q.data() + frame_size * share.place_or_frame);
        sum += frame * share.factor;
      }
      u.segment<3>(3 * static_cast<Eigen::Index>(place)) = sum;
    }
  });
  return u;
}

Eigen::VectorXd FrameBasis::reduce(const Eigen::VectorXd& force) const {
  Eigen::VectorXd reduced_force(unknowns());
  parallel_for(places_of_.size(), 32, [&](std::size_t begin, std::size_t end) {
    for (std::size_t frame = begin; frame < end; ++frame) {
      Eigen::Matrix<double, 3, 4> sum = Eigen::Matrix<double, 3, 4>::Zero();
      for (const Share& share : places_of_[frame]) {
        sum += force.segment<3>(3 * share.place_or_frame) * share.factor.transpose();
      }
      Eigen::Map<Eigen::Matrix<double, 3, 4>>(reduced_force.data() + frame_size * static_cast<Eigen::Index>(frame)) =
          sum;
    }
  });
  return reduced_force;
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

// K P is made a stretch of places at a time, a strip of 3x12 for each frame that a place's neighbours follow, and
// handed on to the rows of P^T (K P) while it is at hand: every strip is used by a dozen frames. Rows are shared out
// among threads, and each takes its places in one order, so that the sums do not depend on how.
FrameMatrix reduced(const Eigen::SparseMatrix<double>& lower, const FrameBasis& basis) {
  const Eigen::SparseMatrix<double> full = lower.selfadjointView<Eigen::Lower>();
  FrameMatrix matrix(basis.neighbours());
  const auto frames = static_cast<std::size_t>(basis.frames());
  const auto places = static_cast<std::size_t>(full.cols() / 3);
  constexpr std::size_t places_at_once = 4096;
  std::vector<StripsOfPlace> strips(std::min(places, places_at_once));
  std::vector<std::size_t> next(frames, 0);  // of each frame's places, the first that is still to come
  for (std::size_t first = 0; first < places; first += places_at_once) {
    const std::size_t last = std::min(first + places_at_once, places);
    parallel_for(last - first, 64, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k) strips[k].make(full, basis, static_cast<int>(first + k));
    });
    parallel_for(frames, 16, [&](std::size_t begin, std::size_t end) {
      std::vector<FrameBlock*> block_of(frames, nullptr);
      for (std::size_t i = begin; i < end; ++i) {
        const std::vector<Share>& own = basis.places_of(static_cast<int>(i));
        if (next[i] == own.size() || static_cast<std::size_t>(own[next[i]].place_or_frame) >= last) continue;
        const auto row = static_cast<int>(i);
        for (std::size_t k = matrix.position(row, row); k < matrix.columns().starts[i + 1]; ++k) {
          block_of[static_cast<std::size_t>(matrix.columns().items[k])] = &matrix.blocks()[k];
        }
        for (; next[i] < own.size() && static_cast<std::size_t>(own[next[i]].place_or_frame) < last; ++next[i]) {
          const Share& at = own[next[i]];
          const StripsOfPlace& here = strips[static_cast<std::size_t>(at.place_or_frame) - first];
          for (std::size_t k = 0; k < here.frames.size(); ++k) {
            if (here.frames[k] < row) continue;  // the other triangle
            FrameBlock& target = *block_of[static_cast<std::size_t>(here.frames[k])];
            for (int l = 0; l < 4; ++l) target.middleRows<3>(3 * l) += at.factor[l] * here.strips[k];
          }
        }
      }
    });
  }
  for (int row = 0; row < basis.frames(); ++row) {
    for (std::size_t k = matrix.columns().starts[row]; matrix.columns().items[k] < row; ++k) {
      matrix.blocks()[k] = matrix.blocks()[matrix.position(matrix.columns().items[k], row)].transpose();
    }
  }
  return matrix;
}

void add_springs(const std::vector<double>& stiffness, const FrameBasis& basis, FrameMatrix& matrix) {
  for (std::size_t place = 0; place < stiffness.size() / 3; ++place) {
    const Eigen::Map<const Vector3d> springs(stiffness.data() + 3 * place);
    if (springs.isZero()) continue;
    for (const Share& a : basis.frames_of(static_cast<int>(place))) {
      for (const Share& b : basis.frames_of(static_cast<int>(place))) {
        FrameBlock& block = matrix.blocks()[matrix.position(a.place_or_frame, b.place_or_frame)];
        for (int k = 0; k < 4; ++k) {
          for (int l = 0; l < 4; ++l) {
            block.block<3, 3>(3 * k, 3 * l).diagonal() += a.factor[k] * b.factor[l] * springs;
          }
        }
      }
    }
  }
}

namespace {

void StripsOfPlace::make(const Eigen::SparseMatrix<double>& full, const FrameBasis& basis, int place) {
  const double* values = full.valuePtr();
  const int* rows = full.innerIndexPtr();
  const int* starts = full.outerIndexPtr();
  const int column = 3 * place;
  frames.clear();
  for (int entry = starts[column]; entry < starts[column + 1]; entry += 3) {
    for (const Share& other : basis.frames_of(rows[entry] / 3)) frames.push_back(other.place_or_frame);
  }
  std::sort(frames.begin(), frames.end());
  frames.erase(std::unique(frames.begin(), frames.end()), frames.end());
  strips.assign(frames.size(), Strip::Zero());
  for (int entry = 0; starts[column] + entry < starts[column + 1]; entry += 3) {
    Eigen::Matrix3d block;  // of this place (rows) and the other (columns)
    for (int c = 0; c < 3; ++c) {
      for (int r = 0; r < 3; ++r) block(c, r) = values[starts[column + c] + entry + r];
    }
    for (const Share& other : basis.frames_of(rows[starts[column] + entry] / 3)) {
      const auto slot = std::lower_bound(frames.begin(), frames.end(), other.place_or_frame) - frames.begin();
      Strip& strip = strips[static_cast<std::size_t>(slot)];
      for (int l = 0; l < 4; ++l) strip.middleCols<3>(3 * l) += other.factor[l] * block;
    }
  }
}

Lists frames_that_meet(const geometry::TetMesh& mesh, const ShapeFunctions& shape) {
  std::vector<std::vector<int>> meet(shape.nodes_mm.size());
  std::vector<int> here;
  for (const auto& cell : mesh.cells) {
    here.clear();
    for (const int point : cell) {
      here.insert(here.end(), shape.nodes.begin() + static_cast<std::ptrdiff_t>(shape.starts[point]),
                  shape.nodes.begin() + static_cast<std::ptrdiff_t>(shape.starts[point + 1]));
    }
    std::sort(here.begin(), here.end());
    here.erase(std::unique(here.begin(), here.end()), here.end());
    for (const int frame : here) {
      auto& list = meet[frame];
      list.insert(list.end(), here.begin(), here.end());
      if (list.size() > 4096) {  // repeated often: kept short
        std::sort(list.begin(), list.end());
        list.erase(std::unique(list.begin(), list.end()), list.end());
      }
    }
  }
  Lists lists;
  lists.starts.push_back(0);
  for (std::size_t frame = 0; frame < meet.size(); ++frame) {
    auto& list = meet[frame];
    list.push_back(static_cast<int>(frame));  // a frame that acts nowhere still has its own block
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
    lists.items.insert(lists.items.end(), list.begin(), list.end());
    lists.starts.push_back(lists.items.size());
  }
  return lists;
}

}  // namespace
}  // namespace glisson::mechanics
