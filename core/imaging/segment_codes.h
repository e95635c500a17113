#pragma once
// What a segment is, in the words of SNOMED CT, as DICOM and 3D Slicer exchange them.

#include <optional>
#include <string>
#include <string_view>

namespace glisson::imaging {

struct CodedConcept {
  const char* value;  // of SNOMED CT (scheme "SCT")
  const char* meaning;
};

struct SegmentCode {
  CodedConcept category, type;
};

// By the segment's name: "liver", "tumour-2", "segment IV" of Couinaud's. Any other name is tissue.
// Source: DICOM PS3.16, CID 7150 (categories), 7151 and following (types), 7170 (Couinaud's segments).
[[nodiscard]] SegmentCode segment_code(std::string_view name);

// The category or type with that code, of those that segment_code() answers with.
[[nodiscard]] std::optional<CodedConcept> segment_concept(std::string_view code);

// segment_code() as 3D Slicer keeps it in the field SegmentN_Tags (vtkMRMLSegmentationStorageNode).
[[nodiscard]] std::string slicer_tags(std::string_view name);

}  // namespace glisson::imaging
