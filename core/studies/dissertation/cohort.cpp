#include "studies/dissertation/cohort.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "base/files.h"
#include "base/json.h"
#include "elastography/region_statistics.h"
#include "report/html.h"
#include "studies/dissertation/subjects.h"

namespace glisson::studies {
namespace fs = std::filesystem;
namespace {

using elastography::RegionStatistics;

Result<NamedNumbers> statistics_of_subject(const Subject& subject);
void summarise(CohortSummary& summary, const CohortOptions& options);
Result<void> write_report(const fs::path& file, const CohortSummary& summary, const CohortOptions& options);

}  // namespace

Result<CohortSummary> run_cohort(const fs::path& folder, const fs::path& out, const CohortOptions& options,
                                 const Progress& progress) {
  const auto subjects = find_subjects(folder);
  if (!subjects) return failure(subjects.error());
  std::vector<BatchPatient> patients;
  for (const Subject& subject : *subjects) patients.push_back({subject.id, "cohort/1 " + fingerprint_of(subject)});

  CohortSummary summary;
  auto rows = run_batch(
      out, patients, [&](std::size_t p) { return statistics_of_subject((*subjects)[p]); }, options.part, progress);
  if (!rows) return failure(rows.error());
  summary.rows = std::move(*rows);
  summarise(summary, options);
  if (!options.part.is_all()) return summary;
  if (summary.patients == 0) {
    return failure(Error{"cohort-all-failed",
                         GLISSON_TEXT("None of the {0} patients could be used; the first one: {1}"),
                         {std::to_string(summary.failed), summary.rows.front().error},
                         {},
                         folder});
  }
  if (auto saved = write_batch_csv(out / "cohort.csv", summary.rows); !saved) return failure(saved.error());
  if (auto saved = write_text_file(out / "summary.json", summary_json(summary).dump(2) + "\n"); !saved)
    return failure(saved.error());
  if (auto saved = write_report(out / "report.html", summary, options); !saved) return failure(saved.error());
  return summary;
}

Result<std::vector<std::string>> cohort_patients(const fs::path& folder) {
  return find_subjects(folder).map([](const std::vector<Subject>& subjects) {
    std::vector<std::string> ids;
    for (const Subject& subject : subjects) ids.push_back(subject.id);
    return ids;
  });
}

Json summary_json(const CohortSummary& summary) {
  Json document{{"patients", summary.patients},
                {"failed", summary.failed},
                {"mean_kPa", summary.mean_kPa},
                {"sd_kPa", summary.sd_kPa},
                {"median_kPa", summary.median_kPa},
                {"interval_95_kPa", {summary.low_kPa, summary.high_kPa}},
                {"within_atlas_width_of_median_fraction", summary.like_reference_fraction},
                {"in_atlas_fraction", summary.in_reference_fraction},
                {"upper_limit_over_atlas", summary.upper_limit_ratio},
                {"rank_correlation_sd_with_mean", summary.rank_correlation},
                {"bins", Json::array()}};
  for (const CohortBin& bin : summary.bins) {
    Json json{{"low_kPa", bin.low_kPa}, {"high_kPa", bin.high_kPa}, {"patients", bin.patients}};
    if (bin.patients > 0) json["mean_sd_kPa"] = bin.mean_sd_kPa;
    document["bins"].push_back(std::move(json));
  }
  return null_where_not_finite(std::move(document));
}

namespace {

Result<NamedNumbers> statistics_of_subject(const Subject& subject) {
  const auto liver = read_subject(subject);
  if (!liver) return failure(liver.error());
  const auto found = elastography::statistics_of(liver->values_kPa());
  if (!found) return failure(found.error());
  return NamedNumbers{{"voxels", static_cast<double>(found->voxels)},
                      {"mean_kPa", found->mean},
                      {"sd_kPa", found->sd},
                      {"median_kPa", found->median},
                      {"percentile_5_kPa", found->percentile_5},
                      {"percentile_95_kPa", found->percentile_95}};
}

// Between two ranks linearly.
double quantile(std::vector<double> values, double fraction) {
  std::sort(values.begin(), values.end());
  const double place = fraction * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, values.size() - 1);
  return values[below] + (place - static_cast<double>(below)) * (values[above] - values[below]);
}

std::vector<double> ranks_of(const std::vector<double>& values) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
  std::vector<double> ranks(values.size());
  for (std::size_t n = 0; n < order.size(); ++n) ranks[order[n]] = static_cast<double>(n);
  return ranks;
}

// Spearman's, for values that are measured and hence hardly ever equal.
double rank_correlation(const std::vector<double>& a, const std::vector<double>& b) {
  if (a.size() < 3) return 0;
  const auto rank_a = ranks_of(a);
  const auto rank_b = ranks_of(b);
  double squares = 0;
  for (std::size_t n = 0; n < a.size(); ++n) squares += (rank_a[n] - rank_b[n]) * (rank_a[n] - rank_b[n]);
  const auto count = static_cast<double>(a.size());
  return 1 - 6 * squares / (count * (count * count - 1));
}

std::vector<CohortBin> bins_of(const std::vector<double>& means, const std::vector<double>& sds,
                               const CohortOptions& options) {
  const double width = 2 * options.reference_half_width_kPa;
  const double minimum = *std::min_element(means.begin(), means.end());
  const double maximum = *std::max_element(means.begin(), means.end());
  const double first = options.reference_kPa - options.reference_half_width_kPa;
  std::vector<CohortBin> bins;
  for (double low = first + width * std::floor((minimum - first) / width); low <= maximum; low += width) {
    CohortBin bin{low, low + width, 0, 0};
    for (std::size_t n = 0; n < means.size(); ++n) {
      if (means[n] < bin.low_kPa || means[n] >= bin.high_kPa) continue;
      ++bin.patients;
      bin.mean_sd_kPa += sds[n];
    }
    if (bin.patients > 0) bin.mean_sd_kPa /= static_cast<double>(bin.patients);
    bins.push_back(bin);
  }
  return bins;
}

