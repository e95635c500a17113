#pragma once
// Whether images belong to the patient of a case. A case keeps no identifier in the clear. With its anatomy stand
// salted hashes (base/secret_hash.h) of the patient, the examination and the frame of reference that the images name.
// Images of formats that name none (NIfTI, NRRD, MHA) are judged by their place alone.
//
// These hashes have a salt of their own in each case, so that no list of cases tells which are of one patient. Beside
// them stand two numbers for two cases that a person puts side by side. The first is four hexadecimal digits of a hash
// of the patient, with the same salt everywhere. Some fifteen of a million patients share them. The second is the
// examination's day, moved by a number of days that other digits of that hash give. So the days between a patient's
// examinations are right, and no date stands there.

#include <map>
#include <optional>
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

// What speaks against these series being of the patient whose anatomy the case holds, each said once. It may be another
// patient, another examination, another frame of reference or another place. Another place means that less than half of
// the smaller grid is shared. Nothing where the case has no anatomy.
[[nodiscard]] std::vector<Sentence> doubts_of_belonging(const Case& patient, const imaging::Study& study,
                                                        const std::vector<SeriesRole>& roles);

// Whether these series would put another anatomy in the place of the case's.
[[nodiscard]] bool would_replace_anatomy(const Case& patient, const std::vector<SeriesRole>& roles);

// Whether the images of two cases name the same patient. Unknown where either names none, or was imported before cases
// kept this. Two patients are taken for one in one of 65,536 pairs.
enum class SamePatient { yes, no, unknown };
[[nodiscard]] SamePatient same_patient(const Case& a, const Case& b);

// From the examination of one case to that of the other; nothing where the images do not name the same patient and both
// dates.
[[nodiscard]] std::optional<int> days_between(const Case& earlier, const Case& later);

}  // namespace glisson::casefile
