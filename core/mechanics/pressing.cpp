#include "mechanics/pressing.h"

#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>
#include <limits>

namespace glisson::mechanics {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::VectorXd;

// A penetration that nobody can see: where all forces are smaller than it makes, there is nothing left to solve.
constexpr double hair_mm = 1e-3;

// How far a held patch is from where it should be.
Vector3d off_mm(const HeldPatch& patch, const VectorXd& u_mm);

// A body with the springs of the bearings and of what jaws hold.
class BearingBody : public Landscape {
 public:
  BearingBody(const Landscape& alone, const std::vector<Bearing>& bearings, const std::vector<HeldPatch>& patches,
              const std::vector<Meeting>& meetings, double stiffness_mN_mm)
      : alone_(alone), bearings_(bearings), patches_(patches), meetings_(meetings), k_(stiffness_mN_mm) {}

  [[nodiscard]] double energy_uJ(const VectorXd& u_mm) const override {
    double sum = alone_.energy_uJ(u_mm);
    for (const Bearing& bearing : bearings_) {
      const double force = force_of(bearing, gap_of(bearing, u_mm));
      sum += (force * force - bearing.force_mN * bearing.force_mN) / (2 * k_) + drag_of(bearing, k_, u_mm).energy_uJ;
    }
    for (const HeldPatch& patch : patches_) {
      sum += (force_of(patch, u_mm).squaredNorm() - patch.force_mN.squaredNorm()) / (2 * k_);
    }
    for (const Meeting& meeting : meetings_) {
      const double force = force_of(meeting, u_mm);
      sum += (force * force - meeting.force_mN * meeting.force_mN) / (2 * k_);
    }
    return sum;
  }
  [[nodiscard]] VectorXd force_mN(const VectorXd& u_mm) const override {
    return alone_.force_mN(u_mm) + tools_force_mN(u_mm);
  }
  [[nodiscard]] Eigen::SparseMatrix<double> tangent(const VectorXd& u_mm, Tangent which) const override {
    std::vector<Eigen::Triplet<double>> entries;
    const auto add = [&](int a, int b, const Matrix3d& block) {
      for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
          if (3 * a + i >= 3 * b + j) entries.emplace_back(3 * a + i, 3 * b + j, block(i, j));
        }
      }
    };
    for (const Bearing& bearing : bearings_) {
      const Gap gap = gap_of(bearing, u_mm);
      const double force = force_of(bearing, gap);
      if (force == 0 && bearing.most_drag_mN == 0) continue;
      Matrix3d block = drag_of(bearing, k_, u_mm).stiffness;
      if (force > 0) block += k_ * gap.normal * gap.normal.transpose();
      if (force > 0 && which == Tangent::exact) block -= force * gap.bend;
      for (int a = 0; a < 3; ++a) {
        for (int b = 0; b < 3; ++b) {
          add(bearing.nodes[a], bearing.nodes[b], bearing.place.weights[a] * bearing.place.weights[b] * block);
        }
      }
    }
    for (const HeldPatch& patch : patches_) {
      for (std::size_t a = 0; a < patch.nodes.size(); ++a) {
        for (std::size_t b = 0; b < patch.nodes.size(); ++b) {
          add(patch.nodes[a], patch.nodes[b], k_ * patch.weights[a] * patch.weights[b] * Matrix3d::Identity());
        }
      }
    }
    for (const Meeting& meeting : meetings_) {
      if (force_of(meeting, u_mm) == 0) continue;
      const Matrix3d block = k_ * meeting.normal * meeting.normal.transpose();
      for (const auto& [a, a_share] : meeting.shares()) {
        for (const auto& [b, b_share] : meeting.shares()) add(a, b, a_share * b_share * block);
      }
    }
    Eigen::SparseMatrix<double> springs(u_mm.size(), u_mm.size());
    springs.setFromTriplets(entries.begin(), entries.end());
    return alone_.tangent(u_mm, which) + springs;
  }
  [[nodiscard]] double energy_scale_uJ(const VectorXd& u_mm) const override {
    double scale = alone_.energy_scale_uJ(u_mm);
    for (const Bearing& bearing : bearings_) {
      scale += (bearing.force_mN * bearing.force_mN + bearing.drag_mN.squaredNorm()) / k_;
    }
    for (const HeldPatch& patch : patches_) scale += patch.force_mN.squaredNorm() / k_;
    for (const Meeting& meeting : meetings_) scale += meeting.force_mN * meeting.force_mN / k_;
    return scale;
  }

  [[nodiscard]] double force_of(const Bearing& bearing, const Gap& gap) const {
    return std::max(0.0, bearing.force_mN - k_ * gap.mm);
  }
  [[nodiscard]] double force_of(const Meeting& meeting, const VectorXd& u_mm) const {
    return std::max(0.0, meeting.force_mN - k_ * meeting.gap_mm(u_mm));
  }
  [[nodiscard]] Vector3d force_of(const HeldPatch& patch, const VectorXd& u_mm) const {
    return patch.force_mN - k_ * off_mm(patch, u_mm);
  }
  [[nodiscard]] VectorXd tools_force_mN(const VectorXd& u_mm) const {
    VectorXd sum = VectorXd::Zero(u_mm.size());
    for (const Bearing& bearing : bearings_) {
      const Gap gap = gap_of(bearing, u_mm);
      const Vector3d force = force_of(bearing, gap) * gap.normal + drag_of(bearing, k_, u_mm).force_mN;
      for (int i = 0; i < 3; ++i) sum.segment<3>(3 * bearing.nodes[i]) += bearing.place.weights[i] * force;
    }
    for (const HeldPatch& patch : patches_) {
      const Vector3d force = force_of(patch, u_mm);
      for (std::size_t i = 0; i < patch.nodes.size(); ++i) {
        sum.segment<3>(3 * patch.nodes[i]) += patch.weights[i] * force;
      }
    }
    for (const Meeting& meeting : meetings_) {
      const Vector3d force = force_of(meeting, u_mm) * meeting.normal;
      for (const auto& [node, share] : meeting.shares()) sum.segment<3>(3 * node) += share * force;
    }
    return sum;
  }

 private:
  const Landscape& alone_;
  const std::vector<Bearing>& bearings_;
  const std::vector<HeldPatch>& patches_;
  const std::vector<Meeting>& meetings_;
  double k_;
};

}  // namespace

