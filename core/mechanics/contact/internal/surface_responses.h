#pragma once
// What a linear body answers to forces on its surface. A unit force on a point is solved for once by the kept factor
// and remembered, in single precision. That is done in fixed groups of neighbours, so that what is remembered does not
// depend on who asked first. What the model's mutual points (of the walls of cuts) answer to each other is known from
// the start. Forces on them are solved for anew each time that all is seen under them.
//
// Where a cut has opened, what the opening adds is kept apart from what is remembered of the whole body (opening.h).
// That is the loads that forces put on its jumps, and what follows from those.
//
// What is seen: the nodes of the surface's points, in their order, and those that the judged places lie between. Then
// those that the other watched places lie between, and all corners. 3 values each (mm). Places are many where
// structures are drawn, nodes are not; still they are most of what a point's answer takes. So answers that are solved
// for ahead are of the surface and the judged places alone. What they lack is solved for when it is shown, for all
// together, and remembered for one of those that lacked it before.

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "base/result.h"
#include "geometry/surface.h"
#include "mechanics/cutting/opening.h"
#include "mechanics/elements/point_location.h"
#include "mechanics/elements/strain.h"
#include "mechanics/statics/static_model.h"

namespace glisson::mechanics {

// By points of the surface.
using PointForces = std::map<int, Eigen::Vector3d>;
// What pushes open walls apart (mN), along their normals: by numbers of Opening::points().
using WallForces = std::map<int, double>;

class SurfaceResponses {
 public:
  // `standing` is the body's state without further forces. The first `judged` of the watched places have the same bits
  // whatever was remembered.
  SurfaceResponses(StaticModel model, const StaticResult& standing, std::vector<PointInMesh> watched,
                   std::size_t judged);

  [[nodiscard]] const StaticModel& model() const { return model_; }
  [[nodiscard]] const geometry::Surface& surface() const { return surface_; }
  [[nodiscard]] int node(int point) const { return model_.nodes().node_of_point[mesh_point_[point]]; }
  // The model's mutual points, as points of the surface.
  [[nodiscard]] const std::vector<int>& mutual_points() const { return mutual_points_; }

  // The same body with its cut opened further; what is remembered is shared. Failures: those of Opening::advanced;
  // "not-available" for a body that was meshed with cuts.
  [[nodiscard]] Result<SurfaceResponses> opened(const CutStrip& strip, const Loads& standing_loads) const;
  [[nodiscard]] const Opening* opening() const { return opening_ ? &*opening_ : nullptr; }
  [[nodiscard]] const std::vector<OpenCell>& open_cells() const { return open_cells_; }

  // Solves for what is not known of the points yet; gives back for how many right-hand sides. Failure: "not-converged".
  [[nodiscard]] Result<int> remember(const std::vector<int>& points) const;
  // Solves ahead for one group: what the points that bear force now lack, then the unknown one that is nearest to any
  // of the places at rest (without places, any). False where there is none, or memory for it is full (160 MB of the
  // surface, 128 MB of the rest). Failure: "not-converged".
  [[nodiscard]] Result<bool> remember_ahead(const PointForces& bearing_mN,
                                            const std::vector<Eigen::Vector3d>& places_mm) const;

  // How a point of the whole body moves by a force on another, both remembered or mutual.
  [[nodiscard]] Eigen::Matrix3d compliance(int at, int of) const;
  // Between all mutual points, 3 a point, in their order.
  [[nodiscard]] const Eigen::MatrixXd& mutual_compliance() const { return mutual_compliance_; }

  // The same body in a step in time (all nodes, mm, 3 a node), which without tools takes it to `taken_mm`. It rests at
  // `rest_mm`. What is remembered is shared.
  [[nodiscard]] SurfaceResponses within_step(const Eigen::VectorXd& rest_mm, const Eigen::VectorXd& taken_mm) const;

  // The surface under the standing loads, of the whole body (mm, 3 a point).
  [[nodiscard]] const Eigen::VectorXd& standing_surface_mm() const { return standing_surface_mm_; }
  // Of the opening, the amplitudes (mm) and the jumps (mm, 3 a point) under such forces; none: without values.
  [[nodiscard]] Eigen::VectorXd amplitudes_under(const PointForces& force_mN, const WallForces& wall_mN) const;
  [[nodiscard]] Eigen::VectorXd jumps_under(const PointForces& force_mN, const WallForces& wall_mN) const;
  // Where the surface lies under forces on points that are remembered or mutual, and on walls (mm, 3 a point). Failure:
  // "not-converged".
  [[nodiscard]] Result<Eigen::VectorXd> surface_under(const PointForces& force_mN, const WallForces& wall_mN) const;

