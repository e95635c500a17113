#include "closedloop/fullfield/internal/reference.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <Eigen/QR>
#include <limits>
#include <map>
#include <optional>

#include "closedloop/experiment/whitening.h"
#include "closedloop/fullfield/internal/law_shapes.h"

namespace glisson::closedloop {
namespace {

bool is_stable(const PlaneLaw& law);

class Finding {
 public:
  Finding(const Plate& plate, Eigen::VectorXd noise) : plate_(plate), noise_(std::move(noise)) {
    difference_ = Eigen::VectorXd::Zero(noise_.size());
  }

  Result<Reference> run(const Progress& progress);

 private:
  bool stand_at_measured();
  bool stand_at(const PlaneLaw& law);
  bool look_about();
  void compare_elements();
  [[nodiscard]] std::vector<std::vector<Fitted>> fit_laws(const Eigen::VectorXd& correction);
  [[nodiscard]] Fitted fit(const LawForm& form, const Eigen::VectorXd& shapes, const Whitening& whitening,
                           const Eigen::VectorXd& rest);
  [[nodiscard]] const Eigen::VectorXd& response(const LawForm& form, Eigen::Index coefficient,
                                                const Eigen::VectorXd& shapes);
  [[nodiscard]] Eigen::VectorXd correction(FieldReading reading) const;
  [[nodiscard]] std::vector<Fitted> best_of_each(const Eigen::VectorXd& correction);
  bool stand_at_best(const Eigen::VectorXd& correction);
  void choose_reading();
  [[nodiscard]] Eigen::VectorXd noise_with_mesh_error() const;