void summarise(CohortSummary& summary, const CohortOptions& options) {
  for (const BatchRow& row : summary.rows) {
    row.error.empty() ? ++summary.patients : ++summary.failed;
    summary.reused += row.reused ? 1 : 0;
  }
  const std::vector<double> means = column_of(summary.rows, "mean_kPa");
  const std::vector<double> sds = column_of(summary.rows, "sd_kPa");
  const auto found = elastography::statistics_of(means);
  if (!found) return;
  summary.mean_kPa = found->mean;
  summary.sd_kPa = found->sd;
  summary.median_kPa = found->median;
  summary.low_kPa = quantile(means, 0.025);
  summary.high_kPa = quantile(means, 0.975);
  summary.upper_limit_ratio = summary.high_kPa / (options.reference_kPa + options.reference_half_width_kPa);
  const auto near = [&](double kPa) {
    const auto count = std::count_if(means.begin(), means.end(), [&](double mean) {
      return std::abs(mean - kPa) <= options.reference_half_width_kPa;
    });
    return static_cast<double>(count) / static_cast<double>(means.size());
  };
  summary.like_reference_fraction = near(summary.median_kPa);
  summary.in_reference_fraction = near(options.reference_kPa);
  summary.rank_correlation = rank_correlation(means, sds);
  summary.bins = bins_of(means, sds, options);
}

Result<void> write_report(const fs::path& file, const CohortSummary& summary, const CohortOptions& options) {
  report::Plot distribution{"How the patients' mean stiffness is distributed, and the atlas (fig. 4.6).",
                            "mean shear stiffness (kPa)",
                            "patients",
                            report::Histogram{},
                            {},
                            {},
                            {}};
  report::Plot spread{"Spread within a patient against the patient's mean (fig. 4.7).",
                      "mean shear stiffness (kPa)",
                      "standard deviation within the patient (kPa)",
                      {},
                      {},
                      {},
                      {}};
  report::PlotCurve each{"each patient", {}, report::PlotCurve::Style::dots};
  report::PlotCurve binned{"mean of each bin", {}, report::PlotCurve::Style::line};
  for (const CohortBin& bin : summary.bins) {
    if (distribution.histogram->edges.empty()) distribution.histogram->edges.push_back(bin.low_kPa);
    distribution.histogram->edges.push_back(bin.high_kPa);
    distribution.histogram->heights.push_back(static_cast<double>(bin.patients));
    if (bin.patients > 0) binned.points.emplace_back(0.5 * (bin.low_kPa + bin.high_kPa), bin.mean_sd_kPa);
  }
  const double atlas_low_kPa = options.reference_kPa - options.reference_half_width_kPa,
               atlas_high_kPa = options.reference_kPa + options.reference_half_width_kPa;
  distribution.bands = {{summary.low_kPa, summary.high_kPa, "95 % of these patients"},
                        {atlas_low_kPa, atlas_high_kPa, "95 % of the atlas's patients"}};
  distribution.rules.push_back({report::Rule::Along::x, options.reference_kPa, "atlas"});
  const auto means = column_of(summary.rows, "mean_kPa");
  const auto sds = column_of(summary.rows, "sd_kPa");
  for (std::size_t n = 0; n < means.size(); ++n) each.points.emplace_back(means[n], sds[n]);
  spread.curves = {std::move(each), std::move(binned)};

  report::Page page;
  page.title = "Stiffness between and within patients";
  page.subtitle = fmt::format("{} patients, {} could not be used", summary.patients, summary.failed);
  page.warning = options.warning;
  page.footer = fmt::format("Glisson {}. Research software; not a medical device.", version());
  page.blocks = {
      report::Paragraph{fmt::format(
          "The patients' mean shear stiffness is {:.2f} kPa on average (median {:.2f}, sd {:.2f}); 95 % lie between "
          "{:.2f} and {:.2f} kPa. {:.0f} % lie within {:.1f} kPa of the median and {:.0f} % within it of the atlas's "
          "{:.1f} kPa, where 95 % of the atlas's lie; the upper limit is {:.1f} times the atlas's. Within a patient "
          "stiffness varies more the stiffer "
          "the patient: rank correlation {:.2f}.",
          summary.mean_kPa, summary.median_kPa, summary.sd_kPa, summary.low_kPa, summary.high_kPa,
          100 * summary.like_reference_fraction, options.reference_half_width_kPa, 100 * summary.in_reference_fraction,
          options.reference_kPa, summary.upper_limit_ratio, summary.rank_correlation)},
      distribution, spread};
  report::Table table{"Each patient.", {"Patient", "Mean (kPa)", "sd (kPa)", "5 % (kPa)", "95 % (kPa)"}, {}};
  for (const BatchRow& row : summary.rows) {
    if (!row.error.empty()) {
      table.rows.push_back({{row.id}, {row.error, report::Cell::Emphasis::flag}});
      continue;
    }
    const auto cell = [&](const char* name) {
      return report::Cell{fmt::format("{:.2f}", column_of({row}, name).front())};
    };
    table.rows.push_back(
        {{row.id}, cell("mean_kPa"), cell("sd_kPa"), cell("percentile_5_kPa"), cell("percentile_95_kPa")});
  }
  page.blocks.emplace_back(std::move(table));
  return report::write_html(file, page);
}

}  // namespace
}  // namespace glisson::studies
