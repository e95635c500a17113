// A case's model as rehearsals and scenarios take it.

#include <algorithm>
#include <utility>

#include "casefile/model.h"
#include "mechanics/scenario/mesh_moduli.h"
#include "mechanics/simulation.h"

namespace glisson::casefile {
namespace {

// Gives the mesh its moduli at once, and what relaxed away from them.
mechanics::Relaxation moduli_at_once(PatientModel& model) {
  if (model.relaxation.empty()) return {};
  std::vector<double> at_once_kPa = youngs_kPa(model);
  for (double& modulus_kPa : at_once_kPa) modulus_kPa /= mechanics::long_term_share(model.relaxation);
  mechanics::set_moduli(model.mesh, std::move(at_once_kPa), mechanics::poisson_ratio_of(model.mesh));
  return std::exchange(model.relaxation, {});
}

}  // namespace

const std::vector<double>& youngs_kPa(const PatientModel& model) {
  return geometry::find_field(model.mesh.cell_fields, mechanics::youngs_modulus_field)->values;
}

closedloop::OrganModel organ_of(const PatientModel& model) {
  return {youngs_kPa(model),    model.supports,          model.capsule,   model.anisotropy,
          model.standing_loads, model.strain_stiffening, model.relaxation};
}

rehearsal::RehearsalSetup rehearsal_setup(PatientModel model) {
  rehearsal::RehearsalSetup setup;
  setup.patient_youngs_kPa = youngs_kPa(model);
  if (const auto ratio = mechanics::poisson_ratio_of(model.mesh)) setup.options.poisson_ratio = *ratio;
  setup.mesh = std::move(model.mesh);
  if (!model.assumed) setup.reference_youngs_kPa = model.reference_youngs_kPa;
  setup.supports = std::move(model.supports);
  setup.standing_loads = std::move(model.standing_loads);
  setup.landmarks = std::move(model.landmarks);
  setup.options.capsule = model.capsule;
  setup.options.anisotropy = model.anisotropy;
  setup.patient_stiffening = model.strain_stiffening;
  setup.relaxation = std::move(model.relaxation);
  return setup;
}

LiveSetup live_rehearsal_setup(PatientModel model) {
  std::vector<geometry::Surface> moved{std::move(model.liver.surface)};
  for (StructureSurface& structure : model.structures) moved.push_back(std::move(structure.surface));
  LiveSetup live{rehearsal_setup(std::move(model)), 0};
  rehearsal::RehearsalSetup& setup = live.setup;
  setup.structures = std::move(moved);
  setup.options.factor_precision = mechanics::StaticOptions::FactorPrecision::single;
  if (!mechanics::locate_landmarks(setup.mesh, setup.landmarks, setup.landmark_tolerance_mm)) {
    live.lost_landmarks = std::erase_if(setup.landmarks, [&](const mechanics::Landmark& landmark) {
      return !mechanics::locate_landmarks(setup.mesh, {landmark}, setup.landmark_tolerance_mm);
    });
  }
  return live;
}

std::vector<Sentence> put_into(mechanics::Scenario& scenario, PatientModel& model) {
  const bool own_supports = !scenario.supports.empty(), own_modulus = scenario.youngs_modulus.has_value(),
             own_capsule = scenario.capsule.has_value(),
             stiffens = scenario.material == mechanics::MaterialLaw::veronda_westmann,
             own_stiffening = stiffens && scenario.strain_stiffening != 0,
             own_relaxation = !scenario.relaxation.empty(), stays_isotropic = !mechanics::may_be_anisotropic(scenario);
  const auto why_not = [&](const std::string& kind) -> std::string {
    const bool holds = kind == "support-compliance" || kind == "undeclared-attachment" || kind == "missing-attachment";
    if (own_supports && holds) {
      return GLISSON_TEXT("The scenario says itself what holds the organ: the effect {0} is left out.");
    }
    if (own_modulus && (kind == "stiffness-scale" || kind == "viscoelastic-creep" || kind == "stiff-inclusion")) {
      return GLISSON_TEXT("The scenario says itself how stiff the organ is: the effect {0} is left out.");
    }
    if (kind == "viscoelastic-creep" && own_relaxation) {
      return GLISSON_TEXT("The scenario says itself how the organ relaxes: the effect {0} is left out.");
    }
    if (kind == "strain-stiffening" && own_stiffening) {
      return GLISSON_TEXT("The scenario says itself how soon the organ stiffens: the effect {0} is left out.");
    }
    if (kind == "strain-stiffening" && !stiffens) {
      return GLISSON_TEXT("Only the material veronda-westmann stiffens with strain: the effect {0} is left out.");
    }
    if (own_capsule && kind == "capsule") {
      return GLISSON_TEXT("The scenario says itself what skin the organ has: the effect {0} is left out.");
    }
    if (stays_isotropic && kind == "anisotropy") {
      return GLISSON_TEXT(
          "Only a linear equilibrium by finite elements can have a fibre direction: the effect {0} is left out.");
    }
    return {};
  };
  std::vector<Sentence> said;
  for (const closedloop::LearntEffect& effect : model.evidence.effects) {
    std::string reason = effect.carried ? why_not(effect.kind) : std::string();
    said.push_back(reason.empty() ? effect.sentence : Sentence{std::move(reason), {effect.kind}});
  }
  said.insert(said.end(), model.evidence.remarks.begin(), model.evidence.remarks.end());

  if (!own_supports) scenario.supports = model.supports;
  if (scenario.landmarks.empty()) scenario.landmarks = model.landmarks;
  if (!own_capsule) scenario.capsule = model.capsule;
  if (stiffens && !own_stiffening) scenario.strain_stiffening = model.strain_stiffening.value_or(0);
  if (!stays_isotropic && !scenario.anisotropy) scenario.anisotropy = model.anisotropy;
  if (!own_modulus && (scenario.motion || own_relaxation)) {
    mechanics::Relaxation relaxation = moduli_at_once(model);
    if (!own_relaxation) scenario.relaxation = std::move(relaxation);
  }
  scenario.loads.insert(scenario.loads.end(), model.standing_loads.begin(), model.standing_loads.end());
  return said;
}

void leave_stiffness_to_data(PatientModel& model) {
  model.capsule.reset();
  model.anisotropy.reset();
  model.strain_stiffening.reset();
  model.relaxation.clear();
  std::erase_if(model.evidence.effects, [](const closedloop::LearntEffect& effect) {
    return effect.kind != "support-compliance" && effect.kind != "preload";
  });
}

}  // namespace glisson::casefile
