// The one file that includes Mesh_3.
#include "meshing/internal/delaunay_refinement.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/exude_mesh_3.h>
#include <CGAL/Labeled_mesh_domain_3.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_constant_domain_field_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/perturb_mesh_3.h>
#include <CGAL/refine_mesh_3.h>
#include <algorithm>
#include <array>
#include <atomic>
#include <map>
#include <set>
#include <unordered_map>

namespace glisson::meshing {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Domain = CGAL::Labeled_mesh_domain_3<Kernel>;
using Triangulation = CGAL::Mesh_triangulation_3<Domain>::type;
using Complex = CGAL::Mesh_complex_3_in_triangulation_3<Triangulation>;
using Criteria = CGAL::Mesh_criteria_3<Triangulation>;
using SizeField = CGAL::Mesh_constant_domain_field_3<Kernel, Domain::Index>;
using PatchSizes = std::map<std::pair<int, int>, double>;

// Of the cell radius: how far a facet may lie from the boundary. Inside, where the radius of a ball is about two cell
// radii, chords cost three times their depth of the volume.
constexpr double facet_distance_share = 0.125;
constexpr double inner_facet_distance_share = 0.08;
constexpr double minimum_facet_angle_deg = 25;
constexpr double maximum_radius_edge_ratio = 2.5;
constexpr double sliver_bound_deg = 10;

// Of the body's diagonal: how exactly points are put on the boundary.
constexpr double relative_error_bound = 1e-4;

struct Cancelled {};

// The cell radius at each boundary between two pieces (0 is the outside): the smaller of the two.
PatchSizes sizes_at_boundaries(const PieceMap& map, const std::vector<double>& cell_radius_mm);
Criteria criteria_for(const Domain& domain, const PatchSizes& patches, const std::vector<double>& cell_radius_mm);

// Points on every boundary of every piece to begin with, not nearer to each other than a cell's edge is long: points
// are never taken away again, and two close together would draw a nest of small cells. Refinement alone only what the
// edges between its first cells happen to cross, and loses the pieces between them.
void insert_first_points(Complex& complex, const Domain& domain, const PieceMap& map, const PatchSizes& patches);

// Turns what the library throws, and a stop that was asked for, into an Error.
template <typename Work>
Result<void> guarded(Work&& work);

}  // namespace

struct DelaunayRefinement::State {
  std::unique_ptr<Domain> domain;
  Progress progress;
  std::atomic<unsigned> questions = 0;
  Complex complex;
};

DelaunayRefinement::DelaunayRefinement(std::unique_ptr<State> state) : state_(std::move(state)) {}
DelaunayRefinement::DelaunayRefinement(DelaunayRefinement&&) noexcept = default;
DelaunayRefinement& DelaunayRefinement::operator=(DelaunayRefinement&&) noexcept = default;
DelaunayRefinement::~DelaunayRefinement() = default;

Result<DelaunayRefinement> DelaunayRefinement::refine(const LabelField& field,
                                                      const std::vector<double>& cell_radius_mm,
                                                      const Progress& progress) {
  const PieceMap& map = field.map();
  const Eigen::Vector3d end_mm =
      map.grid.spacing_mm.cwiseProduct(Eigen::Vector3d(map.grid.size[0], map.grid.size[1], map.grid.size[2]));
  auto state = std::make_unique<State>();
  State* const asked = state.get();
  state->progress = progress;
  const auto piece_at = [&field, asked](const Kernel::Point_3& point) {
    constexpr unsigned questions_between_looks = 4096;
    if (++asked->questions % questions_between_looks == 0 && asked->progress.cancelled()) throw Cancelled{};
    return field.piece_at({point.x(), point.y(), point.z()});
  };
  const auto refined = guarded([&] {
    state->domain = std::make_unique<Domain>(piece_at, CGAL::Bbox_3(0, 0, 0, end_mm.x(), end_mm.y(), end_mm.z()),
                                             relative_error_bound);
    const PatchSizes patches = sizes_at_boundaries(map, cell_radius_mm);
    insert_first_points(state->complex, *state->domain, map, patches);
    CGAL::refine_mesh_3(state->complex, *state->domain, criteria_for(*state->domain, patches, cell_radius_mm),
                        CGAL::parameters::no_perturb(), CGAL::parameters::no_exude());
  });
  if (!refined) return failure(refined.error());
  return DelaunayRefinement(std::move(state));
}

