#include "closedloop/inference/fit.h"

#include <ceres/ceres.h>
#include <glog/logging.h>

#include <algorithm>
#include <cmath>
#include <Eigen/Eigenvalues>
#include <numeric>
#include <utility>

namespace glisson::closedloop {
namespace {

// The search runs over logarithms of logarithmic parameters, and over the others in units of their prior width, so that
// one trust region fits all.
struct SearchSpace {
  ParameterRanges ranges;

  [[nodiscard]] bool logarithmic(Eigen::Index p) const {
    return ranges.scales[static_cast<std::size_t>(p)] == Scale::logarithmic;
  }
  [[nodiscard]] double inward(Eigen::Index p, double value) const {
    return logarithmic(p) ? std::log(value) : value / ranges.prior_width[p];
  }
  [[nodiscard]] double outward(Eigen::Index p, double x) const {
    return std::clamp(logarithmic(p) ? std::exp(x) : x * ranges.prior_width[p], ranges.lower[p], ranges.upper[p]);
  }
  // d value / d x
  [[nodiscard]] double slope(Eigen::Index p, double value) const {
    return logarithmic(p) ? value : ranges.prior_width[p];
  }
  [[nodiscard]] Eigen::VectorXd outward(const double* x) const {
    Eigen::VectorXd values(ranges.lower.size());
    for (Eigen::Index p = 0; p < values.size(); ++p) values[p] = outward(p, x[p]);
    return values;
  }
};

class WhiteResidual : public ceres::CostFunction {
 public:
  WhiteResidual(const ForwardModel& model, const Settings& settings, const Whitening& whitening, SearchSpace space)
      : model_(model), settings_(settings), whitening_(whitening), space_(std::move(space)) {
    set_num_residuals(static_cast<int>(whitening.rows().size()));
    mutable_parameter_block_sizes()->push_back(static_cast<int>(parameter_count(settings)));
  }

  bool Evaluate(const double* const* parameters, double* residuals, double** jacobians) const override {
    const Eigen::VectorXd values = space_.outward(parameters[0]);
    const Eigen::VectorXd& measured = model_.observations().measured;
    const auto rows = static_cast<Eigen::Index>(whitening_.rows().size());
    // A step that is only tried may be refused: its slopes, which cost the most, are computed where it is taken.
    if (jacobians == nullptr || jacobians[0] == nullptr) {
      const auto predicted =
          known(values) ? Result<Eigen::VectorXd>(linear_.predicted) : model_.predict(with_values(settings_, values));
      if (!predicted) return false;
      Eigen::Map<Eigen::VectorXd>(residuals, rows) = whitening_.whiten(*predicted - measured);
      return Eigen::Map<Eigen::VectorXd>(residuals, rows).allFinite();
    }
    const Linearisation* linear = at(values);
    if (linear == nullptr) return false;
    Eigen::Map<Eigen::VectorXd>(residuals, rows) = whitening_.whiten(linear->predicted - measured);
    using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    Eigen::Map<RowMajor> jacobian(jacobians[0], rows, values.size());
    jacobian = whitening_.whiten(linear->derivatives);
    for (Eigen::Index p = 0; p < values.size(); ++p) jacobian.col(p) *= space_.slope(p, values[p]);
    return jacobian.allFinite() && Eigen::Map<Eigen::VectorXd>(residuals, rows).allFinite();
  }

  const Linearisation* at(const Eigen::VectorXd& values) const {
    if (!known(values)) {
      auto linear = model_.linearise(with_values(settings_, values));
      if (!linear) return nullptr;
      values_ = values;
      linear_ = std::move(*linear);
    }
    return &linear_;
  }

 private:
  [[nodiscard]] bool known(const Eigen::VectorXd& values) const {
    return values_.size() == values.size() && values_ == values;
  }

