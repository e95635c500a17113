#include "session_question.h"

#include "casefile/model.h"
#include "casefile/orders.h"
#include "casefile/used_entries.h"
#include "elastography/cell_stiffness.h"
#include "geometry/mesh_file.h"
#include "mechanics/scenario/scenario_file.h"

namespace glisson::cli {
namespace {

Result<SessionQuestion> question_of_case(const SessionSource& source, bool with_structures) {
  const auto patient = casefile::Case::open(*source.case_folder);
  if (!patient) return failure(patient.error());
  if (with_structures) {
    return casefile::orders_question(*patient).map([&](casefile::OrdersQuestion question) {
      return SessionQuestion{
          std::move(question.setup), std::move(question.vessels), {}, messages(question.remarks), patient->origin()};
    });
  }
  auto model = casefile::read_model(*patient);
  if (!model) return failure(model.error());
  SessionQuestion question{{}, {}, model->evidence, messages(casefile::model_remarks(*patient)), patient->origin()};
  if (model->assumed) question.remarks.push_back(model->assumed->message());
  question.setup = source.live ? casefile::live_rehearsal_setup(*std::move(model)).setup
                               : casefile::rehearsal_setup(*std::move(model));
  return question;
}

// Beside a mesh lies the same reference body as beside a case.
Result<SessionQuestion> question_of_mesh(const std::string& mesh_file, const std::string& scenario_file) {
  const auto scenario = mechanics::read_scenario(scenario_file);
  if (!scenario) return failure(scenario.error());
  auto mesh = geometry::read_tetrahedra(mesh_file);
  if (!mesh) return failure(std::move(mesh.error()));
  auto setup = rehearsal::rehearsal_setup(std::move(*mesh), *scenario);
  if (!setup) return failure(std::move(setup.error()).in_file(scenario_file));
  setup->reference_youngs_kPa = elastography::reference_youngs_kPa(elastography::PopulationMean::dissertation_cohort,
                                                                   setup->options.poisson_ratio);
  return SessionQuestion{std::move(*setup), {}, {}, {}, {}};
}

void put_into_motion(rehearsal::RehearsalSetup& setup, const SessionSource& source) {
  if (source.step_s) {
    if (!setup.motion) setup.motion.emplace();
    setup.motion->step_s = *source.step_s;
  }
  if (!setup.motion) return;
  if (source.mass_damping_per_s) setup.motion->mass_damping_per_s = *source.mass_damping_per_s;
  if (source.stiffness_damping_s) setup.motion->stiffness_damping_s = *source.stiffness_damping_s;
}

}  // namespace

Result<SessionQuestion> question_of(const SessionSource& source, bool with_structures) {
  auto question = source.case_folder ? question_of_case(source, with_structures)
                                     : question_of_mesh(*source.mesh_file, *source.scenario_file);
  if (!question) return question;
  if (source.engine == mechanics::Engine::fem) question->setup.meshfree.reset();
  if (source.engine == mechanics::Engine::meshfree && !question->setup.meshfree) question->setup.meshfree.emplace();
  if (source.nodes && question->setup.meshfree) question->setup.meshfree->nodes = *source.nodes;
  put_into_motion(question->setup, source);
  mechanics::ChosenLaw& law = question->setup.law;
  if (source.material) law.law = *source.material;
  if (source.strain_stiffening) {
    law.strain_stiffening = *source.strain_stiffening;
    question->setup.patient_stiffening.reset();
  }
  if (law.law != mechanics::MaterialLaw::veronda_westmann || law.strain_stiffening != 0) return question;
  if (question->setup.patient_stiffening) {
    law.strain_stiffening = *question->setup.patient_stiffening;
  } else {
    law.strain_stiffening = 3;
    question->remarks.emplace_back(
        "Nobody said how soon the liver stiffens with strain: strain_stiffening 3 is assumed.");
  }
  return question;
}

}  // namespace glisson::cli
