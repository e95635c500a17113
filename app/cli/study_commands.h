#pragma once
// The parts of glisson-cli study.

#include "command.h"

namespace glisson::cli {

void add_study_anatomy(CLI::App& study, Action& chosen);
void add_study_beams(CLI::App& study, Action& chosen);
void add_study_cohort(CLI::App& study, Action& chosen);
void add_study_convergence(CLI::App& study, Action& chosen);
void add_study_data_driven(CLI::App& study, Action& chosen);
void add_study_example_sequence(CLI::App& study, Action& chosen);
void add_study_landmarks(CLI::App& study, Action& chosen);
void add_study_matching(CLI::App& study, Action& chosen);
void add_study_palpation(CLI::App& study, Action& chosen);
void add_study_shapes(CLI::App& study, Action& chosen);
void add_study_validate_stiffness(CLI::App& study, Action& chosen);

}  // namespace glisson::cli
