#include "closedloop/fullfield/internal/plate.h"

#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>
#include <Eigen/QR>
#include <set>

#include "closedloop/fullfield/internal/boundaries.h"

namespace glisson::closedloop {
namespace {

// That are read. Of a field that was smoothed so few that their errors are about independent of each other: rows that
// share an error would make a small one look certain.
constexpr std::size_t maximum_plate_points = 300;
constexpr std::size_t maximum_points_if_smoothed = 30;

std::vector<std::pair<std::size_t, int>> moved_of(const FullField& field) {
  std::vector<std::pair<std::size_t, int>> moved;
  for (std::size_t b = 0; b < field.boundaries.size(); ++b) {
    for (int d = 0; d < 2; ++d) {
      if (field.boundaries[b].prescribed[static_cast<std::size_t>(d)]) moved.emplace_back(b, d);
    }
  }
  return moved;
}

}  // namespace

Plate::Plate(FullField field)
    : field_(std::move(field)),
      moved_(moved_of(field_)),
      linear_(make_body(ElementOrder::linear)),
      quadratic_(make_body(ElementOrder::quadratic)) {
  for (std::size_t trial = 0; trial < field_.trials.size(); ++trial) prescribe(trial);
  choose_rows();
}

std::vector<bool> Plate::fixed() const {
  std::vector<bool> fixed(2 * field_.points.size(), true);
  for (const auto& triangle : field_.triangles) {
    for (const int point : triangle) {
      fixed[2 * static_cast<std::size_t>(point)] = false;
      fixed[2 * static_cast<std::size_t>(point) + 1] = false;
    }
  }
  for (const auto& [b, d] : moved_) {
    for (const int point : field_.boundaries[b].points)
      fixed[2 * static_cast<std::size_t>(point) + static_cast<std::size_t>(d)] = true;
  }
  return fixed;
}

Plate::Body Plate::make_body(ElementOrder order) const {
  Body body{PlaneElements(field_.points, field_.triangles, fixed(), order), {}};
  const auto of_mesh = 2 * static_cast<Eigen::Index>(field_.points.size());
  body.moves.resize(body.elements.freedoms(), static_cast<Eigen::Index>(moved_.size()));
  for (std::size_t m = 0; m < moved_.size(); ++m) {
    Eigen::VectorXd move = Eigen::VectorXd::Zero(of_mesh);
    for (const int point : field_.boundaries[moved_[m].first].points) move[2 * point + moved_[m].second] = 1;
    Eigen::VectorXd all = body.elements.prolonged(move);
    // Halfway between a point that moves and one that does not is free.
    for (double& one : all) one = one == 1 ? 1 : 0;
    body.moves.col(static_cast<Eigen::Index>(m)) = all;
  }
  return body;
}

// A boundary moves as one, unless it was seen to turn or bend: then each point as it was measured.
void Plate::prescribe(std::size_t which) {
  const PlaneTrial& trial = field_.trials[which];
  Eigen::VectorXd all(2 * static_cast<Eigen::Index>(field_.points.size()));
  for (Eigen::Index i = 0; i < all.size(); ++i) {
    const double measured = trial.displacement(i % 2, i / 2);
    all[i] = std::isfinite(measured) ? measured : 0;
  }
  Eigen::VectorXd doubts = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(moved_.size()));
  for (std::size_t m = 0; m < moved_.size(); ++m) {
    const auto& [b, d] = moved_[m];
    const std::vector<int>& points = field_.boundaries[b].points;
    const double said = trial.prescribed(d, static_cast<Eigen::Index>(b));
    const auto [count, mean, spread] = boundary_move(trial, d, points);
    constexpr double noises_of_one = 5;
    constexpr double share_of_one = 0.02;
    const bool as_one = spread <= std::max(noises_of_one * field_.noise, share_of_one * std::abs(mean));
    for (const int point : points) {
      double& value = all[2 * point + d];
      if (std::isfinite(said)) {
        value = said;
      } else if (as_one || !std::isfinite(trial.displacement(d, point))) {
        value = mean;
      }
    }
    if (!std::isfinite(said) && count > 0) doubts[static_cast<Eigen::Index>(m)] = field_.noise / std::sqrt(count);
  }
  prescribed_.push_back(std::move(all));
  doubts_.push_back(std::move(doubts));
}

