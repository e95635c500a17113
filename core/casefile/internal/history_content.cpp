#include "casefile/internal/history_content.h"

#include <limits>
#include <system_error>

#include "base/files.h"
#include "base/write_file.h"
#include "imaging/volume_file.h"
#include "segmentation/mask_difference.h"

namespace glisson::casefile {
namespace fs = std::filesystem;
namespace {

using imaging::SegmentedMask;

Result<std::optional<SegmentedMask>> read_side(const std::optional<Entry>& entry, const fs::path& file);
Result<bool> comes_out_the_same(const SegmentedMask& mask, const Entry& entry, const fs::path& beside);
Json json_of_side(const SegmentedMask& side, const Entry& entry);
Json json_of_grid(const imaging::Grid& grid);
Result<imaging::Mask> empty_mask_on(const Json& grid);

imaging::Mask empty_mask(const imaging::Grid& grid) { return {grid, std::vector<std::uint8_t>(grid.voxels())}; }

}  // namespace

fs::path KeptFiles::place_of(const Entry& entry) const {
  return folder_ / (entry.sha256 + entry.file.extension().string());
}

Result<void> KeptFiles::keep(const fs::path& case_folder, const Entry& entry) const {
  const fs::path place = place_of(entry);
  std::error_code problem;
  if (fs::exists(place, problem)) return {};
  fs::create_directories(folder_, problem);
  fs::create_hard_link(case_folder / entry.file, place, problem);
  if (!problem) return {};
  return write_copy(case_folder / entry.file, place);
}

bool is_whole_file(const Json& content) { return content.at("kind") == "file"; }

Result<Json> difference_of(const fs::path& case_folder, const KeptFiles& kept, const Sides& sides,
                           const fs::path& runs_file) {
  const Json whole{{"kind", "file"}};
  const Entry& any = sides.before ? *sides.before : *sides.after;
  if (sides.before && sides.after && sides.before->sha256 == sides.after->sha256) return Json{{"kind", "same"}};
  if (!any.id.starts_with("labels/") || any.file.extension() != ".nrrd") return whole;
  const auto before = read_side(sides.before, sides.before ? kept.place_of(*sides.before) : fs::path());
  const auto after = read_side(sides.after, case_folder / any.file);
  // What cannot be read as a label, or is not as we write it (another program's), is kept whole.
  if (!before || !after) return whole;
  if (*before && *after && !imaging::same_grid((*before)->mask.grid, (*after)->mask.grid, 0)) return whole;
  for (const auto& [side, entry] : {std::pair(&*before, &sides.before), std::pair(&*after, &sides.after)}) {
    if (!*side) continue;
    const auto same = comes_out_the_same(**side, **entry, runs_file.parent_path());
    if (!same) return failure(same.error());
    if (!*same) return whole;
  }
  const imaging::Grid& grid = *before ? (*before)->mask.grid : (*after)->mask.grid;
  const auto runs = segmentation::difference(*before ? (*before)->mask : empty_mask(grid),
                                             *after ? (*after)->mask : empty_mask(grid));
  if (auto written = write_text_file(runs_file, segmentation::to_bytes(runs)); !written)
    return failure(written.error());
  Json content{{"kind", "runs"}, {"grid", json_of_grid(grid)}};
  if (*before) content["before"] = json_of_side(**before, *sides.before);
  if (*after) content["after"] = json_of_side(**after, *sides.after);
  return content;
}

Result<void> write_other_side(const fs::path& case_folder, const KeptFiles& kept, const Json& content,
                              const std::optional<Entry>& from, const Entry& to, const fs::path& runs_file,
                              const fs::path& target) {
  if (content.at("kind") != "runs") {
    const fs::path source = content.at("kind") == "same" ? case_folder / to.file : kept.place_of(to);
    return write_copy(source, target);
  }
  const auto now = read_side(from, from ? case_folder / from->file : fs::path());
  if (!now) return failure(now.error());
  auto start = *now ? Result<imaging::Mask>((*now)->mask) : empty_mask_on(content.at("grid"));
  if (!start) return failure(start.error());
  imaging::Mask& mask = *start;
  const auto bytes = read_text_file(runs_file);
  if (!bytes) return failure(bytes.error());
  const auto runs = segmentation::difference_from_bytes(*bytes, mask.values.size());
  if (!runs) return failure(runs.error());
  segmentation::turn(mask, *runs);
  // Which side it is: the one that is written with the name and colour it had there.
  for (const char* side : {"before", "after"}) {
    if (!content.contains(side) || content.at(side).at("sha256") != to.sha256) continue;
    const Json& info = content.at(side);
    return imaging::write_mask_file(target, mask,
                                    {info.at("name").get<std::string>(), info.at("value").get<int>(),
                                     info.at("color").get<std::array<double, 3>>()});
  }
  return failure("history-damaged", GLISSON_TEXT("A stored step of the history does not fit its case."));
}

namespace {

Result<std::optional<SegmentedMask>> read_side(const std::optional<Entry>& entry, const fs::path& file) {
  if (!entry) return std::optional<SegmentedMask>();
  return imaging::read_mask_file(file).map([](SegmentedMask read) {
    for (std::uint8_t& value : read.mask.values) value = value != 0 ? 1 : 0;
    return std::optional(std::move(read));
  });
}

// A label that this program wrote comes out the same, byte for byte, when it is written again.
Result<bool> comes_out_the_same(const SegmentedMask& mask, const Entry& entry, const fs::path& beside) {
  const fs::path trial = beside / ".trial.nrrd";
  std::error_code ignored;
  fs::create_directories(beside, ignored);
  if (auto written = imaging::write_mask_file(trial, mask.mask, mask.info); !written) return failure(written.error());
  auto content = sha256_of_file(trial);
  fs::remove(trial, ignored);
  return content.map([&](const std::string& sha256) { return sha256 == entry.sha256; });
}

Json json_of_side(const SegmentedMask& side, const Entry& entry) {
  return Json{{"sha256", entry.sha256},
              {"name", side.info.name},
              {"value", side.info.label_value},
              {"color", side.info.color_rgb}};
}

Json json_of_grid(const imaging::Grid& grid) {
  Json direction = Json::array();
  for (Eigen::Index column = 0; column < 3; ++column) direction.push_back(json_of(grid.direction.col(column)));
  return Json{{"size", grid.size},
              {"spacing_mm", json_of(grid.spacing_mm)},
              {"origin_mm", json_of(grid.origin_mm)},
              {"axes", direction}};
}

// The case may come from anywhere: its sizes are judged before memory is asked for.
Result<imaging::Mask> empty_mask_on(const Json& json) {
  imaging::Grid grid;
  grid.size = json.at("size").get<std::array<int, 3>>();
  std::uint64_t voxels = 1;
  for (const int size : grid.size) voxels = size > 0 && size <= 65535 ? voxels * static_cast<std::uint64_t>(size) : 0;
  if (voxels == 0 || voxels > std::numeric_limits<std::uint32_t>::max()) {
    return failure("history-damaged", GLISSON_TEXT("A stored step of the history does not fit its case."));
  }
  for (Eigen::Index k = 0; k < 3; ++k) {
    const auto n = static_cast<std::size_t>(k);
    grid.spacing_mm[k] = json.at("spacing_mm").at(n).get<double>();
    grid.origin_mm[k] = json.at("origin_mm").at(n).get<double>();
    for (Eigen::Index row = 0; row < 3; ++row) {
      grid.direction(row, k) = json.at("axes").at(n).at(static_cast<std::size_t>(row)).get<double>();
    }
  }
  return empty_mask(grid);
}

}  // namespace
}  // namespace glisson::casefile
