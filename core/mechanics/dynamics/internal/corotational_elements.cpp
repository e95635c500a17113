#include "mechanics/dynamics/internal/corotational_elements.h"

#include <algorithm>
#include <numeric>

#include "base/parallel.h"
#include "mechanics/elements/shape_functions.h"
#include "mechanics/materials/deformation.h"

namespace glisson::mechanics {
namespace {

struct Cell {
  std::array<int, 4> nodes;
  Eigen::Matrix3d gradients;  // columns: of the nodes 1, 2, 3
  double lambda_volume, mu_volume;

  [[nodiscard]] int first_node() const { return *std::min_element(nodes.begin(), nodes.end()); }
  [[nodiscard]] int last_node() const { return *std::max_element(nodes.begin(), nodes.end()); }
};

ElementBatch batch_of(const Cell* cells, std::size_t count) {
  ElementBatch batch = {};
  batch.count = static_cast<int>(count);
  for (std::size_t lane = 0; lane < ElementBatch::lanes; ++lane) {
    const Cell& cell = cells[std::min(lane, count - 1)];
    for (int i = 0; i < 4; ++i) batch.first[i][lane] = 3 * static_cast<std::int64_t>(cell.nodes[i]);
    for (int d = 0; d < 3; ++d) batch.rotation[d][d][lane] = 1.0;
    if (lane >= count) continue;
    for (int axis = 0; axis < 3; ++axis) {
      for (int i = 0; i < 3; ++i) batch.gradients[axis][i][lane] = cell.gradients(axis, i);
    }
    batch.lambda_volume[lane] = cell.lambda_volume;
    batch.mu_volume[lane] = cell.mu_volume;
  }
  return batch;
}

int node_of(const ElementBatch& batch, int i, int lane) { return static_cast<int>(batch.first[i][lane] / 3); }

void slow_rotation(const double f[3][3], double r[3][3]) {
  using RowMajor = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
  const RowMajor gradient = Eigen::Map<const RowMajor>(&f[0][0]);
  const RowMajor rotation = polar_decomposition(gradient).rotation;
  std::copy_n(rotation.data(), 9, &r[0][0]);
}

}  // namespace

CorotationalElements::CorotationalElements(const Body& body, Turning turning, double share) : turning_(turning) {
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

  std::vector<Cell> cells;
  for (std::size_t c = 0; c < layout.cells.size(); ++c) {
    const CellGeometry shape = cell_geometry(body.mesh, c);
    Cell cell;
    for (int i = 0; i < 4; ++i) cell.nodes[i] = node_of_layout_[layout.cells[c][i]];
    cell.gradients = shape.barycentric_gradients.bottomRows<3>().transpose();
    cell.lambda_volume = share * body.materials[c].lambda_kPa * shape.volume_mm3;
    cell.mu_volume = share * body.materials[c].mu_kPa * shape.volume_mm3;
    cells.push_back(cell);
  }
  std::stable_sort(cells.begin(), cells.end(),
                   [](const Cell& a, const Cell& b) { return a.first_node() < b.first_node(); });

  // A slab is the cells whose first node lies in a range, and its last node must lie before the slab after the next.
  const int target_nodes = std::max(1, nodes() / 24);
  int start_after_next = target_nodes;
  std::size_t begin = 0;
  while (begin < cells.size()) {
    const int next_start = start_after_next;
    int last_node = 0;
    std::size_t end = begin;
    for (; end < cells.size() && cells[end].first_node() < next_start; ++end) {
      last_node = std::max(last_node, cells[end].last_node());
    }
    const std::size_t first_batch = batches_.size();
    for (std::size_t c = begin; c < end; c += ElementBatch::lanes) {
      batches_.push_back(batch_of(&cells[c], std::min<std::size_t>(ElementBatch::lanes, end - c)));
    }
    slabs_.push_back({first_batch, batches_.size()});  // maybe empty, which keeps every other one apart
    start_after_next = std::max(next_start + target_nodes, last_node + 1);
    begin = end;
  }
}

// work(first batch, end of the batches) for every slab.
template <typename Work>
void CorotationalElements::each_slab(const Work& work) const {
  for (std::size_t parity = 0; parity < 2; ++parity) {
    const std::size_t count = (slabs_.size() + 1 - parity) / 2;
    parallel_for(count, 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t s = begin; s < end; ++s) work(slabs_[2 * s + parity].begin, slabs_[2 * s + parity].end);
    });
  }
}

