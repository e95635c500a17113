#include "mechanics/dynamics/stress_history.h"

#include <cmath>
#include <numeric>
#include <utility>

#include "mechanics/potentials/dead_load.h"
#include "mechanics/potentials/internal/cell_samples.h"
#include "mechanics/potentials/standing_stress.h"

namespace glisson::mechanics {

using Eigen::Matrix3d;

namespace {

bool turns_with_f(const Material& material) {
  return !std::holds_alternative<SmallStrain>(material) && !std::holds_alternative<Corotational>(material);
}

// H : C^-1 : H / 2, C of the law at small strain.
double energy_density_of_stress_kPa(const Lame& lame, const Matrix3d& stress) {
  const double trace = stress.trace();
  const double share = lame.lambda_kPa / (3 * lame.lambda_kPa + 2 * lame.mu_kPa);
  return (stress.squaredNorm() - share * trace * trace) / (4 * lame.mu_kPa);
}

// What first Piola-Kirchhoff stresses resist with, one a sample, whatever the body's shape is now.
template <typename Stress>
Eigen::VectorXd resisted_by_samples_mN(const Body& body, const Stress& first_piola_kPa) {
  const std::size_t points = Sampling(body.options.order).points();
  const Eigen::VectorXd anywhere = Eigen::VectorXd::Zero(3 * static_cast<Eigen::Index>(body.layout.nodes()));
  return resisting_force_mN(
      body, anywhere, [&](std::size_t c, std::size_t q, const Matrix3d&) { return first_piola_kPa(points * c + q); });
}

Lame at_rest(const Material& material) {
  const Matrix9d tangent = tangent_kPa(material, Matrix3d::Identity());
  return {tangent(0, 4), 0.5 * (tangent(0, 0) - tangent(0, 4))};
}

}  // namespace

StressHistory::StressHistory(const Body& body, std::vector<Material> materials, Relaxation relaxation, double step_s)
    : materials_(std::move(materials)),
      relaxation_(std::move(relaxation)),
      steps_(steps_of(relaxation_, step_s)),
      samples_(Sampling(body.options.order).points() * body.layout.cells.size()),
      relaxing_kPa_(relaxation_.size(), std::vector<Matrix3d>(samples_.size(), Matrix3d::Zero())) {
  GLISSON_ASSERT(materials_.size() == body.layout.cells.size());
  for (const Material& material : materials_) lame_.push_back(at_rest(material));
}

Eigen::VectorXd StressHistory::force_mN(const Body& body) const {
  return -resisted_by_samples_mN(body, [&](std::size_t s) { return (samples_[s].frame * older_kPa(s)).eval(); });
}

Potentials StressHistory::potentials(const Body& body) const {
  if (!turns_with_f(materials_.front())) return {std::make_shared<DeadLoad>(force_mN(body))};
  std::vector<Matrix3d> older(samples_.size());
  for (std::size_t s = 0; s < samples_.size(); ++s) older[s] = older_kPa(s);
  return {std::make_shared<StandingStress>(body, std::move(older))};
}

void StressHistory::advance(const Body& body, const Eigen::VectorXd& u_mm) { move(body, u_mm, steps_); }

void StressHistory::jump(const Body& body, const Eigen::VectorXd& u_mm) {
  std::vector<RelaxationStep> at_once;
  for (const RelaxationTerm& term : relaxation_) at_once.push_back({1.0, term.weight});
  move(body, u_mm, at_once);
}

void StressHistory::move(const Body& body, const Eigen::VectorXd& u_mm, const std::vector<RelaxationStep>& steps) {
  const Sampling sampling(body.options.order);
  visit_samples(body, sampling, u_mm,
                [&](std::size_t c, std::size_t q, const TetGradients&, const Matrix3d& f, double) {
                  const std::size_t s = sampling.points() * c + q;
                  Sample& sample = samples_[s];
                  const Matrix3d before = sample.elastic_kPa;
                  if (const auto* small = std::get_if<SmallStrain>(&materials_[c])) {
                    sample.elastic_kPa = small->first_piola_kPa(f);
                  } else if (const auto* turned = std::get_if<Corotational>(&materials_[c])) {
                    const Polar polar = polar_decomposition(f);
                    sample.frame = polar.rotation;
                    sample.elastic_kPa = mechanics::stress_kPa(turned->lame, polar.stretch - Matrix3d::Identity());
                  } else {
                    constexpr double flat = 1e-6;
                    sample.frame = f;
                    if (std::abs(f.determinant()) > flat) {
                      const Matrix3d stress = f.inverse() * first_piola_kPa(materials_[c], f);
                      sample.elastic_kPa = 0.5 * (stress + stress.transpose());  // symmetric but for rounding
                    }
                  }
                  sample.elastic_energy_kPa = energy_density_kPa(materials_[c], f);
                  for (std::size_t k = 0; k < steps.size(); ++k) {
                    Matrix3d& relaxing = relaxing_kPa_[k][s];
                    relaxing = steps[k].decay * relaxing + steps[k].share * (sample.elastic_kPa - before);
                  }
                });
}

Matrix3d StressHistory::older_kPa(std::size_t sample) const {
  Matrix3d older = Matrix3d::Zero();
  for (std::size_t k = 0; k < steps_.size(); ++k) {
    older += steps_[k].decay * relaxing_kPa_[k][sample] - steps_[k].share * samples_[sample].elastic_kPa;
  }
  return older;
}

Matrix3d StressHistory::stress_kPa(std::size_t sample) const {
  Matrix3d stress = long_term_share(relaxation_) * samples_[sample].elastic_kPa;
  for (const auto& relaxing : relaxing_kPa_) stress += relaxing[sample];
  return stress;
}

Eigen::VectorXd StressHistory::resisting_force_mN(const Body& body) const {
  return resisted_by_samples_mN(body, [&](std::size_t s) { return (samples_[s].frame * stress_kPa(s)).eval(); });
}

double StressHistory::free_energy_uJ(const Body& body) const {
  const Sampling sampling(body.options.order);
  std::vector<double> of_cell(body.layout.cells.size(), 0.0);
  for (std::size_t c = 0; c < of_cell.size(); ++c) {
    const double volume_mm3 = geometry::cell_volume_mm3(body.mesh, c);
    for (std::size_t q = 0; q < sampling.points(); ++q) {
      const std::size_t s = sampling.points() * c + q;
      double energy_kPa = long_term_share(relaxation_) * samples_[s].elastic_energy_kPa;
      for (std::size_t k = 0; k < relaxation_.size(); ++k) {
        energy_kPa += energy_density_of_stress_kPa(lame_[c], relaxing_kPa_[k][s]) / relaxation_[k].weight;
      }
      of_cell[c] += sampling.weights[q] * volume_mm3 * energy_kPa;
    }
  }
  return std::accumulate(of_cell.begin(), of_cell.end(), 0.0);
}

std::vector<double> StressHistory::von_mises_of_cells(const Body& body, const Eigen::VectorXd& u_mm) const {
  const Sampling sampling(body.options.order);
  std::vector<Matrix3d> cauchy_kPa(body.layout.cells.size(), Matrix3d::Zero());
  visit_samples(
      body, sampling, u_mm, [&](std::size_t c, std::size_t q, const TetGradients&, const Matrix3d& f, double) {
        const std::size_t s = sampling.points() * c + q;
        cauchy_kPa[c] += sampling.weights[q] * samples_[s].frame * stress_kPa(s) * f.transpose() / f.determinant();
      });
  std::vector<double> von_mises_kPa;
  for (const Matrix3d& stress : cauchy_kPa) von_mises_kPa.push_back(von_mises(stress));
  return von_mises_kPa;
}

}  // namespace glisson::mechanics
