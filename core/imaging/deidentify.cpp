#include "imaging/deidentify.h"

#include <fmt/format.h>
#include <algorithm>
#include <optional>
#include <random>
#include <set>

#include "base/files.h"
#include "imaging/dicom_fields.h"
#include "imaging/dicom_uid.h"

namespace glisson::imaging {
namespace fs = std::filesystem;
namespace {

// Replaces what names a patient in one data set, and counts what it did.
class Cleaner {
 public:
  Cleaner(std::string key, std::map<std::string, int>& removed) : key_(std::move(key)), removed_(removed) {}

  void clean(DcmDataset& data_set, const std::string& series_description);

 private:
  void clean_item(DcmItem& item);
  // Whether the element may stay, perhaps with another value.
  bool may_stay(DcmElement& element);
  void replace_uids(DcmElement& element);
  void replace(DcmElement& element, const std::string& value);
  void count(const DcmElement& element);
  [[nodiscard]] std::string pseudonym(const std::string& old) const {
    return "ANON-" + sha256_of_text(key_ + "/patient/" + old).substr(0, 12);
  }

  std::string key_;
  std::map<std::string, int>& removed_;
};

Result<std::vector<fs::path>> files_under(const fs::path& path);
std::map<std::string, std::string> description_of_file(const fs::path& path);
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

namespace {

// Texts that say how an image was made, or what a code means; all other short texts go.
const std::set<DcmTagKey>& technical_texts() {
  static const std::set<DcmTagKey> tags = {DCM_Manufacturer,
                                           DCM_ManufacturerModelName,
                                           DCM_SoftwareVersions,
                                           DCM_SequenceName,
                                           DCM_PulseSequenceName,
                                           DCM_CodeValue,
                                           DCM_CodingSchemeDesignator,
                                           DCM_CodingSchemeVersion,
                                           DCM_CodeMeaning,
                                           DCM_RescaleType,
                                           DCM_ImagedNucleus,
                                           DCM_ReceiveCoilName,
                                           DCM_TransmitCoilName,
                                           DCM_FilterType,
                                           DCM_ConvolutionKernel,
                                           DCM_PositionReferenceIndicator,
                                           DCM_ContrastBolusAgent,
                                           DCM_SegmentLabel,
                                           DCM_SegmentAlgorithmName,
                                           DCM_DimensionDescriptionLabel,
                                           DCM_LUTExplanation,
                                           DCM_LUTLabel,
                                           DCM_StackID};
  return tags;
}

// Attributes that must be there but may be empty (type 2).
const std::set<DcmTagKey>& emptied() {
  static const std::set<DcmTagKey> tags = {DCM_StudyDate,  DCM_StudyTime,          DCM_AccessionNumber,
                                           DCM_StudyID,    DCM_PatientBirthDate,   DCM_PatientSex,
                                           DCM_SeriesDate, DCM_ContentCreatorName, DCM_ReferringPhysicianName};
  return tags;
}

// What the kind of value does not tell: bodily facts, and sequences about persons, requests and other versions.
const std::set<DcmTagKey>& removed_whatever_their_kind() {
  static const std::set<DcmTagKey> tags = {DCM_PatientWeight,
                                           DCM_PatientSize,
                                           DCM_PregnancyStatus,
                                           DCM_SmokingStatus,
                                           DCM_PatientSexNeutered,
                                           DCM_PatientAddress,
                                           DCM_OtherPatientIDsSequence,
                                           DCM_IssuerOfPatientIDQualifiersSequence,
                                           DCM_PatientInsurancePlanCodeSequence,
                                           DCM_PatientPrimaryLanguageCodeSequence,
                                           DCM_ReferencedPatientSequence,
                                           DCM_ReferencedStudySequence,
                                           DCM_ReferencedPerformedProcedureStepSequence,
                                           DCM_RequestAttributesSequence,
                                           DCM_RequestedProcedureCodeSequence,
                                           DCM_InstitutionCodeSequence,
                                           DCM_OperatorIdentificationSequence,
                                           DCM_PerformingPhysicianIdentificationSequence,
                                           DCM_PhysiciansOfRecordIdentificationSequence,
                                           DCM_ReferringPhysicianIdentificationSequence,
                                           DCM_ContentCreatorIdentificationCodeSequence,
                                           DCM_OriginalAttributesSequence,
                                           DCM_ModifiedAttributesSequence,
                                           DCM_EncryptedAttributesSequence,
                                           DCM_DigitalSignaturesSequence,
                                           DCM_MACParametersSequence,
                                           DCM_IconImageSequence,
                                           DCM_ContentSequence,
                                           DCM_AcquisitionContextSequence,
                                           DCM_EncapsulatedDocument,
                                           DCM_DataSetTrailingPadding};
  return tags;
}

// Private numbers without which an elastography study cannot be read: GE's name of the pulse sequence and kind of
// image, Siemens' number of tiles in a mosaic. The first and last are in PS3.15's list of safe private attributes.
std::set<DcmTagKey> safe_private_keys(DcmItem& item) {
  struct Safe {
    unsigned group;
    const char* creator;
    unsigned element;
  };
  std::set<DcmTagKey> keys;
  for (const auto& [group, creator, element] : {Safe{0x0019, "GEMS_ACQU_01", 0x9c}, Safe{0x0043, "GEMS_PARM_01", 0x2f},
                                                Safe{0x0019, "SIEMENS MR HEADER", 0x0a}}) {
    const auto key = private_key(item, group, creator, element);
    if (!key || !item.tagExists(*key)) continue;
    keys.insert(*key);
    keys.insert(DcmTagKey(key->getGroup(), static_cast<Uint16>(key->getElement() >> 8)));  // who reserved the block
  }
  return keys;
}

void Cleaner::clean(DcmDataset& data_set, const std::string& series_description) {
  const std::string patient = pseudonym(text_of(data_set, DCM_PatientID));
  clean_item(data_set);
  data_set.putAndInsertString(DCM_PatientName, patient.c_str());
  data_set.putAndInsertString(DCM_PatientID, patient.c_str());
  if (!series_description.empty()) data_set.putAndInsertString(DCM_SeriesDescription, series_description.c_str());
  // Demanded of segmentations, by which nobody is known.
  if (text_of(data_set, DCM_SOPClassUID) == UID_SegmentationStorage) {
    data_set.putAndInsertString(DCM_ContentDate, "19000101");
    data_set.putAndInsertString(DCM_ContentTime, "000000");
    data_set.putAndInsertString(DCM_DeviceSerialNumber, "0");
  }
  data_set.putAndInsertString(DCM_PatientIdentityRemoved, "YES");
  data_set.putAndInsertString(DCM_DeidentificationMethod,
                              "Glisson: PS3.15 Annex E, all texts, dates and names removed");
  DcmItem* code = nullptr;
  if (data_set.findOrCreateSequenceItem(DCM_DeidentificationMethodCodeSequence, code, 0).good()) {
    code->putAndInsertString(DCM_CodeValue, "113100");
    code->putAndInsertString(DCM_CodingSchemeDesignator, "DCM");
    code->putAndInsertString(DCM_CodeMeaning, "Basic Application Confidentiality Profile");
  }
}

void Cleaner::clean_item(DcmItem& item) {
  const std::set<DcmTagKey> safe_private = safe_private_keys(item);
  for (unsigned long i = 0; i < item.card();) {
    DcmElement* element = item.getElement(i);
    const DcmTagKey key = element->getTag().getXTag();
    const bool stays = (key.getGroup() & 1) != 0 ? safe_private.contains(key) : may_stay(*element);
    if (stays) {
      ++i;
    } else {
      count(*element);
      delete item.remove(i);
    }
  }
}

bool Cleaner::may_stay(DcmElement& element) {
  const DcmTagKey key = element.getTag().getXTag();
  const unsigned group = key.getGroup();
  const bool overlay_or_curve = (group >= 0x5000 && group <= 0x50ff) || (group >= 0x6000 && group <= 0x60ff);
  if (overlay_or_curve || removed_whatever_their_kind().contains(key)) return false;
  if (emptied().contains(key)) {
    replace(element, "");
    return true;
  }
  if (key == DCM_PatientName || key == DCM_PatientID) {
    count(element);
    return true;  // replaced afterwards
  }
  switch (element.ident()) {
    case EVR_SQ: {
      auto& sequence = static_cast<DcmSequenceOfItems&>(element);
      for (unsigned long n = 0; n < sequence.card(); ++n) clean_item(*sequence.getItem(n));
      return true;
    }
    case EVR_UI: replace_uids(element); return true;
    case EVR_LO:
    case EVR_SH: return technical_texts().contains(key);
    case EVR_PN:
    case EVR_DA:
    case EVR_TM:
    case EVR_DT:
    case EVR_AS:
    case EVR_AE:
    case EVR_LT:
    case EVR_ST:
    case EVR_UT:
    case EVR_UC:
    case EVR_UR:
    case EVR_UN: return false;
    default: return true;
  }
}

// Those of the standard itself (classes, transfer syntaxes) say nothing of a patient and stay.
void Cleaner::replace_uids(DcmElement& element) {
  OFString text;
  element.getOFStringArray(text);
  std::string replaced;
  const std::string all(text.c_str());
  for (std::size_t begin = 0; begin <= all.size();) {
    const std::size_t end = std::min(all.find('\\', begin), all.size());
    const std::string uid = all.substr(begin, end - begin);
    const bool stays = uid.empty() || uid.starts_with("1.2.840.10008.");
    replaced += (begin > 0 ? "\\" : "") + (stays ? uid : uid_from_name(key_ + "/uid/" + uid));
    begin = end + 1;
  }
  if (replaced != all) replace(element, replaced);
}

void Cleaner::replace(DcmElement& element, const std::string& value) {
  count(element);
  element.putString(value.c_str());
}

void Cleaner::count(const DcmElement& element) {
  if (element.getLengthField() == 0) return;
  DcmTag tag = element.getTag();
  const bool is_private = (tag.getGroup() & 1) != 0;
  ++removed_[is_private ? "private elements" : std::string(tag.getTagName())];
}

Result<std::vector<fs::path>> files_under(const fs::path& path) {
  std::error_code problem;
  if (fs::is_regular_file(path, problem)) return std::vector{path};
  std::vector<fs::path> files;
  for (auto entry = fs::recursive_directory_iterator(path, problem); !problem && entry != fs::end(entry);
       entry.increment(problem)) {
    if (entry->is_regular_file()) files.push_back(entry->path());
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

// What a series is for, in words that scanning recognises again.
std::string description_of(Role role) {
  switch (role) {
    case Role::anatomy: return "anatomy";
    case Role::mre_magnitude: return "MRE magnitude";
    case Role::mre_phase: return "MRE phase";
    case Role::mre_wave: return "MRE wave";
    case Role::mre_stiffness: return "MRE stiffness";
    case Role::mre_confidence: return "MRE confidence";
    case Role::segmentation: return "segmentation";
    case Role::other: return "";
  }
  return "";
}

std::map<std::string, std::string> description_of_file(const fs::path& path) {
  std::map<std::string, std::string> descriptions;
  const auto study = scan(path);
  if (!study) return descriptions;
  for (const Series& series : study->series) {
    for (const fs::path& file : series.files) descriptions[file.string()] = description_of(series.role);
  }
  return descriptions;
}

Result<void> clean_file(const fs::path& file, const fs::path& out, const std::string& series_description,
                        const std::string& key, DeidentifyResult& result) {
  if (const auto checked = check_dicom_file(file); !checked) return failure(checked.error());
  DcmFileFormat format;
  const OFCondition loaded = format.loadFile(file.c_str());
  DcmDataset* data_set = format.getDataset();
  if (loaded.bad() || !data_set->tagExists(DCM_PixelData)) {
    return failure("dicom-damaged", GLISSON_TEXT("{0} holds no image, or is damaged."), {file.string()});
  }
  // Files that were stripped before may lack identifiers; a folder then stands for a series, as scanning takes it.
  const auto ensure = [&](const DcmTagKey& tag, const std::string& value) {
    if (text_of(*data_set, tag).empty()) data_set->putAndInsertString(tag, value.c_str());
  };
  ensure(DCM_SOPInstanceUID, uid_from_name(file.string()));
  ensure(DCM_SeriesInstanceUID, uid_from_name(file.parent_path().string()));
  ensure(DCM_SOPClassUID, text_of(*data_set, DCM_Modality) == "CT" ? UID_CTImageStorage : UID_MRImageStorage);
  warn_of_burned_in_text(*data_set, file, result.warnings);
  const E_TransferSyntax syntax = data_set->getOriginalXfer();
  Cleaner(key, result.removed).clean(*data_set, series_description);

  const fs::path target =
      out / text_of(*data_set, DCM_SeriesInstanceUID) / (text_of(*data_set, DCM_SOPInstanceUID) + ".dcm");
  auto written = write_atomically(target, [&](const fs::path& beside) -> Result<void> {
    // A new meta header: the old one may name the station that sent the file.
    const OFCondition saved = format.saveFile(beside.c_str(), syntax, EET_ExplicitLength, EGL_recalcGL, EPD_noChange, 0,
                                              0, EWM_createNewMeta);
    if (saved.good()) return {};
    return failure(Error{"file-not-writable",
                         GLISSON_TEXT("{0} cannot be written: {1}."),
                         {target.string(), saved.text()},
                         GLISSON_TEXT("Check the folder, your rights there and the free space."),
                         target});
  });
  if (written) result.files.push_back(target);
  return written;
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
  return std::mismatch(b.begin(), b.end(), a.begin(), a.end()).first == b.end();
}

}  // namespace
}  // namespace glisson::imaging
