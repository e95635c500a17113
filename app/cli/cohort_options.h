#pragma once
// Which patients a study over a cohort is about: what its subcommands have in common.

#include <optional>
#include <string>
#include <vector>

#include "command.h"
#include "study/batch.h"

namespace glisson::cli {

struct CohortChoice {
  std::string folder;
  std::string out;
  int simulated = 0;  // 0: the folder's patients
  unsigned seed = 1;
  bool list = false;
  std::optional<std::string> only;
};

void add_cohort_options(CLI::App& command, CohortChoice& choice);

// The folder with the patients, written first where a simulated cohort is asked for.
Result<std::string> folder_of(const CohortChoice& choice);

// The patients' names (--list).
Result<Outcome> list_patients(const std::string& folder);

// "rows" of the document, and a line of the text for each patient who could not be used.
void add_rows(const std::vector<study::BatchRow>& rows, Outcome& outcome);

}  // namespace glisson::cli
