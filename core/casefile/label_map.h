#pragma once
// Label maps that other programs wrote, on their way to being structures of a case.
//
// A value's name comes from the person, else from the file (imaging/label_names.h). A map of one value may take it from
// the file's own name ("liver.nii.gz"). Last come TotalSegmentator's numbers, where the map is plainly its. Names that
// Glisson has another word for are given that: "portal_vein_and_splenic_vein" is "portal-vein".

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "base/sentence.h"
#include "imaging/image.h"
#include "imaging/study.h"

namespace glisson::casefile {

struct LabelledPart {
  int value = 0;
  std::string written;    // as the file calls it; empty where nothing does
  std::string structure;  // what it becomes, "kidney-left"; empty: it is left out
  double volume_ml = 0;
};

struct ReadLabelMap {
  imaging::LabelMap labels;
  std::vector<LabelledPart> parts;  // every value but 0 that the map holds, in order
  Sentence named_by;                // how the names came; an empty text where nothing names them
};

// `given` are a person's names by value: where there are any, values without one are left out. Of a table of hundreds
// of classes only what Glisson knows is taken. Fails as imaging::read_labels_file does; "labels-empty" where no voxel
// is labelled; "labels-no-such-value" where a given value is not in the map.
[[nodiscard]] Result<ReadLabelMap> read_label_map(const std::filesystem::path& file,
                                                  const std::map<int, std::string>& given = {});

// The voxels of all parts that become one structure; Couinaud's eight segments may all be the liver.
[[nodiscard]] imaging::Mask mask_of(const ReadLabelMap& map, const std::string& structure);

// Whether a series that is to be a segmentation lies in a volume file, and not in a DICOM SEG.
[[nodiscard]] bool is_label_map(const imaging::Series& series);

// Those of the study's label maps that were drawn on this anatomy: the best fit in space first, and of equals those of
// the nearest folder. Positions in study.series. None that shares less than half of its place with the anatomy.
[[nodiscard]] std::vector<std::size_t> label_maps_on(const imaging::Study& study, const imaging::Series& anatomy);

// How much of the smaller one's place two grids share: boxes along the patient's axes, 0 to 1.
[[nodiscard]] double shared_place(const imaging::Grid& a, const imaging::Grid& b);

// "Hepatic Vein, left" -> "hepatic-vein-left": a name that serves as a file name and on the command line.
[[nodiscard]] std::string structure_name(const std::string& name);

// The same with Glisson's own word for it: "liver_tumor_2" -> "tumour-2", "inferior_vena_cava" -> "vena-cava".
[[nodiscard]] std::string usual_structure_name(const std::string& name);

// "5=liver" as a person types it: a value of 1 to 65535 and its name; nothing where it is anything else.
[[nodiscard]] std::optional<std::pair<int, std::string>> named_value(const std::string& text);

}  // namespace glisson::casefile
