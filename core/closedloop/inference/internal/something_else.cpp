#include "closedloop/inference/internal/something_else.h"

#include <algorithm>
#include <cmath>

#include "closedloop/inference/shaped_rest.h"
#include "closedloop/inference/smooth_rest.h"

namespace glisson::closedloop {
namespace {

Result<std::vector<double>> weights_by_shapes(const Weighing& weighing, const Eigen::MatrixXd& shapes,
                                              const Eigen::VectorXd& declared, const Weighed& leading,
                                              double of_nothing, const PosteriorOptions& options);
LocalFit thinned(LocalFit fit, double share);

}  // namespace

// Over the rows that a smooth function rests on, with the leading explanation on the same rows: in place of all causes,
// or at work beside the leading ones, which then have to be there too.
Result<std::vector<double>> weights_of_something_else(const Weighing& weighing, const Eigen::VectorXd& declared,
                                                      const Weighed& leading, double of_nothing,
                                                      const PosteriorOptions& options, const Progress& progress) {
  const ForwardModel& model = weighing.model;
  if (const Eigen::MatrixXd shapes = model.unlisted_shapes(); shapes.size() > 0)
    return weights_by_shapes(weighing, shapes, declared, leading, of_nothing, options);
  const auto smooth = [&](const Eigen::VectorXd& predicted) {
    return smooth_evidence(model.observations(), weighing.systematic, model.observations().measured - predicted,
                           options, weighing.worth, progress);
  };
  // What is no larger than the prediction's own error is no sign of anything.
  const auto beside = [&](const SmoothEvidence& rest, const Eigen::VectorXd& predicted) {
    const double better = rest.smooth - rest.noise;
    return excess(model.observations(), predicted) <= weighing.systematic.indistinct ? std::min(0.0, better) : better;
  };
  const double log_prior = std::log(options.something_else), half = std::log(0.5);
  const double log_odds = log_prior - std::log(1 - options.something_else);
  const SmoothEvidence in_place = smooth(declared);
  if (leading.kinds.empty()) return std::vector<double>{log_prior + of_nothing + beside(in_place, declared)};
  const auto predicted = model.predict(leading.fit.settings);
  if (!predicted) return failure(predicted.error());
  const SmoothEvidence rest = smooth(*predicted);
  // What the freedom of its parameters costs on these rows, as that of the smooth function is counted.
  const LogEvidence seen = log_evidence(model, thinned(leading.fit, rest.share_of_rows), weighing.correlation, options);
  return std::vector<double>{
      half + log_prior + leading.log.evidence + (seen.best - seen.evidence) + in_place.smooth - rest.noise,
      half + log_odds + leading.log_prior + leading.log.evidence + beside(rest, *predicted)};
}

double excess(const Observations& observations, const Eigen::VectorXd& predicted) {
  const double size = root_mean_square((observations.measured - predicted).cwiseQuotient(observations.noise));
  return std::sqrt(std::max(0.0, size * size - 1));
}

double root_mean_square(const Eigen::VectorXd& values) {
  return values.norm() / std::sqrt(static_cast<double>(values.size()));
}

namespace {

// The same over all rows, where the model says what shapes something else may have; and, as likely, that the leading
// explanation is the catalogue's nearest to something that is not in it. What such a likeness leaves is a share of what
// it changes, and a larger one than the mesh's own error.
Result<std::vector<double>> weights_by_shapes(const Weighing& weighing, const Eigen::MatrixXd& shapes,
                                              const Eigen::VectorXd& declared, const Weighed& leading,
                                              double of_nothing, const PosteriorOptions& options) {
  const Observations& observations = weighing.model.observations();
  const ShapedRest rest(observations, weighing.whitening.whiten(shapes), options);
  const auto left = [&](const Eigen::VectorXd& predicted) -> Eigen::VectorXd {
    return weighing.whitening.whiten(observations.measured - predicted);
  };
  const auto shown = [&](double log_odds, const Eigen::VectorXd& predicted) {
    return excess(observations, predicted) <= weighing.systematic.indistinct ? std::min(0.0, log_odds) : log_odds;
  };
  const auto in_noises = [&](const Eigen::VectorXd& values) {
    return root_mean_square(values.cwiseQuotient(observations.noise));
  };
  const Amplitude any{options.smooth_amplitude, options.smooth_amplitude_spread};
  const double log_prior = std::log(options.something_else), half = std::log(0.5);
  const double in_place = rest.log_odds(left(declared), any);
  if (leading.kinds.empty()) return std::vector<double>{log_prior + of_nothing + shown(in_place, declared)};
  const auto predicted = weighing.model.predict(leading.fit.settings);
  if (!predicted) return failure(predicted.error());
  const double change = in_noises(*predicted - declared);
  const double mesh = weighing.systematic.indistinct / std::max(1e-12, in_noises(declared)) * change;
  const double left_over =
      shown(rest.log_odds(left(*predicted), {options.likeness_leaves * change, options.likeness_leaves_spread},
                          {mesh, options.mesh_error_scale}),
            *predicted);
  const double of_leading = leading.log_prior + leading.log.evidence;
  const double log_odds = log_prior - std::log(1 - options.something_else);
  return std::vector<double>{half + log_prior + of_nothing + in_place,
                             std::log(options.likeness) + of_leading + left_over,
                             half + log_odds + of_leading + left_over};
}

// To a share of its rows, evenly from all.
LocalFit thinned(LocalFit fit, double share) {
  fit.chi2 *= share;
  fit.rows = static_cast<Eigen::Index>(std::lround(share * double(fit.rows)));
  fit.downhill *= share;
  fit.information *= share;
  return fit;
}

}  // namespace
}  // namespace glisson::closedloop
