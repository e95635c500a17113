#include "closedloop/fullfield/model.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "closedloop/fullfield/internal/reference.h"

namespace glisson::closedloop {
namespace {

class FullFieldModel : public ForwardModel {
 public:
  explicit FullFieldModel(FullField field) : plate_(std::move(field)) {}
  Result<void> prepare(const Progress& progress);

  [[nodiscard]] const Observations& observations() const override { return plate_.observations(); }
  [[nodiscard]] const std::vector<Effect>& catalogue() const override { return catalogue_; }
  [[nodiscard]] Result<Eigen::VectorXd> predict(const Settings& settings) const override;
  [[nodiscard]] Result<Linearisation> linearise(const Settings& settings) const override;
  [[nodiscard]] SystematicUncertainty systematic_uncertainty() const override {
    return reference_ ? reference_->systematic : SystematicUncertainty{};
  }
  [[nodiscard]] std::vector<Start> starts(const Effect& effect, const Settings& active,
                                          const Eigen::VectorXd& residual) const override;
  [[nodiscard]] bool predicts_quickly() const override { return false; }
  [[nodiscard]] std::string reading() const override { return reference_ ? name_of(reference_->reading) : ""; }
  [[nodiscard]] Result<Eigen::VectorXd> predict_as(const std::string& reading, const Settings& settings) const override;
  [[nodiscard]] std::vector<Sentence> remarks() const override { return remarks_; }

 private:
  [[nodiscard]] PlaneLaw law_of(const Settings& settings) const;
  [[nodiscard]] Result<std::vector<Eigen::VectorXd>> on_linear_triangles(const PlaneLaw& law, bool anywhere) const;
  [[nodiscard]] Result<Eigen::VectorXd> solved(ElementOrder order, const PlaneLaw& law) const;
  [[nodiscard]] Result<Eigen::VectorXd> forces_by(const Settings& settings, Eigen::Index parameter, std::size_t trial,
                                                  const Eigen::VectorXd& displacement) const;
  void make_catalogue(bool declared_has_numbers);

