#pragma once
// Structures that others outlined, taken into a case on the grid of its anatomy.

#include <map>
#include <string>
#include <vector>

#include "base/progress.h"
#include "casefile/case.h"
#include "imaging/study.h"

namespace glisson::casefile {

// A segmentation that is wanted, and a person's names for its values (a label map's alone; see label_map.h).
struct WantedLabels {
  const imaging::Series* series;
  std::map<int, std::string> names = {};
  std::string drawn_by = {};  // the command of the program that drew it just now; goes into how the entry was made
};

struct ImportedStructure {
  std::string id;  // "labels/liver"
  double volume_ml = 0;
  std::vector<Sentence> notes;  // how it was named, what was left out, whether it was carried to another grid
};

// Labels are drawn on `anatomy`'s grid: of another grid each voxel takes the value of the nearest one. Fails with
// "labels-unnamed" where nothing names any structure, and says which values there are. Fails with "labels-twice" where
// two files bring the same structure. Fails with "labels-no-overlap" where none of it lies in the anatomy, or as
// reading fails.
Result<std::vector<ImportedStructure>> import_labels(Case& patient, const std::vector<WantedLabels>& wanted,
                                                     const imaging::Grid& anatomy, const Progress& progress);

// How an entry that comes of a series was made.
[[nodiscard]] Provenance made_from(const imaging::Series& series);

}  // namespace glisson::casefile
