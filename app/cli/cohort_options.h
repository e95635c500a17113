#pragma once
// Which patients a study over a cohort is about: what its subcommands have in common.

#include <optional>
#include <string>
#include <vector>

#include "command.h"
#include "studies/dissertation/batch.h"
#include "studies/dissertation/cohort.h"

namespace glisson::cli {

struct CohortChoice {
  std::string folder;
  std::string out;
  int simulated = 0;  // 0: the folder's patients
  unsigned seed = 1;
  bool list = false;
  studies::BatchPart part;
};

void add_cohort_options(CLI::App& command, CohortChoice& choice);

// The folder with the patients, written first where a simulated cohort is asked for.
Result<std::string> folder_of(const CohortChoice& choice);

// The patients' names (--list).
Result<Outcome> list_patients(const std::string& folder);

// study(folder, options) over the patients chosen, or their names. `options` are a study's, told here which part
// is asked for and what to warn of.
template <typename StudyOptions, typename Study>
Result<Outcome> run_over_cohort(const CohortChoice& choice, StudyOptions options, const Study& study) {
  const auto folder = folder_of(choice);
  if (!folder) return failure(folder.error());
  if (choice.list) return list_patients(*folder);
  options.part = choice.part;
  options.warning = studies::cohort_warning(*folder);
  return study(*folder, options);
}

// "rows" of the document, and a line of the text for each patient who could not be used.
void add_rows(const std::vector<studies::BatchRow>& rows, Outcome& outcome);

}  // namespace glisson::cli
