#pragma once
// What is seen of an organ, as linear equations: a row a seen point and direction. Unknown are its shift and turn, the
// forces of tools, and the amounts of force modes. Each row is divided by its noise, and counts by its trust and share.

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
  std::vector<double> off_mm;        // of each point of the cloud, in any direction
  double noise_mm = 1;               // of the cloud, as found: from what was stated up to what was allowed
  double trusted_share = 0;          // of the cloud
  double rms_mm = 0;                 // of the trusted points, along the normal
  std::vector<double> curve_off_mm;  // of each of the frame's curves: median distance from where the organ has it
};

// How the organ is looked at.
struct Look {
  double coarsest_mm = 0;      // that the cloud's noise is taken for at most
  double widest_mm = 0;        // that points may be off by and still be trusted
  bool is_share_told = false;  // whether rows say what share of an independent one they are; each is one otherwise
};

class SeenEquations {
 public:
  // Displacements by unknown amounts that are no modes: of tools' forces. `sd` is that of each amount.
  struct Further {
    const Eigen::MatrixXd& per_unit_mm;
    double sd = 1;
  };
  using RowMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

  // All three must outlive it.
  SeenEquations(const ForceModes& modes, const SeenFrame& frame, const RegistrationOptions& options);

  // What is seen of the surface, thinned, in the camera's frame.
  [[nodiscard]] const std::vector<Eigen::Vector3d>& cloud_mm() const { return cloud_mm_; }

  // Against the organ at `pose` (scan to camera) whose points lie at `now_mm` (scan's frame).
  [[nodiscard]] SeenRows rows(const Eigen::Isometry3d& pose, const std::vector<Eigen::Vector3d>& now_mm,
                              const Look& look) const;
  // The same, where its surface has been laid out already.
  [[nodiscard]] SeenRows rows(const Eigen::Isometry3d& pose, const std::vector<Eigen::Vector3d>& now_mm,
                              const SeenSurface& surface, const Look& look) const;

  // The right-hand side: how far what is seen lies from where the known displacement (3 a point) alone puts it.
  [[nodiscard]] Eigen::VectorXd residuals(const std::vector<SeenRow>& rows, const Eigen::VectorXd& known_mm) const;
  // Columns of shift and turn, and of further displacements (3 a point) by one of an amount each. What is known of them
  // before stands in rows of their own, which `right` gets too: `off` is how far the pose is from the guess.
  [[nodiscard]] Eigen::MatrixXd free_columns(const std::vector<SeenRow>& rows, const Further& further,
                                             const Eigen::Isometry3d& off, double prior_scale,
                                             Eigen::VectorXd& right) const;
  // Of how far the pose is from the guess: the square of shift and turn, divided by how well they were known.
  [[nodiscard]] double squared_off_guess(const Eigen::Isometry3d& off) const;
  // Columns of modes (3 values a point), with `free` rows of zeros below.
  [[nodiscard]] static Eigen::MatrixXd mode_columns(const std::vector<SeenRow>& rows, const RowMatrix& modes_mm,
                                                    Eigen::Index free);

 private:
  // Places of a curve at rest in the mesh, and what of it was seen.
  struct PlacedCurve {
    std::vector<mechanics::PointInMesh> at_rest;
    const SeenCurve* seen;
  };

  void add_cloud_rows(const Eigen::Isometry3d& back, const SeenSurface& surface, const Look& look,
                      SeenRows& seen) const;
  void add_point_rows(const Eigen::Isometry3d& back, const std::vector<Eigen::Vector3d>& now_mm, const Look& look,
                      SeenRows& seen) const;
  void add_curve_rows(const Eigen::Isometry3d& back, const std::vector<Eigen::Vector3d>& now_mm, const Look& look,
                      SeenRows& seen) const;
  // Of an independent point, that each of these is: 1 where it is not asked for.
  [[nodiscard]] double share_of(const std::vector<Eigen::Vector3d>& points_mm, const Look& look) const;

  const ForceModes& modes_;
  const SeenFrame& frame_;
  const RegistrationOptions& options_;
  std::vector<Eigen::Vector3d> cloud_mm_;
  std::vector<PlacedCurve> curves_;
  std::vector<mechanics::PointInMesh> known_points_;  // at rest
};

// How many boxes of this spacing the points lie in.
[[nodiscard]] std::size_t boxes_of(const std::vector<Eigen::Vector3d>& points_mm, double spacing_mm);

// Between points of the mesh, wherever they are.
[[nodiscard]] Eigen::Vector3d between(const std::vector<Eigen::Vector3d>& points_mm, const std::array<int, 4>& points,
                                      const Eigen::Vector4d& weights);

}  // namespace glisson::guidance
