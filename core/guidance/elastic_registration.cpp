#include "guidance/elastic_registration.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <limits>

#include "guidance/internal/organ_fit.h"
#include "guidance/internal/seen_surface.h"
#include "guidance/internal/supported_fit.h"

namespace glisson::guidance {

using Eigen::Isometry3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

namespace {

constexpr double hidden_tool_radius_mm = 8.0;
constexpr double min_trust = 0.02;  // of a point, where evidences are compared
// Fitted on 34 cases of 23 livers by the 0.9 quantile's loss, then widened by what each liver showed that was left out
// (docs/guidance.md). What the fit does not know grows with the distance from what was seen.
constexpr SpreadRule spread_rule{.posterior_factor = 1.73,
                                 .elastic_share = 0.1,
                                 .elastic_share_of_depth = 0.0023,
                                 .smallest_sd_mm = 0.1,
                                 .share_of_depth = 0.011};

// Of an organ that nothing is known to hold.
class FreeFit {
 public:
  FreeFit(const ForceModes& modes, const SeenFrame& frame, const Isometry3d& guess, const Vector3d& gravity_mm_s2,
          const RegistrationOptions& options)
      : fit_(modes, frame, guess, gravity_mm_s2, options) {
    fit_.basis_mm = modes.reduced_basis_mm();
  }

  // What forces there may be: on the unseen surface alone; everywhere alike; and of a tool that nobody mentioned,
  // where the cloud lies farthest off the rigid organ.
  enum class Forces { unseen, anywhere, hidden_tool };

  void fit_pose();
  // After fit_pose(), and anew for each kind of forces.
  void fit_pose_and_forces(Forces forces);
  // Of the data under these forces, comparable between kinds of them.
  [[nodiscard]] double log_evidence() const { return log_evidence_; }
  // Whether some of the cloud lies so far off the rigid organ that a tool may pull there.
  [[nodiscard]] bool is_pulled() const { return farthest_off_mm_ > pulled_mm; }
  [[nodiscard]] ElasticPlacement outcome(const std::vector<mechanics::PointInMesh>& targets) const;

 private:
  void find_farthest();
  void choose_forces(Forces forces);
  void add_hidden_tool();
  // Why a fit that bends so far is none; without text where it is one.
  [[nodiscard]] Sentence what_bending_says(const ElasticPlacement& placed) const;

