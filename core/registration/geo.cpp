#include "registration/geo.h"

#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>
#include <numeric>
#include <random>

#include "base/parallel.h"
#include "registration/rigid.h"
#include "registration/trwls.h"
#include "registration/trws.h"

namespace glisson::registration {
namespace {

using geometry::Surface;

// One side of the matching: the surface and its samples.
struct Side {
  const Surface& surface;
  const GeodesicSamples& samples;

  [[nodiscard]] const Eigen::Vector3d& position_mm(int sample) const {
    return surface.points_mm[static_cast<std::size_t>(samples.points[static_cast<std::size_t>(sample)])];
  }
};

// Both sides, of which the smaller one gives the nodes, and their field.
struct Matching {
  Side nodes, labels;
  bool swapped;  // the nodes are the target's
  MatchingProblem problem;
};

struct Found {
  MatchingSolution solution;
  double orientation_kept = 0;

  [[nodiscard]] bool turned_right() const { return orientation_kept >= 0.5; }
};

Matching matching_of(const Side& source, const Side& target, const GeoOptions& options);
Result<Found> found_from_anywhere(const Matching& matching, const GeoOptions& options, const Progress& progress);
// From a start, which may be of the first nodes only.
Result<Found> found_from(const Matching& matching, const Labelling& start, const GeoOptions& options,
                         const Progress& progress);
// Without the samples.
SurfaceMatch match_of(const Matching& matching, Found found);

std::size_t nearest_of(const std::vector<Eigen::Vector3d>& places_mm, const Eigen::Vector3d& here_mm);

}  // namespace

Result<SurfaceMatch> match_surfaces(const Surface& source, const Surface& target, const GeoOptions& options,
                                    const Progress& progress) {
  auto source_samples = sample_surface(source, options.points, 0, progress.part(0, 0.45));
  if (!source_samples) return failure(source_samples.error());
  auto target_samples = sample_surface(target, options.points, 0, progress.part(0.45, 0.9));
  if (!target_samples) return failure(target_samples.error());
  const Matching matching = matching_of({source, *source_samples}, {target, *target_samples}, options);
  auto found = found_from_anywhere(matching, options, progress.part(0.9, 1));
  if (!found) return failure(found.error());
  SurfaceMatch match = match_of(matching, std::move(*found));
  match.source_samples = std::move(*source_samples);
  match.target_samples = std::move(*target_samples);
  return match;
}

struct FrameMatcher::Model {
  Surface surface;
  GeodesicSamples samples;
  GeoOptions options;
};

// Where the last frame's match leads the nodes: those before the first one that it does not know.
Labelling FrameMatcher::start_from(const Last& last, const std::vector<Eigen::Vector3d>& frame_mm,
                                   bool nodes_are_frame) {
  Labelling start;
  if (nodes_are_frame) {
    for (const Eigen::Vector3d& place_mm : frame_mm)
      start.push_back(last.samples[nearest_of(last.places_mm, place_mm)]);
    return start;
  }
  for (int node = 0;; ++node) {
    const auto known = std::find(last.samples.begin(), last.samples.end(), node);
    if (known == last.samples.end()) return start;
    const auto match = static_cast<std::size_t>(known - last.samples.begin());
    start.push_back(static_cast<int>(nearest_of(frame_mm, last.places_mm[match])));
  }
}

Result<FrameMatcher> FrameMatcher::create(Surface model, const GeoOptions& options, const Progress& progress) {
  auto samples = sample_surface(model, options.points, 0, progress);
  if (!samples) return failure(samples.error());
  return FrameMatcher(std::make_shared<const Model>(Model{std::move(model), std::move(*samples), options}));
}

Result<SurfaceMatch> FrameMatcher::match(const Surface& frame, const Progress& progress) {
  constexpr double far_worse = 1.2;
  const auto& [surface, model_samples, options] = *model_;
  auto samples = sample_surface(frame, options.points, 0, progress.part(0, 0.5));
  if (!samples) return failure(samples.error());
  const Matching matching = matching_of({frame, *samples}, {surface, model_samples}, options);

  std::vector<Eigen::Vector3d> places_mm;
  for (const int point : samples->points) places_mm.push_back(frame.points_mm[static_cast<std::size_t>(point)]);

  std::optional<Found> found;
  if (last_) {
    const Labelling start = start_from(*last_, places_mm, !matching.swapped);
    auto followed = found_from(matching, start, options, progress.part(0.5, 0.5));
    if (!followed) return failure(followed.error());
    if (progress.cancelled()) return cancelled();
    const double misfit = followed->solution.energy / matching.problem.tau_mm;
    if (followed->turned_right() && misfit <= far_worse * last_->misfit) found = std::move(*followed);
  }
  searched_ = !found;
  if (!found) {
    auto anywhere = found_from_anywhere(matching, options, progress.part(0.5, 1));
    if (!anywhere) return failure(anywhere.error());
    found = std::move(*anywhere);
  }
  last_ = Last{{}, {}, found->solution.energy / matching.problem.tau_mm};
  for (int node = 0; node < matching.problem.nodes(); ++node) {
    const int label = found->solution.labels[static_cast<std::size_t>(node)];
    last_->places_mm.push_back(places_mm[static_cast<std::size_t>(matching.swapped ? label : node)]);
    last_->samples.push_back(matching.swapped ? node : label);
  }
  SurfaceMatch match = match_of(matching, std::move(*found));
  match.source_samples = std::move(*samples);
  match.target_samples = model_samples;
  return match;
}

std::vector<int> densify(const SurfaceMatch& match) {
  constexpr int neighbours = 12;  // matches that a point's place is told from: enough that one bad one is outvoted
  const auto matches = static_cast<int>(match.source_points.size());
  const auto row_of = [](const GeodesicSamples& samples, int point) {
    return std::find(samples.points.begin(), samples.points.end(), point) - samples.points.begin();
  };
  std::vector<Eigen::Index> source_row, target_row;
  for (int i = 0; i < matches; ++i) {
    source_row.push_back(row_of(match.source_samples, match.source_points[static_cast<std::size_t>(i)]));
    target_row.push_back(row_of(match.target_samples, match.target_points[static_cast<std::size_t>(i)]));
  }
  const Eigen::MatrixXd& source_mm = match.source_samples.to_surface_mm;
  const Eigen::MatrixXd& target_mm = match.target_samples.to_surface_mm;

  // The points of the target around where each match leads.
  const double radius_mm = 2.5 * match.target_samples.covering_radius_mm;
  std::vector<std::vector<int>> around(static_cast<std::size_t>(matches));
  for (std::size_t i = 0; i < around.size(); ++i) {
    for (Eigen::Index point = 0; point < target_mm.cols(); ++point) {
      if (target_mm(target_row[i], point) <= radius_mm) around[i].push_back(static_cast<int>(point));
    }
  }

  std::vector<int> target_of(static_cast<std::size_t>(source_mm.cols()));
  parallel_for(target_of.size(), 64, [&](std::size_t begin, std::size_t end) {
    std::vector<std::size_t> nearest(static_cast<std::size_t>(matches));
    for (std::size_t point = begin; point < end; ++point) {
      const auto column = static_cast<Eigen::Index>(point);
      std::iota(nearest.begin(), nearest.end(), std::size_t{0});
      const auto count = static_cast<std::ptrdiff_t>(std::min(neighbours, matches));
      std::partial_sort(nearest.begin(), nearest.begin() + count, nearest.end(), [&](std::size_t a, std::size_t b) {
        return source_mm(source_row[a], column) < source_mm(source_row[b], column);
      });
      double minimum = std::numeric_limits<double>::infinity();
      for (const int candidate : around[nearest.front()]) {
        double misfit_mm = 0;
        for (auto i = nearest.begin(); i != nearest.begin() + count && misfit_mm < minimum; ++i) {
          misfit_mm += std::abs(source_mm(source_row[*i], column) - target_mm(target_row[*i], candidate));
        }
        if (misfit_mm < minimum) {
          minimum = misfit_mm;
          target_of[point] = candidate;
        }
      }
    }
  });
  return target_of;
}

namespace {

Eigen::MatrixXd position_seed(const Side& nodes, const Side& labels, double tau_mm, double weight);
Result<MatchingSolution> solve(const MatchingProblem& problem, const GeoOptions& options, const Progress& progress);
std::vector<Labelling> rough_matchings(const MatchingProblem& problem);
Result<MatchingSolution> solve_from(MatchingProblem problem, const Labelling& start, const GeoOptions& options,
                                    const Progress& progress);
double orientation_kept(const Side& nodes, const Side& labels, const Labelling& labelling);

Matching matching_of(const Side& source, const Side& target, const GeoOptions& options) {
  const double source_area_mm2 = geometry::area_mm2(source.surface);
  const double target_area_mm2 = geometry::area_mm2(target.surface);
  const bool swapped = target_area_mm2 < source_area_mm2;
  Matching matching{swapped ? target : source, swapped ? source : target, swapped, {}};
  MatchingProblem& problem = matching.problem;
  problem.source_mm = matching.nodes.samples.between_mm;
  problem.target_mm = matching.labels.samples.between_mm;
  const double size_mm = std::sqrt(std::max(source_area_mm2, target_area_mm2));
  problem.sigma_mm = options.relative_sigma * size_mm;
  problem.tau_mm = options.relative_tau * size_mm;
  const bool partial = resolved(Overlap::by_area, source.surface, target.surface) != Overlap::neither;
  if (options.prior == Prior::positions || (options.prior == Prior::automatic && partial)) {
    problem.seed = position_seed(matching.nodes, matching.labels, problem.tau_mm, options.prior_weight);
  }
  return matching;
}

Result<Found> found_from_anywhere(const Matching& matching, const GeoOptions& options, const Progress& progress) {
  progress.report(0, GLISSON_TEXT("matching"));
  const Progress solving = progress.part(0, 0);  // each solver goes through its own passes
  auto first = solve(matching.problem, options, solving);
  if (!first) return failure(first.error());
  Found best{std::move(*first)};
  best.orientation_kept = orientation_kept(matching.nodes, matching.labels, best.solution.labels);
  double solve_ms = best.solution.solve_ms;
  const double lower_bound = best.solution.lower_bound;  // of the field as it is, without any start
  for (const Labelling& start : rough_matchings(matching.problem)) {
    if (progress.cancelled()) return cancelled();
    auto other = found_from(matching, start, options, solving);
    if (!other) return other;
    solve_ms += other->solution.solve_ms;
    if (other->turned_right() != best.turned_right() ? other->turned_right()
                                                     : other->solution.energy < best.solution.energy) {
      best = std::move(*other);
    }
  }
  if (progress.cancelled()) return cancelled();
  best.solution.solve_ms = solve_ms;
  best.solution.lower_bound = lower_bound;
  return best;
}

Result<Found> found_from(const Matching& matching, const Labelling& start, const GeoOptions& options,
                         const Progress& progress) {
  auto solution = solve_from(matching.problem, start, options, progress);
  if (!solution) return failure(solution.error());
  const double kept = orientation_kept(matching.nodes, matching.labels, solution->labels);
  return Found{std::move(*solution), kept};
}

SurfaceMatch match_of(const Matching& matching, Found found) {
  SurfaceMatch match;
  const std::vector<int>& node_points = matching.nodes.samples.points;
  const std::vector<int>& label_points = matching.labels.samples.points;
  for (std::size_t node = 0; node < node_points.size(); ++node) {
    const int label_point = label_points[static_cast<std::size_t>(found.solution.labels[node])];
    match.source_points.push_back(matching.swapped ? label_point : node_points[node]);
    match.target_points.push_back(matching.swapped ? node_points[node] : label_point);
  }
  match.solution = std::move(found.solution);
  match.orientation_kept = found.orientation_kept;
  match.swapped = matching.swapped;
  return match;
}

std::size_t nearest_of(const std::vector<Eigen::Vector3d>& places_mm, const Eigen::Vector3d& here_mm) {
  const auto nearest = std::min_element(places_mm.begin(), places_mm.end(), [&](const auto& a, const auto& b) {
    return (a - here_mm).squaredNorm() < (b - here_mm).squaredNorm();
  });
  return static_cast<std::size_t>(nearest - places_mm.begin());
}

Eigen::MatrixXd position_seed(const Side& nodes, const Side& labels, double tau_mm, double weight) {
  const auto node_count = static_cast<Eigen::Index>(nodes.samples.points.size());
  const auto label_count = static_cast<Eigen::Index>(labels.samples.points.size());
  Eigen::MatrixXd seed(node_count, label_count);
  for (Eigen::Index i = 0; i < node_count; ++i) {
    for (Eigen::Index l = 0; l < label_count; ++l) {
      const double distance_mm =
          (nodes.position_mm(static_cast<int>(i)) - labels.position_mm(static_cast<int>(l))).norm();
      seed(i, l) = weight * static_cast<double>(node_count - 1) * std::min(distance_mm, tau_mm);
    }
  }
  return seed;
}

// A solver that is cancelled answers the best so far: whoever asks looks at `progress`.
Result<MatchingSolution> solve(const MatchingProblem& problem, const GeoOptions& options, const Progress& progress) {
  if (options.solver == Solver::trws) {
    const auto mrf = store(problem, std::uint64_t{8} << 30, progress);
    if (!mrf) return failure(mrf.error());
    return trws(*mrf, options.solving, progress);
  }
  TrwlsOptions solving;
  solving.starts = Starts::one;  // match_surfaces has its own, and orientation to tell them apart
  solving.width = options.width;
  solving.device = options.device;
  static_cast<SolverOptions&>(solving) = options.solving;
  return trwls(problem, solving, progress);
}

Eigen::MatrixXd seed_of(const MatchingProblem& problem) {
  if (problem.seed.size() > 0) return problem.seed;
  return Eigen::MatrixXd::Zero(problem.nodes(), problem.labels());
}

// Matchings of the first few nodes, the extremities, that are good in different ways: the solver is started from
// noise, again and again. Mirrored ones and those with head and tail swapped are among them, and the right one.
std::vector<Labelling> rough_matchings(const MatchingProblem& problem) {
  constexpr int rough_nodes = 24, starts = 40, maximum = 8;
  constexpr double worst = 1.5;  // of the best energy
  const int nodes = std::min(rough_nodes, problem.nodes());
  MatchingProblem rough = problem;
  rough.source_mm = problem.source_mm.topLeftCorner(nodes, nodes);
  rough.seed = seed_of(problem).topRows(nodes) * (static_cast<double>(nodes) / problem.nodes());
  const MatchingEnergy energy(rough);
  const double maximum_noise = 0.3 * problem.q * problem.tau_mm * (nodes - 1);

  struct Found {
    double energy;
    Labelling labels;
  };
  std::vector<Found> found;
  std::mt19937 random(20151207);  // any number; the same each time, so that the same surfaces match the same way
  std::uniform_real_distribution<double> noise(0, maximum_noise);
  TrwlsOptions solving;
  solving.starts = Starts::one;
  solving.passes = 3;
  for (int start = 0; start < starts; ++start) {
    MatchingProblem noisy = rough;
    noisy.seed += Eigen::MatrixXd::NullaryExpr(nodes, problem.labels(), [&] { return noise(random); });
    const auto solution = trwls(noisy, solving);
    if (!solution) continue;
    auto settled = solve_from(rough, solution->labels, GeoOptions{.solving = solving}, {});
    if (!settled) continue;
    found.push_back({energy(settled->labels), std::move(settled->labels)});
  }
  std::sort(found.begin(), found.end(), [](const Found& a, const Found& b) { return a.energy < b.energy; });

  const auto is_like = [&](const Labelling& a, const Labelling& b) {
    double apart_mm = 0;
    for (std::size_t i = 0; i < a.size(); ++i) apart_mm += std::min(problem.target_mm(a[i], b[i]), problem.tau_mm);
    return apart_mm < 0.2 * problem.tau_mm * static_cast<double>(a.size());
  };
  std::vector<Labelling> different;
  for (const Found& candidate : found) {
    if (candidate.energy > worst * found.front().energy || static_cast<int>(different.size()) == maximum) break;
    const bool is_new = std::none_of(different.begin(), different.end(),
                                     [&](const Labelling& known) { return is_like(candidate.labels, known); });
    if (is_new) different.push_back(candidate.labels);
  }
  return different;
}

// Leaving the start, which may be of the first nodes only, costs; so the solver begins there. Where it ends is polished
// and judged by the field itself.
Result<MatchingSolution> solve_from(MatchingProblem problem, const Labelling& start, const GeoOptions& options,
                                    const Progress& progress) {
  const Eigen::MatrixXd own_seed = seed_of(problem);
  const double cost_of_leaving = 0.1 * problem.q * problem.tau_mm * (problem.nodes() - 1);
  problem.seed = own_seed;
  for (std::size_t i = 0; i < start.size(); ++i) {
    problem.seed.row(static_cast<Eigen::Index>(i)) +=
        cost_of_leaving * (problem.target_mm.row(start[i]) / problem.tau_mm).cwiseMin(1.0);
  }
  auto solution = solve(problem, options, progress);
  if (!solution) return solution;
  problem.seed = own_seed;
  solution->energy = MatchingEnergy(problem)(solution->labels);
  return solution;
}

double orientation_kept(const Side& nodes, const Side& labels, const Labelling& labelling) {
  constexpr int neighbours = 8;
  const auto node_normals = geometry::point_normals(nodes.surface);
  const auto label_normals = geometry::point_normals(labels.surface);
  // How far a -> b -> c turns to the left about the outward normal at a, from -1 to 1; 0 for points in a line.
  const auto turn = [](const Side& side, const std::vector<Eigen::Vector3d>& normals, int a, int b, int c) {
    const Eigen::Vector3d& normal = normals[static_cast<std::size_t>(side.samples.points[static_cast<std::size_t>(a)])];
    const Eigen::Vector3d to_b = side.position_mm(b) - side.position_mm(a);
    const Eigen::Vector3d to_c = side.position_mm(c) - side.position_mm(a);
    const double lengths = to_b.norm() * to_c.norm();
    return lengths > 0 ? normal.dot(to_b.cross(to_c)) / lengths : 0.0;
  };
  const int count = static_cast<int>(labelling.size());
  std::vector<int> nearest(labelling.size());
  double kept = 0, total = 0;
  for (int a = 0; a < count; ++a) {
    std::iota(nearest.begin(), nearest.end(), 0);
    const int around = std::min(neighbours + 1, count);
    const auto distances_mm = nodes.samples.between_mm.row(a);
    std::partial_sort(nearest.begin(), nearest.begin() + around, nearest.end(),
                      [&](int x, int y) { return distances_mm(x) < distances_mm(y); });
    for (int i = 1; i < around; ++i) {
      for (int j = i + 1; j < around; ++j) {
        const int b = nearest[static_cast<std::size_t>(i)], c = nearest[static_cast<std::size_t>(j)];
        const auto label = [&](int node) { return labelling[static_cast<std::size_t>(node)]; };
        const double product =
            turn(nodes, node_normals, a, b, c) * turn(labels, label_normals, label(a), label(b), label(c));
        total += std::abs(product);
        if (product > 0) kept += product;
      }
    }
  }
  return total > 0 ? kept / total : 0.5;
}

}  // namespace
}  // namespace glisson::registration
