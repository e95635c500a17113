#include "mechanics/turning_cells.h"

#include <Eigen/LU>
#include <numeric>

#include "base/parallel.h"
#include "mechanics/deformation.h"
#include "mechanics/shape_functions.h"

namespace glisson::mechanics {
namespace {

using Eigen::Matrix3d;

// The rotation of F = R S. Newton's iteration X <- (X + X^-T) / 2 (Higham 1986, SIAM J. Sci. Stat. Comput. 7:1160) is
// quadratic from anywhere with det > 0 and needs four or five steps from moderate strain; what is crushed or inside
// out takes the slow, sure way.
Matrix3d rotation_of(const Matrix3d& f) {
  Matrix3d x = f;
  for (int step = 0; step < 12; ++step) {
    const Matrix3d cofactor = determinant_gradient(x);
    const double determinant = x.col(0).dot(cofactor.col(0));
    if (!(determinant > 0.02)) break;
    const Matrix3d next = 0.5 * x + (0.5 / determinant) * cofactor;
    const double change = (next - x).squaredNorm();
    x = next;
    if (change < 1e-9) return x;  // the error left is about half of that square: 5e-10
  }
  return polar_decomposition(f).rotation;
}

}  // namespace

TurningCells::TurningCells(const Body& body, Turning turning) : turning_(turning) {
  GLISSON_ASSERT(body.layout.order == ElementOrder::linear);
  const NodeLayout& layout = body.layout;
  Eigen::Index longest = 0;
  const geometry::Box box = geometry::bounding_box(layout.positions_mm);
  (box.max_mm - box.min_mm).maxCoeff(&longest);
  std::vector<int> layout_of_node(static_cast<std::size_t>(layout.nodes()));
  std::iota(layout_of_node.begin(), layout_of_node.end(), 0);
  std::stable_sort(layout_of_node.begin(), layout_of_node.end(),
                   [&](int a, int b) { return layout.positions_mm[a][longest] < layout.positions_mm[b][longest]; });
  node_of_layout_.resize(layout_of_node.size());
  for (std::size_t n = 0; n < layout_of_node.size(); ++n) {
    node_of_layout_[layout_of_node[n]] = static_cast<int>(n);
    rest_mm_.push_back(layout.positions_mm[layout_of_node[n]]);
  }

  for (std::size_t c = 0; c < layout.cells.size(); ++c) {
    const CellGeometry shape = cell_geometry(body.mesh, c);
    Cell cell;
    for (int i = 0; i < 4; ++i) cell.nodes[i] = node_of_layout_[layout.cells[c][i]];
    cell.gradients = shape.barycentric_gradients.bottomRows<3>().transpose();
    cell.lambda_volume = body.materials[c].lambda_kPa * shape.volume_mm3;
    cell.mu_volume = body.materials[c].mu_kPa * shape.volume_mm3;
    cells_.push_back(cell);
  }
  std::stable_sort(cells_.begin(), cells_.end(), [](const Cell& a, const Cell& b) {
    return *std::min_element(a.nodes.begin(), a.nodes.end()) < *std::min_element(b.nodes.begin(), b.nodes.end());
  });
  rotations_.assign(cells_.size(), Matrix3d::Identity());
  make_slabs();
}

void TurningCells::make_slabs() {
  // A slab is the cells whose first node lies in a range, and its last node must lie before the slab after the next.
  const int target_nodes = std::max(1, nodes() / 24);
  int next_start = 0, start_after_next = target_nodes;
  std::size_t begin = 0;
  while (begin < cells_.size()) {
    next_start = start_after_next;
    int last_node = 0;
    std::size_t end = begin;
    const auto first_node = [&](std::size_t c) {
      return *std::min_element(cells_[c].nodes.begin(), cells_[c].nodes.end());
    };
    for (; end < cells_.size() && first_node(end) < next_start; ++end) {
      last_node = std::max(last_node, *std::max_element(cells_[end].nodes.begin(), cells_[end].nodes.end()));
    }
    slabs_.push_back({begin, end});  // maybe empty, which keeps every other one apart
    start_after_next = std::max(next_start + target_nodes, last_node + 1);
    begin = end;
  }
}

template <typename Work>
void TurningCells::each_cell(const Work& work) const {
  for (std::size_t parity = 0; parity < 2; ++parity) {
    const std::size_t count = (slabs_.size() + 1 - parity) / 2;
    parallel_for(count, 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t s = begin; s < end; ++s) {
        const Slab& slab = slabs_[2 * s + parity];
        for (std::size_t c = slab.begin; c < slab.end; ++c) work(c);
      }
    });
  }
}

Lists TurningCells::neighbours() const {
  std::vector<std::vector<int>> rows(static_cast<std::size_t>(nodes()));
  for (const Cell& cell : cells_) {
    for (const int a : cell.nodes) rows[a].insert(rows[a].end(), cell.nodes.begin(), cell.nodes.end());
  }
  Lists lists;
  lists.starts.assign(1, 0);
  for (auto& row : rows) {
    std::sort(row.begin(), row.end());
    row.erase(std::unique(row.begin(), row.end()), row.end());
    lists.items.insert(lists.items.end(), row.begin(), row.end());
    lists.starts.push_back(lists.items.size());
  }
  return lists;
}

