#pragma once
// What a linear body answers to forces on its surface. A unit force on a point is solved for once by the kept factor
// and remembered. That is done in fixed groups of neighbours, so that what is remembered does not depend on who asked
// first. What the model's mutual points (of the walls of cuts) answer to each other is known from the start. Forces on
// them are solved for anew each time that all is seen under them.
//
// Where a cut has opened, what the opening adds is kept apart from what is remembered of the whole body (opening.h).
// That is the loads that forces put on its jumps, and what follows from those.
//
// What is seen: the surface, the watched places, and the inner points of the mesh, in this order, 3 values each (mm).

#include <Eigen/Core>
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
  // `standing` is the body's state without further forces.
  SurfaceResponses(StaticModel model, const StaticResult& standing, std::vector<PointInMesh> watched);

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

  // How a point of the whole body moves by a force on another, both remembered or mutual.
  [[nodiscard]] Eigen::Matrix3d compliance(int at, int of) const;
  // Between all mutual points, 3 a point, in their order.
  [[nodiscard]] const Eigen::MatrixXd& mutual_compliance() const { return mutual_compliance_; }

  // Of the whole body.
  [[nodiscard]] const Eigen::VectorXd& standing_seen_mm() const { return standing_seen_mm_; }
  // The opening's amplitudes and its jumps (mm, 3 a point) under such forces; none: without values.
  [[nodiscard]] Eigen::VectorXd amplitudes_under(const PointForces& force_mN, const WallForces& wall_mN) const;
  [[nodiscard]] Eigen::VectorXd jumps_under(const PointForces& force_mN, const WallForces& wall_mN) const;
  // Where what is seen lies under forces on points that are remembered or mutual, and on walls. For the surface alone
  // it costs a fraction, and the other values are those of the standing loads. Failure: "not-converged".
  enum class Part { surface, all };
  [[nodiscard]] Result<Eigen::VectorXd> seen_under(const PointForces& force_mN, const WallForces& wall_mN,
                                                   Part part = Part::all) const;
  [[nodiscard]] Eigen::Index surface_values() const { return 3 * static_cast<Eigen::Index>(mesh_point_.size()); }
  [[nodiscard]] Eigen::Index watched_values() const { return 3 * static_cast<Eigen::Index>(watched_.size()); }

  // Of what is seen, the displacement of each point of the mesh.
  [[nodiscard]] std::vector<Eigen::Vector3d> mesh_points_mm(const Eigen::VectorXd& seen_mm) const;
  // By the cells' corners alone: the largest mean strain of any cell, and the cells turned inside out.
  // An open cell counts by both of its sides.
  [[nodiscard]] StrainRange strain_range(const Eigen::VectorXd& seen_mm, const Eigen::VectorXd& jumps_mm) const;
  [[nodiscard]] double relative_residual() const;  // the worst so far

 private:
  using Response = Eigen::Matrix<double, Eigen::Dynamic, 3>;
  [[nodiscard]] Eigen::Index seen_values() const { return standing_seen_mm_.size(); }
  [[nodiscard]] Eigen::MatrixXd seen_part(const Eigen::MatrixXd& displacement_mm) const;  // of all nodes
  Result<void> accept(const StaticModel::Responses& solved) const;
  void make_groups();

  StaticModel model_;
  geometry::Surface surface_;
  std::vector<int> mesh_point_;  // of each point of the surface
  std::vector<PointInMesh> watched_;
  std::vector<int> inner_;  // points of the mesh that are not of the surface
  std::vector<Eigen::Index> seen_of_mesh_point_;
  Eigen::VectorXd standing_seen_mm_;
  std::vector<std::vector<int>> groups_;  // of points of the surface
  std::vector<int> group_of_point_;
  std::vector<int> mutual_points_;
  std::vector<int> mutual_of_point_;  // -1: none
  Eigen::MatrixXd mutual_compliance_;

  std::optional<Opening> opening_;
  std::vector<OpenCell> open_cells_;

  struct Memory {
    std::mutex mutex;  // it grows behind it
    std::vector<std::optional<Response>> responses;
    double relative_residual = 0;
  };
  std::shared_ptr<Memory> memory_ = std::make_shared<Memory>();
};

}  // namespace glisson::mechanics
