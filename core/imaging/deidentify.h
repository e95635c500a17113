#pragma once
// Taking a patient's identity out of DICOM files so that they can leave the hospital.
//
// Follows the Basic Application Level Confidentiality Profile of DICOM PS3.15, Annex E, for what MR, CT and
// segmentations hold, and goes further where that is simpler: every person's name, every date and time, every private
// element and every overlay is removed, but for a date or name that the standard demands, which is emptied or replaced.
// Free texts are removed too; a series' description is replaced by its role ("MRE stiffness"), without which nobody
// could use an elastography study again. Identifiers (UIDs) are replaced consistently, so that series, references and
// the frame of reference still belong together.
//
// What it cannot see: identity burned into the picture, a face in a head scan, 3-D reconstructions. It warns where the
// headers hint at the first.

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "imaging/study.h"

namespace glisson::imaging {

struct DeidentifyOptions {
  // New identifiers follow from this and the old ones. Keep it secret, and use it again for later scans of the same
  // patients that shall belong together. Empty: drawn anew, and forgotten.
  std::string key;
};

struct DeidentifyResult {
  std::vector<std::filesystem::path> files;  // written: OUT/<series>/<instance>.dcm, named by the new identifiers
  std::map<std::string, int> removed;        // how many of each attribute were removed, emptied or replaced
  std::vector<std::string> warnings;         // one sentence each
  std::vector<SkippedFile> skipped;          // not written: not DICOM, damaged, or a DICOMDIR
};

// A file, or all files under a folder; `out` must not lie inside it. The sources are not touched.
// Fails with path-not-found, deidentify-inside-source, deidentify-nothing, file-not-writable, cancelled (files that
// were finished before stay).
Result<DeidentifyResult> deidentify(const std::filesystem::path& path, const std::filesystem::path& out,
                                    const DeidentifyOptions& options = {}, const Progress& progress = {});

}  // namespace glisson::imaging