  // All that is seen under such forces: of nodes as if the body were whole, and what the opening adds to the surface's
  // points, the inner corners and the watched places, with its jumps (without values where nothing is open). Failure:
  // "not-converged".
  struct Seen {
    Eigen::VectorXd nodes_mm, by_cut_mm, jumps_mm;
  };
  [[nodiscard]] Result<Seen> all_under(const PointForces& force_mN, const WallForces& wall_mN) const;
  // Of a body without a cut whose nodes lie so (mm, 3 a node).
  [[nodiscard]] Seen seen_of(const Eigen::VectorXd& u_mm) const { return {seen_part(u_mm), {}, {}}; }
  // Of it, displacements of the surface's points, the watched places and the mesh's points.
  [[nodiscard]] std::vector<Eigen::Vector3d> surface_mm(const Seen& seen) const;
  [[nodiscard]] std::vector<Eigen::Vector3d> watched_mm(const Seen& seen) const;
  [[nodiscard]] std::vector<Eigen::Vector3d> mesh_points_mm(const Seen& seen) const;
  // By the cells' corners alone, from the mesh's points: the largest mean strain of any cell, and the cells turned
  // inside out. An open cell counts by both of its sides.
  [[nodiscard]] StrainRange strain_range(const std::vector<Eigen::Vector3d>& points_mm,
                                         const Eigen::VectorXd& jumps_mm) const;
  [[nodiscard]] double relative_residual() const;  // the worst so far

 private:
  enum class Part { surface, all };                          // with the judged places
  using Response = Eigen::Matrix<float, Eigen::Dynamic, 3>;  // of what is seen, to a unit force along each axis
  [[nodiscard]] Eigen::Index surface_values() const { return 3 * static_cast<Eigen::Index>(mesh_point_.size()); }
  // Of several displacements of all nodes, one a column: what is seen, and what a cut moves of it.
  [[nodiscard]] Eigen::MatrixXd seen_part(const Eigen::MatrixXd& displacement_mm) const;
  [[nodiscard]] SeenPart seen_of_cut() const;
  // The first so many values of `nodes_mm`: those of surface and judged places, or all.
  [[nodiscard]] Result<Eigen::VectorXd> nodes_under(const PointForces& force_mN, Part part) const;
  [[nodiscard]] StaticModel::Responses solve_group(int group) const;
  // The rest of what is seen moves by that under forces on points whose answers lack it.
  [[nodiscard]] Result<Eigen::VectorXd> rest_under(const PointForces& force_mN) const;
  [[nodiscard]] Result<void> keep(int group, const StaticModel::Responses& solved, Part part) const;
  [[nodiscard]] bool knows_all(int point) const;
  // With how much of its answer.
  [[nodiscard]] std::optional<std::pair<int, Part>> group_ahead(const PointForces& bearing_mN,
                                                                const std::vector<Eigen::Vector3d>& places_mm) const;
  [[nodiscard]] Eigen::VectorXd force_on_nodes_mN(const PointForces& force_mN) const;
  Result<void> accept(const StaticModel::Responses& solved) const;
  void see_nodes(std::size_t judged);
  void make_groups();

  StaticModel model_;
  geometry::Surface surface_;
  std::vector<int> mesh_point_;  // of each point of the surface
  std::vector<PointInMesh> watched_;
  std::vector<int> inner_;                                        // points of the mesh that are not of the surface
  std::vector<int> seen_nodes_, seen_of_node_;                    // -1: not seen
  Eigen::Index judged_values_ = 0;                                // rows of the surface and the judged places
  Eigen::SparseMatrix<double, Eigen::RowMajor> watched_of_seen_;  // shape functions: a row a place, a column a node
  Eigen::VectorXd standing_seen_mm_;                              // where all but the tools takes it
  Eigen::VectorXd standing_surface_mm_;
  std::vector<std::vector<int>> groups_;  // of points of the surface
  std::vector<int> group_of_point_;
  std::vector<int> mutual_points_;
  std::vector<int> mutual_of_point_;  // -1: none
  Eigen::MatrixXd mutual_compliance_;

  std::optional<Opening> opening_;
  std::vector<OpenCell> open_cells_;

  struct Memory {
    std::mutex mutex;                                // it grows behind it
    std::vector<std::optional<Response>> responses;  // of all rows, or of the first judged_values_
    std::vector<std::uint8_t> lacked_rest;           // of points that were shown
    std::size_t surface_bytes = 0, rest_bytes = 0;
    double relative_residual = 0;
  };
  std::shared_ptr<Memory> memory_ = std::make_shared<Memory>();
};

}  // namespace glisson::mechanics