Result<Pressing> Pressing::create(const Body& body, const std::vector<HandTool>& tools, const ContactOptions& options,
                                  VectorXd u_mm, const std::vector<OpenedBody::Wall>& walls) {
  Pressing pressing(body, options, std::move(u_mm));
  if (!walls.empty()) {
    const std::vector<int> on_wall = points_on(walls);
    std::vector<int> wall_points;
    const auto& mesh_points = geometry::find_field(pressing.surface_.point_fields, "mesh_point")->values;
    for (std::size_t p = 0; p < mesh_points.size(); ++p) {
      if (std::binary_search(on_wall.begin(), on_wall.end(), static_cast<int>(mesh_points[p]))) {
        wall_points.push_back(static_cast<int>(p));
      }
    }
    pressing.walls_ = MeetingWalls(pressing.surface_, pressing.node_of_point_, wall_points);
  }
  for (std::size_t t = 0; t < tools.size(); ++t) {
    if (const auto* touching = std::get_if<TouchingTool>(&tools[t].what)) {
      if (auto checked = check_tool(touching->shape, touching->pose); !checked) {
        return failure(std::move(checked.error()));
      }
      continue;
    }
    const auto& grasp = std::get<Grasp>(tools[t].what);
    auto gripped = grip(pressing.surface_, t, grasp);
    if (!gripped) return failure(std::move(gripped.error()));
    if (std::holds_alternative<Vector3d>(grasp.drawn)) {
      HeldPatch patch{t, {}, gripped->weights};
      for (const int point : gripped->points) patch.nodes.push_back(pressing.node_of_point_[point]);
      patch.from_mm = off_mm(patch, pressing.u_mm_);
      pressing.patches_.push_back(std::move(patch));
    }
    pressing.grips_.push_back(std::move(*gripped));
  }
  return pressing;
}

Pressing::Pressing(const Body& body, const ContactOptions& options, VectorXd u_mm)
    : body_(&body), options_(options), surface_(geometry::boundary_surface(body.mesh)), u_mm_(std::move(u_mm)) {
  for (const double p : geometry::find_field(surface_.point_fields, "mesh_point")->values) {
    node_of_point_.push_back(body_->layout.node_of_point[static_cast<std::size_t>(p)]);
  }
  // Some fifty times as stiff as the surface itself is at a point, which answers with about E times an edge: what a
  // round leaves of a penetration is then a fiftieth, and the matrix stays far from singular.
  double mean_kPa = 0;
  for (const double youngs : body_->youngs_kPa) mean_kPa += youngs / static_cast<double>(body_->youngs_kPa.size());
  const double edge_mm =
      std::sqrt(4 / std::sqrt(3.0) * geometry::area_mm2(surface_) / static_cast<double>(surface_.triangles.size()));
  k_mN_mm_ = 50 * mean_kPa * edge_mm;
}

