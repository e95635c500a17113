#include "mechanics/contact.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>
#include <mutex>
#include <numeric>
#include <optional>

#include "mechanics/contact_forces.h"
#include "mechanics/load_vector.h"
#include "mechanics/shape_functions.h"
#include "mechanics/stopwatch.h"
#include "mechanics/tool_search.h"

namespace glisson::mechanics {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::VectorXd;

}  // namespace

struct ContactBody::Parts {
  StaticModel model;
  geometry::Surface surface;
  std::vector<int> mesh_point;  // of each point of the surface
  std::vector<PointInMesh> watched;
  std::vector<int> inner;  // points of the mesh that are not of the surface
  std::vector<Eigen::Index> seen_of_mesh_point;
  VectorXd untouched_seen_mm;
  VectorXd standing_force_mN;  // on all nodes
  ContactState untouched;
  std::vector<std::vector<int>> groups;  // of points of the surface
  std::vector<int> group_of_point;

  // Displacement of all that is seen (the surface, the watched places, the inner points; 3 a point) by a force of 1 mN
  // on one point of the surface along x, y and z.
  using Response = Eigen::Matrix<double, Eigen::Dynamic, 3>;
  mutable std::mutex mutex;
  mutable std::vector<std::optional<Response>> responses;
  mutable double relative_residual = 0;

  explicit Parts(StaticModel given) : model(std::move(given)) {}

  [[nodiscard]] Eigen::Index seen() const {
    return 3 * static_cast<Eigen::Index>(surface.points_mm.size() + watched.size() + inner.size());
  }
  [[nodiscard]] Result<int> remember(const std::vector<int>& points) const;
  [[nodiscard]] const Response& response(int point) const { return *responses[static_cast<std::size_t>(point)]; }
  [[nodiscard]] Matrix3d compliance(int at, int of) const { return response(of).middleRows<3>(3 * at); }
  [[nodiscard]] Response seen_part(const Response& displacement_mm) const;  // of all nodes
  [[nodiscard]] VectorXd seen_under(const std::map<int, Vector3d>& force_mN) const;
  [[nodiscard]] int inverted_cells(const VectorXd& seen_mm) const;
  void make_groups();
};

namespace {

struct Unknowns {
  std::map<int, Vector3d> force_mN;  // on points of the surface
  VectorXd advance_mm;               // one a tool; 0 for one that is held
};

double largest_change(const VectorXd& a, const VectorXd& b, Eigen::Index values) {
  double squared = 0;
  for (Eigen::Index i = 0; i < values; i += 3) squared = std::max(squared, (a - b).segment<3>(i).squaredNorm());
  return std::sqrt(squared);
}

Vector3d unit_or_zero(const Vector3d& v) { return v.norm() > 0 ? v.normalized() : Vector3d::Zero(); }

const TouchingTool* pushed(const HandTool& tool) {
  const auto* touching = std::get_if<TouchingTool>(&tool.what);
  return touching != nullptr && touching->push_mN ? touching : nullptr;
}

}  // namespace