  const Plate& plate_;
  Eigen::VectorXd noise_;
  PlaneLaw law_;
  std::vector<Eigen::VectorXd> displacement_, quadratic_;
  std::vector<PlaneElements::Tangent> tangents_;
  SystematicUncertainty systematic_;
  std::map<std::string, Eigen::VectorXd> responses_;
  Eigen::VectorXd difference_;  // what quadratic triangles change
  FieldReading reading_ = FieldReading::measured;
};

}  // namespace

const char* name_of(FieldReading reading) {
  switch (reading) {
    case FieldReading::reactions_of_linear_triangles: return "linear-reactions";
    case FieldReading::linear_triangles: return "linear";
    default: return "";
  }
}

Result<Reference> find_reference(const Plate& plate, const Progress& progress) {
  std::vector<Sentence> remarks;
  return Finding(plate, noise_of(plate, remarks)).run(progress);
}

Eigen::VectorXd noise_of(const Plate& plate, std::vector<Sentence>& remarks) {
  const FullField& field = plate.field();
  double displacement = field.noise;
  const double rough = plate.roughness();
  constexpr double more = 1.3;  // people know their noise to about a tenth
  if (rough > more * displacement) {
    remarks.push_back(
        {GLISSON_TEXT("The noise of displacements is stated as {0}, but neighbouring points differ by {1}, "
                      "which was taken in its place."),
         {fmt::format("{:.2g}", displacement), fmt::format("{:.2g}", rough)}});
    displacement = rough;
  } else if (plate.is_smoothed()) {
    remarks.push_back(
        {GLISSON_TEXT("The noise of displacements is stated as {0}, but neighbouring points differ by {1} "
                      "alone: was the field smoothed? Smoothing leaves errors that neighbours share."),
         {fmt::format("{:.2g}", displacement), fmt::format("{:.2g}", rough)}});
  }
  // A law and a mesh are no better than a few ten-thousandths of the largest force.
  constexpr double trusted = 2e-4, usual = 2e-3;
  double reaction = plate.largest_reaction() > 0 ? usual * plate.largest_reaction() : 1;
  if (field.noise_of_reactions) {
    reaction = *field.noise_of_reactions;
  } else if (const auto imbalance = plate.imbalance()) {
    reaction = std::max(*imbalance, trusted * plate.largest_reaction());
    remarks.push_back({GLISSON_TEXT("The noise of reactions is not stated; as opposite ones balance, {0} was taken."),
                       {fmt::format("{:.2g}", reaction)}});
  } else {
    remarks.push_back({GLISSON_TEXT("The noise of reactions is not stated; {0} was taken, two thousandths of the "
                                    "largest."),
                       {fmt::format("{:.2g}", reaction)}});
  }
  Eigen::VectorXd noise(plate.observations().rows());
  for (Eigen::Index row = 0; row < noise.size(); ++row) noise[row] = plate.is_reaction(row) ? reaction : displacement;
  return noise;
}

namespace {

Result<Reference> Finding::run(const Progress& progress) {
  if (!stand_at_measured() || !stand_at_best(difference_))
    return failure(
        Error{"plane-no-equilibrium",
              GLISSON_TEXT("No law has an equilibrium near these displacements."),
              {},
              GLISSON_TEXT("Are points numbered as in the mesh, and are boundaries where the forces were measured?"),
              {}});
  if (progress.cancelled()) return cancelled();
  // The law moves what quadratic triangles change, and that the law: twice is enough for both.
  for (int round = 0; round < 2; ++round) {
    compare_elements();
    if (progress.cancelled()) return cancelled();
    if (round == 0) choose_reading();
    stand_at_best(correction(reading_));
  }
  compare_elements();
  Reference reference{law_, displacement_, reading_, correction(reading_), noise_with_mesh_error(), systematic_, {}};
  const std::vector<std::vector<Fitted>> fitted = fit_laws(reference.correction);
  double best = std::numeric_limits<double>::infinity();
  for (const auto& of_form : fitted) best = std::min(best, of_form.empty() ? best : of_form.front().chi2);
  const auto rows = static_cast<double>(noise_.size());
  // To first order about another law a fit is known roughly: what is off by far more than the best is not fitted.
  constexpr double hopeless = 6;
  for (const auto& of_form : fitted) {
    std::vector<Start> starts;
    for (const Fitted& one : of_form) {
      const bool worth = one.chi2 < hopeless * std::max(best, rows);
      starts.push_back({one.law.parameters, worth ? std::numeric_limits<double>::infinity() : 0.0});
    }
    reference.starts.push_back(std::move(starts));
  }
  return reference;
}

// Where every point was seen the field itself is the state, about a law that only has the order of the forces.
bool Finding::stand_at_measured() {
  const double order = std::max(plate_.order_of_stiffness(), 1e-12);
  law_ = {plane_law("neo-hookean"), Eigen::Vector2d(order / 6, order / 4)};
  displacement_.clear();
  for (std::size_t t = 0; t < plate_.field().trials.size(); ++t) {
    const bool everywhere = plate_.measured_everywhere(t);
    const auto solved =
        everywhere ? std::optional(plate_.prescribed(t)) : plate_.equilibrium(ElementOrder::linear, law_, t);
    if (!solved) return false;
    displacement_.push_back(*solved);
  }
  // Noise on a fine mesh may turn a triangle over: then from the rough law's equilibrium.
  return look_about() || stand_at(law_);
}

bool Finding::stand_at(const PlaneLaw& law) {
  std::vector<Eigen::VectorXd> there;
  for (std::size_t t = 0; t < plate_.field().trials.size(); ++t) {
    auto solved =
        plate_.equilibrium(ElementOrder::linear, law, t, t < displacement_.size() ? &displacement_[t] : nullptr);
    if (!solved) return false;
    there.push_back(*std::move(solved));
  }
  displacement_ = std::move(there);
  law_ = law;
  return look_about();
}

bool Finding::look_about() {
  responses_.clear();
  tangents_.clear();
  const Eigen::Index rows = plate_.observations().rows();
  Eigen::MatrixXd directions = Eigen::MatrixXd::Zero(rows, 0);
  for (std::size_t t = 0; t < displacement_.size(); ++t) {
    auto tangent = plate_.tangent(law_, displacement_[t]);
    if (!tangent) return false;
    const Eigen::MatrixXd moved = plate_.response_to_moves(t, *tangent) * plate_.doubt_of_prescribed(t).asDiagonal();
    for (Eigen::Index m = 0; m < moved.cols(); ++m) {
      if (moved.col(m).squaredNorm() == 0) continue;
      directions.conservativeResize(Eigen::NoChange, directions.cols() + 1);
      directions.rightCols<1>().setZero();
      directions.block(plate_.first_row(t), directions.cols() - 1, moved.rows(), 1) = moved.col(m);
    }
    tangents_.push_back(*std::move(tangent));
  }
  systematic_ = {};
  systematic_.directions = std::move(directions);
  // What smoothing left of the noise is an error that neighbours share, and of no known shape.
  if (plate_.is_smoothed()) {
    const double rough = plate_.roughness() / plate_.field().noise;
    systematic_.indistinct = std::sqrt(1 - rough * rough);
  }
  return true;
}

void Finding::compare_elements() {
  difference_.setZero();
  quadratic_.resize(displacement_.size());
  const PlaneElements& quadratic = plate_.elements(ElementOrder::quadratic);
  for (std::size_t t = 0; t < displacement_.size(); ++t) {
    const Eigen::VectorXd start = quadratic_[t].size() > 0 ? quadratic_[t] : quadratic.prolonged(displacement_[t]);
    const auto solved = plate_.equilibrium(ElementOrder::quadratic, law_, t, &start);
    if (!solved) continue;  // then nothing is known of the mesh's error in this trial
    quadratic_[t] = *solved;
    const auto fine = quadratic.forces(law_, *solved);
    difference_.segment(plate_.first_row(t), plate_.row_count(t)) =
        plate_.read(ElementOrder::quadratic, t, *solved, *fine) -
        plate_.read(ElementOrder::linear, t, displacement_[t], tangents_[t].forces);
  }
}

Eigen::VectorXd Finding::correction(FieldReading reading) const {
  Eigen::VectorXd correction = difference_;
  for (Eigen::Index row = 0; row < correction.size(); ++row) {
    if (reading == FieldReading::linear_triangles ||
        (reading == FieldReading::reactions_of_linear_triangles && plate_.is_reaction(row)))
      correction[row] = 0;
  }
  return correction;
}

// Quadratic triangles leave about a twentieth of what linear ones are off by; so does taking the difference at a law
// near the right one.
Eigen::VectorXd Finding::noise_with_mesh_error() const {
  constexpr double left = 0.05;
  return (noise_.array().square() + (left * correction(reading_)).array().square()).sqrt();
}

bool Finding::stand_at_best(const Eigen::VectorXd& correction) {
  std::vector<Fitted> candidates = best_of_each(correction);
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const Fitted& a, const Fitted& b) { return a.bic < b.bic; });
  for (const Fitted& candidate : candidates) {
    if (std::isfinite(candidate.bic) && stand_at(candidate.law)) return true;
  }
  return false;
}

