#pragma once
// What the values of a label map stand for, as far as the file, or one beside it, says:
//
// - 3D Slicer: NRRD fields SegmentN_Name and SegmentN_LabelValue (vtkMRMLSegmentationStorageNode).
// - TotalSegmentator: a table of labels, <Label Key="5">, in the extension of the NIfTI header.
// - ITK-SNAP: a label description file in the folder of the map: number, colour, flags, "name" on a line.
//
// The size of what is read is bounded; a header that cannot be read names nothing.

#include <filesystem>
#include <map>
#include <optional>
#include <string>

namespace glisson::imaging {

enum class NamedBy { nothing, slicer_fields, nifti_table, description_file };

struct LabelNames {
  std::map<int, std::string> name_of;  // by value, as they stand there; a table may name values that the map lacks
  NamedBy by = NamedBy::nothing;
};

[[nodiscard]] LabelNames label_names(const std::filesystem::path& label_map);

// A label description file of ITK-SNAP: lines of index, red, green, blue, alpha, two flags and a name in quotes, with
// comments from "#" on. None where a line is anything else.
[[nodiscard]] std::optional<std::map<int, std::string>> label_descriptions(const std::string& text);

}  // namespace glisson::imaging
