// From values to names, and which maps belong to an anatomy.

#include "casefile/label_map.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cctype>
#include <Eigen/Geometry>
#include <optional>
#include <string_view>

#include "base/text.h"
#include "base/units.h"
#include "imaging/label_names.h"
#include "imaging/volume_file.h"
#include "segmentation/structures.h"

namespace glisson::casefile {
namespace fs = std::filesystem;
namespace {

using imaging::Grid;
using segmentation::Place;

struct Counted {
  std::size_t voxels = 0;
  Eigen::Vector3d sum_mm{0, 0, 0};
  [[nodiscard]] Eigen::Vector3d centre_mm() const { return sum_mm / static_cast<double>(voxels); }
};
std::map<int, Counted> count(const imaging::LabelMap& labels);
Result<void> take_given(const std::map<int, std::string>& given, const fs::path& file, ReadLabelMap& map);
void take_from_file(const imaging::LabelNames& names, ReadLabelMap& map);
void take_from_numbers(const std::map<int, Counted>& counted, ReadLabelMap& map);
std::string structure_in_file_name(const fs::path& file);
bool names_nothing(const std::string& name);
bool known(const std::string& structure) { return segmentation::known_structure(structure).place != Place::unknown; }

}  // namespace

Result<ReadLabelMap> read_label_map(const fs::path& file, const std::map<int, std::string>& given) {
  auto labels = imaging::read_labels_file(file);
  if (!labels) return failure(std::move(labels.error()));
  const auto counted = count(*labels);
  if (counted.empty()) {
    return failure(Error{"labels-empty", GLISSON_TEXT("{0} has no labelled voxel."), {file.string()}, {}, file});
  }
  ReadLabelMap map{*std::move(labels), {}, {}};
  for (const auto& [value, found] : counted) {
    const double volume_mm3 = static_cast<double>(found.voxels) * map.labels.grid.voxel_volume_mm3();
    map.parts.push_back({value, {}, {}, units::ml_from_mm3(volume_mm3)});
  }
  const imaging::LabelNames names = imaging::label_names(file);
  take_from_file(names, map);
  const bool named =
      std::any_of(map.parts.begin(), map.parts.end(), [](const LabelledPart& part) { return !part.structure.empty(); });
  if (!named && map.parts.size() == 1) {
    map.parts.front().structure = structure_in_file_name(file);
    if (!map.parts.front().structure.empty()) map.named_by = {GLISSON_TEXT("Named after the file."), {}};
  } else if (!named) {
    take_from_numbers(counted, map);
  }
  if (auto taken = take_given(given, file, map); !taken) return failure(taken.error());
  return map;
}

imaging::Mask mask_of(const ReadLabelMap& map, const std::string& structure) {
  std::vector<std::uint8_t> wanted(65536);
  for (const LabelledPart& part : map.parts) {
    if (part.structure == structure) wanted[static_cast<std::size_t>(part.value)] = 1;
  }
  imaging::Mask mask{map.labels.grid, std::vector<std::uint8_t>(map.labels.values.size())};
  std::transform(map.labels.values.begin(), map.labels.values.end(), mask.values.begin(),
                 [&](std::uint16_t value) { return wanted[value]; });
  return mask;
}

bool is_label_map(const imaging::Series& series) {
  return series.files.size() == 1 && imaging::has_volume_file_name(series.files.front());
}

std::vector<std::size_t> label_maps_on(const imaging::Study& study, const imaging::Series& anatomy) {
  constexpr double same = 0.98, minimum = 0.5;  // of the place that they share
  struct Candidate {
    std::size_t series;
    bool whole;  // both cover the same place
    std::ptrdiff_t folders_apart;
  };
  const fs::path home = anatomy.files.front().parent_path();
  std::vector<Candidate> candidates;
  for (std::size_t k = 0; k < study.series.size(); ++k) {
    const imaging::Series& series = study.series[k];
    if (series.role != imaging::Role::segmentation || !is_label_map(series)) continue;
    const double shared = shared_place(series.grid, anatomy.grid);
    if (shared < minimum) continue;
    const double larger = std::max(series.grid.voxel_volume_mm3() * static_cast<double>(series.grid.voxels()),
                                   anatomy.grid.voxel_volume_mm3() * static_cast<double>(anatomy.grid.voxels()));
    const double smaller = std::min(series.grid.voxel_volume_mm3() * static_cast<double>(series.grid.voxels()),
                                    anatomy.grid.voxel_volume_mm3() * static_cast<double>(anatomy.grid.voxels()));
    const fs::path way = series.files.front().parent_path().lexically_relative(home);
    const auto apart = way == "." ? 0 : std::distance(way.begin(), way.end());
    candidates.push_back({k, shared > same && smaller > same * larger, apart});
  }
  const bool any_whole = std::any_of(candidates.begin(), candidates.end(), [](const auto& one) { return one.whole; });
  std::erase_if(candidates, [&](const Candidate& one) { return one.whole != any_whole; });
  std::ptrdiff_t nearest = std::numeric_limits<std::ptrdiff_t>::max();
  for (const Candidate& one : candidates) nearest = std::min(nearest, one.folders_apart);
  std::vector<std::size_t> found;
  for (const Candidate& one : candidates) {
    if (one.folders_apart == nearest) found.push_back(one.series);
  }
  return found;
}

double shared_place(const Grid& a, const Grid& b) {
  const auto box = [](const Grid& grid) {
    Eigen::AlignedBox3d around;
    for (int corner = 0; corner < 8; ++corner) {
      Eigen::Vector3d index;
      for (int axis = 0; axis < 3; ++axis) {
        index[axis] = (corner >> axis & 1) != 0 ? grid.size[static_cast<std::size_t>(axis)] - 0.5 : -0.5;
      }
      around.extend(grid.position_mm(index));
    }
    return around;
  };
  const Eigen::AlignedBox3d of_a = box(a), of_b = box(b), both = of_a.intersection(of_b);
  const double smaller = std::min(of_a.volume(), of_b.volume());
  return both.isEmpty() || smaller <= 0 ? 0.0 : both.volume() / smaller;
}

std::string structure_name(const std::string& name) {
  std::string simple;
  for (const char c : name) {
    if (std::isalnum(static_cast<unsigned char>(c))) {
      simple += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    } else if (!simple.empty() && simple.back() != '-') {
      simple += '-';
    }
  }
  while (simple.ends_with('-')) simple.pop_back();
  return simple.empty() ? "structure" : simple;
}

std::string usual_structure_name(const std::string& name) {
  struct Usual {
    std::string_view theirs, ours;
  };
  constexpr std::array<Usual, 25> words{{{"inferior-vena-cava", "vena-cava"},
                                         {"ivc", "vena-cava"},
                                         {"postcava", "vena-cava"},
                                         {"portal-vein-and-splenic-vein", "portal-vein"},
                                         {"portal-veins", "portal-vein"},
                                         {"hepatic-veins", "hepatic-vein"},
                                         {"hepatic-artery", "artery"},
                                         {"hepatic-arteries", "artery"},
                                         {"arteries", "artery"},
                                         {"gall-bladder", "gallbladder"},
                                         {"bile-duct", "biliary-tract"},
                                         {"bile-ducts", "biliary-tract"},
                                         {"biliary-tree", "biliary-tract"},
                                         {"right-kidney", "kidney-right"},
                                         {"left-kidney", "kidney-left"},
                                         {"right-adrenal-gland", "adrenal-gland-right"},
                                         {"left-adrenal-gland", "adrenal-gland-left"},
                                         {"oesophagus", "esophagus"},
                                         {"liver-tumor", "tumour"},
                                         {"liver-tumour", "tumour"},
                                         {"liver-lesion", "tumour"},
                                         {"tumor", "tumour"},
                                         {"lesion", "tumour"},
                                         {"liver-cyst", "cyst"},
                                         {"livercyst", "cyst"}}};
  const std::string simple = structure_name(name);
  for (const Usual& word : words) {
    if (simple == word.theirs) return std::string(word.ours);
    // A number behind it stays.
    const std::string_view rest = std::string_view(simple).substr(std::min(simple.size(), word.theirs.size()));
    const bool numbered = simple.starts_with(word.theirs) && rest.size() > 1 && rest.front() == '-' &&
                          std::all_of(rest.begin() + 1, rest.end(), [](char c) { return c >= '0' && c <= '9'; });
    if (numbered) return std::string(word.ours) + std::string(rest);
  }
  return simple;
}

std::optional<std::pair<int, std::string>> named_value(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals + 1 == text.size()) return std::nullopt;
  const auto value = read_whole_number<int>(std::string_view(text).substr(0, equals));
  if (!value || *value < 1 || *value > 65535) return std::nullopt;
  return std::pair(*value, text.substr(equals + 1));
}

