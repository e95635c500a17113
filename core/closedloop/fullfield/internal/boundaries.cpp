#include "closedloop/fullfield/internal/boundaries.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

#include "base/json_reading.h"

namespace glisson::closedloop {
namespace {

std::string letters_and_digits(const std::string& name) {
  std::string kept;
  for (const char c : name) {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0)
      kept += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  return kept;
}

struct Side {
  const char* name;
  int axis;
  bool upper;
  std::vector<std::string> names;
};
const std::vector<Side>& sides() {
  static const std::vector<Side> all{{"left", 0, false, {"left", "xmin", "x0", "west", "minx"}},
                                     {"right", 0, true, {"right", "xmax", "x1", "xl", "east", "maxx"}},
                                     {"bottom", 1, false, {"bottom", "ymin", "y0", "south", "miny", "lower"}},
                                     {"top", 1, true, {"top", "ymax", "y1", "yl", "north", "maxy", "upper"}}};
  return all;
}

class Finder {
 public:
  Finder(const Json& declared, const geometry::Surface& mesh, FullField& field)
      : declared_(declared), mesh_(mesh), field_(field), used_(field.points.size(), false) {
    for (const auto& triangle : field.triangles) {
      for (const int point : triangle) used_[static_cast<std::size_t>(point)] = true;
    }
  }

  // Its number among the boundaries; found and added at its first mention. `acts`: directions in which it certainly
  // is prescribed.
  std::size_t named(const std::string& name, std::array<bool, 2> acts, const std::string& where);
  void add_groups_without_name();
  void add_sides_that_moved_as_one();

 private:
  [[nodiscard]] std::vector<int> points_where(const geometry::Field& field, std::optional<double> value) const;
  [[nodiscard]] std::vector<int> points_of(const Side& side) const;
  [[nodiscard]] std::optional<PlaneBoundary> declared_boundary(const std::string& name) const;
  [[nodiscard]] std::optional<PlaneBoundary> group(const std::string& name) const;
  [[nodiscard]] bool has_groups() const { return group_field(0) != nullptr || group_field(1) != nullptr; }
  [[nodiscard]] const geometry::Field* group_field(int axis) const {
    return geometry::find_field(mesh_.point_fields, axis == 0 ? "group_x" : "group_y");
  }
  [[nodiscard]] bool moved_as_one(const std::vector<int>& points, int axis) const;
  [[nodiscard]] bool is_covered(const std::vector<int>& points, int axis) const;