  mutable Eigen::VectorXd values_;
  mutable Linearisation linear_;
  const ForwardModel& model_;
  const Settings& settings_;
  const Whitening& whitening_;
  SearchSpace space_;
};

// What Ceres has to say of a step that fails is in its summary, which is read. It would also go to stderr, where the
// log is the program's: nothing below what ends the program is let through.
void keep_ceres_quiet() {
  static const bool once = [] {
    FLAGS_minloglevel = google::GLOG_FATAL;
    return true;
  }();
  static_cast<void>(once);
}

// Ends the search when it is cancelled, and where a step is refused that hardly changes anything: Ceres would try ever
// smaller ones.
class StopEarly : public ceres::IterationCallback {
 public:
  StopEarly(const Progress& progress, double relative_tolerance)
      : progress_(progress), relative_tolerance_(relative_tolerance) {}
  ceres::CallbackReturnType operator()(const ceres::IterationSummary& step) override {
    if (progress_.cancelled()) return ceres::SOLVER_ABORT;
    const bool refused = step.iteration > 0 && step.step_is_valid && !step.step_is_successful;
    return refused && std::abs(step.cost_change) < relative_tolerance_ * step.cost
               ? ceres::SOLVER_TERMINATE_SUCCESSFULLY
               : ceres::SOLVER_CONTINUE;
  }

