#pragma once
// What a diagnosis is strict about: every threshold of the search, of the evidence and of what is told, each with its
// reason. Chi-squared and promises are in units of the noise; "excess" is the root mean square by which a residual
// exceeds the noise.

#include <array>
#include <cstddef>

namespace glisson::closedloop {

// How effects are looked for. Most of it says where fits, which may take many solves, are not worth their time.
struct SearchOptions {
  // A solve can take seconds: every candidate gets so many steps, and only those near the best go on to the end.
  int first_iterations = 5;
  int first_iterations_where_quick = 15;  // where a prediction takes so little that more steps cost nothing
  double near_the_best = 1.5;             // within this factor of the smallest chi-squared the order may still change
  std::size_t searches_per_effect = 2;    // from the starts of smallest error: each further one costs a whole fit
  double hopeless_start = 0.1;            // one that is ten times as far off as another has ended is not fitted

  // Shares of what the best candidate takes of the error, to first order.
  double minimum_promise = 0.3;        // what promises far less than the best is not fitted
  double promise_for_slow_form = 0.6;  // slow forms are tried where a quick form of their kind does about as well
  // Half of what a finer mesh may change, squared: less cannot be told from the mesh's own error.
  double promise_over_mesh_error = 0.25;

  // From the third effect on, one that leaves more than this share of the excess names nothing.
  double excess_after_third_effect = 0.8;
  // ... and one that promises less than half of the square that this would take is not fitted.
  [[nodiscard]] double promise_of_third_effect() const {
    return 0.5 * (1 - excess_after_third_effect * excess_after_third_effect);
  }
  // Two effects that leave more than this share of the excess are no explanation that a third would complete.
  double excess_worth_a_third_effect = 0.7;

  // First-order refits hold while parameters move little: above this factor of the fit's chi-squared they are made
  // anew.
  double beyond_first_order = 1.3;
  double clearly_worse_left_out = 1.25;     // of chi-squared: an effect whose absence costs so much on trials stays
  double exit_bic_share = 0.5;              // of entry_bic: lower than at entry, so that none goes in and out for ever
  double gain_beyond_luck = 5;              // of chi-squared on trials left out, in units of what the fit leaves
  double end_of_range = 1e-6;               // of a parameter's range: the tolerance of fits that end at a bound
  std::size_t forms_per_kind_in_pairs = 2;  // the number of pairs to fit grows with the square of the forms

  // Each effect against the others in its place.
  std::size_t swap_rounds = 3;      // two effects may go on swapping for ever
  double excess_worth_swaps = 0.5;  // what leaves more than half of the error is no explanation, whatever its effects
  double swap_bic = 2;              // "positive" evidence on Kass and Raftery's scale
  double about_as_well_left_out = 1.1;  // of chi-squared: one of fewer numbers may lose so much on trials left out
};

// What speaks for a set of effects.
struct EvidenceOptions {
  double top_load = 0.9;  // trials beyond this share of the largest load are left out together: a tenth is another load
  int refit_iterations = 3;                      // from where the first order leads there is little left to go
  int refit_iterations_where_quick = 10;         // where more steps cost nothing
  double maximum_share_of_expected_error = 1.5;  // the size of the mesh's error is known roughly, from one finer mesh
  int resamplings_of_error = 1000;               // 25 lie beyond each end of the interval
  int resamplings_of_parameters = 400;           // 10 do; each takes a small solve
  double resampling_prior = 1e-6;  // weakest of priors: keeps a resampling solvable that drew one trial again and again
};

// What is believed before anything is measured, and how far evidence is carried. Probabilities that add up to 1: of
// nothing, of something else, and the rest of known causes. Sets of as many causes have equal shares, and so have the
// forms of a kind.
struct PosteriorOptions {
  double nothing_missing = 0.3;  // models are declared to be right, and a good third of them pass
  double something_else = 0.2;   // catalogues are never complete: of effects made outside of ours, about one in four
  double two_causes = 0.2;       // of the known: two that act at once are rarer than one, and far more numerous
  double three_causes = 0.03;    // ... three again

  // An effect's parameters are normal, within the bounds of the search. The mean is the middle of where a surgeon would
  // expect them (Parameter::prior_low and prior_high). Half of that range is this many standard deviations.
  double deviations_to_prior_end = 1;
  // Standard deviation of the logarithm of the noise over the stated one: people know theirs to about a tenth. Some
  // state it roughly, or forget that one value in a hundred is wild.
  double noise_scale = 0.1;
  double rough_noise_scale = 0.3;
  double roughly_stated = 0.3;  // probability
  // ... of the logarithm of the mesh's error over the expected one, which one finer mesh shows roughly.
  double mesh_error_scale = 0.4;
  // Beside something else the noise may be any number of times as large, for it may be what is wrong. With half of the
  // probability it lies within this logarithm of the stated one; the tail is Cauchy's. It is no smaller than one would
  // state it: a shape that lies below the stated noise is no sign of anything.
  double unknown_noise_scale = 0.5;
  double noise_alone = 0.2;  // of something else: noise of that size, and no shape
  // That errors repeat themselves from sample to sample, which nobody states; and how much of each the next one keeps.
  double noise_repeats = 0.2;
  std::array<double, 4> noise_kept{0.3, 0.5, 0.7, 0.9};