  Plate plate_;
  PlaneLaw declared_;
  std::optional<Reference> reference_;  // of what is to be explained
  std::vector<Effect> catalogue_;
  std::vector<Sentence> remarks_;
};

Failure no_equilibrium(const PlaneLaw& law, const std::string& trial) {
  return failure(Error{"plane-no-equilibrium",
                       GLISSON_TEXT("The law {0} has no equilibrium in trial {1}."),
                       {law.form->name, trial},
                       GLISSON_TEXT("Are its numbers in the unit of the reactions over lengths, and large enough?"),
                       {}});
}

}  // namespace

Result<std::unique_ptr<ForwardModel>> full_field_model(FullField field, const Progress& progress) {
  auto model = std::make_unique<FullFieldModel>(std::move(field));
  if (auto prepared = model->prepare(progress); !prepared) return failure(std::move(prepared.error()));
  return model;
}

namespace {

Result<void> FullFieldModel::prepare(const Progress& progress) {
  const FullField& field = plate_.field();
  declared_ = {plane_law(field.law), field.law_numbers};
  const bool has_numbers = declared_.parameters.size() > 0;
  plate_.set_noise(noise_of(plate_, remarks_));
  if (field.needs == Needs::measurements) {
    auto found = find_reference(plate_, progress);
    if (!found) return failure(std::move(found.error()));
    reference_ = *std::move(found);
    plate_.set_noise(reference_->noise);
    const auto place = declared_.form - plane_laws().data();
    if (!has_numbers) declared_.parameters = reference_->starts[static_cast<std::size_t>(place)].front().values;
    if (reference_->reading == FieldReading::reactions_of_linear_triangles)
      remarks_.push_back(
          {GLISSON_TEXT("The reactions are those of a solution on the mesh's own linear triangles, not of "
                        "a plate: that error is in what is predicted for them."),
           {}});
    if (reference_->reading == FieldReading::linear_triangles)
      remarks_.push_back({GLISSON_TEXT("Displacements and reactions are those of a solution on the mesh's own linear "
                                       "triangles, not of a plate: that error is in what is predicted."),
                          {}});
  }
  if (!has_numbers)
    remarks_.push_back(
        {GLISSON_TEXT("The declared law stands without numbers: the best ones were taken as declared."), {}});
  make_catalogue(has_numbers);
  return {};
}

void FullFieldModel::make_catalogue(bool declared_has_numbers) {
  double order = plate_.order_of_stiffness();
  if (!(order > 0)) order = declared_.parameters.size() > 0 ? std::abs(shear_modulus(declared_)) : 1;
  const auto declared_number = [&](const LawParameter& parameter) {
    for (std::size_t p = 0; p < declared_.form->parameters.size(); ++p) {
      const LawParameter& own = declared_.form->parameters[p];
      if (declared_.parameters.size() == 0 || own.number != parameter.number) continue;
      const double value = declared_.parameters[static_cast<Eigen::Index>(p)];
      if (std::string_view(own.name) == parameter.name) return value;
      if (parameter.number == LawNumber::shear) return std::string_view(parameter.name) == "mu" ? 2 * value : value / 2;
    }
    return parameter.usual;
  };
  const auto range = [&](const LawParameter& parameter) -> Parameter {
    const double rest = declared_number(parameter);
    switch (parameter.number) {
      case LawNumber::shear: return {parameter.name, rest, -50 * order, 50 * order, 0, order};
      case LawNumber::volume: return {parameter.name, rest, 1e-3 * order, 50 * order, 0, 2 * order};
      case LawNumber::coefficient: return {parameter.name, rest, -50 * order, 50 * order, -order, order};
      case LawNumber::angle: return {parameter.name, rest, parameter.lower, parameter.upper, 0, 180};
      default: break;
    }
    const Scale scale = parameter.lower > 0 ? Scale::logarithmic : Scale::linear;
    return {parameter.name,         rest, parameter.lower, parameter.upper, parameter.tried.front(),
            parameter.tried.back(), scale};
  };
  if (declared_has_numbers)
    catalogue_.push_back(
        {"stiffness-scale",
         "",
         {{"factor", 1, 1e-3, 1e3, 0.5, 2, Scale::logarithmic}},
         GLISSON_TEXT("The specimen is stiffer or softer than declared, everywhere and at every load."),
         {Eigen::VectorXd::Ones(1)}});
  for (const LawForm& form : plane_laws()) {
    if (&form == declared_.form && !declared_has_numbers) continue;
    Effect effect{form.name, form.name, {}, form.sentence, {}};
    for (const LawParameter& parameter : form.parameters) effect.parameters.push_back(range(parameter));
    catalogue_.push_back(std::move(effect));
  }
}

// A law stands in place of the declared one.
PlaneLaw FullFieldModel::law_of(const Settings& settings) const {
  PlaneLaw law = declared_;
  double factor = 1;
  for (const Setting& setting : settings) {
    if (setting.kind == "stiffness-scale") {
      factor *= setting.parameters[0];
    } else {
      law = {plane_law(setting.kind), setting.parameters};
    }
  }
  law.parameters.head(std::min(law.parameters.size(), law.form->coefficients())) *= factor;
  return law;
}

std::vector<Start> FullFieldModel::starts(const Effect& effect, const Settings&, const Eigen::VectorXd&) const {
  const LawForm* form = plane_law(effect.kind);
  if (form == nullptr || !reference_) return {{Eigen::VectorXd::Ones(1)}};
  return reference_->starts[static_cast<std::size_t>(form - plane_laws().data())];
}

// From the reference's; `anywhere` also from far off, for the declared law.
Result<std::vector<Eigen::VectorXd>> FullFieldModel::on_linear_triangles(const PlaneLaw& law, bool anywhere) const {
  const PlaneElements& elements = plate_.elements(ElementOrder::linear);
  std::vector<Eigen::VectorXd> displacements;
  for (std::size_t t = 0; t < plate_.field().trials.size(); ++t) {
    const Eigen::VectorXd& start = reference_->displacement[t];
    auto solved = anywhere ? plate_.equilibrium(ElementOrder::linear, law, t, &start)
                           : elements.equilibrium(law, start, plate_.prescribed(t));
    if (!solved) return no_equilibrium(law, plate_.field().trials[t].id);
    displacements.push_back(*std::move(solved));
  }
  return displacements;
}

Result<Eigen::VectorXd> FullFieldModel::solved(ElementOrder order, const PlaneLaw& law) const {
  Eigen::VectorXd predicted(observations().rows());
  for (std::size_t t = 0; t < plate_.field().trials.size(); ++t) {
    const auto displacement = plate_.equilibrium(order, law, t);
    if (!displacement) return no_equilibrium(law, plate_.field().trials[t].id);
    predicted.segment(plate_.first_row(t), plate_.row_count(t)) =
        plate_.read(order, t, *displacement, *plate_.elements(order).forces(law, *displacement));
  }
  return predicted;
}

Result<Eigen::VectorXd> FullFieldModel::predict(const Settings& settings) const {
  const PlaneLaw law = law_of(settings);
  if (law.parameters.size() == 0)
    return failure(Error{"experiment-invalid",
                         GLISSON_TEXT("The declared law {0} stands without numbers."),
                         {law.form->name},
                         GLISSON_TEXT("Give them under \"declared\", or a model.json with --with."),
                         {}});
  if (!reference_) return solved(ElementOrder::quadratic, law);
  const bool declared = settings.empty() || settings.front().kind == "stiffness-scale";
  const auto displacements = on_linear_triangles(law, declared);
  if (!displacements) return failure(displacements.error());
  Eigen::VectorXd predicted = reference_->correction;
  for (std::size_t t = 0; t < displacements->size(); ++t) {
    const Eigen::VectorXd& displacement = (*displacements)[t];
    predicted.segment(plate_.first_row(t), plate_.row_count(t)) += plate_.read(
        ElementOrder::linear, t, displacement, *plate_.elements(ElementOrder::linear).forces(law, displacement));
  }
  return predicted;
}

Result<Eigen::VectorXd> FullFieldModel::predict_as(const std::string& reading, const Settings& settings) const {
  auto predicted = predict(settings);
  if (!predicted || reference_ || reading.empty()) return predicted;
  const auto linear = solved(ElementOrder::linear, law_of(settings));
  if (!linear) return linear;
  for (Eigen::Index row = 0; row < predicted->size(); ++row) {
    if (reading == name_of(FieldReading::linear_triangles) || plate_.is_reaction(row))
      (*predicted)[row] = (*linear)[row];
  }
  return predicted;
}

// How forces change with a parameter, by differences: exact where the energy is linear in it.
Result<Eigen::VectorXd> FullFieldModel::forces_by(const Settings& settings, Eigen::Index parameter, std::size_t trial,
                                                  const Eigen::VectorXd& displacement) const {
  Settings moved = settings;
  Eigen::Index before = 0;
  std::size_t s = 0;
  while (parameter - before >= moved[s].parameters.size()) before += moved[s++].parameters.size();
  double& value = moved[s].parameters[parameter - before];
  const double here = value;
  const double step = 1e-5 * std::max(std::abs(here), 1e-3 * moved[s].parameters.lpNorm<Eigen::Infinity>());
  const PlaneElements& elements = plate_.elements(ElementOrder::linear);
  value = here + step;
  const auto ahead = elements.forces(law_of(moved), displacement);
  value = here - step;
  const auto behind = elements.forces(law_of(moved), displacement);
  if (!ahead || !behind) return no_equilibrium(law_of(settings), plate_.field().trials[trial].id);
  return Eigen::VectorXd((*ahead - *behind) / (2 * step));
}

Result<Linearisation> FullFieldModel::linearise(const Settings& settings) const {
  if (!reference_) return ForwardModel::linearise(settings);
  const PlaneLaw law = law_of(settings);
  const bool declared = settings.empty() || settings.front().kind == "stiffness-scale";
  const auto displacements = on_linear_triangles(law, declared);
  if (!displacements) return failure(displacements.error());
  const Eigen::Index count = parameter_count(settings);
  Linearisation result{reference_->correction, Eigen::MatrixXd(observations().rows(), count)};
  for (std::size_t t = 0; t < displacements->size(); ++t) {
    const Eigen::VectorXd& displacement = (*displacements)[t];
    const auto tangent = plate_.tangent(law, displacement);
    if (!tangent) return no_equilibrium(law, plate_.field().trials[t].id);
    const Eigen::Index first = plate_.first_row(t), rows = plate_.row_count(t);
    result.predicted.segment(first, rows) += plate_.read(ElementOrder::linear, t, displacement, tangent->forces);
    for (Eigen::Index p = 0; p < count; ++p) {
      const auto forces = forces_by(settings, p, t, displacement);
      if (!forces) return failure(forces.error());
      result.derivatives.col(p).segment(first, rows) = plate_.response(t, *tangent, *forces);
    }
  }
  return result;
}

}  // namespace
}  // namespace glisson::closedloop