Result<ContactBody> ContactBody::create(StaticModel model, const Loads& standing_loads,
                                        std::vector<PointInMesh> watched) {
  auto parts = std::make_shared<Parts>(std::move(model));
  const StaticModel& body = parts->model;
  const auto standing = body.solve(standing_loads);
  if (!standing) return failure(standing.error());
  if (!standing->may_be_used()) {
    return failure("not-converged", GLISSON_TEXT("The equilibrium was not found. {0}"), {standing->why_stopped});
  }
  const auto boundary = boundary_faces(body.mesh(), body.nodes());
  auto force_mN = load_vector(body.mesh(), body.nodes(), boundary, body.options().density_kg_mm3, standing_loads);
  if (!force_mN) return failure(std::move(force_mN.error()));
  parts->standing_force_mN = std::move(*force_mN);

  parts->surface = geometry::boundary_surface(body.mesh());
  for (const double p : geometry::find_field(parts->surface.point_fields, "mesh_point")->values) {
    parts->mesh_point.push_back(static_cast<int>(p));
  }
  parts->watched = std::move(watched);
  parts->seen_of_mesh_point.assign(body.mesh().points_mm.size(), -1);
  for (std::size_t p = 0; p < parts->mesh_point.size(); ++p) {
    parts->seen_of_mesh_point[parts->mesh_point[p]] = static_cast<Eigen::Index>(p);
  }
  for (std::size_t p = 0; p < parts->seen_of_mesh_point.size(); ++p) {
    if (parts->seen_of_mesh_point[p] >= 0) continue;
    parts->seen_of_mesh_point[p] =
        static_cast<Eigen::Index>(parts->mesh_point.size() + parts->watched.size() + parts->inner.size());
    parts->inner.push_back(static_cast<int>(p));
  }
  parts->responses.resize(parts->mesh_point.size());
  parts->make_groups();

  ContactState& rest = parts->untouched;
  for (const int p : parts->mesh_point) rest.surface_mm.push_back(standing->displacement_mm[p]);
  rest.watched_mm = body.displacement_at(*standing, parts->watched);
  parts->untouched_seen_mm.resize(parts->seen());
  Eigen::Index row = 0;
  const auto add = [&](const Vector3d& u) {
    parts->untouched_seen_mm.segment<3>(row) = u;
    row += 3;
  };
  for (const Vector3d& u : rest.surface_mm) add(u);
  for (const Vector3d& u : rest.watched_mm) add(u);
  for (const int p : parts->inner) add(standing->displacement_mm[p]);
  rest.report.converged = true;
  rest.report.relative_residual = standing->relative_residual;
  return ContactBody(std::move(parts));
}

