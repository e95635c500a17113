#pragma once
// Structures outlined by somebody else's program, such as a neural network. The case's anatomy is handed to it as a
// file. The label maps that it leaves become structures of the case.

#include <map>
#include <string>
#include <vector>

#include "base/progress.h"
#include "casefile/case.h"
#include "casefile/import_labels.h"

namespace glisson::casefile {

struct OutliningProgram {
  // "TotalSegmentator -i {image} -o {folder}": words as base/run_program.h splits them, in which these are replaced.
  //   {image}         the anatomy as .nii.gz (float; HU, or as measured), named as nnU-Net wants it:
  //   anatomy_0000.nii.gz {image_folder}  the folder in which it lies alone {folder}        an empty folder for what
  //   the program writes: one file a structure, or one for all {labels}        a file in that folder, labels.nii.gz,
  //   for a program that writes one
  std::string command;
  // A name for each value of its label maps, where neither they nor their files' names say it. It may find less.
  std::map<int, std::string> names = {};
};

// Runs it, and takes in what it outlined (import_labels.h); structures of the same names are replaced. Files whose
// names say no structure that Glisson knows stay out. Fails with "command-no-image" or "command-no-labels" where the
// command lacks a placeholder. Fails with "program-no-labels" where no label map was left. Fails also as run_program,
// words_of_command, Case::volume and import_labels do. Then the case is as it was.
Result<std::vector<ImportedStructure>> outline_by_program(Case& patient, const OutliningProgram& program,
                                                          const Progress& progress = {});

}  // namespace glisson::casefile
