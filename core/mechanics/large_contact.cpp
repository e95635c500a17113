#include "mechanics/large_contact.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>

#include "mechanics/newton.h"
#include "mechanics/stopwatch.h"
#include "mechanics/surroundings.h"
#include "mechanics/tool_search.h"

namespace glisson::mechanics {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::VectorXd;

// A penetration that nobody can see: where all forces are smaller than it makes, there is nothing left to solve.
constexpr double hair_mm = 1e-3;

// A kept place with the rod where it is now, and the force that it is known to bear.
struct Bearing {
  KeptPlace place;
  Rod rod;
  std::array<int, 3> nodes;
  Vector3d rest_mm;
  double force_mN = 0;
};

// How far a place is from its rod, which way that grows, and how that turns.
struct Gap {
  double mm;
  Vector3d normal;
  Matrix3d bend;
};
Gap gap_of(const Bearing& bearing, const VectorXd& u_mm);

// The body under its loads with the bearings' springs.
class BearingBody : public Landscape {
 public:
  BearingBody(const Body& body, const std::vector<Material>& materials, const AppliedLoads& loads,
              const std::vector<Bearing>& bearings, double stiffness_mN_mm)
      : body_(body), materials_(materials), loads_(loads), bearings_(bearings), k_(stiffness_mN_mm) {}

  [[nodiscard]] double energy_uJ(const VectorXd& u_mm) const override {
    double sum = strain_energy_uJ(body_, materials_, u_mm) + surroundings_energy_uJ(body_, loads_.gas_kPa, u_mm) -
                 loads_.dead_mN.dot(u_mm);
    for (const Bearing& bearing : bearings_) {
      const double force = force_of(bearing, gap_of(bearing, u_mm));
      sum += (force * force - bearing.force_mN * bearing.force_mN) / (2 * k_);
    }
    return sum;
  }
  [[nodiscard]] VectorXd force_mN(const VectorXd& u_mm) const override {
    return loads_.dead_mN + bearing_force_mN(u_mm) + surroundings_force_mN(body_, loads_.gas_kPa, u_mm) -
           internal_force_mN(body_, materials_, u_mm);
  }
  [[nodiscard]] Eigen::SparseMatrix<double> tangent(const VectorXd& u_mm, Tangent which) const override {
    std::vector<Eigen::Triplet<double>> entries;
    for (const Bearing& bearing : bearings_) {
      const Gap gap = gap_of(bearing, u_mm);
      const double force = force_of(bearing, gap);
      if (force == 0) continue;
      Matrix3d block = k_ * gap.normal * gap.normal.transpose();
      if (which == Tangent::exact) block -= force * gap.bend;
      for (int a = 0; a < 3; ++a) {
        for (int b = 0; b < 3; ++b) {
          for (int i = 0; i < 3; ++i) {
            for (int j = 0; j < 3; ++j) {
              const int row = 3 * bearing.nodes[a] + i, column = 3 * bearing.nodes[b] + j;
              if (row < column) continue;
              entries.emplace_back(row, column, bearing.place.weights[a] * bearing.place.weights[b] * block(i, j));
            }
          }
        }
      }
    }
    Eigen::SparseMatrix<double> springs(u_mm.size(), u_mm.size());
    springs.setFromTriplets(entries.begin(), entries.end());
    return tangent_stiffness(body_, materials_, u_mm, which, loads_.gas_kPa) + springs;
  }
  [[nodiscard]] double energy_scale_uJ(const VectorXd& u_mm) const override {
    double scale = std::abs(loads_.dead_mN.dot(u_mm)) + std::abs(loads_.gas_kPa) * geometry::volume_mm3(body_.mesh);
    for (const Bearing& bearing : bearings_) scale += bearing.force_mN * bearing.force_mN / k_;
    return scale;
  }

  [[nodiscard]] double force_of(const Bearing& bearing, const Gap& gap) const {
    return std::max(0.0, bearing.force_mN - k_ * gap.mm);
  }
  [[nodiscard]] VectorXd bearing_force_mN(const VectorXd& u_mm) const {
    VectorXd sum = VectorXd::Zero(u_mm.size());
    for (const Bearing& bearing : bearings_) {
      const Gap gap = gap_of(bearing, u_mm);
      const Vector3d force = force_of(bearing, gap) * gap.normal;
      for (int i = 0; i < 3; ++i) sum.segment<3>(3 * bearing.nodes[i]) += bearing.place.weights[i] * force;
    }
    return sum;
  }
  [[nodiscard]] double scale_mN(const VectorXd& u_mm) const {
    const auto size = [&](const VectorXd& force) { return of_the_free(body_.resolved.held, force).norm(); };
    return size(loads_.dead_mN + surroundings_force_mN(body_, loads_.gas_kPa, VectorXd::Zero(u_mm.size()))) +
           size(bearing_force_mN(u_mm)) + k_ * hair_mm;
  }

