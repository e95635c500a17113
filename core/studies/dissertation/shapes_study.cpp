#include "studies/dissertation/shapes_study.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "anatomy/level_surface.h"
#include "base/files.h"
#include "base/folder_contents.h"
#include "base/json.h"
#include "base/json_forward.h"
#include "base/stopwatch.h"
#include "base/write_file.h"
#include "geometry/mesh_file.h"
#include "geometry/nearest.h"
#include "imaging/volume_file.h"
#include "segmentation/rasterise.h"
#include "shapes/completion.h"
#include "shapes/correspondence.h"
#include "shapes/liver_outline.h"
#include "shapes/model_file.h"

namespace glisson::studies {
namespace fs = std::filesystem;

using Eigen::Index;
using Eigen::Vector3d;
using geometry::Surface;

namespace {

constexpr const char* method = "shapes/3";  // another where rows made before are no longer what would be made now

fs::path surface_file(const fs::path& out, const char* of, const std::string& id) { return out / of / (id + ".vtp"); }

Result<NamedNumbers> correspond_liver(const ShapesLiver& liver, const fs::path& out, const Surface& reference,
                                      const ShapesOptions& options) {
  const Stopwatch watch;
  const auto labels = imaging::read_labels_file(liver.file);
  if (!labels) return failure(labels.error());
  shapes::OutlineOptions outlining;
  outlining.believe_unit_spacing = options.believe_unit_spacing;
  const auto outline = shapes::outline_of(*labels, outlining);
  if (!outline) return failure(outline.error());
  if (outline->cut_off_at != nullptr) {
    return failure("shapes-cut-off",
                   GLISSON_TEXT("The image cuts the liver off towards {0}: a model learns from whole ones."),
                   {outline->cut_off_at});
  }
  const auto found = shapes::correspond(reference, outline->surface, outline->coarse);
  if (!found) return failure(found.error());
  auto written = geometry::write_surface(surface_file(out, "outlines", liver.id), outline->surface).and_then([&] {
    return geometry::write_surface(surface_file(out, "livers", liver.id), found->surface);
  });
  if (!written) return failure(written.error());
  return NamedNumbers{{"volume_ml", outline->volume_ml},
                      {"correspondence_mm", found->mean_mm},
                      {"mirrored_ratio", found->mirrored_ratio},
                      {"orientation_kept", found->orientation_kept},
                      {"seconds", watch.seconds()}};
}

// The height (z) above which so much of the liver lies.
double height_above(const Surface& liver, double share) {
  geometry::Box box = geometry::bounding_box(liver.points_mm);
  const imaging::Mask mask = segmentation::rasterise(liver, anatomy::grid_over(box, 4));
  std::vector<std::size_t> slices(static_cast<std::size_t>(mask.grid.size[2]), 0);
  std::size_t all = 0;
  for (std::size_t v = 0; v < mask.values.size(); ++v) {
    const std::size_t slice = v / (mask.values.size() / slices.size());
    slices[slice] += mask.values[v];
    all += mask.values[v];
  }
  std::size_t above = 0;
  std::size_t k = slices.size();
  while (k > 0 && static_cast<double>(above) < share * static_cast<double>(all)) above += slices[--k];
  return mask.grid.position_mm(0, 0, static_cast<int>(k)).z() - 2;
}

// What lies on the side of the plane that is seen: below the height, or above it.
Surface seen_part(const Surface& liver, double height_mm, bool below) {
  Surface seen = liver;
  std::erase_if(seen.triangles, [&](const std::array<int, 3>& triangle) {
    return std::any_of(triangle.begin(), triangle.end(), [&](int point) {
      const double z = liver.points_mm[static_cast<std::size_t>(point)].z();
      return below ? z > height_mm : z < height_mm;
    });
  });
  // Points that no triangle uses would count in the middle.
  std::vector<int> number(seen.points_mm.size(), -1);
  std::vector<Vector3d> points_mm;
  for (auto& triangle : seen.triangles) {
    for (int& corner : triangle) {
      int& name = number[static_cast<std::size_t>(corner)];
      if (name < 0) {
        name = static_cast<int>(points_mm.size());
        points_mm.push_back(seen.points_mm[static_cast<std::size_t>(corner)]);
      }
      corner = name;
    }
  }
  seen.points_mm = std::move(points_mm);
  return seen;
}

struct CompletionScore {
  double mean_mm = 0;                 // both ways, over what was missing
  double sd_mm = 0;                   // that was said
  double within_1 = 0, within_2 = 0;  // share of missing points within one and within 1.96 sd of where they belong
  double volume_percent = 0, volume_sd_percent = 0;
  double mirrored_ratio = 0, mean_square = 0, residual_mm = 0, outside = 0;
};

// `truth`: the reference's points on the liver.
Result<CompletionScore> score_completion(const shapes::ShapeModel& model, const Surface& outline, const Surface& truth,
                                         double height_mm, bool below, const shapes::FitOptions& options) {
  const Surface seen = seen_part(outline, height_mm, below);
  const auto completed = shapes::complete(model, seen, options);
  if (!completed) return failure(completed.error());
  const auto missing = [&](const Vector3d& point) { return below ? point.z() > height_mm : point.z() < height_mm; };
  CompletionScore score;
  score.mirrored_ratio = shapes::mirrored_ratio(model, seen, completed->fit).value_or(99);
  score.mean_square = completed->fit.mean_square;
  score.residual_mm = completed->fit.residual_mm;
  score.outside = shapes::check_inside(model, completed->fit) ? 0 : 1;
  const geometry::SurfaceDistance to_outline(outline), to_completed(completed->surface);
  const std::vector<Vector3d> normals = geometry::point_normals(completed->surface);
  const geometry::Field& sd_mm = *geometry::find_field(completed->surface.point_fields, "sd_mm");
  double there = 0, back = 0;
  std::size_t points = 0, places = 0;
  for (std::size_t p = 0; p < completed->surface.points_mm.size(); ++p) {
    const Vector3d& point = completed->surface.points_mm[p];
    if (!missing(point)) continue;
    ++points;
    there += to_outline.closest(point).distance_mm;
    score.sd_mm += sd_mm.values[p];
    const double off = std::abs((truth.points_mm[p] - point).dot(normals[p]));
    score.within_1 += off <= sd_mm.values[p] ? 1 : 0;
    score.within_2 += off <= 1.96 * sd_mm.values[p] ? 1 : 0;
  }
  for (const Vector3d& point : outline.points_mm) {
    if (!missing(point)) continue;
    ++places;
    back += to_completed.closest(point).distance_mm;
  }
  const double n = std::max<double>(1, static_cast<double>(points));
  score.mean_mm = 0.5 * (there / n + back / std::max<double>(1, static_cast<double>(places)));
  score.sd_mm /= n;
  score.within_1 /= n;
  score.within_2 /= n;
  const double true_ml = geometry::volume_mm3(outline) / 1000;
  score.volume_percent = 100 * std::abs(geometry::volume_mm3(completed->surface) / 1000 - true_ml) / true_ml;
  score.volume_sd_percent = 100 * completed->fit.volume_sd_ml / true_ml;
  return score;
}

Result<NamedNumbers> judge_liver(const shapes::AlignedShapes& all, const shapes::RanksJudged& ranks, int left_out,
                                 const Surface& outline, const Surface& truth, const shapes::FitOptions& options) {
  const Stopwatch watch;
  const shapes::ShapeModel model = shapes::calibrated(shapes::model_of(all, ranks.rank, {left_out}), ranks, left_out);
  // Nothing is to be guessed of a liver that is seen whole: as near as the sample's own modes come.
  shapes::FitOptions whole = options;
  whole.independent = 3000;
  whole.iterations = 60;
  whole.noise_mm = 0.5;
  whole.along_mm = 25;
  const auto fit = shapes::fit_model(shapes::model_of(all, ranks.rank, {left_out}), outline, whole);
  if (!fit) return failure(fit.error());
  NamedNumbers row{{"generalisation_mm", geometry::gap_between(fit->surface, outline, 4).mean_mm},
                   {"generalisation_rms_mm", fit->residual_mm}};
  for (const auto& [name, share, below] : {std::tuple{"dome", 1 / 3.0, true}, std::tuple{"tip", 2 / 3.0, false}}) {
    const auto score = score_completion(model, outline, truth, height_above(outline, share), below, options);
    if (!score) return failure(score.error());
    const std::string of = name;
    row.insert(row.end(), {{of + "_mm", score->mean_mm},
                           {of + "_sd_mm", score->sd_mm},
                           {of + "_within_1_sd", score->within_1},
                           {of + "_within_2_sd", score->within_2},
                           {of + "_volume_percent", score->volume_percent},
                           {of + "_volume_sd_percent", score->volume_sd_percent},
                           {of + "_mirrored_ratio", score->mirrored_ratio},
                           {of + "_mean_square", score->mean_square},
                           {of + "_residual_mm", score->residual_mm},
                           {of + "_outside", score->outside}});
  }
  row.emplace_back("seconds", watch.seconds());
  return row;
}

ShapesScore score_of(const std::vector<BatchRow>& rows, const std::string& column, const std::string& says,
                     bool high_is_good = false) {
  std::vector<double> values = column_of(rows, column);
  if (values.empty()) return {column, says, 0, 0, 0};
  std::sort(values.begin(), values.end());
  double sum = 0;
  for (const double value : values) sum += value;
  const std::size_t half = values.size() / 2;
  const double median = values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
  return {column, says, sum / static_cast<double>(values.size()), median,
          high_is_good ? values.front() : values.back()};
}

Json summary_json(const ShapesStudy& study, const shapes::ShapeModel& model) {
  Json modes = Json::array(), scores = Json::array();
  for (const shapes::RankJudged& of : study.ranks.by_modes) {
    modes.push_back({{"modes", of.modes},
                     {"compactness", of.compactness},
                     {"generalisation_points_mm", of.generalisation_mm},
                     {"held_out_ratio", of.held_out_ratio}});
  }
  for (const ShapesScore& score : study.scores) {
    scores.push_back({{"column", score.column},
                      {"says", score.says},
                      {"mean", score.mean},
                      {"median", score.median},
                      {"worst", score.worst}});
  }
  Json refused = Json::array();
  for (const auto* rows : {&study.livers, &study.judged}) {
    for (const BatchRow& row : *rows) {
      if (!row.error.empty()) refused.push_back({{"liver", row.id}, {"reason", row.error}});
    }
  }
  const double held =
      model.rank() > 0 ? study.ranks.by_modes[static_cast<std::size_t>(model.rank() - 1)].compactness : 0;
  return null_where_not_finite(
      Json{{"livers", study.used},
           {"points", model.mean.points_mm.size()},
           {"rank", model.rank()},
           {"compactness", held},
           {"spread_mm", study.spread_mm},
           {"specificity_mm", study.specificity_mm},
           {"correspondence_mm", score_of(study.livers, "correspondence_mm", "").mean},
           {"seconds_a_liver", score_of(study.livers, "seconds", "").mean},
           {"judged", column_of(study.judged, "generalisation_mm").size()},
           {"scores", scores},
           {"by_modes", modes},
           {"refused", refused},
           {"from_real_patients", "The model is made from patients' scans; share it only as they may be shared."}});
}

}  // namespace

std::vector<ShapesLiver> shapes_livers(const fs::path& folder) {
  std::map<std::string, std::pair<int, fs::path>> best;  // by id: how much its file is preferred
  for (const fs::path& file : contents_of(folder)) {
    if (!imaging::has_volume_file_name(file)) continue;
    std::string stem = file.filename().string();
    stem = stem.substr(0, stem.find('.'));
    int preferred = 0;
    if (stem.ends_with("_vessels") || stem.ends_with("_couinaud2")) continue;
    for (const auto& [ending, rank] : {std::pair{std::string("_couinaud"), 2}, std::pair{std::string("_liver"), 1}}) {
      if (!stem.ends_with(ending)) continue;
      stem.resize(stem.size() - ending.size());
      preferred = rank;
    }
    const auto found = best.find(stem);
    if (found == best.end() || found->second.first < preferred) best[stem] = {preferred, file};
  }
  std::vector<ShapesLiver> livers;
  for (const auto& [id, file] : best) livers.push_back({id, file.second, livers.size() % 2 == 0});
  return livers;
}

Result<ShapesStudy> run_shapes(const fs::path& folder, const fs::path& out, const ShapesOptions& options,
                               const Progress& progress) {
  std::vector<ShapesLiver> livers = shapes_livers(folder);
  if (options.judged == ShapesJudged::tuning)
    std::erase_if(livers, [](const auto& liver) { return !liver.for_tuning; });
  if (livers.empty()) {
    return failure(Error{"shapes-no-livers",
                         GLISSON_TEXT("The folder holds no label maps of livers."),
                         {},
                         GLISSON_TEXT("Give one with a file a liver, as ID_liver.nii.gz."),
                         folder});
  }
  const auto reference = shapes::reference_liver(options.reference_spacing_mm);
  if (!reference) return failure(reference.error());
  std::vector<BatchPatient> patients;
  std::string everything;
  for (const ShapesLiver& liver : livers) {
    const std::string fingerprint =
        fmt::format("{} {:g} {} {}", method, options.reference_spacing_mm, options.believe_unit_spacing,
                    sha256_of_file(liver.file).value_or("unreadable"));
    // A row without its surfaces is no row.
    std::error_code problem;
    if (!fs::exists(surface_file(out, "livers", liver.id), problem) ||
        !fs::exists(surface_file(out, "outlines", liver.id), problem)) {
      fs::remove(out / "patients" / (liver.id + ".json"), problem);
    }
    patients.push_back({liver.id, fingerprint});
    everything += liver.id + fingerprint + "\n";
  }
  std::error_code problem;
  for (const char* inner : {"livers", "outlines"}) fs::create_directories(out / inner, problem);
  ShapesStudy study;
  auto rows = run_batch(
      out, patients, [&](std::size_t p) { return correspond_liver(livers[p], out, *reference, options); },
      {options.only}, progress.part(0, 0.6));
  if (!rows) return failure(rows.error());
  study.livers = std::move(*rows);
  if (options.only) return study;

  std::vector<Surface> surfaces;
  std::vector<std::size_t> of_liver;
  for (std::size_t i = 0; i < study.livers.size(); ++i) {
    if (!study.livers[i].error.empty()) continue;
    auto surface = geometry::read_surface(surface_file(out, "livers", study.livers[i].id));
    if (!surface) return failure(surface.error());
    surfaces.push_back(std::move(*surface));
    of_liver.push_back(i);
  }
  study.used = surfaces.size();
  study.refused = study.livers.size() - study.used;
  const auto aligned = shapes::align_shapes(surfaces);
  if (!aligned) return failure(aligned.error());
  study.ranks = shapes::judge_ranks(*aligned, progress.part(0.6, 0.65));
  if (progress.cancelled()) return cancelled();
  const shapes::ShapeModel model = shapes::calibrated(shapes::model_of(*aligned, study.ranks.rank), study.ranks);
  study.specificity_mm = shapes::specificity_mm(model, *aligned);
  const Eigen::VectorXd mean = aligned->shapes_mm.rowwise().mean();
  for (Index i = 0; i < aligned->shapes_mm.cols(); ++i) {
    const Eigen::VectorXd off = aligned->shapes_mm.col(i) - mean;
    study.spread_mm += Eigen::Map<const Eigen::Matrix3Xd>(off.data(), 3, off.size() / 3).colwise().norm().mean() /
                       static_cast<double>(aligned->shapes_mm.cols());
  }

  std::vector<BatchPatient> judged;
  std::vector<std::size_t> judged_shape;
  const shapes::FitOptions& fit = options.fit;
  const std::string all_of = sha256_of_text(everything) + fmt::format(" {:g} {:g} {} {}", fit.noise_mm, fit.along_mm,
                                                                      fit.independent, fit.iterations);
  for (std::size_t s = 0; s < of_liver.size(); ++s) {
    const ShapesLiver& liver = livers[of_liver[s]];
    const bool wanted = options.judged == ShapesJudged::all || options.judged == ShapesJudged::tuning ||
                        (options.judged == ShapesJudged::judging && !liver.for_tuning);
    if (!wanted) continue;
    judged.push_back({liver.id, all_of});
    judged_shape.push_back(s);
  }
  if (!judged.empty()) {
    auto judged_rows = run_batch(
        out / "judged", judged,
        [&](std::size_t j) -> Result<NamedNumbers> {
          const auto outline = geometry::read_surface(surface_file(out, "outlines", judged[j].id));
          if (!outline) return failure(outline.error());
          return judge_liver(*aligned, study.ranks, static_cast<int>(judged_shape[j]), *outline,
                             surfaces[judged_shape[j]], fit);
        },
        {}, progress.part(0.65, 1));
    if (!judged_rows) return failure(judged_rows.error());
    study.judged = std::move(*judged_rows);
  }
  study.scores = {score_of(study.judged, "generalisation_mm", "a liver left out, from the model's nearest"),
                  score_of(study.judged, "dome_mm", "the upper third, completed from the rest"),
                  score_of(study.judged, "dome_sd_mm", "standard deviation that was said of it"),
                  score_of(study.judged, "dome_within_1_sd", "share of its points within one standard deviation", true),
                  score_of(study.judged, "dome_within_2_sd", "within 1.96 standard deviations", true),
                  score_of(study.judged, "dome_volume_percent", "error of the whole volume"),
                  score_of(study.judged, "tip_mm", "the lower third, completed from the rest"),
                  score_of(study.judged, "tip_sd_mm", "standard deviation that was said of it"),
                  score_of(study.judged, "tip_within_1_sd", "share of its points within one standard deviation", true),
                  score_of(study.judged, "tip_within_2_sd", "within 1.96 standard deviations", true),
                  score_of(study.judged, "tip_volume_percent", "error of the whole volume"),
                  score_of(study.judged, "dome_mean_square", "mean square of the modes' coefficients"),
                  score_of(study.judged, "dome_residual_mm", "left between what is seen and the model"),
                  score_of(study.judged, "dome_outside", "share refused as no liver of the model's"),
                  score_of(study.judged, "dome_mirrored_ratio",
                           "how much worse its mirror image fits; below 0.9 it is refused", true)};
  return write_together([&] {
           return shapes::write_model(out / "model.vtp", model)
               .and_then([&] { return write_batch_csv(out / "livers.csv", study.livers); })
               .and_then([&] { return write_batch_csv(out / "judged.csv", study.judged); })
               .and_then(
                   [&] { return write_text_file(out / "summary.json", summary_json(study, model).dump(2) + "\n"); });
         })
      .map([&] { return std::move(study); });
}

}  // namespace glisson::studies
