#include "mechanics/cutting/opening.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>
#include <mutex>
#include <utility>

#include "mechanics/cutting/internal/jump_functions.h"
#include "mechanics/cutting/internal/opening_state.h"
#include "mechanics/elements/load_vector.h"

namespace glisson::mechanics {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

namespace {

constexpr std::size_t points_in_a_group = 4;  // a dozen right-hand sides, a tenth of a second on a liver

}  // namespace

Result<Opening> Opening::of(StaticModel model, Loads standing_loads, SeenPart seen) {
  const Body& body = model.body();
  auto force_mN = load_vector(body.mesh, body.layout, body.boundary, body.options.density_kg_mm3, standing_loads);
  if (!force_mN) return failure(std::move(force_mN.error()));
  return Opening(
      std::make_shared<State>(std::move(model), std::move(standing_loads), std::move(*force_mN), std::move(seen)));
}

Result<Opening> Opening::advanced(const CutStrip& strip) const {
  const Body& body = state_->model.body();
  if (body.options.capsule) {
    return failure(Error{"not-available",
                         GLISSON_TEXT("A cut cannot advance through a body with a capsule."),
                         {},
                         GLISSON_TEXT("Leave the capsule out, or cut before the rehearsal."),
                         {}});
  }
  if (!((strip.to_mm - strip.from_mm).norm() > 0) || !strip.from_mm.allFinite() || !strip.to_mm.allFinite()) {
    return failure("cut-invalid", GLISSON_TEXT("The cut's advance needs two different places to go between."));
  }
  auto next = std::make_shared<State>(*state_);
  auto cut = std::find_if(next->cuts.begin(), next->cuts.end(),
                          [&](const PartlyCut& known) { return known.along->surface.is_same(strip.surface); });
  if (cut == next->cuts.end()) cut = next->cuts.insert(cut, {surface_in_body(body, strip), {}, {}});
  const std::vector<WholeWall> before = std::exchange(cut->walls, {});
  cut->strips.push_back(strip);
  cut->walls = whole_walls(body.mesh, cut->along->crossing, cut->strips);
  const double whole_before_mm2 = before.empty() ? all_area_mm2(cut->walls) : whole_area_mm2(before);

  const std::vector<int> candidates = next->candidates_to_open(*cut);
  std::vector<int> new_points;
  for (const int candidate : candidates) {
    new_points.push_back(cut->along->candidates[static_cast<std::size_t>(candidate)]);
  }
  if (next->meets_another_cut(new_points, *cut->along)) {
    return failure(Error{"cuts-meet",
                         GLISSON_TEXT("The cut crosses an earlier one, whose walls would have to be divided too."),
                         {},
                         GLISSON_TEXT("Go on along the earlier cut, or keep a cell's distance from it."),
                         {}});
  }
  if (new_points.empty() && whole_area_mm2(cut->walls) == whole_before_mm2) {
    return failure("cut-misses", GLISSON_TEXT("The cut opens nothing: all that lies along it is open already, held, or "
                                              "outside of the body."));
  }
  if (auto opened = next->open_points(candidates, cut->along); !opened) return failure(std::move(opened.error()));
  if (auto factorised = next->factorise(); !factorised) return failure(std::move(factorised.error()));
  return Opening(std::move(next));
}

// Those that have begun to open and were not.
std::vector<int> Opening::State::candidates_to_open(const PartlyCut& cut) const {
  const geometry::TetMesh& mesh = model.mesh();
  std::vector<std::uint8_t> known(mesh.points_mm.size(), 0);
  for (const int point : points) known[point] = 1;
  std::vector<int> found;
  for (std::size_t c = 0; c < cut.along->candidates.size(); ++c) {
    constexpr double begun = 0.02;
    const int point = cut.along->candidates[c];
    if (known[point] == 0 && cut_share(mesh, cut.along->crossing, cut.walls, point) >= begun)
      found.push_back(static_cast<int>(c));
  }
  return found;
}

// A cell has one wall: no point of it may be open along one surface, and another point along another.
bool Opening::State::meets_another_cut(const std::vector<int>& new_points, const SurfaceInBody& along) const {
  const geometry::TetMesh& mesh = model.mesh();
  std::vector<const SurfaceInBody*> surface_of_point(mesh.points_mm.size(), nullptr);
  for (const OpenPoint& known : open) surface_of_point[known.point()] = known.along.get();
  const auto meets = [&](const Crossing& crossing, int point) {
    const auto& cells = crossing.cells_of_point[point];
    return std::any_of(cells.begin(), cells.end(), [&](int c) {
      const auto& corners = mesh.cells[crossing.cells[c].cell];
      return std::any_of(corners.begin(), corners.end(),
                         [&](int p) { return surface_of_point[p] != nullptr && surface_of_point[p] != &along; });
    });
  };
  return std::any_of(new_points.begin(), new_points.end(), [&](int point) {
    return meets(along.crossing, point) || std::any_of(cuts.begin(), cuts.end(), [&](const PartlyCut& other) {
             return other.along.get() != &along && meets(other.along->crossing, point);
           });
  });
}

Result<std::shared_ptr<const SolvedPoint>> Opening::State::solved(const SurfaceInBody& along, int candidate) const {
  const std::lock_guard lock(along.mutex);
  const auto c = static_cast<std::size_t>(candidate);
  const auto knows_all = [&](const SolvedPoint& known) {
    return std::all_of(cuts.begin(), cuts.end(), [&](const PartlyCut& cut) {
      return std::any_of(known.products.begin(), known.products.end(),
                         [&](const auto& product) { return product.first == cut.along.get(); });
    });
  };
  if (!along.solved[c] || !knows_all(*along.solved[c])) {
    if (auto done = solve_group(along, c / points_in_a_group); !done) return failure(std::move(done.error()));
  }
  return along.solved[c];
}

Result<void> Opening::State::solve_group(const SurfaceInBody& along, std::size_t group) const {
  const Body& body = model.body();
  const std::size_t first = group * points_in_a_group;
  const std::size_t size = std::min(points_in_a_group, along.candidates.size() - first);
  const std::vector<int> group_points(along.candidates.begin() + static_cast<std::ptrdiff_t>(first),
                                      along.candidates.begin() + static_cast<std::ptrdiff_t>(first + size));
  const auto columns = along.coupling.middleCols(static_cast<Index>(3 * first), static_cast<Index>(3 * size));
  const StaticModel::Responses solved = model.respond(MatrixXd(columns));
  if (!solved.converged) {
    return failure("not-converged",
                   GLISSON_TEXT("The body's answer to the cut was not found: the relative residual stayed at {0}."),
                   {fmt::format("{:.1e}", solved.relative_residual)});
  }
  const MatrixXd& w = solved.displacement_mm;
  MatrixXd v = seen.of_nodes(w);
  for (const SeenPart::Place& place : seen.places) {
    for (std::size_t i = 0; i < size; ++i) {
      const double value = value_at(body.mesh, along.crossing, group_points[i], place.at);
      if (value != 0) v.block<3, 3>(place.row, 3 * static_cast<Index>(i)).diagonal().array() -= value;
    }
  }
  const VectorXd load = load_on(body, along.crossing, standing_loads, group_points) - w.transpose() * standing_force_mN;
  std::vector<MatrixXd> products;
  for (const PartlyCut& cut : cuts) products.emplace_back(cut.along->coupling.transpose() * w);
  for (std::size_t i = 0; i < size; ++i) {
    const auto column = static_cast<Index>(3 * i);
    auto point = std::make_shared<SolvedPoint>();
    point->v = v.middleCols<3>(column);
    point->standing_load = load.segment<3>(column);
    for (std::size_t c = 0; c < cuts.size(); ++c) {
      point->products.emplace_back(cuts[c].along.get(), products[c].middleCols<3>(column));
    }
    point->relative_residual = solved.relative_residual;
    along.solved[first + i] = std::move(point);
  }
  return {};
}

Result<void> Opening::State::open_points(const std::vector<int>& candidates,
                                         const std::shared_ptr<const SurfaceInBody>& along) {
  const std::size_t known = open.size();
  std::vector<int> new_points, along_it;
  std::vector<Index> row_of;
  for (std::size_t i = 0; i < known; ++i) {
    if (open[i].along != along) continue;
    along_it.push_back(open[i].point());
    row_of.push_back(static_cast<Index>(3 * i));
  }
  for (const int candidate : candidates) {
    auto point = solved(*along, candidate);
    if (!point) return failure(std::move(point.error()));
    relative_residual = std::max(relative_residual, (*point)->relative_residual);
    open.push_back({candidate, along, std::move(*point)});
    row_of.push_back(static_cast<Index>(3 * (open.size() - 1)));
    new_points.push_back(open.back().point());
    along_it.push_back(new_points.back());
    points.push_back(new_points.back());
    Vector3d normal = Vector3d::Zero();
    for (const int c : along->crossing.cells_of_point[new_points.back()]) {
      normal += along->crossing.cells[c].wall_area_mm2 * along->crossing.cells[c].wall_normal;
    }
    normals.push_back(normal.normalized());
  }

  const auto all = static_cast<Index>(3 * open.size()), first = static_cast<Index>(3 * known);
  stiffness.conservativeResize(all, all);
  standing_load.conservativeResize(all);
  for (std::size_t j = known; j < open.size(); ++j) {
    const auto column = static_cast<Index>(3 * j);
    standing_load.segment<3>(column) = open[j].solved->standing_load;
    for (std::size_t i = 0; i < open.size(); ++i) {
      const auto& products = open[j].solved->products;
      const auto of_surface = std::find_if(products.begin(), products.end(),
                                           [&](const auto& product) { return product.first == open[i].along.get(); });
      stiffness.block<3, 3>(static_cast<Index>(3 * i), column) =
          -of_surface->second.middleRows<3>(3 * static_cast<Index>(open[i].candidate));
    }
  }
  const MatrixXd between = stiffness_between(model.body(), along->crossing, along_it, new_points);
  for (std::size_t i = 0; i < along_it.size(); ++i) {
    stiffness.block(row_of[i], first, 3, all - first) += between.middleRows<3>(3 * static_cast<Index>(i));
  }
  stiffness.block(first, 0, all - first, first) = stiffness.block(0, first, first, all - first).transpose();
  return {};
}

std::vector<int> Opening::State::jumps_along(const SurfaceInBody& along) const {
  std::vector<int> number(model.mesh().points_mm.size(), -1);
  for (std::size_t i = 0; i < open.size(); ++i) {
    if (open[i].along.get() == &along) number[open[i].point()] = static_cast<int>(i);
  }
  return number;
}

Result<void> Opening::State::factorise() {
  MatrixXd bridged = stiffness;
  for (const PartlyCut& cut : cuts) {
    add_bridges(model.body(), cut.along->crossing, cut.walls, jumps_along(*cut.along), bridged);
  }
  factor.emplace(bridged);
  // What nothing holds has no stiffness but rounding's.
  constexpr double nothing = 1e-9;
  const bool held = factor->info() == Eigen::Success &&
                    (factor->matrixLLT().diagonal().array().square() > nothing * bridged.diagonal().array()).all();
  if (held) return {};
  return failure(Error{"cut-frees-part",
                       GLISSON_TEXT("Nothing would hold the part that this cut separates."),
                       {},
                       GLISSON_TEXT("Stop before the last bridge of tissue."),
                       {}});
}

Result<bool> Opening::prepare(const CutStrip& ahead) const {
  const auto cut = std::find_if(state_->cuts.begin(), state_->cuts.end(),
                                [&](const PartlyCut& known) { return known.along->surface.is_same(ahead.surface); });
  if (cut == state_->cuts.end()) return false;
  const SurfaceInBody& along = *cut->along;
  const double from_mm = (ahead.from_mm - along.begin_mm).dot(along.forward);
  const double until_mm = (ahead.to_mm - along.begin_mm).dot(along.forward);
  for (std::size_t c = 0; c < along.candidates.size(); ++c) {
    if (along.at_mm[c] < from_mm || along.at_mm[c] > until_mm) continue;
    {
      const std::lock_guard lock(along.mutex);
      if (along.solved[c]) continue;
    }
    auto point = state_->solved(along, static_cast<int>(c));
    if (!point) return failure(std::move(point.error()));
    return true;
  }
  return false;
}

const std::vector<int>& Opening::points() const { return state_->points; }
const std::vector<Vector3d>& Opening::normals() const { return state_->normals; }
const VectorXd& Opening::standing_load() const { return state_->standing_load; }
double Opening::relative_residual() const { return state_->relative_residual; }

VectorXd Opening::load_of_force(Index row, const Vector3d& force_mN) const {
  VectorXd load(state_->standing_load.size());
  for (std::size_t i = 0; i < state_->open.size(); ++i) {
    load.segment<3>(static_cast<Index>(3 * i)) = -state_->open[i].solved->v.middleRows<3>(row).transpose() * force_mN;
  }
  return load;
}

VectorXd Opening::load_of_push(std::size_t point, const Vector3d& direction) const {
  VectorXd load = VectorXd::Zero(state_->standing_load.size());
  load.segment<3>(static_cast<Index>(3 * point)) = direction;
  return load;
}

MatrixXd Opening::jumps_mm(const MatrixXd& load) const {
  return state_->open.empty() ? load : MatrixXd(state_->factor->solve(load));
}

VectorXd Opening::seen_mm(const VectorXd& jumps_mm) const {
  return state_->open.empty() ? VectorXd() : seen_mm(jumps_mm, state_->open.front().solved->v.rows());
}

VectorXd Opening::seen_mm(const VectorXd& jumps_mm, Index rows) const {
  VectorXd sum_mm = VectorXd::Zero(rows);
  for (std::size_t i = 0; i < state_->open.size(); ++i) {
    sum_mm -= state_->open[i].solved->v.topRows(rows) * jumps_mm.segment<3>(static_cast<Index>(3 * i));
  }
  return sum_mm;
}

double Opening::open_mm2() const {
  double all_mm2 = 0;
  for (const PartlyCut& cut : state_->cuts) all_mm2 += all_area_mm2(cut.walls);
  return all_mm2 - whole_mm2();
}

double Opening::whole_mm2() const {
  double sum_mm2 = 0;
  for (const PartlyCut& cut : state_->cuts) sum_mm2 += whole_area_mm2(cut.walls);
  return sum_mm2;
}

VectorXd Opening::force_on_nodes_mN(const VectorXd& jumps_mm) const {
  VectorXd force_mN = VectorXd::Zero(state_->standing_force_mN.size());
  for (std::size_t i = 0; i < state_->open.size(); ++i) {
    const OpenPoint& open = state_->open[i];
    force_mN -= open.along->coupling.middleCols(3 * open.candidate, 3) * jumps_mm.segment<3>(static_cast<Index>(3 * i));
  }
  return force_mN;
}

}  // namespace glisson::mechanics
