// How an opening is put together: which functions open, what is solved for of them, and their dense system.

#include <fmt/format.h>
#include <algorithm>
#include <iterator>
#include <map>
#include <mutex>
#include <numeric>

#include "geometry/disjoint_sets.h"
#include "mechanics/cutting/internal/opening_state.h"

namespace glisson::mechanics {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

namespace {

constexpr int solved_together = 12;  // right-hand sides: a tenth of a second on a liver

std::size_t functions_in_a_group(const OpeningFunctions& functions) {
  return static_cast<std::size_t>(std::max(1, solved_together / functions.size));
}

}  // namespace

// Those that have begun to open and were not.
std::vector<int> Opening::State::functions_to_open(const PartlyCut& cut) const {
  const auto& points_of = cut.along->functions->points_of;
  std::vector<std::uint8_t> known(points_of.size(), 0);
  for (const OpenFunction& opened : open) {
    if (opened.along == cut.along) known[static_cast<std::size_t>(opened.function)] = 1;
  }
  std::vector<int> found;
  for (std::size_t f = 0; f < points_of.size(); ++f) {
    constexpr double begun = 0.02;
    if (known[f] == 0 && cut_share(model.mesh(), cut.along->crossing, cut.walls, points_of[f]) >= begun)
      found.push_back(static_cast<int>(f));
  }
  return found;
}

// A cell has one wall: no point of it may be open along one surface, and another point along another.
bool Opening::State::meets_another_cut(const std::vector<int>& functions, const SurfaceInBody& along) const {
  const geometry::TetMesh& mesh = model.mesh();
  std::vector<const SurfaceInBody*> surface_of_point(mesh.points_mm.size(), nullptr);
  for (std::size_t i = 0; i < points.size(); ++i) surface_of_point[points[i]] = surface_of_jump[i];
  const auto meets = [&](const Crossing& crossing, int point) {
    const auto& cells = crossing.cells_of_point[point];
    return std::any_of(cells.begin(), cells.end(), [&](int c) {
      const auto& corners = mesh.cells[crossing.cells[c].cell];
      return std::any_of(corners.begin(), corners.end(),
                         [&](int p) { return surface_of_point[p] != nullptr && surface_of_point[p] != &along; });
    });
  };
  const auto point_meets = [&](int point) {
    return meets(along.crossing, point) || std::any_of(cuts.begin(), cuts.end(), [&](const PartlyCut& other) {
             return other.along.get() != &along && meets(other.along->crossing, point);
           });
  };
  return std::any_of(functions.begin(), functions.end(), [&](int f) {
    const std::vector<int>& its_points = along.functions->points_of[static_cast<std::size_t>(f)];
    return std::any_of(its_points.begin(), its_points.end(), point_meets) ||
           std::any_of(open.begin(), open.end(), [&](const OpenFunction& other) {
             return other.along.get() != &along && along.functions->meets(f, other.of(), other.function);
           });
  });
}

Result<std::shared_ptr<const SolvedFunction>> Opening::State::solved(const SurfaceInBody& along, int function) const {
  const std::lock_guard lock(along.mutex);
  const auto f = static_cast<std::size_t>(function);
  if (!knows(along, function)) {
    const std::size_t in_a_group = functions_in_a_group(*along.functions);
    const std::size_t first = f / in_a_group * in_a_group;
    std::vector<int> members(std::min(in_a_group, along.functions->points_of.size() - first));
    std::iota(members.begin(), members.end(), static_cast<int>(first));
    if (auto done = solve_group(along, members); !done) return failure(std::move(done.error()));
  }
  return along.solved[f];
}

// With its products with all surfaces that there are.
bool Opening::State::knows(const SurfaceInBody& along, int function) const {
  const auto& known = along.solved[static_cast<std::size_t>(function)];
  return known && std::all_of(cuts.begin(), cuts.end(), [&](const PartlyCut& cut) {
           return std::any_of(known->products.begin(), known->products.end(),
                              [&](const auto& product) { return product.first == cut.along->number; });
         });
}

Result<void> Opening::State::solve_group(const SurfaceInBody& along, const std::vector<int>& members) const {
  const OpeningFunctions& functions = *along.functions;
  const Index each = functions.size, columns = each * static_cast<Index>(members.size());
  MatrixXd of_members(functions.coupling.rows(), columns);
  VectorXd load(columns);
  for (std::size_t i = 0; i < members.size(); ++i) {
    const Index from = each * members[i], to = each * static_cast<Index>(i);
    of_members.middleCols(to, each) = functions.coupling.middleCols(from, each);
    load.segment(to, each) = along.standing_load.segment(from, each);
  }
  const StaticModel::Responses solved = model.respond(of_members);
  if (!solved.converged) {
    return failure("not-converged",
                   GLISSON_TEXT("The body's answer to the cut was not found: the relative residual stayed at {0}."),
                   {fmt::format("{:.1e}", solved.relative_residual)});
  }
  const MatrixXd& w = solved.displacement_mm;
  MatrixXd v = seen.of_nodes(w);
  functions.take_off(seen, members, v);
  load -= w.transpose() * standing_force_mN;
  std::vector<MatrixXd> products;
  const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> by_rows = w;  // which the product reads
  for (const PartlyCut& cut : cuts) products.emplace_back(cut.along->functions->coupling.transpose() * by_rows);
  for (std::size_t i = 0; i < members.size(); ++i) {
    const Index column = each * static_cast<Index>(i);
    auto one = std::make_shared<SolvedFunction>();
    one->v = v.middleCols(column, each);
    one->standing_load = load.segment(column, each);
    for (std::size_t c = 0; c < cuts.size(); ++c) {
      one->products.emplace_back(cuts[c].along->number, products[c].middleCols(column, each));
    }
    one->relative_residual = solved.relative_residual;
    along.solved[static_cast<std::size_t>(members[i])] = std::move(one);
  }
  return {};
}

Result<void> Opening::State::open_functions(const std::vector<int>& functions,
                                            const std::shared_ptr<const SurfaceInBody>& along) {
  const std::size_t known = open.size();
  if (along->surface.is_swept()) {
    // It is drawn as it is cut: nobody knows what lies ahead, and none but these are solved for, all together.
    const std::lock_guard lock(along->mutex);
    std::vector<int> unknown;
    std::copy_if(functions.begin(), functions.end(), std::back_inserter(unknown),
                 [&](int f) { return !knows(*along, f); });
    if (!unknown.empty()) {
      if (auto done = solve_group(*along, unknown); !done) return done;
    }
  }
  const Index first = standing_load.size(), each = along->functions->size;
  Index all = first;
  for (const int function : functions) {
    auto one = solved(*along, function);
    if (!one) return failure(std::move(one.error()));
    relative_residual = std::max(relative_residual, (*one)->relative_residual);
    open.push_back({function, along, std::move(*one), all});
    all += each;
    add_points(open.back());
  }
  find_jumps();

  stiffness.conservativeResize(all, all);
  standing_load.conservativeResize(all);
  own_stiffness.conservativeResize(all);
  for (std::size_t j = known; j < open.size(); ++j) {
    standing_load.segment(open[j].first, each) = open[j].solved->standing_load;
    for (const OpenFunction& other : open) {
      const auto& products = open[j].solved->products;
      const auto of_surface = std::find_if(products.begin(), products.end(),
                                           [&](const auto& product) { return product.first == other.along->number; });
      stiffness.block(other.first, open[j].first, other.size(), each) =
          -of_surface->second.middleRows(Index{other.size()} * other.function, other.size());
    }
  }
  std::vector<int> along_it;
  std::vector<Index> row_of;
  for (const OpenFunction& one : open) {
    if (one.along != along) continue;
    along_it.push_back(one.function);
    row_of.push_back(one.first);
  }
  const MatrixXd between = along->functions->stiffness_between(along_it, functions);
  for (std::size_t i = 0; i < along_it.size(); ++i) {
    const auto rows = between.middleRows(each * static_cast<Index>(i), each);
    stiffness.block(row_of[i], first, each, all - first) += rows;
    if (row_of[i] >= first)
      own_stiffness.segment(row_of[i], each) = rows.middleCols(row_of[i] - first, each).diagonal();
  }
  stiffness.block(first, 0, all - first, first) = stiffness.block(0, first, first, all - first).transpose();
  return {};
}

Result<void> Opening::State::lead_on(PartlyCut& cut, const CutStrip& strip) {
  const std::shared_ptr<const SurfaceInBody> before = cut.along;
  std::vector<int> jumping;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (surface_of_jump[i] == before.get()) jumping.push_back(points[i]);
  }
  auto grown = grown_surface(model, standing_loads, *before, jumping, strip);
  if (!grown) return failure(std::move(grown.error()));
  cut.along = std::move(*grown);
  std::vector<int> function_of(model.mesh().points_mm.size(), -1);
  const auto& points_of = cut.along->functions->points_of;
  for (std::size_t f = 0; f < points_of.size(); ++f) function_of[points_of[f].front()] = static_cast<int>(f);
  for (OpenFunction& opened : open) {
    if (opened.along != before) continue;
    opened.function = function_of[before->functions->points_of[static_cast<std::size_t>(opened.function)].front()];
    GLISSON_ASSERT(opened.function >= 0);
    opened.along = cut.along;
  }
  std::replace(surface_of_jump.begin(), surface_of_jump.end(), before.get(), cut.along.get());
  return {};
}

