#include "studies/dissertation/matching_study.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

#include "studies/dissertation/internal/matching_problems.h"
#include "studies/dissertation/internal/matching_timing.h"

namespace glisson::studies {
namespace {

using registration::MatchingProblem;
using registration::TrwlsOptions;
using registration::WordWidth;

constexpr WordWidth all_widths[] = {WordWidth::double_precision, WordWidth::bits_32, WordWidth::bits_16,
                                    WordWidth::bits_8};

Result<void> check(const MatchingOptions& options);
std::string column(int points, WordWidth width);
std::vector<MatchingQuality> quality_of(const std::vector<BatchRow>& rows, const MatchingOptions& options);
// The dissertation's Xeon with an Arria 10: 12 GB/s to the accelerator (section 3.2.1), 32 x 32 cells at 100 MHz
// (sections 3.3.2 and 3.4.2).
constexpr double harp_GB_per_s = 12, harp_costs_G_per_s = 32 * 32 * 0.1;
MatchingDevice platform(const std::string& name, double memory_GB_per_s, double costs_G_per_s,
                        const MatchingOptions& options);

}  // namespace

Result<MatchingStudy> run_matching(const std::filesystem::path& out, const MatchingOptions& options,
                                   const Progress& progress) {
  if (auto good = check(options); !good) return failure(good.error());
  const auto problems = MatchingProblems::create(options, progress.part(0, 0.2));
  if (!problems) return failure(problems.error());
  MatchingStudy study;
  study.options = options;
  study.simulated = options.shapes.empty();
  const auto energies = [&](std::size_t problem) -> Result<NamedNumbers> {
    NamedNumbers values;
    for (const int points : options.points) {
      const MatchingProblem field = problems->of(problem, points);
      for (const WordWidth width : all_widths) {
        const bool plain = width == WordWidth::bits_8 || width == WordWidth::bits_32;
        if (plain && points > options.points_of_all_widths) continue;
        if (progress.cancelled()) return cancelled();
        const auto solution = registration::trwls(field, as_in_table_3_1(options.passes, width));
        if (!solution) return failure(solution.error());
        values.emplace_back(column(points, width), solution->energy);
      }
      const auto usual = registration::trwls(field);
      if (!usual) return failure(usual.error());
      values.emplace_back(fmt::format("n{}_usual", points), usual->energy);
    }
    return values;
  };
  auto rows = run_batch(out, problems->list(), energies, {}, progress.part(0.2, 0.8));
  if (!rows) return failure(rows.error());
  study.rows = std::move(*rows);
  study.quality = quality_of(study.rows, options);

  study.points_by_pass = std::min(options.points.back(), options.points_of_all_widths);
  const MatchingProblem first = problems->of(0, study.points_by_pass);
  for (const WordWidth width : all_widths) {
    if (progress.cancelled()) return cancelled();
    const auto solution = registration::trwls(first, as_in_table_3_1(options.passes, width));
    if (!solution) return failure(solution.error());
    std::vector<double> by_pass;
    for (const auto& pass : solution->passes) by_pass.push_back(pass.energy);
    study.energy_by_pass.push_back(std::move(by_pass));
  }

  for (int points = 16; points <= 512; points += 16) {
    study.demands.push_back(matching_demand(points, options.passes, options.scans_per_s));
  }
  study.platforms.push_back(
      platform("the dissertation's Xeon and Arria 10", harp_GB_per_s, harp_costs_G_per_s, options));
  if (options.seconds_a_timing > 0) {
    const auto measured = time_matching(problems->of(0, options.points.back()), options, progress.part(0.8, 1));
    if (!measured) return failure(measured.error());
    study.timings = measured->timings;
    study.remarks = measured->remarks;
    study.platforms.push_back(platform("this machine", measured->memory_GB_per_s, measured->costs_G_per_s, options));
  }
  return study;
}

MatchingDemand matching_demand(int points, int passes, double scans_per_s) {
  const double n = points;
  const double passes_per_s = passes * scans_per_s;
  MatchingDemand demand;
  demand.points = points;
  demand.field_MB = 8 * n * (n - 1) / 2 * n * n * 1e-6;
  demand.field_GB_per_s = passes_per_s * 2 * demand.field_MB * 1e-3;
  demand.distances_GB_per_s = passes_per_s * 8 * 2 * n * n * 1e-9;
  demand.messages_GB_per_s = passes_per_s * 2 * n * (n - 1) * n * 1e-9;
  demand.costs_G_per_s = passes_per_s * n * n * n * (n - 1) * 1e-9;
  return demand;
}

const char* name_of(WordWidth width) {
  switch (width) {
    case WordWidth::bits_8: return "8 bits";
    case WordWidth::bits_16: return "16 bits";
    case WordWidth::bits_32: return "32 bits";
    case WordWidth::double_precision: return "64-bit floating point";
  }
  return "16 bits";
}

namespace {

Result<void> check(const MatchingOptions& options) {
  bool good = !options.points.empty() && std::is_sorted(options.points.begin(), options.points.end()) &&
              options.points.front() >= 8 && options.points.back() <= 1024 && !options.starts.empty() &&
              options.passes >= 1 && options.passes <= 1000 && options.scans_per_s > 0 && options.scans_per_s <= 1e6 &&
              options.livers >= 1 && options.livers <= 1000 && options.seconds_a_timing >= 0 &&
              options.seconds_a_timing <= 600;
  for (const int start : options.starts) good = good && start >= 0;
  for (const auto& poses : options.shapes) good = good && poses.size() >= 2;
  if (good) return {};
  return failure(
      "study-options",
      GLISSON_TEXT("The matching study takes ascending numbers of points from 8 to 1024, starts of 0 or more, "
                   "1 to 1000 passes and livers, and two or more poses of each shape."));
}

std::string column(int points, WordWidth width) {
  switch (width) {
    case WordWidth::bits_8: return fmt::format("n{}_8_bits", points);
    case WordWidth::bits_16: return fmt::format("n{}_16_bits", points);
    case WordWidth::bits_32: return fmt::format("n{}_32_bits", points);
    case WordWidth::double_precision: break;
  }
  return fmt::format("n{}_double", points);
}

std::vector<MatchingQuality> quality_of(const std::vector<BatchRow>& rows, const MatchingOptions& options) {
  std::vector<MatchingQuality> quality;
  for (const int points : options.points) {
    const auto exact = column_of(rows, column(points, WordWidth::double_precision));
    for (const WordWidth width : {WordWidth::bits_32, WordWidth::bits_16, WordWidth::bits_8}) {
      const auto energies = column_of(rows, column(points, width));
      if (energies.empty() || energies.size() != exact.size()) continue;
      MatchingQuality of{points, width, energies.size()};
      for (std::size_t i = 0; i < energies.size(); ++i) {
        const double delta = exact[i] > 0 ? energies[i] / exact[i] - 1 : 0;
        of.mean_delta += std::abs(delta) / double(energies.size());
        of.mean_signed += delta / double(energies.size());
        of.worst_delta = std::max(of.worst_delta, std::abs(delta));
      }
      quality.push_back(of);
    }
  }
  return quality;
}

MatchingDevice platform(const std::string& name, double memory_GB_per_s, double costs_G_per_s,
                        const MatchingOptions& options) {
  MatchingDevice of{name, memory_GB_per_s, costs_G_per_s};
  for (int points = 2; points <= 4096; ++points) {
    const MatchingDemand demand = matching_demand(points, options.passes, options.scans_per_s);
    if (demand.field_GB_per_s <= memory_GB_per_s) of.points_by_field = points;
    if (demand.messages_GB_per_s <= memory_GB_per_s) of.points_by_messages = points;
    if (demand.costs_G_per_s <= costs_G_per_s) of.points_by_costs = points;
  }
  return of;
}

}  // namespace
}  // namespace glisson::studies