Lists CorotationalElements::neighbours() const {
  std::vector<std::vector<int>> rows(static_cast<std::size_t>(nodes()));
  for (const ElementBatch& batch : batches_) {
    for (int lane = 0; lane < batch.count; ++lane) {
      for (int a = 0; a < 4; ++a) {
        for (int b = 0; b < 4; ++b) rows[node_of(batch, a, lane)].push_back(node_of(batch, b, lane));
      }
    }
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

CorotationalElements::Turned CorotationalElements::turn(const Eigen::VectorXd& u_mm) {
  constexpr std::size_t batches_in_chunk = 512;  // one sum each, so that threads do not change the total
  std::vector<Turned> parts((batches_.size() + batches_in_chunk - 1) / batches_in_chunk);
  parallel_for(parts.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t p = begin; p < end; ++p) {
      const std::size_t last = std::min((p + 1) * batches_in_chunk, batches_.size());
      parts[p] = kernels_.turn(batches_.data() + p * batches_in_chunk, batches_.data() + last, u_mm.data(),
                               turning_ == Turning::never, slow_rotation);
    }
  });
  Turned whole;
  for (const Turned& part : parts) {
    whole.inverted_cells += part.inverted_cells;
    whole.strain_energy_uJ += part.strain_energy_uJ;
  }
  return whole;
}

void CorotationalElements::add_forces(const Eigen::VectorXd& w, double rest, double factor,
                                      Eigen::VectorXd& forces) const {
  GLISSON_ASSERT(w.size() == 3 * nodes() && forces.size() == w.size());
  each_slab([&](std::size_t begin, std::size_t end) {
    kernels_.add_forces(batches_.data() + begin, batches_.data() + end, w.data(), rest, factor, forces.data());
  });
}

void CorotationalElements::add_force_mN(const Eigen::VectorXd& u_mm, Eigen::VectorXd& force_mN) const {
  add_forces(u_mm, 1.0, 1.0, force_mN);
}

void CorotationalElements::add_stiffness_times(double factor, const Eigen::VectorXd& w,
                                               Eigen::VectorXd& product) const {
  add_forces(w, 0.0, factor, product);
}

void CorotationalElements::find_blocks(const BlockCsr& matrix) {
  blocks_.resize(ElementBatch::lanes * batches_.size());
  for (std::size_t at = 0; at < batches_.size(); ++at) {
    for (int lane = 0; lane < batches_[at].count; ++lane) {
      for (int a = 0; a < 4; ++a) {
        for (int b = 0; b < 4; ++b) {
          blocks_[ElementBatch::lanes * at + static_cast<std::size_t>(lane)][4 * a + b] =
              static_cast<int>(matrix.position(node_of(batches_[at], a, lane), node_of(batches_[at], b, lane)));
        }
      }
    }
  }
}

void CorotationalElements::add_stiffness(double factor, BlockCsr& matrix) {
  if (blocks_.empty()) find_blocks(matrix);
  const auto add_cell = [&](const ElementBatch& batch, int lane, const std::array<int, 16>& blocks) {
    // Turning the gradients turns the whole: R K_ab R^T is the block of the turned gradients (linear_elasticity.h).
    Eigen::Matrix3f rotation, gradients;
    for (int r = 0; r < 3; ++r) {
      for (int c = 0; c < 3; ++c) {
        rotation(r, c) = static_cast<float>(batch.rotation[r][c][lane]);
        gradients(r, c) = static_cast<float>(batch.gradients[r][c][lane]);
      }
    }
    Eigen::Matrix<float, 3, 4> g;
    g.rightCols<3>() = rotation * gradients;
    g.col(0) = -g.rightCols<3>().rowwise().sum();
    const auto lambda = static_cast<float>(factor * batch.lambda_volume[lane]);
    const auto mu = static_cast<float>(factor * batch.mu_volume[lane]);
    for (int a = 0; a < 4; ++a) {
      for (int b = a; b < 4; ++b) {
        Eigen::Matrix3f block = lambda * g.col(a) * g.col(b).transpose() + mu * g.col(b) * g.col(a).transpose();
        block.diagonal().array() += mu * g.col(a).dot(g.col(b));
        Eigen::Map<Eigen::Matrix3f>(matrix.block(static_cast<std::size_t>(blocks[4 * a + b]))) += block;
        if (b == a) continue;
        Eigen::Map<Eigen::Matrix3f>(matrix.block(static_cast<std::size_t>(blocks[4 * b + a]))) += block.transpose();
      }
    }
  };
  each_slab([&](std::size_t begin, std::size_t end) {
    for (std::size_t at = begin; at < end; ++at) {
      for (int lane = 0; lane < batches_[at].count; ++lane) {
        add_cell(batches_[at], lane, blocks_[ElementBatch::lanes * at + static_cast<std::size_t>(lane)]);
      }
    }
  });
}

}  // namespace glisson::mechanics
