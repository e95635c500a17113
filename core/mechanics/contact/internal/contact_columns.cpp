#include "mechanics/contact/internal/contact_columns.h"

#include <Eigen/SparseCore>

namespace glisson::mechanics {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

// What the graspers pull with.
PointForces given_forces(const std::vector<ContactTool>& tools, const std::vector<Gripped>& grips);
// By the surface moved by moved_mm, for 1 mN of the column's force.
double work(const ContactColumn& column, const VectorXd& moved_mm);
// Of the meetings among themselves: a thousand and more, by products of matrices, the columns being sparse.
Eigen::MatrixXd compliance_of_meetings(const SurfaceResponses& responses, const ContactColumns& columns);
// What the jumps of a live cut give to the gaps, by the loads that the columns put on them.
Eigen::MatrixXd compliance_of_jumps(const SurfaceResponses& responses, const ContactColumns& columns);

}  // namespace

const TouchingTool* pushed(const ContactTool& tool) {
  const auto* touching = std::get_if<TouchingTool>(&tool.what);
  return touching != nullptr && touching->push_mN ? touching : nullptr;
}

Result<ContactColumns> columns_of(const SurfaceResponses& responses, const Touching& touching) {
  ContactColumns columns;
  columns.given_mN = given_forces(touching.tools, touching.grips);
  const auto surface_given_mm = responses.surface_under(columns.given_mN, {});
  if (!surface_given_mm) return failure(surface_given_mm.error());

  for (const ContactCandidate& place : touching.places) {
    ContactColumn column;
    for (int i = 0; i < 3; ++i) {
      if (place.weights[i] > 0) column.on.emplace_back(place.points[i], place.weights[i] * place.normal);
    }
    column.start_mm = place.gap_mm + work(column, *surface_given_mm) - work(column, touching.surface_mm);
    if (const TouchingTool* tool = pushed(touching.tools[place.tool])) {
      column.pushed_by = place.tool;
      column.along = place.normal.dot(tool->pose.forward());
      column.start_mm += column.along * touching.advance_mm[static_cast<Eigen::Index>(place.tool)];
    }
    columns.all.push_back(std::move(column));
  }
  columns.places = touching.places.size();
  for (const CutContact& meeting : touching.meetings) {
    ContactColumn column;
    for (const auto& [point, share] : meeting.shares()) column.on.emplace_back(point, share * meeting.normal);
    column.start_mm = meeting.gap_mm(*surface_given_mm);
    columns.all.push_back(std::move(column));
  }
  columns.meetings = touching.meetings.size();
  const VectorXd jumps_given_mm = responses.jumps_under(columns.given_mN, {});
  for (const int wall : touching.live_walls) {
    ContactColumn column;
    column.wall = wall;
    column.start_mm =
        responses.opening()->normals()[static_cast<std::size_t>(wall)].dot(jumps_given_mm.segment<3>(3 * wall));
    columns.all.push_back(std::move(column));
  }
  for (const Gripped& gripped : touching.grips) {
    const auto* drawn_mm = std::get_if<Vector3d>(&std::get<Grasp>(touching.tools[gripped.tool].what).drawn);
    if (drawn_mm == nullptr) continue;
    for (int axis = 0; axis < 3; ++axis, ++columns.two_sided) {
      ContactColumn column;
      for (std::size_t i = 0; i < gripped.points.size(); ++i) {
        column.on.emplace_back(gripped.points[i], gripped.weights[i] * Vector3d::Unit(axis));
      }
      column.start_mm =
          work(column, *surface_given_mm) - work(column, responses.standing_surface_mm()) - (*drawn_mm)[axis];
      columns.all.push_back(std::move(column));
    }
  }
  return columns;
}

