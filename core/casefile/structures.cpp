#include "casefile/structures.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <algorithm>

#include "base/files.h"
#include "casefile/internal/structure_making.h"
#include "casefile/label_map.h"
#include "imaging/dicom_seg.h"
#include "imaging/volume_file.h"
#include "segmentation/edit.h"
#include "segmentation/grow.h"
#include "segmentation/grow_contrast.h"
#include "segmentation/lesions.h"
#include "segmentation/plausibility.h"
#include "segmentation/resample.h"

namespace glisson::casefile {
namespace fs = std::filesystem;
namespace {

using segmentation::Structure;

struct Labelled {
  int value;
  std::string name;
  imaging::Mask mask;
};
Result<std::vector<Labelled>> read_labelled(const fs::path& file);
Result<Labelled> pick(std::vector<Labelled> found, const std::string& name, std::optional<int> label_value,
                      const fs::path& file);

Result<imaging::Mask> mask_named(const Case& patient, const std::string& name);
// That structure on the grid; none where none is named.
Result<std::optional<imaging::Mask>> mask_to_stay_in(const Case& patient, const std::optional<std::string>& name,
                                                     const imaging::Grid& grid);

struct Grown {
  imaging::Mask mask;
  std::vector<Sentence> notes;
};
Result<Grown> grow(const imaging::Volume& anatomy, const std::string& name,
                   const std::vector<Eigen::Vector3d>& seeds_mm, const imaging::Mask* within, const Progress& progress);

}  // namespace

Result<SavedStructure> grow_structure(Case& patient, const std::string& name,
                                      const std::vector<Eigen::Vector3d>& seeds_mm, const Progress& progress,
                                      const std::optional<std::string>& within) {
  const auto anatomy = patient.volume("volumes/anatomy");
  if (!anatomy) return failure(anatomy.error());
  const auto inside = mask_to_stay_in(patient, within, anatomy->grid);
  if (!inside) return failure(inside.error());
  auto grown = grow(*anatomy, name, seeds_mm, *inside ? &**inside : nullptr, progress);
  if (!grown) return failure(grown.error());

  Provenance made = made_from_seeds("seeds", seeds_mm);
  if (within) {
    made.options["within"] = *within;
    made.from.push_back("labels/" + *within);
  }
  std::vector<Sentence> notes = std::move(grown->notes);
  if (name == "liver") {
    auto whole = with_known_lesions(patient, std::move(grown->mask), made, notes);
    if (!whole) return failure(whole.error());
    grown->mask = std::move(*whole);
  }
  made.notes = notes;
  auto saved = save_structure(patient, segmentation::make_structure(name, std::move(grown->mask)), std::move(made));
  if (saved) saved->notes = std::move(notes);
  return saved;
}

Result<SavedStructure> segment_vessels(Case& patient, const std::string& name,
                                       const std::vector<Eigen::Vector3d>& seeds_mm, const std::string& within,
                                       std::optional<segmentation::VesselBrightness> brightness,
                                       const Progress& progress) {
  const auto anatomy = patient.volume("volumes/anatomy");
  if (!anatomy) return failure(anatomy.error());
  const auto inside = mask_named(patient, within);
  if (!inside) return failure(inside.error());
  segmentation::SegmentVesselsOptions options;
  options.brightness = brightness;
  auto found = segmentation::segment_vessels(*anatomy, segmentation::resample(*inside, anatomy->grid), seeds_mm,
                                             options, progress);
  if (!found) return failure(found.error());
  Provenance made = made_from_seeds("tubes", seeds_mm);
  made.options["within"] = within;
  if (within != name) made.from.push_back("labels/" + within);
  if (brightness) {
    made.options["brightness"] = *brightness == segmentation::VesselBrightness::bright ? "bright" : "dark";
  }
  made.notes = found->notes;
  auto saved = save_structure(patient, segmentation::make_structure(name, std::move(found->mask)), std::move(made));
  if (saved) saved->notes = std::move(found->notes);
  return saved;
}

Result<SavedStructure> threshold_structure(Case& patient, const std::string& name, const segmentation::GreyRange& range,
                                           const std::optional<std::string>& within) {
  const auto anatomy = patient.volume("volumes/anatomy");
  if (!anatomy) return failure(anatomy.error());
  const auto inside = mask_to_stay_in(patient, within, anatomy->grid);
  if (!inside) return failure(inside.error());
  Provenance made{
      "segment",
      {{"method", "range"}, {"from", fmt::format("{:g}", range.low)}, {"to", fmt::format("{:g}", range.high)}},
      {"volumes/anatomy"},
      {},
      {}};
  if (within) {
    made.options["within"] = *within;
    if (*within != name) made.from.push_back("labels/" + *within);
  }
  auto mask = segmentation::in_range(*anatomy, range, *inside ? &**inside : nullptr);
  if (segmentation::voxel_count(mask) == 0) {
    return failure(Error{"range-empty",
                         GLISSON_TEXT("No voxel there has a grey value from {0} to {1}."),
                         {fmt::format("{:g}", range.low), fmt::format("{:g}", range.high)},
                         GLISSON_TEXT("Widen the range."),
                         {}});
  }
  return save_structure(patient, segmentation::make_structure(name, std::move(mask)), std::move(made));
}

Result<SavedStructure> combine_structure(Case& patient, const std::string& name, Combination how,
                                         const std::string& other) {
  const auto by = mask_named(patient, other);
  if (!by) return failure(by.error());
  imaging::Mask mask{by->grid, std::vector<std::uint8_t>(by->values.size(), 0)};
  if (how != Combination::unite || patient.find("labels/" + name) != nullptr) {
    auto own = mask_named(patient, name);
    if (!own) return failure(own.error());
    mask = std::move(*own);
  }
  if (!imaging::same_grid(mask.grid, by->grid)) {
    return failure("labels-grids-differ", GLISSON_TEXT("The structures {0} and {1} lie on different voxel grids."),
                   {name, other});
  }
  switch (how) {
    case Combination::unite: mask = segmentation::united(std::move(mask), *by); break;
    case Combination::intersect: mask = segmentation::intersected(std::move(mask), *by); break;
    case Combination::subtract: mask = segmentation::subtracted(std::move(mask), *by); break;
  }
  Provenance made{"segment", {{"method", "combined"}, {"with", other}}, {}, {}, {}};
  made.options["how"] = how == Combination::unite ? "unite" : how == Combination::intersect ? "intersect" : "subtract";
  if (patient.find("volumes/anatomy") != nullptr) made.from.emplace_back("volumes/anatomy");
  if (other != name) made.from.push_back("labels/" + other);
  return save_structure(patient, segmentation::make_structure(name, std::move(mask)), std::move(made));
}

Result<SavedStructure> import_structure(Case& patient, const std::string& name, const fs::path& labels,
                                        std::optional<int> label_value, const Progress& progress) {
  progress.report(0.0, GLISSON_TEXT("Reading the labels"));
  const auto anatomy = patient.volume("volumes/anatomy");
  if (!anatomy) return failure(anatomy.error());
  auto picked = read_labelled(labels).and_then(
      [&](std::vector<Labelled> found) { return pick(std::move(found), name, label_value, labels); });
  if (!picked) return failure(picked.error());

  const imaging::Mask mask = segmentation::resample(picked->mask, anatomy->grid);
  if (segmentation::voxel_count(mask) == 0) {
    return failure(Error{"labels-no-overlap",
                         GLISSON_TEXT("No voxel of label {0} in {1} lies inside the anatomy."),
                         {std::to_string(picked->value), labels.string()},
                         GLISSON_TEXT("Check that both belong to the same patient and frame of reference."),
                         labels});
  }
  Provenance made{"segment",
                  {{"method", "labels"}, {"label-value", std::to_string(picked->value)}},
                  {"volumes/anatomy"},
                  {{labels.filename().string(), sha256_of_file(labels).value_or("unreadable")}},
                  {}};
  return save_structure(patient, segmentation::make_structure(name, mask), std::move(made));
}

Result<SavedStructure> save_structure(Case& patient, const Structure& structure, Provenance made) {
  SavedStructure saved{structure.name,
                       "labels/" + structure.name,
                       segmentation::voxel_count(structure.mask),
                       segmentation::volume_ml(structure.mask),
                       {}};
  auto added = patient.add(saved.id, ".nrrd", std::move(made), [&](const fs::path& file) {
    return imaging::write_mask_file(file, structure.mask, {structure.name, 1, structure.color_rgb});
  });
  if (!added) return failure(added.error());
  return saved;
}

Result<std::vector<Structure>> read_structures(const Case& patient) {
  std::vector<Structure> structures;
  for (const Entry& entry : patient.entries()) {
    if (!entry.id.starts_with("labels/")) continue;
    auto read = imaging::read_mask_file(patient.folder() / entry.file);
    if (!read) return failure(read.error());
    structures.push_back({entry.id.substr(7), read->info.color_rgb, std::move(read->mask)});
  }
  std::stable_partition(structures.begin(), structures.end(), [](const Structure& s) { return s.name == "liver"; });
  return structures;
}

Provenance made_from_seeds(const std::string& method, const std::vector<Eigen::Vector3d>& seeds_mm) {
  Provenance made{"segment", {{"method", method}}, {"volumes/anatomy"}, {}, {}};
  keep_points(made, "seed", seeds_mm);
  return made;
}

void keep_points(Provenance& made, const std::string& name, const std::vector<Eigen::Vector3d>& points_mm) {
  for (std::size_t i = 0; i < points_mm.size(); ++i) {
    const Eigen::Vector3d& point = points_mm[i];
    made.options[fmt::format("{}-{}_mm", name, i + 1)] = fmt::format("{},{},{}", point.x(), point.y(), point.z());
  }
}

Result<imaging::Mask> with_known_lesions(const Case& patient, imaging::Mask liver, Provenance& made,
                                         std::vector<Sentence>& notes) {
  const auto known = read_structures(patient);
  if (!known) return failure(known.error());
  auto whole = segmentation::with_lesions(std::move(liver), *known);
  for (const std::string& lesion : whole.added) {
    made.from.push_back("labels/" + lesion);
    notes.push_back({GLISSON_TEXT("The growing left {0} out; it was added to the liver."), {lesion}});
  }
  return std::move(whole.liver);
}

namespace {

Result<imaging::Mask> mask_named(const Case& patient, const std::string& name) {
  const Entry* entry = patient.find("labels/" + name);
  if (entry == nullptr) {
    return failure(Error{"structure-unknown",
                         GLISSON_TEXT("This case has no structure \"{0}\"."),
                         {name},
                         GLISSON_TEXT("Names are those of the folder labels in the case: liver, portal-vein, ..."),
                         patient.folder()});
  }
  auto read = imaging::read_mask_file(patient.folder() / entry->file);
  if (!read) return failure(read.error());
  return std::move(read->mask);
}

Result<std::optional<imaging::Mask>> mask_to_stay_in(const Case& patient, const std::optional<std::string>& name,
                                                     const imaging::Grid& grid) {
  if (!name) return std::optional<imaging::Mask>();
  return mask_named(patient, *name).map([&](const imaging::Mask& found) {
    return std::optional(segmentation::resample(found, grid));
  });
}

Result<Grown> grow(const imaging::Volume& anatomy, const std::string& name,
                   const std::vector<Eigen::Vector3d>& seeds_mm, const imaging::Mask* within,
                   const Progress& progress) {
  const auto by_contrast = [&](segmentation::Contrast kind) {
    return segmentation::grow_contrast(anatomy, seeds_mm, kind, within, {}, progress)
        .map([](segmentation::ContrastGrowth grown) {
          return Grown{std::move(grown.mask), std::move(grown.doubts)};
        });
  };
  if (const auto kind = segmentation::contrast_of(name)) return by_contrast(*kind);
  if (within != nullptr) return by_contrast(segmentation::Contrast::lesion);
  auto grown = segmentation::grow_from_seeds(anatomy, seeds_mm, {}, progress);
  // A name that says nothing, at something thinner than an organ.
  const bool may_be_small = name != "liver";
  if (!grown && may_be_small && grown.error().code == "grow-nothing-found") {
    return by_contrast(segmentation::Contrast::lesion);
  }
  if (!grown) return failure(grown.error());
  std::vector<Sentence> notes;
  const auto odd = name == "liver" ? segmentation::doubt_of_liver(grown->mask, anatomy) : std::nullopt;
  if (odd) notes.push_back(*odd);
  for (auto& doubt : grown->doubts) {
    // Of an animal's liver it is no news that it is small.
    if (!odd || doubt.kind != segmentation::GrowthDoubt::too_small) notes.push_back(std::move(doubt.sentence));
  }
  return Grown{std::move(grown->mask), std::move(notes)};
}

Result<std::vector<Labelled>> read_labelled(const fs::path& file) {
  std::vector<Labelled> found;
  if (file.extension() == ".dcm" || file.extension().empty()) {
    auto segments = imaging::read_dicom_seg(file);
    if (!segments) return failure(segments.error());
    for (auto& segment : *segments) {
      found.push_back({segment.info.label_value, segment.info.name, std::move(segment.mask)});
    }
    return found;
  }
  const auto map = read_label_map(file);
  if (!map) return failure(map.error());
  for (const LabelledPart& part : map->parts) {
    const std::string name = !part.structure.empty() ? part.structure
                             : !part.written.empty() ? part.written
                                                     : std::to_string(part.value);
    found.push_back({part.value, name, segmentation::mask_of_label(map->labels, part.value)});
  }
  return found;
}

// By its value, or the only one, or the only one of that name.
Result<Labelled> pick(std::vector<Labelled> found, const std::string& name, std::optional<int> label_value,
                      const fs::path& file) {
  if (!label_value && found.size() == 1) return std::move(found.front());
  const auto named = [&](const Labelled& labelled) { return labelled.name == name; };
  if (!label_value && std::count_if(found.begin(), found.end(), named) == 1) {
    return std::move(*std::find_if(found.begin(), found.end(), named));
  }
  std::vector<std::string> values;
  for (Labelled& labelled : found) {
    if (label_value && labelled.value == *label_value) return std::move(labelled);
    values.push_back(labelled.name == std::to_string(labelled.value)
                         ? labelled.name
                         : fmt::format("{} ({})", labelled.value, labelled.name));
  }
  if (found.empty()) {
    return failure(Error{"labels-empty", GLISSON_TEXT("{0} has no labelled voxel."), {file.string()}, {}, file});
  }
  return failure(Error{
      label_value ? "labels-no-such-value" : "labels-ambiguous",
      label_value ? GLISSON_TEXT("{0} has no label {2}; it holds {1}.")
                  : GLISSON_TEXT("{0} holds several labels: {1}."),
      {file.string(), fmt::format("{}", fmt::join(values, ", ")), label_value ? std::to_string(*label_value) : ""},
      GLISSON_TEXT("Choose one with --label-value."),
      file});
}

}  // namespace
}  // namespace glisson::casefile