  const Json& declared_;
  const geometry::Surface& mesh_;
  FullField& field_;
  std::vector<bool> used_;
  std::map<std::string, std::size_t> known_;
};

std::vector<int> Finder::points_where(const geometry::Field& field, std::optional<double> value) const {
  std::vector<int> points;
  for (std::size_t i = 0; i < used_.size() && field.components == 1; ++i) {
    if (used_[i] && (value ? field.values[i] == *value : field.values[i] != 0)) points.push_back(static_cast<int>(i));
  }
  return points;
}

std::vector<int> Finder::points_of(const Side& side) const {
  double end = side.upper ? -std::numeric_limits<double>::infinity() : std::numeric_limits<double>::infinity();
  double other = -end;
  for (std::size_t i = 0; i < used_.size(); ++i) {
    if (!used_[i]) continue;
    const double at = field_.points[i][side.axis];
    end = side.upper ? std::max(end, at) : std::min(end, at);
    other = side.upper ? std::min(other, at) : std::max(other, at);
  }
  std::vector<int> points;
  for (std::size_t i = 0; i < used_.size(); ++i) {
    if (used_[i] && std::abs(field_.points[i][side.axis] - end) <= 1e-6 * std::abs(end - other))
      points.push_back(static_cast<int>(i));
  }
  return points;
}

std::optional<PlaneBoundary> Finder::declared_boundary(const std::string& name) const {
  if (!declared_.contains(name)) return std::nullopt;
  const Json& json = declared_[name];
  const std::string where = "boundary " + name;
  only_keys(json, {"point_array", "value", "side", "prescribed"}, where);
  PlaneBoundary boundary{name, {}, {false, false}};
  if (json.contains("side")) {
    const std::string wanted = text_in(json["side"], where + ", side");
    for (const Side& side : sides()) {
      if (wanted == side.name) boundary.points = points_of(side);
    }
    if (boundary.points.empty())
      refuse_at(where + ", side", GLISSON_TEXT("{0} must be one of {1}."),
                {"\"left\", \"right\", \"bottom\", \"top\""});
  } else {
    const std::string array = text_in(required(json, "point_array", where), where + ", point_array");
    const geometry::Field* field = geometry::find_field(mesh_.point_fields, array);
    if (field == nullptr)
      refuse("experiment-invalid", GLISSON_TEXT("{0} names the point array \"{1}\", which the mesh does not have."),
             {where, array});
    boundary.points = points_where(
        *field, json.contains("value") ? std::optional(number_in(json["value"], where + ", value")) : std::nullopt);
  }
  for (const Json& direction : required(json, "prescribed", where)) {
    const std::string axis = text_in(direction, where + ", prescribed");
    if (axis != "x" && axis != "y" && axis != "ux" && axis != "uy")
      refuse_at(where + ", prescribed", GLISSON_TEXT("{0} must be one of {1}."), {"\"x\", \"y\""});
    boundary.prescribed[axis.back() == 'x' ? 0 : 1] = true;
  }
  return boundary;
}

// The number in a name is the group's, a letter x or y says in which array.
std::optional<PlaneBoundary> Finder::group(const std::string& name) const {
  std::string digits, axes;
  for (const char c : letters_and_digits(name)) {
    if (std::isdigit(static_cast<unsigned char>(c)) != 0) digits += c;
    if (c == 'x' || c == 'y') axes += c;
  }
  if (digits.empty() || digits.size() > 6) return std::nullopt;
  const double value = std::stod(digits);
  for (int axis = 0; axis < 2 && value != 0; ++axis) {
    const geometry::Field* field = group_field(axis);
    if (field == nullptr || (axes.size() == 1 && axes[0] != "xy"[axis])) continue;
    PlaneBoundary boundary{name, points_where(*field, value), {axis == 0, axis == 1}};
    if (!boundary.points.empty()) return boundary;
  }
  return std::nullopt;
}

std::size_t Finder::named(const std::string& name, std::array<bool, 2> acts, const std::string& where) {
  if (const auto found = known_.find(name); found != known_.end()) {
    PlaneBoundary& boundary = field_.boundaries[found->second];
    for (std::size_t d = 0; d < 2; ++d) boundary.prescribed[d] = boundary.prescribed[d] || acts[d];
    return found->second;
  }
  std::optional<PlaneBoundary> boundary = declared_boundary(name);
  if (!boundary) {
    if (const geometry::Field* field = geometry::find_field(mesh_.point_fields, name))
      boundary = PlaneBoundary{name, points_where(*field, std::nullopt), acts};
  }
  if (!boundary) boundary = group(name);
  for (const Side& side : sides()) {
    if (boundary || std::count(side.names.begin(), side.names.end(), letters_and_digits(name)) == 0) continue;
    boundary = PlaneBoundary{name, points_of(side), acts};
    boundary->prescribed[static_cast<std::size_t>(side.axis)] = true;
  }
  if (!boundary || boundary->points.empty())
    refuse(
        "experiment-invalid", GLISSON_TEXT("{0} names the boundary \"{1}\", of which the mesh has no points."),
        {where, name},
        GLISSON_TEXT("Boundaries are sides (left, right, bottom, top), point arrays of the mesh, groups in its arrays "
                     "\"group_x\" and \"group_y\", or stand under \"boundaries\" in the experiment."));
  field_.boundaries.push_back(*std::move(boundary));
  return known_[name] = field_.boundaries.size() - 1;
}

bool Finder::is_covered(const std::vector<int>& points, int axis) const {
  return std::any_of(field_.boundaries.begin(), field_.boundaries.end(), [&](const PlaneBoundary& boundary) {
    return boundary.prescribed[static_cast<std::size_t>(axis)] &&
           std::count(boundary.points.begin(), boundary.points.end(), points[points.size() / 2]) > 0;
  });
}

void Finder::add_groups_without_name() {
  for (int axis = 0; axis < 2; ++axis) {
    const geometry::Field* field = group_field(axis);
    if (field == nullptr || field->components != 1) continue;
    std::vector<double> values = field->values;
    std::sort(values.begin(), values.end());
    values.erase(std::unique(values.begin(), values.end()), values.end());
    for (const double value : values) {
      if (value == 0 || field_.boundaries.size() > 100) continue;
      std::vector<int> points = points_where(*field, value);
      if (points.empty() || is_covered(points, axis)) continue;
      field_.boundaries.push_back(
          {std::string(1, "xy"[axis]) + std::to_string(static_cast<long>(value)), points, {axis == 0, axis == 1}});
    }
  }
}

// A free side bends inwards where it is pulled along.
bool Finder::moved_as_one(const std::vector<int>& points, int axis) const {
  bool seen = false;
  for (const PlaneTrial& trial : field_.trials) {
    const BoundaryMove move = boundary_move(trial, axis, points);
    if (move.count < 3) continue;
    seen = true;
    double largest = 0;
    for (const double moved : trial.displacement.reshaped()) {
      if (std::isfinite(moved)) largest = std::max(largest, std::abs(moved));
    }
    if (move.spread > std::max(2 * field_.noise, 2e-3 * largest)) return false;
  }
  return seen;
}

void Finder::add_sides_that_moved_as_one() {
  if (has_groups()) return;
  for (const Side& side : sides()) {
    std::vector<int> points = points_of(side);
    if (points.size() < 2 || is_covered(points, side.axis) || !moved_as_one(points, side.axis)) continue;
    field_.boundaries.push_back({side.name, std::move(points), {side.axis == 0, side.axis == 1}});
  }
}

}  // namespace

BoundaryMove boundary_move(const PlaneTrial& trial, int axis, const std::vector<int>& points) {
  double sum = 0, squares = 0, count = 0;
  for (const int point : points) {
    const double moved = trial.displacement(axis, point);
    if (!std::isfinite(moved)) continue;
    sum += moved;
    squares += moved * moved;
    count += 1;
  }
  if (count == 0) return {};
  const double mean = sum / count;
  return {count, mean, std::sqrt(std::max(0.0, squares / count - mean * mean))};
}

void assign_boundaries(const Json& declared, const geometry::Surface& mesh,
                       const std::vector<std::vector<ReactionRow>>& reactions,
                       const std::vector<std::vector<PrescribedRow>>& prescribed, FullField& field) {
  if (!declared.is_object()) refuse_at("boundaries", GLISSON_TEXT("{0} must be an object in braces."));
  Finder finder(declared, mesh, field);
  double largest = 0;
  for (const auto& rows : reactions) {
    for (const ReactionRow& row : rows) {
      for (const double force : row.force) {
        if (std::isfinite(force)) largest = std::max(largest, std::abs(force));
      }
    }
  }
  // Tables write 0 where nothing was measured, and where nothing pulls.
  const auto pulls = [&](double force) { return std::isfinite(force) && std::abs(force) > 1e-6 * largest; };
  struct Place {
    std::size_t trial, boundary;
    Eigen::Vector2d value;
  };
  std::vector<Place> forces, moves;
  for (std::size_t t = 0; t < field.trials.size(); ++t) {
    for (const ReactionRow& row : reactions[t])
      forces.push_back(
          {t, finder.named(row.boundary, {pulls(row.force.x()), pulls(row.force.y())}, row.where), row.force});
    for (const PrescribedRow& row : prescribed[t])
      moves.push_back(
          {t,
           finder.named(row.boundary, {std::isfinite(row.displacement.x()), std::isfinite(row.displacement.y())},
                        row.where),
           row.displacement});
  }
  for (const auto& [name, unused] : declared.items()) finder.named(name, {false, false}, "boundaries");
  finder.add_groups_without_name();
  finder.add_sides_that_moved_as_one();

  const auto count = static_cast<Eigen::Index>(field.boundaries.size());
  for (PlaneTrial& trial : field.trials) {
    trial.prescribed = trial.reaction = Eigen::Matrix2Xd::Constant(2, count, not_given);
  }
  for (const Place& place : forces)
    field.trials[place.trial].reaction.col(static_cast<Eigen::Index>(place.boundary)) = place.value;
  for (const Place& place : moves)
    field.trials[place.trial].prescribed.col(static_cast<Eigen::Index>(place.boundary)) = place.value;
  for (std::size_t b = 0; b < field.boundaries.size(); ++b) {
    for (int d = 0; d < 2; ++d) {
      if (field.boundaries[b].prescribed[static_cast<std::size_t>(d)]) continue;
      for (PlaneTrial& trial : field.trials) trial.reaction(d, static_cast<Eigen::Index>(b)) = not_given;
    }
  }
  for (int d = 0; d < 2; ++d) {
    const auto acts = [&](const PlaneBoundary& boundary) { return boundary.prescribed[static_cast<std::size_t>(d)]; };
    if (std::none_of(field.boundaries.begin(), field.boundaries.end(), acts))
      refuse(
          "experiment-invalid", GLISSON_TEXT("Nothing says where the plate is held or moved in {0}."),
          {d == 0 ? "x" : "y"},
          GLISSON_TEXT("Name the boundaries in the tables of reactions, or under \"boundaries\" in the experiment."));
  }
  const auto has_force = [](const PlaneTrial& trial) { return trial.reaction.array().isFinite().any(); };
  if (field.needs == Needs::measurements && std::none_of(field.trials.begin(), field.trials.end(), has_force))
    refuse("experiment-invalid", GLISSON_TEXT("No reaction is given where a displacement is prescribed."), {},
           GLISSON_TEXT("Displacements alone do not say how stiff the material is."));
}

}  // namespace glisson::closedloop
