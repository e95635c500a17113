#include "meshing/mesh_labels.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "base/units.h"
#include "geometry/nearest.h"
#include "meshing/internal/delaunay_refinement.h"
#include "meshing/internal/label_field.h"
#include "meshing/internal/pinches.h"
#include "meshing/internal/voxel_faces.h"

namespace glisson::meshing {
namespace {

using geometry::TetMesh;

// Cells in a volume V whose circumscribed spheres are held below R: about V / (0.28 R^3), as counted in livers of 5,000
// to 90,000 cells. Only the first guess depends on it.
constexpr double cell_volume_share = 0.28;

// Of an inner piece's thickness (its radius if long, 2/3 of it if round): the radius of its cells' spheres. An edge is
// about 1.4 such radii, so that a long piece is two edges across.
constexpr double radius_share_of_thickness = 0.7;

// Cells between fine and coarse ones, for each fine one of a piece: its surroundings out to twice its radius have three
// times (long) or seven times (round) its volume, in cells that grow with the distance.
constexpr double cells_around_a_piece = 3.0;

// How much coarser than first guessed the liver may become to make up for inner pieces that cost more than guessed.
// Beyond that the mesh has more cells than asked for, rather than a liver without its shape.
constexpr double maximum_coarsening = 1.6;

constexpr double close_enough_count = 0.07;
constexpr double promised_count = 0.15;
constexpr int maximum_refinements = 5;
constexpr double minimum_kept_volume = 0.5;

Result<void> check_options(const MeshOptions& options);

std::map<std::uint16_t, double> volume_by_label_ml(const PieceMap& map);

// Dissolves the pieces that would cost too many cells, the thinnest first, with a note for each label.
void dissolve_what_costs_too_much(PieceMap& map, const MeshOptions& options);

// Refined until the number of cells is near the target.
Result<DelaunayRefinement> refine_to_target(const LabelField& field, const MeshOptions& options,
                                            const Progress& progress);

std::vector<double> volume_by_piece_mm3(const TetMesh& local, std::size_t pieces);
Result<void> check_that_none_was_lost(const PieceMap& map, const std::vector<double>& mesh_volume_mm3,
                                      const MeshOptions& options);
std::vector<RegionVolume> region_volumes(const PieceMap& map, const std::map<std::uint16_t, double>& label_volume_ml,
                                         const std::vector<double>& mesh_volume_mm3);

// From the grid's own frame to the patient's, and from pieces to labels.
TetMesh in_patient_coordinates(TetMesh local, const PieceMap& map);

}  // namespace

Result<LiverMesh> mesh_labels(const imaging::LabelMap& labels, const MeshOptions& options, const Progress& progress) {
  if (auto checked = check_options(options); !checked) return failure(checked.error());
  progress.report(0.0, GLISSON_TEXT("Preparing the labels"));
  Result<PieceMap> found = find_pieces(labels, {options.names});
  if (!found) return failure(found.error());
  PieceMap& map = *found;
  const auto label_volume_ml = volume_by_label_ml(map);
  dissolve_what_costs_too_much(map, options);
  if (progress.cancelled()) return cancelled();

  const LabelField field(map);
  auto refined = refine_to_target(field, options, progress.part(0.1, 0.5));
  if (!refined) return failure(refined.error());
  progress.report(0.5, GLISSON_TEXT("Removing slivers"));
  if (auto improved = refined->remove_slivers(progress); !improved) return failure(improved.error());

  LiverMesh liver;
  TetMesh local = refined->mesh();
  const std::size_t removed = remove_pinches(local);
  const std::vector<double> mesh_volume_mm3 = volume_by_piece_mm3(local, map.pieces.size());
  if (auto checked = check_that_none_was_lost(map, mesh_volume_mm3, options); !checked) return failure(checked.error());

  progress.report(0.8, GLISSON_TEXT("Measuring the distance to the label boundary"));
  const double spacing_mm = map.grid.spacing_mm.maxCoeff();
  const auto gap = gap_between(boundary_surface(local), voxel_faces(map), spacing_mm);
  liver.hausdorff_mm = gap.hausdorff_mm;
  liver.mean_distance_mm = gap.mean_mm;

  liver.regions = region_volumes(map, label_volume_ml, mesh_volume_mm3);
  liver.notes = map.notes;
  const double cells_of_target = static_cast<double>(local.cells.size()) / options.target_cells;
  if (std::abs(cells_of_target - 1) > promised_count) {
    liver.notes.push_back(
        {GLISSON_TEXT("The mesh has {0} cells instead of {1}; its shape and inner structures ask for them."),
         {std::to_string(local.cells.size()), std::to_string(options.target_cells)}});
  }
  if (removed > 0) {
    liver.notes.push_back({GLISSON_TEXT("Cells taken away where the body touched itself in a point or an edge: {0}."),
                           {std::to_string(removed)}});
  }
  liver.body = in_patient_coordinates(std::move(local), map);
  liver.surface = boundary_surface(liver.body);
  liver.quality = quality(liver.body);
  if (!is_watertight(liver.surface) || !pinched_points(liver.surface).empty()) {
    return failure("mesh-not-manifold", GLISSON_TEXT("The surface of the mesh is not a closed manifold."));
  }
  progress.report(1.0, GLISSON_TEXT("Meshed"));
  return liver;
}

namespace {

Result<void> check_options(const MeshOptions& options) {
  constexpr int fewest_cells = 200;
  constexpr int maximum_cells = 3'000'000;
  if (options.target_cells < fewest_cells || options.target_cells > maximum_cells) {
    return failure("mesh-options", GLISSON_TEXT("A mesh of {0} cells cannot be made; from {1} to {2} can."),
                   {std::to_string(options.target_cells), std::to_string(fewest_cells), std::to_string(maximum_cells)});
  }
  if (!(options.inner_share >= 0 && options.inner_share < 1)) {
    return failure("mesh-options",
                   GLISSON_TEXT("The share of cells for inner structures is {0}; it must be in 0 to 1."),
                   {fmt::format("{:g}", options.inner_share)});
  }
  return {};
}

std::map<std::uint16_t, double> volume_by_label_ml(const PieceMap& map) {
  std::map<std::uint16_t, double> volume_ml;
  for (const Piece& piece : map.pieces) volume_ml[piece.label] += units::ml_from_mm3(piece.volume_mm3);
  return volume_ml;
}

double cell_radius_of_inner_mm(const Piece& piece) { return radius_share_of_thickness * piece.thickness_mm(); }

double cells_for(double volume_mm3, double radius_mm) {
  return volume_mm3 / (cell_volume_share * radius_mm * radius_mm * radius_mm);
}

double inner_cost_cells(const Piece& piece) {
  return (1 + cells_around_a_piece) * cells_for(piece.volume_mm3, cell_radius_of_inner_mm(piece));
}

double in_hundreds(double cells) { return 100 * std::ceil(cells / 100); }

void dissolve_what_costs_too_much(PieceMap& map, const MeshOptions& options) {
  struct Loss {
    int pieces = 0;
    double volume_mm3 = 0;
    double cells = 0;
  };
  std::map<std::uint16_t, Loss> losses;
  const double budget = options.inner_share * options.target_cells;
  while (map.pieces.size() > 1) {
    double cost = 0;
    std::size_t thinnest = 1;
    for (std::size_t i = 1; i < map.pieces.size(); ++i) {
      cost += inner_cost_cells(map.pieces[i]);
      if (map.pieces[i].thickness_mm() < map.pieces[thinnest].thickness_mm()) thinnest = i;
    }
    if (cost <= budget) break;
    const Piece& piece = map.pieces[thinnest];
    Loss& loss = losses[piece.label];
    ++loss.pieces;
    loss.volume_mm3 += piece.volume_mm3;
    loss.cells += inner_cost_cells(piece);
    dissolve_piece(map, thinnest);
  }
  for (const auto& [label, loss] : losses) {
    map.notes.push_back(
        {loss.pieces == 1
             ? GLISSON_TEXT("{0}: {1} piece ({2} ml) too thin for {3} cells got no cells of its own; about "
                            "{4} cells would show it.")
             : GLISSON_TEXT("{0}: {1} pieces ({2} ml) too thin for {3} cells got no cells of their own; "
                            "about {4} cells would show them."),
         {display_name(label, options.names), std::to_string(loss.pieces),
          fmt::format("{:.3g}", units::ml_from_mm3(loss.volume_mm3)), std::to_string(options.target_cells),
          fmt::format("{:.0f}", in_hundreds(loss.cells / std::max(options.inner_share, 0.05)))}});
  }
}

std::vector<double> cell_radii_mm(const PieceMap& map, double liver_radius_mm) {
  std::vector<double> radii_mm{liver_radius_mm};
  for (std::size_t i = 1; i < map.pieces.size(); ++i) {
    radii_mm.push_back(std::min(liver_radius_mm, cell_radius_of_inner_mm(map.pieces[i])));
  }
  return radii_mm;
}

Result<DelaunayRefinement> refine_to_target(const LabelField& field, const MeshOptions& options,
                                            const Progress& progress) {
  const PieceMap& map = field.map();
  double inner_cells = 0;
  for (std::size_t i = 1; i < map.pieces.size(); ++i) inner_cells += inner_cost_cells(map.pieces[i]);
  const double for_liver = std::max(options.target_cells - inner_cells, 0.3 * options.target_cells);
  double radius_mm = std::cbrt(map.pieces.front().volume_mm3 / (cell_volume_share * for_liver));
  const double largest_radius_mm = maximum_coarsening * radius_mm;

  // The count follows the radius by a power: -3 where the liver has nearly all cells, less steep where inner pieces
  // have.
  double power = -3;
  std::optional<DelaunayRefinement> best;
  double best_miss = std::numeric_limits<double>::infinity();
  double last_excess = 0;
  double last_step = 0;
  for (int round = 0; round < maximum_refinements; ++round) {
    progress.report(static_cast<double>(round) / maximum_refinements, GLISSON_TEXT("Filling the body with tetrahedra"));
    auto refined = DelaunayRefinement::refine(field, cell_radii_mm(map, radius_mm), progress);
    if (!refined) return refined;
    const double excess = std::log(std::max(static_cast<double>(refined->cells()), 1.0) / options.target_cells);
    if (std::abs(excess) < best_miss) {
      best_miss = std::abs(excess);
      best = std::move(*refined);
    }
    if (best_miss < close_enough_count) break;
    if (last_step != 0) power = std::clamp((excess - last_excess) / last_step, -3.5, -0.3);
    last_excess = excess;
    last_step =
        std::min(std::clamp(-excess / power, -std::log(2.0), std::log(2.0)), std::log(largest_radius_mm / radius_mm));
    if (last_step == 0) break;
    radius_mm *= std::exp(last_step);
  }
  return std::move(*best);
}

std::vector<double> volume_by_piece_mm3(const TetMesh& local, std::size_t pieces) {
  const auto& piece = find_field(local.cell_fields, "piece")->values;
  std::vector<double> volume_mm3(pieces, 0);
  for (std::size_t cell = 0; cell < local.cells.size(); ++cell) {
    volume_mm3[static_cast<std::size_t>(piece[cell]) - 1] += cell_volume_mm3(local, cell);
  }
  return volume_mm3;
}

Result<void> check_that_none_was_lost(const PieceMap& map, const std::vector<double>& mesh_volume_mm3,
                                      const MeshOptions& options) {
  for (std::size_t i = 0; i < map.pieces.size(); ++i) {
    if (mesh_volume_mm3[i] >= minimum_kept_volume * map.pieces[i].volume_mm3) continue;
    return failure(Error{"mesh-region-lost",
                         GLISSON_TEXT("A piece of {0} has {1} ml, but its cells only {2} ml: the mesh has lost it."),
                         {display_name(map.pieces[i].label, options.names),
                          fmt::format("{:.3g}", units::ml_from_mm3(map.pieces[i].volume_mm3)),
                          fmt::format("{:.3g}", units::ml_from_mm3(mesh_volume_mm3[i]))},
                         GLISSON_TEXT("Ask for more cells."),
                         {}});
  }
  return {};
}

std::vector<RegionVolume> region_volumes(const PieceMap& map, const std::map<std::uint16_t, double>& label_volume_ml,
                                         const std::vector<double>& mesh_volume_mm3) {
  std::vector<RegionVolume> regions;
  for (const auto& [label, volume_ml] : label_volume_ml) {
    RegionVolume region{label, volume_ml, 0};
    for (std::size_t i = 0; i < map.pieces.size(); ++i) {
      if (map.pieces[i].label == label) region.mesh_volume_ml += units::ml_from_mm3(mesh_volume_mm3[i]);
    }
    regions.push_back(region);
  }
  return regions;
}

TetMesh in_patient_coordinates(TetMesh local, const PieceMap& map) {
  const imaging::Grid& grid = map.grid;
  for (Eigen::Vector3d& point : local.points_mm) point = grid.origin_mm + grid.direction * point;
  if (grid.direction.determinant() < 0) {
    for (auto& cell : local.cells) std::swap(cell[2], cell[3]);
  }
  geometry::Field region{"region", 1, {}};
  for (const double piece : find_field(local.cell_fields, "piece")->values) {
    region.values.push_back(map.pieces[static_cast<std::size_t>(piece) - 1].label);
  }
  local.cell_fields = {std::move(region)};
  return local;
}

}  // namespace
}  // namespace glisson::meshing