// Those that jump by it and did not.
void Opening::State::add_points(const OpenFunction& opened) {
  const Crossing& crossing = opened.along->crossing;
  const std::vector<int> number = jumps_along(*opened.along);
  for (const int point : opened.of().points_of[static_cast<std::size_t>(opened.function)]) {
    if (number[point] >= 0) continue;
    points.push_back(point);
    surface_of_jump.push_back(opened.along.get());
    Vector3d normal = Vector3d::Zero();
    for (const int c : crossing.cells_of_point[point]) {
      normal += crossing.cells[c].wall_area_mm2 * crossing.cells[c].wall_normal;
    }
    normals.push_back(normal.normalized());
  }
}

void Opening::State::find_jumps() {
  std::map<const SurfaceInBody*, std::vector<int>> numbers;
  std::vector<Eigen::Triplet<double>> entries;
  Index amplitudes = 0;
  for (const OpenFunction& one : open) {
    auto [number, is_new] = numbers.try_emplace(one.along.get());
    if (is_new) number->second = jumps_along(*one.along);
    for (int c = 0; c < one.size(); ++c) {
      const Index column = Index{one.size()} * one.function + c;
      for (Eigen::SparseMatrix<double>::InnerIterator entry(one.of().jumps, column); entry; ++entry) {
        const int jump = number->second[static_cast<std::size_t>(entry.row() / 3)];
        entries.emplace_back(3 * jump + static_cast<int>(entry.row() % 3), static_cast<int>(one.first) + c,
                             entry.value());
      }
    }
    amplitudes = one.first + one.size();
  }
  jumps.resize(3 * static_cast<Index>(points.size()), amplitudes);
  jumps.setFromTriplets(entries.begin(), entries.end());
}

