#pragma once
// What is seen of an organ, as linear equations: a row a seen point and direction, for its shift and turn, the forces
// of tools, and the amounts of force modes. Each row is divided by its noise. Inside of this room.

#include <array>
#include <Eigen/Core>
#include <Eigen/Geometry>
#include <vector>

#include "guidance/elastic_registration.h"
#include "guidance/force_modes.h"
#include "guidance/frame.h"
#include "guidance/internal/seen_surface.h"
#include "mechanics/elements/point_location.h"

namespace glisson::guidance {

struct SeenRows {
  std::vector<SeenRow> rows;
  double noise_mm = 1;       // of the cloud, as found: from what was stated up to what was allowed
  double trusted_share = 0;  // of the cloud
  double rms_mm = 0;         // of the trusted points, along the normal
};

class SeenEquations {
 public:
  using RowMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

  // All three must outlive it.
  SeenEquations(const ForceModes& modes, const SeenFrame& frame, const RegistrationOptions& options);

  // What is seen of the surface, thinned, in the camera's frame.
  [[nodiscard]] const std::vector<Eigen::Vector3d>& cloud_mm() const { return cloud_mm_; }

  // Against the organ at `pose` (scan to camera) whose points lie at `now_mm` (scan's frame). The cloud's noise is
  // taken for `coarsest_mm` at most.
  [[nodiscard]] SeenRows rows(const Eigen::Isometry3d& pose, const std::vector<Eigen::Vector3d>& now_mm,
                              double coarsest_mm) const;

  // The right-hand side: how far what is seen lies from where the known displacement (3 a point) alone puts it.
  [[nodiscard]] Eigen::VectorXd residuals(const std::vector<SeenRow>& rows, const Eigen::VectorXd& known_mm) const;
  // Columns of shift, turn and tools' forces (`tool_columns`: mm per mN). What is known of them before stands in rows
  // of their own, which `right` gets too: `off` is how far the pose is from the guess.
  [[nodiscard]] Eigen::MatrixXd free_columns(const std::vector<SeenRow>& rows, const Eigen::MatrixXd& tool_columns,
                                             const Eigen::Isometry3d& off, double prior_scale,
                                             Eigen::VectorXd& right) const;
  // Columns of modes, with `free` rows of zeros below.
  [[nodiscard]] static Eigen::MatrixXd mode_columns(const std::vector<SeenRow>& rows, const RowMatrix& scaled_modes,
                                                    Eigen::Index free);

 private:
  // Places of a curve at rest in the mesh, and what of it was seen.
  struct PlacedCurve {
    std::vector<mechanics::PointInMesh> at_rest;
    const SeenCurve* seen;
  };

  void add_cloud_rows(const Eigen::Isometry3d& back, const std::vector<Eigen::Vector3d>& now_mm, double coarsest_mm,
                      SeenRows& seen) const;
  void add_point_rows(const Eigen::Isometry3d& back, const std::vector<Eigen::Vector3d>& now_mm, double coarsest_mm,
                      SeenRows& seen) const;
  void add_curve_rows(const Eigen::Isometry3d& back, const std::vector<Eigen::Vector3d>& now_mm, SeenRows& seen) const;

  const ForceModes& modes_;
  const SeenFrame& frame_;
  const RegistrationOptions& options_;
  std::vector<Eigen::Vector3d> cloud_mm_;
  std::vector<PlacedCurve> curves_;
  std::vector<mechanics::PointInMesh> known_points_;  // at rest
};

// Between points of the mesh, wherever they are.
[[nodiscard]] Eigen::Vector3d between(const std::vector<Eigen::Vector3d>& points_mm, const std::array<int, 4>& points,
                                      const Eigen::Vector4d& weights);

}  // namespace glisson::guidance
