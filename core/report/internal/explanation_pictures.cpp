#include "report/internal/explanation_pictures.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "base/markup.h"
#include "base/result.h"
#include "closedloop/inference/posterior.h"
#include "report/plot.h"

namespace glisson::report {
namespace {

using closedloop::Explanation;
using closedloop::Observations;

// A moment of a trial, and what it left before.
struct Moment {
  int trial = 0;
  int sample = 0;
};

// Of measured points, of what was predicted before an effect was added, and after.
const PlotCurve measured_curve{{}, {}, PlotCurve::Style::dots, "currentColor"};
const PlotCurve before_curve{{}, {}, PlotCurve::Style::dashes, "#d55e00"};
const PlotCurve after_curve{{}, {}, PlotCurve::Style::line, "#0072b2"};

std::vector<Drawing> on_the_specimen(const Explanation& explanation, const Observations& observations,
                                     const Words& words);
std::vector<Drawing> as_curves(const Explanation& explanation, const Observations& observations, const Words& words);

}  // namespace

std::vector<Drawing> explanation_pictures(const Explanation& explanation, const Observations& observations,
                                          const Words& words) {
  return observations.has_places() ? on_the_specimen(explanation, observations, words)
                                   : as_curves(explanation, observations, words);
}

Drawing probability_bars(const closedloop::Posterior& posterior, const Words& words) {
  constexpr double width_px = 640, name_px = 340, bar_px = 230, line_px = 24;
  const std::size_t count =
      std::min<std::size_t>(8, posterior.size());  // what comes after is below a percent, or noise
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"probabilities\" viewBox=\"0 0 {:.0f} {:.0f}\" "
      "font-size=\"13\" fill=\"currentColor\" role=\"img\">",
      width_px, line_px * static_cast<double>(count) + 4);
  for (std::size_t i = 0; i < count; ++i) {
    const double top = line_px * static_cast<double>(i) + 4;
    svg += fmt::format("<text x=\"{:.0f}\" y=\"{:.0f}\" text-anchor=\"end\">{}</text>", name_px - 8, top + 14,
                       escaped_markup(explanation_name(posterior[i], words)));
    svg += fmt::format("<rect x=\"{:.0f}\" y=\"{:.0f}\" width=\"{:.1f}\" height=\"{:.0f}\" fill=\"#0072b2\"/>", name_px,
                       top, std::max(1.0, bar_px * posterior[i].probability), line_px - 6);
    svg += fmt::format("<text x=\"{:.1f}\" y=\"{:.0f}\">{:.1f} %</text>",
                       name_px + 6 + bar_px * posterior[i].probability, top + 14, 100 * posterior[i].probability);
  }
  return {svg + "</svg>",
          words.say(GLISSON_TEXT("Probability of each explanation, all that were weighed taken together"))};
}

Drawing probabilities_by_trials(const closedloop::PosteriorHistory& history, const Words& words) {
  constexpr std::size_t likeliest = 4;
  std::vector<std::string> names;
  for (const closedloop::PosteriorStep& step : history) {
    for (std::size_t i = 0; i < std::min(likeliest, step.posterior.size()); ++i) {
      const std::string name = explanation_name(step.posterior[i], words);
      if (std::count(names.begin(), names.end(), name) == 0) names.push_back(name);
    }
  }
  Plot plot{words.say(GLISSON_TEXT("How the probabilities went while trials were added")),
            words.say(GLISSON_TEXT("number of trials")), words.say(GLISSON_TEXT("probability (%)"))};
  for (const std::string& name : names) {
    PlotCurve curve{name, {}};
    for (const closedloop::PosteriorStep& step : history) {
      double percent = 0;
      for (const closedloop::WeighedExplanation& one : step.posterior)
        if (explanation_name(one, words) == name) percent = 100 * one.probability;
      curve.points.emplace_back(static_cast<double>(step.trials.size()), percent);
    }
    plot.curves.push_back(std::move(curve));
  }
  return {svg_of(plot), plot.caption};
}

