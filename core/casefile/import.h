#pragma once
// From the series of a study to the volumes of a case.

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/progress.h"
#include "casefile/belonging.h"
#include "casefile/case.h"
#include "casefile/import_labels.h"
#include "casefile/label_map.h"
#include "imaging/study.h"

namespace glisson::casefile {

// Which series to take, by uid. Where none is named, the only candidate of that role is taken; of several, none: the
// person must choose ("import-ambiguous", with the list).
struct ImportChoice {
  std::optional<std::string> anatomy_uid;
  std::optional<std::string> stiffness_uid;
  std::optional<std::string> magnitude_uid;
  std::vector<std::string> phase_uids;  // several where each direction or frequency is a series of its own
  // Label maps; without, those that were drawn on the anatomy (label_map.h), and every DICOM SEG.
  std::vector<std::string> label_uids;
  std::map<int, std::string> label_names;  // by value; empty: as the files say
};

// What may become of a case that holds images already.
enum class Replacing {
  refused,  // "import-would-replace" where the case has an anatomy and another is to be it; "import-not-this-patient"
            // where there is any doubt that the series belong to it (belonging.h)
  wanted    // a person said so
};

struct ImportedVolume {
  std::string id;  // of the case's entry: "volumes/anatomy"
  imaging::Role role;
  imaging::Grid grid;
  std::vector<std::string> notes;  // what is wrong with the series, and how a stiffness unit was decided
};

struct Imported {
  std::vector<ImportedVolume> volumes;
  std::vector<ImportedStructure> structures;
};

// The entries that an import makes. A series of several volumes (phase offsets) is kept as ID-01, ID-02, ...
//   volumes/anatomy          as rescaled; where the study has none, the mean of the elastography's magnitude images
//   volumes/stiffness        shear modulus in kPa
//   volumes/confidence, volumes/magnitude, volumes/phase, volumes/wave      where the study has them; waves with what
//                            they were encoded for, as far as the headers say
//   labels/NAME              each segment of a DICOM SEG and each named value of a label map, on the anatomy's grid
//
// Fails with "import-no-anatomy" (unless the case has one), "import-ambiguous", "import-unknown-uid", as Replacing and
// import_labels say, or as reading fails. What the case held before stays until each new volume is complete.
Result<Imported> import_study(Case& patient, const imaging::Study& study, const ImportChoice& choice,
                              const Progress& progress = {}, Replacing replacing = Replacing::refused);

// The same with every role chosen by a person: exactly these series, each as what it says (`other`: not at all). An
// anatomy is not asked for: waves alone make a case whose elastography can be inverted. Fails with "import-nothing" or
// "import-unknown-uid". Fails with "import-role-twice": only phases and segmentations may be several series. Fails with
// "case-lacks-entry" where segmentations have nothing that they could be drawn on. Fails also as Replacing says, or as
// reading fails.
Result<Imported> import_series_as(Case& patient, const imaging::Study& study, const std::vector<SeriesRole>& roles,
                                  const Progress& progress = {}, Replacing replacing = Replacing::refused);

// A new case of a study, or nothing: where the import fails or is cancelled, the folder that it made is gone again.
struct NewCase {
  Case patient;
  Imported imported;
};
Result<NewCase> new_case_from(const imaging::Study& study, const std::filesystem::path& folder,
                              const ImportChoice& choice, const Progress& progress = {});

}  // namespace glisson::casefile
