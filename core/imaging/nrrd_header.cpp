// NRRD (https://teem.sourceforge.net/nrrd/format.html): a magic line, "field: value" and "key:=value" lines, an empty
// line.

#include <cmath>

#include "base/text.h"
#include "imaging/internal/volume_header.h"

namespace glisson::imaging {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t maximum_nrrd_bytes = 1 << 20;

struct NrrdLines {
  std::map<std::string, std::string> fields;  // names in lower case without blanks ("spaceorigin")
  std::map<std::string, std::string> notes;
  std::size_t end = 0;  // the byte after the empty line
};

// "\n" and "\\" stand for a new line and a backslash in keys and values.
std::string unescaped(std::string_view text) {
  std::string plain;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool escape = text[i] == '\\' && i + 1 < text.size() && (text[i + 1] == 'n' || text[i + 1] == '\\');
    plain += escape ? (text[++i] == 'n' ? '\n' : '\\') : text[i];
  }
  return plain;
}

std::optional<NrrdLines> nrrd_lines(const std::string& text) {
  if (!text.starts_with("NRRD000") || text.size() < 9) return std::nullopt;
  NrrdLines lines;
  for (std::size_t begin = text.find('\n'); begin != std::string::npos && begin + 1 <= text.size();) {
    ++begin;
    const std::size_t end = text.find('\n', begin);
    std::string_view line = std::string_view(text).substr(begin, end - begin);
    if (line.ends_with('\r')) line.remove_suffix(1);
    lines.end = end == std::string::npos ? text.size() : end + 1;
    if (line.empty()) return lines;
    begin = end;
    if (line.front() == '#') continue;
    const std::size_t colon = line.find(':');
    if (colon == std::string_view::npos) return std::nullopt;
    if (const std::size_t note = line.find(":="); note != std::string_view::npos && note == colon) {
      lines.notes[unescaped(line.substr(0, note))] = unescaped(line.substr(note + 2));
      continue;
    }
    std::string name = in_lower_case(line.substr(0, colon));
    std::erase(name, ' ');
    lines.fields[name] = without_blanks(line.substr(colon + 1));
  }
  return lines;  // the header of a detached file may end with the file
}

std::optional<VoxelType> type_of(const std::string& name) {
  struct Named {
    VoxelType type;
    std::string_view names;  // each between blanks
  };
  static constexpr Named known[] = {
      {VoxelType::int8, " signed_char int8 int8_t "},
      {VoxelType::uint8, " uchar unsigned_char uint8 uint8_t "},
      {VoxelType::int16, " short short_int signed_short signed_short_int int16 int16_t "},
      {VoxelType::uint16, " ushort unsigned_short unsigned_short_int uint16 uint16_t "},
      {VoxelType::int32, " int signed_int int32 int32_t "},
      {VoxelType::uint32, " uint unsigned_int uint32 uint32_t "},
      {VoxelType::int64, " longlong long_long long_long_int signed_long_long signed_long_long_int int64 int64_t "},
      {VoxelType::uint64, " ulonglong unsigned_long_long unsigned_long_long_int uint64 uint64_t "},
      {VoxelType::float32, " float "},
      {VoxelType::float64, " double "}};
  std::string word = " " + in_lower_case(name) + " ";
  for (std::size_t i = 1; i + 1 < word.size(); ++i) word[i] = word[i] == ' ' ? '_' : word[i];
  for (const Named& one : known) {
    if (one.names.find(word) != std::string_view::npos) return one.type;
  }
  return std::nullopt;
}

// "(1,0,0) none (0,1,0)": a vector for each axis, nothing for one that does not run through space.
using Directions = std::vector<std::optional<Eigen::Vector3d>>;
std::optional<Directions> directions_in(std::string_view text) {
  Directions directions;
  for (std::string_view rest = without_blanks(text); !rest.empty(); rest = without_blanks(rest)) {
    if (rest.starts_with("none")) {
      directions.push_back(std::nullopt);
      rest.remove_prefix(4);
      continue;
    }
    const std::size_t close = rest.find(')');
    if (rest.front() != '(' || close == std::string_view::npos) return std::nullopt;
    std::string inside(rest.substr(1, close - 1));
    for (char& c : inside) c = c == ',' ? ' ' : c;
    const auto numbers = numbers_in(inside);
    if (!numbers || numbers->size() < 3) return std::nullopt;
    directions.push_back(Eigen::Vector3d(numbers->data()));
    rest.remove_prefix(close + 1);
  }
  return directions;
}

