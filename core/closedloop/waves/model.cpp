#include "closedloop/waves/model.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "closedloop/waves/internal/wave_effects.h"
#include "closedloop/waves/internal/wave_residual.h"

namespace glisson::closedloop {
namespace {

class WaveModel : public ForwardModel {
 public:
  explicit WaveModel(Elastography waves) : residual_(std::move(waves)) {}
  Result<void> prepare();

  [[nodiscard]] const Observations& observations() const override { return observations_; }
  [[nodiscard]] const std::vector<Effect>& catalogue() const override { return catalogue_; }
  [[nodiscard]] Result<Eigen::VectorXd> predict(const Settings& settings) const override {
    return Eigen::VectorXd(base_ - residual_.left(state_of(settings)));
  }
  // A prediction takes a hundredth of a second at most, but an inclusion's fit some hundred of them.
  [[nodiscard]] bool predicts_quickly() const override { return false; }
  [[nodiscard]] SystematicUncertainty systematic_uncertainty() const override { return systematic_; }
  [[nodiscard]] std::vector<Start> starts(const Effect& effect, const Settings& active,
                                          const Eigen::VectorXd& residual) const override;
  [[nodiscard]] std::vector<Sentence> remarks() const override { return remarks_; }

 private:
  void make_observations();
  void doubt_sums();