Result<ContactState> ContactBody::solve(const ContactState& from, const std::vector<HandTool>& tools,
                                        const ContactOptions& options) const {
  const Stopwatch watch;
  const Parts& parts = *parts_;
  const auto surface_values = 3 * static_cast<Eigen::Index>(parts.surface.points_mm.size());
  const auto count = static_cast<Eigen::Index>(tools.size());
  ContactReport report;

  // Beginning: the forces and advances of the state before, for the tools that were there.
  Unknowns now{from.force_mN, VectorXd::Zero(count)};
  std::vector<Gripped> grips;
  std::vector<int> asked;
  for (const auto& [point, force] : now.force_mN) asked.push_back(point);
  for (std::size_t t = 0; t < tools.size(); ++t) {
    if (const auto* grasp = std::get_if<Grasp>(&tools[t].what)) {
      auto gripped = grip(parts.surface, t, *grasp);
      if (!gripped) return failure(std::move(gripped.error()));
      asked.insert(asked.end(), gripped->points.begin(), gripped->points.end());
      grips.push_back(std::move(*gripped));
      continue;
    }
    const auto& touching = std::get<TouchingTool>(tools[t].what);
    if (auto checked = check_tool(touching.shape, touching.pose); !checked) return failure(std::move(checked.error()));
  }
  auto solves = parts.remember(asked);
  if (!solves) return failure(std::move(solves.error()));
  report.new_solves += *solves;
  VectorXd seen_mm = parts.seen_under(now.force_mN);
  for (std::size_t t = 0; t < tools.size(); ++t) {
    const TouchingTool* tool = pushed(tools[t]);
    if (tool == nullptr) continue;
    const auto before = std::find_if(from.tools.begin(), from.tools.end(),
                                     [&](const ToolContact& contact) { return contact.id == tools[t].id; });
    if (before != from.tools.end() && before->contacts > 0) {
      now.advance_mm[static_cast<Eigen::Index>(t)] = before->advance_mm;
      continue;
    }
    const auto way_mm = way_to_surface(parts.surface, *tool, seen_mm);
    if (!way_mm) return failure(way_mm.error());
    now.advance_mm[static_cast<Eigen::Index>(t)] = *way_mm;
  }

  std::vector<NearPlace> places;
  ContactForces forces;
  std::vector<KeptPlace> kept;
  for (const TouchedPlace& touched : from.touched) {
    for (std::size_t t = 0; t < tools.size(); ++t) {
      const auto* tool = std::get_if<TouchingTool>(&tools[t].what);
      if (tools[t].id == touched.tool && tool != nullptr && touched.rod < tool->shape.size()) {
        keep({t, touched.rod, touched.points, touched.weights}, parts.surface, kept);
      }
    }
  }
  // Across a tool's bend the surface may swing to and fro: a round that goes back on the one before goes half as far.
  // Where rounds go on in one direction, it slides, and they go farther again.
  double share = 1.0;
  VectorXd last_way_mm;
  constexpr double margin_mm = 1.0;  // what is farther is found when it comes nearer: no round moves through a tool
  for (report.rounds = 0; report.rounds < options.max_rounds; ++report.rounds) {
    for (const NearPlace& near : places_near(parts.surface, tools, now.advance_mm, seen_mm, margin_mm)) {
      keep({near.tool, near.rod, near.points, near.weights}, parts.surface, kept);
    }
    places = kept_places(parts.surface, kept, tools, now.advance_mm, seen_mm, options.largest_move_mm);
    // A pushed tool that lost the surface goes on to it.
    bool lost = false;
    for (std::size_t t = 0; t < tools.size(); ++t) {
      const TouchingTool* tool = pushed(tools[t]);
      if (tool == nullptr ||
          std::any_of(places.begin(), places.end(), [&](const NearPlace& p) { return p.tool == t; })) {
        continue;
      }
      const auto way_mm = way_to_surface(parts.surface, *tool, seen_mm);
      if (!way_mm) return failure(way_mm.error());
      now.advance_mm[static_cast<Eigen::Index>(t)] = *way_mm;
      lost = true;
    }
    if (lost) continue;
    asked.clear();
    for (const NearPlace& place : places) asked.insert(asked.end(), place.points.begin(), place.points.end());
    solves = parts.remember(asked);
    if (!solves) return failure(std::move(solves.error()));
    report.new_solves += *solves;

    // Every unknown force is a few point forces along directions: a contact's three, a grip's many.
    struct Column {
      std::vector<std::pair<int, Vector3d>> on;  // point and force for 1 mN of the unknown
    };
    std::vector<Column> columns;
    for (const NearPlace& place : places) {
      Column column;
      for (int i = 0; i < 3; ++i) {
        if (place.weights[i] > 0) column.on.emplace_back(place.points[i], place.weights[i] * place.normal);
      }
      columns.push_back(std::move(column));
    }
    std::vector<std::pair<int, Vector3d>> given;  // forces that are known: of graspers that pull
    int two_sided = 0;
    std::vector<double> wanted_mm;
    for (const Gripped& gripped : grips) {
      const auto& grasp = std::get<Grasp>(tools[gripped.tool].what);
      const auto* displacement_mm = std::get_if<Vector3d>(&grasp.drawn);
      for (int axis = 0; axis < 3; ++axis) {
        if (displacement_mm == nullptr && axis > 0) break;
        const Vector3d along =
            displacement_mm != nullptr ? Vector3d(Vector3d::Unit(axis)) : Vector3d(unit_or_zero(grasp.direction));
        Column column;
        for (std::size_t i = 0; i < gripped.points.size(); ++i) {
          column.on.emplace_back(gripped.points[i], gripped.weights[i] * along);
        }
        if (displacement_mm != nullptr) {
          columns.push_back(std::move(column));
          wanted_mm.push_back((*displacement_mm)[axis]);
          ++two_sided;
        } else {
          for (auto& [point, force] : column.on) given.emplace_back(point, std::get<double>(grasp.drawn) * force);
        }
      }
    }

    // Gaps at given forces alone, by the surface as it would then be.
    std::map<int, Vector3d> given_force;
    for (const auto& [point, force] : given) {
      given_force.try_emplace(point, Vector3d::Zero()).first->second += force;
    }
    const VectorXd seen_given_mm = parts.seen_under(given_force);
    const auto size = static_cast<Eigen::Index>(columns.size());
    std::vector<Eigen::Index> drive_of_tool(tools.size(), -1);
    Eigen::Index drives = 0;
    for (std::size_t t = 0; t < tools.size(); ++t) {
      if (pushed(tools[t]) != nullptr) drive_of_tool[t] = drives++;
    }
    ContactProblem problem{Eigen::MatrixXd(size, size), VectorXd(size), two_sided, Eigen::MatrixXd::Zero(size, drives),
                           VectorXd(drives)};
    for (Eigen::Index c = 0; c < size; ++c) {
      const Column& column = columns[static_cast<std::size_t>(c)];
      const auto work = [&](const VectorXd& moved_mm) {
        double sum = 0;
        for (const auto& [point, force] : column.on) sum += force.dot(moved_mm.segment<3>(3 * point));
        return sum;
      };
      if (c < static_cast<Eigen::Index>(places.size())) {
        const NearPlace& place = places[static_cast<std::size_t>(c)];
        problem.start[c] = place.gap_mm + work(seen_given_mm) - work(seen_mm);
        if (const TouchingTool* tool = pushed(tools[place.tool])) {
          problem.drives(c, drive_of_tool[place.tool]) = place.normal.dot(tool->pose.forward());
          problem.start[c] +=
              problem.drives(c, drive_of_tool[place.tool]) * now.advance_mm[static_cast<Eigen::Index>(place.tool)];
        }
      } else {
        problem.start[c] = work(seen_given_mm) - work(parts.untouched_seen_mm) -
                           wanted_mm[static_cast<std::size_t>(c) - places.size()];
      }
      for (Eigen::Index d = 0; d <= c; ++d) {
        double sum = 0;
        for (const auto& [at, force] : column.on) {
          for (const auto& [of, other] : columns[static_cast<std::size_t>(d)].on) {
            sum += force.dot(parts.compliance(at, of) * other);
          }
        }
        problem.compliance(c, d) = problem.compliance(d, c) = sum;
      }
    }
    for (std::size_t t = 0; t < tools.size(); ++t) {
      if (drive_of_tool[t] >= 0) problem.drive_force[drive_of_tool[t]] = *pushed(tools[t])->push_mN;
    }
    forces = solve_contact(problem);
    if (!forces.force.allFinite() || !forces.advance.allFinite()) break;

    Unknowns next{given_force, VectorXd::Zero(count)};
    for (Eigen::Index c = 0; c < size; ++c) {
      if (forces.force[c] == 0) continue;
      for (const auto& [point, force] : columns[static_cast<std::size_t>(c)].on) {
        next.force_mN.try_emplace(point, Vector3d::Zero()).first->second += forces.force[c] * force;
      }
    }
    for (std::size_t t = 0; t < tools.size(); ++t) {
      if (drive_of_tool[t] >= 0) next.advance_mm[static_cast<Eigen::Index>(t)] = forces.advance[drive_of_tool[t]];
    }
    const VectorXd next_seen_mm = parts.seen_under(next.force_mN);
    report.movement_mm = std::max(largest_change(next_seen_mm, seen_mm, surface_values),
                                  count > 0 ? (next.advance_mm - now.advance_mm).cwiseAbs().maxCoeff() : 0.0);
    VectorXd way_mm = (next_seen_mm - seen_mm).head(surface_values);
    if (last_way_mm.size() > 0) {
      const double along = way_mm.dot(last_way_mm) / std::max(way_mm.norm() * last_way_mm.norm(), 1e-300);
      share = std::clamp(along < -0.2 ? 0.5 * share : along > 0.2 ? 1.5 * share : share, 0.05, 1.0);
    }
    last_way_mm = std::move(way_mm);
    const bool at_rest = report.movement_mm <= options.movement_tolerance_mm;
    const double part = at_rest ? 1.0 : std::min(share, options.largest_move_mm / std::max(report.movement_mm, 1e-12));
    // Forces, displacements and advances are linear in each other: a part of the way is in equilibrium too.
    for (auto& [point, force] : now.force_mN) force *= 1.0 - part;
    for (const auto& [point, force] : next.force_mN) {
      now.force_mN.try_emplace(point, Vector3d::Zero()).first->second += part * force;
    }
    if (part == 1.0) now.force_mN = next.force_mN;
    now.advance_mm += part * (next.advance_mm - now.advance_mm);
    seen_mm = part == 1.0 ? next_seen_mm : parts.seen_under(now.force_mN);
    if (!at_rest) continue;
    report.penetration_mm = 0;
    for (const NearPlace& place : places_near(parts.surface, tools, now.advance_mm, seen_mm, 0.0)) {
      report.penetration_mm = std::max(report.penetration_mm, -place.gap_mm);
    }
    report.converged = forces.converged && report.movement_mm <= options.movement_tolerance_mm &&
                       report.penetration_mm <= options.penetration_tolerance_mm;
    if (report.converged) {
      ++report.rounds;
      break;
    }
  }

  ContactState state;
  state.force_mN = now.force_mN;
  std::erase_if(state.force_mN, [](const auto& item) { return item.second.norm() == 0; });
  const Eigen::Index shown_values = surface_values + 3 * static_cast<Eigen::Index>(parts.watched.size());
  for (Eigen::Index i = 0; i < shown_values; i += 3) {
    (i < surface_values ? state.surface_mm : state.watched_mm).emplace_back(seen_mm.segment<3>(i));
  }
  for (std::size_t t = 0; t < tools.size(); ++t) {
    state.tools.push_back({tools[t].id, Vector3d::Zero(), 0, now.advance_mm[static_cast<Eigen::Index>(t)], 0});
  }
  for (std::size_t c = 0; c < places.size(); ++c) {
    ToolContact& contact = state.tools[places[c].tool];
    if (forces.force.size() <= static_cast<Eigen::Index>(c) || !(forces.force[static_cast<Eigen::Index>(c)] > 0))
      continue;
    contact.force_mN += forces.force[static_cast<Eigen::Index>(c)] * places[c].normal;
    ++contact.contacts;
    state.touched.push_back({contact.id, places[c].rod, places[c].points, places[c].weights});
  }
  for (const NearPlace& place : places_near(parts.surface, tools, now.advance_mm, seen_mm, 0.0)) {
    state.tools[place.tool].penetration_mm = std::max(state.tools[place.tool].penetration_mm, -place.gap_mm);
  }
  auto two_sided = static_cast<Eigen::Index>(places.size());
  for (const Gripped& gripped : grips) {
    ToolContact& contact = state.tools[gripped.tool];
    const auto& grasp = std::get<Grasp>(tools[gripped.tool].what);
    contact.contacts = static_cast<int>(gripped.points.size());
    if (const double* pull_mN = std::get_if<double>(&grasp.drawn)) {
      contact.force_mN = *pull_mN * unit_or_zero(grasp.direction);
    } else if (two_sided + 3 <= forces.force.size()) {
      contact.force_mN = forces.force.segment<3>(two_sided);
      two_sided += 3;
    }
  }
  report.inverted_cells = parts.inverted_cells(seen_mm);
  report.relative_residual = std::max(parts.untouched.report.relative_residual, parts.relative_residual);
  for (const auto& [point, force] : state.force_mN) {
    report.energy_uJ += 0.5 * force.dot(state.surface_mm[point] - parts.untouched.surface_mm[point]);
  }
  report.solve_ms = 1e3 * watch.seconds();
  state.report = report;
  return state;
}