void Opening::State::find_what_is_cut() {
  is_cut.assign(points.size(), 0);
  for (const PartlyCut& cut : cuts) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (surface_of_jump[i] != cut.along.get()) continue;
      is_cut[i] = cut_share(model.mesh(), cut.along->crossing, cut.walls, {points[i]}) > 0 ? 1 : 0;
    }
  }
}

std::vector<int> Opening::State::jumps_along(const SurfaceInBody& along) const {
  std::vector<int> number(model.mesh().points_mm.size(), -1);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (surface_of_jump[i] == &along) number[points[i]] = static_cast<int>(i);
  }
  return number;
}

Result<void> Opening::State::factorise() {
  find_what_is_cut();
  std::vector<Eigen::Triplet<double>> alike, springs;
  for (const PartlyCut& cut : cuts) {
    add_bridges(model.body(), cut.along->crossing, cut.walls, jumps_along(*cut.along), alike);
  }
  for (const auto& spring : alike) {
    for (int axis = 0; axis < 3; ++axis) {
      springs.emplace_back(3 * spring.row() + axis, 3 * spring.col() + axis, spring.value());
    }
  }
  Eigen::SparseMatrix<double> bridges(jumps.rows(), jumps.rows());
  bridges.setFromTriplets(springs.begin(), springs.end());
  MatrixXd bridged = stiffness;
  bridged += Eigen::SparseMatrix<double>(jumps.transpose() * bridges * jumps);
  const bool by_points = model.reduced_functions() == nullptr;
  constexpr double nothing = 1e-9;
  // Functions may describe one motion in two ways: to be factorised their diagonal is raised.
  if (!by_points) bridged.diagonal() += nothing * own_stiffness;
  const VectorXd stiff = bridged.diagonal();
  factor = DenseCholesky::of(std::move(bridged));
  // What nothing holds has no stiffness but rounding's.
  const bool held =
      factor &&
      (by_points ? (factor->factor().diagonal().array().square() > nothing * stiff.array()).all() : !frees_a_part());
  if (held) return {};
  return failure(Error{"cut-frees-part",
                       GLISSON_TEXT("Nothing would hold the part that this cut separates."),
                       {},
                       GLISSON_TEXT("Stop before the last bridge of tissue."),
                       {}});
}

