#include "guidance/elastic_registration.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <random>
#include <set>

#include "base/units.h"
#include "geometry/nearest.h"
#include "guidance/internal/evidence_fit.h"
#include "guidance/internal/seen_surface.h"

namespace glisson::guidance {

using Eigen::Isometry3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

namespace {

constexpr double curve_error_mm = 2.0;     // of a ridge or a ligament that was marked, at least
constexpr double beside_mm = 8.0;          // of the surface's rim: farther points belong to something else
constexpr double coarsest_noise_mm = 2.0;  // that elastic rounds take the cloud for
constexpr double tool_sd_mN = 10e3;        // of a force that is asked for
constexpr int rounds_to_full_forces = 12;
constexpr double pulled_mm = 6.0;  // that some of the cloud lies off the rigid organ where a tool may be at work
constexpr double hidden_tool_radius_mm = 8.0;
constexpr double min_trust = 0.02;  // of a point, where evidences are compared
// Of the standard deviation, from tests on bodies that were not judged (docs/guidance.md): the posterior's, times; the
// part of the elastic displacement that the model gets wrong; and what is left of a rigid organ.
constexpr double posterior_factor = 1.5;
constexpr double elastic_share = 0.3;
constexpr double smallest_sd_mm = 0.25;

using RowMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

std::vector<Vector3d> thinned(std::vector<Vector3d> points, std::size_t maximum) {
  std::mt19937 random(0);
  std::shuffle(points.begin(), points.end(), random);
  if (points.size() > maximum) points.resize(maximum);
  return points;
}

// Between points of the mesh, wherever they are.
Vector3d between(const std::vector<Vector3d>& points_mm, const std::array<int, 4>& points,
                 const Eigen::Vector4d& weights) {
  Vector3d place = Vector3d::Zero();
  for (int k = 0; k < 4; ++k) place += weights[k] * points_mm[static_cast<std::size_t>(points[k])];
  return place;
}

// Places of a curve at rest in the mesh, and what of it was seen.
struct PlacedCurve {
  std::vector<mechanics::PointInMesh> at_rest;
  const SeenCurve* seen;
};

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
  [[nodiscard]] std::vector<SeenRow> rows(double coarsest_mm);
  void add_cloud_rows(const std::vector<Vector3d>& now_mm, double coarsest_mm, std::vector<SeenRow>& rows);
  void add_curve_rows(const std::vector<Vector3d>& now_mm, std::vector<SeenRow>& rows) const;
  [[nodiscard]] VectorXd residuals(const std::vector<SeenRow>& rows, const VectorXd& known_mm) const;
  [[nodiscard]] MatrixXd free_columns(const std::vector<SeenRow>& rows, double prior_scale, VectorXd& right) const;
  [[nodiscard]] MatrixXd mode_columns(const std::vector<SeenRow>& rows) const;
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
  Isometry3d guess_, pose_;
  std::vector<Vector3d> cloud_mm_;  // in the camera's frame
  std::vector<PlacedCurve> curves_;
  Isometry3d rigid_pose_;          // before any forces
  Vector3d farthest_mm_{0, 0, 0};  // where the cloud lies farthest off the rigid organ, and how far
  double farthest_off_mm_ = 0;
  double log_evidence_ = 0;
  VectorXd gravity_mm_;
  VectorXd known_mm_;  // displacement under known loads, 3 a point
  VectorXd u_mm_;
  RowMatrix scaled_modes_;  // times the root of each force's own variance
  MatrixXd tool_columns_;   // mm per mN of unknown tool forces, 3 a tool
  std::vector<std::string> asked_tools_;
  EvidenceFit fit_;
  double noise_mm_ = 1;
  double trusted_share_ = 0;
  double rms_mm_ = 0;
};

ElasticFit::ElasticFit(const ForceModes& modes, const SeenFrame& frame, const Isometry3d& from,
                       const Vector3d& gravity_mm_s2, const RegistrationOptions& options)
    : modes_(modes),
      frame_(frame),
      options_(options),
      guess_(from),
      pose_(from),
      cloud_mm_(thinned(frame.points_mm, options.maximum_points)) {
  for (const SeenCurve& curve : frame.curves) {
    curves_.push_back({mechanics::locate_points(modes.mesh(), curve.at_rest_mm), &curve});
  }
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

// ---- What is seen, as equations ----

std::vector<SeenRow> ElasticFit::rows(double coarsest_mm) {
  const std::vector<Vector3d> now_mm = displaced();
  std::vector<SeenRow> rows;
  add_cloud_rows(now_mm, coarsest_mm, rows);
  add_curve_rows(now_mm, rows);
  return rows;
}

void ElasticFit::add_cloud_rows(const std::vector<Vector3d>& now_mm, double coarsest_mm, std::vector<SeenRow>& rows) {
  const SeenSurface surface(modes_.surface(), modes_.mesh_point_of(), now_mm);
  const Isometry3d back = pose_.inverse();
  std::vector<SeenSurface::Found> found;
  std::vector<double> off_mm;
  for (const Vector3d& point : cloud_mm_) {
    found.push_back(surface.find(back * point));
    off_mm.push_back(std::abs(found.back().off_mm));
  }
  const double stated_mm = std::hypot(frame_.noise_mm, options_.surface_error_mm);
  noise_mm_ = std::max(stated_mm, std::min(1.4826 * median(off_mm), coarsest_mm));
  double square = 0;
  std::size_t trusted = 0;
  for (SeenSurface::Found& each : found) {
    const bool beside = each.beside_mm > std::max(beside_mm, 2 * noise_mm_);
    each.row.noise_mm = noise_mm_;
    each.row.trust = beside ? 0.0 : robust_weight(each.off_mm, noise_mm_);
    if (!beside && std::abs(each.off_mm) < 3 * noise_mm_) {
      square += each.off_mm * each.off_mm;
      ++trusted;
    }
    rows.push_back(each.row);
  }
  trusted_share_ = static_cast<double>(trusted) / static_cast<double>(std::max<std::size_t>(1, found.size()));
  rms_mm_ = std::sqrt(square / static_cast<double>(std::max<std::size_t>(1, trusted)));
}

// A point of a curve says where the curve runs, not where along it: two rows across its tangent.
void ElasticFit::add_curve_rows(const std::vector<Vector3d>& now_mm, std::vector<SeenRow>& rows) const {
  const Isometry3d back = pose_.inverse();
  for (const PlacedCurve& curve : curves_) {
    std::vector<Vector3d> line_mm;
    for (const mechanics::PointInMesh& place : curve.at_rest) {
      const auto& cell = modes_.mesh().cells[static_cast<std::size_t>(place.cell)];
      line_mm.push_back(between(now_mm, cell, place.barycentric));
    }
    const geometry::NearestPoint nearest(line_mm);
    const double noise_mm = std::max(curve.seen->noise_mm, curve_error_mm);
    for (const Vector3d& seen : curve.seen->seen_mm) {
      const auto on_line = nearest.nearest(back * seen);
      const auto i = static_cast<std::size_t>(on_line.point);
      const Vector3d tangent = (line_mm[std::min(i + 1, line_mm.size() - 1)] - line_mm[i > 0 ? i - 1 : 0]).normalized();
      const Vector3d across = tangent.unitOrthogonal();
      const mechanics::PointInMesh& place = curve.at_rest[i];
      for (const Vector3d& direction : {across, Vector3d(tangent.cross(across))}) {
        rows.push_back({modes_.mesh().cells[static_cast<std::size_t>(place.cell)], place.barycentric, direction,
                        back * seen, noise_mm, robust_weight(std::sqrt(on_line.squared_distance_mm2), noise_mm)});
      }
    }
  }
}

// How far what is seen lies from where it would be under the known displacement alone, divided by the noise.
VectorXd ElasticFit::residuals(const std::vector<SeenRow>& rows, const VectorXd& known_mm) const {
  VectorXd right(static_cast<Eigen::Index>(rows.size()));
  for (std::size_t r = 0; r < rows.size(); ++r) {
    const SeenRow& row = rows[r];
    Vector3d place = Vector3d::Zero();
    for (int k = 0; k < 4; ++k) {
      if (row.weights[k] == 0) continue;
      place += row.weights[k] * (modes_.mesh().points_mm[static_cast<std::size_t>(row.points[k])] +
                                 known_mm.segment<3>(3 * row.points[k]));
    }
    right[static_cast<Eigen::Index>(r)] = row.direction.dot(row.at_mm - place) * std::sqrt(row.trust) / row.noise_mm;
  }
  return right;
}

// Shift and turn of the organ, and the tools' forces, with what is known of them before as rows of their own.
MatrixXd ElasticFit::free_columns(const std::vector<SeenRow>& rows, double prior_scale, VectorXd& right) const {
  const auto seen = static_cast<Eigen::Index>(rows.size());
  const Eigen::Index tools = tool_columns_.cols(), free = 6 + tools;
  MatrixXd columns = MatrixXd::Zero(seen + free, free);
  const Vector3d center = modes_.centroid_mm();
  for (Eigen::Index r = 0; r < seen; ++r) {
    const SeenRow& row = rows[static_cast<std::size_t>(r)];
    const double scale = std::sqrt(row.trust) / row.noise_mm;
    columns.block<1, 3>(r, 0) = scale * row.direction.transpose();
    columns.block<1, 3>(r, 3) = scale * (row.at_mm - center).cross(row.direction).transpose();
    for (int k = 0; k < 4 && tools > 0; ++k) {
      if (row.weights[k] == 0) continue;
      columns.row(r).tail(tools) +=
          scale * row.weights[k] * row.direction.transpose() * tool_columns_.middleRows<3>(3 * row.points[k]);
    }
  }
  const Isometry3d off = guess_.inverse() * pose_;
  const Vector3d shift_mm = off * center - center;
  const Eigen::AngleAxisd turn(off.linear());
  right.conservativeResize(seen + free);
  right.tail(free).setZero();
  const double sd_turn = options_.guess_sd_deg * std::numbers::pi / 180;
  for (int k = 0; k < 3; ++k) {
    columns(seen + k, k) = prior_scale / options_.guess_sd_mm;
    right[seen + k] = -prior_scale * shift_mm[k] / options_.guess_sd_mm;
    columns(seen + 3 + k, 3 + k) = prior_scale / sd_turn;
    right[seen + 3 + k] = -prior_scale * turn.angle() * turn.axis()[k] / sd_turn;
  }
  for (Eigen::Index k = 6; k < free; ++k) columns(seen + k, k) = prior_scale / tool_sd_mN;
  return columns;
}

MatrixXd ElasticFit::mode_columns(const std::vector<SeenRow>& rows) const {
  RowMatrix columns =
      RowMatrix::Zero(static_cast<Eigen::Index>(rows.size()) + 6 + tool_columns_.cols(), scaled_modes_.cols());
  for (std::size_t r = 0; r < rows.size(); ++r) {
    const SeenRow& row = rows[r];
    const double scale = std::sqrt(row.trust) / row.noise_mm;
    if (scale == 0) continue;
    for (int k = 0; k < 4; ++k) {
      if (row.weights[k] == 0) continue;
      for (int axis = 0; axis < 3; ++axis) {
        columns.row(static_cast<Eigen::Index>(r)) +=
            scale * row.weights[k] * row.direction[axis] * scaled_modes_.row(3 * row.points[k] + axis);
      }
    }
  }
  return columns;
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
    const std::vector<SeenRow> seen = rows(coarsest_mm);
    VectorXd right = residuals(seen, u_mm_);
    const MatrixXd columns = free_columns(seen, 1.0, right);
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
  for (const Vector3d& point : cloud_mm_) {
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
    const std::vector<SeenRow> seen = rows(coarsest_noise_mm);
    const double independent = independent_points();
    const double share = std::min(1.0, independent / static_cast<double>(seen.size()));
    VectorXd right = residuals(seen, known_mm_);
    const MatrixXd free = free_columns(seen, 1.0 / std::sqrt(share), right);
    const double opened = std::min(1.0, (round + 1.0) / rounds_to_full_forces);
    fit_ = fit_by_evidence(mode_columns(seen), free, right, independent, std::pow(options_.largest_rms_mm * opened, 2));
    u_mm_ = known_mm_ + scaled_modes_ * fit_.modes + tool_columns_ * fit_.free.tail(tool_columns_.cols());
    move_pose(fit_.free.head<3>(), fit_.free.segment<3>(3));
    double weights = 0;
    for (const SeenRow& row : seen) weights += std::log(std::sqrt(std::max(row.trust, min_trust)) / row.noise_mm);
    log_evidence_ = fit_.log_evidence + share * weights;
  }
  (void)rows(coarsest_noise_mm);  // what is left, where it ended
}

double ElasticFit::independent_points() const {
  std::set<std::array<long, 3>> boxes;
  for (const Vector3d& point : cloud_mm_) {
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
  for (const Vector3d& point : cloud_mm_) seen_mm.push_back(back * point);
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
  placed.residual_rms_mm = rms_mm_;
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
    placed.why_not = GLISSON_TEXT("Less than 5 % of the organ is seen: too little to say where the rest is.");
  } else if (trusted_share_ < 0.5 || rms_mm_ > 3 * noise_mm_) {
    placed.why_not =
        GLISSON_TEXT("What is seen does not fit this organ: more than half of the points lie far from it.");
  }
  placed.converged = placed.why_not.empty();
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
