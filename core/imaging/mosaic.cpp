// The layout of the CSA header and the shift of the first tile are as nibabel documents them ("Siemens format DICOM
// with CSA header", "DICOM mosaic"). They were checked here against real mosaics.

#include "imaging/mosaic.h"

#include <cmath>
#include <cstring>
#include <Eigen/Geometry>

#include "base/text.h"
#include "imaging/internal/dicom_fields.h"

namespace glisson::imaging {
namespace {

constexpr int maximum_tiles = 4096;

// Reads little-endian numbers from a text, and says nothing rather than reading behind its end.
class Cursor {
 public:
  explicit Cursor(std::string_view text) : text_(text) {}
  std::optional<std::string_view> take(std::size_t count) {
    if (count > text_.size()) return std::nullopt;
    const std::string_view taken = text_.substr(0, count);
    text_.remove_prefix(count);
    return taken;
  }
  std::optional<std::uint32_t> take_number() {
    const auto bytes = take(4);
    if (!bytes) return std::nullopt;
    std::uint32_t number = 0;
    for (int i = 3; i >= 0; --i)
      number = number << 8 | static_cast<unsigned char>((*bytes)[static_cast<std::size_t>(i)]);
    return number;
  }

 private:
  std::string_view text_;
};

std::string_view up_to_zero(std::string_view text) { return text.substr(0, text.find('\0')); }

std::optional<double> number_in(std::string_view text) {
  text = up_to_zero(text);
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  return read_leading_number(text);
}

// The values of one element of the CSA header; nothing when the header ends early.
std::optional<std::vector<double>> take_csa_values(Cursor& cursor, std::uint32_t items) {
  std::vector<double> values;
  for (std::uint32_t i = 0; i < items; ++i) {
    const auto lengths = cursor.take(16);
    if (!lengths) return std::nullopt;
    const std::uint32_t length = *Cursor(lengths->substr(4)).take_number();
    const auto value = cursor.take(length);
    if (!value || !cursor.take((4 - length % 4) % 4)) return std::nullopt;
    if (const auto number = number_in(*value)) values.push_back(*number);
  }
  return values;
}

std::optional<MosaicFacts> counted_tiles(DcmItem& data_set) {
  if (const auto csa = private_key(data_set, 0x0029, "SIEMENS CSA HEADER", 0x10)) {
    if (const auto facts = mosaic_facts_in_csa_header(private_bytes(data_set, *csa))) return facts;
  }
  const auto count = private_key(data_set, 0x0019, "SIEMENS MR HEADER", 0x0a);
  if (!count) return std::nullopt;
  MosaicFacts facts;
  facts.tiles = whole_number_of(data_set, *count, 0);
  if (facts.tiles < 1 || facts.tiles > maximum_tiles) return std::nullopt;
  return facts;
}

}  // namespace

std::optional<MosaicFacts> mosaic_facts(DcmItem& data_set) {
  std::optional<MosaicFacts> facts = counted_tiles(data_set);
  const auto times = private_key(data_set, 0x0019, "SIEMENS MR HEADER", 0x29);
  if (!facts || !times) return facts;
  const std::vector<double> times_ms = numbers_of(data_set, *times);
  if (times_ms.size() == static_cast<std::size_t>(facts->tiles)) facts->times_ms = times_ms;
  return facts;
}

std::optional<MosaicFacts> mosaic_facts_in_csa_header(std::string_view csa_header) {
  Cursor cursor(csa_header);
  if (csa_header.substr(0, 4) != "SV10" || !cursor.take(8)) return std::nullopt;
  const auto elements = cursor.take_number();
  if (!elements || *elements > 1000 || !cursor.take(4)) return std::nullopt;
  MosaicFacts facts;
  for (std::uint32_t e = 0; e < *elements; ++e) {
    const auto name = cursor.take(64);
    const auto type = cursor.take(12);  // multiplicity, value representation, syngo type
    const auto items = type ? cursor.take_number() : std::nullopt;
    if (!name || !items || !cursor.take(4)) break;
    const auto values = take_csa_values(cursor, *items);
    if (!values) break;
    if (up_to_zero(*name) == "NumberOfImagesInMosaic" && !values->empty() && values->front() >= 1 &&
        values->front() <= maximum_tiles) {
      facts.tiles = static_cast<int>(values->front());
    }
    if (up_to_zero(*name) == "SliceNormalVector" && values->size() == 3) {
      facts.normal = Eigen::Vector3d((*values)[0], (*values)[1], (*values)[2]);
    }
  }
  if (facts.tiles == 0) return std::nullopt;
  return facts;
}

std::optional<std::vector<Picture>> unpack_mosaic(const Picture& mosaic, const MosaicFacts& facts,
                                                  double slice_spacing_mm) {
  const int across = static_cast<int>(std::ceil(std::sqrt(static_cast<double>(facts.tiles)) - 1e-9));
  if (across < 1 || mosaic.columns % across != 0 || mosaic.rows % across != 0) return std::nullopt;

  Picture tile = mosaic;
  tile.columns = mosaic.columns / across;
  tile.rows = mosaic.rows / across;
  const Eigen::Vector3d inwards =
      mosaic.along_row * (mosaic.column_spacing_mm * (mosaic.columns - tile.columns) / 2.0) +
      mosaic.along_column * (mosaic.row_spacing_mm * (mosaic.rows - tile.rows) / 2.0);
  Eigen::Vector3d normal = mosaic.along_row.cross(mosaic.along_column);
  if (facts.normal && facts.normal->dot(normal) < 0) normal = -normal;

  std::vector<Picture> tiles;
  for (int k = 0; k < facts.tiles; ++k) {
    tile.left = k % across * tile.columns;
    tile.top = k / across * tile.rows;
    if (!facts.times_ms.empty()) tile.time_in_volume_ms = facts.times_ms[static_cast<std::size_t>(k)];
    tile.position_mm = mosaic.position_mm + inwards + normal * (slice_spacing_mm * k);
    tiles.push_back(tile);
  }
  return tiles;
}

}  // namespace glisson::imaging
