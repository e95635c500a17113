#pragma once
// A case's contents as files for other programs.

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/progress.h"
#include "casefile/case.h"

namespace glisson::casefile {

enum class ExportFormat {
  nrrd,       // volumes, labels and Couinaud's segments, one file each, into a folder
  nifti,      // the same as .nii.gz
  dicom_seg,  // all labels and Couinaud's segments in one DICOM SEG file
  stl,        // surfaces, one file each, into a folder
  obj,
  vtp,
  vtu  // the model's tetrahedra (or, before it has stiffness, the mesh) in one file
};
// "nrrd", "nifti", "dicom-seg", "stl", "obj", "vtp", "vtu".
[[nodiscard]] std::optional<ExportFormat> export_format(std::string_view name);

// What a DICOM SEG carries beside the labels.
struct SegmentationExport {
  // The images that the case was made from. The file carries their identity (the patient's name and number, the study,
  // each slice), so that an archive can file it with them. Without them it names nobody.
  std::optional<std::filesystem::path> study = {};
  std::optional<std::string> plan = {};  // a plan of the case, whose "remnant" and "specimen" go along
};

// The files that were written, each whole. `out` is a file or a folder, as the format says. Fails with
// "export-nothing" where the case has nothing of that kind, "export-other-study" where those are not the case's images,
// "plan-unknown", or "model-of-another" as read_model does.
Result<std::vector<std::filesystem::path>> export_case(const Case& patient, ExportFormat format,
                                                       const std::filesystem::path& out, const Progress& progress = {},
                                                       const SegmentationExport& with = {});

// What a person should know of what goes out: which of it is not as it was saved.
[[nodiscard]] std::vector<Sentence> export_remarks(const Case& patient, ExportFormat format);

}  // namespace glisson::casefile