std::vector<Fitted> Finding::best_of_each(const Eigen::VectorXd& correction) {
  std::vector<Fitted> best;
  for (const auto& of_form : fit_laws(correction)) {
    for (const Fitted& one : of_form) {
      if (!is_stable(one.law)) continue;
      best.push_back(one);
      break;
    }
  }
  return best;
}

void Finding::choose_reading() {
  constexpr double very_strong = 10;  // of BIC, on Kass and Raftery's scale: what was measured is the rule
  double best = std::numeric_limits<double>::infinity();
  FieldReading chosen = FieldReading::measured;
  for (const FieldReading reading :
       {FieldReading::measured, FieldReading::reactions_of_linear_triangles, FieldReading::linear_triangles}) {
    for (const Fitted& one : best_of_each(correction(reading))) {
      const double bic = one.bic + (reading == FieldReading::measured ? 0 : very_strong);
      if (bic >= best) continue;
      best = bic;
      chosen = reading;
    }
  }
  reading_ = chosen;
}

// Of each law the two best shapes, the best first.
std::vector<std::vector<Fitted>> Finding::fit_laws(const Eigen::VectorXd& correction) {
  const Observations& all = plate_.observations();
  Eigen::VectorXd rest = all.measured - correction;
  std::vector<Eigen::Index> rows;
  for (Eigen::Index row = 0; row < rest.size(); ++row) rows.push_back(row);
  for (std::size_t t = 0; t < displacement_.size(); ++t) {
    // Of reactions the law makes all, of displacements what the state is not yet.
    rest.segment(plate_.first_row(t), plate_.row_count(t)) -=
        plate_.read(ElementOrder::linear, t, displacement_[t], Eigen::VectorXd::Zero(tangents_[t].forces.size()));
  }
  const Whitening whitening(noise_with_mesh_error(), systematic_, rows);
  const Eigen::VectorXd white = whitening.whiten(rest);
  std::vector<std::vector<Fitted>> fitted;
  for (const LawForm& form : plane_laws()) {
    std::vector<Fitted> of_form;
    for (const Eigen::VectorXd& shapes : shapes_to_try(form)) of_form.push_back(fit(form, shapes, whitening, white));
    std::stable_sort(of_form.begin(), of_form.end(), [](const Fitted& a, const Fitted& b) { return a.chi2 < b.chi2; });
    if (of_form.size() > 2) of_form.resize(2);
    if (std::isfinite(of_form.front().chi2))
      of_form.front() = with_better_shapes(std::move(of_form.front()), [&](const Eigen::VectorXd& shapes) {
        return fit(form, shapes, whitening, white);
      });
    fitted.push_back(std::move(of_form));
  }
  return fitted;
}

