// MetaImage (.mha, .mhd): lines "Key = Value", the last of which says where the voxels are.

#include <array>
#include <utility>

#include "base/text.h"
#include "imaging/internal/volume_header.h"

namespace glisson::imaging {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t maximum_metaimage_bytes = 1 << 20;

// MetaIO's LONG has four bytes wherever it was written.
constexpr std::array<std::pair<std::string_view, VoxelType>, 14> types{{{"MET_UCHAR", VoxelType::uint8},
                                                                        {"MET_CHAR", VoxelType::int8},
                                                                        {"MET_ASCII_CHAR", VoxelType::int8},
                                                                        {"MET_USHORT", VoxelType::uint16},
                                                                        {"MET_SHORT", VoxelType::int16},
                                                                        {"MET_UINT", VoxelType::uint32},
                                                                        {"MET_INT", VoxelType::int32},
                                                                        {"MET_ULONG", VoxelType::uint32},
                                                                        {"MET_LONG", VoxelType::int32},
                                                                        {"MET_ULONG_LONG", VoxelType::uint64},
                                                                        {"MET_LONG_LONG", VoxelType::int64},
                                                                        {"MET_FLOAT", VoxelType::float32},
                                                                        {"MET_DOUBLE", VoxelType::float64},
                                                                        {"MET_NONE", VoxelType::uint8}}};

struct MetaImageLines {
  std::map<std::string, std::string> values;
  std::size_t end = 0;  // the byte after the last line
};

std::optional<MetaImageLines> metaimage_lines(const std::string& text) {
  MetaImageLines lines;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = text.find('\n', begin);
    const std::string_view line = std::string_view(text).substr(begin, end - begin);
    const std::size_t equals = line.find_first_of("=:");
    if (end == std::string::npos && equals == std::string_view::npos) return std::nullopt;
    begin = end == std::string::npos ? text.size() : end + 1;
    if (without_blanks(line).empty()) continue;
    if (equals == std::string_view::npos) return std::nullopt;
    const std::string key(without_blanks(line.substr(0, equals)));
    lines.values[key] = without_blanks(line.substr(equals + 1));
    if (key != "ElementDataFile") continue;
    lines.end = begin;
    return lines;
  }
  return std::nullopt;
}

class HeaderFields {
 public:
  explicit HeaderFields(std::map<std::string, std::string> values) : values_(std::move(values)) {}

  [[nodiscard]] std::string text(std::initializer_list<const char*> names) const {
    for (const char* name : names) {
      if (const auto found = values_.find(name); found != values_.end()) return found->second;
    }
    return {};
  }
  [[nodiscard]] bool is_true(std::initializer_list<const char*> names) const {
    const std::string value = text(names);
    return !value.empty() && (value[0] == 'T' || value[0] == 't' || value[0] == '1');
  }
  // As many numbers as asked for; `otherwise` where the field is not there; nothing where it holds something else.
  [[nodiscard]] std::optional<std::vector<double>> numbers(std::initializer_list<const char*> names, std::size_t count,
                                                           const std::vector<double>& otherwise) const {
    const std::string value = text(names);
    if (value.empty()) return otherwise;
    const auto found = numbers_in(value);
    if (!found || found->size() != count) return std::nullopt;
    return found;
  }
  [[nodiscard]] std::int64_t whole_number(const char* name, std::int64_t otherwise, bool& good) const {
    const std::string value = text({name});
    if (value.empty()) return otherwise;
    const auto number = whole_number_in(value);
    good = good && number;
    return number.value_or(otherwise);
  }

 private:
  std::map<std::string, std::string> values_;
};

bool place(Grid& grid, const HeaderFields& fields, std::size_t axes) {
  std::vector<double> identity(axes * axes, 0);
  for (std::size_t axis = 0; axis < axes; ++axis) identity[axis * axes + axis] = 1;
  const auto sizes = fields.numbers({"ElementSize"}, axes, std::vector<double>(axes, 1));
  const auto spacing = fields.numbers({"ElementSpacing"}, axes, sizes.value_or(std::vector<double>(axes, 1)));
  const auto origin = fields.numbers({"Offset", "Position", "Origin"}, axes, std::vector<double>(axes, 0));
  const auto matrix = fields.numbers({"TransformMatrix", "Rotation", "Orientation"}, axes * axes, identity);
  if (!spacing || !origin || !matrix) return false;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto column = static_cast<Eigen::Index>(axis);
    grid.spacing_mm[column] = (*spacing)[axis];
    grid.origin_mm[column] = (*origin)[axis];
    for (std::size_t row = 0; row < 3; ++row) {
      grid.direction(static_cast<Eigen::Index>(row), column) = (*matrix)[axis * axes + row];
    }
  }
  return true;
}

}  // namespace

Result<FoundHeader> read_metaimage_header(const fs::path& file) {
  const auto not_of_that_format = [&] {
    return volume_file_unreadable(file, GLISSON_TEXT("its header is not of that format"));
  };
  auto lines = metaimage_lines(beginning_of(file, maximum_metaimage_bytes));
  if (!lines) return not_of_that_format();
  const HeaderFields fields(lines->values);
  bool good = true;
  const std::int64_t axes = fields.whole_number("NDims", 0, good);
  if (!good || axes < 1 || axes > 10) return not_of_that_format();
  FoundHeader found;
  const auto sizes = numbers_in(fields.text({"DimSize"}));
  if (!sizes || static_cast<std::int64_t>(sizes->size()) != axes) return not_of_that_format();
  for (const double size : *sizes) {
    found.sizes.push_back(size >= 1 && size < 1e15 ? static_cast<std::int64_t>(size) : std::int64_t{0});
  }
  if (axes < 3) return found;  // refused as it is

  VolumeHeader& header = found.header;
  found.components = fields.whole_number("ElementNumberOfChannels", 1, good);
  const std::string type_name = fields.text({"ElementType"});
  const auto* type =
      std::find_if(types.begin(), types.end(), [&](const auto& known) { return known.first == type_name; });
  if (type == types.end() || type_name == "MET_NONE") {
    return volume_file_unreadable(file, GLISSON_TEXT("its numbers are of an unknown type"));
  }
  header.type = type->second;
  header.big_endian = fields.is_true({"ElementByteOrderMSB", "BinaryDataByteOrderMSB"});
  if (!place(header.grid, fields, static_cast<std::size_t>(axes))) return not_of_that_format();

  const bool is_text = !fields.text({"BinaryData"}).empty() && !fields.is_true({"BinaryData"});
  header.coding = is_text                              ? VoxelCoding::text
                  : fields.is_true({"CompressedData"}) ? VoxelCoding::deflated
                                                       : VoxelCoding::raw;
  const std::int64_t compressed = fields.whole_number("CompressedDataSize", 0, good);
  const std::int64_t before = fields.whole_number("HeaderSize", 0, good);
  if (!good || compressed < 0 || before < -1) return not_of_that_format();
  if (compressed > 0) header.in_bytes = static_cast<std::uint64_t>(compressed);
  const std::string data = fields.text({"ElementDataFile"});
  if (data.starts_with("LIST") || data.find('%') != std::string::npos) {
    return volume_file_unreadable(file, GLISSON_TEXT("its voxels lie in several files"));
  }
  const bool local = in_lower_case(data) == "local";
  header.data = local ? file : file.parent_path() / data;
  header.begin = local ? lines->end : 0;
  if (before > 0) header.begin = static_cast<std::uint64_t>(before);
  header.at_the_end = before == -1;
  header.notes = std::move(lines->values);
  return found;
}

}  // namespace glisson::imaging