 private:
  const Body& body_;
  const std::vector<Material>& materials_;
  const AppliedLoads& loads_;
  const std::vector<Bearing>& bearings_;
  double k_;
};

// A body with the tools' forces on it, moved on from station to station.
class Pressing {
 public:
  Pressing(const Body& body, const std::vector<Material>& materials, const ContactOptions& options, VectorXd u_mm);

  // Brings the body and the pushed tools to rest. False where they do not come to it.
  Result<bool> rest_under(const std::vector<HandTool>& tools, const AppliedLoads& loads, const Progress& progress);

  [[nodiscard]] LargeContact outcome(const std::vector<HandTool>& tools, const AppliedLoads& loads) const;

 private:
  Result<bool> rest_at_advances(const std::vector<HandTool>& tools, const AppliedLoads& loads,
                                const Progress& progress);
  void bear(const std::vector<HandTool>& tools);
  [[nodiscard]] VectorXd surface_mm(const VectorXd& u_mm) const;
  [[nodiscard]] Vector3d force_of_tool(std::size_t tool) const;
  [[nodiscard]] Rod rod_of(const KeptPlace& place, const std::vector<HandTool>& tools) const;

  const Body& body_;
  const std::vector<Material>& materials_;
  ContactOptions options_;
  geometry::Surface surface_;
  std::vector<int> node_of_point_;  // of the surface
  double k_mN_mm_;
  VectorXd u_mm_, advance_mm_;
  std::vector<Bearing> bearings_;
  ContactReport report_;
  double relative_residual_ = 0;
};

Result<void> check_stations(const std::vector<std::vector<HandTool>>& stations);
AppliedLoads with_pulls(AppliedLoads loads, const Body& body, const std::vector<HandTool>& tools,
                        const std::vector<Gripped>& grips);

}  // namespace

Result<LargeContact> find_equilibrium_in_contact(const Body& body, const std::vector<Material>& materials,
                                                 const AppliedLoads& loads,
                                                 const std::vector<std::vector<HandTool>>& stations,
                                                 const ContactOptions& options, const Progress& progress) {
  GLISSON_ASSERT(!stations.empty());
  const Stopwatch watch;
  if (auto checked = check_stations(stations); !checked) return failure(std::move(checked.error()));
  const geometry::Surface surface = geometry::boundary_surface(body.mesh);
  std::vector<Gripped> grips;
  for (std::size_t t = 0; t < stations.front().size(); ++t) {
    const auto* grasp = std::get_if<Grasp>(&stations.front()[t].what);
    if (grasp == nullptr) continue;
    auto gripped = grip(surface, t, *grasp);
    if (!gripped) return failure(std::move(gripped.error()));
    grips.push_back(std::move(*gripped));
  }

  auto standing = find_equilibrium(body, materials, loads, {}, progress.part(0.0, 0.1));
  if (!standing) return failure(std::move(standing.error()));
  if (!standing->may_be_used()) return LargeContact{std::move(*standing), {}, {}};
  Pressing pressing(body, materials, options, nodal_displacements(body, *standing));
  std::size_t station = 0;
  bool rested = true;
  AppliedLoads all = loads;
  for (; station < stations.size() && rested; ++station) {
    progress.report(0.1 + 0.9 * double(station) / double(stations.size()), GLISSON_TEXT("Moving the tools"));
    all = with_pulls(loads, body, stations[station], grips);
    const auto came_to_rest = pressing.rest_under(stations[station], all, progress);
    if (!came_to_rest) return failure(came_to_rest.error());
    rested = *came_to_rest;
  }
  LargeContact contact = pressing.outcome(stations[station - 1], all);
  for (const Gripped& gripped : grips) {
    const auto& grasp = std::get<Grasp>(stations[station - 1][gripped.tool].what);
    contact.tools[gripped.tool].contacts = static_cast<int>(gripped.points.size());
    contact.tools[gripped.tool].force_mN = std::get<double>(grasp.drawn) * grasp.direction.normalized();
  }
  contact.report.converged = rested;
  contact.report.solve_ms = contact.result.step_ms = 1e3 * watch.seconds();
  contact.result.status = rested ? SolveStatus::converged : SolveStatus::not_converged;
  contact.result.why_stopped =
      rested ? fmt::format("The tools rest: the relative residual is {:.1e}, the deepest penetration {:.3f} mm.",
                           contact.result.relative_residual, contact.report.penetration_mm)
             : fmt::format(
                   "At step {} of {} of the tools' way no rest was found: a tool reaches {:.2f} mm into the "
                   "surface (tolerance {:.2f}), which still moves by {:.2f} mm.",
                   station, stations.size(), contact.report.penetration_mm, options.penetration_tolerance_mm,
                   contact.report.movement_mm);
  return contact;
}

