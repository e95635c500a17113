#include "guidance/internal/supported_fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/dense.h"
#include "geometry/nearest.h"
#include "guidance/internal/large_deformation.h"
#include "guidance/internal/organ_fit.h"

namespace glisson::guidance {

using Eigen::Isometry3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

namespace {

constexpr std::array rounds_of_narrow_forces{3, 6, 9, 12, 15};  // when one more is tried
constexpr double negligible_variance = 1e-4;                    // of all the modes together, that may be left out
constexpr double lost_noise_mm = 1.2;      // that no good fit of a pulled organ leaves: another start is worth its time
constexpr double compared_error_mm = 0.5;  // of the surface, where fits are compared: beside the noise
constexpr double farthest_mm = 30.0;       // that a point counts for there
constexpr SpreadRule supported_rule{.posterior_factor = 2.0};

// Of large deformation. Turning by u over a length L takes linear elasticity u^2 / 2L off.
constexpr double neglected_turn_mm = 1.0;
constexpr double most_displaced = 2.0;  // lengths of the organ: Newton's method diverges
constexpr int rounds_a_tangent = 2;     // the forces are fitted about one state
constexpr int equilibrium_steps = 8;    // under forces that stay, once they are found
constexpr double off_equilibrium = 1e-2;
// Log evidence by which linear elasticity must be better to be believed of an organ that turns, whose tissue cannot
// obey it: "very strong" in Kass and Raftery 1995, J. Am. Stat. Assoc. 90:773.
constexpr double linear_gain = 5.0;

class SupportedFit {
 public:
  SupportedFit(const ForceModes& modes, const SeenFrame& frame, const Isometry3d& guess, const Vector3d& gravity_mm_s2,
               const RegistrationOptions& options)
      : fit_(modes, frame, guess, gravity_mm_s2, options) {}

  // Where forces may stand besides the tools: on the unseen surface alone, or everywhere alike.
  enum class Forces { unseen, anywhere };

  void fit_pose() { fit_.fit_pose(); }
  void fit_pose_and_forces(Forces forces, const Isometry3d& from);
  // The same by large deformation: whether the organ came to equilibrium. Of a fit that did not, nothing holds.
  [[nodiscard]] bool fit_large(Forces forces, const Isometry3d& from, LargeDeformation& large);
  [[nodiscard]] const Isometry3d& pose() const { return fit_.pose; }
  // After fit_pose(): whether a tool may have drawn part of the surface away, which misleads the pose alone.
  [[nodiscard]] bool is_pulled() const;
  // That the cloud lies off the fit by.
  [[nodiscard]] double noise_mm() const { return fit_.seen.noise_mm; }
  // Whether it moves the organ so far that linear elasticity errs by turning it.
  [[nodiscard]] bool turns() const;
  // Of what is seen under this fit, comparable between fits.
  [[nodiscard]] double log_evidence() const;
  [[nodiscard]] ElasticPlacement outcome(const std::vector<mechanics::PointInMesh>& targets) const;

 private:
  // Where a tool touches, on the mesh, and what 1 mN there does.
  struct Contact {
    int point = -1;
    MatrixXd per_mN;
  };

  void look_again(double widest_mm);
  void choose_forces(Forces forces);
  void find_contacts();
  void lay_out_loads();
  [[nodiscard]] bool turn_loads(LargeDeformation& large);
  [[nodiscard]] bool settle(LargeDeformation& large);
  [[nodiscard]] bool is_lost() const;
  [[nodiscard]] double length_mm() const;
  void begin(Forces forces, const Isometry3d& from);
  void fit_once(int round);
  void add_narrow_force(const MatrixXd& mode_columns, const MatrixXd& free, const VectorXd& right);

