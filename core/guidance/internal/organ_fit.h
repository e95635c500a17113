#pragma once
// The state of one fit of an organ to a frame, and what every fit does. That is the pose alone, by points to planes
// with weights of Student's t (iteratively reweighted), and the answer with its standard deviations. What is searched
// for between them differs: elastic_registration.cpp for an organ that nothing is known to hold, supported_fit.h
// otherwise.

#include <string>
#include <vector>

#include "geometry/nearest.h"
#include "guidance/elastic_registration.h"
#include "guidance/internal/evidence_fit.h"
#include "guidance/internal/seen_equations.h"

namespace glisson::guidance {

constexpr double coarsest_noise_mm = 2.0;  // that elastic rounds take the cloud for
constexpr double pulled_mm = 6.0;    // that some of the cloud lies off the rigid organ where a tool may be at work
constexpr double tool_sd_mN = 10e3;  // of each component of a force that is asked for

// A target's standard deviation, from the posterior's and what the posterior does not know: the parts are added by
// their squares. From bodies that were not judged (docs/guidance.md).
struct SpreadRule {
  double posterior_factor = 1;
  double elastic_share = 0.3;         // of the displacement over the surface (rms), that the model gets wrong
  double elastic_share_of_depth = 0;  // added to that share, a mm from what was seen
  double smallest_sd_mm = 0.25;       // what is left of a rigid organ at its surface
  double share_of_depth = 0;          // added to that, of the distance from what was seen
};

// Which tools' forces were asked for: three of the further amounts each, from the first.
struct AskedTools {
  std::vector<std::string> tools;
  double unit_mN = 1;      // that an amount of 1 is
  double sd_factor = 1;    // of the posterior's standard deviation
  double wrong_share = 0;  // of each force, that the model gets wrong beside
};

struct OrganFit {
  // All but `from` and `gravity_mm_s2` must outlive it.
  OrganFit(const ForceModes& the_modes, const SeenFrame& the_frame, const Eigen::Isometry3d& from,
           const Eigen::Vector3d& gravity_mm_s2, const RegistrationOptions& the_options);

  // From where the pose is, with the displacement as it is.
  void fit_pose();
  // Of the forces in a round: they are let grow slowly, so that the pose comes first.
  [[nodiscard]] double largest_variance(int round) const;
  // Takes over what a round has found: displacement and pose.
  void follow(EvidenceFit found);
  // The points of the mesh now, in the scan's frame.
  [[nodiscard]] std::vector<Eigen::Vector3d> displaced() const;
  // What is seen is touched less: a factor a mode, `seen_root` for patches that the cloud covers, 1 for others.
  [[nodiscard]] Eigen::VectorXd factors_by_what_is_seen(double seen_root) const;
  // Columns of the modes at what is seen, with `free` rows of zeros below.
  [[nodiscard]] Eigen::MatrixXd mode_columns(Eigen::Index free) const;
  [[nodiscard]] ElasticPlacement outcome(const std::vector<mechanics::PointInMesh>& targets, const SpreadRule& rule,
                                         const AskedTools& asked) const;

  const ForceModes& modes;
  const SeenFrame& frame;
  const RegistrationOptions& options;
  SeenEquations equations;
  Eigen::Isometry3d guess, pose;
  Eigen::VectorXd at_rest_mm;  // displacement under weight and by the supports, 3 a point
  Eigen::VectorXd known_mm;    // under the tools' known forces too
  Eigen::VectorXd u_mm;
  // Displacements under the modes, whose amounts have one variance: basis_mm times mixing, or basis_mm alone where
  // there is none.
  SeenEquations::RowMatrix basis_mm;
  Eigen::MatrixXd mixing;
  Eigen::MatrixXd further_mm;  // by one of each further amount, 3 values a point
  EvidenceFit fit;
  SeenRows seen;  // where the last round ended

 private:
  [[nodiscard]] Sentence what_contradicts(double visible_share) const;
  void move_pose(const Eigen::Vector3d& shift_mm, const Eigen::Vector3d& turn);
  [[nodiscard]] geometry::NearestPoint seen_in_scan() const;
  [[nodiscard]] double visible_share(const geometry::NearestPoint& cloud,
                                     const std::vector<Eigen::Vector3d>& now_mm) const;
  [[nodiscard]] Eigen::MatrixXd mixed(Eigen::MatrixXd of_basis) const;
  [[nodiscard]] Eigen::Index mode_count() const { return mixing.size() > 0 ? mixing.cols() : basis_mm.cols(); }
  [[nodiscard]] Eigen::Matrix<double, 3, Eigen::Dynamic> columns_at(const mechanics::PointInMesh& place) const;
};

}  // namespace glisson::guidance
