#include "casefile/export.h"

#include <algorithm>
#include <array>
#include <set>

#include "base/files.h"
#include "base/write_file.h"
#include "casefile/plans.h"
#include "casefile/structures.h"
#include "casefile/used_entries.h"
#include "casefile/vascular.h"
#include "geometry/mesh_file.h"
#include "imaging/dicom_seg.h"
#include "imaging/dicom_uid.h"
#include "imaging/study.h"
#include "imaging/volume_file.h"

namespace glisson::casefile {
namespace fs = std::filesystem;
namespace {

struct NamedFormat {
  std::string_view name;
  ExportFormat format;
  const char* extension;
};
constexpr std::array named_formats{
    NamedFormat{"nrrd", ExportFormat::nrrd, ".nrrd"},
    NamedFormat{"nifti", ExportFormat::nifti, ".nii.gz"},
    NamedFormat{"dicom-seg", ExportFormat::dicom_seg, ".dcm"},
    NamedFormat{"stl", ExportFormat::stl, ".stl"},
    NamedFormat{"obj", ExportFormat::obj, ".obj"},
    NamedFormat{"vtp", ExportFormat::vtp, ".vtp"},
    NamedFormat{"vtu", ExportFormat::vtu, ".vtu"},
};

const NamedFormat& named(ExportFormat format) {
  return *std::find_if(named_formats.begin(), named_formats.end(), [&](const auto& n) { return n.format == format; });
}

Result<void> export_image(const Case& patient, const Entry& entry, const fs::path& target) {
  // A label map is a volume of whole numbers: 0 outside, 1 inside.
  return imaging::read_volume_file(patient.folder() / entry.file).and_then([&](const imaging::Volume& volume) {
    return imaging::write_volume_file(target, volume);
  });
}

Result<void> export_label_as_nrrd(const Case& patient, const Entry& entry, const fs::path& target) {
  return imaging::read_mask_file(patient.folder() / entry.file).and_then([&](const imaging::SegmentedMask& segment) {
    return imaging::write_mask_file(target, segment.mask, segment.info);
  });
}

Result<void> export_surface(const Case& patient, const Entry& entry, const fs::path& target) {
  return geometry::read_surface(patient.folder() / entry.file).and_then([&](const geometry::Surface& surface) {
    return geometry::write_surface(target, surface);
  });
}

// The series of the study whose files are those that the anatomy was read from, by their content.
Result<imaging::SegmentationSource> source_in(const Case& patient, const fs::path& folder) {
  const auto other_study = [&] {
    return failure(Error{"export-other-study",
                         GLISSON_TEXT("{0} does not hold the images that {1} was made from."),
                         {folder.string(), patient.folder().string()},
                         GLISSON_TEXT("Name the folder that was imported."),
                         folder});
  };
  const Entry* anatomy = patient.find("volumes/anatomy");
  if (anatomy == nullptr || anatomy->made.sources.empty()) return other_study();
  std::multiset<std::string> contents;
  for (const auto& [name, content] : anatomy->made.sources) contents.insert(content);
  const auto study = imaging::scan(folder);
  if (!study) return failure(study.error());
  for (const imaging::Series& series : study->series) {
    if (series.files.size() != contents.size() || imaging::has_volume_file_name(series.files.front())) continue;
    std::multiset<std::string> found;
    for (const fs::path& file : series.files) found.insert(sha256_of_file(file).value_or("unreadable"));
    if (found != contents) continue;
    auto source = imaging::segmentation_source(series.files);
    if (source) source->series_description = "Segmentation";
    return source;
  }
  return other_study();
}

// What has that value in an image of a part, as a mask on the whole grid.
template <typename Value>
imaging::Mask on_the_whole(const imaging::Image<Value>& part, Value wanted, const imaging::Grid& whole) {
  imaging::Mask mask{whole, std::vector<std::uint8_t>(whole.voxels(), 0)};
  for (int k = 0; k < part.grid.size[2]; ++k) {
    for (int j = 0; j < part.grid.size[1]; ++j) {
      for (int i = 0; i < part.grid.size[0]; ++i) {
        if (part.at(i, j, k) != wanted) continue;
        const Eigen::Vector3d place = whole.index_of(part.grid.position_mm(i, j, k));
        const Eigen::Vector3i at = place.array().round().cast<int>();
        if (whole.contains(at.x(), at.y(), at.z())) mask.at(at.x(), at.y(), at.z()) = 1;
      }
    }
  }
  return mask;
}

Result<void> add_couinaud_segments(const Case& patient, std::vector<imaging::SegmentedMask>& segments) {
  if (patient.find(couinaud_id) == nullptr) return {};
  const auto map = patient.file_of(couinaud_id).and_then(imaging::read_labels_file);
  if (!map) return failure(map.error());
  for (imaging::SegmentInfo info : couinaud_segment_infos()) {
    imaging::Mask mask = on_the_whole(*map, static_cast<std::uint16_t>(info.label_value), segments.front().mask.grid);
    info.label_value = static_cast<int>(segments.size()) + 1;
    segments.push_back({std::move(info), std::move(mask)});
  }
  return {};
}

Result<void> add_plan(const Case& patient, const std::string& name, const Progress& progress,
                      std::vector<imaging::SegmentedMask>& segments) {
  const auto kept = kept_plan(patient, name);
  if (!kept) return failure(kept.error());
  const auto opened = open_planner(patient, progress);
  if (!opened) return failure(opened.error());
  const auto parts = opened->planner.parts(kept->plan.cuts);
  if (!parts) return failure(parts.error());
  struct PlanPart {
    const char* name;
    std::uint8_t value;
    std::array<double, 3> color_rgb;
  };
  for (const PlanPart& part :
       {PlanPart{"remnant", 1, {0.55, 0.75, 0.55}}, PlanPart{"specimen", 2, {0.85, 0.55, 0.35}}}) {
    segments.push_back({{part.name, static_cast<int>(segments.size()) + 1, part.color_rgb},
                        on_the_whole(*parts, part.value, segments.front().mask.grid)});
  }
  return {};
}

Result<void> export_segmentation(const Case& patient, const fs::path& target, const Progress& progress,
                                 const SegmentationExport& with) {
  const auto structures = read_structures(patient);
  if (!structures) return failure(structures.error());
  std::vector<imaging::SegmentedMask> segments;
  for (const auto& structure : *structures) {
    segments.push_back({{structure.name, static_cast<int>(segments.size()) + 1, structure.color_rgb}, structure.mask});
  }
  if (auto added = add_couinaud_segments(patient, segments); !added) return added;
  if (with.plan) {
    if (auto added = add_plan(patient, *with.plan, progress, segments); !added) return added;
  }
  const Entry* anatomy = patient.find("volumes/anatomy");
  const std::string identity = anatomy ? anatomy->sha256 : segments.front().info.name;
  imaging::SegmentationSource source;
  source.study_uid = imaging::uid_from_name("study " + identity);
  source.series_uid = imaging::uid_from_name("series " + identity);
  source.frame_of_reference_uid = imaging::uid_from_name("frame of reference " + identity);
  if (with.study) {
    auto named = source_in(patient, *with.study);
    if (!named) return failure(named.error());
    source = *std::move(named);
    // Of several volumes in one series, or of many frames in one file, which slice is which is not known.
    const auto slices = static_cast<std::size_t>(segments.front().mask.grid.size[2]);
    if (source.instances.size() != slices) source.instances.clear();
  }
  return imaging::write_dicom_seg(target, segments, source);
}

// Which entries go out, by what their names begin with.
std::vector<const Entry*> entries_for(const Case& patient, ExportFormat format) {
  const auto wanted = [&](const std::string& id) {
    switch (format) {
      case ExportFormat::nrrd:
      case ExportFormat::nifti: return id.starts_with("volumes/") || id.starts_with("labels/") || id == couinaud_id;
      case ExportFormat::dicom_seg: return id.starts_with("labels/");
      case ExportFormat::stl:
      case ExportFormat::obj:
      case ExportFormat::vtp: return id.starts_with("surfaces/");
      case ExportFormat::vtu: return id == (patient.find("meshes/model") ? "meshes/model" : "meshes/liver");
    }
    return false;
  };
  std::vector<const Entry*> entries;
  for (const Entry& entry : patient.entries()) {
    if (wanted(entry.id)) entries.push_back(&entry);
  }
  return entries;
}

}  // namespace

std::optional<ExportFormat> export_format(std::string_view name) {
  for (const NamedFormat& known : named_formats) {
    if (known.name == name) return known.format;
  }
  return std::nullopt;
}

Result<std::vector<fs::path>> export_case(const Case& patient, ExportFormat format, const fs::path& out,
                                          const Progress& progress, const SegmentationExport& with) {
  const auto entries = entries_for(patient, format);
  if (entries.empty()) {
    return failure(Error{"export-nothing",
                         GLISSON_TEXT("{0} holds nothing that could be written as {1}."),
                         {patient.folder().string(), std::string(named(format).name)},
                         GLISSON_TEXT("Run the stage that makes it first."),
                         patient.folder()});
  }
  if (format == ExportFormat::dicom_seg) {
    return export_segmentation(patient, out, progress, with).map([&] { return std::vector{out}; });
  }
  if (format == ExportFormat::vtu) {
    return geometry::read_tetrahedra(patient.folder() / entries.front()->file)
        .and_then([&](const geometry::TetMesh& mesh) {
          return check_own_mesh(patient, mesh).and_then([&] { return geometry::write_tetrahedra(out, mesh); });
        })
        .map([&] { return std::vector{out}; });
  }
  std::vector<fs::path> files;
  const auto write_each = [&]() -> Result<void> {
    for (const Entry* entry : entries) {
      if (progress.cancelled()) return cancelled();
      progress.report(static_cast<double>(files.size()) / static_cast<double>(entries.size()),
                      std::string(GLISSON_TEXT("Writing")) + ": " + entry->id);
      const fs::path target = out / (fs::path(entry->id).filename().string() + named(format).extension);
      const bool label_as_nrrd = format == ExportFormat::nrrd && entry->id.starts_with("labels/");
      const bool segments_as_nrrd = format == ExportFormat::nrrd && entry->id == couinaud_id;
      const bool image = format == ExportFormat::nrrd || format == ExportFormat::nifti;
      auto written = label_as_nrrd      ? export_label_as_nrrd(patient, *entry, target)
                     : segments_as_nrrd ? write_copy(patient.folder() / entry->file, target)
                     : image            ? export_image(patient, *entry, target)
                                        : export_surface(patient, *entry, target);
      if (!written) return failure(written.error());
      files.push_back(target);
    }
    return {};
  };
  return write_together(write_each).map([&] { return std::move(files); });
}

std::vector<Sentence> export_remarks(const Case& patient, ExportFormat format) {
  std::vector<std::string> ids;
  for (const Entry* entry : entries_for(patient, format)) ids.push_back(entry->id);
  return remarks_on(patient, ids);
}

}  // namespace glisson::casefile
