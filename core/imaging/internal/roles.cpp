// The rules, in the order in which they are tried. Where the facts come from:
//
// - Units and ImageType: PS3.3 C.11.1.1.2 and C.7.6.1.1.2.
// - GE: the private pulse sequence name (0019,xx9c) is "fgremre" or "epimre". Derived series end in 01 (stiffness in
//   Pa, window centre 4000 or more), 05 (processed waves) and 07 (confidence 0 to 999, window 950 / 100). With several
//   phases 07 are waves again. Coloured "SCREEN SAVE" copies of all of them are sent along. After the hepatosplenic
//   MRE tools of M. Yin, Mayo Clinic, which sort GE's elastography series by these.
// - Siemens: ImageType has M or P third; the elastograms, wave and confidence series say so in their descriptions.
//   Measured series of the Charité have ImageComments that begin with "MRE:".
// - Philips: ImageType has M, P, R or I fourth ("M_FFE", "PHASE MAP"); maps name themselves in the description.

#include "imaging/internal/roles.h"

#include <algorithm>
#include <cctype>
#include <optional>

#include "imaging/internal/dicom_fields.h"

namespace glisson::imaging {
namespace {

// A field's words in capitals, each between single blanks: " 2D GRE MRE ".
std::string words_of(const std::string& text) {
  std::string words = " ";
  for (const char c : upper_case(text)) {
    const bool in_word = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '%';
    if (in_word) words += c;
    if (!in_word && words.back() != ' ') words += ' ';
  }
  if (words.back() != ' ') words += ' ';
  return words;
}

struct Field {
  std::string name;
  std::string words;
};

// Finds the first field that has one of some words. A word given with blanks around it must stand alone.
class Fields {
 public:
  explicit Fields(const RoleClues& clues) {
    add("SeriesDescription", clues.description);
    for (const std::string& value : clues.image_type) add("ImageType", value);
    add("ProtocolName", clues.protocol);
    add("SequenceName", clues.sequence_name);
    add("the pulse sequence", clues.ge_pulse_sequence);
    add("ImageComments", clues.comments);
  }
  explicit Fields(const std::string& file_name) { add("the file name", file_name); }

  [[nodiscard]] std::optional<std::string> naming(std::initializer_list<const char*> words) const {
    for (const Field& field : fields_) {
      for (const char* word : words) {
        if (field.words.find(word) == std::string::npos) continue;
        const std::string shown = field.words.substr(1, field.words.size() - 2);
        return field.name + " \"" + shown.substr(0, 64) + "\"";
      }
    }
    return std::nullopt;
  }

