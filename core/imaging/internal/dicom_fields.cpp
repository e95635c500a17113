// Values of DICOM elements: numbers read without regard to the locale, text brought to UTF-8.

#include "imaging/internal/dicom_fields.h"

#include <dcmtk/dcmdata/dcistrmb.h>
#include <dcmtk/oflog/oflog.h>
#include <algorithm>
#include <cctype>
#include <cmath>
#include <mutex>

#include "base/text.h"

namespace glisson::imaging {
namespace {

bool is_padding(char c) { return c == ' ' || c == '\0' || c == '\t' || c == '\r' || c == '\n'; }

std::string trimmed(std::string text) {
  while (!text.empty() && is_padding(text.back())) text.pop_back();
  text.erase(text.begin(), std::find_if_not(text.begin(), text.end(), is_padding));
  return text;
}

bool is_utf8(std::string_view text) {
  for (std::size_t i = 0; i < text.size();) {
    const auto lead = static_cast<unsigned char>(text[i]);
    const std::size_t count = lead < 0x80 ? 1 : lead >= 0xC2 && lead < 0xE0 ? 2 : lead >= 0xE0 && lead < 0xF0 ? 3 : 0;
    if (count == 0 || i + count > text.size()) return false;
    for (std::size_t k = 1; k < count; ++k) {
      if ((static_cast<unsigned char>(text[i + k]) & 0xC0u) != 0x80u) return false;
    }
    i += count;
  }
  return true;
}

// Text that is not UTF-8 is taken for Latin 1, the commonest of DICOM's character sets in what we read; control
// characters become blanks.
std::string as_utf8(const std::string& text) {
  const bool already = is_utf8(text);
  std::string converted;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x20 || byte == 0x7F) {
      converted += ' ';
    } else if (already || byte < 0x80) {
      converted += c;
    } else {
      converted += static_cast<char>(0xC0 | byte >> 6);
      converted += static_cast<char>(0x80 | (byte & 0x3F));
    }
  }
  return trimmed(converted);
}

std::optional<double> as_number(const std::string& written) {
  const std::string text = trimmed(written);
  return read_leading_number(std::string_view(text).substr(text.starts_with('+') ? 1 : 0));
}

// More values than any attribute that is read here has.
constexpr unsigned long maximum_values = 64;

}  // namespace

std::unique_ptr<DcmDataset> parse(const CheckedDicom& file) {
  // What is wrong with a file is said in its problems; DCMTK's own warnings would only mingle with the log.
  static std::once_flag quiet;
  std::call_once(quiet, [] { OFLog::configure(OFLogger::OFF_LOG_LEVEL); });
  const E_TransferSyntax syntax = !file.syntax.explicit_vr    ? EXS_LittleEndianImplicit
                                  : file.syntax.little_endian ? EXS_LittleEndianExplicit
                                                              : EXS_BigEndianExplicit;
  auto data_set = std::make_unique<DcmDataset>();
  DcmInputBufferStream stream;
  stream.setBuffer(file.data_set.data(), static_cast<offile_off_t>(file.data_set.size()));
  stream.setEos();
  data_set->transferInit();
  const OFCondition read = data_set->read(stream, syntax, EGL_noChange, DCM_MaxReadLength);
  data_set->transferEnd();
  if (read.bad() && read != EC_EndOfStream) return nullptr;
  return data_set;
}

std::string text_of(DcmItem& item, const DcmTagKey& key) {
  DcmElement* element = nullptr;
  OFString all;
  if (item.findAndGetElement(key, element).bad() || element == nullptr) return {};
  if (element->getOFStringArray(all).bad()) return {};
  return as_utf8(std::string(all.c_str(), all.size()));
}

std::vector<std::string> texts_of(DcmItem& item, const DcmTagKey& key) {
  DcmElement* element = nullptr;
  std::vector<std::string> texts;
  if (item.findAndGetElement(key, element).bad() || element == nullptr) return texts;
  const unsigned long count = std::min(element->getVM(), maximum_values);
  for (unsigned long i = 0; i < count; ++i) {
    OFString text;
    if (element->getOFString(text, i).bad()) break;
    texts.push_back(as_utf8(std::string(text.c_str(), text.size())));
  }
  return texts;
}

std::vector<double> numbers_of(DcmItem& item, const DcmTagKey& key) {
  std::vector<double> numbers;
  for (const std::string& text : texts_of(item, key)) {
    const std::optional<double> number = as_number(text);
    if (!number) return {};
    numbers.push_back(*number);
  }
  return numbers;
}

std::optional<double> number_of(DcmItem& item, const DcmTagKey& key) {
  const std::vector<double> numbers = numbers_of(item, key);
  if (numbers.empty()) return std::nullopt;
  return numbers.front();
}

int whole_number_of(DcmItem& item, const DcmTagKey& key, int otherwise) {
  const std::optional<double> number = number_of(item, key);
  if (!number || std::abs(*number) > 2147483647.0) return otherwise;
  return static_cast<int>(*number);
}

DcmItem* item_of(DcmItem& item, const DcmTagKey& sequence, unsigned n) {
  DcmItem* found = nullptr;
  if (item.findAndGetSequenceItem(sequence, found, static_cast<signed long>(n)).bad()) return nullptr;
  return found;
}

std::optional<DcmTagKey> private_key(DcmItem& item, unsigned group, std::string_view creator, unsigned element) {
  for (unsigned block = 0x10; block <= 0xFF; ++block) {
    const DcmTagKey reservation(static_cast<Uint16>(group), static_cast<Uint16>(block));
    if (!item.tagExists(reservation)) {
      if (block > 0x1F) break;  // blocks are reserved from the bottom up, with few gaps
      continue;
    }
    if (trimmed(private_bytes(item, reservation)) == creator) {
      return DcmTagKey(static_cast<Uint16>(group), static_cast<Uint16>(block << 8 | element));
    }
  }
  return std::nullopt;
}

std::string private_bytes(DcmItem& item, const DcmTagKey& key) {
  DcmElement* element = nullptr;
  if (item.findAndGetElement(key, element).bad() || element == nullptr) return {};
  Uint8* bytes = nullptr;
  if (element->getUint8Array(bytes).good() && bytes != nullptr) {
    return {reinterpret_cast<const char*>(bytes), element->getLength()};
  }
  OFString text;
  if (element->getOFStringArray(text).bad()) return {};
  return {text.c_str(), text.size()};
}

std::string upper_case(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return text;
}

}  // namespace glisson::imaging