std::string explanation_name(const closedloop::WeighedExplanation& weighed, const Words& words, bool quoted) {
  if (weighed.something_else) return words.say(GLISSON_TEXT("something else"));
  if (weighed.kinds.empty()) return words.say(GLISSON_TEXT("nothing is missing"));
  std::string name;
  for (const std::string& kind : weighed.kinds) {
    const std::string one = quoted ? words.quoted_effect(kind) : words.effect(kind);
    name = name.empty() ? one : words.say(GLISSON_TEXT("{0} and {1}"), {name, one});
  }
  return name;
}

namespace {

Moment worst_moment(const Explanation& explanation, const Observations& observations) {
  std::map<std::pair<int, int>, double> squares;
  for (Eigen::Index row = 0; row < observations.rows(); ++row) {
    const auto i = static_cast<std::size_t>(row);
    const double residual = observations.measured[row] - explanation.predicted_before[row];
    squares[{observations.trial[i], observations.sample[i]}] += residual * residual;
  }
  const auto worst = std::max_element(squares.begin(), squares.end(),
                                      [](const auto& a, const auto& b) { return a.second < b.second; });
  return {worst->first.first, worst->first.second};
}

// Published fields come without, and waves in noises.
bool has_units(const Observations& observations) { return observations.unit != "noise"; }
// Of plates the forces are measured too.
bool is_of_waves(const Observations& observations) {
  return !has_units(observations) &&
         std::count(observations.directions.begin(), observations.directions.end(), "fx") == 0;
}

// The two axes along which the places spread most.
std::array<int, 2> widest_axes(const Observations& observations) {
  const Eigen::RowVector3d extent =
      observations.place_mm.colwise().maxCoeff() - observations.place_mm.colwise().minCoeff();
  int narrowest = 0;
  extent.minCoeff(&narrowest);
  return {narrowest == 0 ? 1 : 0, narrowest == 2 ? 1 : 2};
}

struct Vector {
  Eigen::Vector3d place_mm;
  Eigen::Vector3d residual_mm{0, 0, 0};
};

std::vector<Vector> vectors_at(const Moment& moment, const Eigen::VectorXd& predicted,
                               const Observations& observations) {
  std::map<int, Vector> vectors;
  for (Eigen::Index row = 0; row < observations.rows(); ++row) {
    const auto i = static_cast<std::size_t>(row);
    if (observations.trial[i] != moment.trial || observations.sample[i] != moment.sample) continue;
    // A distance from a surface has no direction of its own, and a force is no displacement.
    const std::string& name = observations.directions[static_cast<std::size_t>(observations.direction[i])];
    if (observations.direction[i] > 2 || name == "fx") continue;
    Vector& vector = vectors[observations.point[i]];
    vector.place_mm = observations.place_mm.row(row).transpose();
    vector.residual_mm[observations.direction[i]] = observations.measured[row] - predicted[row];
  }
  std::vector<Vector> list;
  for (const auto& [point, vector] : vectors) list.push_back(vector);
  return list;
}

Drawing errors_by_load(const Explanation& explanation, const Observations& observations, const Words& words) {
  struct Sums {
    double load = 0, before = 0, after = 0, count = 0;
  };
  const bool of_waves = is_of_waves(observations);
  std::map<std::pair<int, int>, Sums> moments;
  for (Eigen::Index row = 0; row < observations.rows(); ++row) {
    const auto i = static_cast<std::size_t>(row);
    // Of waves a trial is one frequency, and moments are parts of its equation.
    Sums& sums = moments[of_waves ? std::pair(0, observations.trial[i])
                                  : std::pair(observations.trial[i], observations.sample[i])];
    sums.load = observations.load[row];
    sums.before += std::pow(observations.measured[row] - explanation.predicted_before[row], 2);
    sums.after += std::pow(observations.measured[row] - explanation.predicted_after[row], 2);
    sums.count += 1;
  }
  std::map<int, std::array<PlotCurve, 2>> curves_of_trial;
  for (const auto& [key, sums] : moments) {
    auto& [before, after] = curves_of_trial.try_emplace(key.first, std::array{before_curve, after_curve}).first->second;
    before.points.emplace_back(sums.load, std::sqrt(sums.before / sums.count));
    after.points.emplace_back(sums.load, std::sqrt(sums.after / sums.count));
  }
  if (of_waves) {
    for (PlotCurve& curve : curves_of_trial.begin()->second) std::sort(curve.points.begin(), curve.points.end());
  }
  Plot plot{words.say(of_waves ? GLISSON_TEXT("Error by frequency: broken before, whole after")
                               : GLISSON_TEXT("Error by load, a line a trial: broken before, whole after")),
            has_units(observations) ? words.say(GLISSON_TEXT("force (N)"))
            : of_waves              ? words.say(GLISSON_TEXT("frequency (Hz)"))
                                    : words.say(GLISSON_TEXT("largest strain")),
            of_waves ? words.say(GLISSON_TEXT("× noise"))
                     : words.say(GLISSON_TEXT("error ({0})"), {has_units(observations) ? observations.unit : "u, f"})};
  for (auto& [trial, both] : curves_of_trial) plot.curves.insert(plot.curves.end(), both.begin(), both.end());
  return {svg_of(plot), plot.caption};
}

// Root mean square of what is left at each place, all trials together.
std::map<std::array<double, 3>, double> left_by_place(const Eigen::VectorXd& predicted,
                                                      const Observations& observations) {
  std::map<std::array<double, 3>, std::pair<double, double>> sums;
  for (Eigen::Index row = 0; row < observations.rows(); ++row) {
    auto& [square, count] =
        sums[{observations.place_mm(row, 0), observations.place_mm(row, 1), observations.place_mm(row, 2)}];
    square += std::pow(observations.measured[row] - predicted[row], 2);
    count += 1;
  }
  std::map<std::array<double, 3>, double> left;
  for (const auto& [place, sum] : sums) left[place] = std::sqrt(sum.first / sum.second);
  return left;
}

// A disc a patch, of those that lie in one layer with the worst, as the declared law and the better model leave them.
std::vector<Drawing> where_it_holds(const Explanation& explanation, const Observations& observations,
                                    const Words& words) {
  const auto before = left_by_place(explanation.predicted_before, observations);
  const auto after = left_by_place(explanation.predicted_after, observations);
  const auto worst =
      std::max_element(before.begin(), before.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  const auto [across, up] = widest_axes(observations);
  const auto deep = static_cast<std::size_t>(3 - across - up);
  const double extent =
      (observations.place_mm.colwise().maxCoeff() - observations.place_mm.colwise().minCoeff()).maxCoeff();
  const auto drawn = [&, a = static_cast<std::size_t>(across), u = static_cast<std::size_t>(up)](
                         const std::map<std::array<double, 3>, double>& left, const char* caption) {
    constexpr const char* axes = "xyz";
    Plot plot{words.say(caption, {fmt::format("{:.3g}", worst->second)}), fmt::format("{} (mm)", axes[a]),
              fmt::format("{} (mm)", axes[u])};
    plot.hottest = worst->second;
    plot.from_zero = false;
    for (const auto& [place, rms] : left)
      if (std::abs(place.at(deep) - worst->first.at(deep)) < 0.1 * extent)
        plot.spots.push_back({place.at(a), place.at(u), 0.04 * extent, rms});
    return Drawing{svg_of(plot), plot.caption};
  };
  return {drawn(before, GLISSON_TEXT("Where the declared law does not hold: what it leaves in each patch, in noises (1 "
                                     "is noise alone; red at {0}); the worst layer")),
          drawn(after, GLISSON_TEXT("The same with the better model")),
          errors_by_load(explanation, observations, words)};
}

std::vector<Drawing> on_the_specimen(const Explanation& explanation, const Observations& observations,
                                     const Words& words) {
  if (is_of_waves(observations)) return where_it_holds(explanation, observations, words);
  const Moment moment = worst_moment(explanation, observations);
  const auto [across, up] = widest_axes(observations);
  const auto before = vectors_at(moment, explanation.predicted_before, observations);
  const auto after = vectors_at(moment, explanation.predicted_after, observations);
  double longest = 0;
  for (const Vector& vector : before) longest = std::max(longest, vector.residual_mm.norm());
  const Eigen::RowVector3d extent =
      observations.place_mm.colwise().maxCoeff() - observations.place_mm.colwise().minCoeff();
  const double magnification = longest > 0 ? 0.15 * std::max(extent[across], extent[up]) / longest : 1;
  const auto drawn = [&, a = across, u = up](const std::vector<Vector>& vectors, const char* caption) {
    constexpr const char* axes = "xyz";
    const char* mm = has_units(observations) ? " (mm)" : "";
    Plot plot{words.say(caption, {observations.trials[static_cast<std::size_t>(moment.trial)],
                                  fmt::format("{:.3g}", magnification), fmt::format("{:.3g}", longest)}),
              fmt::format("{}{}", axes[a], mm), fmt::format("{}{}", axes[u], mm)};
    plot.hottest = longest;
    plot.from_zero = false;
    for (const Vector& v : vectors)
      plot.arrows.push_back({v.place_mm[a], v.place_mm[u], magnification * v.residual_mm[a],
                             magnification * v.residual_mm[u], v.residual_mm.norm()});
    return Drawing{svg_of(plot), plot.caption};
  };
  if (!has_units(observations)) {
    return {
        drawn(before, GLISSON_TEXT("Residual before, trial {0} at its worst: arrows {1} times as long, red at {2}")),
        drawn(after, GLISSON_TEXT("Residual after, trial {0} at its worst: arrows {1} times as long, red at {2}")),
        errors_by_load(explanation, observations, words)};
  }
  return {drawn(before, GLISSON_TEXT("Residual before, trial {0} at its worst: arrows {1} times as long, red at {2} "
                                     "mm")),
          drawn(after, GLISSON_TEXT("Residual after, trial {0} at its worst: arrows {1} times as long, red at {2} "
                                    "mm")),
          errors_by_load(explanation, observations, words)};
}

// What a wearable computer tells, as its file calls it.
std::string reading(const std::string& direction, const Words& words) {
  return direction == "voltage_V"       ? words.say(GLISSON_TEXT("voltage (V)"))
         : direction == "temperature_C" ? words.say(GLISSON_TEXT("temperature (°C)"))
         : direction == "power_W"       ? words.say(GLISSON_TEXT("power (W)"))
                                        : direction;
}

std::vector<Drawing> as_curves(const Explanation& explanation, const Observations& observations, const Words& words) {
  constexpr std::size_t maximum_points = 150;  // a trial and line
  const bool material = observations.unit != "noise";
  std::vector<Drawing> drawings;
  for (std::size_t direction = 0; direction < observations.directions.size(); ++direction) {
    std::map<int, std::vector<Eigen::Index>> rows_of_trial;
    for (Eigen::Index row = 0; row < observations.rows(); ++row) {
      const auto i = static_cast<std::size_t>(row);
      if (observations.direction[i] == static_cast<int>(direction)) rows_of_trial[observations.trial[i]].push_back(row);
    }
    if (rows_of_trial.empty()) continue;
    const auto pictured = [&](bool against_load, bool residual, Plot plot) {
      for (const auto& [trial, rows] : rows_of_trial) {
        PlotCurve measured = measured_curve;
        PlotCurve before = before_curve;
        PlotCurve after = after_curve;
        for (std::size_t i = 0; i < rows.size(); i += 1 + rows.size() / maximum_points) {
          const Eigen::Index row = rows[i];
          const double x = against_load ? observations.load[row] : observations.time_s[row];
          const double from = residual ? observations.measured[row] : 0;
          const double sign = residual ? -1 : 1;
          if (!residual) measured.points.emplace_back(x, observations.measured[row]);
          before.points.emplace_back(x, sign * (explanation.predicted_before[row] - from));
          after.points.emplace_back(x, sign * (explanation.predicted_after[row] - from));
        }
        for (PlotCurve* curve : {&measured, &before, &after}) {
          if (!curve->points.empty()) plot.curves.push_back(std::move(*curve));
        }
      }
      plot.from_zero = false;
      return Drawing{svg_of(plot), plot.caption};
    };
    const std::string name =
        material ? words.say(GLISSON_TEXT("stress (kPa)")) : reading(observations.directions[direction], words);
    const std::string time = words.say(GLISSON_TEXT("time (s)"));
    drawings.push_back(pictured(material, false,
                                {words.say(GLISSON_TEXT("Measured (dots), before (broken), after (line)")),
                                 material ? words.say(GLISSON_TEXT("strain")) : time, name}));
    drawings.push_back(pictured(false, true,
                                {words.say(GLISSON_TEXT("What was left before (broken) and after (line)")), time,
                                 words.say(GLISSON_TEXT("residual: {0}"), {name})}));
  }
  return drawings;
}

}  // namespace
}  // namespace glisson::report
