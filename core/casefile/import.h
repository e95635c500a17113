#pragma once
// From the series of a study to the volumes of a case.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/progress.h"
#include "casefile/case.h"
#include "imaging/study.h"

namespace glisson::casefile {

// Which series to take, by uid. Where none is named, the only candidate of that role is taken; of several, none: the
// person must choose ("import-ambiguous", with the list).
struct ImportChoice {
  std::optional<std::string> anatomy_uid;
  std::optional<std::string> stiffness_uid;
  std::optional<std::string> magnitude_uid;
  std::vector<std::string> phase_uids;  // several where each direction or frequency is a series of its own
};

struct ImportedVolume {
  std::string id;  // of the case's entry: "volumes/anatomy"
  imaging::Role role;
  imaging::Grid grid;
  std::vector<std::string> notes;  // what is wrong with the series, and how a stiffness unit was decided
};

// The entries that an import makes. A series of several volumes (phase offsets) is kept as ID-01, ID-02, ...
//   volumes/anatomy          as rescaled; where the study has none, the mean of the elastography's magnitude images
//   volumes/stiffness        shear modulus in kPa
//   volumes/confidence, volumes/magnitude, volumes/phase, volumes/wave      where the study has them; waves with what
//                            they were encoded for, as far as the headers say
//   labels/NAME              each segment of a DICOM SEG, on the grid of the anatomy
//
// Fails with "import-no-anatomy", "import-ambiguous", "import-unknown-uid", or as reading fails. What the case held
// before stays until each new volume is complete.
Result<std::vector<ImportedVolume>> import_study(Case& patient, const imaging::Study& study, const ImportChoice& choice,
                                                 const Progress& progress = {});

// The same with every role chosen by a person: exactly these series, each as what it says (`other`: not at all). An
// anatomy is not asked for: waves alone make a case whose elastography can be inverted. Fails with "import-nothing",
// "import-unknown-uid", "import-role-twice" (only phases may be several series), or as reading fails.
struct SeriesRole {
  std::string uid;
  imaging::Role role;
};
Result<std::vector<ImportedVolume>> import_series_as(Case& patient, const imaging::Study& study,
                                                     const std::vector<SeriesRole>& roles,
                                                     const Progress& progress = {});

// A new case of a study, or nothing: where the import fails or is cancelled, the folder that it made is gone again.
struct NewCase {
  Case patient;
  std::vector<ImportedVolume> volumes;
};
Result<NewCase> new_case_from(const imaging::Study& study, const std::filesystem::path& folder,
                              const ImportChoice& choice, const Progress& progress = {});

// "Hepatic Vein, left" -> "hepatic-vein-left": a name that serves as a file name and on the command line.
std::string structure_name(const std::string& name);

}  // namespace glisson::casefile