 private:
  void add(const std::string& name, const std::string& text) {
    if (!text.empty()) fields_.push_back({name, words_of(text)});
  }
  std::vector<Field> fields_;
};

std::optional<RoleFinding> map_named_in(const Fields& fields, const std::string& unit);
std::optional<RoleFinding> ge_derived_series(const RoleClues& clues);
std::optional<RoleFinding> measured_part(const RoleClues& clues, const Fields& fields, const std::string& mre_evidence);

std::optional<std::string> sign_of_elastography(const RoleClues& clues, const Fields& fields) {
  if (const auto named = fields.naming({" MRE", "MRE ", "ELASTO", "MRTOUCH", " MR TOUCH ", "RESOUNDANT"})) return named;
  if (clues.unit == "Pa" || clues.unit == "kPa") return "values in " + clues.unit;
  return std::nullopt;
}

}  // namespace

RoleFinding role_of(const RoleClues& clues) {
  const Fields fields(clues);
  if (clues.modality == "SEG") return {Role::segmentation, "Modality SEG"};
  if (clues.is_colour) return {Role::other, "a picture in colour, not values"};
  if (const auto named = fields.naming({"LOCALIZER", "SCOUT", " SURVEY", "3 PLANE LOC", "SCREEN SAVE"})) {
    return {Role::other, *named};
  }
  const auto mre = sign_of_elastography(clues, fields);
  if (const auto map = map_named_in(fields, clues.unit); map && (mre || map->role == Role::mre_stiffness)) return *map;
  if (mre) {
    if (const auto ge = ge_derived_series(clues)) return *ge;
    if (const auto part = measured_part(clues, fields, *mre)) return *part;
    return {Role::other, "elastography by " + *mre + ", but nothing says which part of it"};
  }
  if (clues.modality != "MR" && clues.modality != "CT") {
    return {Role::other, "Modality " + (clues.modality.empty() ? "not given" : clues.modality)};
  }
  if (clues.component == "P" || clues.component == "R" || clues.component == "I") {
    return {Role::other, "part " + clues.component + " of a complex image, with no sign of elastography"};
  }
  if (const auto named = fields.naming(
          {" ADC ", " FA ", " PDFF", "FAT FRAC", "FATFRAC", "T2STAR MAP", " T1 MAP", " T2 MAP", "PARAMETRIC"})) {
    return {Role::other, "a computed map by " + *named};
  }
  return {Role::anatomy, "Modality " + clues.modality + " with no sign of elastography"};
}

RoleFinding role_of_volume_file(const std::string& file_name, bool holds_bytes) {
  const Fields fields(file_name);
  if (const auto named = fields.naming({" SEG", "SEG ", "LABEL", "MASK"})) return {Role::segmentation, *named};
  if (const auto map = map_named_in(fields, "")) return *map;
  const auto mre = fields.naming({" MRE", "MRE "});
  if (const auto named = fields.naming({"PHASE"}); mre && named) return {Role::mre_phase, *named};
  if (const auto named = fields.naming({"MAG"}); mre && named) return {Role::mre_magnitude, *named};
  if (holds_bytes) return {Role::segmentation, "values of 8 bits, as label maps have"};
  return {Role::anatomy, "a volume file of which nothing says otherwise"};
}

namespace {

// Maps computed from the waves, which name themselves. A map of confidence names the stiffness too, unless it is the
// stiffness that was masked by it.
std::optional<RoleFinding> map_named_in(const Fields& fields, const std::string& unit) {
  const bool in_pascal = unit == "Pa" || unit == "kPa";
  if (const auto named = fields.naming({"STORAGE", " LOSS ", "DAMPING", "WAVE SPEED", "WAVESPEED", "ATTENUATION"})) {
    return RoleFinding{Role::other, "not the shear stiffness by " + *named};
  }
  const auto stiffness = fields.naming({"STIFF", "ELASTOGRAM", "SHEAR MODULUS", "SHEARMODULUS", " KPA"});
  const auto confidence = fields.naming({"CONFIDENCE", " CONF ", "CONFMAP", " CONF MAP"});
  const bool masked = fields.naming({"MASK"}).has_value();
  if (confidence && !in_pascal && !(stiffness && masked)) return RoleFinding{Role::mre_confidence, *confidence};
  if (stiffness) return RoleFinding{Role::mre_stiffness, *stiffness};
  if (in_pascal) return RoleFinding{Role::mre_stiffness, "values in " + unit};
  if (const auto wave = fields.naming({"WAVE", "DISPLACEMENT", " CURL"})) return RoleFinding{Role::mre_wave, *wave};
  return std::nullopt;
}

std::optional<RoleFinding> ge_derived_series(const RoleClues& clues) {
  const bool ge_mre = upper_case(clues.ge_pulse_sequence).find("MRE") != std::string::npos;
  const bool derived = !clues.image_type.empty() && clues.image_type.front() == "DERIVED";
  if (!ge_mre) return std::nullopt;
  const std::string evidence =
      "GE pulse sequence " + clues.ge_pulse_sequence + ", series number " + std::to_string(clues.series_number);
  const int ending = clues.series_number % 100;
  if (clues.series_number >= 100 && ending == 5) return RoleFinding{Role::mre_wave, evidence};
  if (!derived || clues.series_number < 100) return std::nullopt;
  const bool window_of_confidence = clues.window_center > 500 && clues.window_width > 0 && clues.window_width < 500;
  if (ending == 1 && !window_of_confidence) return RoleFinding{Role::mre_stiffness, evidence};
  if (ending == 7) return RoleFinding{clues.volumes > 1 ? Role::mre_wave : Role::mre_confidence, evidence};
  if (window_of_confidence) return RoleFinding{Role::mre_confidence, evidence + ", window of a confidence map"};
  return std::nullopt;
}

std::optional<RoleFinding> measured_part(const RoleClues& clues, const Fields& fields,
                                         const std::string& mre_evidence) {
  const std::string by = " of elastography by " + mre_evidence;
  if (clues.component == "P") return RoleFinding{Role::mre_phase, "the phase" + by};
  if (clues.component == "M") return RoleFinding{Role::mre_magnitude, "the magnitude" + by};
  if (const auto named = fields.naming({"PHASE", " PHA ", " PH "})) return RoleFinding{Role::mre_phase, *named};
  if (const auto named = fields.naming({" MAG", "MAG "})) return RoleFinding{Role::mre_magnitude, *named};
  if (clues.unit == "rad") return RoleFinding{Role::mre_phase, "values in rad" + by};
  if (clues.unit == "um") return RoleFinding{Role::mre_wave, "values in um" + by};
  return std::nullopt;
}

}  // namespace
}  // namespace glisson::imaging
