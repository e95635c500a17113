// Walks the structure of a DICOM file (PS3.5 chapter 7 and annex A) with a stack of its own in place of recursion.

#include "imaging/internal/checked_dicom.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <string_view>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctag.h>

#include "imaging/internal/file_bytes.h"

namespace glisson::imaging {
namespace {

constexpr std::uint32_t undefined_length = 0xFFFFFFFFu;
constexpr std::uint32_t item_tag = 0xFFFEE000u;
constexpr std::uint32_t item_end_tag = 0xFFFEE00Du;
constexpr std::uint32_t sequence_end_tag = 0xFFFEE0DDu;

// Real headers nest up to eight deep (structured reports), enhanced images with 10,000 frames have some 20 MiB and a
// million elements.
constexpr std::size_t deepest_nesting = 32;
constexpr std::uint64_t maximum_dicom_header_bytes = std::uint64_t{64} << 20;
constexpr std::uint64_t maximum_elements = 2'000'000;
constexpr std::uint64_t maximum_value_bytes_kept = std::uint64_t{1} << 20;

struct Element {
  std::uint32_t tag = 0;
  std::array<char, 2> vr{'U', 'N'};
  std::uint32_t length = 0;
  std::uint64_t header_bytes = 8;

  [[nodiscard]] bool is(const char* name) const { return vr[0] == name[0] && vr[1] == name[1]; }
  [[nodiscard]] bool is_pixels() const { return tag == 0x7FE00010u || tag == 0x7FE00008u || tag == 0x7FE00009u; }
};

// A sequence or an item that the walk is inside of.
struct Enclosure {
  bool is_sequence = true;
  bool ends_with_delimiter = false;
  std::uint64_t end = 0;  // the byte after it, or after the next enclosure outwards that knows
  bool explicit_vr = true;
  bool little_endian = true;
};

class Walk {
 public:
  explicit Walk(FileBytes& bytes) : bytes_(bytes) {}

  Result<CheckedDicom> run();

 private:
  Result<void> read_meta_information();
  Result<void> guess_without_meta_information();
  Result<void> walk_data_set();
  Result<void> step_into(const Element& element, bool outermost);
  Result<void> step_in_sequence();
  Result<void> locate_pixels(const Element& element);
  Result<void> locate_fragments();
  Result<Element> element_here(bool explicit_vr, bool little_endian) const;
  Result<void> push(Enclosure enclosure);
  void leave_finished_enclosures();

  [[nodiscard]] std::uint64_t innermost_end() const { return open_.empty() ? bytes_.end() : open_.back().end; }
  [[nodiscard]] Failure error(const char* code, std::string text, std::vector<std::string> more = {}) const;