std::size_t DelaunayRefinement::cells() const { return state_->complex.number_of_cells_in_complex(); }

Result<void> DelaunayRefinement::remove_slivers(const Progress& progress) {
  state_->progress = progress;
  return guarded([&] {
    CGAL::get_default_random() = CGAL::Random(0);
    CGAL::perturb_mesh_3(state_->complex, *state_->domain, CGAL::parameters::sliver_bound = sliver_bound_deg);
    CGAL::exude_mesh_3(state_->complex, CGAL::parameters::sliver_bound = sliver_bound_deg);
  });
}

geometry::TetMesh DelaunayRefinement::mesh() const {
  geometry::TetMesh mesh;
  geometry::Field piece{"piece", 1, {}};
  std::unordered_map<Complex::Vertex_handle, int, CGAL::Handle_hash_function> number_of;
  const Complex& complex = state_->complex;
  for (auto cell = complex.cells_in_complex_begin(); cell != complex.cells_in_complex_end(); ++cell) {
    std::array<int, 4> corners{};
    for (int i = 0; i < 4; ++i) {
      const auto [found, is_new] = number_of.try_emplace(cell->vertex(i), static_cast<int>(mesh.points_mm.size()));
      if (is_new) {
        const auto& point = cell->vertex(i)->point().point();
        mesh.points_mm.emplace_back(point.x(), point.y(), point.z());
      }
      corners[static_cast<std::size_t>(i)] = found->second;
    }
    mesh.cells.push_back(corners);
    piece.values.push_back(complex.subdomain_index(cell));
  }
  mesh.cell_fields.push_back(std::move(piece));
  return mesh;
}

namespace {

PatchSizes sizes_at_boundaries(const PieceMap& map, const std::vector<double>& cell_radius_mm) {
  // Pieces that are a few voxels apart can meet in the smoothed labels, so all pairs within a window count.
  std::set<std::pair<int, int>> pairs;
  const auto radius = [&](int number) {
    return number == 0 ? std::numeric_limits<double>::infinity() : cell_radius_mm[static_cast<std::size_t>(number - 1)];
  };
  const auto& size = map.grid.size;
  for (int k = 0; k + 1 < size[2]; ++k) {
    for (int j = 0; j + 1 < size[1]; ++j) {
      for (int i = 0; i + 1 < size[0]; ++i) {
        std::array<int, 8> corners{};
        for (int n = 0; n < 8; ++n) {
          corners[static_cast<std::size_t>(n)] =
              map.piece[map.grid.offset(i + (n & 1), j + (n >> 1 & 1), k + (n >> 2))];
        }
        if (std::all_of(corners.begin(), corners.end(), [&](int c) { return c == corners[0]; })) continue;
        for (const int a : corners) {
          for (const int b : corners) {
            if (a < b) pairs.emplace(a, b);
          }
        }
      }
    }
  }
  PatchSizes sizes;
  for (const auto& [a, b] : pairs) sizes[{a, b}] = std::min(radius(a), radius(b));
  return sizes;
}

Criteria criteria_for(const Domain& domain, const PatchSizes& patches, const std::vector<double>& cell_radius_mm) {
  const double largest = *std::max_element(cell_radius_mm.begin(), cell_radius_mm.end());
  SizeField cell_radius(largest);
  for (std::size_t piece = 0; piece < cell_radius_mm.size(); ++piece) {
    cell_radius.set_size(cell_radius_mm[piece], 3, domain.index_from_subdomain_index(static_cast<int>(piece + 1)));
  }
  SizeField facet_radius(largest);
  SizeField facet_distance(facet_distance_share * largest);
  for (const auto& [patch, radius] : patches) {
    const Domain::Index index = domain.index_from_surface_patch_index(patch);
    facet_radius.set_size(radius, 2, index);
    const bool inner = patch.first != 0;
    facet_distance.set_size((inner ? inner_facet_distance_share : facet_distance_share) * radius, 2, index);
  }
  namespace parameters = CGAL::parameters;
  return Criteria(parameters::facet_angle = minimum_facet_angle_deg, parameters::facet_size = facet_radius,
                  parameters::facet_distance = facet_distance,
                  parameters::cell_radius_edge_ratio = maximum_radius_edge_ratio, parameters::cell_size = cell_radius);
}

// Points that keep a distance from each other, found by the brick of space that they lie in. Bricks are as long as the
// distance, so that each holds few points and only the neighbours need to be asked.
class SparsePoints {
 public:
  explicit SparsePoints(double apart_mm) : apart_mm_(apart_mm) {}

