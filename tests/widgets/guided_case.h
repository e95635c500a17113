#pragma once
// The demo patient's liver as a case, coarse and quick, with a planned cut and a tumour at a place whose truth in every
// frame of the example sequence is known; and that sequence.

#include "anatomy/patient.h"
#include "casefile/model.h"
#include "casefile/resection_folder.h"
#include "casefile/structures.h"
#include "imaging/volume_file.h"
#include "segmentation/edit.h"
#include "segmentation/rasterise.h"
#include "studies/review/example_sequence.h"
#include "support/table_places.h"

namespace glisson::widgets::test {

namespace fs = std::filesystem;

template <typename Value>
Value needed(Result<Value> result) {
  if (!result) qFatal("%s", result.error().message().c_str());
  return *std::move(result);
}

inline fs::path guided_sequence(const fs::path& folder, int frames, std::uint64_t patient = 1) {
  studies::ExampleSequenceOptions options;
  options.frames = frames;
  options.patient = patient;
  return needed(studies::write_example_sequence(folder, options));
}

// `tumour`: "hidden-3" of the sequence's hidden.csv.
inline fs::path guided_case(const fs::path& parent, const fs::path& sequence, const std::string& tumour) {
  anatomy::PatientOptions options;
  options.portal_terminals = options.hepatic_terminals = options.arterial_terminals = 12;
  const anatomy::Patient patient = needed(anatomy::make_patient(options));
  const fs::path folder = parent / "guided.glisson";
  casefile::Case made = needed(casefile::Case::create(folder));
  std::vector<anatomy::NamedSurface> surfaces = anatomy::surfaces_of(patient, 2.5);
  const geometry::Box box = geometry::bounding_box(surfaces.front().surface.points_mm);
  imaging::Volume volume;
  volume.grid.spacing_mm = Eigen::Vector3d::Constant(3);
  volume.grid.origin_mm = box.min_mm - Eigen::Vector3d::Constant(9);
  for (int axis = 0; axis < 3; ++axis) {
    volume.grid.size[static_cast<std::size_t>(axis)] = static_cast<int>((box.max_mm - box.min_mm)[axis] / 3) + 7;
  }
  volume.values.assign(volume.grid.voxels(), 50.0F);
  if (!made.add("volumes/anatomy", ".nrrd", {"import", {}, {}, {}, {}},
                [&](const fs::path& file) { return imaging::write_volume_file(file, volume); })) {
    qFatal("no images for the test");
  }
  const auto save = [&](const std::string& name, imaging::Mask mask) {
    (void)needed(casefile::save_structure(made, segmentation::make_structure(name, std::move(mask)),
                                          {"segment", {}, {"volumes/anatomy"}, {}, {}}));
  };
  for (const anatomy::NamedSurface& surface : surfaces) {
    if (surface.name != "liver" && surface.name != "hepatic-vein") continue;
    save(surface.name, segmentation::rasterise(surface.surface, volume.grid));
  }
  const Eigen::Vector3d at_mm = glisson::test::places_in(sequence.parent_path() / "hidden.csv", tumour + ",").at(0);
  save("tumour-1", segmentation::paint({volume.grid, std::vector<std::uint8_t>(volume.grid.voxels())}, {at_mm, 9}));
  meshing::MeshOptions mesh;
  mesh.target_cells = 6000;
  (void)needed(casefile::mesh_liver(made, mesh));
  (void)needed(casefile::assign_stiffness(made, casefile::Uniform{6.0}));
  // A cut is planned across the liver, 25 mm from the tumour.
  casefile::PlannedCut cut;
  cut.point_mm = at_mm - Eigen::Vector3d(25, 0, 0);
  cut.normal = {1, 0, 0};
  const auto plan = needed(casefile::plan_resection(needed(casefile::read_model(made)).mesh, cut, {}));
  if (!casefile::write_resection(folder / "results" / "resection", cut, plan)) qFatal("no plan for the test");
  return folder;
}

}  // namespace glisson::widgets::test