Result<StaticResult> ContactBody::whole_result(const ContactState& state) const {
  const Parts& parts = *parts_;
  VectorXd force_mN = parts.standing_force_mN;
  for (const auto& [point, force] : state.force_mN) {
    force_mN.segment<3>(3 * parts.model.nodes().node_of_point[parts.mesh_point[point]]) += force;
  }
  return parts.model.solve_nodal({std::move(force_mN), {}});
}

const ContactState& ContactBody::untouched() const { return parts_->untouched; }
const geometry::Surface& ContactBody::surface() const { return parts_->surface; }
const StaticModel& ContactBody::model() const { return parts_->model; }

// Neighbours share a group: who needs one will soon need the others, and several right-hand sides cost little more than
// one. Cells of a grid, cut into runs of at most eight.
void ContactBody::Parts::make_groups() {
  constexpr double cell_mm = 15.0;
  constexpr std::size_t most = 8;
  std::map<std::array<long, 3>, std::vector<int>> cells;
  for (std::size_t p = 0; p < surface.points_mm.size(); ++p) {
    const Vector3d at = (surface.points_mm[p] / cell_mm).array().floor();
    cells[{std::lround(at.x()), std::lround(at.y()), std::lround(at.z())}].push_back(static_cast<int>(p));
  }
  group_of_point.resize(surface.points_mm.size());
  for (const auto& [cell, points] : cells) {
    for (std::size_t begin = 0; begin < points.size(); begin += most) {
      const std::size_t end = std::min(points.size(), begin + most);
      for (std::size_t i = begin; i < end; ++i) group_of_point[points[i]] = static_cast<int>(groups.size());
      groups.emplace_back(points.begin() + static_cast<long>(begin), points.begin() + static_cast<long>(end));
    }
  }
}

