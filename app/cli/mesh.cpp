// glisson-cli mesh CASE: a watertight surface and tetrahedra of the liver with its inner structures.

#include <fmt/format.h>

#include "casefile/model.h"
#include "command.h"
#include "shared_options.h"

namespace glisson::cli {
namespace {

Outcome describe_mesh(const meshing::LiverMesh& mesh) {
  const bool watertight = geometry::is_watertight(mesh.surface);
  const double volume_ml = units::ml_from_mm3(geometry::volume_mm3(mesh.body));
  Outcome outcome{
      {{"points", mesh.body.points_mm.size()},
       {"cells", mesh.body.cells.size()},
       {"volume_ml", volume_ml},
       {"min_dihedral_deg", mesh.quality.min_dihedral_deg},
       {"mean_aspect", mesh.quality.mean_aspect},
       {"watertight", watertight},
       {"hausdorff_mm", mesh.hausdorff_mm},
       {"regions", Json::array()},
       {"notes", messages(mesh.notes)}},
      fmt::format("{} points, {} cells, {:.1f} ml, smallest dihedral angle {:.1f} deg, {}, at most {:.2f} mm "
                  "from the labels\n",
                  mesh.body.points_mm.size(), mesh.body.cells.size(), volume_ml, mesh.quality.min_dihedral_deg,
                  watertight ? "watertight" : "NOT watertight", mesh.hausdorff_mm) +
          bullet_list(messages(mesh.notes))};
  for (const auto& region : mesh.regions) {
    outcome.document["regions"].push_back({{"label", region.label},
                                           {"label_volume_ml", region.label_volume_ml},
                                           {"mesh_volume_ml", region.mesh_volume_ml}});
  }
  return outcome;
}

}  // namespace

void add_mesh(CLI::App& app, Action& chosen) {
  CLI::App* command = app.add_subcommand("mesh", "Make the surface and the tetrahedra of the liver");
  auto case_folder = std::make_shared<std::string>();
  auto options = std::make_shared<meshing::MeshOptions>();
  command->add_option("case", *case_folder, "The case")->required();
  command->add_option("--target-cells", options->target_cells, "About how many tetrahedra")
      ->check(CLI::Range(200, 2000000))
      ->capture_default_str();
  command->callback([&chosen, case_folder, options] {
    chosen = [case_folder, options](const Progress& progress) -> Result<Outcome> {
      auto patient = casefile::Case::open(*case_folder);
      if (!patient) return failure(patient.error());
      return casefile::mesh_liver(*patient, *options, progress).map(describe_mesh);
    };
  });
}

}  // namespace glisson::cli
