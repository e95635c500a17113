#include "studies/dissertation/internal/revolved_press.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <Eigen/LU>
#include <Eigen/Sparse>
#include <Eigen/SparseCholesky>
#include <numbers>
#include <optional>

namespace glisson::studies {
namespace {

using Eigen::Vector2d;
using Eigen::VectorXd;
// F as (F_rr, F_rz, F_zr, F_zz, F_hoop).
using Vector5d = Eigen::Matrix<double, 5, 1>;
using Matrix5d = Eigen::Matrix<double, 5, 5>;
using Vector16d = Eigen::Matrix<double, 16, 1>;
using Matrix16d = Eigen::Matrix<double, 16, 16>;

struct Density {
  double energy_kPa = 0;
  Vector5d stress_kPa;
  Matrix5d tangent_kPa;
};
std::optional<Density> density(const Gel& gel, const Vector5d& f);

// A Gauss point of an element: how F follows from the nodes' displacements, and its rest volume.
struct Point {
  std::array<int, 8> nodes;
  Eigen::Matrix<double, 5, 16> from_nodes;
  double volume_mm3;
  Gel gel;
};
// A point of the top's surface.
struct TopPoint {
  std::array<int, 3> nodes;
  Eigen::Vector3d shape;
  double area_mm2;
};

struct Mesh {
  std::vector<Vector2d> nodes_mm;
  std::vector<Point> points;
  std::vector<TopPoint> top;
  std::vector<int> profile;  // nodes from the axis over the top to the rim, and down the side
  std::vector<bool> held;    // two a node
  double stiffest_kPa = 0;   // shear modulus
};
Mesh mesh_of(const RevolvedBody& body, double ball_radius_mm, const PressOptions& options);

// What resists at displacements u, with the ball's lowest point at `depth_mm`.
struct Resistance {
  VectorXd force_mN;
  Eigen::SparseMatrix<double> stiffness;
  double on_ball_mN = 0;  // upwards
  double energy_uJ = 0;   // of the gel
  double contact_radius_mm = 0;
};

// A place on the ball's way.
struct Stop {
  VectorXd u_mm;
  PressedProfile seen;
};

class Press {
 public:
  Press(const RevolvedBody& body, double ball_radius_mm, const PressOptions& options)
      : mesh_(mesh_of(body, ball_radius_mm, options)),
        top_mm_(body.height_mm),
        ball_mm_(ball_radius_mm),
        spring_kPa_per_mm_(400 * mesh_.stiffest_kPa / options.finest_mm) {}

  [[nodiscard]] Stop at_rest() const;
  // From one stop to where the ball is deeper, in parts where it must be; none where no equilibrium is found.
  [[nodiscard]] std::optional<Stop> deeper(const Stop& from, double depth_mm, int halvings = 6) const;

 private:
  [[nodiscard]] std::optional<Stop> equilibrium(const VectorXd& guess_mm, double depth_mm) const;
  [[nodiscard]] std::optional<Resistance> resistance(const VectorXd& u_mm, double depth_mm) const;
  void press_on(const VectorXd& u_mm, double depth_mm, Resistance& sum,
                std::vector<Eigen::Triplet<double>>& entries) const;
  [[nodiscard]] std::vector<Vector2d> profile_mm(const VectorXd& u_mm) const;