bool Plate::measured_everywhere(std::size_t trial) const {
  for (const auto& triangle : field_.triangles) {
    for (const int point : triangle) {
      if (!field_.trials[trial].displacement.col(point).allFinite()) return false;
    }
  }
  return true;
}

double Plate::extent() const {
  Eigen::AlignedBox2d box;
  for (const Eigen::Vector2d& point : field_.points) box.extend(point);
  return box.sizes().maxCoeff();
}

// Points that were measured in every trial; all of them where none was measured at all, to be predicted.
void Plate::choose_rows() {
  const std::vector<bool> is_fixed = fixed();
  std::vector<int> points;
  bool measured = false;
  for (const PlaneTrial& trial : field_.trials) measured = measured || trial.displacement.array().isFinite().any();
  for (std::size_t p = 0; p < field_.points.size(); ++p) {
    const auto column = static_cast<Eigen::Index>(p);
    const bool free = !is_fixed[2 * p] || !is_fixed[2 * p + 1];
    const bool seen = std::any_of(field_.trials.begin(), field_.trials.end(),
                                  [&](const PlaneTrial& trial) { return trial.displacement.col(column).allFinite(); });
    if (free && (seen || !measured)) points.push_back(static_cast<int>(p));
  }
  const std::size_t stride =
      1 +
      (points.empty() ? 0 : (points.size() - 1) / (is_smoothed() ? maximum_points_if_smoothed : maximum_plate_points));

  observations_.unit = "noise";
  observations_.directions = {"ux", "uy", "fx", "fy"};
  observations_.quantities = {0, 0, 1, 1};
  std::vector<Observation> all;
  int number = 0;
  for (std::size_t t = 0; t < field_.trials.size(); ++t) {
    const PlaneTrial& trial = field_.trials[t];
    first_rows_.push_back(static_cast<Eigen::Index>(all.size()));
    rows_.emplace_back();
    double load = 0;
    for (const auto& [b, d] : moved_) {
      for (const int point : field_.boundaries[b].points)
        load = std::max(load, std::abs(prescribed_[t][2 * point + d]) / extent());
    }
    const bool of_trial = trial.displacement.array().isFinite().any();
    for (std::size_t i = 0; i < points.size(); i += stride, ++number) {
      const auto p = static_cast<std::size_t>(points[i]);
      if (of_trial && !trial.displacement.col(points[i]).allFinite()) continue;
      for (int d = 0; d < 2; ++d) {
        if (is_fixed[2 * p + static_cast<std::size_t>(d)]) continue;
        rows_[t].push_back({points[i], d, {}});
        all.push_back({.measured = trial.displacement(d, points[i]),
                       .noise = field_.noise,
                       .trial = static_cast<int>(t),
                       .direction = d,
                       .point = number,
                       .load = load,
                       .place_mm = Eigen::Vector3d(field_.points[p].x(), field_.points[p].y(), 0)});
      }
    }
    const std::size_t before = all.size();
    add_reactions(t, all);
    for (std::size_t row = before; row < all.size(); ++row, ++number) {
      all[row].point = number;
      all[row].load = load;
    }
    observations_.trials.push_back(trial.id);
  }
  observations_.add(all);
}