  bool add(const Eigen::Vector3d& point) {
    const Eigen::Vector3i brick = (point / apart_mm_).array().floor().cast<int>();
    for (int n = 0; n < 27; ++n) {
      const auto near = points_.equal_range({brick.x() + n % 3 - 1, brick.y() + n / 3 % 3 - 1, brick.z() + n / 9 - 1});
      for (auto other = near.first; other != near.second; ++other) {
        if ((other->second - point).norm() < apart_mm_) return false;
      }
    }
    points_.insert({{brick.x(), brick.y(), brick.z()}, point});
    return true;
  }

 private:
  double apart_mm_;
  std::multimap<std::array<int, 3>, Eigen::Vector3d> points_;
};

void insert_first_points(Complex& complex, const Domain& domain, const PieceMap& map, const PatchSizes& patches) {
  constexpr double edge_of_radius = 1.5;
  std::map<std::pair<int, int>, SparsePoints> taken;
  for (const auto& [patch, radius_mm] : patches) taken.emplace(patch, SparsePoints(edge_of_radius * radius_mm));
  const imaging::Grid& grid = map.grid;
  const auto intersection = domain.construct_intersection_object();
  const auto point_of = [&](const Eigen::Vector3d& local) { return Kernel::Point_3(local.x(), local.y(), local.z()); };
  for (int k = 0; k + 1 < grid.size[2]; ++k) {
    for (int j = 0; j + 1 < grid.size[1]; ++j) {
      for (int i = 0; i + 1 < grid.size[0]; ++i) {
        const int here = map.piece[grid.offset(i, j, k)];
        for (int axis = 0; axis < 3; ++axis) {
          const Eigen::Vector3i step = Eigen::Vector3i::Unit(axis);
          const int there = map.piece[grid.offset(i + step.x(), j + step.y(), k + step.z())];
          if (here == there) continue;
          const Eigen::Vector3d from = grid.spacing_mm.cwiseProduct(Eigen::Vector3d(i, j, k));
          const Eigen::Vector3d to = from + grid.spacing_mm.cwiseProduct(step.cast<double>());
          if (!taken.at(std::minmax(here, there)).add(0.5 * (from + to))) continue;
          const auto [point, index, dimension] = intersection(Kernel::Segment_3(point_of(from), point_of(to)));
          if (dimension == 0) continue;
          const auto vertex = complex.triangulation().insert(Triangulation::Weighted_point(point));
          if (vertex == Triangulation::Vertex_handle()) continue;
          complex.set_dimension(vertex, 2);
          complex.set_index(vertex, index);
        }
      }
    }
  }
}

template <typename Work>
Result<void> guarded(Work&& work) {
  try {
    work();
    return {};
  } catch (const Cancelled&) {
    return cancelled();
  } catch (const std::exception& thrown) {
    return failure(Error{"mesh-refinement",
                         GLISSON_TEXT("The mesh generator gave up: {0}."),
                         {thrown.what()},
                         GLISSON_TEXT("Ask for another number of cells, or smooth the labels."),
                         {}});
  }
}

}  // namespace
}  // namespace glisson::meshing
