// Label maps and DICOM SEGs become structures.

#include "casefile/import_labels.h"

#include <fmt/format.h>
#include <algorithm>
#include <set>

#include "base/files.h"
#include "casefile/label_map.h"
#include "imaging/dicom_seg.h"
#include "imaging/volume_file.h"
#include "segmentation/plausibility.h"
#include "segmentation/resample.h"
#include "segmentation/structures.h"

namespace glisson::casefile {
namespace fs = std::filesystem;
namespace {

using imaging::Series;

// One structure as a file brings it.
struct Brought {
  std::string name;
  imaging::Mask mask;
  std::array<double, 3> color_rgb;
  Provenance made;
};
struct Read {
  std::vector<Brought> structures;
  std::vector<LabelledPart> unnamed;
};
Result<Read> read_dicom(const Series& series);
Result<Read> read_map(const WantedLabels& wanted);
Failure nothing_named(const std::vector<WantedLabels>& wanted, const std::vector<LabelledPart>& unnamed);
Failure brought_twice(const std::string& name, const std::string& second);
Failure outside(const Series& series);
std::string without_names_of(const Series& series, std::string text);

}  // namespace

Result<std::vector<ImportedStructure>> import_labels(Case& patient, const std::vector<WantedLabels>& wanted,
                                                     const imaging::Grid& anatomy, const Progress& progress) {
  std::vector<ImportedStructure> imported;
  std::vector<LabelledPart> unnamed;
  std::set<std::string> names;
  for (std::size_t k = 0; k < wanted.size(); ++k) {
    if (progress.cancelled()) return cancelled();
    progress.report(static_cast<double>(k) / static_cast<double>(wanted.size()), GLISSON_TEXT("Reading the labels"));
    const Series& series = *wanted[k].series;
    auto read = is_label_map(series) ? read_map(wanted[k]) : read_dicom(series);
    if (!read) {
      if (read.error().code == "labels-empty" && wanted.size() > 1) continue;  // of many masks some are empty
      return failure(read.error());
    }
    unnamed.insert(unnamed.end(), read->unnamed.begin(), read->unnamed.end());
    bool any_inside = read->structures.empty();
    for (Brought& brought : read->structures) {
      if (!names.insert(brought.name).second) return brought_twice(brought.name, series.files.front().string());
      const imaging::Mask mask = segmentation::resample(brought.mask, anatomy);
      if (segmentation::voxel_count(mask) == 0) continue;
      any_inside = true;
      if (!imaging::same_grid(brought.mask.grid, anatomy)) {
        const auto& size = brought.mask.grid.size;
        brought.made.notes.push_back(
            {GLISSON_TEXT("Drawn on another grid ({0} x {1} x {2}) and carried to the anatomy's, each voxel from the "
                          "nearest one."),
             {std::to_string(size[0]), std::to_string(size[1]), std::to_string(size[2])}});
      }
      brought.made.from.emplace_back("volumes/anatomy");
      if (!wanted[k].drawn_by.empty()) brought.made.options["program"] = wanted[k].drawn_by;
      if (brought.name == "liver") {
        const auto image = patient.volume("volumes/anatomy");
        const bool fits = image && imaging::same_grid(image->grid, mask.grid);
        const auto odd = fits ? segmentation::doubt_of_liver(mask, *image) : std::nullopt;
        if (odd) brought.made.notes.push_back(*odd);
      }
      const std::string id = "labels/" + brought.name;
      imported.push_back({id, segmentation::volume_ml(mask), brought.made.notes});
      auto added = patient.add(id, ".nrrd", std::move(brought.made), [&](const auto& file) {
        return imaging::write_mask_file(file, mask, {brought.name, 1, brought.color_rgb});
      });
      if (!added) return failure(added.error());
    }
    if (!any_inside) return outside(series);
  }
  if (imported.empty() && !wanted.empty()) return nothing_named(wanted, unnamed);
  return imported;
}

// Descriptions, numbers and names of files often name the patient; what was taken in is known by its content.
Provenance made_from(const Series& series) {
  Provenance made{"import", {}, {}, {}, {}};
  std::string contents;
  for (std::size_t n = 0; n < series.files.size(); ++n) {
    const std::string content = sha256_of_file(series.files[n]).value_or("unreadable");
    made.sources[fmt::format("file-{:05}", n + 1)] = content;
    contents += content;
  }
  made.options["series"] = sha256_of_text(contents).substr(0, 16);
  for (const std::string& problem : series.problems) made.notes.push_back({without_names_of(series, problem), {}});
  return made;
}

namespace {

// Of its files, and of others beside them (a copy that was left out).
std::string without_names_of(const Series& series, std::string text) {
  std::set<fs::path> folders;
  for (const fs::path& file : series.files) folders.insert(file.parent_path());
  std::set<std::string> names;
  for (const fs::path& folder : folders) {
    std::error_code problem;
    for (fs::directory_iterator file(folder, problem), end; !problem && file != end; file.increment(problem)) {
      names.insert(file->path().filename().string());
    }
    names.insert(folder.string());
  }
  // The longest first, so that none is left that another is part of.
  std::vector<std::string> in_order(names.begin(), names.end());
  std::stable_sort(in_order.begin(), in_order.end(), [](const auto& a, const auto& b) { return a.size() > b.size(); });
  for (const std::string& name : in_order) {
    if (name.size() < 3) continue;
    for (std::size_t at = text.find(name); at != std::string::npos; at = text.find(name, at + 3)) {
      text.replace(at, name.size(), "...");
    }
  }
  return text;
}

Result<Read> read_dicom(const Series& series) {
  auto segments = imaging::read_dicom_seg(series.files.front());
  if (!segments) return failure(segments.error());
  Read read;
  for (imaging::SegmentedMask& segment : *segments) {
    Provenance made = made_from(series);
    // Of several "Tumour" each is kept.
    const std::string name = structure_name(segment.info.name);
    const auto taken = [&](const std::string& candidate) {
      return std::any_of(read.structures.begin(), read.structures.end(),
                         [&](const Brought& one) { return one.name == candidate; });
    };
    std::string free = name;
    for (int number = 2; taken(free); ++number) free = fmt::format("{}-{}", name, number);
    read.structures.push_back({free, std::move(segment.mask), segment.info.color_rgb, std::move(made)});
  }
  return read;
}

std::string value_and_volume(const LabelledPart& part) {
  return fmt::format("{} ({:.1f} ml{}{})", part.value, part.volume_ml, part.written.empty() ? "" : ", ", part.written);
}

// A few by name: a whole-body map has a hundred.
Sentence left_out(const std::vector<LabelledPart>& parts) {
  constexpr std::size_t named = 5;
  std::string names;
  for (std::size_t k = 0; k < std::min(named, parts.size()); ++k) {
    const LabelledPart& part = parts[k];
    names += (k == 0 ? "" : ", ") + (part.written.empty() ? std::to_string(part.value) : part.written);
  }
  if (parts.size() <= named) return {GLISSON_TEXT("Left out of the label map: {0}."), {names}};
  return {GLISSON_TEXT("Left out of the label map: {0} and {1} more."), {names, std::to_string(parts.size() - named)}};
}

Result<Read> read_map(const WantedLabels& wanted) {
  const Series& series = *wanted.series;
  const auto map = read_label_map(series.files.front(), wanted.names);
  if (!map) return failure(map.error());
  Read read;
  for (const LabelledPart& part : map->parts) {
    if (part.structure.empty()) read.unnamed.push_back(part);
  }
  for (const LabelledPart& part : map->parts) {
    const auto same = [&](const Brought& one) { return one.name == part.structure; };
    if (part.structure.empty() || std::any_of(read.structures.begin(), read.structures.end(), same)) continue;
    Provenance made = made_from(series);
    made.options["label-value"] = std::to_string(part.value);
    if (!map->named_by.text.empty()) made.notes.push_back(map->named_by);
    if (!read.unnamed.empty()) made.notes.push_back(left_out(read.unnamed));
    read.structures.push_back({part.structure, mask_of(*map, part.structure),
                               segmentation::known_structure(part.structure).color_rgb, std::move(made)});
  }
  return read;
}

Failure nothing_named(const std::vector<WantedLabels>& wanted, const std::vector<LabelledPart>& unnamed) {
  constexpr std::size_t maximum = 12;
  std::string values;
  for (std::size_t k = 0; k < std::min(maximum, unnamed.size()); ++k) {
    values += (k == 0 ? "" : ", ") + value_and_volume(unnamed[k]);
  }
  if (unnamed.size() > maximum) values += ", ...";
  return failure(Error{"labels-unnamed",
                       GLISSON_TEXT("Nothing says what the values of {0} are: {1}."),
                       {wanted.front().series->files.front().string(), values},
                       GLISSON_TEXT("Name them, as in --label-value 1=liver --label-value 2=tumour-1."),
                       wanted.front().series->files.front()});
}

Failure brought_twice(const std::string& name, const std::string& second) {
  return failure(Error{"labels-twice",
                       GLISSON_TEXT("Two files bring the structure {0}: {1} is the second."),
                       {name, second},
                       GLISSON_TEXT("Leave one of them out (--labels UID takes that label map alone)."),
                       second});
}

Failure outside(const Series& series) {
  return failure(Error{"labels-no-overlap",
                       GLISSON_TEXT("No voxel of {0} lies inside the anatomy."),
                       {series.files.front().string()},
                       GLISSON_TEXT("Check that both belong to the same patient and frame of reference."),
                       series.files.front()});
}

}  // namespace
}  // namespace glisson::casefile