void Plate::add_reactions(std::size_t t, std::vector<Observation>& all) {
  const PlaneTrial& trial = field_.trials[t];
  const bool nothing_measured = !trial.reaction.array().isFinite().any();
  for (int d = 0; d < 2; ++d) {
    std::vector<Eigen::Index> moves, known;
    for (std::size_t m = 0; m < moved_.size(); ++m) {
      if (moved_[m].second != d) continue;
      moves.push_back(static_cast<Eigen::Index>(m));
      if (nothing_measured || std::isfinite(trial.reaction(d, static_cast<Eigen::Index>(moved_[m].first))))
        known.push_back(static_cast<Eigen::Index>(m));
    }
    const bool in_balance = known.size() == moves.size() && known.size() > 1;
    for (std::size_t k = in_balance ? 1 : 0; k < known.size(); ++k) {
      Row row{-1, d, {}};
      double measured = 0;
      Eigen::Vector2d middle = Eigen::Vector2d::Zero();
      for (const Eigen::Index m : known) {
        const double share = (m == known[k] ? 1.0 : 0.0) - (in_balance ? 1.0 / static_cast<double>(known.size()) : 0.0);
        if (share == 0) continue;
        row.of_moves.emplace_back(m, share);
        measured += share * trial.reaction(d, static_cast<Eigen::Index>(moved_[static_cast<std::size_t>(m)].first));
      }
      const auto& points = field_.boundaries[moved_[static_cast<std::size_t>(known[k])].first].points;
      for (const int point : points)
        middle += field_.points[static_cast<std::size_t>(point)] / static_cast<double>(points.size());
      all.push_back({.measured = nothing_measured ? not_given : measured,
                     .noise = 1,
                     .trial = static_cast<int>(t),
                     .direction = 2 + d,
                     .place_mm = Eigen::Vector3d(middle.x(), middle.y(), 0)});
      rows_[t].push_back(std::move(row));
    }
  }
}

std::optional<Eigen::VectorXd> Plate::equilibrium(ElementOrder order, const PlaneLaw& law, std::size_t trial,
                                                  const Eigen::VectorXd* start) const {
  const PlaneElements& elements = body(order).elements;
  const Eigen::VectorXd prescribed = elements.prolonged(prescribed_[trial]);
  if (start != nullptr) {
    if (auto found = elements.equilibrium(law, *start, prescribed)) return found;
  }
  if (measured_everywhere(trial)) {
    if (auto found = elements.equilibrium(law, prescribed, prescribed)) return found;
  }
  return elements.equilibrium_from_rest(law, prescribed);
}

Eigen::VectorXd Plate::read(ElementOrder order, std::size_t trial, const Eigen::VectorXd& displacement,
                            const Eigen::VectorXd& forces) const {
  const Eigen::VectorXd on_boundaries = field_.thickness * (body(order).moves.transpose() * forces);
  return rows_of(trial, displacement, on_boundaries);
}

Eigen::VectorXd Plate::rows_of(std::size_t trial, const Eigen::VectorXd& displacement,
                               const Eigen::VectorXd& on_boundaries) const {
  Eigen::VectorXd values(row_count(trial));
  for (std::size_t r = 0; r < rows_[trial].size(); ++r) {
    const Row& row = rows_[trial][r];
    double value = 0;
    for (const auto& [move, share] : row.of_moves) value += share * on_boundaries[move];
    values[static_cast<Eigen::Index>(r)] = row.point >= 0 ? displacement[2 * row.point + row.direction] : value;
  }
  return values;
}

std::optional<PlaneElements::Tangent> Plate::tangent(const PlaneLaw& law, const Eigen::VectorXd& displacement) const {
  return linear_.elements.tangent(law, displacement, linear_.moves);
}

Eigen::VectorXd Plate::response(std::size_t trial, const PlaneElements::Tangent& about,
                                const Eigen::VectorXd& forces) const {
  const Eigen::VectorXd moved = linear_.elements.solved(*about.factor, -forces);
  const Eigen::VectorXd on_boundaries =
      field_.thickness * (linear_.moves.transpose() * forces + about.along.transpose() * moved);
  return rows_of(trial, moved, on_boundaries);
}

Eigen::MatrixXd Plate::response_to_moves(std::size_t trial, const PlaneElements::Tangent& about) const {
  Eigen::MatrixXd responses(row_count(trial), linear_.moves.cols());
  for (Eigen::Index m = 0; m < linear_.moves.cols(); ++m) responses.col(m) = response(trial, about, about.along.col(m));
  return responses;
}