namespace {

Gap gap_of(const Bearing& bearing, const VectorXd& u_mm) {
  Vector3d at_mm = bearing.rest_mm;
  for (int i = 0; i < 3; ++i) at_mm += bearing.place.weights[i] * u_mm.segment<3>(3 * bearing.nodes[i]);
  const Vector3d axis = bearing.rod.to_mm - bearing.rod.from_mm;
  const double along = axis.squaredNorm() > 0 ? (at_mm - bearing.rod.from_mm).dot(axis) / axis.squaredNorm() : 0.0;
  const Vector3d arm = at_mm - bearing.rod.from_mm - std::clamp(along, 0.0, 1.0) * axis;
  const double distance_mm = std::max(arm.norm(), 1e-9);
  Gap gap{distance_mm - bearing.rod.radius_mm, arm / distance_mm, Matrix3d::Identity()};
  gap.bend -= gap.normal * gap.normal.transpose();
  if (along > 0 && along < 1) gap.bend -= axis * axis.transpose() / axis.squaredNorm();
  gap.bend /= distance_mm;
  return gap;
}

Pressing::Pressing(const Body& body, const std::vector<Material>& materials, const ContactOptions& options,
                   VectorXd u_mm)
    : body_(body),
      materials_(materials),
      options_(options),
      surface_(geometry::boundary_surface(body.mesh)),
      u_mm_(std::move(u_mm)) {
  for (const double p : geometry::find_field(surface_.point_fields, "mesh_point")->values) {
    node_of_point_.push_back(body.layout.node_of_point[static_cast<std::size_t>(p)]);
  }
  // Some fifty times as stiff as the surface itself is at a point, which answers with about E times an edge: what a
  // round leaves of a penetration is then a fiftieth, and the matrix stays far from singular.
  double mean_kPa = 0;
  for (const double youngs : body.youngs_kPa) mean_kPa += youngs / static_cast<double>(body.youngs_kPa.size());
  const double edge_mm =
      std::sqrt(4 / std::sqrt(3.0) * geometry::area_mm2(surface_) / static_cast<double>(surface_.triangles.size()));
  k_mN_mm_ = 50 * mean_kPa * edge_mm;
}

Result<bool> Pressing::rest_under(const std::vector<HandTool>& tools, const AppliedLoads& loads,
                                  const Progress& progress) {
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

  // The more a tool advances the more it meets: secants, kept between what was too little and too much.
  constexpr int most_attempts = 30;
  for (int attempt = 0; attempt < most_attempts; ++attempt) {
    const auto rested = rest_at_advances(tools, loads, progress);
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
      if (!(next_mm > drive.low_mm && next_mm < drive.high_mm)) next_mm = 0.5 * (drive.low_mm + drive.high_mm);
      advance_mm = next_mm;
    }
    if (as_pushed) return true;
  }
  return false;
}

Result<bool> Pressing::rest_at_advances(const std::vector<HandTool>& tools, const AppliedLoads& loads,
                                        const Progress& progress) {
  for (Bearing& bearing : bearings_) bearing.rod = rod_of(bearing.place, tools);
  constexpr int most_rounds = 40;
  for (int round = 0; round < most_rounds; ++round) {
    bear(tools);
    const BearingBody landscape(body_, materials_, loads, bearings_, k_mN_mm_);
    auto descent = descend(landscape, body_.resolved.held, landscape.scale_mN(u_mm_), u_mm_,
                           {1e-5, 40, body_.options.memory_limit_bytes}, progress);
    if (!descent) return failure(std::move(descent.error()));
    report_.rounds += descent->steps;
    relative_residual_ = descent->relative_residual;
    report_.relative_residual = relative_residual_;
    report_.movement_mm = (surface_mm(descent->u_mm) - surface_mm(u_mm_)).cwiseAbs().maxCoeff();
    u_mm_ = std::move(descent->u_mm);
    if (!descent->converged) return false;
    double all_mN = 0, changed_mN = 0;
    for (Bearing& bearing : bearings_) {
      const double force_mN = landscape.force_of(bearing, gap_of(bearing, u_mm_));
      changed_mN += std::abs(force_mN - bearing.force_mN);
      all_mN += force_mN;
      bearing.force_mN = force_mN;
    }
    report_.penetration_mm = 0;
    for (const NearPlace& place : places_near(surface_, tools, advance_mm_, surface_mm(u_mm_), 0.0)) {
      report_.penetration_mm = std::max(report_.penetration_mm, -place.gap_mm);
    }
    if (report_.penetration_mm <= options_.penetration_tolerance_mm && changed_mN <= 0.02 * all_mN) return true;
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
    Bearing bearing{kept[i], rod_of(kept[i], tools), {}, Vector3d::Zero(), 0.0};
    for (int c = 0; c < 3; ++c) {
      bearing.nodes[c] = node_of_point_[kept[i].points[c]];
      bearing.rest_mm += kept[i].weights[c] * surface_.points_mm[kept[i].points[c]];
    }
    bearings_.push_back(bearing);
  }
}