AppliedLoads Pressing::with_pulls(AppliedLoads loads, const std::vector<HandTool>& tools) const {
  for (const Gripped& gripped : grips_) {
    const auto& grasp = std::get<Grasp>(tools[gripped.tool].what);
    const double* pull_mN = std::get_if<double>(&grasp.drawn);
    if (pull_mN == nullptr) continue;
    const Vector3d force_mN = *pull_mN * grasp.direction.normalized();
    for (std::size_t i = 0; i < gripped.points.size(); ++i) {
      loads.dead_mN.segment<3>(3 * node_of_point_[gripped.points[i]]) += gripped.weights[i] * force_mN;
    }
  }
  return loads;
}

Result<bool> Pressing::rest_under(const std::vector<HandTool>& tools, const Ground& ground) {
  struct Drive {
    std::size_t tool;
    double push_mN;
    double low_mm = -std::numeric_limits<double>::infinity(), high_mm = std::numeric_limits<double>::infinity();
    double last_mm = 0, last_mN = -1;  // of the attempt before
  };
  std::vector<Drive> drives;
  if (advance_mm_.size() == 0) {
    advance_mm_ = VectorXd::Zero(static_cast<Eigen::Index>(tools.size()));
    for (std::size_t t = 0; t < tools.size(); ++t) {
      const auto* touching = std::get_if<TouchingTool>(&tools[t].what);
      if (touching == nullptr || !touching->push_mN) continue;
      const auto way_mm = way_to_surface(surface_, *touching, surface_mm(u_mm_));
      if (!way_mm) return failure(way_mm.error());
      advance_mm_[static_cast<Eigen::Index>(t)] = *way_mm;
    }
  }
  for (std::size_t t = 0; t < tools.size(); ++t) {
    const auto* touching = std::get_if<TouchingTool>(&tools[t].what);
    if (touching != nullptr && touching->push_mN) drives.push_back({t, *touching->push_mN});
  }

  for (HeldPatch& patch : patches_) {
    patch.wanted_mm = patch.from_mm + std::get<Vector3d>(std::get<Grasp>(tools[patch.tool].what).drawn);
  }

  // The more a tool advances the more it meets: secants, kept between what was too little and too much.
  constexpr int most_attempts = 30;
  for (int attempt = 0; attempt < most_attempts; ++attempt) {
    const auto rested = rest_at_advances(tools, ground);
    if (!rested || !*rested) return rested;
    bool as_pushed = true;
    for (Drive& drive : drives) {
      double& advance_mm = advance_mm_[static_cast<Eigen::Index>(drive.tool)];
      const Vector3d forward = std::get<TouchingTool>(tools[drive.tool].what).pose.forward();
      const double met_mN = force_of_tool(drive.tool).dot(forward), missing_mN = drive.push_mN - met_mN;
      if (std::abs(missing_mN) <= 2e-3 * drive.push_mN) continue;
      as_pushed = false;
      (missing_mN > 0 ? drive.low_mm : drive.high_mm) = advance_mm;
      double slope = drive.last_mN >= 0 ? (met_mN - drive.last_mN) / (advance_mm - drive.last_mm) : 0.0;
      if (!(slope > 1e-4 * k_mN_mm_)) slope = 0.02 * k_mN_mm_;
      drive.last_mm = advance_mm;
      drive.last_mN = met_mN;
      double next_mm = advance_mm + std::clamp(missing_mN / slope, -1.5, 1.5);
      // With friction the force depends on the way there too: what was too little may then be too much.
      if (drive.high_mm - drive.low_mm < hair_mm) {
        drive.low_mm = -std::numeric_limits<double>::infinity();
        drive.high_mm = std::numeric_limits<double>::infinity();
      }
      if (!(next_mm > drive.low_mm && next_mm < drive.high_mm)) next_mm = 0.5 * (drive.low_mm + drive.high_mm);
      advance_mm = next_mm;
    }
    if (!as_pushed) continue;
    for (Bearing& bearing : bearings_) anchor(bearing, tools);
    return true;
  }
  return false;
}