  FileBytes& bytes_;
  std::uint64_t at_ = 0;  // index in bytes_
  std::uint64_t data_set_begin_ = 0;
  std::uint64_t elements_ = 0;
  std::vector<Enclosure> open_;
  CheckedDicom found_;
};

std::uint16_t number16(const std::uint8_t* p, bool little_endian) {
  return static_cast<std::uint16_t>(little_endian ? p[0] | p[1] << 8 : p[1] | p[0] << 8);
}

std::uint32_t number32(const std::uint8_t* p, bool little_endian) {
  const std::uint32_t first = number16(p, little_endian);
  const std::uint32_t second = number16(p + 2, little_endian);
  return little_endian ? first | second << 16 : second | first << 16;
}

std::uint32_t tag_at(const std::uint8_t* p, bool little_endian) {
  return static_cast<std::uint32_t>(number16(p, little_endian)) << 16 | number16(p + 2, little_endian);
}

// The value representations of PS3.5 table 6.2-1: those with a length of 16 bits, and those with 32.
constexpr std::string_view short_vrs = "AE AS AT CS DA DS DT FD FL IS LO LT PN SH SL SS ST TM UI UL US";
constexpr std::string_view long_vrs = "OB OD OF OL OV OW SQ SV UC UN UR UT UV";

bool is_one_of(const std::array<char, 2>& vr, std::string_view names) {
  for (std::size_t i = 0; i + 1 < names.size(); i += 3) {
    if (names[i] == vr[0] && names[i + 1] == vr[1]) return true;
  }
  return false;
}

bool looks_like_vr(const std::uint8_t* p) {
  const std::array<char, 2> vr{static_cast<char>(p[0]), static_cast<char>(p[1])};
  return is_one_of(vr, short_vrs) || is_one_of(vr, long_vrs);
}

// Implicit VR leaves it to the dictionary what is a sequence. An unknown element that begins with an item is taken for
// one too: wherever a parser might descend, this walk has been before.
bool may_be_sequence(std::uint32_t tag, const std::uint8_t* value, std::uint64_t value_bytes, bool little_endian) {
  const DcmTag known(static_cast<Uint16>(tag >> 16), static_cast<Uint16>(tag & 0xFFFFu));
  if (known.getEVR() == EVR_SQ) return true;
  return value != nullptr && value_bytes >= 8 && tag_at(value, little_endian) == item_tag;
}

Result<TransferSyntax> transfer_syntax(const std::string& uid, const std::filesystem::path& file) {
  TransferSyntax syntax;
  syntax.uid = uid;
  if (uid == "1.2.840.10008.1.2") {
    syntax.explicit_vr = false;
  } else if (uid == "1.2.840.10008.1.2.2") {
    syntax.little_endian = false;
  } else if (uid == "1.2.840.10008.1.2.1.99") {
    return failure(Error{"dicom-deflated",
                         GLISSON_TEXT("{0} is deflated as a whole, which is not read."),
                         {file.string()},
                         GLISSON_TEXT("Convert it first, for example with dcmconv +te."),
                         file});
  } else if (uid != "1.2.840.10008.1.2.1") {
    syntax.encapsulated = true;
  }
  return syntax;
}

}  // namespace

Result<CheckedDicom> check_dicom_file(const std::filesystem::path& file) {
  Result<FileBytes> bytes = FileBytes::open(file);
  if (!bytes) return failure(bytes.error());
  return Walk(*bytes).run();
}

namespace {

Result<CheckedDicom> Walk::run() {
  if (bytes_.end() == 0) return error("file-empty", GLISSON_TEXT("{0} is empty."));
  const std::uint8_t* preamble = bytes_.view(0, 132);
  const bool has_preamble = preamble != nullptr && std::memcmp(preamble + 128, "DICM", 4) == 0;
  if (has_preamble) at_ = 132;
  const Result<void> begun = has_preamble ? read_meta_information() : guess_without_meta_information();
  if (!begun) return failure(begun.error());
  data_set_begin_ = at_;
  if (const Result<void> walked = walk_data_set(); !walked) return failure(walked.error());
  found_.data_set = bytes_.copy(data_set_begin_, at_);
  found_.file_bytes = bytes_.file_bytes();
  return std::move(found_);
}

// Group 0002, always explicit little endian; of interest is only the transfer syntax.
Result<void> Walk::read_meta_information() {
  std::string uid = "1.2.840.10008.1.2";
  while (const std::uint8_t* tag = bytes_.view(at_, 8)) {
    if (number16(tag, true) != 0x0002) break;
    const Result<Element> element = element_here(true, true);
    if (!element) return failure(element.error());
    const std::uint64_t value = at_ + element->header_bytes;
    const std::uint8_t* text = element->length <= 64 ? bytes_.view(value, element->length) : nullptr;
    if (element->length == undefined_length || element->length > bytes_.end() - value) {
      return error("dicom-length", GLISSON_TEXT("{0} declares a length beyond its end in its first lines."));
    }
    if (element->tag == 0x00020010u && text != nullptr) {
      uid.assign(reinterpret_cast<const char*>(text), element->length);
      while (!uid.empty() && (uid.back() == '\0' || uid.back() == ' ')) uid.pop_back();
    }
    at_ = value + element->length;
  }
  Result<TransferSyntax> syntax = transfer_syntax(uid, bytes_.file());
  if (!syntax) return failure(syntax.error());
  found_.syntax = *syntax;
  return {};
}

// Files of before 1993's part 10 begin with the data set itself. Only the little-endian forms are taken, and only when
// the first element is of group 0008, with which every image begins.
Result<void> Walk::guess_without_meta_information() {
  const std::uint8_t* first = bytes_.view(0, 8);
  if (first == nullptr || number16(first, true) != 0x0008 || number16(first + 2, true) > 0x0070) {
    return error("not-dicom",
                 GLISSON_TEXT("{0} is no DICOM file, nor named as one of the volume files that are read."));
  }
  found_.syntax.explicit_vr = looks_like_vr(first + 4);
  found_.syntax.uid = found_.syntax.explicit_vr ? "1.2.840.10008.1.2.1" : "1.2.840.10008.1.2";
  return {};
}

Result<void> Walk::walk_data_set() {
  while (true) {
    leave_finished_enclosures();
    if (open_.empty() && at_ == bytes_.end()) return {};
    if (++elements_ > maximum_elements || at_ - data_set_begin_ > maximum_dicom_header_bytes) {
      return error("dicom-header-too-large", GLISSON_TEXT("The header of {0} is too large to be that of an image."));
    }
    if (!open_.empty() && open_.back().is_sequence) {
      if (const Result<void> stepped = step_in_sequence(); !stepped) return stepped;
      continue;
    }
    const bool outermost = open_.empty();
    const Result<Element> element = element_here(outermost ? found_.syntax.explicit_vr : open_.back().explicit_vr,
                                                 outermost ? found_.syntax.little_endian : open_.back().little_endian);
    if (!element) return failure(element.error());
    if (element->tag == item_end_tag && !outermost && open_.back().ends_with_delimiter && element->length == 0) {
      at_ += 8;
      open_.pop_back();
      continue;
    }
    if (element->tag >> 16 == 0xFFFEu) {
      return error("dicom-damaged", GLISSON_TEXT("{0} is damaged: an item stands outside a sequence at byte {1}."),
                   {std::to_string(bytes_.offset(at_))});
    }
    if (outermost && element->is_pixels()) return locate_pixels(*element);
    if (const Result<void> stepped = step_into(*element, outermost); !stepped) return stepped;
  }
}

// Over an element's value, or into it where it is a sequence.
Result<void> Walk::step_into(const Element& element, bool outermost) {
  const bool explicit_vr = outermost ? found_.syntax.explicit_vr : open_.back().explicit_vr;
  const bool little_endian = outermost ? found_.syntax.little_endian : open_.back().little_endian;
  const std::uint64_t value = at_ + element.header_bytes;
  if (element.length == undefined_length) {
    // UN of undefined length holds a sequence in implicit VR little endian (PS3.5, 6.2.2 note 4).
    const bool unknown = explicit_vr && element.is("UN");
    if (explicit_vr && !unknown && !element.is("SQ")) {
      return error("dicom-length", GLISSON_TEXT("{0} is damaged: a value without a length stands at byte {1}."),
                   {std::to_string(bytes_.offset(at_))});
    }
    at_ = value;
    return push({true, true, innermost_end(), explicit_vr && !unknown, little_endian || unknown});
  }
  if (element.length > innermost_end() - value) {
    if (outermost) {
      return error("dicom-truncated", GLISSON_TEXT("{0} ends at byte {1}, in the middle of its header."),
                   {std::to_string(bytes_.file_bytes())});
    }
    return error("dicom-length", GLISSON_TEXT("{0} is damaged: the length at byte {1} leaves what encloses it."),
                 {std::to_string(bytes_.offset(at_))});
  }
  const bool is_sequence = explicit_vr
                               ? element.is("SQ")
                               : may_be_sequence(element.tag, element.length >= 8 ? bytes_.view(value, 8) : nullptr,
                                                 element.length, little_endian);
  if (is_sequence) {
    at_ = value;
    return push({true, false, value + element.length, explicit_vr, little_endian});
  }
  if (outermost && element.length > maximum_value_bytes_kept) {
    bytes_.leave_out(at_, value + element.length);
  } else {
    at_ = value + element.length;
  }
  return {};
}

Result<void> Walk::step_in_sequence() {
  const Enclosure sequence = open_.back();
  const std::uint8_t* header = innermost_end() - at_ >= 8 ? bytes_.view(at_, 8) : nullptr;
  if (header == nullptr) {
    return error("dicom-truncated", GLISSON_TEXT("{0} ends at byte {1}, in the middle of a sequence."),
                 {std::to_string(bytes_.file_bytes())});
  }
  const std::uint32_t tag = tag_at(header, sequence.little_endian);
  const std::uint32_t length = number32(header + 4, sequence.little_endian);
  at_ += 8;
  if (tag == sequence_end_tag && sequence.ends_with_delimiter) {
    open_.pop_back();
    return {};
  }
  if (tag != item_tag) {
    return error("dicom-damaged",
                 GLISSON_TEXT("{0} is damaged: a sequence holds something else than items at byte {1}."),
                 {std::to_string(bytes_.offset(at_ - 8))});
  }
  if (length == undefined_length) {
    return push({false, true, sequence.end, sequence.explicit_vr, sequence.little_endian});
  }
  if (length > sequence.end - at_) {
    return error("dicom-length", GLISSON_TEXT("{0} is damaged: the length at byte {1} leaves what encloses it."),
                 {std::to_string(bytes_.offset(at_ - 8))});
  }
  return push({false, false, at_ + length, sequence.explicit_vr, sequence.little_endian});
}

Result<void> Walk::locate_pixels(const Element& element) {
  PixelElement pixels;
  pixels.element = static_cast<std::uint16_t>(element.tag & 0xFFFFu);
  pixels.is_byte_string = element.is("OB");
  const std::uint64_t value = at_ + element.header_bytes;
  const bool in_fragments = element.length == undefined_length;
  if (in_fragments != found_.syntax.encapsulated) {
    return error("dicom-damaged",
                 GLISSON_TEXT("{0} is damaged: its pixels are not stored in the way its transfer syntax {1} says."),
                 {found_.syntax.uid});
  }
  found_.pixels = pixels;
  if (in_fragments) {
    const std::uint64_t data_set_end = at_;
    at_ = value;
    const Result<void> located = locate_fragments();
    at_ = data_set_end;
    return located;
  }
  found_.pixels->native = {bytes_.offset(value), element.length};
  if (element.length > bytes_.end() - value) {
    return error("dicom-truncated", GLISSON_TEXT("{0} is cut short: {1} of {2} bytes of its pixels are there."),
                 {std::to_string(bytes_.end() - value), std::to_string(element.length)});
  }
  return {};
}

// PS3.5 A.4: a table of offsets (which may be empty), then the fragments, then a delimiter.
Result<void> Walk::locate_fragments() {
  bool table_seen = false;
  while (at_ != bytes_.end()) {
    const std::uint8_t* header = bytes_.view_far(at_, 8);
    if (header == nullptr) break;
    const std::uint32_t tag = tag_at(header, true);
    const std::uint64_t length = number32(header + 4, true);
    if (tag == sequence_end_tag) return {};
    if (tag != item_tag) {
      return error("dicom-damaged", GLISSON_TEXT("{0} is damaged: its compressed pixels are broken at byte {1}."),
                   {std::to_string(bytes_.offset(at_))});
    }
    at_ += 8;
    if (length > bytes_.end() - at_) break;
    if (++elements_ > maximum_elements) {
      return error("dicom-header-too-large", GLISSON_TEXT("The pixels of {0} are in too many pieces."));
    }
    if (table_seen) {
      found_.pixels->fragments.push_back({bytes_.offset(at_), length});
    } else if (length <= maximum_dicom_header_bytes) {
      for (std::uint64_t i = 0; i + 4 <= length; i += 4) {
        const std::uint8_t* entry = bytes_.view_far(at_ + i, 4);
        if (entry == nullptr) break;
        found_.pixels->first_byte_of_frame.push_back(number32(entry, true));
      }
    }
    table_seen = true;
    at_ += length;
  }
  // Some writers forget the delimiter; that alone loses nothing.
  if (table_seen && at_ == bytes_.end() && !found_.pixels->fragments.empty()) return {};
  return error("dicom-truncated", GLISSON_TEXT("{0} is cut short in its compressed pixels, at byte {1}."),
               {std::to_string(bytes_.file_bytes())});
}

Result<Element> Walk::element_here(bool explicit_vr, bool little_endian) const {
  const std::uint64_t room = innermost_end() - at_;
  const std::uint8_t* p = room >= 8 ? bytes_.view(at_, 8) : nullptr;
  const auto cut = [&] {
    return error("dicom-truncated", GLISSON_TEXT("{0} ends at byte {1}, in the middle of its header."),
                 {std::to_string(bytes_.file_bytes())});
  };
  if (p == nullptr) return cut();
  Element element;
  element.tag = tag_at(p, little_endian);
  if (!explicit_vr || element.tag >> 16 == 0xFFFEu) {
    element.length = number32(p + 4, little_endian);
    return element;
  }
  element.vr = {static_cast<char>(p[4]), static_cast<char>(p[5])};
  if (is_one_of(element.vr, short_vrs)) {
    element.length = number16(p + 6, little_endian);
    return element;
  }
  if (!is_one_of(element.vr, long_vrs)) {
    return error("dicom-damaged", GLISSON_TEXT("{0} is damaged: no value type is known for what stands at byte {1}."),
                 {std::to_string(bytes_.offset(at_))});
  }
  p = room >= 12 ? bytes_.view(at_, 12) : nullptr;
  if (p == nullptr) return cut();
  element.length = number32(p + 8, little_endian);
  element.header_bytes = 12;
  return element;
}

Result<void> Walk::push(Enclosure enclosure) {
  // A sequence and its item are two enclosures.
  if (open_.size() >= 2 * deepest_nesting) {
    return error("dicom-nesting", GLISSON_TEXT("{0} nests its sequences more than {1} deep, which no image does."),
                 {std::to_string(deepest_nesting)});
  }
  open_.push_back(enclosure);
  return {};
}

void Walk::leave_finished_enclosures() {
  while (!open_.empty() && !open_.back().ends_with_delimiter && at_ >= open_.back().end) open_.pop_back();
}

Failure Walk::error(const char* code, std::string text, std::vector<std::string> more) const {
  std::vector<std::string> arguments{bytes_.file().string()};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return failure(Error{code, std::move(text), std::move(arguments),
                       GLISSON_TEXT("Copy the file again from where it came."), bytes_.file()});
}

}  // namespace
}  // namespace glisson::imaging