// Kinds of axes along which a voxel's components lie.
bool is_range_kind(const std::string& kind) {
  for (const char* part : {"color", "vector", "list", "complex", "matrix", "point", "normal", "gradient", "quaternion",
                           "scalar", "stub"}) {
    if (in_lower_case(kind).find(part) != std::string::npos) return true;
  }
  return false;
}

std::vector<std::string> words_in(const std::string& text) {
  std::vector<std::string> words;
  for (std::string_view rest = without_blanks(text); !rest.empty(); rest = without_blanks(rest)) {
    const std::size_t end = std::min(rest.find_first_of(" \t"), rest.size());
    words.emplace_back(rest.substr(0, end));
    rest.remove_prefix(end);
  }
  return words;
}

// Signs that turn the named space into left, posterior, superior; others are taken as they are.
Eigen::Vector3d to_lps(const std::string& space) {
  const std::string name = in_lower_case(space);
  if (name == "ras" || name.starts_with("right-anterior-superior") || name == "rast") return {-1, -1, 1};
  if (name == "las" || name.starts_with("left-anterior-superior") || name == "last") return {1, -1, 1};
  return {1, 1, 1};
}

class Reader {
 public:
  Reader(const fs::path& file, NrrdLines lines) : file_(file), lines_(std::move(lines)) {}

  Result<FoundHeader> run() {
    if (!take_axes() || !place() || !find_voxels()) {
      return volume_file_unreadable(file_, reason_);
    }
    found_.header.notes = std::move(lines_.notes);
    return std::move(found_);
  }

 private:
  [[nodiscard]] const std::string& field(const char* name) const {
    static const std::string nothing;
    const auto found = lines_.fields.find(name);
    return found == lines_.fields.end() ? nothing : found->second;
  }

  bool take_axes() {
    const auto axes = whole_number_in(field("dimension"));
    const auto sizes = numbers_in(field("sizes"));
    const auto type = type_of(field("type"));
    if (!axes || *axes < 1 || *axes > 16 || !sizes || static_cast<std::int64_t>(sizes->size()) != *axes) return false;
    if (!type) reason_ = GLISSON_TEXT("its numbers are of an unknown type");
    if (!type) return false;
    found_.header.type = *type;
    const auto directions = directions_in(field("spacedirections"));
    if (!directions || (!directions->empty() && directions->size() != sizes->size())) return false;
    const std::vector<std::string> kinds = words_in(field("kinds"));
    for (std::size_t axis = 0; axis < sizes->size(); ++axis) {
      const double size = (*sizes)[axis];
      const auto whole = size >= 1 && size < 1e15 ? static_cast<std::int64_t>(size) : std::int64_t{0};
      const bool in_space =
          directions->empty() ? axis >= kinds.size() || !is_range_kind(kinds[axis]) : (*directions)[axis].has_value();
      if (!in_space) {
        found_.components = whole == 0 ? 0 : std::min<std::int64_t>(found_.components * whole, 1'000'000);
        continue;
      }
      axes_.push_back(axis);
      found_.sizes.push_back(whole);
      if (!directions->empty()) directions_.push_back(*(*directions)[axis]);
    }
    return true;
  }