ContactProblem problem_of(const SurfaceResponses& responses, const std::vector<ContactTool>& tools,
                          const ContactColumns& columns) {
  const auto size = static_cast<Eigen::Index>(columns.all.size());
  std::vector<double> drive_force_mN;
  std::vector<Eigen::Index> drive_of_tool(tools.size(), -1);
  for (std::size_t t = 0; t < tools.size(); ++t) {
    const TouchingTool* tool = pushed(tools[t]);
    if (tool == nullptr) continue;
    drive_of_tool[t] = static_cast<Eigen::Index>(drive_force_mN.size());
    drive_force_mN.push_back(*tool->push_mN);
  }
  const auto drives = static_cast<Eigen::Index>(drive_force_mN.size());
  ContactProblem problem{Eigen::MatrixXd(size, size), VectorXd(size), columns.two_sided,
                         Eigen::MatrixXd::Zero(size, drives),
                         Eigen::Map<const VectorXd>(drive_force_mN.data(), drives)};
  const auto first_meeting = static_cast<Eigen::Index>(columns.places);
  const auto meetings = static_cast<Eigen::Index>(columns.meetings);
  const auto is_meeting = [&](Eigen::Index c) { return c >= first_meeting && c < first_meeting + meetings; };
  for (Eigen::Index c = 0; c < size; ++c) {
    const ContactColumn& column = columns.all[static_cast<std::size_t>(c)];
    problem.start[c] = column.start_mm;
    if (column.pushed_by) problem.drives(c, drive_of_tool[*column.pushed_by]) = column.along;
    for (Eigen::Index d = 0; d <= c; ++d) {
      if (is_meeting(c) && is_meeting(d)) continue;
      double sum = 0;
      for (const auto& [at, force] : column.on) {
        for (const auto& [of, other] : columns.all[static_cast<std::size_t>(d)].on) {
          sum += force.dot(responses.compliance(at, of) * other);
        }
      }
      problem.compliance(c, d) = problem.compliance(d, c) = sum;
    }
  }
  if (responses.opening() != nullptr) problem.compliance += compliance_of_jumps(responses, columns);
  if (meetings > 0) {
    problem.compliance.block(first_meeting, first_meeting, meetings, meetings) =
        compliance_of_meetings(responses, columns);
  }
  return problem;
}

namespace {

PointForces given_forces(const std::vector<ContactTool>& tools, const std::vector<Gripped>& grips) {
  PointForces given_mN;
  for (const Gripped& gripped : grips) {
    const auto& grasp = std::get<Grasp>(tools[gripped.tool].what);
    const double* pull_mN = std::get_if<double>(&grasp.drawn);
    if (pull_mN == nullptr) continue;
    for (std::size_t i = 0; i < gripped.points.size(); ++i) {
      given_mN.try_emplace(gripped.points[i], Vector3d::Zero()).first->second +=
          *pull_mN * (gripped.weights[i] * unit_or_zero(grasp.direction));
    }
  }
  return given_mN;
}

double work(const ContactColumn& column, const VectorXd& moved_mm) {
  double sum = 0;
  for (const auto& [point, force] : column.on) sum += force.dot(moved_mm.segment<3>(3 * point));
  return sum;
}

Eigen::MatrixXd compliance_of_meetings(const SurfaceResponses& responses, const ContactColumns& columns) {
  const std::vector<int>& mutual = responses.mutual_points();
  std::map<int, int> number_of;
  for (std::size_t i = 0; i < mutual.size(); ++i) number_of[mutual[i]] = static_cast<int>(i);
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t m = 0; m < columns.meetings; ++m) {
    for (const auto& [point, force] : columns.all[columns.places + m].on) {
      for (int i = 0; i < 3; ++i) entries.emplace_back(3 * number_of[point] + i, static_cast<int>(m), force[i]);
    }
  }
  Eigen::SparseMatrix<double> directions(3 * static_cast<Eigen::Index>(mutual.size()),
                                         static_cast<Eigen::Index>(columns.meetings));
  directions.setFromTriplets(entries.begin(), entries.end());
  const Eigen::MatrixXd moved_mm = responses.mutual_compliance() * directions;
  return directions.transpose() * moved_mm;
}

Eigen::MatrixXd compliance_of_jumps(const SurfaceResponses& responses, const ContactColumns& columns) {
  const Opening& opening = *responses.opening();
  Eigen::MatrixXd load =
      Eigen::MatrixXd::Zero(opening.standing_load().size(), static_cast<Eigen::Index>(columns.all.size()));
  for (std::size_t c = 0; c < columns.all.size(); ++c) {
    const ContactColumn& column = columns.all[c];
    auto of_column = load.col(static_cast<Eigen::Index>(c));
    for (const auto& [point, force] : column.on) of_column += opening.load_of_force(3 * point, force);
    if (column.wall < 0) continue;
    of_column += opening.load_of_push(column.wall, opening.normals()[static_cast<std::size_t>(column.wall)]);
  }
  return load.transpose() * opening.amplitudes_mm(load);
}

}  // namespace
}  // namespace glisson::mechanics