 private:
  const Progress& progress_;
  double relative_tolerance_;
};

}  // namespace

Result<Fit> without_fitting(const ForwardModel& model, const Settings& settings, const Whitening& whitening) {
  auto linear = model.linearise(settings);
  if (!linear) return failure(std::move(linear.error()));
  Fit fit{settings, std::move(linear->predicted), std::move(linear->derivatives), {}, 0, true};
  fit.white = whitening.whiten(model.observations().measured - fit.predicted);
  fit.chi2 = fit.white.squaredNorm();
  return fit;
}

Result<Fit> fit(const ForwardModel& model, const Settings& start, const Whitening& whitening, const FitOptions& options,
                const Progress& progress) {
  if (parameter_count(start) == 0) return without_fitting(model, start, whitening);
  const SearchSpace space{ranges_of(model, start)};
  const Eigen::VectorXd begin = values_of(start);
  std::vector<double> x(static_cast<std::size_t>(begin.size()));
  ceres::Problem problem;
  auto* const residual = new WhiteResidual(model, start, whitening, space);  // the problem's from here
  problem.AddResidualBlock(residual, nullptr, x.data());
  for (Eigen::Index p = 0; p < begin.size(); ++p) {
    const auto i = static_cast<int>(p);
    x[static_cast<std::size_t>(p)] =
        space.inward(p, std::clamp(begin[p], space.ranges.lower[p], space.ranges.upper[p]));
    problem.SetParameterLowerBound(x.data(), i, space.inward(p, space.ranges.lower[p]));
    problem.SetParameterUpperBound(x.data(), i, space.inward(p, space.ranges.upper[p]));
  }
  StopEarly stop(progress, options.relative_tolerance);
  ceres::Solver::Options solver;
  solver.linear_solver_type = ceres::DENSE_QR;
  solver.max_num_iterations = options.maximum_iterations;
  solver.function_tolerance = options.relative_tolerance;
  solver.max_num_consecutive_invalid_steps = 10;
  solver.logging_type = ceres::SILENT;
  solver.callbacks.push_back(&stop);
  keep_ceres_quiet();
  ceres::Solver::Summary summary;
  ceres::Solve(solver, &problem, &summary);
  if (progress.cancelled()) return cancelled();
  if (!summary.IsSolutionUsable())
    return failure("fit-failed", GLISSON_TEXT("The search for parameters failed: {0}."), {summary.message});
  const Eigen::VectorXd values = space.outward(x.data());
  const Linearisation* linear = residual->at(values);
  if (linear == nullptr)
    return failure("fit-failed", GLISSON_TEXT("The model has no solution where the search ended."));
  Fit found{with_values(start, values),
            linear->predicted,
            linear->derivatives,
            {},
            0,
            summary.termination_type == ceres::CONVERGENCE || summary.termination_type == ceres::USER_SUCCESS};
  found.white = whitening.whiten(model.observations().measured - found.predicted);
  found.chi2 = found.white.squaredNorm();
  return found;
}

Eigen::VectorXd first_order_change(const Fit& fit, const Eigen::VectorXd& measured, const Whitening& whitening) {
  const Eigen::MatrixXd jacobian = whitening.whiten(fit.derivatives);
  const Eigen::VectorXd residual = whitening.whiten(measured - fit.predicted);
  const Eigen::VectorXd scale = jacobian.colwise().norm().transpose().cwiseMax(1e-300);
  const Eigen::MatrixXd scaled = jacobian * scale.cwiseInverse().asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(scaled.transpose() * scaled);
  constexpr double undetermined = 1e-9;
  const Eigen::VectorXd inverse =
      eigen.eigenvalues().unaryExpr([](double value) { return value > undetermined ? 1 / value : 0.0; });
  const Eigen::VectorXd along = eigen.eigenvectors().transpose() * (scaled.transpose() * residual);
  return scale.cwiseInverse().asDiagonal() * (eigen.eigenvectors() * inverse.cwiseProduct(along));
}

Eigen::MatrixXd covariance(const Eigen::MatrixXd& white_derivatives, const Eigen::VectorXd& widest) {
  // In units of `widest`, with the information of a measurement of every parameter that is as poor as that.
  const Eigen::MatrixXd scaled = white_derivatives * widest.asDiagonal();
  const Eigen::MatrixXd information =
      scaled.transpose() * scaled + Eigen::MatrixXd::Identity(widest.size(), widest.size());
  return widest.asDiagonal() * information.inverse() * widest.asDiagonal();
}

std::vector<Eigen::Index> rows_of(const Observations& observations, const std::vector<bool>& trials) {
  std::vector<Eigen::Index> rows;
  for (Eigen::Index row = 0; row < observations.rows(); ++row) {
    const int trial = observations.trial[static_cast<std::size_t>(row)];
    if (trials[static_cast<std::size_t>(trial)]) rows.push_back(row);
  }
  return rows;
}

std::vector<Eigen::Index> all_rows(const Observations& observations) {
  std::vector<Eigen::Index> rows(static_cast<std::size_t>(observations.rows()));
  std::iota(rows.begin(), rows.end(), Eigen::Index{0});
  return rows;
}

ParameterRanges ranges_of(const ForwardModel& model, const Settings& settings) {
  ParameterRanges ranges;
  const Eigen::Index count = parameter_count(settings);
  ranges.lower.resize(count);
  ranges.upper.resize(count);
  ranges.prior_width.resize(count);
  Eigen::Index at = 0;
  for (const Setting& setting : settings) {
    const Effect* effect = effect_of(model, setting);
    GLISSON_ASSERT(effect != nullptr);
    for (const Parameter& parameter : effect->parameters) {
      ranges.lower[at] = parameter.lower;
      ranges.upper[at] = parameter.upper;
      ranges.prior_width[at] = parameter.prior_high - parameter.prior_low;
      ranges.scales.push_back(parameter.scale);
      ranges.names.push_back(parameter.name);
      ++at;
    }
  }
  return ranges;
}

Eigen::VectorXd values_of(const Settings& settings) {
  Eigen::VectorXd values(parameter_count(settings));
  Eigen::Index at = 0;
  for (const Setting& setting : settings) {
    values.segment(at, setting.parameters.size()) = setting.parameters;
    at += setting.parameters.size();
  }
  return values;
}

Settings with_values(Settings settings, const Eigen::VectorXd& values) {
  Eigen::Index at = 0;
  for (Setting& setting : settings) {
    setting.parameters = values.segment(at, setting.parameters.size());
    at += setting.parameters.size();
  }
  return settings;
}

}  // namespace glisson::closedloop
