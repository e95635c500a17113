#include "casefile/structures.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <algorithm>
#include <limits>

#include "base/files.h"
#include "casefile/label_map.h"
#include "imaging/dicom_seg.h"
#include "imaging/volume_file.h"
#include "segmentation/grow.h"
#include "segmentation/lesions.h"
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

}  // namespace

Result<SavedStructure> grow_structure(Case& patient, const std::string& name,
                                      const std::vector<Eigen::Vector3d>& seeds_mm, const Progress& progress) {
  const auto anatomy = patient.volume("volumes/anatomy");
  if (!anatomy) return failure(anatomy.error());
  auto grown = segmentation::grow_from_seeds(*anatomy, seeds_mm, {}, progress);
  if (!grown) return failure(grown.error());

  Provenance made{"segment", {{"method", "seeds"}}, {"volumes/anatomy"}, {}, {}};
  for (std::size_t i = 0; i < seeds_mm.size(); ++i) {
    const Eigen::Vector3d& seed = seeds_mm[i];
    made.options[fmt::format("seed-{}_mm", i + 1)] = fmt::format("{:.2f},{:.2f},{:.2f}", seed.x(), seed.y(), seed.z());
  }
  std::vector<Sentence> notes;
  for (const auto& doubt : grown->doubts) notes.push_back(doubt.sentence);
  if (name == "liver") {
    const auto known = read_structures(patient);
    if (!known) return failure(known.error());
    auto whole = segmentation::with_lesions(std::move(grown->mask), *known);
    grown->mask = std::move(whole.liver);
    for (const std::string& lesion : whole.added) {
      made.from.push_back("labels/" + lesion);
      notes.push_back({GLISSON_TEXT("The growing left {0} out; it was added to the liver."), {lesion}});
    }
  }
  made.notes = notes;
  auto saved = save_structure(patient, segmentation::make_structure(name, std::move(grown->mask)), std::move(made));
  if (saved) saved->notes = std::move(notes);
  return saved;
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

namespace {

// Points of a mask, spread by always taking the one farthest from those taken; the first is the farthest from the
// centroid. Every voxel is looked at once for each point taken.
std::vector<Eigen::Vector3d> spread_points(const imaging::Mask& mask, const imaging::Mask* inside, int count) {
  std::vector<Eigen::Vector3d> voxels;
  Eigen::Vector3d centroid = Eigen::Vector3d::Zero();
  for (int k = 0; k < mask.grid.size[2]; ++k) {
    for (int j = 0; j < mask.grid.size[1]; ++j) {
      for (int i = 0; i < mask.grid.size[0]; ++i) {
        if (!mask.at(i, j, k) || (inside && !inside->at(i, j, k))) continue;
        voxels.push_back(mask.grid.position_mm(i, j, k));
        centroid += voxels.back();
      }
    }
  }
  if (voxels.empty()) return {};
  centroid /= static_cast<double>(voxels.size());

  std::vector<Eigen::Vector3d> taken;
  std::vector<double> squared_distance(voxels.size(), std::numeric_limits<double>::max());
  const auto farthest_from_centroid =
      std::max_element(voxels.begin(), voxels.end(), [&](const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
        return (a - centroid).squaredNorm() < (b - centroid).squaredNorm();
      });
  taken.push_back(*farthest_from_centroid);
  while (static_cast<int>(taken.size()) < count) {
    for (std::size_t v = 0; v < voxels.size(); ++v) {
      squared_distance[v] = std::min(squared_distance[v], (voxels[v] - taken.back()).squaredNorm());
    }
    const auto farthest = std::max_element(squared_distance.begin(), squared_distance.end());
    if (*farthest <= 0) break;
    taken.push_back(voxels[static_cast<std::size_t>(farthest - squared_distance.begin())]);
  }
  return taken;
}

}  // namespace

bool is_vessel(const std::string& name) {
  return name.find("vein") != std::string::npos || name.find("arter") != std::string::npos;
}

std::vector<mechanics::Landmark> landmarks_of(const std::vector<Structure>& structures, int points_per_vessel) {
  const imaging::Mask* liver = nullptr;
  for (const Structure& structure : structures) {
    if (structure.name == "liver") liver = &structure.mask;
  }
  std::vector<mechanics::Landmark> landmarks;
  for (const Structure& structure : structures) {
    if (segmentation::known_structure(structure.name).place != segmentation::Place::inside) continue;
    const imaging::Mask* inside = liver && imaging::same_grid(liver->grid, structure.mask.grid) ? liver : nullptr;
    if (is_vessel(structure.name)) {
      int number = 0;
      for (const Eigen::Vector3d& point : spread_points(structure.mask, inside, points_per_vessel)) {
        landmarks.push_back({fmt::format("{}-{}", structure.name, ++number), point});
      }
      continue;
    }
    const auto found = segmentation::pieces(structure.mask);
    if (found.empty()) continue;
    landmarks.push_back({structure.name, found.front().centroid_mm});
  }
  return landmarks;
}

namespace {

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