double Plate::order_of_stiffness() const {
  double order = 0;
  for (std::size_t t = 0; t < field_.trials.size(); ++t) {
    double strain = 0;
    for (const auto& [b, d] : moved_) {
      for (const int point : field_.boundaries[b].points)
        strain = std::max(strain, std::abs(prescribed_[t][2 * point + d]) / extent());
    }
    for (const double force : field_.trials[t].reaction.reshaped()) {
      if (std::isfinite(force) && strain > 0)
        order = std::max(order, std::abs(force) / (field_.thickness * extent() * strain));
    }
  }
  return order;
}

double Plate::largest_reaction() const {
  double largest = 0;
  for (const PlaneTrial& trial : field_.trials) {
    for (const double force : trial.reaction.reshaped()) {
      if (std::isfinite(force)) largest = std::max(largest, std::abs(force));
    }
  }
  return largest;
}

std::optional<double> Plate::imbalance() const {
  double squares = 0, count = 0;
  for (const PlaneTrial& trial : field_.trials) {
    for (int d = 0; d < 2; ++d) {
      double sum = 0, boundaries = 0;
      for (const auto& [b, direction] : moved_) {
        if (direction != d) continue;
        sum += trial.reaction(d, static_cast<Eigen::Index>(b));
        boundaries += 1;
      }
      if (!std::isfinite(sum) || boundaries < 2) continue;
      squares += sum * sum / boundaries;
      count += 1;
    }
  }
  return count > 0 ? std::optional(std::sqrt(squares / count)) : std::nullopt;
}

// A point beside what its neighbours, and theirs, say of it by a quadratic function; the median, so that the few places
// where a field bends more than that do not count.
double Plate::roughness() const {
  std::vector<std::set<int>> neighbours(field_.points.size());
  for (const auto& triangle : field_.triangles) {
    for (const int a : triangle) {
      for (const int b : triangle) {
        if (a != b) neighbours[static_cast<std::size_t>(a)].insert(b);
      }
    }
  }
  std::vector<double> squares;
  const std::size_t stride = 1 + field_.points.size() / maximum_plate_points;
  for (std::size_t p = 0; p < field_.points.size(); p += stride) {
    std::set<int> around = neighbours[p];
    for (const int near : neighbours[p])
      around.insert(neighbours[static_cast<std::size_t>(near)].begin(),
                    neighbours[static_cast<std::size_t>(near)].end());
    around.erase(static_cast<int>(p));
    if (around.size() < 10) continue;
    Eigen::MatrixXd functions(static_cast<Eigen::Index>(around.size()), 6);
    Eigen::Index row = 0;
    for (const int other : around) {
      const Eigen::Vector2d r = field_.points[static_cast<std::size_t>(other)] - field_.points[p];
      functions.row(row++) << 1, r.x(), r.y(), r.x() * r.x(), r.x() * r.y(), r.y() * r.y();
    }
    // The value at the point itself is the constant: a row of weights on the neighbours.
    const Eigen::VectorXd weights = functions.completeOrthogonalDecomposition().pseudoInverse().row(0).transpose();
    for (const PlaneTrial& trial : field_.trials) {
      for (int d = 0; d < 2; ++d) {
        double off = trial.displacement(d, static_cast<Eigen::Index>(p));
        Eigen::Index i = 0;
        for (const int other : around) off -= weights[i++] * trial.displacement(d, other);
        if (std::isfinite(off)) squares.push_back(off * off / (1 + weights.squaredNorm()));
      }
    }
  }
  if (squares.size() < 20) return 0;
  const auto middle = squares.begin() + static_cast<std::ptrdiff_t>(squares.size() / 2);
  std::nth_element(squares.begin(), middle, squares.end());
  constexpr double median_of_chi_squared = 0.4549;  // of one degree of freedom
  return std::sqrt(*middle / median_of_chi_squared);
}

}  // namespace glisson::closedloop