Result<int> ContactBody::Parts::remember(const std::vector<int>& points) const {
  const std::lock_guard lock(mutex);
  int solves = 0;
  for (const int asked : points) {
    if (responses[asked]) continue;
    const std::vector<int>& group = groups[group_of_point[asked]];
    Eigen::MatrixXd unit = Eigen::MatrixXd::Zero(3 * static_cast<Eigen::Index>(model.nodes().nodes()),
                                                 3 * static_cast<Eigen::Index>(group.size()));
    for (std::size_t i = 0; i < group.size(); ++i) {
      const int node = model.nodes().node_of_point[mesh_point[group[i]]];
      unit.block<3, 3>(3 * node, 3 * static_cast<Eigen::Index>(i)).setIdentity();
    }
    const StaticModel::Responses solved = model.respond(unit);
    if (!solved.converged) {
      return failure("not-converged",
                     GLISSON_TEXT("The body's answer to a force on its surface was not found: the relative residual "
                                  "stayed at {0}."),
                     {fmt::format("{:.1e}", solved.relative_residual)});
    }
    relative_residual = std::max(relative_residual, solved.relative_residual);
    solves += static_cast<int>(unit.cols());
    for (std::size_t i = 0; i < group.size(); ++i) {
      responses[group[i]] = seen_part(solved.displacement_mm.middleCols<3>(3 * static_cast<Eigen::Index>(i)));
    }
  }
  return solves;
}

