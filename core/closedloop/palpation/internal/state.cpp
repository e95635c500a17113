#include "closedloop/palpation/internal/state.h"

#include <algorithm>

#include "base/units.h"
#include "closedloop/palpation/internal/effects.h"

namespace glisson::closedloop {
namespace {

StiffeningLaw stiffening_law(const std::string& form) {
  if (form == palpation::form_linear) return StiffeningLaw::linear;
  if (form == palpation::form_yeoh) return StiffeningLaw::yeoh;
  if (form == palpation::form_ogden) return StiffeningLaw::ogden;
  return StiffeningLaw::exponential;
}

}  // namespace

mechanics::AnisotropyLaw anisotropy_law(const std::string& form) {
  return form == palpation::form_fibres ? mechanics::AnisotropyLaw::fibres : mechanics::AnisotropyLaw::engineering;
}

Structure PalpationState::scaled_structure() const {
  Structure scaled = structure;
  scaled.compliance_mm_per_kPa *= stiffness_factor;
  scaled.sideways_compliance_mm_per_kPa *= stiffness_factor;
  scaled.capsule_mN_per_mm /= stiffness_factor;
  if (scaled.attachment) scaled.attachment->foundation_kPa_per_mm /= stiffness_factor;
  if (scaled.loosened) scaled.loosened->compliance_mm_per_kPa *= stiffness_factor;
  return scaled;
}

PalpationState state_of(const Settings& settings, const DeclaredSupports& supports) {
  PalpationState state;
  for (const Setting& setting : settings) {
    const Eigen::VectorXd& p = setting.parameters;
    if (setting.kind == palpation::stiffness_scale) {
      state.stiffness_factor = p[0];
    } else if (setting.kind == palpation::strain_stiffening) {
      state.stiffening = Stiffening{stiffening_law(setting.form), p[0]};
    } else if (setting.kind == palpation::support_compliance) {
      if (p.minCoeff() < supports.fixed_from_kPa_per_mm) {
        state.structure.compliance_mm_per_kPa = 1.0 / p[0];
        state.structure.sideways_compliance_mm_per_kPa = 1.0 / p[p.size() - 1];
      }
    } else if (setting.kind == palpation::stiff_inclusion) {
      state.structure.inclusion = Inclusion{{p.head<3>(), p[3]}, p[4]};
    } else if (setting.kind == palpation::undeclared_attachment) {
      if (p[4] > supports.nothing_to_kPa_per_mm) state.structure.attachment = Attachment{{p.head<3>(), p[3]}, p[4]};
    } else if (setting.kind == palpation::missing_attachment) {
      const auto named = std::find(supports.names.begin(), supports.names.end(), setting.form);
      GLISSON_ASSERT(named != supports.names.end());
      if (p[0] < supports.fixed_from_kPa_per_mm)
        state.structure.loosened = Loosened{static_cast<std::size_t>(named - supports.names.begin()), 1.0 / p[0]};
    } else if (setting.kind == palpation::viscoelastic_creep) {
      const Eigen::Index terms = p.size() / 2;
      for (Eigen::Index i = 0; i < terms; ++i) state.creep.push_back({p[i], p[terms + i]});
    } else if (setting.kind == palpation::force_bias) {
      if (p.size() > 1) state.zero_mN = units::mN_from_N(p[0]);
      state.gain = p[p.size() - 1];
    } else if (setting.kind == palpation::frame_misalignment) {
      state.rotation_deg = p.head<3>();
      state.translation_mm = p.tail<3>();
    } else if (setting.kind == palpation::anisotropy) {
      state.structure.anisotropy =
          mechanics::TransverseIsotropy{anisotropy_law(setting.form), p.head<3>(), p[3], p.size() > 4 ? p[4] : 1.0};
    } else if (setting.kind == palpation::capsule) {
      state.structure.capsule_mN_per_mm = units::mN_from_N(p[0]);
    } else if (setting.kind == palpation::preload && setting.form == palpation::form_pressure) {
      state.pressure_kPa = p[0];
    } else if (setting.kind == palpation::preload) {
      for (int d = 0; d < 3; ++d) state.gravity_mm_s2[d] = units::mm_s2_from_m_s2(p[d]);
    } else {
      GLISSON_ASSERT(false);
    }
  }
  return state;
}

}  // namespace glisson::closedloop
