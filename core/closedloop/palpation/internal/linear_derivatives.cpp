#include "closedloop/palpation/internal/linear_derivatives.h"

#include <algorithm>

#include "base/units.h"
#include "closedloop/palpation/internal/effects.h"

namespace glisson::closedloop {
namespace {

// Which of the structure's parameters each parameter of a setting is, and its derivative by it.
struct Chain {
  StructureParameter parameter;
  double factor = 1;
};
std::vector<Chain> chain(const Setting& setting, const PalpationState& state) {
  using S = StructureParameter;
  if (setting.kind == palpation::stiff_inclusion) {
    return {{S::inclusion_x}, {S::inclusion_y}, {S::inclusion_z}, {S::inclusion_radius}, {S::inclusion_ratio}};
  }
  if (setting.kind == palpation::undeclared_attachment && state.structure.attachment) {
    return {{S::attachment_x},
            {S::attachment_y},
            {S::attachment_z},
            {S::attachment_radius},
            {S::attachment_foundation, 1.0 / state.stiffness_factor}};
  }
  if (setting.kind == palpation::missing_attachment && state.structure.loosened) {
    const double compliance = state.structure.loosened->compliance_mm_per_kPa;
    return {{S::loosened_compliance, -compliance * compliance * state.stiffness_factor}};
  }
  if (setting.kind == palpation::anisotropy) {
    std::vector<Chain> links{{S::axis_x}, {S::axis_y}, {S::axis_z}, {S::anisotropy_ratio}};
    if (setting.parameters.size() > 4) links.push_back({S::anisotropy_shear_ratio});
    return links;
  }
  if (setting.kind == palpation::capsule) return {{S::capsule, units::mN_from_N(1.0) / state.stiffness_factor}};
  if (setting.kind == palpation::support_compliance && state.structure.compliance_mm_per_kPa > 0) {
    const double across = state.structure.compliance_mm_per_kPa;
    const double sideways = state.structure.sideways_compliance_mm_per_kPa;
    const double factor = -across * across * state.stiffness_factor;
    if (setting.form != palpation::form_layer) return {{S::compliance, factor}};
    return {{S::compliance_across, factor}, {S::compliance_sideways, -sideways * sideways * state.stiffness_factor}};
  }
  return {};
}

}  // namespace

Result<std::vector<Eigen::MatrixXd>> linear_derivatives(const PalpationSolver& solver, const LoadColumns& columns,
                                                        const Loading& loading, const PalpationState& state,
                                                        const Settings& settings) {
  const Structure structure = state.scaled_structure();
  auto response = solver.at_markers(structure);
  if (!response) return failure(std::move(response.error()));

  // All that one factorisation gives, asked for at once.
  std::vector<StructureParameter> wanted;
  for (const Setting& setting : settings) {
    for (const Chain& link : chain(setting, state)) wanted.push_back(link.parameter);
  }
  if (state.stiffness_factor != 1 || std::any_of(settings.begin(), settings.end(), [](const Setting& setting) {
        return setting.kind == palpation::stiffness_scale;
      })) {
    if (structure.compliance_mm_per_kPa > 0) {
      wanted.push_back(StructureParameter::compliance_across);
      wanted.push_back(StructureParameter::compliance_sideways);
    }
    if (structure.capsule_mN_per_mm > 0) wanted.push_back(StructureParameter::capsule);
    if (structure.attachment) wanted.push_back(StructureParameter::attachment_foundation);
    if (structure.loosened) wanted.push_back(StructureParameter::loosened_compliance);
  }
  std::sort(wanted.begin(), wanted.end());
  wanted.erase(std::unique(wanted.begin(), wanted.end()), wanted.end());
  auto derivatives = solver.derivatives_at_markers(structure, wanted);
  if (!derivatives) return failure(std::move(derivatives.error()));
  const Eigen::MatrixXd amounts = loading.amounts / state.stiffness_factor;
  const auto by = [&](StructureParameter parameter) -> Eigen::MatrixXd {
    const auto found = std::find(wanted.begin(), wanted.end(), parameter);
    return (*derivatives)[static_cast<std::size_t>(found - wanted.begin())] * amounts;
  };
  const auto of_load = [&](const Eigen::MatrixXd& change) -> Eigen::MatrixXd {
    return *response * change / state.stiffness_factor;
  };

  std::vector<Eigen::MatrixXd> fields;
  const Eigen::MatrixXd nothing = Eigen::MatrixXd::Zero(response->rows(), amounts.cols());
  for (const Setting& setting : settings) {
    const auto links = chain(setting, state);
    for (Eigen::Index p = 0; p < setting.parameters.size(); ++p) {
      if (!links.empty()) {
        const Chain& link = links[static_cast<std::size_t>(p)];
        fields.emplace_back(link.factor * by(link.parameter));
      } else if (setting.kind == palpation::stiffness_scale) {
        const double factor = state.stiffness_factor;
        Eigen::MatrixXd field = -(*response * amounts) / factor;
        if (structure.compliance_mm_per_kPa > 0) {
          field += state.structure.compliance_mm_per_kPa * by(StructureParameter::compliance_across) +
                   state.structure.sideways_compliance_mm_per_kPa * by(StructureParameter::compliance_sideways);
        }
        if (structure.capsule_mN_per_mm > 0) {
          field -= state.structure.capsule_mN_per_mm / (factor * factor) * by(StructureParameter::capsule);
        }
        if (structure.attachment) {
          field -= state.structure.attachment->foundation_kPa_per_mm / (factor * factor) *
                   by(StructureParameter::attachment_foundation);
        }
        if (structure.loosened)
          field += state.structure.loosened->compliance_mm_per_kPa * by(StructureParameter::loosened_compliance);
        fields.push_back(std::move(field));
      } else if (setting.kind == palpation::viscoelastic_creep) {
        const auto terms = static_cast<Eigen::Index>(state.creep.size());
        const auto term = static_cast<std::size_t>(p % terms);
        fields.push_back(of_load(p < terms ? loading.by_amplitude[term] : loading.by_time[term]));
      } else if (setting.kind == palpation::force_bias) {
        fields.push_back(p + 1 < setting.parameters.size() ? of_load(units::mN_from_N(1.0) * loading.by_zero)
                                                           : of_load(loading.by_gain));
      } else if (setting.kind == palpation::preload && setting.form == palpation::form_pressure) {
        fields.emplace_back(response->col(columns.pressure()) *
                            Eigen::RowVectorXd::Constant(amounts.cols(), 1.0 / state.stiffness_factor));
      } else if (setting.kind == palpation::preload) {
        fields.emplace_back(
            response->col(columns.gravity() + p) *
            Eigen::RowVectorXd::Constant(amounts.cols(), units::mm_s2_from_m_s2(1.0) / state.stiffness_factor));
      } else {
        fields.push_back(nothing);  // of what is seen alone, or of supports that are held
      }
    }
  }
  return fields;
}

}  // namespace glisson::closedloop
