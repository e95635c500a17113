// Walks a data set to its innermost items; what is put back at the outermost level is made here.

#include "imaging/internal/data_set_cleaner.h"

#include <algorithm>
#include <optional>
#include <vector>

#include "base/files.h"
#include "imaging/dicom_uid.h"
#include "imaging/internal/confidentiality.h"
#include "imaging/internal/dicom_fields.h"

namespace glisson::imaging {
namespace {

// Private values without which an elastography study cannot be read ("Retain Safe Private Option"): GE's kind of pulse
// sequence and part of the complex image, Siemens' number of tiles in a mosaic. They are read, and written anew.
struct SafePrivate {
  bool ge_elastography = false;
  std::optional<Uint16> ge_component;
  std::optional<Uint16> siemens_tiles;
};

std::optional<Uint16> small_number(DcmItem& item, unsigned group, const char* creator, unsigned element, int maximum) {
  const auto key = private_key(item, group, creator, element);
  if (!key || !item.tagExists(*key)) return std::nullopt;
  const std::string bytes = private_bytes(item, *key);
  const int number = whole_number_of(item, *key, bytes.size() == 2 ? static_cast<unsigned char>(bytes[0]) : -1);
  if (number < 0 || number > maximum) return std::nullopt;
  return static_cast<Uint16>(number);
}

SafePrivate safe_private_values(DcmItem& item) {
  SafePrivate safe;
  if (const auto key = private_key(item, 0x0019, "GEMS_ACQU_01", 0x9c)) {
    safe.ge_elastography = upper_case(private_bytes(item, *key)).find("MRE") != std::string::npos;
  }
  safe.ge_component = small_number(item, 0x0043, "GEMS_PARM_01", 0x2f, 3);
  safe.siemens_tiles = small_number(item, 0x0019, "SIEMENS MR HEADER", 0x0a, 4096);
  return safe;
}

void put_safe_private_values(DcmItem& item, const SafePrivate& safe) {
  const auto creator = [&](unsigned group, const char* name) {
    item.putAndInsertString(DcmTag(static_cast<Uint16>(group), 0x0010, EVR_LO), name);
  };
  if (safe.ge_elastography) {
    creator(0x0019, "GEMS_ACQU_01");
    item.putAndInsertString(DcmTag(0x0019, 0x109c, EVR_LO), "fgremre");
  }
  if (safe.ge_component) {
    creator(0x0043, "GEMS_PARM_01");
    item.putAndInsertSint16(DcmTag(0x0043, 0x102f, EVR_SS), static_cast<Sint16>(*safe.ge_component));
  }
  if (safe.siemens_tiles && !safe.ge_elastography) {
    creator(0x0019, "SIEMENS MR HEADER");
    item.putAndInsertUint16(DcmTag(0x0019, 0x100a, EVR_US), *safe.siemens_tiles);
  }
}

// Which parts of PS3.15 were followed, by their codes in PS3.16 (CID 7050).
void state_method(DcmDataset& data_set) {
  data_set.putAndInsertString(DCM_PatientIdentityRemoved, "YES");
  data_set.putAndInsertString(DCM_LongitudinalTemporalInformationModified, "REMOVED");
  data_set.putAndInsertString(DCM_DeidentificationMethod,
                              "Glisson: PS3.15 Annex E, what is not known to be harmless is removed");
  struct Option {
    const char* code;
    const char* meaning;
  };
  for (const Option& option :
       {Option{"113100", "Basic Application Confidentiality Profile"}, Option{"113105", "Clean Descriptors Option"},
        Option{"113111", "Retain Safe Private Option"}}) {
    DcmItem* code = nullptr;
    if (data_set.findOrCreateSequenceItem(DCM_DeidentificationMethodCodeSequence, code, -2).bad()) return;
    code->putAndInsertString(DCM_CodeValue, option.code);
    code->putAndInsertString(DCM_CodingSchemeDesignator, "DCM");
    code->putAndInsertString(DCM_CodeMeaning, option.meaning);
  }
}

// Enhanced images and segmentations must say when they were made and by which device; by these nobody is known.
void put_demanded_values(DcmDataset& data_set) {
  const std::string sop_class = text_of(data_set, DCM_SOPClassUID);
  const bool enhanced = data_set.tagExists(DCM_SharedFunctionalGroupsSequence) ||
                        data_set.tagExists(DCM_PerFrameFunctionalGroupsSequence);
  if (sop_class != UID_SegmentationStorage && !enhanced) return;
  data_set.putAndInsertString(DCM_ContentDate, "19000101");
  data_set.putAndInsertString(DCM_ContentTime, "000000");
  for (const DcmTagKey& key :
       {DCM_Manufacturer, DCM_ManufacturerModelName, DCM_DeviceSerialNumber, DCM_SoftwareVersions}) {
    if (text_of(data_set, key).empty()) data_set.putAndInsertString(key, placeholder_text);
  }
}

}  // namespace

void DataSetCleaner::clean(DcmDataset& data_set, const std::string& series_description) {
  const std::string patient = pseudonym("patient", text_of(data_set, DCM_PatientID));
  const SafePrivate safe = safe_private_values(data_set);
  clean_item(data_set);
  data_set.putAndInsertString(DCM_PatientName, patient.c_str());
  data_set.putAndInsertString(DCM_PatientID, patient.c_str());
  if (!series_description.empty()) data_set.putAndInsertString(DCM_SeriesDescription, series_description.c_str());
  put_demanded_values(data_set);
  put_safe_private_values(data_set, safe);
  state_method(data_set);
}

void DataSetCleaner::clean_item(DcmItem& item) {
  bool holds_code = false;
  for (unsigned long i = 0; i < item.card();) {
    DcmElement* element = item.getElement(i);
    if (may_stay(*element)) {
      holds_code = holds_code || handling_of(element->getTag().getXTag()) == Handling::code;
      ++i;
    } else {
      count(*element);
      delete item.remove(i);
    }
  }
  if (holds_code) clean_code(item);
  if (text_of(item, DCM_SegmentLabel) == "segment") {
    const std::string name = "segment-" + std::to_string(whole_number_of(item, DCM_SegmentNumber, 1));
    item.putAndInsertString(DCM_SegmentLabel, name.c_str());
  }
}

bool DataSetCleaner::may_stay(DcmElement& element) {
  const Handling handling = handling_of(element.getTag().getXTag());
  if (handling == Handling::remove || !has_its_own_kind(element)) return false;
  if (handling == Handling::sequence) {
    auto& sequence = static_cast<DcmSequenceOfItems&>(element);
    for (unsigned long n = 0; n < sequence.card(); ++n) clean_item(*sequence.getItem(n));
    return true;
  }
  if (handling == Handling::number) return holds_only_numbers(element);
  if (handling == Handling::empty) {
    count(element);
    return element.clear().good();
  }
  OFString all;
  if (element.getOFStringArray(all).bad()) return false;
  const std::string text(all.c_str(), all.size());
  switch (handling) {
    case Handling::new_uid: return replace_uids(element);
    case Handling::class_uid: return dcmFindNameOfUID(std::string(without_padding(text)).c_str()) != nullptr;
    case Handling::term: return is_technical(text);
    case Handling::image_type: return keep_text(element, technical_values(text));
    case Handling::code: return true;  // judged with the rest of its item
    case Handling::segment_name: return keep_text(element, known_segment_name(text));
    case Handling::vendor: return keep_text(element, known_vendor(without_padding(text)));
    case Handling::unit: return keep_text(element, known_unit(text));
    case Handling::stack: return keep_text(element, pseudonym("stack", text).substr(0, 16));
    case Handling::placeholder: return keep_text(element, placeholder_text);
    default: return false;
  }
}

bool DataSetCleaner::keep_text(DcmElement& element, const std::string& text) {
  OFString old;
  if (element.getOFStringArray(old).good() && text == old.c_str() && old.size() == text.size()) return true;
  count(element);
  return element.putString(text.c_str()).good();
}

// Every one, whatever it looks like: an identifier of the standard itself has no place where instances are named.
bool DataSetCleaner::replace_uids(DcmElement& element) {
  OFString text;
  element.getOFStringArray(text);
  std::string replaced;
  bool first = true;
  each_part(std::string_view(text.c_str(), text.size()), "\\", [&](std::string_view part) {
    const std::string uid(without_padding(part));
    replaced += (first ? "" : "\\") + (uid.empty() ? uid : uid_from_name(key_ + "/uid/" + uid));
    first = false;
  });
  count(element);
  return element.putString(replaced.c_str()).good();
}

void DataSetCleaner::count(const DcmElement& element) {
  if (element.getLengthField() == 0) return;
  DcmTag tag = element.getTag();
  const bool is_private = (tag.getGroup() & 1) != 0;
  ++removed_[is_private ? "private elements" : std::string(tag.getTagName())];
}

std::string DataSetCleaner::pseudonym(const std::string& kind, const std::string& old) const {
  return "ANON-" + sha256_of_text(key_ + "/" + kind + "/" + old).substr(0, 12);
}

}  // namespace glisson::imaging