  OrganFit fit_;
  Isometry3d rigid_pose_;          // before any forces
  Vector3d farthest_mm_{0, 0, 0};  // where the cloud lies farthest off the rigid organ, and how far
  double farthest_off_mm_ = 0;
  double log_evidence_ = 0;
  std::vector<std::string> asked_tools_;
};

void FreeFit::fit_pose() {
  fit_.fit_pose();
  rigid_pose_ = fit_.pose;
  find_farthest();
}

// The middle of the twentieth of the cloud that lies farthest off, on the organ at rest.
void FreeFit::find_farthest() {
  const ForceModes& modes = fit_.modes;
  const SeenSurface surface(modes.surface(), modes.mesh_point_of(), fit_.displaced());
  const Isometry3d back = fit_.pose.inverse();
  std::vector<std::pair<double, Vector3d>> off;
  for (const Vector3d& point : fit_.equations.cloud_mm()) {
    const SeenSurface::Found found = surface.find(back * point);
    off.emplace_back(std::hypot(found.off_mm, found.beside_mm),
                     between(modes.mesh().points_mm, found.row.points, found.row.weights));
  }
  std::sort(off.begin(), off.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  const std::size_t some = std::max<std::size_t>(1, off.size() / 20);
  farthest_mm_.setZero();
  for (std::size_t i = 0; i < some; ++i) farthest_mm_ += off[i].second / static_cast<double>(some);
  farthest_off_mm_ = off[some - 1].first;
}

void FreeFit::add_hidden_tool() {
  fit_.further_mm = fit_.modes.under_tool_mm_mN(farthest_mm_, hidden_tool_radius_mm);
  asked_tools_.emplace_back("hidden tool");
}

// What is seen is touched by nothing but the tools; forces elsewhere are all alike.
void FreeFit::choose_forces(Forces forces) {
  const Isometry3d back = fit_.pose.inverse();
  const VectorXd factors =
      fit_.factors_by_what_is_seen(forces == Forces::anywhere ? 1.0 : std::sqrt(fit_.options.touched_by_unseen));
  const MatrixXd scaled = fit_.modes.reduced_amounts() * factors.asDiagonal();
  // Amounts that forces of one variance give the reduced basis: its covariance is the square of this.
  fit_.mixing = (scaled * scaled.transpose()).llt().matrixL();
  asked_tools_.clear();
  fit_.further_mm.resize(fit_.known_mm.size(), 0);
  if (forces == Forces::hidden_tool) add_hidden_tool();
  for (const SeenTool& tool : fit_.frame.tools) {
    const MatrixXd per_mN = fit_.modes.under_tool_mm_mN(back * tool.contact_mm, tool.radius_mm);
    if (tool.force_mN) {
      fit_.known_mm += per_mN * (back.linear() * *tool.force_mN);
    } else {
      fit_.further_mm.conservativeResize(Eigen::NoChange, fit_.further_mm.cols() + 3);
      fit_.further_mm.rightCols<3>() = per_mN;
      asked_tools_.push_back(tool.id);
    }
  }
}

void FreeFit::fit_pose_and_forces(Forces forces) {
  const RegistrationOptions& options = fit_.options;
  fit_.pose = forces == Forces::hidden_tool ? fit_.guess : rigid_pose_;  // a pulled organ misleads the pose alone
  fit_.known_mm = fit_.at_rest_mm;
  fit_.u_mm = fit_.known_mm;
  if (forces == Forces::hidden_tool) find_farthest();
  choose_forces(forces);
  const auto look_again = [&] {
    fit_.seen = fit_.equations.rows(fit_.pose, fit_.displaced(), {.coarsest_mm = coarsest_noise_mm});
  };
  const auto independent = static_cast<double>(boxes_of(fit_.equations.cloud_mm(), options.independent_spacing_mm));
  for (int round = 0; round < options.elastic_rounds; ++round) {
    look_again();
    const std::vector<SeenRow>& seen = fit_.seen.rows;
    const double share = std::min(1.0, independent / static_cast<double>(seen.size()));
    VectorXd right = fit_.equations.residuals(seen, fit_.known_mm);
    const MatrixXd free = fit_.equations.free_columns(seen, {fit_.further_mm, tool_sd_mN},
                                                      fit_.guess.inverse() * fit_.pose, 1.0 / std::sqrt(share), right);
    fit_.follow(
        fit_by_evidence(fit_.mode_columns(free.cols()), free, right, independent, fit_.largest_variance(round)));
    double weights = 0;
    for (const SeenRow& row : seen) weights += std::log(std::sqrt(std::max(row.trust, min_trust)) / row.noise_mm);
    log_evidence_ = fit_.fit.log_evidence + share * weights;
  }
  look_again();
}

// A cloud in a mirror and the liver of another patient are fitted too, where a liver is bent enough. Right simulated
// ones were bent by 11 mm at most. Wrong ones are bent by more, or what was seen stays off the bent organ too.
Sentence FreeFit::what_bending_says(const ElasticPlacement& placed) const {
  const RegistrationOptions& options = fit_.options;
  if (placed.elastic_rms_mm > options.most_bent_mm) {
    return {GLISSON_TEXT("Only bent by {0} mm (rms) does the organ lie where it was seen: it is another organ, "
                         "the cloud is mirrored, or the guess is far off."),
            {fmt::format("{:.0f}", placed.elastic_rms_mm)}};
  }
  const double stated_mm = std::hypot(fit_.frame.noise_mm, options.surface_error_mm);
  const double strangeness = placed.elastic_rms_mm / options.most_bent_mm + placed.residual_rms_mm / stated_mm;
  if (placed.elastic_rms_mm < options.strange_when_bent_mm || strangeness <= options.most_strange) return {};
  return {GLISSON_TEXT("Bent by {0} mm (rms), the organ still lies {1} mm off what was seen, where the noise explains "
                       "{2} mm: it is another patient's, or the noise is larger than stated."),
          {fmt::format("{:.0f}", placed.elastic_rms_mm), fmt::format("{:.1f}", placed.residual_rms_mm),
           fmt::format("{:.1f}", stated_mm)}};
}

ElasticPlacement FreeFit::outcome(const std::vector<mechanics::PointInMesh>& targets) const {
  ElasticPlacement placed = fit_.outcome(targets, spread_rule, {asked_tools_});
  if (!placed.converged) return placed;
  placed.why_not = what_bending_says(placed);
  placed.converged = placed.why_not.text.empty();
  return placed;
}

}  // namespace

RegistrationOptions following_options() {
  RegistrationOptions options;
  options.rigid_rounds = 6;
  options.elastic_rounds = 8;
  options.maximum_points = 500;
  return options;
}

ElasticPlacement register_elastic(const ForceModes& modes, const SeenFrame& frame, const Isometry3d& from,
                                  const std::vector<mechanics::PointInMesh>& targets, const Vector3d& gravity_mm_s2,
                                  const RegistrationOptions& options) {
  if (modes.is_supported()) return register_supported(modes, frame, from, targets, gravity_mm_s2, options);
  FreeFit fit(modes, frame, from, gravity_mm_s2, options);
  fit.fit_pose();
  std::vector<FreeFit::Forces> kinds{FreeFit::Forces::unseen, FreeFit::Forces::anywhere};
  if (fit.is_pulled()) kinds.push_back(FreeFit::Forces::hidden_tool);
  ElasticPlacement best;
  double best_evidence = -std::numeric_limits<double>::infinity();
  for (const FreeFit::Forces kind : kinds) {
    fit.fit_pose_and_forces(kind);
    if (fit.log_evidence() <= best_evidence) continue;
    best_evidence = fit.log_evidence();
    best = fit.outcome(targets);
  }
  return best;
}

}  // namespace glisson::guidance