// Whether what hangs together by cells and by what bridges the cuts has a part without a support.
bool Opening::State::frees_a_part() const {
  const Body& body = model.body();
  geometry::DisjointSets parts(body.mesh.points_mm.size());
  std::vector<std::uint8_t> is_cut(body.mesh.cells.size(), 0);
  for (const PartlyCut& cut : cuts) {
    for (std::size_t c = 0; c < cut.walls.size(); ++c) {
      if (cut.walls[c].whole_mm2.sum() > 0) continue;
      is_cut[cut.along->crossing.cells[c].cell] = 1;
      const auto& corners = body.mesh.cells[cut.along->crossing.cells[c].cell];
      for (const int a : corners) {
        for (const int b : corners) {
          if (cut.along->crossing.height_mm[a] * cut.along->crossing.height_mm[b] > 0) {
            parts.join(static_cast<std::size_t>(a), static_cast<std::size_t>(b));
          }
        }
      }
    }
  }
  std::vector<std::uint8_t> is_held(body.mesh.points_mm.size(), 0), is_used(body.mesh.points_mm.size(), 0);
  for (std::size_t c = 0; c < body.mesh.cells.size(); ++c) {
    for (const int p : body.mesh.cells[c]) {
      is_used[p] = 1;
      if (is_cut[c] == 0) parts.join(static_cast<std::size_t>(body.mesh.cells[c][0]), static_cast<std::size_t>(p));
    }
  }
  const auto hold = [&](int point) { is_held[parts.root(static_cast<std::size_t>(point))] = 1; };
  for (std::size_t p = 0; p < is_used.size(); ++p) {
    const auto first = 3 * static_cast<std::size_t>(std::max(0, body.layout.node_of_point[p]));
    if (is_used[p] != 0 && body.resolved.fixed[first] != 0) hold(static_cast<int>(p));
  }
  for (const FoundationFace& spring : body.resolved.foundations) hold(body.boundary[spring.face].points[0]);
  for (std::size_t p = 0; p < is_used.size(); ++p) {
    if (is_used[p] != 0 && is_held[parts.root(p)] == 0) return true;
  }
  return false;
}

}  // namespace glisson::mechanics