  bool place() {
    Grid& grid = found_.header.grid;
    if (found_.sizes.size() < 3) return true;  // refused as it is
    const Eigen::Vector3d signs = to_lps(field("space"));
    if (directions_.empty()) return place_by_spacings();
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      const Eigen::Vector3d along = directions_[static_cast<std::size_t>(axis)].cwiseProduct(signs);
      grid.spacing_mm[axis] = along.norm();
      grid.direction.col(axis) = along.normalized();
    }
    if (field("spaceorigin").empty()) return true;
    const auto origin = directions_in(field("spaceorigin"));
    if (!origin || origin->size() != 1 || !origin->front()) return false;
    grid.origin_mm = origin->front()->cwiseProduct(signs);
    return true;
  }

  // Without directions: spacings, and the least position along each axis, of a voxel's edge unless it says "node".
  bool place_by_spacings() {
    Grid& grid = found_.header.grid;
    const auto spacings = numbers_in(field("spacings")), minimum = numbers_in(field("axismins"));
    if (!spacings || !minimum) return false;
    const std::vector<std::string> centers = words_in(field(field("centers").empty() ? "centerings" : "centers"));
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      const std::size_t from = axes_[static_cast<std::size_t>(axis)];
      const double spacing = from < spacings->size() ? (*spacings)[from] : 1;
      const double begin = from < minimum->size() ? (*minimum)[from] : std::nan("");
      const bool at_node = from < centers.size() && centers[from] == "node";
      grid.spacing_mm[axis] = std::isnan(spacing) ? 1 : spacing;
      if (!std::isnan(begin)) grid.origin_mm[axis] = begin + (at_node ? 0 : 0.5 * grid.spacing_mm[axis]);
    }
    return true;
  }

  bool find_voxels() {
    VolumeHeader& header = found_.header;
    header.big_endian = in_lower_case(field("endian")) == "big";
    const std::string encoding = in_lower_case(field("encoding"));
    if (encoding == "raw") {
      header.coding = VoxelCoding::raw;
    } else if (encoding == "gzip" || encoding == "gz") {
      header.coding = VoxelCoding::deflated;
    } else if (encoding == "ascii" || encoding == "text" || encoding == "txt") {
      header.coding = VoxelCoding::text;
    } else {
      reason_ = GLISSON_TEXT("its voxels are encoded in a way that is not read");
      return false;
    }
    const std::string data = field(field("datafile").empty() ? "datafiles" : "datafile");
    if (data.starts_with("LIST") || data.find('%') != std::string::npos) {
      reason_ = GLISSON_TEXT("its voxels lie in several files");
      return false;
    }
    header.data = data.empty() ? file_ : file_.parent_path() / data;
    header.begin = data.empty() ? lines_.end : 0;
    return skip();
  }

  // Lines are skipped in the file, bytes in what comes out of it; -1: the voxels are the last of the file.
  bool skip() {
    VolumeHeader& header = found_.header;
    const auto lines = whole_number_in(field("lineskip").empty() ? "0" : field("lineskip"));
    const auto bytes = whole_number_in(field("byteskip").empty() ? "0" : field("byteskip"));
    if (!lines || !bytes || *lines < 0 || *lines > 1'000'000 || *bytes < -1) return false;
    if (*lines > 0) {
      const std::string text = beginning_of(header.data, header.begin + maximum_nrrd_bytes);
      for (std::int64_t n = 0; n < *lines; ++n) {
        const std::size_t end = text.find('\n', header.begin);
        if (end == std::string::npos) return false;
        header.begin = end + 1;
      }
    }
    if (*bytes == -1 && header.coding != VoxelCoding::raw) return false;
    header.at_the_end = *bytes == -1;
    const auto skipped = static_cast<std::uint64_t>(std::max<std::int64_t>(*bytes, 0));
    (header.coding == VoxelCoding::deflated ? header.skipped : header.begin) += skipped;
    return true;
  }

  const fs::path& file_;
  NrrdLines lines_;
  FoundHeader found_;
  std::vector<std::size_t> axes_;  // of those in space, their numbers in the file
  std::vector<Eigen::Vector3d> directions_;
  std::string reason_ = GLISSON_TEXT("its header is not of that format");
};

}  // namespace

Result<FoundHeader> read_nrrd_header(const fs::path& file) {
  auto lines = nrrd_lines(beginning_of(file, maximum_nrrd_bytes));
  if (!lines) return volume_file_unreadable(file, GLISSON_TEXT("its header is not of that format"));
  return Reader(file, std::move(*lines)).run();
}

}  // namespace glisson::imaging