Result<bool> Pressing::rest_at_advances(const std::vector<HandTool>& tools, const Ground& ground) {
  for (Bearing& bearing : bearings_) {
    bearing.rod = rod_of(bearing.place, tools);
    const Pose pose = pose_of(bearing.place.tool, tools);
    bearing.from_mm = pose.rotation * bearing.from_on_tool_mm + pose.position_mm;
  }
  constexpr int most_rounds = 40, rounds_that_wander = 6;
  for (int round = 0; round < most_rounds; ++round) {
    bear(tools);
    for (Bearing& bearing : bearings_) limit_drag(bearing, u_mm_);
    walls_.find(u_mm_, round == 0                   ? MeetingWalls::Search::anew
                       : round < rounds_that_wander ? MeetingWalls::Search::again
                                                    : MeetingWalls::Search::more);
    const BearingBody landscape(ground.alone, bearings_, patches_, walls_.meetings(), k_mN_mm_);
    const double scale_mN = ground.scale_mN +
                            of_the_free(body_->resolved.held, landscape.tools_force_mN(u_mm_)).norm() +
                            k_mN_mm_ * hair_mm;
    auto descent = ground.settle(landscape, scale_mN, u_mm_);
    if (!descent) return failure(std::move(descent.error()));
    report_.rounds += descent->steps;
    report_.relative_residual = descent->relative_residual;
    report_.movement_mm = (surface_mm(descent->u_mm) - surface_mm(u_mm_)).cwiseAbs().maxCoeff();
    u_mm_ = std::move(descent->u_mm);
    if (!descent->converged) return false;
    double all_mN = 0, changed_mN = 0, farthest_off_mm = 0;
    for (Bearing& bearing : bearings_) {
      const double force_mN = landscape.force_of(bearing, gap_of(bearing, u_mm_));
      changed_mN += std::abs(force_mN - bearing.force_mN);
      all_mN += force_mN;
      bearing.force_mN = force_mN;
      const Drag drag = drag_of(bearing, k_mN_mm_, u_mm_);
      changed_mN += (drag.force_mN - bearing.drag_mN).norm();
      bearing.drag_mN = drag.force_mN;
      bearing.slips = drag.slips;
      if (force_mN == 0) anchor(bearing, tools);  // it has lost the tool, or not met it yet
    }
    for (HeldPatch& patch : patches_) {
      const Vector3d force_mN = landscape.force_of(patch, u_mm_);
      changed_mN += (force_mN - patch.force_mN).norm();
      all_mN += force_mN.norm();
      patch.force_mN = force_mN;
      farthest_off_mm = std::max(farthest_off_mm, off_mm(patch, u_mm_).norm());
    }
    for (Meeting& meeting : walls_.meetings()) {
      const double force_mN = landscape.force_of(meeting, u_mm_);
      changed_mN += std::abs(force_mN - meeting.force_mN);
      all_mN += force_mN;
      meeting.force_mN = force_mN;
    }
    report_.overlap_mm = report_.penetration_mm = walls_.find(u_mm_, MeetingWalls::Search::more);
    for (const NearPlace& place : places_near(surface_, tools, advance_mm_, surface_mm(u_mm_), 0.0)) {
      report_.penetration_mm = std::max(report_.penetration_mm, -place.gap_mm);
    }
    if (report_.penetration_mm <= options_.penetration_tolerance_mm &&
        farthest_off_mm <= options_.movement_tolerance_mm && changed_mN <= 0.02 * all_mN) {
      return true;
    }
  }
  return false;
}

// Places that come near are borne by a spring from now on, without a force yet.
void Pressing::bear(const std::vector<HandTool>& tools) {
  constexpr double margin_mm = 1.0;
  std::vector<KeptPlace> kept;
  for (const Bearing& bearing : bearings_) kept.push_back(bearing.place);
  for (const NearPlace& near : places_near(surface_, tools, advance_mm_, surface_mm(u_mm_), margin_mm)) {
    keep({near.tool, near.rod, near.points, near.weights}, surface_, kept);
  }
  for (std::size_t i = bearings_.size(); i < kept.size(); ++i) {
    Bearing bearing{kept[i], rod_of(kept[i], tools), {}, Vector3d::Zero()};
    bearing.friction = std::get<TouchingTool>(tools[kept[i].tool].what).friction;
    for (int c = 0; c < 3; ++c) {
      bearing.nodes[c] = node_of_point_[kept[i].points[c]];
      bearing.rest_mm += kept[i].weights[c] * surface_.points_mm[kept[i].points[c]];
    }
    anchor(bearing, tools);
    bearings_.push_back(bearing);
  }
}

