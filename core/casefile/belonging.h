#pragma once
// Whether images belong to the patient of a case. A case keeps no identifier in the clear: with its anatomy stand
// salted hashes (base/secret_hash.h) of the patient, the examination and the frame of reference that the images name.
// Images of formats that name none (NIfTI, NRRD, MHA) are judged by their place alone.

#include <map>
#include <string>
#include <vector>

#include "base/sentence.h"
#include "casefile/case.h"
#include "imaging/study.h"

namespace glisson::casefile {

struct SeriesRole {
  std::string uid;
  imaging::Role role;
  std::map<int, std::string> label_names = {};  // of a label map: a person's names by value; empty: as the file says
};

// The hashes for the options of an entry that is made from this series, with a salt of their own.
[[nodiscard]] std::map<std::string, std::string> whose(const imaging::Series& series);

// What speaks against these series being of the patient whose anatomy the case holds, each said once: another patient,
// another examination, another frame of reference, another place (less than half of the smaller grid is shared).
// Nothing where the case has no anatomy.
[[nodiscard]] std::vector<Sentence> doubts_of_belonging(const Case& patient, const imaging::Study& study,
                                                        const std::vector<SeriesRole>& roles);

// Whether these series would put another anatomy in the place of the case's.
[[nodiscard]] bool would_replace_anatomy(const Case& patient, const std::vector<SeriesRole>& roles);

}  // namespace glisson::casefile
