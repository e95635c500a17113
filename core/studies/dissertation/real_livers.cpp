#include "studies/dissertation/real_livers.h"

#include <fmt/format.h>
#include <cmath>

#include "anatomy/level_surface.h"
#include "base/folder_contents.h"
#include "base/noise.h"
#include "imaging/volume_file.h"
#include "meshing/mask_surface.h"
#include "segmentation/rasterise.h"
#include "segmentation/structures.h"
#include "shapes/liver_outline.h"
#include "studies/dissertation/cohort.h"
#include "studies/dissertation/shapes_study.h"
#include "vasculature/center_lines.h"
#include "vasculature/couinaud.h"
#include "vasculature/forks.h"

namespace glisson::studies {
namespace fs = std::filesystem;
namespace {

constexpr double voxel_mm = 3, wide_mm = 6;

fs::path vessels_beside(const fs::path& labels, const std::string& id);
unsigned seed_of(const Subject& subject);
imaging::Mask filled(const geometry::Surface& outline);
Result<void> add_forks(const fs::path& vessels, const imaging::LabelMap& labels, MeasuredLiver& liver);

}  // namespace

Result<std::vector<Subject>> find_livers(const fs::path& folder, unsigned seed) {
  std::vector<Subject> subjects;
  for (const ShapesLiver& liver : shapes_livers(folder)) {
    subjects.push_back({liver.id, liver.file, {}, DrawnStiffness{seed, vessels_beside(liver.file, liver.id)}});
  }
  if (!subjects.empty()) return subjects;
  return failure(Error{"shapes-no-livers",
                       GLISSON_TEXT("The folder holds no label maps of livers."),
                       {},
                       GLISSON_TEXT("Give one with a file a liver, as ID_liver.nii.gz."),
                       folder});
}

Result<MeasuredLiver> read_liver(const Subject& subject) {
  GLISSON_ASSERT(subject.drawn.has_value());
  const auto labels = imaging::read_labels_file(subject.path);
  if (!labels) return failure(labels.error());
  const auto outline = shapes::outline_of(*labels);
  if (!outline) return failure(outline.error());
  if (outline->cut_off_at != nullptr) {
    return failure("shapes-cut-off",
                   GLISSON_TEXT("The image cuts the liver off towards {0}: only whole ones can be retracted."),
                   {outline->cut_off_at});
  }
  MeasuredLiver liver;
  liver.shear_kPa = simulated_liver_map(outline->surface, seed_of(subject));
  liver.organ = filled(outline->surface);
  if (subject.drawn->vessels.empty()) return liver;
  if (auto added = add_forks(subject.drawn->vessels, *labels, liver); !added) return failure(added.error());
  return liver;
}

Result<std::optional<geometry::Surface>> vessels_of(const Subject& subject) {
  if (!subject.drawn || subject.drawn->vessels.empty()) return std::nullopt;
  const auto labels = imaging::read_labels_file(subject.drawn->vessels);
  if (!labels) return failure(labels.error());
  auto surface = meshing::mask_surface(segmentation::mask_of_any_label(*labels));
  if (!surface) return failure(surface.error());
  return std::move(*surface);
}

namespace {

fs::path vessels_beside(const fs::path& labels, const std::string& id) {
  for (const fs::path& file : contents_of(labels.parent_path())) {
    const std::string name = file.filename().string();
    if (name.substr(0, name.find('.')) == id + "_vessels" && imaging::has_volume_file_name(file)) return file;
  }
  return {};
}

unsigned seed_of(const Subject& subject) {
  std::uint64_t seed = subject.drawn->seed;
  for (const char letter : subject.id) seed = mixed(seed, static_cast<unsigned char>(letter));
  return static_cast<unsigned>(seed);
}

imaging::Mask filled(const geometry::Surface& outline) {
  geometry::Box box = geometry::bounding_box(outline.points_mm);
  box.min_mm.array() -= 2 * voxel_mm;
  box.max_mm.array() += 2 * voxel_mm;
  return segmentation::rasterise(outline, anatomy::grid_over(box, voxel_mm));
}

Result<void> add_forks(const fs::path& vessels, const imaging::LabelMap& labels, MeasuredLiver& liver) {
  const auto vessel_labels = imaging::read_labels_file(vessels);
  if (!vessel_labels) return failure(vessel_labels.error());
  const auto graph = vasculature::center_lines(segmentation::mask_of_any_label(*vessel_labels));
  if (!graph) return failure(graph.error());
  const auto explained = vasculature::explain_vessels(*graph, segmentation::mask_of_any_label(labels));
  if (!explained) return failure(explained.error());

  liver.groups = {{"forks", {}}, {"portal_forks", {}}, {"hepatic_forks", {}}, {"wide_forks", {}}, {"narrow_forks", {}}};
  for (const vasculature::Fork& fork : vasculature::forks_of(explained->trees)) {
    const Eigen::Vector3i at = liver.organ.grid.index_of(fork.position_mm).array().round().cast<int>();
    if (!liver.organ.grid.contains(at.x(), at.y(), at.z()) || liver.organ.at(at.x(), at.y(), at.z()) == 0) continue;
    const std::size_t landmark = liver.landmarks.size();
    const bool portal = fork.system == vasculature::System::portal_vein, wide = fork.calibre_mm >= wide_mm;
    for (const std::size_t group : {0, portal ? 1 : 2, wide ? 3 : 4}) liver.groups[group].members.push_back(landmark);
    liver.landmarks.push_back({fmt::format("fork-{}", landmark + 1), fork.position_mm});
  }
  return {};
}

}  // namespace
}  // namespace glisson::studies