Rod Pressing::rod_of(const KeptPlace& place, const std::vector<HandTool>& tools) const {
  const auto& tool = std::get<TouchingTool>(tools[place.tool].what);
  Pose pose = tool.pose;
  pose.position_mm += advance_mm_[static_cast<Eigen::Index>(place.tool)] * pose.forward();
  return placed({tool.shape[place.rod]}, pose).front();
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
    if (bearing.place.tool == tool) sum += bearing.force_mN * gap_of(bearing, u_mm_).normal;
  }
  return sum;
}

LargeContact Pressing::outcome(const std::vector<HandTool>& tools, const AppliedLoads& loads) const {
  const BearingBody landscape(body_, materials_, loads, bearings_, k_mN_mm_);
  LargeContact contact{state_of(body_, materials_, u_mm_, loads, landscape.bearing_force_mN(u_mm_)), {}, report_};
  contact.result.relative_residual = relative_residual_;
  contact.result.iterations = report_.rounds;
  contact.report.energy_uJ = contact.result.strain_energy_uJ;
  contact.report.inverted_cells = static_cast<int>(contact.result.inverted_cells);
  for (std::size_t t = 0; t < tools.size(); ++t) {
    ToolContact tool{tools[t].id, force_of_tool(t), 0, advance_mm_[static_cast<Eigen::Index>(t)], 0};
    for (const Bearing& bearing : bearings_) tool.contacts += bearing.place.tool == t && bearing.force_mN > 0;
    contact.tools.push_back(std::move(tool));
  }
  for (const NearPlace& place : places_near(surface_, tools, advance_mm_, surface_mm(u_mm_), 0.0)) {
    contact.tools[place.tool].penetration_mm = std::max(contact.tools[place.tool].penetration_mm, -place.gap_mm);
  }
  return contact;
}

Result<void> check_stations(const std::vector<std::vector<HandTool>>& stations) {
  for (const std::vector<HandTool>& tools : stations) {
    for (const HandTool& tool : tools) {
      if (const auto* touching = std::get_if<TouchingTool>(&tool.what)) {
        if (auto checked = check_tool(touching->shape, touching->pose); !checked) return checked;
      } else if (!std::holds_alternative<double>(std::get<Grasp>(tool.what).drawn)) {
        return failure(Error{"not-available",
                             GLISSON_TEXT("At large deformation a grasper pulls with a force; {0} has a displacement."),
                             {tool.id},
                             GLISSON_TEXT("Give it a pull, or take the material \"linear\"."),
                             {}});
      }
    }
  }
  return {};
}

AppliedLoads with_pulls(AppliedLoads loads, const Body& body, const std::vector<HandTool>& tools,
                        const std::vector<Gripped>& grips) {
  if (grips.empty()) return loads;
  const geometry::Surface surface = geometry::boundary_surface(body.mesh);
  const auto& mesh_point = geometry::find_field(surface.point_fields, "mesh_point")->values;
  for (const Gripped& gripped : grips) {
    const auto& grasp = std::get<Grasp>(tools[gripped.tool].what);
    const Vector3d pull_mN = std::get<double>(grasp.drawn) * grasp.direction.normalized();
    for (std::size_t i = 0; i < gripped.points.size(); ++i) {
      const int node = body.layout.node_of_point[static_cast<std::size_t>(mesh_point[gripped.points[i]])];
      loads.dead_mN.segment<3>(3 * node) += gripped.weights[i] * pull_mN;
    }
  }
  return loads;
}

}  // namespace
}  // namespace glisson::mechanics
