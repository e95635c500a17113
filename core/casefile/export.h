#pragma once
// A case's contents as files for other programs.

#include <filesystem>
#include <optional>
#include <string_view>
#include <vector>

#include "base/progress.h"
#include "casefile/case.h"

namespace glisson::casefile {

enum class ExportFormat {
  nrrd,       // volumes and labels, one file each, into a folder
  nifti,      // the same as .nii.gz
  dicom_seg,  // all labels in one DICOM SEG file
  stl,        // surfaces, one file each, into a folder
  obj,
  vtp,
  vtu  // the model's tetrahedra (or, before it has stiffness, the mesh) in one file
};
// "nrrd", "nifti", "dicom-seg", "stl", "obj", "vtp", "vtu".
[[nodiscard]] std::optional<ExportFormat> export_format(std::string_view name);

// The files that were written, each whole. `out` is a file or a folder, as the format says. `study`, of a DICOM SEG:
// the images that the case was made from, whose identity the file is to carry (the patient's name and number, the
// study, each slice), so that an archive can put it to them; without them it names nobody. Fails with "export-nothing"
// where the case has nothing of that kind, "export-other-study" where those are not the case's images, or
// "model-of-another" as read_model does.
Result<std::vector<std::filesystem::path>> export_case(const Case& patient, ExportFormat format,
                                                       const std::filesystem::path& out, const Progress& progress = {},
                                                       const std::optional<std::filesystem::path>& study = {});

// What a person should know of what goes out: which of it is not as it was saved.
[[nodiscard]] std::vector<Sentence> export_remarks(const Case& patient, ExportFormat format);

}  // namespace glisson::casefile
