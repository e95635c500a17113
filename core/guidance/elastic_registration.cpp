#include "guidance/elastic_registration.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "geometry/nearest.h"
#include "guidance/internal/evidence_fit.h"
#include "guidance/internal/seen_equations.h"
#include "guidance/internal/seen_surface.h"

namespace glisson::guidance {

using Eigen::Isometry3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

namespace {

constexpr double coarsest_noise_mm = 2.0;  // that elastic rounds take the cloud for
constexpr int rounds_to_full_forces = 12;
constexpr double pulled_mm = 6.0;  // that some of the cloud lies off the rigid organ where a tool may be at work
constexpr double hidden_tool_radius_mm = 8.0;
constexpr double min_trust = 0.02;  // of a point, where evidences are compared
// Of the standard deviation, from tests on bodies that were not judged (docs/guidance.md): the posterior's, times; the
// part of the elastic displacement that the model gets wrong; and what is left of a rigid organ.
constexpr double posterior_factor = 1.5;
constexpr double elastic_share = 0.3;
constexpr double smallest_sd_mm = 0.25;

class ElasticFit {
 public:
  ElasticFit(const ForceModes& modes, const SeenFrame& frame, const Isometry3d& from, const Vector3d& gravity_mm_s2,
             const RegistrationOptions& options);

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
  [[nodiscard]] std::vector<Vector3d> displaced() const;
  const std::vector<SeenRow>& look_again(double coarsest_mm);
  void find_farthest();
  void choose_forces(Forces forces);
  void add_hidden_tool();
  void move_pose(const Vector3d& shift_mm, const Vector3d& turn);
  [[nodiscard]] double independent_points() const;
  [[nodiscard]] geometry::NearestPoint seen_in_scan() const;
  [[nodiscard]] double visible_share() const;
  [[nodiscard]] Eigen::Matrix<double, 3, Eigen::Dynamic> columns_at(const mechanics::PointInMesh& place) const;

