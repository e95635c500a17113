#include "mechanics/contact/internal/augmented_lagrangian.h"

#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>
#include <limits>

#include "mechanics/contact/internal/cut_contact_potential.h"
#include "mechanics/contact/internal/grasp_potential.h"
#include "mechanics/contact/internal/tool_contact_potential.h"

namespace glisson::mechanics {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double deepest_between_mm = 0.2;  // the points that tools press on, those of a live body

}  // namespace

Result<AugmentedLagrangian> AugmentedLagrangian::create(const Body& body, const std::vector<ContactTool>& tools,
                                                        const ContactOptions& options, VectorXd u_mm,
                                                        const std::vector<OpenedBody::Wall>& walls) {
  AugmentedLagrangian lagrangian(body, options, std::move(u_mm));
  if (!walls.empty()) {
    const std::vector<int> on_wall = points_on(walls);
    std::vector<int> wall_points;
    const auto& mesh_points = geometry::find_field(lagrangian.surface_.point_fields, "mesh_point")->values;
    for (std::size_t p = 0; p < mesh_points.size(); ++p) {
      if (std::binary_search(on_wall.begin(), on_wall.end(), static_cast<int>(mesh_points[p]))) {
        wall_points.push_back(static_cast<int>(p));
      }
    }
    lagrangian.walls_ = CutSelfContact(lagrangian.surface_, lagrangian.node_of_point_, wall_points);
  }
  if (auto checked = check_no_patch(tools); !checked) return failure(std::move(checked.error()));
  for (std::size_t t = 0; t < tools.size(); ++t) {
    if (const auto* touching = std::get_if<TouchingTool>(&tools[t].what)) {
      if (auto checked = check_tool(touching->shape, touching->pose); !checked) {
        return failure(std::move(checked.error()));
      }
      continue;
    }
    const auto& grasp = std::get<Grasp>(tools[t].what);
    auto gripped = grip(lagrangian.surface_, t, grasp);
    if (!gripped) return failure(std::move(gripped.error()));
    if (std::holds_alternative<Vector3d>(grasp.drawn)) {
      PrescribedPatch patch{t, {}, gripped->weights};
      for (const int point : gripped->points) patch.nodes.push_back(lagrangian.node_of_point_[point]);
      patch.from_mm = patch.off_mm(lagrangian.u_mm_);
      lagrangian.patches_.push_back(std::move(patch));
    }
    lagrangian.grips_.push_back(std::move(*gripped));
  }
  return lagrangian;
}

AugmentedLagrangian::AugmentedLagrangian(const Body& body, const ContactOptions& options, VectorXd u_mm)
    : body_(&body), options_(options), surface_(geometry::boundary_surface(body.mesh)), u_mm_(std::move(u_mm)) {
  for (const double p : geometry::find_field(surface_.point_fields, "mesh_point")->values) {
    node_of_point_.push_back(body_->layout.node_of_point[static_cast<std::size_t>(p)]);
  }
  // What a round leaves of a penetration is then a fiftieth, and the matrix stays far from singular.
  k_mN_mm_ = penalty_stiffness_mN_mm(50, body, surface_);
  k_kPa_mm_ = penalty_stiffness_kPa_mm(50, body, surface_);
}