Fitted Finding::fit(const LawForm& form, const Eigen::VectorXd& shapes, const Whitening& whitening,
                    const Eigen::VectorXd& white) {
  const Eigen::Index coefficients = form.coefficients();
  Eigen::MatrixXd columns(noise_.size(), coefficients);
  for (Eigen::Index c = 0; c < coefficients; ++c) columns.col(c) = response(form, c, shapes);
  Fitted fitted;
  if (!columns.allFinite()) return fitted;
  columns = whitening.whiten(columns);
  const Eigen::VectorXd scale = columns.colwise().norm().transpose().cwiseMax(1e-300);
  const Eigen::VectorXd solution = scale.cwiseInverse().asDiagonal() *
                                   (columns * scale.cwiseInverse().asDiagonal()).colPivHouseholderQr().solve(white);
  fitted.law = {&form, Eigen::VectorXd(coefficients + shapes.size())};
  fitted.law.parameters << solution, shapes;
  fitted.chi2 = (white - columns * solution).squaredNorm();
  const auto rows = static_cast<double>(white.size());
  const double variance = std::max(1.0, fitted.chi2 / rows);
  fitted.bic = rows * (std::log(variance) + fitted.chi2 / rows / variance) +
               static_cast<double>(form.parameters.size()) * std::log(rows);
  return fitted;
}

// Terms that several laws share are computed once.
const Eigen::VectorXd& Finding::response(const LawForm& form, Eigen::Index coefficient, const Eigen::VectorXd& shapes) {
  const std::string name = form.parameters[static_cast<std::size_t>(coefficient)].name;
  std::string key = name;
  if (name == "mu" || name == "k" || name == "k1") {
    key += form.name;
    for (const double shape : shapes) key += fmt::format(" {}", shape);
  }
  const auto [found, is_new] = responses_.try_emplace(key);
  if (!is_new) return found->second;
  PlaneLaw law{&form, Eigen::VectorXd::Zero(form.coefficients() + shapes.size())};
  law.parameters[coefficient] = 1;
  law.parameters.tail(shapes.size()) = shapes;
  found->second = Eigen::VectorXd::Constant(noise_.size(), std::numeric_limits<double>::quiet_NaN());
  for (std::size_t t = 0; t < displacement_.size(); ++t) {
    const auto forces = plate_.elements(ElementOrder::linear).forces(law, displacement_[t]);
    if (!forces) continue;
    found->second.segment(plate_.first_row(t), plate_.row_count(t)) = plate_.response(t, tangents_[t], *forces);
  }
  return found->second;
}

// At rest.
bool is_stable(const PlaneLaw& law) {
  PlaneStress at_rest;
  add_stress(law, {1, 0, 0, 1}, true, at_rest);
  return at_rest.tangent(1, 1) > 0 && at_rest.tangent(0, 0) > 0;
}

}  // namespace
}  // namespace glisson::closedloop