  const ForceModes& modes_;
  const SeenFrame& frame_;
  const RegistrationOptions& options_;
  SeenEquations equations_;
  Isometry3d guess_, pose_;
  Isometry3d rigid_pose_;          // before any forces
  Vector3d farthest_mm_{0, 0, 0};  // where the cloud lies farthest off the rigid organ, and how far
  double farthest_off_mm_ = 0;
  double log_evidence_ = 0;
  VectorXd gravity_mm_;
  VectorXd known_mm_;  // displacement under known loads, 3 a point
  VectorXd u_mm_;
  SeenEquations::RowMatrix scaled_modes_;  // times the root of each force's own variance
  MatrixXd tool_columns_;                  // mm per mN of unknown tool forces, 3 a tool
  std::vector<std::string> asked_tools_;
  EvidenceFit fit_;
  SeenRows seen_;  // where the last round ended
};

ElasticFit::ElasticFit(const ForceModes& modes, const SeenFrame& frame, const Isometry3d& from,
                       const Vector3d& gravity_mm_s2, const RegistrationOptions& options)
    : modes_(modes), frame_(frame), options_(options), equations_(modes, frame, options), guess_(from), pose_(from) {
  gravity_mm_ =
      gravity_mm_s2.isZero() ? VectorXd::Zero(modes.displacement_mm().rows()) : modes.under_gravity_mm(gravity_mm_s2);
  known_mm_ = gravity_mm_;
  u_mm_ = known_mm_;
}

std::vector<Vector3d> ElasticFit::displaced() const {
  std::vector<Vector3d> points = modes_.mesh().points_mm;
  for (std::size_t p = 0; p < points.size(); ++p) points[p] += u_mm_.segment<3>(3 * static_cast<Eigen::Index>(p));
  return points;
}

const std::vector<SeenRow>& ElasticFit::look_again(double coarsest_mm) {
  seen_ = equations_.rows(pose_, displaced(), coarsest_mm);
  return seen_.rows;
}

// ---- The rounds ----

void ElasticFit::move_pose(const Vector3d& shift_mm, const Vector3d& turn) {
  const double angle = turn.norm();
  const Vector3d center = modes_.centroid_mm();
  Isometry3d motion = Isometry3d::Identity();
  if (angle > 0) motion.rotate(Eigen::AngleAxisd(angle, turn / angle));
  motion.translation() = center + shift_mm - motion.linear() * center;
  pose_ = pose_ * motion;
}

void ElasticFit::fit_pose() {
  u_mm_ = known_mm_;
  for (int round = 0; round < options_.rigid_rounds; ++round) {
    const double coarsest_mm = 1.5 + 10.0 * (1.0 - static_cast<double>(round) / options_.rigid_rounds);
    const std::vector<SeenRow>& seen = look_again(coarsest_mm);
    VectorXd right = equations_.residuals(seen, u_mm_);
    const MatrixXd columns = equations_.free_columns(seen, tool_columns_, guess_.inverse() * pose_, 1.0, right);
    const Eigen::Matrix<double, 6, 6> normal = columns.transpose() * columns;
    const Eigen::Matrix<double, 6, 1> step = normal.ldlt().solve(columns.transpose() * right);
    move_pose(step.head<3>(), step.tail<3>());
  }
  rigid_pose_ = pose_;
  find_farthest();
}

// The middle of the twentieth of the cloud that lies farthest off, on the organ at rest.
void ElasticFit::find_farthest() {
  const SeenSurface surface(modes_.surface(), modes_.mesh_point_of(), displaced());
  const Isometry3d back = pose_.inverse();
  std::vector<std::pair<double, Vector3d>> off;
  for (const Vector3d& point : equations_.cloud_mm()) {
    const SeenSurface::Found found = surface.find(back * point);
    off.emplace_back(std::hypot(found.off_mm, found.beside_mm),
                     between(modes_.mesh().points_mm, found.row.points, found.row.weights));
  }
  std::sort(off.begin(), off.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  const std::size_t some = std::max<std::size_t>(1, off.size() / 20);
  farthest_mm_.setZero();
  for (std::size_t i = 0; i < some; ++i) farthest_mm_ += off[i].second / static_cast<double>(some);
  farthest_off_mm_ = off[some - 1].first;
}

void ElasticFit::add_hidden_tool() {
  tool_columns_ = modes_.under_tool_mm_mN(farthest_mm_, hidden_tool_radius_mm);
  asked_tools_.emplace_back("hidden tool");
}

// What is seen is touched by nothing but the tools; forces elsewhere are all alike.
void ElasticFit::choose_forces(Forces forces) {
  const geometry::NearestPoint nearest = seen_in_scan();
  const Isometry3d back = pose_.inverse();
  scaled_modes_ = modes_.displacement_mm();
  const double seen_root = forces == Forces::anywhere ? 1.0 : std::sqrt(options_.touched_by_unseen);
  for (std::size_t k = 0; k < modes_.centers_mm().size(); ++k) {
    const double away_mm = std::sqrt(nearest.nearest(modes_.centers_mm()[k]).squared_distance_mm2);
    if (away_mm < options_.seen_within_mm) scaled_modes_.middleCols<3>(3 * static_cast<Eigen::Index>(k)) *= seen_root;
  }
  asked_tools_.clear();
  tool_columns_.resize(known_mm_.size(), 0);
  if (forces == Forces::hidden_tool) add_hidden_tool();
  for (const SeenTool& tool : frame_.tools) {
    const MatrixXd per_mN = modes_.under_tool_mm_mN(back * tool.contact_mm, tool.radius_mm);
    if (tool.force_mN) {
      known_mm_ += per_mN * (back.linear() * *tool.force_mN);
    } else {
      tool_columns_.conservativeResize(Eigen::NoChange, tool_columns_.cols() + 3);
      tool_columns_.rightCols<3>() = per_mN;
      asked_tools_.push_back(tool.id);
    }
  }
}

void ElasticFit::fit_pose_and_forces(Forces forces) {
  pose_ = forces == Forces::hidden_tool ? guess_ : rigid_pose_;  // a pulled organ misleads the pose alone
  known_mm_ = gravity_mm_;
  u_mm_ = known_mm_;
  if (forces == Forces::hidden_tool) find_farthest();
  choose_forces(forces);
  for (int round = 0; round < options_.elastic_rounds; ++round) {
    const std::vector<SeenRow>& seen = look_again(coarsest_noise_mm);
    const double independent = independent_points();
    const double share = std::min(1.0, independent / static_cast<double>(seen.size()));
    VectorXd right = equations_.residuals(seen, known_mm_);
    const MatrixXd free =
        equations_.free_columns(seen, tool_columns_, guess_.inverse() * pose_, 1.0 / std::sqrt(share), right);
    const double opened = std::min(1.0, (round + 1.0) / rounds_to_full_forces);
    fit_ = fit_by_evidence(SeenEquations::mode_columns(seen, scaled_modes_, free.cols()), free, right, independent,
                           std::pow(options_.largest_rms_mm * opened, 2));
    u_mm_ = known_mm_ + scaled_modes_ * fit_.modes + tool_columns_ * fit_.free.tail(tool_columns_.cols());
    move_pose(fit_.free.head<3>(), fit_.free.segment<3>(3));
    double weights = 0;
    for (const SeenRow& row : seen) weights += std::log(std::sqrt(std::max(row.trust, min_trust)) / row.noise_mm);
    log_evidence_ = fit_.log_evidence + share * weights;
  }
  look_again(coarsest_noise_mm);
}

double ElasticFit::independent_points() const {
  std::set<std::array<long, 3>> boxes;
  for (const Vector3d& point : equations_.cloud_mm()) {
    const Vector3d box = point / options_.independent_spacing_mm;
    boxes.insert({std::lround(box[0]), std::lround(box[1]), std::lround(box[2])});
  }
  return static_cast<double>(boxes.size());
}

// ---- What came of it ----

Eigen::Matrix<double, 3, Eigen::Dynamic> ElasticFit::columns_at(const mechanics::PointInMesh& place) const {
  const Eigen::Index q = scaled_modes_.cols(), tools = tool_columns_.cols();
  Eigen::Matrix<double, 3, Eigen::Dynamic> columns = Eigen::Matrix<double, 3, Eigen::Dynamic>::Zero(3, q + 6 + tools);
  const auto& cell = modes_.mesh().cells[static_cast<std::size_t>(place.cell)];
  Vector3d arm_mm = -modes_.centroid_mm();
  for (int k = 0; k < 4; ++k) {
    columns.leftCols(q) += place.barycentric[k] * scaled_modes_.middleRows<3>(3 * cell[k]);
    columns.rightCols(tools) += place.barycentric[k] * tool_columns_.middleRows<3>(3 * cell[k]);
    arm_mm += place.barycentric[k] *
              (modes_.mesh().points_mm[static_cast<std::size_t>(cell[k])] + u_mm_.segment<3>(3 * cell[k]));
  }
  columns.block<3, 3>(0, q).setIdentity();
  for (int axis = 0; axis < 3; ++axis) columns.block<3, 1>(0, q + 3 + axis) = Vector3d::Unit(axis).cross(arm_mm);
  return columns;
}

// The cloud, brought back to the scan's frame.
geometry::NearestPoint ElasticFit::seen_in_scan() const {
  std::vector<Vector3d> seen_mm;
  const Isometry3d back = pose_.inverse();
  for (const Vector3d& point : equations_.cloud_mm()) seen_mm.push_back(back * point);
  return geometry::NearestPoint(std::move(seen_mm));
}

double ElasticFit::visible_share() const {
  const geometry::NearestPoint nearest = seen_in_scan();
  const std::vector<Vector3d> now_mm = displaced();
  std::size_t visible = 0;
  for (const int p : modes_.mesh_point_of()) {
    const auto found = nearest.nearest(now_mm[static_cast<std::size_t>(p)]);
    if (found.squared_distance_mm2 < 100) ++visible;
  }
  return static_cast<double>(visible) / static_cast<double>(std::max<std::size_t>(1, modes_.mesh_point_of().size()));
}

ElasticPlacement ElasticFit::outcome(const std::vector<mechanics::PointInMesh>& targets) const {
  ElasticPlacement placed;
  placed.pose = pose_;
  const std::vector<Vector3d> now_mm = displaced();
  double square = 0;
  for (const int p : modes_.mesh_point_of()) square += u_mm_.segment<3>(3 * p).squaredNorm();
  placed.elastic_rms_mm = std::sqrt(square / static_cast<double>(modes_.mesh_point_of().size()));
  for (std::size_t p = 0; p < now_mm.size(); ++p) {
    placed.displacement_mm.push_back(now_mm[p] - modes_.mesh().points_mm[p]);
  }
  placed.residual_rms_mm = seen_.rms_mm;
  placed.visible_share = visible_share();
  const MatrixXd covariance = fit_.covariance();
  for (const mechanics::PointInMesh& place : targets) {
    const auto& cell = modes_.mesh().cells[static_cast<std::size_t>(place.cell)];
    placed.target_mm.push_back(pose_ * between(now_mm, cell, place.barycentric));
    const auto columns = columns_at(place);
    const double posterior_mm = std::sqrt((columns * covariance * columns.transpose()).trace() / 3);
    placed.target_sd_mm.push_back(
        std::hypot(posterior_factor * posterior_mm, elastic_share * placed.elastic_rms_mm, smallest_sd_mm));
  }
  for (std::size_t t = 0; t < asked_tools_.size(); ++t) {
    const auto first = 6 + 3 * static_cast<Eigen::Index>(t);
    const Eigen::Index in_covariance = scaled_modes_.cols() + first;
    placed.tools.push_back({asked_tools_[t], pose_.linear() * fit_.free.segment<3>(first),
                            std::sqrt(covariance.block<3, 3>(in_covariance, in_covariance).trace() / 3)});
  }
  if (placed.visible_share < 0.05) {
    placed.why_not = {GLISSON_TEXT("Less than 5 % of the organ is seen: too little to say where the rest is."), {}};
  } else if (seen_.trusted_share < 0.5 || seen_.rms_mm > 3 * seen_.noise_mm) {
    placed.why_not = {
        GLISSON_TEXT("What is seen does not fit this organ: more than half of the points lie far from it."), {}};
  }
  placed.converged = placed.why_not.text.empty();
  return placed;
}

}  // namespace

ElasticPlacement register_elastic(const ForceModes& modes, const SeenFrame& frame, const Isometry3d& from,
                                  const std::vector<mechanics::PointInMesh>& targets, const Vector3d& gravity_mm_s2,
                                  const RegistrationOptions& options) {
  ElasticFit fit(modes, frame, from, gravity_mm_s2, options);
  fit.fit_pose();
  std::vector<ElasticFit::Forces> kinds{ElasticFit::Forces::unseen, ElasticFit::Forces::anywhere};
  if (fit.is_pulled()) kinds.push_back(ElasticFit::Forces::hidden_tool);
  ElasticPlacement best;
  double best_evidence = -std::numeric_limits<double>::infinity();
  for (const ElasticFit::Forces kind : kinds) {
    fit.fit_pose_and_forces(kind);
    if (fit.log_evidence() <= best_evidence) continue;
    best_evidence = fit.log_evidence();
    best = fit.outcome(targets);
  }
  return best;
}

}  // namespace glisson::guidance
