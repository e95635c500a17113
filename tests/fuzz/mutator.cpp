#include "fuzz/mutator.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace glisson::fuzz {
namespace {

constexpr std::array<std::uint32_t, 13> awkward_counts = {
    0, 1, 2, 0x7F, 0x80, 0xFF, 0x7FFF, 0x8000, 0xFFFF, 0x7FFFFFFF, 0x80000000, 0xFFFFFFFE, 0xFFFFFFFF};
constexpr std::array<const char*, 20> awkward_numbers = {"-1",
                                                         "0",
                                                         "1",
                                                         "-0.0",
                                                         "1e308",
                                                         "-1e308",
                                                         "1e-320",
                                                         "nan",
                                                         "inf",
                                                         "-inf",
                                                         "2147483647",
                                                         "2147483648",
                                                         "65536",
                                                         "1e999",
                                                         "1e19",
                                                         "18446744073709551615",
                                                         "99999999999999999999999",
                                                         "",
                                                         "0x10",
                                                         "1,5"};

bool is_text(char c) { return (c >= ' ' && c <= '~') || c == '\n' || c == '\r' || c == '\t'; }
bool is_of_number(char c) { return (c >= '0' && c <= '9') || c == '.' || c == '-' || c == '+' || c == 'e' || c == 'E'; }
bool is_of_word(char c) { return is_of_number(c) || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }

class Breaker {
 public:
  Breaker(const std::vector<std::string>& good, unsigned number)
      : good_(good), bytes_(good[number % good.size()]), random_(number + 1) {
    random_.discard(3);  // the first numbers of neighbouring seeds are alike
  }

  std::string broken() {
    const std::size_t times = 1 + below(4);
    for (std::size_t n = 0; n < times && !bytes_.empty(); ++n) {
      const std::size_t at = place();
      if (in_text(at) && below(4) > 0) {
        break_text(at);
      } else {
        break_bytes(at);
      }
    }
    return std::move(bytes_);
  }

 private:
  std::size_t below(std::size_t limit) { return random_() % limit; }
  // Half of the time in the first 512 bytes, where headers are.
  std::size_t place() { return below(below(2) == 0 ? std::min<std::size_t>(bytes_.size(), 512) : bytes_.size()); }

  [[nodiscard]] bool in_text(std::size_t at) const {
    const std::size_t from = at < 8 ? 0 : at - 8, to = std::min(bytes_.size(), at + 8);
    return std::all_of(bytes_.begin() + std::ptrdiff_t(from), bytes_.begin() + std::ptrdiff_t(to), is_text);
  }

  void break_bytes(std::size_t at) {
    const std::uint32_t number = awkward_counts[below(awkward_counts.size())];
    switch (below(9)) {
      case 0: bytes_[at] = static_cast<char>(bytes_[at] ^ (1 << below(8))); break;
      case 1: bytes_[at] = static_cast<char>(random_()); break;
      case 2: overwrite(at, number, 2); break;
      case 3: overwrite(at, number, 4); break;
      case 4: overwrite(at, number, 4, false); break;
      case 5: bytes_.resize(at); break;
      case 6: bytes_.erase(at, 1 + below(16)); break;
      case 7: insert_part_of(bytes_, at, 32); break;
      default: insert_part_of(good_[below(good_.size())], at, 256); break;
    }
  }
  void overwrite(std::size_t at, std::uint32_t number, std::size_t count, bool little_endian = true) {
    for (std::size_t i = 0; i < count && at + i < bytes_.size(); ++i) {
      bytes_[at + i] = static_cast<char>(number >> 8 * (little_endian ? i : count - 1 - i));
    }
  }
  void insert_part_of(const std::string& from, std::size_t at, std::size_t longest) {
    if (!from.empty()) bytes_.insert(at, from.substr(below(from.size()), 1 + below(longest)));
  }

  void break_text(std::size_t at) {
    switch (below(10)) {
      case 0:
      case 1: replace_token(at, is_of_number, awkward_numbers[below(awkward_numbers.size())]); break;
      case 2: change_digit(at); break;
      case 3: replace_token(at, is_of_word, token_from(place(), is_of_word)); break;
      case 4: erase_line(at); break;
      case 5: repeat_line(at); break;
      case 6: swap_lines(at, place()); break;
      case 7: change_punctuation(at); break;
      case 8: bytes_.insert(at, std::string(std::size_t{1} << below(16), bytes_[at])); break;
      default: bytes_.insert(at, std::string(1, "\0\xff\xc3\r\n\t\"\\{["[below(10)])); break;
    }
  }

  // The token at or behind a place, as [begin, end).
  std::pair<std::size_t, std::size_t> token_at(std::size_t at, bool (*of_token)(char)) const {
    std::size_t begin = at;
    while (begin < bytes_.size() && !of_token(bytes_[begin])) ++begin;
    std::size_t end = begin;
    while (end < bytes_.size() && of_token(bytes_[end])) ++end;
    return {begin, end};
  }
  std::string token_from(std::size_t at, bool (*of_token)(char)) const {
    const auto [begin, end] = token_at(at, of_token);
    return bytes_.substr(begin, end - begin);
  }
  void replace_token(std::size_t at, bool (*of_token)(char), const std::string& with) {
    const auto [begin, end] = token_at(at, of_token);
    bytes_.replace(begin, end - begin, with);
  }
  // A digit of a written number becomes another, a sign or an exponent.
  void change_digit(std::size_t from) {
    const std::size_t digit = bytes_.find_first_of("0123456789", from);
    if (digit != std::string::npos) bytes_[digit] = "0123456789-.eE"[below(14)];
  }
  void change_punctuation(std::size_t from) {
    const std::size_t mark = bytes_.find_first_of("{}[]()<>\"',;:=/ \n", from);
    if (mark == std::string::npos) return;
    if (below(2) == 0) {
      bytes_.erase(mark, 1);
    } else {
      bytes_[mark] = "{}[]()<>\"',;:=/ \n"[below(17)];
    }
  }

  // The line around a place with its end, as [begin, end).
  [[nodiscard]] std::pair<std::size_t, std::size_t> line_at(std::size_t at) const {
    const std::size_t before = at == 0 ? std::string::npos : bytes_.rfind('\n', at - 1);
    const std::size_t behind = bytes_.find('\n', at);
    return {before == std::string::npos ? 0 : before + 1, behind == std::string::npos ? bytes_.size() : behind + 1};
  }
  void erase_line(std::size_t at) {
    const auto [begin, end] = line_at(at);
    bytes_.erase(begin, end - begin);
  }
  void repeat_line(std::size_t at) {
    const auto [begin, end] = line_at(at);
    const std::string line = bytes_.substr(begin, std::min<std::size_t>(end - begin, 4096));
    for (std::size_t times = 1 + below(4); times > 0; --times) bytes_.insert(begin, line);
  }
  void swap_lines(std::size_t a, std::size_t b) {
    const auto [a_begin, a_end] = line_at(std::min(a, b));
    const auto [b_begin, b_end] = line_at(std::max(a, b));
    if (a_end > b_begin) return;
    const std::string first = bytes_.substr(a_begin, a_end - a_begin);
    bytes_.replace(b_begin, b_end - b_begin, first);
    bytes_.erase(a_begin, a_end - a_begin);
  }

  const std::vector<std::string>& good_;
  std::string bytes_;
  std::minstd_rand random_;
};

}  // namespace

std::string broken(const std::vector<std::string>& good, unsigned number) { return Breaker(good, number).broken(); }

}  // namespace glisson::fuzz
