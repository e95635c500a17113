#include "closedloop/waves/internal/wave_residual.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "imaging/filters.h"

namespace glisson::closedloop {
namespace {

constexpr double radius_in_wavelengths = 0.5;  // of a bump: the weak form then answers most to its own wave

Eigen::MatrixXcd long_wave_shapes(const LongWaves& waves, const Eigen::MatrixXcd& white);
Eigen::LLT<Eigen::MatrixXcd> normal_of(const Eigen::MatrixXcd& shapes);

Eigen::Vector3d in_grid_mm(const imaging::Grid& grid, const Eigen::Vector3d& place_mm) {
  return grid.direction.transpose() * (place_mm - grid.origin_mm);
}

Eigen::Vector3d of_voxel_mm(const imaging::Grid& grid, const std::array<int, 3>& voxel) {
  return grid.spacing_mm.cwiseProduct(Eigen::Vector3d(voxel[0], voxel[1], voxel[2]));
}

}  // namespace

WaveResidual::WaveResidual(Elastography waves)
    : waves_(std::move(waves)),
      forms_{waves_.declared.pressure_is_free, static_cast<int>(waves_.components.size()),
             waves_.grid.size[2] > 1 ? 3 : 2} {}

Result<void> WaveResidual::prepare(std::vector<Sentence>& remarks) {
  for (const WaveTrial& trial : waves_.trials) {
    if (auto added = add_trial(trial, remarks); !added) return added;
  }
  measure_depths();
  return {};
}

Eigen::Index WaveResidual::rows() const { return trials_.back().first_row + rows_of(trials_.back()); }

Result<void> WaveResidual::add_trial(const WaveTrial& trial, std::vector<Sentence>& remarks) {
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
    remarks.push_back({GLISSON_TEXT("Of trial {0} {1} patches were taken, evenly from all."),
                       {trial.id, std::to_string(maximum_patches)}});
  Fields fields = along_grid(trial, waves_.grid);
  Moments moments(fields, waves_.grid, functions, patches);
  Eigen::MatrixXcd plain = moments.of(functions, {});
  TrialForms made{functions,
                  patches,
                  std::move(moments),
                  std::move(plain),
                  std::move(fields),
                  RegionForms(forms_, functions, waves_.grid),
                  {},
                  {},
                  {},
                  trial.frequency_Hz,
                  trial.noise,
                  0};
  if (waves_.components.size() == 3 && waves_.grid.size[2] > 1 && !waves_.declared.pressure_is_free) {
    for (const auto& [form, degree] : long_wave_forms)
      made.long_waves.emplace_back(waves_.grid, made.functions, made.patches, degree);
    for (const LongWaves& waves : made.long_waves) {
      made.declared_shapes.push_back(long_wave_shapes(waves, whitened(made, medium)));
      made.declared_normals.push_back(normal_of(made.declared_shapes.back()));
    }
  }
  if (!trials_.empty())
    made.first_row =
        trials_.back().first_row + static_cast<Eigen::Index>(trials_.back().patches.size()) * rows_of_patch();
  trials_.push_back(std::move(made));
  return {};
}

// What lies beyond the images counts as outside.
void WaveResidual::measure_depths() {
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

Eigen::VectorXd WaveResidual::left(const WaveState& state) const {
  Eigen::VectorXd values(rows());
  for (const TrialForms& trial : trials_) put(trial, left_of(trial, state), values);
  return values;
}

Eigen::MatrixXcd WaveResidual::whitened(const TrialForms& trial, const Medium& medium) const {
  const Eigen::MatrixXcd rows = forms_.rows(medium);
  return whitened_rows(covariance_of(rows, trial.functions.gram()), rows) / trial.noise;
}

Eigen::MatrixXcd WaveResidual::left_of(const TrialForms& trial, const WaveState& state) const {
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

// What long waves leave in the weak forms of a homogeneous body is a known shape a field; their amplitudes are those
// that leave least. What so many numbers take of noise, and Akaike's price for them, is put back on all rows alike.
void WaveResidual::without_long_waves(const TrialForms& trial, const WaveState& state, const Eigen::MatrixXcd& white,
                                      Eigen::MatrixXcd& values) const {
  std::size_t which = 0;
  while (long_wave_forms.at(which).second != state.long_wave_degree) ++which;
  const bool as_declared = state.factor == 1 && !state.viscosity && state.ratio == 1;
  const Eigen::MatrixXcd other = as_declared ? Eigen::MatrixXcd() : long_wave_shapes(trial.long_waves[which], white);
  const Eigen::MatrixXcd& shapes = as_declared ? trial.declared_shapes[which] : other;
  const Eigen::Index fields = shapes.cols();
  Eigen::Map<Eigen::VectorXcd> all(values.data(), values.size());
  const Eigen::VectorXcd along = shapes.adjoint() * all;
  const Eigen::VectorXcd taken =
      shapes * (as_declared ? trial.declared_normals[which].solve(along) : normal_of(shapes).solve(along));
  const double share = state.long_wave_share;
  all -= share * taken;
  const double numbers = static_cast<double>(fields) * (1 - (1 - share) * (1 - share));
  const auto rows = static_cast<double>(values.size());
  all *= std::sqrt((rows + numbers) / std::max(rows - numbers, 0.1 * rows));
}

void WaveResidual::with_region(const TrialForms& trial, const WaveState& state, const Medium& medium,
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

// A column a patch, test functions by component and group; rows by group, real and imaginary part, component.
void WaveResidual::put(const TrialForms& trial, const Eigen::MatrixXcd& values, Eigen::VectorXd& rows) const {
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

Eigen::VectorXd WaveResidual::seen() const {
  Eigen::VectorXd values(rows());
  for (const TrialForms& trial : trials_) put(trial, seen_of(trial), values);
  return values;
}

Eigen::MatrixXcd WaveResidual::seen_of(const TrialForms& trial) const {
  const Eigen::MatrixXcd weak = forms_.rows(medium_of(waves_, {}, trial.frequency_Hz));
  const Eigen::MatrixXcd own = forms_.rows({.inertia = 1});
  const Eigen::MatrixXd& gram = trial.functions.gram();
  const Eigen::MatrixXcd both = (Eigen::MatrixXcd(weak.rows() + own.rows(), weak.cols()) << weak, own).finished();
  return whitened_rows(covariance_of(both, gram), both).bottomRows(own.rows()) / trial.noise * trial.plain;
}

WaveResidual::Lies WaveResidual::lies(const TrialForms& trial, const Patch& patch, const WaveState& state) const {
  constexpr double felt = 0.9;  // of a bump's half width, to all sides about alike: beyond it nothing is left of it
  const double reach = felt * of_voxel_mm(waves_.grid, trial.functions.radius()).maxCoeff() + width_mm();
  const double depth =
      state.sphere
          ? state.sphere->radius_mm -
                (in_grid_mm(waves_.grid, state.sphere->center_mm) - of_voxel_mm(waves_.grid, patch.middle)).norm()
          : state.layer->depth_mm - depth_mm_[waves_.grid.offset(patch.middle[0], patch.middle[1], patch.middle[2])];
  return depth > reach ? Lies::inside : depth < -reach ? Lies::outside : Lies::across;
}

Region WaveResidual::region_of(const WaveState& state) const {
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

namespace {

// Of each long wave what it leaves in the weak forms of a homogeneous body, of length 1.
Eigen::MatrixXcd long_wave_shapes(const LongWaves& waves, const Eigen::MatrixXcd& white) {
  const auto& moments = waves.moments();
  const Eigen::Index tests = white.rows(), fields = moments.front().cols();
  Eigen::MatrixXcd shapes(tests * static_cast<Eigen::Index>(moments.size()), fields);
  for (std::size_t p = 0; p < moments.size(); ++p)
    shapes.middleRows(static_cast<Eigen::Index>(p) * tests, tests) = white * moments[p].cast<std::complex<double>>();
  const Eigen::RowVectorXd inverse = shapes.colwise().norm().cwiseMax(1e-300).cwiseInverse();
  shapes *= inverse.asDiagonal();
  return shapes;
}

Eigen::LLT<Eigen::MatrixXcd> normal_of(const Eigen::MatrixXcd& shapes) {
  Eigen::MatrixXcd normal = Eigen::MatrixXcd::Identity(shapes.cols(), shapes.cols()) * 1e-9;
  normal.selfadjointView<Eigen::Lower>().rankUpdate(shapes.adjoint());
  return normal.llt();
}

}  // namespace
}  // namespace glisson::closedloop