  // The smooth function that stands for something else: normal logarithms of its amplitude, in noises, and of its
  // lengths, in spreads of each feature.
  double smooth_amplitude = 3;           // what draws attention is some noises large,
  double smooth_amplitude_spread = 1.2;  // a third to ten of them
  double smooth_length = 1.5;            // longer than the data reach: what does not depend on a feature
  double smooth_length_spread = 1;       // from ripples of half a spread to straight lines
  std::size_t smooth_rows = 240;         // its cost grows with their cube

  // What looks like a cause may be something else that resembles it, as a job in the background resembles static power.
  // These are the odds against the likeliest cause, while its evidence over nothing is no more than so many nats.
  // Beyond that they fall as its inverse. And beside nothing something may be too weak to show. Both chosen on
  // generated cases (docs/closed-loop.md).
  double look_alike = 1;
  double look_alike_nats = 16;
  double too_weak_to_show = 0.1;

  // Where a model says what shapes something else may have (ForwardModel::unlisted_shapes): the odds against the
  // likeliest cause that it is a mere likeness whose rest shows. A likeness leaves half of what it changes, give or
  // take a factor of two. Chosen on palpations of seeds 1, 50640 and 18081 (docs/closed-loop.md).
  double likeness = 0.5;
  double likeness_leaves = 0.5;
  double likeness_leaves_spread = 0.7;  // of the logarithm

  double worth_refining = 15;    // nats below the best: less than one in a million, and no matter how exactly
  double refined_enough = 0.2;   // standard deviations from the maximum of the posterior: a fiftieth of a nat
  int refinements = 5;           // of Gauss and Newton; more is another maximum
  double worth_telling = 0.001;  // of probability
};

// What an experiment could have shown (visible.h).
struct VisibleOptions {
  double power = 0.9;          // the usual one of a study that wants to miss little
  double first_way = 0.02;     // of the range that a surgeon would expect: where effects are still small
  double close_enough = 0.05;  // of the way: the noise itself is known no better
  int tries = 3;               // each takes a solve
  int tries_where_quick = 10;
};

// Which trials are proposed (next_trial.h).
struct NextTrialOptions {
  std::size_t trials = 3;        // a lab seldom plans further ahead
  std::size_t compared = 6;      // explanations: each takes a solve of all trials
  double stands = 0.01;          // of probability: what is less is no alternative
  double unknown_stands = 0.05;  // of "something else", which is never quite ruled out
  double minimum_doubt = 0.03;   // nats: one of two explanations has 99.5 %
  double worth_a_trial = 0.1;    // of the doubt, expected to go with it
  double about_as_good = 0.03;   // of the doubt: then the simpler trial is made
  int draws = 200;               // an explanation: the information is known to some hundredths of it
};

// What the mistakes of a verdict cost (verdict.h), in units of known causes that are left without a name. So causes are
// named from a probability of about three quarters on, and something else is told where it is five times as probable
// as nothing.
struct VerdictCosts {
  double unnamed = 1;       // unexplained, though known causes act
  double overlooked = 2;    // nothing missing, though something acts
  double wrong_name = 3;    // explained by what does not act: someone builds on it
  double false_alarm = 10;  // unexplained, though nothing is missing: nobody listens to the next one
};

struct DiagnosisOptions {
  double entry_bic = 10;  // "very strong" evidence on Kass and Raftery's scale (1995), over a score of candidates
  double alike_bic = 10;  // what less than that cannot tell apart
  std::size_t maximum_effects = 3;
  // What acts beside named causes does not matter where it is no larger than the noise: by so much may what is left
  // exceed it. Shared among the effects: the more they are, the closer they must come.
  double near_noise_excess = 0.15;
  double maximum_noise_excess =
      0.5;                    // above it causes do not explain what was measured: noise is not stated that badly
  double worth_naming = 0.8;  // of the error on trials left out: above it a partial explanation helps nobody

  int trials_to_resample = 4;          // with fewer, resampling says nothing of the scatter between trials
  double undetermined = 0.5;           // of the prior width: a wider deviation is what was known before
  double told_at_end_of_range = 1e-3;  // of the range: a person takes the value for the limit
  double inseparable = 0.95;           // correlation of two parameters: a tenth of the variance is each one's own
  double clear_separation = 4;         // standard deviations by which a further trial should tell alternatives apart

  VerdictCosts costs;
  SearchOptions search;
  EvidenceOptions evidence;
  PosteriorOptions posterior;
  VisibleOptions visible;
  NextTrialOptions next_trial;
};

}  // namespace glisson::closedloop