  OrganFit fit_;
  std::vector<std::size_t> narrow_;  // which patches
  std::vector<Contact> contacts_;    // one a tool
  // Of large deformation: the forces of the scaled modes, and of the known and further displacements.
  MatrixXd modes_mN_, further_mN_;
  VectorXd known_mN_;
};

// With where the tools are seen to touch.
void SupportedFit::look_again(double widest_mm) {
  const std::vector<Vector3d> now_mm = fit_.displaced();
  fit_.seen = fit_.equations.rows(fit_.pose, now_mm, {coarsest_noise_mm, widest_mm, true});
  const Isometry3d back = fit_.pose.inverse();
  const double sd_mm = fit_.options.contact_sd_mm;
  for (std::size_t t = 0; t < contacts_.size(); ++t) {
    const int point = contacts_[t].point;
    const Vector3d contact_mm = back * fit_.frame.tools[t].contact_mm;
    const double off_mm = (contact_mm - now_mm[static_cast<std::size_t>(point)]).norm() / std::sqrt(3.0);
    const double trust = robust_weight(off_mm, std::max(sd_mm, widest_mm));
    for (int axis = 0; axis < 3; ++axis) {
      fit_.seen.rows.push_back(
          {{point, point, point, point}, {1, 0, 0, 0}, Vector3d::Unit(axis), contact_mm, sd_mm, trust});
    }
  }
}

bool SupportedFit::is_pulled() const {
  if (!fit_.frame.tools.empty()) return true;
  std::vector<double> off_mm =
      fit_.equations.rows(fit_.pose, fit_.displaced(), {.coarsest_mm = coarsest_noise_mm}).off_mm;
  const auto far = off_mm.end() - static_cast<std::ptrdiff_t>(1 + off_mm.size() / 20);
  std::nth_element(off_mm.begin(), far, off_mm.end());
  return *far > pulled_mm;
}

// ---- The rounds ----

// What is seen is touched by nothing but the tools; forces elsewhere are all alike. Combinations of the modes that
// move nothing are left out: they are most of them.
void SupportedFit::choose_forces(Forces forces) {
  const MatrixXd modes_mm =
      fit_.modes.displacement_mm() *
      fit_.factors_by_what_is_seen(forces == Forces::anywhere ? 1.0 : std::sqrt(fit_.options.touched_by_unseen))
          .asDiagonal();
  fit_.basis_mm = modes_mm * leading_vectors(modes_mm.transpose() * modes_mm, negligible_variance);
}

// Tools are seen on the organ as it lies now.
void SupportedFit::find_contacts() {
  const ForceModes& modes = fit_.modes;
  const std::vector<SeenTool>& tools = fit_.frame.tools;
  if (tools.empty()) return;
  const std::vector<Vector3d> now_mm = fit_.displaced();
  std::vector<Vector3d> surface_mm;
  for (const int p : modes.mesh_point_of()) surface_mm.push_back(now_mm[static_cast<std::size_t>(p)]);
  const geometry::NearestPoint nearest(std::move(surface_mm));
  contacts_.resize(tools.size());
  for (std::size_t t = 0; t < contacts_.size(); ++t) {
    const auto on_surface = static_cast<std::size_t>(nearest.nearest(fit_.pose.inverse() * tools[t].contact_mm).point);
    const int point = modes.mesh_point_of()[on_surface];
    if (point == contacts_[t].point) continue;
    contacts_[t] = {point, modes.under_tool_mm_mN(modes.surface().points_mm[on_surface], tools[t].radius_mm)};
  }
}

// Known forces of tools keep their direction in the camera's frame. Amounts of unknown ones are of unit variance.
void SupportedFit::lay_out_loads() {
  fit_.known_mm = fit_.at_rest_mm;
  std::vector<MatrixXd> unknown;
  for (std::size_t t = 0; t < contacts_.size(); ++t) {
    const auto& force_mN = fit_.frame.tools[t].force_mN;
    if (force_mN) {
      fit_.known_mm += contacts_[t].per_mN * (fit_.pose.linear().transpose() * *force_mN);
    } else {
      unknown.emplace_back(tool_sd_mN * contacts_[t].per_mN);
    }
  }
  for (const std::size_t k : narrow_) {
    unknown.emplace_back(fit_.options.narrow_sd_mm *
                         fit_.modes.narrow_displacement_mm().middleCols<3>(3 * static_cast<Eigen::Index>(k)));
  }
  fit_.further_mm.resize(fit_.known_mm.size(), 3 * static_cast<Eigen::Index>(unknown.size()));
  for (std::size_t k = 0; k < unknown.size(); ++k)
    fit_.further_mm.middleCols<3>(3 * static_cast<Eigen::Index>(k)) = unknown[k];
}

void SupportedFit::add_narrow_force(const MatrixXd& mode_columns, const MatrixXd& free, const VectorXd& right) {
  const MatrixXd further =
      fit_.options.narrow_sd_mm *
      SeenEquations::mode_columns(fit_.seen.rows, fit_.modes.narrow_displacement_mm(), free.cols());
  const VectorXd gains = evidence_gains(fit_.fit, mode_columns, free, right, further);
  Eigen::Index best = 0;
  if (gains.size() == 0 || !(gains.maxCoeff(&best) > fit_.options.narrow_gain)) return;
  const auto patch = static_cast<std::size_t>(best);
  if (std::find(narrow_.begin(), narrow_.end(), patch) == narrow_.end()) narrow_.push_back(patch);
}

void SupportedFit::begin(Forces forces, const Isometry3d& from) {
  fit_.pose = from;
  fit_.u_mm = fit_.at_rest_mm;
  narrow_.clear();
  contacts_.clear();
  choose_forces(forces);
}

// Under loads and modes as they are laid out.
void SupportedFit::fit_once(int round) {
  const RegistrationOptions& options = fit_.options;
  look_again(options.widest_mm * std::max(0.0, 1.0 - static_cast<double>(round) / options.widest_rounds));
  const std::vector<SeenRow>& seen = fit_.seen.rows;
  VectorXd right = fit_.equations.residuals(seen, fit_.known_mm);
  const MatrixXd free =
      fit_.equations.free_columns(seen, {fit_.further_mm}, fit_.guess.inverse() * fit_.pose, 1.0, right);
  const MatrixXd modes = fit_.mode_columns(free.cols());
  double independent = 0;
  for (const SeenRow& row : seen) independent += row.share;
  fit_.follow(fit_weighed_by_evidence(modes, free, right, independent, fit_.largest_variance(round)));
  const bool try_narrow = std::count(rounds_of_narrow_forces.begin(), rounds_of_narrow_forces.end(), round) > 0;
  if (try_narrow && static_cast<int>(narrow_.size()) < options.narrow_forces) add_narrow_force(modes, free, right);
}

void SupportedFit::fit_pose_and_forces(Forces forces, const Isometry3d& from) {
  begin(forces, from);
  for (int round = 0; round < fit_.options.supported_rounds; ++round) {
    find_contacts();
    lay_out_loads();
    fit_once(round);
  }
  look_again(0);
}

// Forces are known by what linear elasticity moves under them; from here on they move the organ about where it lies.
bool SupportedFit::turn_loads(LargeDeformation& large) {
  known_mN_ = fit_.modes.forces_mN(fit_.known_mm);
  further_mN_ = fit_.modes.forces_mN(fit_.further_mm);
  if (!large.turn_to(fit_.u_mm)) return false;
  fit_.known_mm = large.under(known_mN_);
  fit_.further_mm = large.moved_by(further_mN_);
  fit_.basis_mm = large.moved_by(modes_mN_);
  return true;
}

// Equilibrium under the forces that were found.
bool SupportedFit::settle(LargeDeformation& large) {
  const VectorXd force_mN =
      known_mN_ + modes_mN_ * fit_.fit.modes + further_mN_ * fit_.fit.free.tail(further_mN_.cols());
  for (int step = 0; step < equilibrium_steps; ++step) {
    if (!large.turn_to(fit_.u_mm)) return false;
    if (large.off_equilibrium(force_mN) < off_equilibrium) return true;
    fit_.u_mm = large.under(force_mN);
    if (is_lost()) return false;
  }
  return false;
}

double SupportedFit::length_mm() const { return geometry::bounding_box(fit_.modes.mesh().points_mm).diagonal_mm(); }

bool SupportedFit::turns() const {
  double most_mm = 0;
  for (const int p : fit_.modes.mesh_point_of()) most_mm = std::max(most_mm, fit_.u_mm.segment<3>(3 * p).norm());
  return most_mm * most_mm > 2 * length_mm() * neglected_turn_mm;
}

bool SupportedFit::is_lost() const {
  return !fit_.u_mm.allFinite() || fit_.u_mm.lpNorm<Eigen::Infinity>() > most_displaced * length_mm();
}

bool SupportedFit::fit_large(Forces forces, const Isometry3d& from, LargeDeformation& large) {
  begin(forces, from);
  modes_mN_ = fit_.modes.forces_mN(fit_.basis_mm);
  for (int round = 0; round < fit_.options.supported_rounds; ++round) {
    if (round % rounds_a_tangent == 0) {
      find_contacts();
      lay_out_loads();
      if (!turn_loads(large)) return false;
    }
    fit_once(round);
    if (is_lost()) return false;
  }
  const bool is_settled = settle(large);
  if (is_settled) look_again(0);
  return is_settled;
}

double SupportedFit::log_evidence() const {
  const double error_mm = std::hypot(fit_.frame.noise_mm, compared_error_mm);
  double log_likelihood = 0;  // Student's t of four degrees of freedom
  for (std::size_t p = 0; p < fit_.seen.off_mm.size(); ++p) {
    const double ratio = std::min(fit_.seen.off_mm[p], farthest_mm) / error_mm;
    log_likelihood -= 2.5 * fit_.seen.rows[p].share * std::log(1 + ratio * ratio / 4);
  }
  const double off_prior = fit_.fit.modes.squaredNorm() / fit_.fit.variance / std::max(1.0, fit_.fit.kappa) +
                           fit_.fit.free.tail(fit_.further_mm.cols()).squaredNorm() +
                           fit_.equations.squared_off_guess(fit_.guess.inverse() * fit_.pose);
  return log_likelihood - 0.5 * off_prior - fit_.fit.log_occam;
}

ElasticPlacement SupportedFit::outcome(const std::vector<mechanics::PointInMesh>& targets) const {
  // A tool's displacement that is wrong by a share is a force that is wrong by it.
  AskedTools asked{{}, tool_sd_mN, supported_rule.posterior_factor, supported_rule.elastic_share};
  for (const SeenTool& tool : fit_.frame.tools) {
    if (!tool.force_mN) asked.tools.push_back(tool.id);
  }
  return fit_.outcome(targets, supported_rule, asked);
}

// Either way about each axis, the organ's middle where it is.
std::vector<Isometry3d> turned(const Isometry3d& pose, const Vector3d& middle_mm, double degrees) {
  std::vector<Isometry3d> poses;
  for (const double angle : {degrees, -degrees}) {
    for (int axis = 0; axis < 3; ++axis) {
      const Eigen::AngleAxisd turn(angle * std::numbers::pi / 180, Vector3d::Unit(axis));
      poses.push_back(pose * Eigen::Translation3d(middle_mm) * turn * Eigen::Translation3d(-middle_mm));
    }
  }
  return poses;
}

}  // namespace

ElasticPlacement register_supported(const ForceModes& modes, const SeenFrame& frame, const Isometry3d& from,
                                    const std::vector<mechanics::PointInMesh>& targets, const Vector3d& gravity_mm_s2,
                                    const RegistrationOptions& options) {
  using Forces = SupportedFit::Forces;
  SupportedFit fit(modes, frame, from, gravity_mm_s2, options);
  fit.fit_pose();
  ElasticPlacement best;
  double best_evidence = -std::numeric_limits<double>::infinity();
  double best_noise_mm = 0;
  bool turns = false;
  const auto take_if_better = [&](double gain) {
    const double log_evidence = fit.log_evidence() + gain;
    if (log_evidence <= best_evidence) return;
    best_evidence = log_evidence;
    best_noise_mm = fit.noise_mm();
    turns = fit.turns();
    best = fit.outcome(targets);
  };
  const auto try_from = [&](const Isometry3d& start, Forces forces) {
    fit.fit_pose_and_forces(forces, start);
    take_if_better(0);
  };
  std::vector<Isometry3d> starts{fit.pose()};
  const bool is_pulled = fit.is_pulled();
  if (is_pulled) starts.push_back(from);
  for (const Isometry3d& start : starts) {
    for (const Forces forces : {Forces::unseen, Forces::anywhere}) try_from(start, forces);
  }
  if (is_pulled && best_noise_mm >= lost_noise_mm) {
    for (const Isometry3d& start : turned(from, modes.centroid_mm(), options.guess_sd_deg)) {
      try_from(start, Forces::anywhere);
    }
  }
  if (!turns || !options.large_deformation) return best;
  LargeDeformation large(modes, mechanics::MaterialLaw::corotational);
  for (const Isometry3d& start : starts) {
    if (fit.fit_large(Forces::anywhere, start, large)) take_if_better(linear_gain);
  }
  return best;
}

}  // namespace glisson::guidance
