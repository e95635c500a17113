#pragma once
// Measured strain and stress, used as they are (chapter 5 of the dissertation; Q. He and J.-S. Chen, A
// physics-constrained data-driven approach based on locally convex reconstruction for noisy database, Comput. Methods
// Appl. Mech. Eng. 363, 2020). No law is fitted: where a state (strain, stress) would lie according to the data is
// found by its nearest measurements and their convex hull.
//
// A uniaxial test measures one curve. In a body of three dimensions the tissue is taken as isotropic. Volume change is
// linear, with the bulk modulus K of the data's initial slope and of Poisson's ratio. The curve says how the deviator
// of stress grows with that of strain, both along one direction. With the axial nominal strain e and stress s of the
// test, the lengths of the two deviators are
//
//   sqrt(3/2) (e - s / (9 K))   and   sqrt(2/3) s,
//
// so that a uniaxial test of such a body gives the measured curve back. Strains are small strains; nominal values are
// used for them up to where the test goes.

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "base/result.h"
#include "base/tissue.h"

namespace glisson::mechanics {

struct StressStrain {
  double strain = 0;      // nominal, along the load; negative in compression
  double stress_kPa = 0;  // nominal; negative in compression
};

struct MaterialDataOptions {
  double poisson_ratio = usual_poisson_ratio;
  int neighbours = 6;    // of which the hull is taken: He and Chen's six to ten; one is the nearest-point solver
  double slope_kPa = 0;  // of the energy norm; 0: the data's own mean slope, by least squares through the origin
};

// The data in the plane of the two deviators' lengths, where the energy norm is Euclid's:
//   |(e, s)|^2 = mu e^2 + s^2 / (4 mu),    mu = slope / (2 (1 + nu))
class MaterialData {
 public:
  // The origin is added, and each point's opposite: what was measured in compression is taken to hold in tension too
  // where nothing was measured there. Failures: "data-invalid" (fewer than 3 measurements, one that is not finite, a
  // slope that is not above zero, or options out of range).
  static Result<MaterialData> create(const std::vector<StressStrain>& measured, const MaterialDataOptions& options);

  // The point of the locally convex hull nearest to a state (deviators' lengths, stress in kPa).
  struct State {
    double strain = 0;
    double stress_kPa = 0;
  };
  [[nodiscard]] State nearest(const State& state) const;

  [[nodiscard]] double slope_kPa() const { return slope_kPa_; }  // Young's modulus of the metric
  [[nodiscard]] double shear_kPa() const { return slope_kPa_ / (2.0 * (1.0 + options_.poisson_ratio)); }
  [[nodiscard]] double bulk_kPa() const { return slope_kPa_ / (3.0 * (1.0 - 2.0 * options_.poisson_ratio)); }
  [[nodiscard]] const MaterialDataOptions& options() const { return options_; }
  [[nodiscard]] std::size_t measurements() const { return measurements_; }
  // The length of the farthest measurement's deviator of strain.
  [[nodiscard]] double largest_deviator_strain() const { return largest_deviator_strain_; }

 private:
  struct Points;
  MaterialDataOptions options_;
  double slope_kPa_ = 0;
  std::size_t measurements_ = 0;
  double largest_deviator_strain_ = 0;
  std::shared_ptr<const Points> points_;
};

// The w >= 0 that minimise |A w - b| (Lawson and Hanson, Solving Least Squares Problems, 1974, chapter 23).
[[nodiscard]] Eigen::VectorXd non_negative_least_squares(const Eigen::MatrixXd& a, const Eigen::VectorXd& b);

}  // namespace glisson::mechanics
