#include "imaging/deidentify.h"

#include <fmt/format.h>
#include <algorithm>
#include <random>

#include "base/files.h"
#include "base/write_file.h"
#include "imaging/dicom_uid.h"
#include "imaging/internal/data_set_cleaner.h"
#include "imaging/internal/dicom_fields.h"
#include "imaging/internal/dicom_image.h"
#include "imaging/internal/frame_reader.h"

namespace glisson::imaging {
namespace fs = std::filesystem;
namespace {

Result<std::vector<fs::path>> files_under(const fs::path& path);
std::map<std::string, std::string> description_of_file(const fs::path& path);
Result<DeidentifyResult> clean_all(const fs::path& path, const fs::path& out, const DeidentifyOptions& options,
                                   const Progress& progress);
Result<void> clean_file(const fs::path& file, const fs::path& out, const std::string& series_description,
                        const std::string& key, DeidentifyResult& result);
void warn_of_burned_in_text(DcmDataset& data_set, const fs::path& file, std::vector<std::string>& warnings);
std::string drawn_key();
bool lies_inside(const fs::path& inner, const fs::path& outer);

}  // namespace

Result<DeidentifyResult> deidentify(const fs::path& path, const fs::path& out, const DeidentifyOptions& options,
                                    const Progress& progress) {
  if (lies_inside(out, path)) {
    return failure(Error{"deidentify-inside-source",
                         GLISSON_TEXT("{0} lies inside {1}, which is only read."),
                         {out.string(), path.string()},
                         GLISSON_TEXT("Choose a folder elsewhere for the files without identity."),
                         out});
  }
  std::error_code ignored;
  // Into a folder that was there, file by file: so many cannot be kept open until the last is written.
  if (fs::exists(out, ignored)) return clean_all(path, out, options, progress);
  Result<DeidentifyResult> result;
  const auto written = write_together([&]() -> Result<void> {
    result = clean_all(path, out, options, progress);
    return result ? Result<void>() : failure(result.error());
  });
  return written ? std::move(result) : failure(written.error());
}

namespace {

Result<DeidentifyResult> clean_all(const fs::path& path, const fs::path& out, const DeidentifyOptions& options,
                                   const Progress& progress) {
  const auto files = files_under(path);
  if (!files) return failure(files.error());
  const std::map<std::string, std::string> descriptions = description_of_file(path);
  const std::string key = options.key.empty() ? drawn_key() : options.key;

  DeidentifyResult result;
  for (std::size_t i = 0; i < files->size(); ++i) {
    if (progress.cancelled()) return cancelled();
    progress.report(static_cast<double>(i) / static_cast<double>(files->size()), GLISSON_TEXT("removing identity"));
    const fs::path& file = (*files)[i];
    const auto description = descriptions.find(file.string());
    const auto cleaned =
        clean_file(file, out, description == descriptions.end() ? "" : description->second, key, result);
    if (cleaned) continue;
    if (cleaned.error().code == "file-not-writable") return failure(cleaned.error());
    result.skipped.push_back({file, cleaned.error().message()});
  }
  if (result.files.empty()) {
    return failure(Error{"deidentify-nothing",
                         GLISSON_TEXT("{0} holds no DICOM file."),
                         {path.string()},
                         GLISSON_TEXT("Give the folder or the file that holds the images."),
                         path});
  }
  return result;
}

Result<std::vector<fs::path>> files_under(const fs::path& path) {
  std::error_code problem;
  if (fs::is_regular_file(path, problem)) return std::vector{path};
  std::vector<fs::path> files;
  for (auto entry = fs::recursive_directory_iterator(path, problem); !problem && entry != fs::end(entry);
       entry.increment(problem)) {
    // What cannot be told, a link that leads nowhere or to itself, is tried and skipped with its reason.
    std::error_code unknown;
    const fs::file_type type = entry->status(unknown).type();
    if (type == fs::file_type::regular || type == fs::file_type::not_found || type == fs::file_type::none) {
      files.push_back(entry->path());
    }
  }
  if (problem) {
    return failure(Error{"path-not-found",
                         GLISSON_TEXT("{0} cannot be read: {1}."),
                         {path.string(), problem.message()},
                         GLISSON_TEXT("Check the path and your rights there."),
                         path});
  }
  std::sort(files.begin(), files.end());
  return files;
}

// What a series is for, in words that scanning recognises again; how fast it was shaken; and that nobody was.
std::string description_of(const Series& series) {
  std::string description;
  switch (series.role) {
    case Role::anatomy: description = "anatomy"; break;
    case Role::mre_magnitude: description = "MRE magnitude"; break;
    case Role::mre_phase: description = "MRE phase"; break;
    case Role::mre_wave: description = "MRE wave"; break;
    case Role::mre_stiffness: description = "MRE stiffness"; break;
    case Role::mre_confidence: description = "MRE confidence"; break;
    case Role::segmentation: description = "segmentation"; break;
    case Role::other: break;
  }
  if (!series.motion.empty() && series.motion.front().frequency_Hz && !description.empty()) {
    description += fmt::format(" {:.6g} Hz", *series.motion.front().frequency_Hz);
  }
  if (upper_case(series.description).find("SIMULATED") != std::string::npos) {
    description += description.empty() ? "SIMULATED" : " SIMULATED";
  }
  return description;
}

std::map<std::string, std::string> description_of_file(const fs::path& path) {
  std::map<std::string, std::string> descriptions;
  const auto study = scan(path);
  if (!study) return descriptions;
  for (const Series& series : study->series) {
    for (const fs::path& file : series.files) descriptions[file.string()] = description_of(series);
  }
  return descriptions;
}

Failure unfit(const fs::path& file, const char* code, std::string text) {
  return failure(Error{code, std::move(text), {file.string()}, "", file});
}

// The pixels as the header describes them, uncompressed: compressed streams carry comments, and bytes behind the last
// pixel are nobody's.
Result<void> put_pixels(DcmDataset& data_set, const DicomImage& image) {
  const PixelFormat& format = image.format;
  const bool packed = format.bits_allocated == 1 || format.samples != 1;
  if (format.photometric == "PALETTE COLOR" || (image.syntax.encapsulated && packed)) {
    return unfit(image.path, "deidentify-colour",
                 GLISSON_TEXT("{0} is left out: its pixels cannot be written without what else is stored with them."));
  }
  VoxelLayout layout;
  layout.files.push_back({image.path, image.file_bytes, image.frames, image.syntax, format, image.pixels});
  auto pixels = FrameReader(layout).stored_pixels(0);
  if (!pixels) return failure(std::move(pixels.error()));
  if (pixels->size() % 2 != 0) pixels->push_back(0);
  const auto bytes = static_cast<unsigned long>(pixels->size());
  const OFCondition put = [&] {
    const Uint8* data = pixels->data();
    if (image.pixels.element == 0x0008)
      return data_set.putAndInsertFloat32Array(DCM_FloatPixelData, reinterpret_cast<const Float32*>(data), bytes / 4);
    if (image.pixels.element == 0x0009) {
      return data_set.putAndInsertFloat64Array(DCM_DoubleFloatPixelData, reinterpret_cast<const Float64*>(data),
                                               bytes / 8);
    }
    if (format.bits_allocated <= 8) return data_set.putAndInsertUint8Array(DCM_PixelData, data, bytes);
    return data_set.putAndInsertUint16Array(DCM_PixelData, reinterpret_cast<const Uint16*>(data), bytes / 2);
  }();
  if (put.good()) return {};
  return unfit(image.path, "dicom-damaged", GLISSON_TEXT("{0} holds no image, or is damaged."));
}

// Where a copy goes.
struct Place {
  fs::path folder;
  std::string instance;
};

// Made of the new identifiers, which are digits and dots.
Place place_of(DcmDataset& data_set, const fs::path& out) {
  return {out / text_of(data_set, DCM_SeriesInstanceUID), text_of(data_set, DCM_SOPInstanceUID)};
}

enum class Taken { no, by_the_same, by_another };

Taken taken(const fs::path& name, const MemoryFile& copy) {
  std::error_code problem;
  if (fs::symlink_status(name, problem).type() == fs::file_type::not_found) return Taken::no;
  const auto there = sha256_of_file(name), ours = sha256_of_file(copy.path());
  return there && ours && *there == *ours ? Taken::by_the_same : Taken::by_another;
}

// Copies that share their identifiers stay apart, those of an earlier run too; one that is there is left.
Result<fs::path> put_copy(const MemoryFile& copy, const Place& place, const std::vector<fs::path>& written) {
  for (int n = 1;; ++n) {
    const fs::path name =
        place.folder / (n == 1 ? place.instance + ".dcm" : fmt::format("{}-{}.dcm", place.instance, n));
    if (std::find(written.begin(), written.end(), name) != written.end()) continue;
    const Taken by = taken(name, copy);
    if (by == Taken::by_another) continue;
    if (by == Taken::by_the_same) return name;
    return copy.write_to(name).map([&] { return name; });
  }
}

Result<void> clean_file(const fs::path& file, const fs::path& out, const std::string& series_description,
                        const std::string& key, DeidentifyResult& result) {
  const auto image = read_dicom_image_header(file);
  if (!image) return failure(image.error());
  const auto checked = check_dicom_file(file);
  if (!checked) return failure(checked.error());
  auto data_set = parse(*checked);
  if (!data_set) return unfit(file, "dicom-damaged", GLISSON_TEXT("{0} holds no image, or is damaged."));
  // Files that were stripped before may lack identifiers; a folder then stands for a series, as scanning takes it.
  const auto ensure = [&](const DcmTagKey& tag, const std::string& value) {
    if (text_of(*data_set, tag).empty()) data_set->putAndInsertString(DcmTag(tag), value.c_str());
  };
  ensure(DCM_SOPInstanceUID, uid_from_name(file.string()));
  ensure(DCM_SeriesInstanceUID, uid_from_name(file.parent_path().string()));
  warn_of_burned_in_text(*data_set, file, result.warnings);
  std::map<std::string, int> removed;
  DataSetCleaner cleaner(key, removed);
  cleaner.clean(*data_set, series_description);
  ensure(DCM_SOPClassUID, image->modality == "CT" ? UID_CTImageStorage : UID_MRImageStorage);
  // What was of the wrong kind has gone, and is needed all the same.
  ensure(DCM_SOPInstanceUID, uid_from_name(key + file.string()));
  ensure(DCM_SeriesInstanceUID, uid_from_name(key + file.parent_path().string()));
  if (const auto put = put_pixels(*data_set, *image); !put) return put;

  const Place place = place_of(*data_set, out);
  const auto copy = MemoryFile::create(place.folder / (place.instance + ".dcm"));
  if (!copy) return failure(copy.error());
  // A new file around it: the old one's preamble and meta header may say who sent it.
  DcmFileFormat format(data_set.release(), OFFalse);
  const OFCondition saved = format.saveFile(copy->path().c_str(), EXS_LittleEndianExplicit, EET_ExplicitLength,
                                            EGL_withoutGL, EPD_noChange, 0, 0, EWM_createNewMeta);
  if (!saved.good()) return file_not_writable(place.folder / (place.instance + ".dcm"), saved.text());
  auto target = put_copy(*copy, place, result.files);
  if (!target) return failure(std::move(target.error()));
  for (const auto& [attribute, count] : removed) result.removed[attribute] += count;
  result.files.push_back(*std::move(target));
  return {};
}

void warn_of_burned_in_text(DcmDataset& data_set, const fs::path& file, std::vector<std::string>& warnings) {
  const std::string modality = text_of(data_set, DCM_Modality);
  const std::string image_type = upper_case(fmt::format("{}", fmt::join(texts_of(data_set, DCM_ImageType), "\\")));
  const bool declared = text_of(data_set, DCM_BurnedInAnnotation) == "YES";
  const bool likely = modality == "US" || modality == "ES" || modality == "XC" || modality == "OT" ||
                      text_of(data_set, DCM_SOPClassUID) == UID_SecondaryCaptureImageStorage ||
                      image_type.find("SCREEN") != std::string::npos;
  if (!declared && !likely) return;
  warnings.push_back(fmt::format("{} {} text burned into its picture, which is not removed: look at it.", file.string(),
                                 declared ? "says that it has" : "may have"));
}

std::string drawn_key() {
  std::random_device source;
  return fmt::format("{:08x}{:08x}{:08x}{:08x}", source(), source(), source(), source());
}

bool lies_inside(const fs::path& inner, const fs::path& outer) {
  std::error_code ignored;
  const fs::path a = fs::weakly_canonical(inner, ignored), b = fs::weakly_canonical(outer, ignored);
  if (a.empty() || b.empty()) return false;  // a link that leads to itself shows in the reading and writing
  return std::mismatch(b.begin(), b.end(), a.begin(), a.end()).first == b.end();
}

}  // namespace
}  // namespace glisson::imaging