  Mesh mesh_;
  double top_mm_, ball_mm_, spring_kPa_per_mm_;
};

}  // namespace

Result<PressCurve> press_revolved(const RevolvedBody& body, double ball_radius_mm, const std::vector<double>& forces_mN,
                                  const PressOptions& options, const Progress& progress) {
  const Press press(body, ball_radius_mm, options);
  Stop from = press.at_rest();
  PressCurve curve{from.seen.profile_mm, {}, {}};
  const auto deeper = [&](double depth_mm) -> Result<Stop> {
    auto stop = press.deeper(from, depth_mm);
    if (stop) return std::move(*stop);
    return failure("press-not-converged", GLISSON_TEXT("No equilibrium of the pressed gel was found at {0} mm."),
                   {fmt::format("{:.2f}", depth_mm)});
  };
  for (const double wanted_mN : forces_mN) {
    for (bool reached = false; !reached;) {
      if (progress.cancelled()) return cancelled();
      double low_mm = from.seen.depth_mm, low_mN = from.seen.force_mN, high_mm = low_mm + options.step_mm;
      if (high_mm > options.largest_part * body.height_mm) {
        return failure("press-too-deep", GLISSON_TEXT("The gel does not bear {0} N at {1} mm of depth."),
                       {fmt::format("{:g}", wanted_mN / 1000), fmt::format("{:.1f}", low_mm)});
      }
      auto next = deeper(high_mm);
      if (!next) return failure(next.error());
      reached = next->seen.force_mN >= wanted_mN;
      double high_mN = next->seen.force_mN;
      // The depth of the force that was asked for, by the rule of false position.
      for (int n = 0; reached && n < 30 && std::abs(next->seen.force_mN / wanted_mN - 1) > 1e-4; ++n) {
        next = deeper(low_mm + (high_mm - low_mm) * (wanted_mN - low_mN) / (high_mN - low_mN));
        if (!next) return failure(next.error());
        const bool below = next->seen.force_mN < wanted_mN;
        (below ? low_mm : high_mm) = next->seen.depth_mm;
        (below ? low_mN : high_mN) = next->seen.force_mN;
      }
      from = std::move(*next);
      curve.steps.push_back(from.seen);
      if (reached) curve.at_force.push_back(from.seen);
    }
  }
  return curve;
}

namespace {

std::optional<Density> density(const Gel& gel, const Vector5d& f) {
  const double plane = f[0] * f[3] - f[1] * f[2], j = plane * f[4];
  if (!(j > 1e-6) || !(plane > 0)) return {};
  const Vector5d j_slope(f[3] * f[4], -f[2] * f[4], -f[1] * f[4], f[0] * f[4], plane);
  Matrix5d j_bend = Matrix5d::Zero();
  j_bend(0, 3) = j_bend(3, 0) = f[4];
  j_bend(1, 2) = j_bend(2, 1) = -f[4];
  j_bend(0, 4) = j_bend(4, 0) = f[3];
  j_bend(3, 4) = j_bend(4, 3) = f[0];
  j_bend(1, 4) = j_bend(4, 1) = -f[2];
  j_bend(2, 4) = j_bend(4, 2) = -f[1];
  const double square = f.squaredNorm(), scale = std::pow(j, -2.0 / 3);
  const double i = scale * square;
  const Vector5d i_slope = 2 * scale * f - 2.0 / 3 * i / j * j_slope;
  const Matrix5d crossed = f * j_slope.transpose();
  const Matrix5d i_bend = 2 * scale * Matrix5d::Identity() - 4.0 / 3 * scale / j * (crossed + crossed.transpose()) +
                          10.0 / 9 * i / (j * j) * j_slope * j_slope.transpose() - 2.0 / 3 * i / j * j_bend;
  const double w = gel.shear_kPa / 2, grown = i - 3;
  const double w_slope = w * (1 + 2 * gel.stiffening * grown), w_bend = w * 2 * gel.stiffening;
  return Density{w * (grown + gel.stiffening * grown * grown) + gel.bulk_kPa / 2 * (j - 1) * (j - 1),
                 w_slope * i_slope + gel.bulk_kPa * (j - 1) * j_slope,
                 w_bend * i_slope * i_slope.transpose() + w_slope * i_bend +
                     gel.bulk_kPa * (j_slope * j_slope.transpose() + (j - 1) * j_bend)};
}

// Corners at (-1, -1), (1, -1), (1, 1), (-1, 1), then the middles of the sides between them.
constexpr std::array<std::array<int, 2>, 8> corners{
    {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {0, -1}, {1, 0}, {0, 1}, {-1, 0}}};

// Of the eight nodes: their values and slopes at (x, y) of the square.
Eigen::Matrix<double, 8, 3> shape(double x, double y) {
  Eigen::Matrix<double, 8, 3> n;
  for (int a = 0; a < 8; ++a) {
    const double p = corners[a][0], q = corners[a][1];
    if (a < 4) {
      n.row(a) << (1 + p * x) * (1 + q * y) * (p * x + q * y - 1) / 4, p * (1 + q * y) * (2 * p * x + q * y) / 4,
          q * (1 + p * x) * (p * x + 2 * q * y) / 4;
    } else if (p == 0) {
      n.row(a) << (1 - x * x) * (1 + q * y) / 2, -x * (1 + q * y), q * (1 - x * x) / 2;
    } else {
      n.row(a) << (1 - y * y) * (1 + p * x) / 2, p * (1 - y * y) / 2, -y * (1 + p * x);
    }
  }
  return n;
}

std::vector<double> columns_of(double radius_mm, double ball_radius_mm, const PressOptions& options) {
  std::vector<double> r{0};
  double across = options.finest_mm;
  while (r.back() < radius_mm) {
    if (r.back() > 1.6 * ball_radius_mm) across *= options.growth;
    r.push_back(r.back() + across);
  }
  for (double& value : r) value *= radius_mm / r.back();
  return r;
}

Mesh mesh_of(const RevolvedBody& body, double ball_radius_mm, const PressOptions& options) {
  const std::vector<double> r = columns_of(body.radius_mm, ball_radius_mm, options);
  const int across = static_cast<int>(r.size()) - 1, high = options.layers;
  Mesh mesh;
  // Nodes on the grid of half elements, without the elements' middles.
  std::vector<int> number(static_cast<std::size_t>((2 * across + 1) * (2 * high + 1)), -1);
  const auto at = [&](int i, int k) -> int& { return number[i + (2 * across + 1) * k]; };
  for (int i = 0; i <= 2 * across; ++i) {
    for (int k = 0; k <= 2 * high; ++k) {
      if (i % 2 == 1 && k % 2 == 1) continue;
      at(i, k) = static_cast<int>(mesh.nodes_mm.size());
      const double r_mm = i % 2 == 0 ? r[i / 2] : (r[i / 2] + r[i / 2 + 1]) / 2;
      mesh.nodes_mm.emplace_back(r_mm, body.height_mm * k / (2 * high));
      mesh.held.push_back(i == 0 || k == 0);
      mesh.held.push_back(k == 0);
    }
  }
  const double gauss = 1 / std::sqrt(3.0);
  for (int i = 0; i < across; ++i) {
    for (int k = 0; k < high; ++k) {
      Point point{};
      for (int a = 0; a < 8; ++a) point.nodes[a] = at(2 * i + 1 + corners[a][0], 2 * k + 1 + corners[a][1]);
      for (int g = 0; g < 4; ++g) {
        const auto n = shape(g % 2 == 0 ? -gauss : gauss, g < 2 ? -gauss : gauss);
        Eigen::Matrix<double, 8, 2> x;
        for (int a = 0; a < 8; ++a) x.row(a) = mesh.nodes_mm[point.nodes[a]].transpose();
        const Vector2d place = x.transpose() * n.col(0);
        const Eigen::Matrix2d to_mm = n.rightCols<2>().transpose() * x;
        const Eigen::Matrix<double, 8, 2> slope = n.rightCols<2>() * to_mm.inverse().transpose();
        point.from_nodes.setZero();
        for (int a = 0; a < 8; ++a) {
          point.from_nodes(0, 2 * a) = point.from_nodes(2, 2 * a + 1) = slope(a, 0);
          point.from_nodes(1, 2 * a) = point.from_nodes(3, 2 * a + 1) = slope(a, 1);
          point.from_nodes(4, 2 * a) = n(a, 0) / place.x();
        }
        point.volume_mm3 = 2 * std::numbers::pi * place.x() * to_mm.determinant();
        point.gel = body.gel_at(place.x(), place.y());
        mesh.stiffest_kPa = std::max(mesh.stiffest_kPa, point.gel.shear_kPa);
        mesh.points.push_back(point);
      }
    }
  }
  // Five points a side of the top.
  constexpr std::array<double, 5> places{-0.9061798459386640, -0.5384693101056831, 0, 0.5384693101056831,
                                         0.9061798459386640};
  constexpr std::array<double, 5> weights{0.2369268850561891, 0.4786286704993665, 0.5688888888888889,
                                          0.4786286704993665, 0.2369268850561891};
  for (int i = 0; i < across; ++i) {
    for (std::size_t g = 0; g < places.size(); ++g) {
      const double x = places[g], half = (r[i + 1] - r[i]) / 2;
      mesh.top.push_back({{at(2 * i, 2 * high), at(2 * i + 1, 2 * high), at(2 * i + 2, 2 * high)},
                          {x * (x - 1) / 2, 1 - x * x, x * (x + 1) / 2},
                          2 * std::numbers::pi * (r[i] + half * (1 + x)) * half * weights[g]});
    }
  }
  for (int i = 0; i <= 2 * across; ++i) mesh.profile.push_back(at(i, 2 * high));
  for (int k = 2 * high - 1; k >= 0; --k) mesh.profile.push_back(at(2 * across, k));
  return mesh;
}

std::optional<Resistance> Press::resistance(const VectorXd& u_mm, double depth_mm) const {
  Resistance sum{VectorXd::Zero(u_mm.size()), Eigen::SparseMatrix<double>(u_mm.size(), u_mm.size())};
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(mesh_.points.size() * 256);
  for (const Point& point : mesh_.points) {
    Vector16d u;
    for (int a = 0; a < 8; ++a) u.segment<2>(2 * a) = u_mm.segment<2>(2 * point.nodes[a]);
    Vector5d f = point.from_nodes * u;
    f[0] += 1;
    f[3] += 1;
    f[4] += 1;
    const auto here = density(point.gel, f);
    if (!here) return {};
    sum.energy_uJ += point.volume_mm3 * here->energy_kPa;
    const Vector16d force = point.volume_mm3 * point.from_nodes.transpose() * here->stress_kPa;
    const Matrix16d stiffness = point.volume_mm3 * point.from_nodes.transpose() * here->tangent_kPa * point.from_nodes;
    for (int a = 0; a < 16; ++a) {
      const int row = 2 * point.nodes[a / 2] + a % 2;
      sum.force_mN[row] += force[a];
      for (int b = 0; b < 16; ++b) entries.emplace_back(row, 2 * point.nodes[b / 2] + b % 2, stiffness(a, b));
    }
  }
  press_on(u_mm, depth_mm, sum, entries);
  std::erase_if(entries, [&](const auto& entry) { return mesh_.held[entry.row()] || mesh_.held[entry.col()]; });
  for (Eigen::Index n = 0; n < u_mm.size(); ++n) {
    if (!mesh_.held[n]) continue;
    sum.force_mN[n] = 0;
    entries.emplace_back(static_cast<int>(n), static_cast<int>(n), 1);
  }
  sum.stiffness.setFromTriplets(entries.begin(), entries.end());
  return sum;
}

void Press::press_on(const VectorXd& u_mm, double depth_mm, Resistance& sum,
                     std::vector<Eigen::Triplet<double>>& entries) const {
  const Vector2d center(0, top_mm_ - depth_mm + ball_mm_);
  for (const TopPoint& point : mesh_.top) {
    Vector2d place(0, 0);
    for (int a = 0; a < 3; ++a) {
      place += point.shape[a] * (mesh_.nodes_mm[point.nodes[a]] + u_mm.segment<2>(2 * point.nodes[a]));
    }
    const double away = (place - center).norm(), gap = away - ball_mm_;
    if (gap >= 0) continue;
    const Vector2d normal = (place - center) / away;
    const double spring = spring_kPa_per_mm_ * point.area_mm2;
    const Eigen::Matrix2d along = normal * normal.transpose();
    const Eigen::Matrix2d bend = spring * (along + gap / away * (Eigen::Matrix2d::Identity() - along));
    for (int a = 0; a < 3; ++a) {
      sum.force_mN.segment<2>(2 * point.nodes[a]) += spring * gap * point.shape[a] * normal;
      for (int b = 0; b < 3; ++b) {
        for (int d = 0; d < 4; ++d) {
          entries.emplace_back(2 * point.nodes[a] + d / 2, 2 * point.nodes[b] + d % 2,
                               point.shape[a] * point.shape[b] * bend(d / 2, d % 2));
        }
      }
    }
    sum.on_ball_mN += spring * gap * normal.y();
    sum.contact_radius_mm = std::max(sum.contact_radius_mm, place.x());
  }
}

Stop Press::at_rest() const {
  const VectorXd u = VectorXd::Zero(2 * static_cast<Eigen::Index>(mesh_.nodes_mm.size()));
  return {u, {0, 0, 0, 0, profile_mm(u)}};
}

std::optional<Stop> Press::deeper(const Stop& from, double depth_mm, int halvings) const {
  if (auto stop = equilibrium(from.u_mm, depth_mm)) return stop;
  if (halvings == 0) return {};
  const auto half = deeper(from, (from.seen.depth_mm + depth_mm) / 2, halvings - 1);
  if (!half) return {};
  return deeper(*half, depth_mm, halvings - 1);
}

std::optional<Stop> Press::equilibrium(const VectorXd& guess_mm, double depth_mm) const {
  constexpr int most_steps = 30, free_steps = 8;
  VectorXd u = guess_mm;
  auto now = resistance(u, depth_mm);
  if (!now) return {};
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor;
  double largest = 0;
  for (int n = 0; n < most_steps; ++n) {
    const double off = now->force_mN.norm();
    largest = std::max(largest, off);
    if (off <= 1e-9 * largest || off < 1e-6) {
      return Stop{u, {depth_mm, now->on_ball_mN, now->energy_uJ, now->contact_radius_mm, profile_mm(u)}};
    }
    factor.compute(now->stiffness);
    if (factor.info() != Eigen::Success) return {};
    const VectorXd step = -factor.solve(now->force_mN);
    if (!step.allFinite()) return {};
    // The whole step, or less of it: while a cell would turn inside out, and later while points come and go.
    const double bearable = (n < free_steps ? 10 : 1) * off;
    double part = 1;
    std::optional<Resistance> next;
    for (; part > 1e-3; part /= 2) {
      next = resistance(u + part * step, depth_mm);
      if (next && next->force_mN.norm() < bearable) break;
    }
    if (!next) return {};
    u += part * step;
    now = std::move(next);
  }
  return {};
}

std::vector<Vector2d> Press::profile_mm(const VectorXd& u_mm) const {
  std::vector<Vector2d> places;
  for (const int node : mesh_.profile) places.emplace_back(mesh_.nodes_mm[node] + u_mm.segment<2>(2 * node));
  return places;
}

}  // namespace
}  // namespace glisson::studies