ContactBody::Parts::Response ContactBody::Parts::seen_part(const Response& displacement_mm) const {
  const NodeLayout& layout = model.nodes();
  Response part(seen(), 3);
  Eigen::Index row = 0;
  for (const int p : mesh_point) {
    part.middleRows<3>(row) = displacement_mm.middleRows<3>(3 * layout.node_of_point[p]);
    row += 3;
  }
  for (const PointInMesh& place : watched) {
    const TetValues values = tet_values(layout.order, place.barycentric);
    part.middleRows<3>(row).setZero();
    for (int i = 0; i < layout.nodes_per_cell(); ++i) {
      part.middleRows<3>(row) += values[i] * displacement_mm.middleRows<3>(3 * layout.cells[place.cell][i]);
    }
    row += 3;
  }
  for (const int p : inner) {
    if (layout.node_of_point[p] >= 0) {
      part.middleRows<3>(row) = displacement_mm.middleRows<3>(3 * layout.node_of_point[p]);
    } else {
      part.middleRows<3>(row).setZero();
    }
    row += 3;
  }
  return part;
}

int ContactBody::Parts::inverted_cells(const VectorXd& seen_mm) const {
  const geometry::TetMesh& mesh = model.mesh();
  int inverted = 0;
  for (const auto& cell : mesh.cells) {
    std::array<Vector3d, 4> corners;
    for (int i = 0; i < 4; ++i) {
      corners[i] = mesh.points_mm[cell[i]] + seen_mm.segment<3>(3 * seen_of_mesh_point[cell[i]]);
    }
    inverted += (corners[1] - corners[0]).cross(corners[2] - corners[0]).dot(corners[3] - corners[0]) <= 0;
  }
  return inverted;
}

VectorXd ContactBody::Parts::seen_under(const std::map<int, Vector3d>& force_mN) const {
  VectorXd values = untouched_seen_mm;
  for (const auto& [point, force] : force_mN) values += response(point) * force;
  return values;
}

}  // namespace glisson::mechanics