namespace {

std::map<int, Counted> count(const imaging::LabelMap& labels) {
  std::vector<Counted> of_value(65536);
  for (int k = 0; k < labels.grid.size[2]; ++k) {
    for (int j = 0; j < labels.grid.size[1]; ++j) {
      for (int i = 0; i < labels.grid.size[0]; ++i) {
        const std::uint16_t value = labels.at(i, j, k);
        if (value == 0) continue;
        ++of_value[value].voxels;
        of_value[value].sum_mm += labels.grid.position_mm(i, j, k);
      }
    }
  }
  std::map<int, Counted> found;
  for (std::size_t value = 1; value < of_value.size(); ++value) {
    if (of_value[value].voxels > 0) found[static_cast<int>(value)] = of_value[value];
  }
  return found;
}

Result<void> take_given(const std::map<int, std::string>& given, const fs::path& file, ReadLabelMap& map) {
  if (given.empty()) return {};
  std::string values;
  for (LabelledPart& part : map.parts) {
    const auto found = given.find(part.value);
    part.structure = found == given.end() || found->second.empty() ? std::string() : structure_name(found->second);
    values += fmt::format("{}{}", values.empty() ? "" : ", ", part.value);
  }
  map.named_by = {GLISSON_TEXT("Named by you."), {}};
  for (const auto& each : given) {
    const int value = each.first;
    if (std::any_of(map.parts.begin(), map.parts.end(), [&](const auto& part) { return part.value == value; }))
      continue;
    return failure(Error{"labels-no-such-value",
                         GLISSON_TEXT("{0} has no label {2}; it holds {1}."),
                         {file.string(), values, std::to_string(value)},
                         GLISSON_TEXT("Choose one with --label-value."),
                         file});
  }
  return {};
}

// A table of classes names what the map may hold; segments and descriptions were written for this map.
void take_from_file(const imaging::LabelNames& names, ReadLabelMap& map) {
  using imaging::NamedBy;
  if (names.by == NamedBy::nothing) return;
  bool any = false;
  for (LabelledPart& part : map.parts) {
    const auto found = names.name_of.find(part.value);
    if (found == names.name_of.end() || names_nothing(found->second)) continue;
    part.written = found->second;
    const std::string structure = usual_structure_name(found->second);
    if (names.by == NamedBy::nifti_table && !known(structure)) continue;
    part.structure = structure;
    any = true;
  }
  if (!any) return;
  map.named_by = {names.by == NamedBy::slicer_fields ? GLISSON_TEXT("Named by 3D Slicer's segments.")
                  : names.by == NamedBy::nifti_table ? GLISSON_TEXT("Named by the table in the file.")
                                                     : GLISSON_TEXT("Named by the label description beside the file."),
                  {}};
}

// TotalSegmentator's class numbers (github.com/wasserth/TotalSegmentator, totalsegmentator/map_to_binary.py), as far as
// its versions 1 and 2 and its classes for MR agree. A map is plainly its own where it holds many classes and these lie
// as in a body: the liver is the largest of them, to the right of the spleen, and the right kidney to that of the left.
void take_from_numbers(const std::map<int, Counted>& counted, ReadLabelMap& map) {
  constexpr std::array<std::string_view, 6> classes{"spleen",      "kidney-right", "kidney-left",
                                                    "gallbladder", "liver",        "stomach"};
  constexpr std::size_t minimum_classes = 12;
  const auto right_of = [&](int right, int left) {
    return counted.contains(right) && counted.contains(left) &&
           counted.at(right).centre_mm().x() < counted.at(left).centre_mm().x();
  };
  if (counted.size() < minimum_classes || !right_of(5, 1)) return;
  if (counted.contains(2) && counted.contains(3) && !right_of(2, 3)) return;
  for (int value = 1; value <= static_cast<int>(classes.size()); ++value) {
    if (value != 5 && counted.contains(value) && counted.at(value).voxels >= counted.at(5).voxels) return;
  }
  for (LabelledPart& part : map.parts) {
    if (part.value <= static_cast<int>(classes.size()))
      part.structure = classes[static_cast<std::size_t>(part.value - 1)];
  }
  map.named_by = {GLISSON_TEXT("Named by TotalSegmentator's class numbers: see whether they are right."), {}};
}

// "Label 3" and "Segment_3" are what ITK-SNAP and 3D Slicer write where nobody gave a name.
bool names_nothing(const std::string& name) {
  const std::string simple = structure_name(name);
  for (const std::string_view word : {"label", "segment", "structure"}) {
    if (simple == word) return true;
    if (!simple.starts_with(word)) continue;
    const std::string_view rest = std::string_view(simple).substr(word.size());
    if (std::all_of(rest.begin(), rest.end(), [](char c) { return c == '-' || (c >= '0' && c <= '9'); })) return true;
  }
  return false;
}

// "3Dircadb-10_liver.nii.gz", "liver_seg.nrrd" -> "liver"; empty where the last words are none that Glisson knows.
std::string structure_in_file_name(const fs::path& file) {
  const std::string whole = file.filename().string();
  std::string name = structure_name(whole.substr(0, whole.find('.')));
  for (const std::string_view ending : {"-seg", "-segmentation", "-label", "-labels", "-mask"}) {
    if (name.ends_with(ending)) name.resize(name.size() - ending.size());
  }
  for (std::size_t from = 0; from != std::string::npos; from = name.find('-', from)) {
    if (from > 0) ++from;
    const std::string structure = usual_structure_name(name.substr(from));
    if (known(structure)) return structure;
    if (from >= name.size()) break;
  }
  return {};
}

}  // namespace
}  // namespace glisson::casefile
