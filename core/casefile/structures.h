#pragma once
// The structures of a case: grown from seeds, or taken from a file that somebody drew.

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "base/progress.h"
#include "base/sentence.h"
#include "casefile/case.h"
#include "segmentation/brush.h"
#include "segmentation/segment_vessels.h"
#include "segmentation/structures.h"

namespace glisson::casefile {

struct SavedStructure {
  std::string name;
  std::string id;  // of the entry: "labels/liver"
  std::size_t voxels = 0;
  double volume_ml = 0;
  std::vector<Sentence> notes;  // doubts about it
};

// Grows from points inside the structure (patient LPS, mm) on volumes/anatomy and saves the outcome. What is grown how
// follows the name: vessels and lesions by what stands out from the tissue around (segmentation/grow_contrast.h),
// organs as the liver is (grow.h). With `within`, the name of a structure of the case, a vessel or lesion stays inside
// of it. Fails with "structure-unknown" where there is none of that name.
Result<SavedStructure> grow_structure(Case& patient, const std::string& name,
                                      const std::vector<Eigen::Vector3d>& seeds_mm, const Progress& progress = {},
                                      const std::optional<std::string>& within = std::nullopt);

// Makes a structure of the vessels inside of `within` on volumes/anatomy, told by their shape (segment_vessels.h); with
// seeds (patient LPS, mm), of those that hang on them. Without a brightness what more of the tubes are counts. Fails
// with "structure-unknown" where there is no structure `within`, and as segment_vessels() does.
Result<SavedStructure> segment_vessels(Case& patient, const std::string& name,
                                       const std::vector<Eigen::Vector3d>& seeds_mm = {},
                                       const std::string& within = "liver",
                                       std::optional<segmentation::VesselBrightness> brightness = std::nullopt,
                                       const Progress& progress = {});

// Makes a structure of the voxels of volumes/anatomy whose grey value lies in the range, of those inside of `within`
// alone where it is given. Fails with "structure-unknown", and with "range-empty" where there is no such voxel.
Result<SavedStructure> threshold_structure(Case& patient, const std::string& name, const segmentation::GreyRange& range,
                                           const std::optional<std::string>& within = std::nullopt);

// Changes a structure by another one of the case, voxel by voxel; the other stays as it is. One that is not there yet
// counts as empty in a union. Fails with "structure-unknown" and, where both lie on different grids,
// "labels-grids-differ".
enum class Combination { unite, intersect, subtract };
Result<SavedStructure> combine_structure(Case& patient, const std::string& name, Combination how,
                                         const std::string& other);

// Takes a structure from a label file (NRRD, NIfTI, MetaImage, DICOM SEG), carried to the grid of volumes/anatomy.
// Without a label value the file must hold one structure only, or name one of them so (label_map.h). Else it fails with
// "labels-ambiguous" and says which values there are. Fails with "labels-no-overlap" where no labelled voxel lies in
// the anatomy.
Result<SavedStructure> import_structure(Case& patient, const std::string& name, const std::filesystem::path& labels,
                                        std::optional<int> label_value, const Progress& progress = {});

// Saves a structure that was edited; its name decides the entry.
Result<SavedStructure> save_structure(Case& patient, const segmentation::Structure& structure, Provenance made);

// All structures of the case, the liver first.
Result<std::vector<segmentation::Structure>> read_structures(const Case& patient);

}  // namespace glisson::casefile
