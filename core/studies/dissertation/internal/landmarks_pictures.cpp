#include "studies/dissertation/internal/landmarks_pictures.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

#include "casefile/result_folder.h"
#include "mechanics/elements/point_location.h"
#include "rehearsal/comparison.h"
#include "scene/case_scenes.h"
#include "scene/composite.h"
#include "studies/dissertation/real_livers.h"

namespace glisson::studies {
namespace fs = std::filesystem;
namespace {

using rehearsal::significant_mm;

constexpr int width_px = 900, height_px = 675;

std::vector<std::size_t> example_rows(const LandmarksSummary& summary, int count);
std::vector<std::size_t> rows_where_one_region_agrees(const LandmarksSummary& summary);
Result<void> draw_livers(const Subject& subject, const fs::path& folder, const fs::path& picture,
                         const LandmarksOptions& options);
Result<void> draw_beams(const BeamRow& beams, const fs::path& picture, const std::string& warning);

}  // namespace

Result<LandmarksPictures> draw_landmarks_pictures(const std::vector<Subject>& subjects, const fs::path& out,
                                                  const LandmarksSummary& summary, const LandmarksOptions& options) {
  const auto subject_of = [&](const BatchRow& row) {
    const auto subject = std::find_if(subjects.begin(), subjects.end(), [&](const auto& s) { return s.id == row.id; });
    GLISSON_ASSERT(subject != subjects.end());
    return *subject;
  };
  LandmarksPictures pictures;
  for (const std::size_t r : example_rows(summary, options.pictures)) {
    const BatchRow& row = summary.rows[r];
    const fs::path folder = out / "examples" / row.id;
    const fs::path picture = folder / "atlas-and-mre.png";
    const auto drawn = draw_livers(subject_of(row), folder, picture, options);
    if (!drawn) return failure(drawn.error());
    std::string apart = fmt::format("{:.1f} mm apart at the tool", column_of({row}, "atlas_near_tool_mm").front());
    for (const double mm : column_of({row}, "forks_max_mm")) apart += fmt::format(", a fork by {:.1f} mm", mm);
    pictures.between.push_back({picture, fmt::format("{}: {}; atlas in red, {} in blue", row.id, apart,
                                                     options.livers_seed ? "drawn stiffness" : "MRE")});
  }
  for (const std::size_t r : rows_where_one_region_agrees(summary)) {
    const BatchRow& row = summary.rows[r];
    const fs::path picture = out / "examples" / row.id / "beams.png";
    const auto drawn = read_subject(subject_of(row))
                           .and_then([&](const MeasuredLiver& liver) {
                             return beams_of(row.id, liver, column_of({row}, "mean_kPa").front(), options);
                           })
                           .and_then([&](const BeamRow& beams) { return draw_beams(beams, picture, options.warning); });
    if (!drawn) return failure(drawn.error());
    pictures.within.push_back({picture, row.id + ": beams of its soft, stiff and most uneven region, lifted"});
  }
  return pictures;
}

namespace {

// The patients of figure 4.12, by their landmark that is farthest off where there are any.
std::vector<std::size_t> example_rows(const LandmarksSummary& summary, int count) {
  std::vector<std::size_t> chosen;
  for (const std::string& id : (summary.groups.empty() ? summary.between : summary.groups)[1].examples) {
    if (static_cast<int>(chosen.size()) == count) break;
    const auto row = std::find_if(summary.rows.begin(), summary.rows.end(), [&](const auto& r) { return r.id == id; });
    chosen.push_back(static_cast<std::size_t>(row - summary.rows.begin()));
  }
  return chosen;
}

// The patients of figure 4.14: for each region the one in whom it alone agrees with the control, and the others are
// farthest from it. There may be none.
std::vector<std::size_t> rows_where_one_region_agrees(const LandmarksSummary& summary) {
  std::vector<std::size_t> chosen;
  for (std::size_t agrees = 0; agrees < region_columns.size(); ++agrees) {
    std::optional<std::size_t> best;
    double best_mm = significant_mm;
    for (std::size_t r = 0; r < summary.rows.size(); ++r) {
      if (!summary.rows[r].error.empty()) continue;
      std::array<double, region_columns.size()> apart_mm{};
      for (std::size_t k = 0; k < apart_mm.size(); ++k) {
        apart_mm[k] = column_of({summary.rows[r]}, fmt::format("{}_max_mm", region_columns[k])).front();
      }
      if (apart_mm[agrees] >= significant_mm) continue;
      const double others_mm = std::min(apart_mm[(agrees + 1) % 3], apart_mm[(agrees + 2) % 3]);
      if (others_mm < best_mm) continue;
      best = r;
      best_mm = others_mm;
    }
    if (best) chosen.push_back(*best);
  }
  return chosen;
}

// Where the simulation brings it, as the corners of each cell go.
geometry::Surface moved(geometry::Surface surface, const mechanics::Simulation& simulation) {
  const geometry::TetMesh& mesh = simulation.mesh;
  const geometry::Field* field = geometry::find_field(mesh.point_fields, mechanics::displacement_field);
  const std::vector<mechanics::PointInMesh> places = mechanics::locate_points(mesh, surface.points_mm);
  for (std::size_t p = 0; p < places.size(); ++p) {
    for (std::size_t c = 0; c < 4; ++c) {
      const int corner = mesh.cells[static_cast<std::size_t>(places[p].cell)][c];
      surface.points_mm[p] += places[p].barycentric[static_cast<Eigen::Index>(c)] *
                              Eigen::Map<const Eigen::Vector3d>(field->values.data() + 3 * std::ptrdiff_t{corner});
    }
  }
  return surface;
}

Result<void> draw_livers(const Subject& subject, const fs::path& folder, const fs::path& picture,
                         const LandmarksOptions& options) {
  const auto liver = read_subject(subject);
  if (!liver) return failure(liver.error());
  const auto vessels = vessels_of(subject);
  if (!vessels) return failure(vessels.error());
  RetractionOptions by_elements = options.retraction;
  by_elements.meshfree.reset();
  const auto retraction = retract(*liver, by_elements);
  if (!retraction) return failure(retraction.error());
  auto saved = casefile::write_result(folder / "measured", retraction->measured).and_then([&] {
    return casefile::write_result(folder / "atlas", retraction->reference);
  });
  if (!saved) return saved;
  const std::string own = subject.drawn ? "Drawn stiffness" : "MRE";
  auto scene = scene::comparison_scene(folder / "atlas", "Atlas", folder / "measured", own);
  if (!scene) return failure(scene.error());
  if (*vessels) {
    for (auto& [shown, simulation] :
         {std::pair<scene::Scene&, const mechanics::Simulation&>{scene->in_red, retraction->reference},
          {scene->in_blue, retraction->measured}}) {
      shown.surfaces.front().opacity = 0.25;
      scene::SurfaceItem item;
      item.name = "vessels";
      item.surface = std::make_shared<const geometry::Surface>(moved(**vessels, simulation));
      item.colour = {1, 1, 1};
      shown.surfaces.push_back(std::move(item));
    }
  }
  scene->in_blue.annotations.warning = options.warning;
  // The tool pulls to the front and the head, which is seen from the side.
  scene->in_blue.camera =
      scene::fit(scene->in_blue, scene::PatientView::right, static_cast<double>(width_px) / height_px);
  return scene::draw_red_blue(*scene, width_px, height_px).and_then([&](const scene::Picture& drawn) {
    return scene::write_png(drawn, picture);
  });
}

// One above the other, the length of each across the picture; from 0 to 1 cm, as figure 4.14 has it.
Result<void> draw_beams(const BeamRow& beams, const fs::path& picture, const std::string& warning) {
  scene::Scene scene;
  double below_mm = 0;
  for (std::size_t r = beams.regions.size(); r-- > 0;) {
    const BeamComparison& region = beams.regions[r];
    auto surface = std::make_shared<geometry::Surface>(region.lifted);
    const geometry::Box box = geometry::bounding_box(surface->points_mm);
    for (Eigen::Vector3d& point : surface->points_mm) point.z() += below_mm - box.min_mm.z();
    const double height_mm = box.max_mm.z() - box.min_mm.z();
    scene.landmarks.push_back({fmt::format("{}: {:.1f} mm", region_names[r], region.max_mm),
                               {-40, 5, below_mm + 0.5 * height_mm},
                               0.5,
                               {0.9, 0.9, 0.9}});
    below_mm += height_mm + 12;
    scene::SurfaceItem item;
    item.name = region_names[r];
    item.surface = std::move(surface);
    item.colouring =
        scene::Colouring{"apart_mm", scene::ColourMap::viridis, {0, 10}, r == 0 ? "From the liver's mean (mm)" : ""};
    scene.surfaces.push_back(std::move(item));
  }
  scene.annotations.orientation = scene::Annotations::Orientation::hidden;
  scene.annotations.title = beams.patient;
  scene.annotations.subtitle = fmt::format("A beam of its mean is lifted {:.1f} mm", beams.control_displacement_mm);
  scene.annotations.warning = warning;
  scene.camera = scene::fit(scene, scene::PatientView::anterior, static_cast<double>(width_px) / height_px);
  return scene::draw(scene, width_px, height_px).and_then([&](const scene::Picture& drawn) {
    return scene::write_png(drawn, picture);
  });
}

}  // namespace
}  // namespace glisson::studies
