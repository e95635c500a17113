#include "shapes/find_liver.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

#include "anatomy/level_surface.h"
#include "base/parallel.h"
#include "geometry/nearest.h"
#include "imaging/filters.h"
#include "segmentation/grid_part.h"
#include "segmentation/rasterise.h"
#include "segmentation/resample.h"
#include "segmentation/signed_distance.h"
#include "segmentation/structures.h"
#include "segmentation/unsure_border.h"
#include "segmentation/working_grid.h"
#include "shapes/completion.h"

namespace glisson::shapes {
namespace {

using Eigen::Vector3d;
using geometry::Surface;
using segmentation::ExpectedBorder;
using segmentation::GivenPoints;

// The image in blocks, as far as the placed liver reaches, smoothed; what is no number is as dark as the darkest.
imaging::Volume working_part(const imaging::Volume& image, const Surface& placed, double spacing_mm,
                             double smoothing_mm);

// The model's deviation at each point and `more_mm` together.
ExpectedBorder expected_border(const Surface& surface, const std::vector<double>& sd_mm, double more_mm);

// The model's surface moved along its normals to the borders that the image shows by itself; the rest left out.
struct BorderSeen {
  Surface surface;
  double fraction = 0;  // of the model's points that lie in the image
};
BorderSeen border_seen(const Surface& shape, const imaging::Image<float>& outside, double reach_mm, double clear);
// How far along the normal the best border from inside to outside lies: what is within looks like the organ, and what
// is beyond otherwise, both by `clear` on average. Nearer is better.
std::optional<double> border_along(const imaging::Image<float>& outside, const Vector3d& from_mm,
                                   const Vector3d& normal, double reach_mm, double clear);

// The shape as it follows the image.
struct Following {
  Surface shape;  // with the point field "sd_mm" once it was fitted
  ShapeFit fit;
  FitOptions fitting;  // with the pose of the fit before
  double seen_fraction = 0;
};
Result<void> fit_to_borders(const ShapeModel& model, const imaging::Image<float>& outside,
                            const FindOptions::Round& round, const FindOptions& options, Following& following,
                            const Progress& progress);

// All that the rounds begin with.
struct Start {
  Placing placing;
  imaging::Volume working;
  ExpectedBorder expected;  // about the shape placed
  segmentation::OrganBrightness organ;
};
Result<Start> start_of(const imaging::Volume& image, const ShapeModel& model, const std::vector<Vector3d>& seeds_mm,
                       const FindOptions& options, const Progress& progress);

struct Followed {
  FoundLiver found;
  ExpectedBorder expected;  // about the shape that was fitted
  imaging::Mask outline;    // on the working grid
};
// What is liver is learnt at first from `outline`, on the working grid; without one, from how bright the liver is.
Result<Followed> followed(const imaging::Volume& image, const ShapeModel& model, const std::vector<Vector3d>& seeds_mm,
                          const Start& start, std::optional<imaging::Mask> outline, const FindOptions& options,
                          const Progress& progress);

// In the thickest part of what was found, where it is as bright as the organ; none where it nowhere is.
std::optional<Vector3d> point_inside(const Followed& followed, const Start& start);
// As much of what grew as a liver placed there can hold.
imaging::Mask held_by(const Start& start, const imaging::Mask& grown, const FindOptions& options);

// By the shape alone, and with what grew: from the points or, without any, from one inside of what the shape alone
// gives. Of all the one whose border is surest.
Result<FoundLiver> found_by_shape(const imaging::Volume& image, const ShapeModel& model,
                                  const std::vector<Vector3d>& seeds_mm, std::optional<segmentation::GrowResult> grown,
                                  const FindOptions& options, const Progress& progress);
// The share of an outline's border that cannot be seen or, with a shape, that this expects elsewhere.
double unsure_share(const imaging::Mask& outline, const imaging::Volume& image, const Start& start,
                    const ExpectedBorder* expected = nullptr);

}  // namespace

Result<FoundLiver> find_liver(const imaging::Volume& image, const ShapeModel& model, const GivenPoints& points,
                              const FindOptions& options, const Progress& progress) {
  if (auto checked = segmentation::check_points(image, points); !checked) return failure(checked.error());
  std::optional<segmentation::GrowResult> grown;
  if (!points.inside_mm.empty()) {
    auto growth = segmentation::grow_from_seeds(image, points.inside_mm, {}, progress.part(0, 0.2));
    if (growth) grown = *std::move(growth);
  }
  if (progress.cancelled()) return cancelled();
  auto found = found_by_shape(image, model, points.inside_mm, grown, options, progress.part(0.2, 1));
  if (progress.cancelled()) return cancelled();
  if (!found) {
    if (!grown) return found;
    found = FoundLiver{*std::move(grown), true, {}, 0, 0};
  }
  if (!points.outside_mm.empty()) {
    found->liver.mask = segmentation::taken_off(std::move(found->liver.mask), image, points);
    found->liver.volume_ml = segmentation::volume_ml(found->liver.mask);
  }
  return found;
}

namespace {

Result<FoundLiver> found_by_shape(const imaging::Volume& image, const ShapeModel& model,
                                  const std::vector<Vector3d>& seeds_mm, std::optional<segmentation::GrowResult> grown,
                                  const FindOptions& options, const Progress& progress) {
  auto start = start_of(image, model, seeds_mm, options, progress.part(0, 0.3));
  if (!start) return failure(start.error());
  const auto found_of = [](Followed&& followed) { return std::move(followed.found); };
  // A shape that is placed badly holds much else than what grew.
  if (grown) start->organ.sd = std::min(start->organ.sd, grown->tissue_sd);
  auto best = followed(image, model, seeds_mm, *start, {}, options, progress.part(0.3, 0.6));
  if (progress.cancelled()) return cancelled();
  if (!grown && best) {
    if (const auto inside_mm = point_inside(*best, *start)) {
      auto growth = segmentation::grow_from_seeds(image, {*inside_mm}, {}, progress.part(0.6, 0.7));
      if (growth) grown = *std::move(growth);
    }
  }
  if (!grown || progress.cancelled()) return std::move(best).map(found_of);
  auto other =
      followed(image, model, seeds_mm, *start, held_by(*start, grown->mask, options), options, progress.part(0.7, 1));
  if (!other) return std::move(best).map(found_of);
  // Each lies where its own shape expects it: what the image shows tells which is better.
  const auto seen_less = [&](const FoundLiver& found) { return unsure_share(found.liver.mask, image, *start); };
  if (!best || seen_less(other->found) < seen_less(best->found)) best = std::move(other);
  // A growth that leaked ends at borders that are seen well, where no shape expects them.
  if (unsure_share(grown->mask, image, *start, &best->expected) <
      unsure_share(best->found.liver.mask, image, *start, &best->expected)) {
    best->found.liver = *std::move(grown);
    best->found.by_brightness_alone = true;
  }
  return std::move(best).map(found_of);
}

std::optional<Vector3d> point_inside(const Followed& followed, const Start& start) {
  const std::vector<float> depth_mm = segmentation::signed_distances_mm(followed.outline);
  std::optional<std::size_t> deepest;
  for (std::size_t voxel = 0; voxel < depth_mm.size(); ++voxel) {
    const double off = static_cast<double>(start.working.values[voxel]) - start.organ.mean;
    if (followed.outline.values[voxel] == 0 || std::abs(off) > start.organ.sd) continue;
    if (!deepest || depth_mm[voxel] < depth_mm[*deepest]) deepest = voxel;
  }
  if (!deepest) return std::nullopt;
  const imaging::Grid& grid = followed.outline.grid;
  const auto nx = static_cast<std::size_t>(grid.size[0]), ny = static_cast<std::size_t>(grid.size[1]);
  return grid.position_mm(static_cast<int>(*deepest % nx), static_cast<int>(*deepest / nx % ny),
                          static_cast<int>(*deepest / (nx * ny)));
}

Result<Start> start_of(const imaging::Volume& image, const ShapeModel& model, const std::vector<Vector3d>& seeds_mm,
                       const FindOptions& options, const Progress& progress) {
  auto placing = place_model(image, model, seeds_mm, options.placing, progress);
  if (!placing) return failure(placing.error());
  Start start{*std::move(placing), {}, {}, {}};
  const Surface& placed = start.placing.surface;
  start.working = working_part(image, placed, options.working_spacing_mm, options.smoothing_mm);
  start.expected = expected_border(placed, std::vector<double>(placed.points_mm.size(), options.placing_sd_mm), 0);
  const auto organ = segmentation::brightness_of(start.working, start.expected, seeds_mm);
  if (!organ) return failure(organ.error());
  start.organ = *organ;
  return start;
}

double unsure_share(const imaging::Mask& outline, const imaging::Volume& image, const Start& start,
                    const ExpectedBorder* expected) {
  segmentation::UnsureBorderOptions looking;
  looking.expected = expected;
  return segmentation::unsure_border(outline, image, start.organ.mean, start.organ.sd, looking).share;
}

Result<Followed> followed(const imaging::Volume& image, const ShapeModel& model, const std::vector<Vector3d>& seeds_mm,
                          const Start& start, std::optional<imaging::Mask> outline, const FindOptions& options,
                          const Progress& progress) {
  Following following{start.placing.surface, {}, options.fit, 0};
  following.fitting.pose = Eigen::Isometry3d(Eigen::Translation3d(start.placing.shift_mm));
  ExpectedBorder expected;
  for (std::size_t round = 0; round < options.rounds.size(); ++round) {
    progress.report(0.8 * static_cast<double>(round) / static_cast<double>(options.rounds.size()),
                    GLISSON_TEXT("Fitting the shape to the image"));
    const imaging::Image<float> outside =
        segmentation::outside_ratio(start.working, start.organ, outline ? &*outline : nullptr, options.cut);
    if (auto fitted = fit_to_borders(model, outside, options.rounds[round], options, following, progress); !fitted) {
      return failure(fitted.error());
    }
    expected = expected_border(following.shape, geometry::find_field(following.shape.point_fields, "sd_mm")->values,
                               options.rounds[round].more_mm);
    outline = segmentation::cut_by_shape(outside, expected, seeds_mm, options.cut);
  }
  if (auto inside = check_inside(model, following.fit); !inside) return failure(inside.error());
  if (progress.cancelled()) return cancelled();
  progress.report(0.85, GLISSON_TEXT("Smoothing the outline"));
  FoundLiver found;
  found.liver = segmentation::finished_by_shape(*outline, image, expected, start.organ, seeds_mm, options.cut);
  found.liver.rounds = static_cast<int>(options.rounds.size());
  found.fit = std::move(following.fit);
  found.placing_score = start.placing.score;
  found.seen_fraction = following.seen_fraction;
  progress.report(1, GLISSON_TEXT("Smoothing the outline"));
  return Followed{std::move(found), std::move(expected), *std::move(outline)};
}

imaging::Mask held_by(const Start& start, const imaging::Mask& grown, const FindOptions& options) {
  constexpr float farthest_mm = 20;  // from the shape placed
  const imaging::Image<float> level{grown.grid, {grown.values.begin(), grown.values.end()}};
  const imaging::Grid& grid = start.working.grid;
  const imaging::Image<float> share =
      segmentation::resample(segmentation::block_means(level.grid, level.values,
                                                       segmentation::blocks_of(level.grid, options.working_spacing_mm)),
                             grid);
  const imaging::Image<float> from_shape_mm = segmentation::resample(start.expected.distance_mm, grid);
  imaging::Mask held{grid, std::vector<std::uint8_t>(grid.voxels())};
  for (std::size_t voxel = 0; voxel < held.values.size(); ++voxel) {
    held.values[voxel] = share.values[voxel] >= 0.5F && from_shape_mm.values[voxel] < farthest_mm ? 1 : 0;
  }
  return held;
}

Result<void> fit_to_borders(const ShapeModel& model, const imaging::Image<float>& outside,
                            const FindOptions::Round& round, const FindOptions& options, Following& following,
                            const Progress& progress) {
  BorderSeen seen;
  for (const double reach_mm : round.reaches_mm) {
    if (progress.cancelled()) return cancelled();
    if (!seen.surface.points_mm.empty()) {
      auto fit = fit_model(model, seen.surface, following.fitting);
      if (!fit) return failure(fit.error());
      following.shape = std::move(fit->surface);
      following.fitting.pose = fit->pose;
    }
    seen = border_seen(following.shape, outside, reach_mm, options.clear);
    if (seen.fraction < options.minimum_seen) {
      return failure(
          no_liver_found(GLISSON_TEXT("The image hardly shows a border where the model expects the liver's.")));
    }
  }
  auto completed = complete(model, seen.surface, following.fitting);
  if (!completed) return failure(completed.error());
  following.seen_fraction = seen.fraction;
  following.fit = std::move(completed->fit);
  following.fitting.pose = following.fit.pose;
  following.shape = std::move(completed->surface);
  return {};
}

imaging::Volume working_part(const imaging::Volume& image, const Surface& placed, double spacing_mm,
                             double smoothing_mm) {
  constexpr double around_mm = 45;
  const imaging::Image<float> working =
      segmentation::block_means(image.grid, image.values, segmentation::blocks_of(image.grid, spacing_mm));
  imaging::Volume part{
      segmentation::cut_out<float>(working, segmentation::part_around(placed.points_mm, around_mm, working.grid)),
      image.unit};
  float lowest = std::numeric_limits<float>::infinity();
  for (const float value : part.values) lowest = std::isfinite(value) ? std::min(lowest, value) : lowest;
  for (float& value : part.values) value = std::isfinite(value) ? value : lowest;
  part.values = imaging::gaussian_blur(std::move(part.values), part.grid, smoothing_mm);
  return part;
}

ExpectedBorder expected_border(const Surface& surface, const std::vector<double>& sd_mm, double more_mm) {
  constexpr double spacing_mm = 5, around_mm = 40, near_mm = 20;
  geometry::Box box = geometry::bounding_box(surface.points_mm);
  box.min_mm.array() -= around_mm;
  box.max_mm.array() += around_mm;
  const imaging::Mask mask = segmentation::rasterise(surface, anatomy::grid_over(box, spacing_mm));
  const std::vector<float> to_other_side_mm = segmentation::signed_distances_mm(mask);
  const geometry::SurfaceDistance to_surface(surface);
  const double typical_sd_mm =
      std::accumulate(sd_mm.begin(), sd_mm.end(), 0.0) / static_cast<double>(std::max<std::size_t>(sd_mm.size(), 1));
  const std::size_t voxels = mask.values.size();
  ExpectedBorder expected{{mask.grid, std::vector<float>(voxels)}, {mask.grid, std::vector<float>(voxels)}};
  const auto rows = static_cast<std::size_t>(mask.grid.size[1]) * static_cast<std::size_t>(mask.grid.size[2]);
  parallel_for(rows, 16, [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row) {
      const int j = static_cast<int>(row) % mask.grid.size[1], k = static_cast<int>(row) / mask.grid.size[1];
      for (int i = 0; i < mask.grid.size[0]; ++i) {
        const std::size_t voxel = mask.grid.offset(i, j, k);
        const float sign = mask.values[voxel] != 0 ? -1.0F : 1.0F;
        const float rough_mm = std::abs(to_other_side_mm[voxel]) - static_cast<float>(spacing_mm) / 2;
        expected.distance_mm.values[voxel] = sign * rough_mm;
        expected.sd_mm.values[voxel] = static_cast<float>(std::hypot(typical_sd_mm, more_mm));
        if (rough_mm > near_mm) continue;
        const auto closest = to_surface.closest(mask.grid.position_mm(i, j, k));
        expected.distance_mm.values[voxel] = sign * static_cast<float>(closest.distance_mm);
        double sd = 0;
        for (const int point : surface.triangles[static_cast<std::size_t>(closest.triangle)]) {
          sd += sd_mm[static_cast<std::size_t>(point)] / 3;
        }
        expected.sd_mm.values[voxel] = static_cast<float>(std::hypot(sd, more_mm));
      }
    }
  });
  return expected;
}

std::optional<double> border_along(const imaging::Image<float>& outside, const Vector3d& from_mm,
                                   const Vector3d& normal, double reach_mm, double clear) {
  constexpr double step_mm = 1.5, beside_mm = 9;
  const auto beside = static_cast<int>(beside_mm / step_mm), reach = static_cast<int>(reach_mm / step_mm);
  const int inmost = 2 * reach;  // a lobe may end far before the model's
  const imaging::Grid& grid = outside.grid;
  const Vector3d start = grid.index_of(from_mm), step = grid.index_of(from_mm + step_mm * normal) - start;
  const Vector3d last(grid.size[0] - 1, grid.size[1] - 1, grid.size[2] - 1);
  // Sums from the innermost sample on; none of a sample beside the image.
  std::vector<double> sums{0};
  std::vector<int> missing{0};
  for (int n = -inmost - beside; n < reach + beside; ++n) {
    const Vector3d at = start + (n + 0.5) * step;
    const bool there = (at.array() >= 0).all() && (at.array() <= last.array()).all();
    sums.push_back(sums.back() + (there ? segmentation::value_between(outside, at) : 0.0));
    missing.push_back(missing.back() + (there ? 0 : 1));
  }
  std::optional<double> best_mm;
  double best = -std::numeric_limits<double>::infinity();
  for (int n = -inmost; n <= reach; ++n) {
    const auto at = static_cast<std::size_t>(n + inmost + beside), few = static_cast<std::size_t>(beside);
    const int inner = beside - (missing[at] - missing[at - few]), outer = beside - (missing[at + few] - missing[at]);
    if (2 * std::min(inner, outer) < beside) continue;
    const double within = (sums[at - few] - sums[at]) / inner, beyond = (sums[at + few] - sums[at]) / outer;
    const double off = (n < 0 ? 1 : 2) * n / static_cast<double>(reach);  // the reach is two deviations
    const double score = within + beyond - 0.5 * off * off;
    if (!(within > clear && beyond > clear && score > best)) continue;
    best = score;
    best_mm = n * step_mm;
  }
  return best_mm;
}

BorderSeen border_seen(const Surface& shape, const imaging::Image<float>& outside, double reach_mm, double clear) {
  const std::vector<Vector3d> normals = geometry::point_normals(shape);
  BorderSeen seen{shape, 0};
  std::vector<std::uint8_t> is_seen(shape.points_mm.size()), in_image(shape.points_mm.size());
  const Vector3d last(outside.grid.size[0] - 1, outside.grid.size[1] - 1, outside.grid.size[2] - 1);
  parallel_for(shape.points_mm.size(), 64, [&](std::size_t begin, std::size_t end) {
    for (std::size_t p = begin; p < end; ++p) {
      const Vector3d index = outside.grid.index_of(shape.points_mm[p]);
      in_image[p] = (index.array() >= 0).all() && (index.array() <= last.array()).all();
      const auto along_mm = border_along(outside, shape.points_mm[p], normals[p], reach_mm, clear);
      if (!along_mm) continue;
      seen.surface.points_mm[p] += *along_mm * normals[p];
      is_seen[p] = 1;
    }
  });
  std::erase_if(seen.surface.triangles, [&](const std::array<int, 3>& triangle) {
    return std::any_of(triangle.begin(), triangle.end(),
                       [&](int point) { return is_seen[static_cast<std::size_t>(point)] == 0; });
  });
  const auto count = [](const std::vector<std::uint8_t>& flags) {
    return static_cast<double>(std::count(flags.begin(), flags.end(), std::uint8_t{1}));
  };
  seen.fraction = count(is_seen) / std::max(1.0, count(in_image));
  // Points that no triangle uses would count as seen.
  std::vector<int> number(is_seen.size(), -1);
  std::vector<Vector3d> points_mm;
  for (auto& triangle : seen.surface.triangles) {
    for (int& point : triangle) {
      int& name = number[static_cast<std::size_t>(point)];
      if (name < 0) {
        name = static_cast<int>(points_mm.size());
        points_mm.push_back(seen.surface.points_mm[static_cast<std::size_t>(point)]);
      }
      point = name;
    }
  }
  seen.surface.points_mm = std::move(points_mm);
  return seen;
}

}  // namespace
}  // namespace glisson::shapes
