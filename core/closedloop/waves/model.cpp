#include "closedloop/waves/model.h"

#include <algorithm>
#include <cmath>
#include <Eigen/Cholesky>
#include <numbers>
#include <utility>

#include "closedloop/waves/internal/inhomogeneity.h"
#include "closedloop/waves/internal/long_waves.h"
#include "closedloop/waves/internal/moments.h"
#include "closedloop/waves/internal/wave_state.h"
#include "imaging/filters.h"

namespace glisson::closedloop {
namespace {

constexpr double radius_in_wavelengths = 0.5;  // of a bump: the weak form then answers most to its own wave

// A frequency, ready to be judged.
struct TrialForms {
  TestFunctions functions;
  std::vector<Patch> patches;
  Moments moments;
  Eigen::MatrixXcd plain;  // the moments as they were measured
  std::vector<std::vector<std::complex<float>>> fields;
  RegionForms regions;
  std::vector<LongWaves> long_waves;  // of each of long_wave_forms; none where they are no effect
  // What they leave under the declared law, orthonormal columns; most effects leave the law as it is.
  std::vector<Eigen::MatrixXcd> declared_shapes;
  double frequency_Hz = 0, noise = 0;
  Eigen::Index first_row = 0;
};

class WaveModel : public ForwardModel {
 public:
  explicit WaveModel(Elastography waves)
      : waves_(std::move(waves)),
        forms_{waves_.declared.pressure_is_free, static_cast<int>(waves_.components.size()),
               waves_.grid.size[2] > 1 ? 3 : 2} {}
  Result<void> prepare();

  [[nodiscard]] const Observations& observations() const override { return observations_; }
  [[nodiscard]] const std::vector<Effect>& catalogue() const override { return catalogue_; }
  [[nodiscard]] Result<Eigen::VectorXd> predict(const Settings& settings) const override {
    return Eigen::VectorXd(base_ - left(state_of(settings)));
  }
  // A prediction takes a hundredth of a second at most, but an inclusion's fit some hundred of them.
  [[nodiscard]] bool predicts_quickly() const override { return false; }
  [[nodiscard]] SystematicUncertainty systematic_uncertainty() const override { return systematic_; }
  [[nodiscard]] std::vector<Start> starts(const Effect& effect, const Settings& active,
                                          const Eigen::VectorXd& residual) const override;
  [[nodiscard]] std::vector<Sentence> remarks() const override { return remarks_; }

 private:
  Result<void> add_trial(const WaveTrial& trial);
  void measure_depths();
  void make_observations();
  void doubt_sums();
  // What is left of the weak forms, a number a row.
  [[nodiscard]] Eigen::VectorXd left(const WaveState& state) const;
  [[nodiscard]] Eigen::MatrixXcd left_of(const TrialForms& trial, const WaveState& state) const;
  [[nodiscard]] Eigen::MatrixXcd whitened(const TrialForms& trial, const Medium& medium) const;
  void without_long_waves(const TrialForms& trial, const WaveState& state, const Eigen::MatrixXcd& white,
                          Eigen::MatrixXcd& values) const;
  void with_region(const TrialForms& trial, const WaveState& state, const Medium& medium,
                   const std::vector<double>& phase, const Eigen::MatrixXcd& moments, Eigen::MatrixXcd& values) const;
  [[nodiscard]] Eigen::MatrixXcd seen_of(const TrialForms& trial) const;
  void put(const TrialForms& trial, const Eigen::MatrixXcd& values, Eigen::VectorXd& rows) const;
  [[nodiscard]] Eigen::Index rows_of_patch() const { return Eigen::Index{2} * forms_.count(); }

  // Of a patch: how much the effects' region takes of it, 0 or 1 where its border runs elsewhere.
  enum class Lies { outside, inside, across };
  [[nodiscard]] Lies lies(const TrialForms& trial, const Patch& patch, const WaveState& state) const;
  [[nodiscard]] Region region_of(const WaveState& state) const;
  [[nodiscard]] double width_mm() const { return waves_.grid.spacing_mm.mean(); }

