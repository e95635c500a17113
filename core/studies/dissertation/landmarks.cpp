#include "studies/dissertation/landmarks.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <utility>

#include "base/files.h"
#include "base/json.h"
#include "base/units.h"
#include "base/write_file.h"
#include "geometry/surface.h"
#include "imaging/filters.h"
#include "mechanics/meshfree/compliance_distance.h"
#include "rehearsal/comparison.h"
#include "segmentation/resample.h"
#include "studies/dissertation/internal/landmark_columns.h"
#include "studies/dissertation/internal/landmarks_pictures.h"
#include "studies/dissertation/real_livers.h"
#include "studies/dissertation/subjects.h"

namespace glisson::studies {
namespace fs = std::filesystem;
namespace {

using Eigen::Vector3d;
using rehearsal::significant_mm;

constexpr std::size_t most_examples = 4;

// How columns of a group begin, and what a legend calls it.
constexpr std::array<std::pair<const char*, const char*>, 8> landmark_groups{
    {{"landmarks", "landmarks"},
     {"near_tool_landmarks", "near the tool"},
     {"forks", "forks"},
     {"portal_forks", "portal forks"},
     {"hepatic_forks", "hepatic forks"},
     {"wide_forks", "forks of 6 mm"},
     {"narrow_forks", "forks below 6 mm"},
     {"near_tool_forks", "forks at the tool"}}};

std::string fingerprint_of(const LandmarksOptions& options);
mechanics::VoxelBody trusted_tissue(const MeasuredLiver& liver, double poisson_ratio);
Result<NamedNumbers> misplacements_in(const Subject& subject, const LandmarksOptions& options);
void summarise(LandmarksSummary& summary);

}  // namespace

Result<LandmarksSummary> run_landmarks(const fs::path& folder, const fs::path& out, const LandmarksOptions& options,
                                       const Progress& progress) {
  const auto subjects = options.livers_seed ? find_livers(folder, *options.livers_seed) : find_subjects(folder);
  if (!subjects) return failure(subjects.error());
  std::vector<BatchPatient> patients;
  for (const Subject& subject : *subjects) {
    patients.push_back({subject.id, fingerprint_of(options) + " " + studies::fingerprint_of(subject)});
  }
  LandmarksSummary summary;
  auto rows = run_batch(
      out, patients, [&](std::size_t p) { return misplacements_in((*subjects)[p], options); }, options.part,
      progress.part(0, 0.9));
  if (!rows) return failure(rows.error());
  summary.rows = std::move(*rows);
  summarise(summary);
  if (!options.part.is_all()) return summary;
  if (summary.patients == 0) {
    return failure(Error{"landmarks-all-failed",
                         GLISSON_TEXT("None of the {0} patients could be used; the first one: {1}"),
                         {std::to_string(summary.failed), summary.rows.front().error},
                         {},
                         folder});
  }
  progress.report(0.9, GLISSON_TEXT("Drawing typical and extreme patients"));
  const auto pictures = draw_landmarks_pictures(*subjects, out, summary, options);
  if (!pictures) return failure(pictures.error());
  return write_together([&] {
           return write_batch_csv(out / "landmarks.csv", summary.rows, "seconds")
               .and_then([&] { return write_text_file(out / "summary.json", summary_json(summary).dump(2) + "\n"); })
               .and_then([&] {
                 return report::write_html(out / "report.html", landmarks_page(summary, options, *pictures));
               });
         })
      .map([&] { return std::move(summary); });
}

Result<BeamRow> beams_of(const std::string& patient, const MeasuredLiver& liver, double mean_shear_kPa,
                         const LandmarksOptions& options) {
  const double poisson_ratio = options.retraction.poisson_ratio;
  return compare_beams(patient, trusted_tissue(liver, poisson_ratio),
                       units::youngs_from_shear(mean_shear_kPa, poisson_ratio), options.beams);
}

Share share_of(std::size_t patients, std::size_t of_all) {
  GLISSON_ASSERT(of_all > 0 && patients <= of_all);
  constexpr double z = 1.959964;  // of the normal distribution, 95 % within
  const auto n = static_cast<double>(of_all);
  const double p = static_cast<double>(patients) / n;
  const double middle = (p + z * z / (2 * n)) / (1 + z * z / n);
  const double half = z / (1 + z * z / n) * std::sqrt(p * (1 - p) / n + z * z / (4 * n * n));
  return {p, std::max(0.0, middle - half), std::min(1.0, middle + half)};
}

Json summary_json(const LandmarksSummary& summary) {
  const auto json_of = [](const std::vector<LandmarksSpread>& spreads) {
    Json list = Json::array();
    for (const LandmarksSpread& spread : spreads) {
      list.push_back({{"column", spread.column},
                      {"says", spread.says},
                      {"patients", spread.mm.voxels},
                      {"mean_mm", spread.mm.mean},
                      {"sd_mm", spread.mm.sd},
                      {"percentile_5_mm", spread.mm.percentile_5},
                      {"percentile_25_mm", spread.mm.percentile_25},
                      {"median_mm", spread.mm.median},
                      {"percentile_75_mm", spread.mm.percentile_75},
                      {"percentile_95_mm", spread.mm.percentile_95},
                      {"max_mm", spread.mm.max},
                      {"significant_fraction", spread.significant.fraction},
                      {"significant_interval", {spread.significant.low, spread.significant.high}},
                      {"median_and_outer_patients", spread.examples}});
    }
    return list;
  };
  Json document{{"patients", summary.patients},
                {"failed", summary.failed},
                {"significant_mm", significant_mm},
                {"inter_patient", json_of(summary.between)},
                {"intra_organ", json_of(summary.within)},
                {"intra_organ_any_region_significant_fraction", summary.any_region_fraction},
                {"landmark_groups", json_of(summary.groups)},
                {"sensitivity", json_of(summary.sensitivity)},
                {"engines", json_of(summary.engines)},
                {"at_large_strain", summary.at_large_strain},
                {"beyond_linear", summary.beyond_linear},
                {"without_meshfree", summary.without_meshfree}};
  return null_where_not_finite(std::move(document));
}

namespace {

std::string fingerprint_of(const LandmarksOptions& options) {
  const RetractionOptions& r = options.retraction;
  const BeamOptions& b = options.beams;
  return fmt::format("landmarks/2 {:g} {:g} {:g} {} {} {:g} {:g} {} {}{}", r.reference_kPa, r.force_N, r.poisson_ratio,
                     r.target_cells, static_cast<int>(r.law), b.force_N, b.foundation_kPa_per_mm,
                     static_cast<int>(b.engine), b.nodes,
                     r.meshfree ? fmt::format(" meshfree {}", r.meshfree->nodes) : std::string());
}

// The liver as cubes along the patient's axes, without what the map is not to be trusted in: unconfident voxels, and
// the border that StiffnessOptions names.
mechanics::VoxelBody trusted_tissue(const MeasuredLiver& liver, double poisson_ratio) {
  std::vector<Eigen::Vector3d> corners_mm;
  const imaging::Grid& from = liver.organ.grid;
  for (int corner = 0; corner < 8; ++corner) {
    const Eigen::Vector3d index((corner & 1) != 0 ? from.size[0] : -1, (corner & 2) != 0 ? from.size[1] : -1,
                                (corner & 4) != 0 ? from.size[2] : -1);
    corners_mm.push_back(from.position_mm(index));
  }
  const geometry::Box box = geometry::bounding_box(corners_mm);
  imaging::Grid grid;
  grid.spacing_mm.setConstant(beam_voxel_mm);
  grid.origin_mm = box.min_mm;
  for (int axis = 0; axis < 3; ++axis) {
    grid.size[static_cast<std::size_t>(axis)] =
        static_cast<int>(std::ceil((box.max_mm - box.min_mm)[axis] / beam_voxel_mm)) + 1;
  }
  imaging::Mask outside = segmentation::resample(liver.organ, grid);
  for (std::uint8_t& value : outside.values) value = value != 0 ? 0 : 1;
  const std::vector<float> to_border_mm2 = imaging::squared_distances_mm2(outside);
  std::optional<imaging::Mask> confident;
  if (liver.confident) confident = segmentation::resample(*liver.confident, grid);

  mechanics::VoxelBody tissue{{grid, std::vector<std::uint8_t>(grid.voxels(), 0)}, {}};
  tissue.youngs_kPa.assign(grid.voxels(), 0);
  const double border_mm = elastography::StiffnessOptions{}.unreliable_border_mm;
  const imaging::Grid& map = liver.shear_kPa.grid;
  const Eigen::Matrix3d turn = map.direction.inverse();
  std::size_t v = 0;
  for (int k = 0; k < grid.size[2]; ++k) {
    for (int j = 0; j < grid.size[1]; ++j) {
      for (int i = 0; i < grid.size[0]; ++i, ++v) {
        if (static_cast<double>(to_border_mm2[v]) <= border_mm * border_mm) continue;
        if (confident && confident->values[v] == 0) continue;
        const Eigen::Vector3d index =
            (turn * (grid.position_mm(i, j, k) - map.origin_mm)).cwiseQuotient(map.spacing_mm);
        const Eigen::Vector3i at = index.array().round().cast<int>();
        if (!map.contains(at.x(), at.y(), at.z())) continue;
        const float shear_kPa = liver.shear_kPa.at(at.x(), at.y(), at.z());
        if (!(shear_kPa > 0) || !std::isfinite(shear_kPa)) continue;
        tissue.body.values[v] = 1;
        tissue.youngs_kPa[v] =
            static_cast<float>(units::youngs_from_shear(static_cast<double>(shear_kPa), poisson_ratio));
      }
    }
  }
  return tissue;
}

Result<NamedNumbers> misplacements_in(const Subject& subject, const LandmarksOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  const auto liver = read_subject(subject);
  if (!liver) return failure(liver.error());
  const auto statistics = elastography::statistics_of(liver->values_kPa());
  if (!statistics) return failure(statistics.error());
  const auto retraction = retract(*liver, options.retraction);
  if (!retraction) return failure(retraction.error());
  const auto beams = beams_of(subject.id, *liver, statistics->mean, options);
  if (!beams) return failure(beams.error());

  NamedNumbers row{{"mean_kPa", statistics->mean},
                   {"sd_kPa", statistics->sd},
                   {"volume_ml", retraction->volume_ml},
                   {"cells", static_cast<double>(retraction->cells)},
                   {"lifted_mm", retraction->measured.result.max_displacement_mm},
                   {"atlas_lifted_mm", retraction->reference.result.max_displacement_mm},
                   {"largest_strain", retraction->measured.result.largest_strain},
                   {"atlas_mean_mm", retraction->measured_against_reference.mean_mm},
                   {"atlas_near_tool_mm", retraction->measured_against_reference.max_near_tool_mm.value_or(0)},
                   {"atlas_max_mm", retraction->measured_against_reference.max_mm},
                   {"mean_stiffness_near_tool_mm", retraction->mean_against_reference.max_near_tool_mm.value_or(0)},
                   {"own_mean_near_tool_mm", retraction->measured_against_mean.max_near_tool_mm.value_or(0)},
                   {"control_beam_lifted_mm", beams->control_displacement_mm}};
  for (std::size_t r = 0; r < beams->regions.size(); ++r) {
    const BeamComparison& region = beams->regions[r];
    const std::string name = region_columns[r];
    row.emplace_back(name + "_mean_kPa",
                     units::shear_from_youngs(region.place.mean_kPa, options.retraction.poisson_ratio));
    row.emplace_back(name + "_sd_kPa", units::shear_from_youngs(region.place.sd_kPa, options.retraction.poisson_ratio));
    row.emplace_back(name + "_mean_mm", region.mean_mm);
    row.emplace_back(name + "_max_mm", region.max_mm);
  }
  if (options.retraction.law == RetractionLaw::by_strain) {
    row.emplace_back("linear_strain", retraction->linear_strain);
    row.emplace_back("at_large_strain", retraction->answered == Retraction::Answered::neo_hookean ? 1 : 0);
    row.emplace_back("beyond_linear", retraction->answered == Retraction::Answered::linear_beyond_it ? 1 : 0);
    row.emplace_back("linear_atlas_near_tool_mm",
                     retraction->linear_measured_against_reference.max_near_tool_mm.value_or(0));
  }
  if (!liver->landmarks.empty()) add_landmark_columns(*liver, *retraction, row);
  if (options.retraction.meshfree) add_engine_columns(*liver, *retraction, row);
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  row.emplace_back("seconds", taken.count());
  return row;
}

std::optional<LandmarksSpread> spread_over(const std::vector<BatchRow>& rows, const std::string& column,
                                           std::string says) {
  const std::vector<double> values = column_of(rows, column);
  const auto found = elastography::statistics_of(values);
  if (!found) return std::nullopt;
  const auto matters = std::count_if(values.begin(), values.end(), [](double mm) { return mm >= significant_mm; });
  LandmarksSpread spread{
      column, std::move(says), *found, share_of(static_cast<std::size_t>(matters), values.size()), {}};
  for (std::size_t n = 0; n < most_examples && n < values.size(); ++n) {
    const double wanted_mm = n == 0 ? found->median : found->mean + static_cast<double>(n) * found->sd;
    const BatchRow* nearest = nullptr;
    double minimum_mm = 0;
    for (const BatchRow& row : rows) {
      const std::vector<double> value = column_of({row}, column);
      if (value.empty() || std::count(spread.examples.begin(), spread.examples.end(), row.id) > 0) continue;
      const double away_mm = std::abs(value.front() - wanted_mm);
      if (nearest != nullptr && away_mm >= minimum_mm) continue;
      nearest = &row;
      minimum_mm = away_mm;
    }
    spread.examples.push_back(nearest->id);
  }
  return spread;
}

// With a column of how far landmarks move in the atlas's body of this shape, off what they do on average over shapes.
std::vector<BatchRow> with_shape(std::vector<BatchRow> rows) {
  const std::vector<double> moved_mm = column_of(rows, "atlas_moved_mm");
  double mean_mm = 0;
  for (const double mm : moved_mm) mean_mm += mm / static_cast<double>(moved_mm.size());
  for (BatchRow& row : rows) {
    const std::vector<double> mm = column_of({row}, "atlas_moved_mm");
    if (!mm.empty()) row.values.emplace_back("by_shape_mm", std::abs(mm.front() - mean_mm));
  }
  return rows;
}

void summarise(LandmarksSummary& summary) {
  for (const BatchRow& row : summary.rows) {
    row.error.empty() ? ++summary.patients : ++summary.failed;
    summary.reused += row.reused ? 1 : 0;
  }
  const auto spread_of = [&](const std::string& column, std::string says) -> std::optional<LandmarksSpread> {
    return spread_over(summary.rows, column, std::move(says));
  };
  const auto add = [](std::vector<LandmarksSpread>& list, std::optional<LandmarksSpread> spread) {
    if (spread) list.push_back(std::move(*spread));
  };
  add(summary.between, spread_of("atlas_mean_mm", "atlas, on average"));
  add(summary.between, spread_of("atlas_near_tool_mm", "atlas, at tool"));
  add(summary.between, spread_of("mean_stiffness_near_tool_mm", "atlas, mean only"));
  add(summary.between, spread_of("own_mean_near_tool_mm", "own mean, at tool"));
  for (const char* region : region_columns) {
    add(summary.within, spread_of(fmt::format("{}_max_mm", region), fmt::format("{} region", region)));
  }
  for (const auto& [name, says] : landmark_groups) {
    add(summary.groups, spread_of(fmt::format("{}_mean_mm", name), fmt::format("{}, on average", says)));
    add(summary.groups, spread_of(fmt::format("{}_max_mm", name), fmt::format("{}, the farthest", says)));
  }
  if (!summary.groups.empty()) {
    add(summary.groups, spread_of("linear_landmarks_max_mm", "the farthest of all, linear"));
    add(summary.sensitivity, spread_of("by_stiffness_mm", "own mean, not the atlas"));
    add(summary.sensitivity, spread_of("by_texture_mm", "own map, not its mean"));
    add(summary.sensitivity, spread_of("by_supports_mm", "wall of 30 mm, not 15"));
    add(summary.sensitivity, spread_over(with_shape(summary.rows), "by_shape_mm", "own shape, not all's mean"));
  }
  for (const auto& [column, says] : engine_columns) add(summary.engines, spread_of(column, says));
  for (const double one : column_of(summary.rows, "meshfree_answered")) summary.without_meshfree += one > 0 ? 0 : 1;
  for (const double one : column_of(summary.rows, "at_large_strain")) summary.at_large_strain += one > 0 ? 1 : 0;
  for (const double one : column_of(summary.rows, "beyond_linear")) summary.beyond_linear += one > 0 ? 1 : 0;
  const auto slowest = column_of(summary.rows, "seconds");
  if (slowest.empty()) return;
  summary.slowest_s = *std::max_element(slowest.begin(), slowest.end());
  std::vector<double> largest(summary.patients, 0);
  for (const char* region : region_columns) {
    const auto values = column_of(summary.rows, fmt::format("{}_max_mm", region));
    for (std::size_t p = 0; p < largest.size(); ++p) largest[p] = std::max(largest[p], values[p]);
  }
  const auto any = std::count_if(largest.begin(), largest.end(), [](double mm) { return mm >= significant_mm; });
  summary.any_region_fraction = static_cast<double>(any) / static_cast<double>(summary.patients);
}

}  // namespace
}  // namespace glisson::studies
