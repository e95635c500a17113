#include "imaging/segment_codes.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <span>

namespace glisson::imaging {
namespace {

constexpr CodedConcept anatomical{"123037004", "Anatomical Structure"};
constexpr CodedConcept altered{"49755003", "Morphologically Altered Structure"};
constexpr CodedConcept tissue{"85756007", "Tissue"};

struct NamedCode {
  std::string_view name;
  SegmentCode code;
};

// Whole names; then beginnings of names, since structures of a kind are numbered.
constexpr std::array segments_of_the_liver = {
    NamedCode{"segment I", {anatomical, {"71133005", "Couinaud hepatic segment I"}}},
    NamedCode{"segment II", {anatomical, {"277956007", "Couinaud hepatic segment II"}}},
    NamedCode{"segment III", {anatomical, {"277957003", "Couinaud hepatic segment III"}}},
    NamedCode{"segment IV", {anatomical, {"277958008", "Couinaud hepatic segment IV"}}},
    NamedCode{"segment V", {anatomical, {"277959000", "Couinaud hepatic segment V"}}},
    NamedCode{"segment VI", {anatomical, {"277960005", "Couinaud hepatic segment VI"}}},
    NamedCode{"segment VII", {anatomical, {"277961009", "Couinaud hepatic segment VII"}}},
    NamedCode{"segment VIII", {anatomical, {"277962002", "Couinaud hepatic segment VIII"}}}};
constexpr std::array structures = {NamedCode{"liver", {anatomical, {"10200004", "Liver"}}},
                                   NamedCode{"portal-vein", {anatomical, {"32764006", "Portal vein"}}},
                                   NamedCode{"hepatic-vein", {anatomical, {"8993003", "Hepatic vein"}}},
                                   NamedCode{"gallbladder", {anatomical, {"28231008", "Gallbladder"}}},
                                   NamedCode{"artery", {anatomical, {"51114001", "Artery"}}},
                                   NamedCode{"tumour", {altered, {"108369006", "Neoplasm"}}},
                                   NamedCode{"cyst", {altered, {"367643001", "Cyst"}}}};

}  // namespace

SegmentCode segment_code(std::string_view name) {
  const auto* segment = std::find_if(segments_of_the_liver.begin(), segments_of_the_liver.end(),
                                     [&](const NamedCode& known) { return name == known.name; });
  if (segment != segments_of_the_liver.end()) return segment->code;
  const auto* structure = std::find_if(structures.begin(), structures.end(),
                                       [&](const NamedCode& known) { return name.starts_with(known.name); });
  return structure != structures.end() ? structure->code : SegmentCode{tissue, tissue};
}

std::optional<CodedConcept> segment_concept(std::string_view code) {
  for (const CodedConcept& category : {anatomical, altered, tissue}) {
    if (code == category.value) return category;
  }
  for (const std::span<const NamedCode> named : {std::span<const NamedCode>(segments_of_the_liver), {structures}}) {
    for (const NamedCode& known : named) {
      if (code == known.code.type.value) return known.code.type;
    }
  }
  return std::nullopt;
}

std::string slicer_tags(std::string_view name) {
  const auto [category, type] = segment_code(name);
  return fmt::format(
      "TerminologyEntry:Segmentation category and type - DICOM master list~SCT^{}^{}~SCT^{}^{}~^^~Anatomic codes - "
      "DICOM master list~^^~^^|",
      category.value, category.meaning, type.value, type.meaning);
}

}  // namespace glisson::imaging
