#include "elastography/wave_phantom.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include "elastography/unwrap.h"

namespace glisson::elastography {
namespace {

// Spherical Bessel functions j_0 .. j_order of a complex argument, by recurrence downwards (Miller).
std::vector<Complex> spherical_j(int order, Complex z) {
  std::vector<Complex> j(static_cast<std::size_t>(order) + 1, 0.0);
  if (std::abs(z) < 1e-8) {
    j[0] = 1;
    return j;
  }
  const int start = order + 20 + static_cast<int>(std::abs(z));
  Complex above = 0;
  Complex here = 1e-280;
  for (int n = start; n > 0; --n) {
    const Complex below = (2.0 * n + 1) / z * here - above;
    above = here;
    here = below;
    if (n - 1 <= order) j[static_cast<std::size_t>(n - 1)] = here;
    if (std::abs(here) > 1e200) {
      above *= 1e-200;
      here *= 1e-200;
      for (Complex& value : j) value *= 1e-200;
    }
  }
  const Complex scale = std::sin(z) / z / j[0];
  for (Complex& value : j) value *= scale;
  return j;
}

// Spherical Hankel functions of the second kind, which run outwards under e^(i w t); the recurrence upwards is stable.
std::vector<Complex> spherical_h2(int order, Complex z) {
  const Complex i(0, 1);
  std::vector<Complex> h(static_cast<std::size_t>(std::max(order, 1)) + 1);
  h[0] = i * std::exp(-i * z) / z;
  h[1] = -(z - i) * std::exp(-i * z) / (z * z);
  for (std::size_t n = 1; n + 1 < h.size(); ++n) h[n + 1] = (2.0 * static_cast<double>(n) + 1) / z * h[n] - h[n - 1];
  return h;
}

Complex derivative(const std::vector<Complex>& f, std::size_t n, Complex z) {
  if (n == 0) return -f[1];
  return f[n - 1] - (static_cast<double>(n) + 1) / z * f[n];
}

}  // namespace

Complex wavenumber(double frequency_Hz, Complex modulus_kPa) {
  const double omega = 2 * std::numbers::pi * frequency_Hz;
  return std::sqrt(1e-6 * omega * omega / modulus_kPa);
}

double wavelength_mm(double frequency_Hz, Complex modulus_kPa) {
  return 2 * std::numbers::pi / wavenumber(frequency_Hz, modulus_kPa).real();
}

imaging::Grid cube_grid(int across, int slices, double voxel_mm, double slice_mm) {
  imaging::Grid grid;
  grid.size = {across, across, slices};
  grid.spacing_mm = {voxel_mm, voxel_mm, slice_mm};
  grid.origin_mm = {-0.5 * (across - 1) * voxel_mm, -0.5 * (across - 1) * voxel_mm, -0.5 * (slices - 1) * slice_mm};
  return grid;
}

ComplexField scattered_wave(const WavePhantom& phantom, const Eigen::Vector3d& direction) {
  const Complex i(0, 1);
  const Complex k_out = wavenumber(phantom.frequency_Hz, phantom.background_kPa);
  const Complex k_in = wavenumber(phantom.frequency_Hz, phantom.inclusion_kPa);
  const double a = phantom.radius_mm;
  const int order = a > 0 ? static_cast<int>(std::max(std::abs(k_out), std::abs(k_in)) * a) + 12 : 0;
  const auto terms = static_cast<std::size_t>(order) + 1;
  std::vector<Complex> outside(terms, 0.0);
  std::vector<Complex> inside(terms, 0.0);
  if (a > 0) {
    const auto j_out = spherical_j(order + 1, k_out * a);
    const auto h_out = spherical_h2(order + 1, k_out * a);
    const auto j_in = spherical_j(order + 1, k_in * a);
    const Complex stiff_out = phantom.background_kPa * k_out;
    const Complex stiff_in = phantom.inclusion_kPa * k_in;
    Complex turn = 1;  // (-i)^n
    for (std::size_t n = 0; n < terms; ++n, turn *= -i) {
      // j + A h = B j_in and stiff_out (j' + A h') = stiff_in B j_in'.
      const Complex h_slope = stiff_out * derivative(h_out, n, k_out * a);
      const Complex j_slope = stiff_out * derivative(j_out, n, k_out * a);
      const Complex in_slope = stiff_in * derivative(j_in, n, k_in * a);
      const Complex determinant = h_out[n] * in_slope - h_slope * j_in[n];
      const double degree = 2 * static_cast<double>(n) + 1;
      outside[n] = degree * turn * (j_slope * j_in[n] - j_out[n] * in_slope) / determinant;
      inside[n] = degree * turn * (j_slope * h_out[n] - j_out[n] * h_slope) / determinant;
    }
  }
  ComplexField u(phantom.grid.voxels());
  for (int z = 0; z < phantom.grid.size[2]; ++z) {
    for (int y = 0; y < phantom.grid.size[1]; ++y) {
      for (int x = 0; x < phantom.grid.size[0]; ++x) {
        const Eigen::Vector3d at = phantom.grid.position_mm(x, y, z) - phantom.center_mm;
        const double r = std::max(at.norm(), 1e-9);
        const double cosine = at.dot(direction) / r;
        const bool in_sphere = r < a;
        const auto radial = in_sphere ? spherical_j(order, k_in * r)
                            : a > 0   ? spherical_h2(order, k_out * r)
                                      : std::vector<Complex>{0.0};
        Complex sum = in_sphere ? 0.0 : std::exp(-i * k_out * at.dot(direction));
        double legendre = 1;
        double legendre_before = 0;
        for (std::size_t n = 0; n < terms; ++n) {
          sum += (in_sphere ? inside[n] : outside[n]) * radial[n] * legendre;
          const double degree = static_cast<double>(n);
          const double next = ((2 * degree + 1) * cosine * legendre - degree * legendre_before) / (degree + 1);
          legendre_before = legendre;
          legendre = next;
        }
        u[phantom.grid.offset(x, y, z)] = std::complex<float>(sum);
      }
    }
  }
  return u;
}

ComplexField refracted_wave(const LayeredPhantom& phantom, const Eigen::Vector3d& direction) {
  const Complex i(0, 1);
  const bool downwards = direction.z() < 0;
  const Complex near_kPa = downwards ? phantom.upper_kPa : phantom.lower_kPa;
  const Complex far_kPa = downwards ? phantom.lower_kPa : phantom.upper_kPa;
  const Complex k_near = wavenumber(phantom.frequency_Hz, near_kPa);
  const Complex k_far = wavenumber(phantom.frequency_Hz, far_kPa);
  // Along the plane both sides share the wavenumber; across it, each has what is left, damped on its way.
  const Complex along = k_near * direction.head<2>().norm();
  const Complex across_near = k_near * std::abs(direction.z());
  Complex across_far = std::sqrt(k_far * k_far - along * along);
  if (across_far.imag() > 0) across_far = -across_far;
  // 1 + r = t, and near (1 - r) = far t.
  const Complex near = near_kPa * across_near, far = far_kPa * across_far;
  const Complex back = (near - far) / (near + far), through = 1.0 + back;
  ComplexField u(phantom.grid.voxels());
  for (int z = 0; z < phantom.grid.size[2]; ++z) {
    for (int y = 0; y < phantom.grid.size[1]; ++y) {
      for (int x = 0; x < phantom.grid.size[0]; ++x) {
        const Eigen::Vector3d at = phantom.grid.position_mm(x, y, z);
        const double ahead = (downwards ? -1 : 1) * (at.z() - phantom.plane_z_mm);
        const Complex turn = std::exp(-i * k_near * at.head<2>().dot(direction.head<2>()));
        const Complex sum = ahead > 0 ? through * std::exp(-i * across_far * ahead)
                                      : std::exp(-i * across_near * ahead) + back * std::exp(i * across_near * ahead);
        u[phantom.grid.offset(x, y, z)] = std::complex<float>(turn * sum);
      }
    }
  }
  return u;
}

namespace {

using Pairs = std::array<std::array<Eigen::Vector3d, 2>, 3>;

template <typename Wave>
std::vector<ComplexField> crossing(const Pairs& directions, const Wave& wave) {
  std::vector<ComplexField> components;
  for (const auto& pair : directions) {
    ComplexField u = wave(pair[0].normalized());
    const ComplexField second = wave(pair[1].normalized());
    for (std::size_t v = 0; v < u.size(); ++v) u[v] += 0.5F * second[v];
    components.push_back(std::move(u));
  }
  return components;
}

}  // namespace

std::vector<ComplexField> crossing_waves(const WavePhantom& phantom) {
  const Pairs directions{{
      {Eigen::Vector3d(1, 0.3, 0.2), Eigen::Vector3d(-0.2, 1, 0.1)},
      {Eigen::Vector3d(0.2, 1, -0.3), Eigen::Vector3d(-1, -0.4, 0.2)},
      {Eigen::Vector3d(-0.7, 0.7, 0.2), Eigen::Vector3d(0.6, 0.8, -0.1)},
  }};
  return crossing(directions, [&](const Eigen::Vector3d& along) { return scattered_wave(phantom, along); });
}

std::vector<ComplexField> crossing_waves(const LayeredPhantom& phantom) {
  const Pairs directions{{
      {Eigen::Vector3d(0.8, 0.3, -1), Eigen::Vector3d(-0.4, 0.7, 1)},
      {Eigen::Vector3d(-0.3, 1.2, -1), Eigen::Vector3d(-0.6, -0.2, 1)},
      {Eigen::Vector3d(-0.5, -0.5, -1), Eigen::Vector3d(1.2, 0.4, 1)},
  }};
  return crossing(directions, [&](const Eigen::Vector3d& along) { return refracted_wave(phantom, along); });
}

WaveImages measured(const imaging::Grid& grid, double frequency_Hz, const std::vector<ComplexField>& components,
                    double amplitude_rad, double noise_rad, int instants, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> noise(0, 1);
  WaveImages images;
  images.frequency_Hz = frequency_Hz;
  images.grid = grid;
  const double width_mm = grid.size[0] * grid.spacing_mm[0];
  for (const auto& u : components) {
    double strongest = 0;
    for (const auto& value : u) strongest = std::max(strongest, static_cast<double>(std::abs(value)));
    images.phase_rad.emplace_back();
    for (int t = 0; t < instants; ++t) {
      const Complex turn = std::polar(amplitude_rad / strongest, 2 * std::numbers::pi * t / instants);
      std::vector<float> phase(u.size());
      for (int k = 0; k < grid.size[2]; ++k) {
        for (int j = 0; j < grid.size[1]; ++j) {
          for (int i = 0; i < grid.size[0]; ++i) {
            const std::size_t v = grid.offset(i, j, k);
            const Eigen::Vector3d at = grid.position_mm(i, j, k) / width_mm;
            const double still = 9 * at.x() - 14 * at.y() * at.y() + 3 * at.z();
            const double value = (Complex(u[v]) * turn).real() + still + noise_rad * noise(random);
            phase[v] = wrapped(static_cast<float>(value));
          }
        }
      }
      images.phase_rad.back().push_back(std::move(phase));
    }
  }
  images.along = {Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitY(), Eigen::Vector3d::UnitZ()};
  return images;
}

WaveImages measured(const WavePhantom& phantom, const std::vector<ComplexField>& components, double amplitude_rad,
                    double noise_rad, int instants, unsigned seed) {
  return measured(phantom.grid, phantom.frequency_Hz, components, amplitude_rad, noise_rad, instants, seed);
}

}  // namespace glisson::elastography