// From now on the place slides from where it is.
void Pressing::anchor(Bearing& bearing, const std::vector<HandTool>& tools) const {
  const Pose pose = pose_of(bearing.place.tool, tools);
  bearing.from_mm = place_of(bearing, u_mm_);
  bearing.from_on_tool_mm = pose.rotation.transpose() * (bearing.from_mm - pose.position_mm);
}

Pose Pressing::pose_of(std::size_t tool, const std::vector<HandTool>& tools) const {
  Pose pose = std::get<TouchingTool>(tools[tool].what).pose;
  pose.position_mm += advance_mm_[static_cast<Eigen::Index>(tool)] * pose.forward();
  return pose;
}

Rod Pressing::rod_of(const KeptPlace& place, const std::vector<HandTool>& tools) const {
  const auto& tool = std::get<TouchingTool>(tools[place.tool].what);
  return placed({tool.shape[place.rod]}, pose_of(place.tool, tools)).front();
}

VectorXd Pressing::surface_mm(const VectorXd& u_mm) const {
  VectorXd moved(3 * static_cast<Eigen::Index>(node_of_point_.size()));
  for (std::size_t p = 0; p < node_of_point_.size(); ++p) {
    moved.segment<3>(3 * static_cast<Eigen::Index>(p)) = u_mm.segment<3>(3 * node_of_point_[p]);
  }
  return moved;
}

Vector3d Pressing::force_of_tool(std::size_t tool) const {
  Vector3d sum = Vector3d::Zero();
  for (const Bearing& bearing : bearings_) {
    if (bearing.place.tool == tool) sum += bearing.force_mN * gap_of(bearing, u_mm_).normal + bearing.drag_mN;
  }
  for (const HeldPatch& patch : patches_) {
    if (patch.tool == tool) sum += patch.force_mN;
  }
  return sum;
}

VectorXd Pressing::force_mN() const {
  VectorXd sum = VectorXd::Zero(u_mm_.size());
  for (const Bearing& bearing : bearings_) {
    const Vector3d force = bearing.force_mN * gap_of(bearing, u_mm_).normal + bearing.drag_mN;
    for (int i = 0; i < 3; ++i) sum.segment<3>(3 * bearing.nodes[i]) += bearing.place.weights[i] * force;
  }
  for (const HeldPatch& patch : patches_) {
    for (std::size_t i = 0; i < patch.nodes.size(); ++i) {
      sum.segment<3>(3 * patch.nodes[i]) += patch.weights[i] * patch.force_mN;
    }
  }
  for (const Meeting& meeting : walls_.meetings()) {
    const Vector3d force = meeting.force_mN * meeting.normal;
    for (const auto& [node, share] : meeting.shares()) sum.segment<3>(3 * node) += share * force;
  }
  return sum;
}

std::vector<ToolContact> Pressing::contacts(const std::vector<HandTool>& tools) const {
  std::vector<ToolContact> contacts;
  for (std::size_t t = 0; t < tools.size(); ++t) {
    ToolContact tool{tools[t].id, force_of_tool(t), 0, advance_mm_[static_cast<Eigen::Index>(t)], 0};
    for (const Bearing& bearing : bearings_) {
      if (bearing.place.tool != t || bearing.force_mN == 0) continue;
      ++tool.contacts;
      if (bearing.friction > 0) ++(bearing.slips ? tool.slipping : tool.sticking);
    }
    contacts.push_back(std::move(tool));
  }
  for (const Gripped& gripped : grips_) {
    const auto& grasp = std::get<Grasp>(tools[gripped.tool].what);
    contacts[gripped.tool].contacts = static_cast<int>(gripped.points.size());
    if (const double* pull_mN = std::get_if<double>(&grasp.drawn)) {
      contacts[gripped.tool].force_mN = *pull_mN * grasp.direction.normalized();
    }
  }
  for (const NearPlace& place : places_near(surface_, tools, advance_mm_, surface_mm(u_mm_), 0.0)) {
    contacts[place.tool].penetration_mm = std::max(contacts[place.tool].penetration_mm, -place.gap_mm);
  }
  return contacts;
}

namespace {

Vector3d off_mm(const HeldPatch& patch, const VectorXd& u_mm) {
  Vector3d mean_mm = Vector3d::Zero();
  for (std::size_t i = 0; i < patch.nodes.size(); ++i) {
    mean_mm += patch.weights[i] * u_mm.segment<3>(3 * patch.nodes[i]);
  }
  return mean_mm - patch.wanted_mm;
}

}  // namespace
}  // namespace glisson::mechanics
