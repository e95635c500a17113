#pragma once
// Which attributes of an image may leave the hospital, and in what form.
//
// The Basic Application Level Confidentiality Profile (DICOM PS3.15, Annex E, table E.1-1) lists what must go. Here it
// is turned round: what is not known to be harmless goes. So an attribute of a newer edition goes too, or one whose
// value is not what its kind promises. The kind is the dictionary's, never the one that a file claims.

#include <algorithm>
#include <string>
#include <string_view>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

namespace glisson::imaging {

// What becomes of an attribute, at every level of nesting; the letter is table E.1-1's action.
enum class Handling {
  remove,       // X
  empty,        // Z
  placeholder,  // D: a text that the standard demands, without what it said
  new_uid,      // U
  class_uid,    // stays where the standard registers it (a class of objects), else goes
  number,       // stays where it is numbers, and as many as the dictionary allows
  term,         // stays where every word of it is one of the standard's or a vendor's technical terms
  image_type,   // the same, value by value: their places carry a meaning
  code,         // the value of a code: judged with its scheme and meaning, by clean_code
  segment_name,
  vendor,
  unit,
  stack,     // a name that only tells stacks apart: replaced consistently
  sequence,  // stays, each item cleaned
};

// remove, too, for what the dictionary does not know and for private attributes.
[[nodiscard]] Handling handling_of(const DcmTagKey& key);

// Whether the element is of the kind that the dictionary gives for its tag.
[[nodiscard]] bool has_its_own_kind(DcmElement& element);

[[nodiscard]] bool holds_only_numbers(DcmElement& element);

// Whether each word of each value is a technical term. Words are parted by blanks and underscores.
[[nodiscard]] bool is_technical(std::string_view values);
// The same with "OTHER" in the place of each value that is not.
[[nodiscard]] std::string technical_values(std::string_view values);

// "SIEMENS" for "Siemens Healthineers, ward 3"; "ANONYMIZED" for a maker that is not known.
[[nodiscard]] std::string known_vendor(std::string_view manufacturer);

// The unit where it is one of those that rescaling knows, else "US", which is DICOM's "unspecified".
[[nodiscard]] std::string known_unit(std::string_view unit);

// The name where it is made of anatomical words and short numbers ("liver", "tumour-2"), else "segment".
[[nodiscard]] std::string known_segment_name(std::string_view name);

// A code's meaning is the one that is known for it here, whatever the file says. A code that is not known here becomes
// (removed, 99GLISSON).
void clean_code(DcmItem& item);

inline constexpr const char* placeholder_text = "ANONYMIZED";

// Without the blanks and zeros that DICOM pads with.
[[nodiscard]] inline std::string_view without_padding(std::string_view text) {
  constexpr std::string_view padding(" \0", 2);
  const auto begin = text.find_first_not_of(padding);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(padding) + 1 - begin);
}

// Calls visit(part) for each part of the text between any of the separators, empty ones too.
template <typename Visit>
void each_part(std::string_view text, std::string_view separators, Visit visit) {
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find_first_of(separators, begin), text.size());
    visit(text.substr(begin, end - begin));
    begin = end + 1;
  }
}

}  // namespace glisson::imaging
