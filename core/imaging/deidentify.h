#pragma once
// Taking a patient's identity out of DICOM files so that they can leave the hospital.
//
// Follows the Basic Application Level Confidentiality Profile of DICOM PS3.15, Annex E, with two options; the files say
// so (0012,0064). By the Clean Descriptors Option a series' description becomes its role ("MRE stiffness 60 Hz").
// Without that nobody could use an elastography study again. By the Retain Safe Private Option three private numbers of
// GE and Siemens are written anew. It goes further where that is safer: what is not known to be harmless goes, at every
// level of nesting. Numbers stay where they are numbers, terms where they are the standard's, codes where they are
// known here. They stay only under the kind that the dictionary gives their tag. Texts, names, dates, times, overlays,
// palettes, colour profiles, preambles and private elements go. Pixels are written uncompressed, as many as rows and
// columns ask for. Identifiers (UIDs) are replaced consistently, so that series, references and the frame of reference
// still belong together.
//
// What it cannot see: identity burned into the picture, a face in a head scan, 3-D reconstructions, or a number that
// means somebody. It warns where the headers hint at the first.

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
  std::vector<std::filesystem::path> files;  // written: OUT/<series>/<instance>.dcm, named by the new identifiers, and
                                             // <instance>-2.dcm where two files share one, in this run or an
                                             // earlier one with the same key
  std::map<std::string, int> removed;        // how many of each attribute were removed, emptied or replaced
  std::vector<std::string> warnings;         // one sentence each
  std::vector<SkippedFile> skipped;          // not written: not DICOM, damaged, without a picture, or one whose pixels
                                     // cannot be told from what is stored with them (palettes, compressed colour)
};

// A file, or all files under a folder; `out` must not lie inside it. The sources are not touched.
// Fails with path-not-found, deidentify-inside-source, deidentify-nothing, file-not-writable, cancelled (files that
// were finished before stay).
Result<DeidentifyResult> deidentify(const std::filesystem::path& path, const std::filesystem::path& out,
                                    const DeidentifyOptions& options = {}, const Progress& progress = {});

}  // namespace glisson::imaging
