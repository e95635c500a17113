#include "studies/dissertation/validate_stiffness.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/csv.h"
#include "base/files.h"
#include "base/json.h"
#include "base/units.h"
#include "base/write_file.h"
#include "elastography/region_statistics.h"
#include "imaging/stiffness_map.h"
#include "imaging/volume_file.h"
#include "report/html.h"
#include "segmentation/resample.h"

namespace glisson::studies {
namespace fs = std::filesystem;
namespace {

// A machine's program rounds its moduli to some digits, and no more than that.
constexpr double rounding = 0.02;

void note_contradictions(const std::vector<CompressedSample>& samples, std::vector<std::string>& notes);
// Where what is stated agrees and what the samples' own figures give does not.
void note_disagreement(const MaterialAgreement& material, std::vector<std::string>& notes);
Result<void> write_outcome(const fs::path& out, const StiffnessValidation& validation,
                           const std::vector<CompressedSample>& samples);

}  // namespace

double CompressedSample::youngs_kPa() const {
  const double area_mm2 = std::numbers::pi * diameter_mm * diameter_mm / 4;
  return force_mN / area_mm2 / (displacement_mm / height_mm);
}

Result<std::vector<CompressedSample>> read_samples(const fs::path& file) {
  const auto table = read_csv(file);
  if (!table) return failure(table.error());
  std::vector<CompressedSample> samples(table->rows());
  const auto read = [&](const char* name, auto put) -> Result<void> {
    const auto column = table->column(name);
    if (!column) return failure(column.error());
    for (std::size_t row = 0; row < samples.size(); ++row) put(samples[row], table->columns[*column][row]);
    return {};
  };
  for (const Result<void>&done : {read("material", [](auto&s, double v) { s.material = fmt::format("{:g}", v); }),
                                  read("diameter_mm", [](auto&s, double v) { s.diameter_mm = v; }),
                                  read("height_mm", [](auto&s, double v) { s.height_mm = v; }),
                                  read("displacement_mm", [](auto&s, double v) { s.displacement_mm = v; }),
                                  read("force_N", [](auto&s, double v) { s.force_mN = units::mN_from_N(v); })}) {
    if (!done) return failure(Error{done.error()}.in_file(file));
  }
  const auto known = [](double value) { return std::isfinite(value) ? value : 0; };
  if (table->column("stated_kPa")) {
    auto done = read("stated_kPa", [&](auto& s, double v) { s.stated_kPa = known(v); });
    if (!done) return failure(done.error());
  }
  if (table->column("mean_kPa")) {
    auto done = read("mean_kPa", [&](auto& s, double v) { s.mean_kPa = known(v); });
    if (!done) return failure(done.error());
  }
  for (std::size_t row = 0; row < samples.size(); ++row) {
    const CompressedSample& s = samples[row];
    if (s.diameter_mm > 0 && s.height_mm > 0 && s.displacement_mm > 0 && s.force_mN > 0) continue;
    return failure(Error{"samples-impossible",
                         GLISSON_TEXT("Sample {0} of {1} has a size, a way or a force that is not positive."),
                         {std::to_string(row + 1), file.string()},
                         {},
                         file});
  }
  return samples;
}

Result<std::vector<MreRegion>> regions_of(const fs::path& map, const fs::path& labels, double poisson_ratio) {
  auto stored = imaging::read_volume_file(map);
  if (!stored) return failure(stored.error());
  const auto stiffness = imaging::stiffness_in_kPa(std::move(*stored));
  if (!stiffness) return failure(stiffness.error());
  const auto drawn = imaging::read_labels_file(labels);
  if (!drawn) return failure(drawn.error());
  const std::uint16_t maximum =
      drawn->values.empty() ? std::uint16_t{0} : *std::max_element(drawn->values.begin(), drawn->values.end());
  std::vector<MreRegion> regions;
  for (std::uint16_t label = 1; label <= maximum; ++label) {
    imaging::Mask mask{drawn->grid, {}};
    for (const std::uint16_t value : drawn->values) mask.values.push_back(value == label ? 1 : 0);
    if (!imaging::same_grid(mask.grid, stiffness->shear_kPa.grid)) {
      mask = segmentation::resample(mask, stiffness->shear_kPa.grid);
    }
    std::vector<double> values;
    for (std::size_t v = 0; v < mask.values.size(); ++v) {
      const float shear_kPa = stiffness->shear_kPa.values[v];
      if (mask.values[v] != 0 && shear_kPa > 0) {
        values.push_back(units::youngs_from_shear(static_cast<double>(shear_kPa), poisson_ratio));
      }
    }
    if (values.empty()) continue;
    const auto found = elastography::statistics_of(std::move(values));
    if (!found) return failure(found.error());
    regions.push_back({std::to_string(label), found->mean, found->sd, found->voxels});
  }
  if (regions.empty()) {
    return failure(Error{"validation-no-regions",
                         GLISSON_TEXT("No labelled voxel of {0} lies where {1} has a stiffness."),
                         {labels.string(), map.string()},
                         {},
                         labels});
  }
  return regions;
}

std::vector<MreRegion> dissertation_regions() { return {{"1", 17.47, 0, 0}, {"2", 36.81, 0, 0}}; }

Result<std::vector<CompressedSample>> dissertation_samples() {
  return resource_folder().and_then(
      [](const fs::path& folder) { return read_samples(folder / "studies/table-4.5.csv"); });
}

Result<StiffnessValidation> validate_stiffness(const std::vector<MreRegion>& regions,
                                               const std::vector<CompressedSample>& samples, const fs::path& out) {
  StiffnessValidation validation;
  for (const MreRegion& region : regions) {
    std::vector<double> moduli;
    std::vector<double> stated;
    double mean_kPa = 0;
    for (const CompressedSample& sample : samples) {
      if (sample.material != region.material) continue;
      moduli.push_back(sample.youngs_kPa());
      if (sample.mean_kPa > 0) mean_kPa = sample.mean_kPa;
      if (sample.stated_kPa > 0) stated.push_back(sample.stated_kPa);
    }
    const auto machine = elastography::statistics_of(moduli);
    if (!machine) {
      return failure(Error{"validation-no-samples",
                           GLISSON_TEXT("Material {0} was never put under the testing machine."),
                           {region.material},
                           GLISSON_TEXT("Give its samples in the file of tests, or leave the region out."),
                           {}});
    }
    MaterialAgreement agreement;
    agreement.material = region.material;
    agreement.mre_kPa = region.youngs_kPa;
    agreement.machine_kPa = machine->median;
    agreement.machine_low_kPa = machine->min;
    agreement.machine_high_kPa = machine->max;
    agreement.samples = machine->voxels;
    const double median_kPa =
        stated.size() == moduli.size() ? elastography::statistics_of(std::move(stated)).value().median : 0.0;
    agreement.stated_kPa = mean_kPa > 0 ? mean_kPa : median_kPa;
    if (agreement.stated_kPa > 0) {
      agreement.stated_difference_percent = 100 * (agreement.mre_kPa / agreement.stated_kPa - 1);
    }
    if (mean_kPa > 0 && median_kPa > 0 && std::abs(mean_kPa / median_kPa - 1) > rounding) {
      validation.notes.push_back(
          fmt::format("Material {}: {:.2f} kPa is stated of it, while the median of what is stated of its samples is "
                      "{:.2f} kPa.",
                      region.material, mean_kPa, median_kPa));
    }
    agreement.difference_percent = 100 * (agreement.mre_kPa - agreement.machine_kPa) / agreement.machine_kPa;
    note_disagreement(agreement, validation.notes);
    validation.largest_difference_percent =
        std::max(validation.largest_difference_percent, std::abs(agreement.difference_percent));
    validation.materials.push_back(std::move(agreement));
  }
  note_contradictions(samples, validation.notes);
  if (auto written = write_outcome(out, validation, samples); !written) return failure(written.error());
  return validation;
}

namespace {

void note_contradictions(const std::vector<CompressedSample>& samples, std::vector<std::string>& notes) {
  for (std::size_t n = 0; n < samples.size(); ++n) {
    const CompressedSample& sample = samples[n];
    if (!(sample.stated_kPa > 0) || std::abs(sample.stated_kPa / sample.youngs_kPa() - 1) <= rounding) continue;
    notes.push_back(
        fmt::format("Sample {} (material {}): {:.2f} kPa is stated, but its own force, way and size give "
                    "{:.2f} kPa, which counts here.",
                    n + 1, sample.material, sample.stated_kPa, sample.youngs_kPa()));
  }
}

void note_disagreement(const MaterialAgreement& material, std::vector<std::string>& notes) {
  constexpr double agrees_percent = 10;
  if (!(material.stated_kPa > 0) || std::abs(material.stated_difference_percent) > agrees_percent ||
      std::abs(material.difference_percent) <= agrees_percent) {
    return;
  }
  notes.push_back(
      fmt::format("Material {}: MRE is {:+.0f} % off what is stated, but {:+.0f} % off what its samples' own forces, "
                  "ways and sizes give.",
                  material.material, material.stated_difference_percent, material.difference_percent));
}

Result<void> write_outcome(const fs::path& out, const StiffnessValidation& validation,
                           const std::vector<CompressedSample>& samples) {
  std::string csv = "material,mre_kPa,machine_median_kPa,machine_min_kPa,machine_max_kPa,samples,difference_percent\n";
  Json document{{"materials", Json::array()},
                {"largest_difference_percent", validation.largest_difference_percent},
                {"notes", validation.notes}};
  report::Table table{
      "MRE against the testing machine. The machine's value is the median of its samples, each from its own "
      "force, way and size; stated is what is reported of the material, or the median of what the machine's "
      "program gave.",
      {"Material", "MRE (kPa)", "Machine (kPa)", "Samples", "Range (kPa)", "Difference", "Stated (kPa)",
       "Difference from stated"},
      {}};
  report::Plot plot{"Young's modulus of each sample under the testing machine, and the mean by MRE.",
                    "material",
                    "Young's modulus (kPa)",
                    {},
                    {},
                    {},
                    {}};
  plot.curves.push_back({"sample", {}, report::PlotCurve::Style::dots});
  plot.curves.push_back({"MRE", {}, report::PlotCurve::Style::dots});
  for (std::size_t n = 0; n < validation.materials.size(); ++n) {
    const MaterialAgreement& m = validation.materials[n];
    csv += fmt::format("{},{:.6g},{:.6g},{:.6g},{:.6g},{},{:.6g}\n", m.material, m.mre_kPa, m.machine_kPa,
                       m.machine_low_kPa, m.machine_high_kPa, m.samples, m.difference_percent);
    Json material{{"material", m.material},       {"mre_kPa", m.mre_kPa},
                  {"machine_kPa", m.machine_kPa}, {"machine_range_kPa", {m.machine_low_kPa, m.machine_high_kPa}},
                  {"samples", m.samples},         {"difference_percent", m.difference_percent}};
    if (m.stated_kPa > 0) {
      material["stated_kPa"] = m.stated_kPa;
      material["stated_difference_percent"] = m.stated_difference_percent;
    }
    document["materials"].push_back(std::move(material));
    table.rows.push_back({{m.material},
                          {fmt::format("{:.2f}", m.mre_kPa)},
                          {fmt::format("{:.2f}", m.machine_kPa)},
                          {std::to_string(m.samples)},
                          {fmt::format("{:.2f} to {:.2f}", m.machine_low_kPa, m.machine_high_kPa)},
                          {fmt::format("{:+.1f} %", m.difference_percent)},
                          {m.stated_kPa > 0 ? fmt::format("{:.2f}", m.stated_kPa) : "-"},
                          {m.stated_kPa > 0 ? fmt::format("{:+.1f} %", m.stated_difference_percent) : "-"}});
    const double at = static_cast<double>(n + 1);
    for (const CompressedSample& sample : samples) {
      if (sample.material == m.material) plot.curves[0].points.emplace_back(at, sample.youngs_kPa());
    }
    plot.curves[1].points.emplace_back(at, m.mre_kPa);
  }
  report::Page page;
  page.title = "MRE against mechanical tests";
  page.subtitle = "Young's modulus of phantom materials (dissertation, section 4.6)";
  page.footer = fmt::format("Glisson {}. Research software; not a medical device.", version());
  page.blocks = {std::move(table), std::move(plot)};
  for (const std::string& note : validation.notes) page.blocks.emplace_back(report::Paragraph{note});
  return write_together([&] {
    return write_text_file(out / "validation.csv", csv)
        .and_then([&] { return write_json_file(out / "summary.json", document); })
        .and_then([&] { return report::write_html(out / "report.html", page); });
  });
}

}  // namespace
}  // namespace glisson::studies