namespace {

Matrix3d gradient_of(const std::array<int, 4>& nodes, const Matrix3d& gradients, const Eigen::VectorXd& w) {
  const Eigen::Vector3d origin = w.segment<3>(3 * nodes[0]);
  Matrix3d moved;
  for (int i = 0; i < 3; ++i) moved.col(i) = w.segment<3>(3 * nodes[i + 1]) - origin;
  return moved * gradients.transpose();
}

}  // namespace

TurningCells::Turned TurningCells::turn(const Eigen::VectorXd& u_mm) {
  constexpr std::size_t cells_in_chunk = 4096;  // one sum each, so that threads do not change the total
  std::vector<Turned> parts((cells_.size() + cells_in_chunk - 1) / cells_in_chunk);
  parallel_for(parts.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t p = begin; p < end; ++p) {
      for (std::size_t c = p * cells_in_chunk; c < std::min((p + 1) * cells_in_chunk, cells_.size()); ++c) {
        const Cell& cell = cells_[c];
        const Matrix3d f = Matrix3d::Identity() + gradient_of(cell.nodes, cell.gradients, u_mm);
        if (turning_ == Turning::each_step) rotations_[c] = rotation_of(f);
        const Matrix3d strain = small_strain(rotations_[c].transpose() * f - Matrix3d::Identity());
        parts[p].inverted_cells += f.determinant() <= 0 ? 1 : 0;
        parts[p].strain_energy_uJ +=
            cell.mu_volume * strain.squaredNorm() + 0.5 * cell.lambda_volume * strain.trace() * strain.trace();
      }
    }
  });
  Turned whole;
  for (const Turned& part : parts) {
    whole.inverted_cells += part.inverted_cells;
    whole.strain_energy_uJ += part.strain_energy_uJ;
  }
  return whole;
}

template <bool at_rest_is_identity>
Matrix3d TurningCells::stress_times_volume(std::size_t c, const Eigen::VectorXd& w) const {
  const Cell& cell = cells_[c];
  Matrix3d f = gradient_of(cell.nodes, cell.gradients, w);
  if constexpr (at_rest_is_identity) f.diagonal().array() += 1.0;
  Matrix3d strain = rotations_[c].transpose() * f;
  if constexpr (at_rest_is_identity) strain.diagonal().array() -= 1.0;
  Matrix3d stress = cell.mu_volume * (strain + strain.transpose());
  stress.diagonal().array() += cell.lambda_volume * strain.trace();
  return rotations_[c] * stress;
}

void TurningCells::scatter(std::size_t c, const Matrix3d& stress, Eigen::VectorXd& force) const {
  const Cell& cell = cells_[c];
  const Matrix3d forces = stress * cell.gradients;
  force.segment<3>(3 * cell.nodes[0]) -= forces.rowwise().sum();
  for (int i = 0; i < 3; ++i) force.segment<3>(3 * cell.nodes[i + 1]) += forces.col(i);
}

void TurningCells::add_force_mN(const Eigen::VectorXd& u_mm, Eigen::VectorXd& force_mN) const {
  each_cell([&](std::size_t c) { scatter(c, stress_times_volume<true>(c, u_mm), force_mN); });
}

void TurningCells::add_stiffness_times(double factor, const Eigen::VectorXd& w, Eigen::VectorXd& product) const {
  each_cell([&](std::size_t c) { scatter(c, factor * stress_times_volume<false>(c, w), product); });
}

void TurningCells::find_blocks(const BlockCsr& matrix) {
  blocks_.resize(cells_.size());
  for (std::size_t c = 0; c < cells_.size(); ++c) {
    for (int a = 0; a < 4; ++a) {
      for (int b = 0; b < 4; ++b) {
        blocks_[c][4 * a + b] = static_cast<int>(matrix.position(cells_[c].nodes[a], cells_[c].nodes[b]));
      }
    }
  }
}

void TurningCells::add_stiffness(double factor, BlockCsr& matrix) {
  if (blocks_.empty()) find_blocks(matrix);
  each_cell([&](std::size_t c) {
    // Turning the gradients turns the whole: R K_ab R^T is the block of the turned gradients (linear_elasticity.h).
    const Cell& cell = cells_[c];
    Eigen::Matrix<float, 3, 4> g;
    g.rightCols<3>() = (rotations_[c] * cell.gradients).cast<float>();
    g.col(0) = -g.rightCols<3>().rowwise().sum();
    const auto lambda = static_cast<float>(factor * cell.lambda_volume);
    const auto mu = static_cast<float>(factor * cell.mu_volume);
    for (int a = 0; a < 4; ++a) {
      for (int b = a; b < 4; ++b) {
        Eigen::Matrix3f block = lambda * g.col(a) * g.col(b).transpose() + mu * g.col(b) * g.col(a).transpose();
        block.diagonal().array() += mu * g.col(a).dot(g.col(b));
        Eigen::Map<Eigen::Matrix3f>(matrix.block(static_cast<std::size_t>(blocks_[c][4 * a + b]))) += block;
        if (b == a) continue;
        Eigen::Map<Eigen::Matrix3f>(matrix.block(static_cast<std::size_t>(blocks_[c][4 * b + a]))) += block.transpose();
      }
    }
  });
}

}  // namespace glisson::mechanics