AppliedLoads AugmentedLagrangian::with_pulls(AppliedLoads loads, const std::vector<ContactTool>& tools) const {
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

Result<bool> AugmentedLagrangian::equilibrate(const std::vector<ContactTool>& tools, const BodyProblem& problem) {
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

  for (PrescribedPatch& patch : patches_) {
    patch.wanted_mm = patch.from_mm + std::get<Vector3d>(std::get<Grasp>(tools[patch.tool].what).drawn);
  }

  // The more a tool advances the more it meets: secants, kept between what was too little and too much.
  constexpr int maximum_attempts = 30;
  for (int attempt = 0; attempt < maximum_attempts; ++attempt) {
    const auto rested = equilibrate_at_advances(tools, problem);
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
    for (ContactConstraint& constraint : constraints_) anchor(constraint, pose_of(constraint.tool, tools), u_mm_);
    return true;
  }
  return false;
}

Result<bool> AugmentedLagrangian::equilibrate_at_advances(const std::vector<ContactTool>& tools,
                                                          const BodyProblem& problem) {
  for (ContactConstraint& constraint : constraints_) {
    constraint.rod = rod_of(constraint, tools);
    const Pose pose = pose_of(constraint.tool, tools);
    constraint.from_mm = pose.rotation * constraint.from_on_tool_mm + pose.position_mm;
  }
  constexpr int maximum_rounds = 40, rounds_that_wander = 6;
  for (int round = 0; round < maximum_rounds; ++round) {
    update_multipliers(tools);
    for (ContactConstraint& constraint : constraints_) limit_friction(constraint, constraint.multiplier_mN, u_mm_);
    walls_.find(u_mm_, round == 0                   ? CutSelfContact::Search::anew
                       : round < rounds_that_wander ? CutSelfContact::Search::again
                                                    : CutSelfContact::Search::more);
    const Potentials contact = {std::make_shared<ToolContactPotential>(constraints_),
                                std::make_shared<GraspPotential>(patches_, k_mN_mm_),
                                std::make_shared<CutContactPotential>(walls_.cut_contacts(), k_mN_mm_)};
    const double scale_mN = problem.scale_mN +
                            free_values(body_->resolved.fixed, mechanics::force_mN(contact, u_mm_)).norm() +
                            k_mN_mm_ * hair_mm;
    const VectorXd before_mN = force_mN();
    auto found = problem.unknowns.minimum_of(problem.alone.with(contact), scale_mN, problem.minimum.x_mm,
                                             problem.options, problem.progress);
    if (!found) return failure(std::move(found.error()));
    report_.rounds += found->steps;
    report_.relative_residual = problem.minimum.relative_residual = found->relative_residual;
    problem.minimum.newton_steps += found->steps;
    problem.minimum.x_mm = std::move(found->u_mm);
    const VectorXd moved_mm = problem.unknowns.displacement_mm(problem.minimum.x_mm);
    report_.movement_mm = (surface_mm(moved_mm) - surface_mm(u_mm_)).cwiseAbs().maxCoeff();
    u_mm_ = moved_mm;
    if (!found->converged) return false;
    double all_mN = 0, farthest_off_mm = 0;
    for (ContactConstraint& constraint : constraints_) {
      const double force_mN = normal_force_mN(constraint, gap_of(constraint, u_mm_));
      all_mN += force_mN;
      constraint.multiplier_mN = force_mN;
      const FrictionForce friction = friction_force_of(constraint, u_mm_);
      constraint.friction_mN = friction.force_mN;
      constraint.slips = friction.slips;
      if (force_mN == 0)
        anchor(constraint, pose_of(constraint.tool, tools), u_mm_);  // it has lost the tool, or not met it yet
    }
    for (PrescribedPatch& patch : patches_) {
      const Vector3d force_mN = patch.pull_mN(k_mN_mm_, u_mm_);
      all_mN += force_mN.norm();
      patch.multiplier_mN = force_mN;
      farthest_off_mm = std::max(farthest_off_mm, patch.off_mm(u_mm_).norm());
    }
    for (CutContact& cut_contact : walls_.cut_contacts()) {
      const double force_mN = normal_force_mN(cut_contact, k_mN_mm_, u_mm_);
      all_mN += force_mN;
      cut_contact.multiplier_mN = force_mN;
    }
    // On the nodes: points that are more than the values they see share a force in many ways, and go on to.
    const double changed_mN = (force_mN() - before_mN).reshaped(3, before_mN.size() / 3).colwise().norm().sum();
    report_.overlap_mm = report_.penetration_mm = walls_.find(u_mm_, CutSelfContact::Search::more);
    for (const NearPoint& place : points_near(*body_, tools, advance_mm_, u_mm_, 0.0, deepest_between_mm)) {
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
void AugmentedLagrangian::update_multipliers(const std::vector<ContactTool>& tools) {
  constexpr double margin_mm = 1.0;
  for (const NearPoint& near : points_near(*body_, tools, advance_mm_, u_mm_, margin_mm, deepest_between_mm)) {
    const bool known = std::any_of(constraints_.begin(), constraints_.end(), [&](const ContactConstraint& other) {
      return other.tool == near.tool && other.which_rod == near.rod && other.at == near.at;
    });
    if (known) continue;
    ContactConstraint constraint = constraint_at(*body_, near.tool, near.rod, near.at, k_kPa_mm_, k_kPa_mm_);
    constraint.rod = rod_of(constraint, tools);
    constraint.friction = std::get<TouchingTool>(tools[near.tool].what).friction;
    anchor(constraint, pose_of(constraint.tool, tools), u_mm_);
    constraints_.push_back(constraint);
  }
}

Pose AugmentedLagrangian::pose_of(std::size_t tool, const std::vector<ContactTool>& tools) const {
  return std::get<TouchingTool>(tools[tool].what).pose.advanced(advance_mm_[static_cast<Eigen::Index>(tool)]);
}

Rod AugmentedLagrangian::rod_of(const ContactConstraint& place, const std::vector<ContactTool>& tools) const {
  const auto& tool = std::get<TouchingTool>(tools[place.tool].what);
  return placed({tool.shape[place.which_rod]}, pose_of(place.tool, tools)).front();
}

VectorXd AugmentedLagrangian::surface_mm(const VectorXd& u_mm) const {
  VectorXd moved(3 * static_cast<Eigen::Index>(node_of_point_.size()));
  for (std::size_t p = 0; p < node_of_point_.size(); ++p) {
    moved.segment<3>(3 * static_cast<Eigen::Index>(p)) = u_mm.segment<3>(3 * node_of_point_[p]);
  }
  return moved;
}

Vector3d AugmentedLagrangian::force_of_tool(std::size_t tool) const {
  Vector3d sum = Vector3d::Zero();
  for (const ContactConstraint& constraint : constraints_) {
    if (constraint.tool == tool)
      sum += constraint.multiplier_mN * gap_of(constraint, u_mm_).normal + constraint.friction_mN;
  }
  for (const PrescribedPatch& patch : patches_) {
    if (patch.tool == tool) sum += patch.multiplier_mN;
  }
  return sum;
}

VectorXd AugmentedLagrangian::force_mN() const {
  VectorXd sum = VectorXd::Zero(u_mm_.size());
  for (const ContactConstraint& constraint : constraints_) {
    const Vector3d force = constraint.multiplier_mN * gap_of(constraint, u_mm_).normal + constraint.friction_mN;
    for (int i = 0; i < 6; ++i) sum.segment<3>(3 * constraint.nodes[i]) += constraint.weights[i] * force;
  }
  for (const PrescribedPatch& patch : patches_) {
    for (std::size_t i = 0; i < patch.nodes.size(); ++i) {
      sum.segment<3>(3 * patch.nodes[i]) += patch.weights[i] * patch.multiplier_mN;
    }
  }
  for (const CutContact& cut_contact : walls_.cut_contacts()) {
    const Vector3d force = cut_contact.multiplier_mN * cut_contact.normal;
    for (const auto& [node, share] : cut_contact.shares()) sum.segment<3>(3 * node) += share * force;
  }
  return sum;
}

std::vector<ToolContact> AugmentedLagrangian::contacts(const std::vector<ContactTool>& tools) const {
  std::vector<ToolContact> contacts;
  for (std::size_t t = 0; t < tools.size(); ++t) {
    ToolContact tool{tools[t].id, force_of_tool(t), 0, advance_mm_[static_cast<Eigen::Index>(t)], 0};
    for (const ContactConstraint& constraint : constraints_) {
      if (constraint.tool != t || constraint.multiplier_mN == 0) continue;
      ++tool.contacts;
      if (constraint.friction > 0) ++(constraint.slips ? tool.slipping : tool.sticking);
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
  for (const NearPoint& place : points_near(*body_, tools, advance_mm_, u_mm_, 0.0, deepest_between_mm)) {
    contacts[place.tool].penetration_mm = std::max(contacts[place.tool].penetration_mm, -place.gap_mm);
  }
  return contacts;
}

}  // namespace glisson::mechanics