  Elastography waves_;
  WeakForms forms_;
  std::vector<TrialForms> trials_;
  std::vector<float> depth_mm_;  // of each voxel below the region's border
  Observations observations_;
  Eigen::VectorXd base_;  // measured
  SystematicUncertainty systematic_;
  std::vector<Effect> catalogue_;
  std::vector<Sentence> remarks_;
};

Eigen::MatrixXcd long_wave_shapes(const LongWaves& waves, const Eigen::MatrixXcd& white);

Eigen::Vector3d in_grid_mm(const imaging::Grid& grid, const Eigen::Vector3d& place_mm) {
  return grid.direction.transpose() * (place_mm - grid.origin_mm);
}

Eigen::Vector3d of_voxel_mm(const imaging::Grid& grid, const std::array<int, 3>& voxel) {
  return grid.spacing_mm.cwiseProduct(Eigen::Vector3d(voxel[0], voxel[1], voxel[2]));
}

}  // namespace

Result<std::unique_ptr<ForwardModel>> wave_model(Elastography waves) {
  auto model = std::make_unique<WaveModel>(std::move(waves));
  if (auto prepared = model->prepare(); !prepared) return failure(std::move(prepared.error()));
  return model;
}

namespace {

Result<void> WaveModel::prepare() {
  for (const WaveTrial& trial : waves_.trials) {
    if (auto added = add_trial(trial); !added) return added;
  }
  measure_depths();
  make_observations();
  doubt_sums();
  Eigen::Vector3d low = trials_.front().patches.front().place_mm, high = low;
  double radius = 0;
  for (const TrialForms& trial : trials_) {
    for (const Patch& patch : trial.patches) {
      low = low.cwiseMin(patch.place_mm);
      high = high.cwiseMax(patch.place_mm);
    }
    radius += trial.functions.radius()[0] * waves_.grid.spacing_mm[0] / static_cast<double>(trials_.size());
  }
  const Eigen::Vector3d beyond = Eigen::Vector3d::Constant(0.7 * radius);
  catalogue_ = wave_effects(waves_, radius, low - beyond, high + beyond);
  return {};
}

Result<void> WaveModel::add_trial(const WaveTrial& trial) {
  const Medium medium = medium_of(waves_, {}, trial.frequency_Hz);
  const double wavelength = 2 * std::numbers::pi * std::sqrt(std::abs(medium.shear_kPa) / medium.inertia);
  const double wanted = waves_.patch_radius_mm > 0 ? waves_.patch_radius_mm : radius_in_wavelengths * wavelength;
  const auto radius = patch_radius(waves_.grid, wanted);
  if (!radius)
    return failure(Error{
        "waves-no-patch",
        GLISSON_TEXT("The images hold {0} x {1} x {2} voxels, too few for a patch."),
        {std::to_string(waves_.grid.size[0]), std::to_string(waves_.grid.size[1]), std::to_string(waves_.grid.size[2])},
        GLISSON_TEXT("Seven along each axis are needed, or a single slice."),
        {}});
  TestFunctions functions(*radius, waves_.grid.spacing_mm);
  auto patches = patches_of(waves_, functions);
  if (patches.empty())
    return failure(
        Error{"waves-no-patch",
              GLISSON_TEXT("No patch of trial {0} lies within the region: it would take {1} mm to each side."),
              {trial.id, std::to_string(static_cast<int>(std::lround(wanted)))},
              GLISSON_TEXT("Is the region thin, or the declared modulus in Pa? \"patch_radius_mm\" sets it."),
              {}});
  if (patches.size() == maximum_patches)
    remarks_.push_back({GLISSON_TEXT("Of trial {0} {1} patches were taken, evenly from all."),
                        {trial.id, std::to_string(maximum_patches)}});
  Moments moments(trial, waves_.grid, functions, patches);
  Eigen::MatrixXcd plain = moments.of(functions, {});
  TrialForms made{functions,
                  patches,
                  std::move(moments),
                  std::move(plain),
                  along_grid(trial, waves_.grid),
                  RegionForms(forms_, functions, waves_.grid),
                  {},
                  {},
                  trial.frequency_Hz,
                  trial.noise,
                  0};
  if (waves_.components.size() == 3 && waves_.grid.size[2] > 1 && !waves_.declared.pressure_is_free) {
    for (const auto& [form, degree] : long_wave_forms)
      made.long_waves.emplace_back(waves_.grid, made.functions, made.patches, degree);
    for (const LongWaves& waves : made.long_waves)
      made.declared_shapes.push_back(long_wave_shapes(waves, whitened(made, medium)));
  }
  if (!trials_.empty())
    made.first_row =
        trials_.back().first_row + static_cast<Eigen::Index>(trials_.back().patches.size()) * rows_of_patch();
  trials_.push_back(std::move(made));
  return {};
}

// What lies beyond the images counts as outside.
void WaveModel::measure_depths() {
  imaging::Mask padded;
  padded.grid = waves_.grid;
  for (int& size : padded.grid.size) size += 2;
  padded.values.assign(padded.grid.voxels(), 0);
  const auto& size = waves_.grid.size;
  const auto each = [&](const auto& act) {
    for (int k = 0; k < size[2]; ++k)
      for (int j = 0; j < size[1]; ++j)
        for (int i = 0; i < size[0]; ++i) act(waves_.grid.offset(i, j, k), padded.grid.offset(i + 1, j + 1, k + 1), k);
  };
  each([&](std::size_t own, std::size_t other, int) { padded.values[other] = waves_.region[own]; });
  // A single slice goes on to both sides.
  if (size[2] == 1) {
    const std::size_t slice = padded.values.size() / 3;
    for (std::size_t v = 0; v < slice; ++v) padded.values[v] = padded.values[2 * slice + v] = padded.values[slice + v];
  }
  const std::vector<float> squares = imaging::squared_depths_mm2(padded);
  depth_mm_.resize(waves_.region.size());
  each([&](std::size_t own, std::size_t other, int) { depth_mm_[own] = std::sqrt(squares[other]); });
}

void WaveModel::make_observations() {
  observations_.unit = "noise";
  observations_.directions = waves_.components;
  const auto components = static_cast<int>(waves_.components.size());
  const auto& last = trials_.back();
  const Eigen::Index count = last.first_row + static_cast<Eigen::Index>(last.patches.size()) * rows_of_patch();
  base_ = Eigen::VectorXd::Zero(count);
  for (const TrialForms& trial : trials_) put(trial, seen_of(trial), base_);
  base_ += left({});
  std::vector<Observation> rows;
  int point = 0;
  for (std::size_t t = 0; t < trials_.size(); ++t) {
    observations_.trials.push_back(waves_.trials[t].id);
    for (const Patch& patch : trials_[t].patches) {
      for (int moment = 0; moment < 2 * forms_.groups(); ++moment, ++point) {
        for (int component = 0; component < components; ++component) {
          Observation row;
          row.measured = base_[static_cast<Eigen::Index>(rows.size())];
          row.noise = 1;
          row.trial = static_cast<int>(t);
          row.sample = moment;
          row.direction = component;
          row.point = point;
          row.load = trials_[t].frequency_Hz;
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
  const Eigen::VectorXd here = left({});
  WaveState stiffer, lossy;
  stiffer.factor += step;
  lossy.viscosity = Setting{"viscosity", "structural", Eigen::VectorXd::Constant(1, step)};
  const bool elastic = waves_.declared.law == WaveLaw::elastic;
  const Eigen::MatrixXd changes = (Eigen::MatrixXd(here.size(), elastic ? 2 : 1) << left(stiffer) - here,
                                   elastic ? Eigen::MatrixXd(left(lossy) - here) : Eigen::MatrixXd(here.size(), 0))
                                      .finished() /
                                  step;
  systematic_.directions =
      Eigen::MatrixXd::Zero(here.size(), changes.cols() * static_cast<Eigen::Index>(trials_.size()));
  Eigen::Index column = 0;
  for (const TrialForms& trial : trials_) {
    const auto& radius = trial.functions.radius();
    const bool coarse = std::any_of(radius.begin(), radius.end(), [](int r) { return r == 4 || r == 5; });
    const Eigen::Index rows = static_cast<Eigen::Index>(trial.patches.size()) * rows_of_patch();
    for (const auto& change : changes.colwise())
      systematic_.directions.col(column++).segment(trial.first_row, rows) =
          (coarse ? off_where_coarse : off) * change.segment(trial.first_row, rows);
  }
}

// A column a patch, test functions by component and group; rows by group, real and imaginary part, component.
void WaveModel::put(const TrialForms& trial, const Eigen::MatrixXcd& values, Eigen::VectorXd& rows) const {
  Eigen::Index row = trial.first_row;
  for (Eigen::Index p = 0; p < values.cols(); ++p) {
    for (int group = 0; group < forms_.groups(); ++group) {
      for (const bool imaginary : {false, true}) {
        for (int c = 0; c < forms_.components; ++c) {
          const std::complex<double> value = values(c * forms_.groups() + group, p);
          rows[row++] = imaginary ? value.imag() : value.real();
        }
      }
    }
  }
}

Eigen::VectorXd WaveModel::left(const WaveState& state) const {
  Eigen::VectorXd rows(base_.size());
  for (const TrialForms& trial : trials_) put(trial, left_of(trial, state), rows);
  return rows;
}

Eigen::MatrixXcd WaveModel::whitened(const TrialForms& trial, const Medium& medium) const {
  const Eigen::MatrixXcd rows = forms_.rows(medium);
  return whitened_rows(covariance_of(rows, trial.functions.gram()), rows) / trial.noise;
}

Eigen::MatrixXcd WaveModel::left_of(const TrialForms& trial, const WaveState& state) const {
  const Medium medium = medium_of(waves_, state, trial.frequency_Hz);
  const std::vector<double> phase = slice_phase(state, trial.frequency_Hz, waves_.grid.size[2]);
  const Eigen::MatrixXcd turned = phase.empty() ? Eigen::MatrixXcd() : trial.moments.of(trial.functions, phase);
  const Eigen::MatrixXcd& moments = phase.empty() ? trial.plain : turned;
  const Eigen::MatrixXcd white = whitened(trial, medium);
  Eigen::MatrixXcd values = white * moments;
  if (state.sphere || state.layer) with_region(trial, state, medium, phase, moments, values);
  if (state.long_wave_share != 0 && !trial.long_waves.empty()) without_long_waves(trial, state, white, values);
  return values;
}

// Of each long wave what it leaves in the weak forms of a homogeneous body, as an orthonormal basis.
Eigen::MatrixXcd long_wave_shapes(const LongWaves& waves, const Eigen::MatrixXcd& white) {
  const auto& moments = waves.moments();
  const Eigen::Index tests = white.rows(), fields = moments.front().cols();
  Eigen::MatrixXcd shapes(tests * static_cast<Eigen::Index>(moments.size()), fields);
  for (std::size_t p = 0; p < moments.size(); ++p)
    shapes.middleRows(static_cast<Eigen::Index>(p) * tests, tests) = white * moments[p].cast<std::complex<double>>();
  shapes *= shapes.colwise().norm().cwiseMax(1e-300).cwiseInverse().asDiagonal();
  Eigen::MatrixXcd normal = shapes.adjoint() * shapes;
  normal.diagonal().array() += 1e-9;
  const Eigen::MatrixXcd root = normal.llt().matrixL();
  return root.triangularView<Eigen::Lower>().solve(shapes.adjoint()).adjoint();
}

// What long waves leave in the weak forms of a homogeneous body is a known shape a field; their amplitudes are those
// that leave least. What so many numbers take of noise, and Akaike's price for them, is put back on all rows alike.
void WaveModel::without_long_waves(const TrialForms& trial, const WaveState& state, const Eigen::MatrixXcd& white,
                                   Eigen::MatrixXcd& values) const {
  std::size_t which = 0;
  while (long_wave_forms.at(which).second != state.long_wave_degree) ++which;
  const bool as_declared = state.factor == 1 && !state.viscosity && state.ratio == 1;
  const Eigen::MatrixXcd other = as_declared ? Eigen::MatrixXcd() : long_wave_shapes(trial.long_waves[which], white);
  const Eigen::MatrixXcd& shapes = as_declared ? trial.declared_shapes[which] : other;
  const Eigen::Index fields = shapes.cols();
  Eigen::Map<Eigen::VectorXcd> all(values.data(), values.size());
  const Eigen::VectorXcd taken = shapes * (shapes.adjoint() * all);
  const double share = state.long_wave_share;
  all -= share * taken;
  const double numbers = static_cast<double>(fields) * (1 - (1 - share) * (1 - share));
  const auto rows = static_cast<double>(values.size());
  all *= std::sqrt((rows + numbers) / std::max(rows - numbers, 0.1 * rows));
}

void WaveModel::with_region(const TrialForms& trial, const WaveState& state, const Medium& medium,
                            const std::vector<double>& phase, const Eigen::MatrixXcd& moments,
                            Eigen::MatrixXcd& values) const {
  const double ratio = state.sphere ? state.sphere->ratio : state.layer->ratio;
  const auto stiffer = [&](double times) {
    Medium other = medium;
    other.shear_kPa *= times;
    return other;
  };
  const Eigen::MatrixXcd inside = whitened(trial, stiffer(ratio));
  const Eigen::MatrixXcd rows = forms_.rows(medium);
  const Eigen::MatrixXcd covariance = covariance_of(rows, trial.functions.gram());
  const Region region = region_of(state);
  for (std::size_t p = 0; p < trial.patches.size(); ++p) {
    const auto column = static_cast<Eigen::Index>(p);
    const Lies lies_here = lies(trial, trial.patches[p], state);
    if (lies_here == Lies::outside) continue;
    if (lies_here == Lies::inside) {
      values.col(column) = inside * moments.col(column);
      continue;
    }
    const RegionSums sums = trial.regions.sums(trial.patches[p], trial.fields, phase, region);
    if (sums.share == 0) continue;
    if (!state.is_isotropic()) {  // the share that the region has, in place of where it is
      values.col(column) = whitened(trial, stiffer(1 + (ratio - 1) * sums.share)) * moments.col(column);
      continue;
    }
    const auto forms = RegionForms::with_region(sums, medium, ratio, covariance, rows * moments.col(column));
    values.col(column) = whitened_rows(forms.covariance, forms.seen) / trial.noise;
  }
}

// What the test functions themselves see of the field, less what shares its noise with the weak forms, in noises.
Eigen::MatrixXcd WaveModel::seen_of(const TrialForms& trial) const {
  const Eigen::MatrixXcd weak = forms_.rows(medium_of(waves_, {}, trial.frequency_Hz));
  const Eigen::MatrixXcd own = forms_.rows({.inertia = 1});
  const Eigen::MatrixXd& gram = trial.functions.gram();
  const Eigen::MatrixXcd both = (Eigen::MatrixXcd(weak.rows() + own.rows(), weak.cols()) << weak, own).finished();
  return whitened_rows(covariance_of(both, gram), both).bottomRows(own.rows()) / trial.noise * trial.plain;
}

WaveModel::Lies WaveModel::lies(const TrialForms& trial, const Patch& patch, const WaveState& state) const {
  constexpr double felt = 0.9;  // of a bump's half width, to all sides about alike: beyond it nothing is left of it
  const double reach = felt * of_voxel_mm(waves_.grid, trial.functions.radius()).maxCoeff() + width_mm();
  const double depth =
      state.sphere
          ? state.sphere->radius_mm -
                (in_grid_mm(waves_.grid, state.sphere->center_mm) - of_voxel_mm(waves_.grid, patch.middle)).norm()
          : state.layer->depth_mm - depth_mm_[waves_.grid.offset(patch.middle[0], patch.middle[1], patch.middle[2])];
  return depth > reach ? Lies::inside : depth < -reach ? Lies::outside : Lies::across;
}

Region WaveModel::region_of(const WaveState& state) const {
  if (state.sphere) {
    const Eigen::Vector3d center = in_grid_mm(waves_.grid, state.sphere->center_mm);
    return [this, center, radius = state.sphere->radius_mm](const std::array<int, 3>& voxel) {
      const Eigen::Vector3d away = of_voxel_mm(waves_.grid, voxel) - center;
      const double distance = away.norm();
      const Eigen::Vector3d inwards = distance > 0 ? Eigen::Vector3d(-away / distance) : Eigen::Vector3d::Zero();
      return smoothed(radius - distance, inwards, width_mm());
    };
  }
  return [this, depth = state.layer->depth_mm](const std::array<int, 3>& voxel) {
    const auto at = [&](int axis, int step) {
      std::array<int, 3> there = voxel;
      int& index = there.at(static_cast<std::size_t>(axis));
      index = std::clamp(index + step, 0, waves_.grid.size.at(static_cast<std::size_t>(axis)) - 1);
      return static_cast<double>(depth_mm_[waves_.grid.offset(there[0], there[1], there[2])]);
    };
    Eigen::Vector3d outwards;
    for (int axis = 0; axis < 3; ++axis)
      outwards[axis] = (at(axis, -1) - at(axis, 1)) / (2 * waves_.grid.spacing_mm[axis]);
    return smoothed(depth - at(0, 0), outwards, width_mm());
  };
}

// Balls about patches that would take most of the residual to first order, each with the ratio that does.
std::vector<Start> WaveModel::starts(const Effect& effect, const Settings& active,
                                     const Eigen::VectorXd& residual) const {
  if (effect.kind != "stiff-inclusion") return ForwardModel::starts(effect, active, residual);
  constexpr double step = 1e-3;
  WaveState stiffer = state_of(active);
  stiffer.factor *= 1 + step;
  const Eigen::VectorXd by_stiffness = (left(stiffer) - residual) / step;
  struct Sums {
    Eigen::Vector3d place_mm;
    double along = 0, square = 0;
  };
  std::vector<Sums> patches;
  for (const TrialForms& trial : trials_) {
    Eigen::Index row = trial.first_row;
    for (const Patch& patch : trial.patches) {
      const auto derivative = by_stiffness.segment(row, rows_of_patch());
      patches.push_back(
          {patch.place_mm, -derivative.dot(residual.segment(row, rows_of_patch())), derivative.squaredNorm()});
      row += rows_of_patch();
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
