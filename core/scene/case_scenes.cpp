#include "scene/case_scenes.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <algorithm>
#include <cmath>
#include <functional>

#include "casefile/model_upkeep.h"
#include "casefile/result_folder.h"
#include "casefile/structure_landmarks.h"
#include "casefile/structures.h"
#include "geometry/mesh_file.h"
#include "mechanics/elements/point_location.h"
#include "scene/anatomy.h"
#include "scene/internal/slices.h"

namespace glisson::scene {
namespace fs = std::filesystem;
namespace {

using segmentation::Structure;

constexpr Colour ivory{0.96, 0.93, 0.85};
constexpr Colour flag_orange{1.0, 0.55, 0.1};
constexpr Colour tool_blue{0.35, 0.75, 1.0};

Result<Scene> anatomy_scene(const casefile::Case& patient);
Result<Scene> liver_scene(const casefile::Case& patient);
Result<Scene> stiffness_scene(const casefile::Case& patient);
Result<Scene> waves_scene(const casefile::Case& patient);
Result<Scene> confidence_scene(const casefile::Case& patient);
Result<Scene> model_scene(const casefile::Case& patient);
Result<Scene> resection_scene(const casefile::Case& patient);

// A result with what its case adds to the picture.
struct ShownResult {
  rehearsal::ComparedResult result;
  std::vector<Eigen::Vector3d> displacement_mm;  // one a mesh point
  std::optional<casefile::Case> patient;
};
Result<ShownResult> read_shown_result(const fs::path& folder);
Result<Scene> moved_organ(const ShownResult& shown);
void add_landmarks_and_tools(Scene& scene, const ShownResult& shown);
double round_up(double value);

}  // namespace

const std::vector<std::string>& case_scene_names() {
  static const std::vector<std::string> names{"anatomy", "liver", "stiffness", "model"};
  return names;
}

const std::vector<std::string>& wave_scene_names() {
  static const std::vector<std::string> names{"waves", "confidence"};
  return names;
}

Result<Scene> case_scene(const casefile::Case& patient, const std::string& name) {
  Result<Scene> scene = failure(Error{"scene-unknown",
                                      GLISSON_TEXT("A case has no scene named {0}; it has {1}."),
                                      {name, fmt::format("{}, {}, {}", fmt::join(case_scene_names(), ", "),
                                                         fmt::join(wave_scene_names(), ", "), resection_scene_name)},
                                      {},
                                      {}});
  if (name == "anatomy") scene = anatomy_scene(patient);
  if (name == "liver") scene = liver_scene(patient);
  if (name == "stiffness") scene = stiffness_scene(patient);
  if (name == "model") scene = model_scene(patient);
  if (name == resection_scene_name) scene = resection_scene(patient);
  if (name == "waves") scene = waves_scene(patient);
  if (name == "confidence") scene = confidence_scene(patient);
  if (scene) scene->annotations.warning = warning_of(patient);
  return scene;
}

Result<Scene> result_scene(const fs::path& result_folder) {
  const auto shown = read_shown_result(result_folder);
  if (!shown) return failure(shown.error());
  auto scene = moved_organ(*shown);
  if (!scene) return scene;

  SurfaceItem& liver = scene->surfaces.front();
  double largest = 0;
  for (const Eigen::Vector3d& u : shown->displacement_mm) largest = std::max(largest, u.norm());
  liver.finish = Finish::solid;
  liver.opacity = 0.55;
  liver.colouring = Colouring{"displacement_mm", ColourMap::viridis, {0, round_up(largest)}, "Displacement (mm)"};
  add_landmarks_and_tools(*scene, *shown);
  scene->annotations.title = "Displacement under the tool";
  return scene;
}

Result<Comparison> comparison_scene(const fs::path& in_red, const std::string& red_label, const fs::path& in_blue,
                                    const std::string& blue_label) {
  Comparison comparison;
  comparison.red_label = red_label;
  comparison.blue_label = blue_label;
  comparison.agreement_label = "Both agree";
  for (auto& [folder, scene] : {std::pair<const fs::path&, Scene&>{in_red, comparison.in_red},
                                std::pair<const fs::path&, Scene&>{in_blue, comparison.in_blue}}) {
    const auto shown = read_shown_result(folder);
    if (!shown) return failure(shown.error());
    auto moved = moved_organ(*shown);
    if (!moved) return failure(moved.error());
    scene = std::move(*moved);
    // Only brightness counts in the composite: bright vessels stand out of a dim organ.
    for (SurfaceItem& item : scene.surfaces) item.colour = Colour{1, 1, 1};
    scene.surfaces.front().opacity = 0.6;
    scene.annotations.title = red_label + " against " + blue_label;
  }
  return comparison;
}

std::string warning_of(const casefile::Case& patient) {
  return patient.origin().empty() ? std::string() : patient.origin() + "; not a medical device";
}

namespace {

const Structure* find_liver(const std::vector<Structure>& structures) {
  return !structures.empty() && structures.front().name == "liver" ? &structures.front() : nullptr;
}

// Where to cut: through the middle of the liver, else of the volume.
Eigen::Vector3d middle(const imaging::Volume& volume, const std::vector<Structure>& structures) {
  if (const Structure* liver = find_liver(structures)) {
    const auto found = segmentation::pieces(liver->mask);
    if (!found.empty()) return found.front().centroid_mm;
  }
  const auto& size = volume.grid.size;
  return volume.grid.position_mm(Eigen::Vector3d(size[0] - 1, size[1] - 1, size[2] - 1) / 2);
}

void add_outlines(SliceItem& slice, std::vector<Structure>& structures) {
  for (Structure& structure : structures) slice.masks.push_back(outline_of(std::move(structure)));
}

// A transverse slice that fills the picture's height with the volume's depth from front to back.
Scene slice_scene(SliceItem slice, const imaging::Grid& framed) {
  Scene scene;
  std::vector<Eigen::Vector3d> corners;
  corners.reserve(8);
  for (int corner = 0; corner < 8; ++corner) {
    corners.push_back(framed.position_mm(corner & 1 ? framed.size[0] : 0, corner & 2 ? framed.size[1] : 0,
                                         corner & 4 ? framed.size[2] : 0));
  }
  const geometry::Box box = geometry::bounding_box(corners);
  Eigen::Vector3d focus = box.center_mm();
  focus.z() = slice.center_mm.z();
  scene.camera = look_at_slice(focus, Eigen::Vector3d::UnitZ(), (box.max_mm - box.min_mm).y() * 1.05);
  scene.slices.push_back(std::move(slice));
  scene.annotations.orientation = Annotations::Orientation::letters;
  return scene;
}

Result<Scene> anatomy_scene(const casefile::Case& patient) {
  auto volume = patient.volume("volumes/anatomy");
  if (!volume) return failure(volume.error());
  auto structures = casefile::read_structures(patient);
  if (!structures) return failure(structures.error());

  SliceItem slice;
  slice.center_mm = middle(*volume, *structures);
  slice.volume = std::make_shared<const imaging::Volume>(std::move(*volume));
  set_grey_window(slice);
  add_outlines(slice, *structures);
  const imaging::Grid framed = slice.volume->grid;
  Scene scene = slice_scene(std::move(slice), framed);
  scene.annotations.title = "Anatomy and structures";
  return scene;
}

// A map in the slice through the middle of the liver, in the anatomy's frame. What the caller sets of the slice is how
// the map is coloured.
Result<Scene> map_scene(const casefile::Case& patient, const std::string& id, const std::string& title,
                        const std::function<void(SliceItem&)>& colour) {
  auto map = patient.volume(id);
  if (!map) return failure(map.error());
  const auto anatomy = patient.volume("volumes/anatomy");
  auto structures = casefile::read_structures(patient);
  if (!structures) return failure(structures.error());

  SliceItem slice;
  slice.center_mm = middle(*map, *structures);
  const imaging::Grid framed = anatomy ? anatomy->grid : map->grid;
  slice.volume = std::make_shared<const imaging::Volume>(std::move(*map));
  colour(slice);
  add_outlines(slice, *structures);
  Scene scene = slice_scene(std::move(slice), framed);
  scene.annotations.title = title;
  return scene;
}

Result<Scene> stiffness_scene(const casefile::Case& patient) {
  return map_scene(patient, "volumes/stiffness", "Stiffness from MR elastography", [](SliceItem& slice) {
    slice.window_center = 4.0;  // 0 to 8 kPa: the scale that clinical liver elastograms are shown on
    slice.window_width = 8.0;
    slice.map = ColourMap::viridis;
    slice.legend_title = "Shear stiffness (kPa)";
  });
}

Result<Scene> waves_scene(const casefile::Case& patient) {
  return map_scene(patient, "volumes/shear-wave", "Shear waves", [](SliceItem& slice) {
    set_grey_window(slice);
    // Rest is the middle grey.
    const double swing = std::max(std::abs(slice.window_center - 0.5 * slice.window_width),
                                  std::abs(slice.window_center + 0.5 * slice.window_width));
    slice.window_center = 0;
    slice.window_width = 2 * round_up(swing);
    slice.legend_title = "Motion (rad)";
  });
}

Result<Scene> confidence_scene(const casefile::Case& patient) {
  return map_scene(patient, "volumes/confidence", "Confidence of the stiffness", [](SliceItem& slice) {
    const auto& values = slice.volume->values;
    // A scanner's own map may be a percentage or count to 999.
    const float largest = *std::max_element(values.begin(), values.end());
    slice.window_width = largest > 1 ? round_up(static_cast<double>(largest)) : 1.0;
    slice.window_center = 0.5 * slice.window_width;
    slice.map = ColourMap::cividis;
    slice.legend_title = "Confidence";
  });
}

SurfaceItem surface_item(const std::string& name, geometry::Surface surface) {
  const Appearance look = appearance_of(name);
  return {name, std::make_shared<const geometry::Surface>(std::move(surface)), look.colour, look.opacity, look.finish,
          {}};
}

Result<Scene> liver_scene(const casefile::Case& patient) {
  Scene scene;
  for (const casefile::Entry& entry : patient.entries()) {
    if (!entry.id.starts_with("surfaces/")) continue;
    auto surface = geometry::read_surface(patient.folder() / entry.file);
    if (!surface) return failure(surface.error());
    scene.surfaces.push_back(surface_item(entry.id.substr(9), std::move(*surface)));
    if (scene.surfaces.back().name == "liver") scene.surfaces.back().finish = Finish::glass;
  }
  if (scene.surfaces.empty()) return failure(patient.file_of("surfaces/liver").error());
  scene.annotations.title = "Liver, tumours and vessels";
  return scene;
}

Result<Scene> resection_scene(const casefile::Case& patient) {
  auto scene = liver_scene(patient);
  if (!scene) return scene;
  auto cut = geometry::read_surface(patient.folder() / "results" / "resection" / "cut.vtp");
  if (!cut) return failure(Error{cut.error()}.with_hint(GLISSON_TEXT("Plan a resection first, and save it.")));
  constexpr Colour of_the_cut{0.56, 0.85, 0.58};
  scene->surfaces.push_back(
      {"cut", std::make_shared<const geometry::Surface>(*std::move(cut)), of_the_cut, 0.9, Finish::solid, {}});
  scene->annotations.title = "The planned cut";
  return scene;
}

Result<Scene> model_scene(const casefile::Case& patient) {
  const auto mesh =
      patient.file_of("meshes/model").and_then([](const fs::path& file) { return geometry::read_tetrahedra(file); });
  if (!mesh) return failure(mesh.error());
  geometry::Surface boundary = geometry::boundary_surface(*mesh);
  const geometry::Field* youngs = geometry::find_field(mesh->cell_fields, mechanics::youngs_modulus_field);
  const geometry::Field* behind = geometry::find_field(boundary.cell_fields, "mesh_cell");
  GLISSON_ASSERT(youngs && behind);
  geometry::Field colour{mechanics::youngs_modulus_field, 1, {}};
  for (const double cell : behind->values) colour.values.push_back(youngs->values[static_cast<std::size_t>(cell)]);
  std::vector<double> sorted = colour.values;
  std::sort(sorted.begin(), sorted.end());
  const double high = round_up(sorted[sorted.size() * 98 / 100]);
  geometry::set_field(boundary.cell_fields, std::move(colour));

  Scene scene;
  SurfaceItem item = surface_item("liver", std::move(boundary));
  item.finish = Finish::solid;
  item.opacity = 1;
  item.colouring = Colouring{mechanics::youngs_modulus_field, ColourMap::viridis, {0, high}, "Young's modulus (kPa)"};
  scene.surfaces.push_back(std::move(item));
  const bool assumed = casefile::assumed_stiffness(patient).has_value();
  scene.annotations.title = assumed ? "The model's stiffness: assumed" : "The model's stiffness";
  return scene;
}

Result<ShownResult> read_shown_result(const fs::path& folder) {
  auto result = casefile::read_result(folder);
  if (!result) return failure(result.error());
  const geometry::Field* field = geometry::find_field(result->mesh.point_fields, "displacement_mm");
  if (!field || field->components != 3) {
    return failure(Error{
        "not-a-result", GLISSON_TEXT("{0} has no displacement."), {(folder / "result.vtu").string()}, {}, folder});
  }
  ShownResult shown;
  for (std::size_t p = 0; p < field->items(); ++p) shown.displacement_mm.emplace_back(&field->values[3 * p]);
  shown.result = std::move(*result);
  // CASE.glisson/results/NAME: the case has the surfaces of the structures.
  std::error_code problem;
  const fs::path above = fs::absolute(folder, problem).lexically_normal().parent_path().parent_path();
  if (fs::exists(above / "case.json", problem)) {
    auto patient = casefile::Case::open(above);
    if (!patient) return failure(patient.error());
    shown.patient = std::move(*patient);
  }
  return shown;
}

// The displacement of the body at a place in it.
Eigen::Vector3d displacement_at(const mechanics::PointInMesh& place, const ShownResult& shown) {
  Eigen::Vector3d u = Eigen::Vector3d::Zero();
  const auto& cell = shown.result.mesh.cells[static_cast<std::size_t>(place.cell)];
  for (int corner = 0; corner < 4; ++corner) {
    u += place.barycentric[corner] * shown.displacement_mm[static_cast<std::size_t>(cell[corner])];
  }
  return u;
}

// Carries a surface with the body around it, and keeps how far each point went as a field.
geometry::Surface moved(geometry::Surface surface, const ShownResult& shown) {
  const auto places = mechanics::locate_points(shown.result.mesh, surface.points_mm);
  geometry::Field field{"displacement_mm", 1, std::vector<double>(surface.points_mm.size())};
  for (std::size_t p = 0; p < places.size(); ++p) {
    const Eigen::Vector3d u = displacement_at(places[p], shown);
    surface.points_mm[p] += u;
    field.values[p] = u.norm();
  }
  geometry::set_field(surface.point_fields, std::move(field));
  return surface;
}

// The liver first, then the structures in it.
Result<Scene> moved_organ(const ShownResult& shown) {
  Scene scene;
  if (shown.patient && shown.patient->find("surfaces/liver")) {
    auto rest = liver_scene(*shown.patient);
    if (!rest) return rest;
    for (SurfaceItem& item : rest->surfaces) {
      item.surface = std::make_shared<const geometry::Surface>(moved(*item.surface, shown));
    }
    std::stable_partition(rest->surfaces.begin(), rest->surfaces.end(),
                          [](const SurfaceItem& item) { return item.name == "liver"; });
    scene.surfaces = std::move(rest->surfaces);
  } else {
    scene.surfaces.push_back(surface_item("liver", moved(geometry::boundary_surface(shown.result.mesh), shown)));
  }
  if (shown.patient) scene.annotations.warning = warning_of(*shown.patient);
  return scene;
}

void add_landmarks_and_tools(Scene& scene, const ShownResult& shown) {
  for (const auto& landmark : shown.result.landmarks) {
    const bool significant = landmark.displacement_mm >= rehearsal::significant_mm;
    // The points on vessels are many; their names would hide the picture.
    const std::string label = casefile::is_vessel(landmark.id)
                                  ? std::string()
                                  : fmt::format("{} {:.1f} mm", landmark.id, landmark.displacement_mm);
    scene.landmarks.push_back({label, landmark.displaced_mm, 2.5, significant ? flag_orange : ivory});
  }
  for (const auto& tool : shown.result.tools) {
    const double force_N = units::N_from_mN(tool.force_mN.norm());
    if (force_N <= 0) continue;
    // The arrow begins where the tool now touches, and points where it pulls.
    const auto place = mechanics::locate_points(shown.result.mesh, {tool.center_mm}).front();
    const Eigen::Vector3d touched = tool.center_mm + displacement_at(place, shown);
    scene.arrows.push_back(
        {touched, touched + 45 * tool.force_mN.normalized(), 3, tool_blue, fmt::format("{:.1f} N", force_N)});
  }
}

// 1, 1.5, 2, 3, ... 10, 15, ... at or above the value: a legend that ends at a round number.
double round_up(double value) {
  if (!(value > 0)) return 1;
  const double power = std::pow(10.0, std::floor(std::log10(value)));
  for (const double step : {1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0}) {
    if (step * power >= value * (1 - 1e-9)) return step * power;
  }
  return 10 * power;
}

}  // namespace
}  // namespace glisson::scene
