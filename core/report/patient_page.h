#pragma once
// What was done for a patient, the answer first. There are pictures, the planned cut with margins, vessels and remnant,
// what the tools do to the landmarks, and the structures. From the next page on stands how it came about: images,
// model, evidence, and where each file of the case comes from. Read from the case; what the case does not hold is
// given.
//
// The patient's name and the case's own folder stay out of it unless the name is given.

#include <optional>
#include <string>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "casefile/case.h"
#include "hardware/plan.h"
#include "mechanics/statics/validity.h"
#include "report/page.h"
#include "report/words.h"

namespace glisson::report {

struct RehearsedLandmark {
  std::string id;
  double moves_mm = 0;
  std::optional<double> reference_off_mm;  // how far the atlas's answer is from the patient's
};

struct RehearsedTool {
  std::string name;  // "nathanson-retractor"
  double force_N = 0;
  double radius_mm = 0;  // of the patch that it touches
};

struct RehearsedRetraction {
  std::vector<RehearsedTool> tools;
  double max_displacement_mm = 0;
  std::vector<RehearsedLandmark> landmarks;
  mechanics::Validity validity = {};  // not usable: no figure of it is printed
  bool large_deformations = false;
  std::optional<double> error_bound_mm = {};  // of the landmarks, where they are not at rest
};

struct PatientPageContent {
  std::optional<std::string> name;  // nothing: withheld
  std::vector<Figure> figures;      // the first large, the others beside each other below it
  std::optional<RehearsedRetraction> retraction;
  std::optional<hardware::Plan> plan;  // where it was asked for
  std::string when;                    // as a person reads it; empty for none
  Words words = {};                    // English unless others are given
};

// Fails where a file of the case cannot be read, naming it. What is missing in the case is said on the page.
Result<Page> patient_page(const casefile::Case& patient, const PatientPageContent& content,
                          const Progress& progress = {});

}  // namespace glisson::report