  WaveResidual residual_;
  Observations observations_;
  Eigen::VectorXd base_;  // measured
  SystematicUncertainty systematic_;
  std::vector<Effect> catalogue_;
  std::vector<Sentence> remarks_;
};

}  // namespace

Result<std::unique_ptr<ForwardModel>> wave_model(Elastography waves) {
  auto model = std::make_unique<WaveModel>(std::move(waves));
  if (auto prepared = model->prepare(); !prepared) return failure(std::move(prepared.error()));
  return model;
}

namespace {

Result<void> WaveModel::prepare() {
  if (auto prepared = residual_.prepare(remarks_); !prepared) return prepared;
  make_observations();
  doubt_sums();
  const std::vector<TrialForms>& trials = residual_.trials();
  Eigen::Vector3d low = trials.front().patches.front().place_mm, high = low;
  double radius = 0;
  for (const TrialForms& trial : trials) {
    for (const Patch& patch : trial.patches) {
      low = low.cwiseMin(patch.place_mm);
      high = high.cwiseMax(patch.place_mm);
    }
    radius += trial.functions.radius()[0] * residual_.waves().grid.spacing_mm[0] / static_cast<double>(trials.size());
  }
  const Eigen::Vector3d beyond = Eigen::Vector3d::Constant(0.7 * radius);
  catalogue_ = wave_effects(residual_.waves(), radius, low - beyond, high + beyond);
  return {};
}

void WaveModel::make_observations() {
  observations_.unit = "noise";
  observations_.directions = residual_.waves().components;
  const auto components = static_cast<int>(residual_.waves().components.size());
  base_ = residual_.seen() + residual_.left({});
  const std::vector<TrialForms>& trials = residual_.trials();
  std::vector<Observation> rows;
  int point = 0;
  for (std::size_t t = 0; t < trials.size(); ++t) {
    observations_.trials.push_back(residual_.waves().trials[t].id);
    for (const Patch& patch : trials[t].patches) {
      for (int moment = 0; moment < 2 * residual_.forms().groups(); ++moment, ++point) {
        for (int component = 0; component < components; ++component) {
          Observation row;
          row.measured = base_[static_cast<Eigen::Index>(rows.size())];
          row.noise = 1;
          row.trial = static_cast<int>(t);
          row.sample = moment;
          row.direction = component;
          row.point = point;
          row.load = trials[t].frequency_Hz;
          row.place_mm = patch.place_mm;
          rows.push_back(row);
        }
      }
    }
  }
  observations_.add(rows);
}

// Sums over voxels stand for integrals: of each frequency the modulus seen is off by so much, and its loss.
void WaveModel::doubt_sums() {
  constexpr double step = 1e-3, off = 0.002, off_where_coarse = 0.02;
  const Eigen::VectorXd here = residual_.left({});
  WaveState stiffer, lossy;
  stiffer.factor += step;
  lossy.viscosity = Setting{"viscosity", "structural", Eigen::VectorXd::Constant(1, step)};
  const bool elastic = residual_.waves().declared.law == WaveLaw::elastic;
  const Eigen::MatrixXd changes =
      (Eigen::MatrixXd(here.size(), elastic ? 2 : 1) << residual_.left(stiffer) - here,
       elastic ? Eigen::MatrixXd(residual_.left(lossy) - here) : Eigen::MatrixXd(here.size(), 0))
          .finished() /
      step;
  systematic_.directions =
      Eigen::MatrixXd::Zero(here.size(), changes.cols() * static_cast<Eigen::Index>(residual_.trials().size()));
  Eigen::Index column = 0;
  for (const TrialForms& trial : residual_.trials()) {
    const auto& radius = trial.functions.radius();
    const bool coarse = std::any_of(radius.begin(), radius.end(), [](int r) { return r == 4 || r == 5; });
    const Eigen::Index rows = residual_.rows_of(trial);
    for (const auto& change : changes.colwise())
      systematic_.directions.col(column++).segment(trial.first_row, rows) =
          (coarse ? off_where_coarse : off) * change.segment(trial.first_row, rows);
  }
}

// Balls about patches that would take most of the residual to first order, each with the ratio that does.
std::vector<Start> WaveModel::starts(const Effect& effect, const Settings& active,
                                     const Eigen::VectorXd& residual) const {
  if (effect.kind != "stiff-inclusion") return ForwardModel::starts(effect, active, residual);
  constexpr double step = 1e-3;
  WaveState stiffer = state_of(active);
  stiffer.factor *= 1 + step;
  const Eigen::VectorXd by_stiffness = (residual_.left(stiffer) - residual) / step;
  struct Sums {
    Eigen::Vector3d place_mm;
    double along = 0, square = 0;
  };
  std::vector<Sums> patches;
  for (const TrialForms& trial : residual_.trials()) {
    Eigen::Index row = trial.first_row;
    for (const Patch& patch : trial.patches) {
      const auto derivative = by_stiffness.segment(row, residual_.rows_of_patch());
      patches.push_back({patch.place_mm, -derivative.dot(residual.segment(row, residual_.rows_of_patch())),
                         derivative.squaredNorm()});
      row += residual_.rows_of_patch();
    }
  }
  struct Ball {
    Eigen::VectorXd values;
    double taken = 0;
  };
  std::vector<Ball> balls;
  const Parameter& range = effect.parameters[3];
  for (const Sums& middle : patches) {
    for (const double times : {0.6, 1.0, 1.6, 2.4, 3.5}) {
      const double radius = std::clamp(times * range.no_effect, range.lower, range.upper);
      double along = 0, square = 0;
      for (const Sums& patch : patches) {
        const double distance = (patch.place_mm - middle.place_mm).norm();
        const double share = std::clamp((radius - distance) / range.no_effect + 0.5, 0.0, 1.0);
        along += share * patch.along;
        square += share * share * patch.square;
      }
      if (square <= 0) continue;
      Ball ball{Eigen::VectorXd(5), along * along / square};
      ball.values << middle.place_mm, radius, std::exp(std::clamp(along / square, -1.2, 1.2));
      for (int axis = 0; axis < 3; ++axis) {
        const Parameter& bounds = effect.parameters[static_cast<std::size_t>(axis)];
        ball.values[axis] = std::clamp(ball.values[axis], bounds.lower, bounds.upper);
      }
      balls.push_back(std::move(ball));
    }
  }
  std::stable_sort(balls.begin(), balls.end(), [](const Ball& a, const Ball& b) { return a.taken > b.taken; });
  std::vector<Start> starts;
  for (const Ball& ball : balls) {
    constexpr std::size_t tried = 6;
    const bool is_new = std::none_of(starts.begin(), starts.end(), [&](const Start& start) {
      return (start.values.head<3>() - ball.values.head<3>()).norm() < range.no_effect &&
             std::abs(std::log(start.values[3] / ball.values[3])) < 0.3;
    });
    if (is_new) starts.push_back({ball.values});
    if (starts.size() == tried) break;
  }
  return starts;
}

}  // namespace
}  // namespace glisson::closedloop
