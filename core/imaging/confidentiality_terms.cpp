// The words that texts of an image may be made of, and the codes that it may hold.

#include <algorithm>
#include <optional>
#include <set>

#include "imaging/internal/confidentiality.h"
#include "imaging/internal/dicom_fields.h"
#include "imaging/segment_codes.h"

namespace glisson::imaging {
namespace {

// Of PS3.3's defined terms, of the standard's codes for compression, and of vendors' kinds of image.
const std::set<std::string, std::less<>>& technical_words() {
  static const std::set<std::string, std::less<>> words = {
      // kinds of image, components, parts and maps
      "ORIGINAL", "DERIVED", "MIXED", "PRIMARY", "SECONDARY", "AXIAL", "LOCALIZER", "OTHER", "M", "P", "R", "I", "ND",
      "NORM", "DIS2D", "DIS3D", "MOSAIC", "FFE", "SE", "IR", "FFEIR", "MAG", "MAGNITUDE", "PHASE", "MAP", "REAL",
      "IMAGINARY", "MRE", "MR", "ELASTO", "ELASTOGRAM", "ELASTOGRAPHY", "STIFFNESS", "WAVE", "WAVES", "CONFIDENCE",
      "CONF", "SHEAR", "MODULUS", "CURL", "DISPLACEMENT", "SCREEN", "SAVE", "MASK", "MASKED", "SUM", "ADD", "AVERAGE",
      "MEAN", "MEDIAN", "MPR", "MIP", "MAX", "MIN", "PROJECTION", "IMAGE", "REFORMATTED", "RESAMPLED", "SUBTRACTION",
      "T1", "T2", "T2STAR", "PDFF", "FAT", "WATER", "IN", "OUT", "OPP", "OPPOSED", "FRACTION", "ADC", "TRACE", "FA",
      "DIFFUSION", "PERFUSION", "VELOCITY", "FLOW", "ENCODED", "VOLUME", "MULTIPLICATION", "DIVISION", "FILTERED", "CT",
      "SEG", "PT", "US", "NM", "OT", "ES", "XC", "CR", "DX", "MG", "RF", "XA", "REG", "SR", "PR", "KO", "RT", "BASE",
      "SOM5", "SPI", "HELIX", "HELICAL", "SEQ", "SPIRAL", "SEQUENCED", "CONSTANT", "ANGLE", "STATIONARY", "FREE",
      "NONE", "UNKNOWN", "YES", "NO", "Y", "N", "TRUE", "COLOR", "MONOCHROME", "MONOCHROME1", "MONOCHROME2", "RGB",
      "PALETTE", "YBR", "FULL", "422", "420", "PARTIAL", "ICT", "RCT", "PRODUCT", "RESEARCH", "SERVICE", "DISTORTED",
      "SAMPLED", "FOR", "PRESENTATION", "PROCESSING", "IDENTITY", "INVERSE", "LINEAR", "EXACT", "SIGMOID", "LIN", "LOG",
      "3D", "2D", "1D", "TEMPORAL", "TILED", "SPARSE", "COMPLEX",
      // positions and sides
      "HFS", "HFP", "HFDR", "HFDL", "FFS", "FFP", "FFDR", "FFDL", "L", "B", "U", "ROW", "COL", "COLUMN", "CW", "CC",
      // how MR images are made
      "GR", "EP", "RM", "SK", "MTC", "SS", "TRSS", "SP", "MP", "OSP", "PER", "RG", "CG", "PPG", "FC", "PFF", "PFP",
      "FS", "TOF", "EPI", "GEMS", "FAST", "FAST-GEMS", "VB", "SPIN", "GRADIENT", "BOTH", "PHASEENCODE", "ACCELERATION",
      "READOUT", "SLICE", "SELECT", "SELECTIVE", "NON", "RF", "RESONANCE", "OFF", "ON", "SINGLE", "DOUBLE", "MULTIPLE",
      "WHITE", "BLACK", "GRID", "LINE", "SLAB", "FREQUENCY", "RECTILINEAR", "RADIAL", "REVERSE", "CENTRIC", "SEGMENTED",
      "PARTIALLY", "PILS", "SENSE", "SMASH", "GRAPPA", "CAIPI", "COMPRESSED", "SENSING", "RIESZ", "HANNING", "HAMMING",
      "GAUSSIAN", "COSINE", "FERMI", "KAISER", "CYLINDRICAL", "ELLIPSOIDAL", "WEDGE", "1H", "31P", "13C", "23NA", "19F",
      "3HE", "129XE", "BODY", "VOLUMETRIC", "SURFACE", "MULTICOIL", "HEAD", "DIRECTIONAL", "BMATRIX", "ISOTROPIC",
      "FRACTIONAL", "RELATIVE", "VOLUME_RATIO", "IEC", "FDA", "MHW", "REALTIME", "PROSPECTIVE", "RETROSPECTIVE",
      "PACED", "BREATH", "HOLD", "GATING", "TRACKING", "REORDERING", "PROTON", "DENSITY", "STIR", "TAGGING",
      "INVERSION", "RECOVERY", "TRANSFER", "MAGNETIZATION", "OPTIMIZED", "W",
      // how CT images are made
      "ITERATIVE", "FILTER", "BACK", "PROJ", "ANGULAR", "XYZ", "EC", "Z", "CARE", "DOSE", "DOSE4D",
      // compression and segmentations
      "ISO", "10918", "14495", "15444", "13818", "LOSSLESS", "LOSSY", "BINARY", "PROBABILITY", "OCCUPANCY", "LABELMAP",
      "AUTOMATIC", "SEMIAUTOMATIC", "MANUAL", "SEGMENTATION", "UNDEFINED"};
  return words;
}

bool is_short_number(std::string_view word) {
  return word.size() <= 2 && std::all_of(word.begin(), word.end(), [](char c) { return c >= '0' && c <= '9'; });
}

bool is_technical_value(std::string_view value) {
  bool technical = true;
  each_part(without_padding(value), " _", [&](std::string_view word) {
    technical = technical && (is_short_number(word) || technical_words().contains(word));
  });
  return technical;
}

struct KnownCode {
  const char* value;
  const char* scheme;
  const char* meaning;
};

// What segmentations of the abdomen, derivations and units are coded with, beside what we code ourselves
// (segment_concept): SNOMED CT, its older identifiers, DICOM's own codes (PS3.16) and UCUM.
constexpr KnownCode known_codes[] = {{"T-D0050", "SRT", "Tissue"},
                                     {"M-01000", "SRT", "Morphologically Altered Structure"},
                                     {"T-D000A", "SRT", "Anatomical Structure"},
                                     {"T-62000", "SRT", "Liver"},
                                     {"T-48810", "SRT", "Portal vein"},
                                     {"T-48720", "SRT", "Hepatic vein"},
                                     {"76015000", "SCT", "Hepatic artery"},
                                     {"T-63000", "SRT", "Gallbladder"},
                                     {"29092000", "SCT", "Vein"},
                                     {"59820001", "SCT", "Blood vessel"},
                                     {"15825003", "SCT", "Aorta"},
                                     {"64131007", "SCT", "Inferior vena cava"},
                                     {"78961009", "SCT", "Spleen"},
                                     {"64033007", "SCT", "Kidney"},
                                     {"15776009", "SCT", "Pancreas"},
                                     {"69695003", "SCT", "Stomach"},
                                     {"818983003", "SCT", "Abdomen"},
                                     {"113345001", "SCT", "Abdomen"},
                                     {"T-D4000", "SRT", "Abdomen"},
                                     {"M-8000/0", "SRT", "Neoplasm"},
                                     {"M-03000", "SRT", "Mass"},
                                     {"4147007", "SCT", "Mass"},
                                     {"52988006", "SCT", "Lesion"},
                                     {"113076", "DCM", "Segmentation"},
                                     {"121322", "DCM", "Source image for image processing operation"},
                                     {"113037", "DCM", "Lossy compression"},
                                     {"113041", "DCM", "Time course of signal"},
                                     {"kPa", "UCUM", "kilopascal"},
                                     {"Pa", "UCUM", "pascal"},
                                     {"[hnsf'U]", "UCUM", "Hounsfield unit"},
                                     {"rad", "UCUM", "radian"},
                                     {"mrad", "UCUM", "milliradian"},
                                     {"um", "UCUM", "micrometre"},
                                     {"mm", "UCUM", "millimetre"},
                                     {"ms", "UCUM", "millisecond"},
                                     {"1", "UCUM", "no units"},
                                     {"mm2/s", "UCUM", "mm2/s"}};

std::optional<KnownCode> known_code(std::string_view value, std::string_view scheme) {
  const bool older_name = scheme == "SNM3" || scheme == "99SDM";
  const auto* known = std::find_if(std::begin(known_codes), std::end(known_codes), [&](const KnownCode& code) {
    return value == code.value && (scheme == code.scheme || (older_name && code.scheme == std::string_view("SRT")));
  });
  if (known != std::end(known_codes)) return *known;
  const auto ours = scheme == "SCT" ? segment_concept(value) : std::nullopt;
  return ours ? std::optional(KnownCode{ours->value, "SCT", ours->meaning}) : std::nullopt;
}

}  // namespace

bool is_technical(std::string_view values) {
  bool technical = true;
  each_part(values, "\\", [&](std::string_view value) { technical = technical && is_technical_value(value); });
  return technical;
}

std::string technical_values(std::string_view values) {
  std::string kept;
  bool first = true;
  each_part(values, "\\", [&](std::string_view value) {
    kept += (first ? "" : "\\") + (is_technical_value(value) ? std::string(without_padding(value)) : "OTHER");
    first = false;
  });
  return kept;
}

std::string known_vendor(std::string_view manufacturer) {
  const std::string name = upper_case(std::string(manufacturer));
  for (const char* vendor :
       {"SIEMENS", "GE MEDICAL SYSTEMS", "Philips", "CANON", "TOSHIBA", "HITACHI", "Bruker", "UIH", "Glisson"}) {
    if (name.find(upper_case(vendor)) != std::string::npos) return vendor;
  }
  return manufacturer.empty() ? "" : placeholder_text;
}

std::string known_unit(std::string_view unit) {
  const std::string written(without_padding(unit));
  for (const char* known : {"HU", "Pa", "kPa", "rad", "mrad", "um", "OD", "PASCAL", "KILOPASCAL", "RADIANS", "RADIAN",
                            "MILLIRADIANS", "MILLIRADIAN", "MICROMETER", "MICROMETRE"}) {
    if (upper_case(written) == upper_case(known)) return written;
  }
  return "US";
}

std::string known_segment_name(std::string_view name) {
  static const std::set<std::string, std::less<>> words = {
      "LIVER",      "PORTAL",   "VEIN",      "VEINS",       "HEPATIC", "VENA",     "CAVA",    "INFERIOR", "IVC",
      "ARTERY",     "ARTERIES", "AORTA",     "GALLBLADDER", "GALL",    "BLADDER",  "BILE",    "DUCT",     "DUCTS",
      "TUMOUR",     "TUMOR",    "TUMOURS",   "TUMORS",      "LESION",  "LESIONS",  "CYST",    "CYSTS",    "METASTASIS",
      "METASTASES", "NEOPLASM", "MASS",      "SPLEEN",      "KIDNEY",  "PANCREAS", "STOMACH", "VESSEL",   "VESSELS",
      "SEGMENT",    "TISSUE",   "LEFT",      "RIGHT",       "MIDDLE",  "LOBE",     "AND",     "OF",       "THE",
      "RESECTION",  "REMNANT",  "TERRITORY", "SKIN",        "BODY",    "BONE",     "LUNG",    "HEART"};
  bool known = !name.empty();
  each_part(upper_case(std::string(without_padding(name))), " -_", [&](std::string_view word) {
    known = known && !word.empty() && (is_short_number(word) || words.contains(word));
  });
  return known ? std::string(without_padding(name)) : "segment";
}

void clean_code(DcmItem& item) {
  const std::string value = text_of(item, DCM_CodeValue), scheme = text_of(item, DCM_CodingSchemeDesignator);
  const auto known = known_code(value, scheme);
  item.putAndInsertString(DCM_CodeValue, known ? known->value : "removed");
  item.putAndInsertString(DCM_CodingSchemeDesignator, known ? known->scheme : "99GLISSON");
  item.putAndInsertString(DCM_CodeMeaning, known ? known->meaning : "removed");
}

}  // namespace glisson::imaging
