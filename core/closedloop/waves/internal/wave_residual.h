#pragma once
// What is left of the weak forms of a field of waves under a law with effects: white noise of variance 1 where it is
// right.

#include <Eigen/Cholesky>
#include <vector>

#include "base/result.h"
#include "base/sentence.h"
#include "closedloop/waves/internal/inhomogeneity.h"
#include "closedloop/waves/internal/long_waves.h"
#include "closedloop/waves/internal/moments.h"
#include "closedloop/waves/internal/wave_state.h"

namespace glisson::closedloop {

// A frequency, ready to be judged.
struct TrialForms {
  TestFunctions functions;
  std::vector<Patch> patches;
  Moments moments;
  Eigen::MatrixXcd plain;  // the moments as they were measured
  Fields fields;
  RegionForms regions;
  std::vector<LongWaves> long_waves;  // of each of long_wave_forms; none where they are no effect
  // What they leave under the declared law, which most effects leave as it is, and the root of its Gram matrix.
  std::vector<Eigen::MatrixXcd> declared_shapes;
  std::vector<Eigen::LLT<Eigen::MatrixXcd>> declared_normals;
  double frequency_Hz = 0, noise = 0;
  Eigen::Index first_row = 0;
};

class WaveResidual {
 public:
  explicit WaveResidual(Elastography waves);
  // Fails as wave_model() does; `remarks` gets what was assumed.
  Result<void> prepare(std::vector<Sentence>& remarks);

  [[nodiscard]] const Elastography& waves() const { return waves_; }
  [[nodiscard]] const WeakForms& forms() const { return forms_; }
  [[nodiscard]] const std::vector<TrialForms>& trials() const { return trials_; }
  [[nodiscard]] Eigen::Index rows() const;
  // Of a patch: by group of test functions, real and imaginary part, component.
  [[nodiscard]] Eigen::Index rows_of_patch() const { return Eigen::Index{2} * forms_.count(); }
  [[nodiscard]] Eigen::Index rows_of(const TrialForms& trial) const {
    return static_cast<Eigen::Index>(trial.patches.size()) * rows_of_patch();
  }

  // A number a row, in noises.
  [[nodiscard]] Eigen::VectorXd left(const WaveState& state) const;
  // What the test functions themselves see of the fields, less what shares its noise with left({}).
  [[nodiscard]] Eigen::VectorXd seen() const;

 private:
  Result<void> add_trial(const WaveTrial& trial, std::vector<Sentence>& remarks);
  void measure_depths();
  [[nodiscard]] Eigen::MatrixXcd left_of(const TrialForms& trial, const WaveState& state) const;
  [[nodiscard]] Eigen::MatrixXcd seen_of(const TrialForms& trial) const;
  [[nodiscard]] Eigen::MatrixXcd whitened(const TrialForms& trial, const Medium& medium) const;
  void without_long_waves(const TrialForms& trial, const WaveState& state, const Eigen::MatrixXcd& white,
                          Eigen::MatrixXcd& values) const;
  void with_region(const TrialForms& trial, const WaveState& state, const Medium& medium,
                   const std::vector<double>& phase, const Eigen::MatrixXcd& moments, Eigen::MatrixXcd& values) const;
  void put(const TrialForms& trial, const Eigen::MatrixXcd& values, Eigen::VectorXd& rows) const;

  // Where a patch lies to the region of a stiffness of its own.
  enum class Lies { outside, inside, across };
  [[nodiscard]] Lies lies(const TrialForms& trial, const Patch& patch, const WaveState& state) const;
  [[nodiscard]] Region region_of(const WaveState& state) const;
  [[nodiscard]] double width_mm() const { return waves_.grid.spacing_mm.mean(); }

  Elastography waves_;
  WeakForms forms_;
  std::vector<TrialForms> trials_;
  std::vector<float> depth_mm_;  // of each voxel below the region's border
};

}  // namespace glisson::closedloop
