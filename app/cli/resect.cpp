// glisson-cli resect (CASE | --mesh FILE.vtu) (--plane ... | --points FILE.csv) --out DIR: volumes, margins and vessels
// of a planned resection, and the liver in its parts.

#include <fmt/format.h>

#include "base/csv.h"
#include "casefile/model.h"
#include "casefile/resection_folder.h"
#include "command.h"
#include "geometry/mesh_file.h"
#include "rehearsal/resection.h"
#include "shared_options.h"

namespace glisson::cli {
namespace {

struct Options {
  std::optional<std::string> case_folder;
  std::optional<std::string> mesh_file;
  std::vector<double> plane;
  std::optional<std::string> points_file;
  std::vector<double> specimen_mm;
  std::vector<std::string> structures;  // NAME=FILE
  std::string out;
};

// Columns x_mm, y_mm, z_mm, or the first three.
Result<std::vector<Eigen::Vector3d>> read_points(const std::filesystem::path& file) {
  const auto table = read_csv(file, std::uint64_t{16} << 20);
  if (!table) return failure(table.error());
  std::array<std::size_t, 3> columns{0, 1, 2};
  const char* names[] = {"x_mm", "y_mm", "z_mm"};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (const auto named = table->column(names[axis])) columns[axis] = *named;
    if (columns[axis] >= table->columns.size()) {
      return failure(Error{
          "points-invalid", GLISSON_TEXT("The points of a cut need three columns: x_mm, y_mm, z_mm."), {}, {}, file});
    }
  }
  std::vector<Eigen::Vector3d> points_mm;
  for (std::size_t row = 0; row < table->rows(); ++row) {
    points_mm.emplace_back(table->columns[columns[0]][row], table->columns[columns[1]][row],
                           table->columns[columns[2]][row]);
  }
  return points_mm;
}

Result<casefile::PlannedCut> cut_of(const Options& options) {
  casefile::PlannedCut cut;
  if (options.points_file) {
    auto points_mm = read_points(*options.points_file);
    if (!points_mm) return failure(points_mm.error());
    cut.through_mm = *std::move(points_mm);
  } else {
    cut.point_mm = Eigen::Vector3d(options.plane.data());
    cut.normal = Eigen::Vector3d(options.plane.data() + 3);
  }
  return cut;
}

struct Liver {
  geometry::TetMesh mesh;
  std::vector<rehearsal::NamedStructure> structures;
};

Result<Liver> liver_of(const Options& options) {
  Liver liver;
  if (options.mesh_file) {
    auto mesh = geometry::read_tetrahedra(*options.mesh_file);
    if (!mesh) return failure(mesh.error());
    liver.mesh = std::move(*mesh);
  } else {
    auto model = casefile::Case::open(*options.case_folder).and_then([](const casefile::Case& patient) {
      return casefile::read_model(patient);
    });
    if (!model) return failure(model.error());
    liver.mesh = std::move(model->mesh);
    for (auto& structure : model->structures) {
      liver.structures.push_back(
          {structure.name, casefile::resection_kind(structure.name), std::move(structure.surface)});
    }
  }
  for (const std::string& given : options.structures) {
    const auto equals = given.find('=');
    auto surface = geometry::read_surface(given.substr(equals + 1));
    if (!surface) return failure(surface.error());
    const std::string name = given.substr(0, equals);
    liver.structures.push_back({name, casefile::resection_kind(name), std::move(*surface)});
  }
  return liver;
}

std::string in_words(const rehearsal::Resection& plan) {
  std::string text = fmt::format("Specimen {:.1f} ml, remnant {:.1f} ml ({:.1f} %), volumes to {:.2f} ml\n",
                                 plan.specimen_ml, plan.remnant_ml, plan.remnant_percent(), plan.volume_error_ml);
  for (const auto& tumour : plan.tumours) {
    text += fmt::format("  {:24} {:9} margin {:6.1f} mm{}\n", tumour.name, to_string(tumour.side), tumour.margin_mm,
                        tumour.r1()       ? "  < 1 mm: R1"
                        : tumour.narrow() ? "  < 5 mm"
                                          : "");
  }
  for (const auto& cyst : plan.cysts) text += fmt::format("  {:24} {}\n", cyst.name, to_string(cyst.side));
  for (const auto& vessel : plan.vessels) text += fmt::format("  {:24} {}\n", vessel.name, to_string(vessel.side));
  for (const auto& crossing : plan.crossings) {
    text += fmt::format("  crosses {:16} {:.1f} mm wide\n", crossing.name, crossing.diameter_mm);
  }
  return text + bullet_list(plan.notes);
}

Result<Outcome> resect(const Options& options, const Progress& progress) {
  progress.report(0.0, GLISSON_TEXT("Reading the liver"));
  const auto cut = cut_of(options);
  if (!cut) return failure(cut.error());
  const auto liver = liver_of(options);
  if (!liver) return failure(liver.error());
  progress.report(0.3, GLISSON_TEXT("Cutting"));
  std::optional<Eigen::Vector3d> specimen_mm;
  if (!options.specimen_mm.empty()) specimen_mm = Eigen::Vector3d(options.specimen_mm.data());
  const auto surface = casefile::surface_of(*cut);
  if (!surface) return failure(surface.error());
  const auto plan = rehearsal::plan_resection(liver->mesh, *surface, liver->structures, specimen_mm);
  if (!plan) return failure(plan.error());
  if (auto written = casefile::write_resection(options.out, *cut, *plan); !written) {
    return failure(std::move(written.error()));
  }
  auto document = parse_json(casefile::resection_text(*cut, *plan));
  if (!document) return failure(std::move(document.error()));
  (*document)["out"] = options.out;
  return Outcome{*std::move(document), in_words(*plan)};
}

}  // namespace

void add_resect(CLI::App& app, Action& chosen) {
  CLI::App* command = app.add_subcommand(
      "resect", "Divide the liver: volumes, margins to tumours (< 1 mm: R1; < 5 mm flagged), vessels crossed");
  auto options = std::make_shared<Options>();
  CLI::Option* case_folder = command->add_option("case", options->case_folder, "The case");
  CLI::Option* mesh = command->add_option("--mesh", options->mesh_file, "Tetrahedra (.vtu), instead of a case");
  CLI::Option* plane = command->add_option("--plane", options->plane, "PX,PY,PZ,NX,NY,NZ: a point (mm) and the normal")
                           ->delimiter(',')
                           ->expected(6);
  CLI::Option* points =
      command->add_option("--points", options->points_file, "CSV x_mm,y_mm,z_mm: a smooth sheet passes through them");
  command->add_option("--specimen", options->specimen_mm, "X,Y,Z in the part to be removed; without it the smaller one")
      ->delimiter(',')
      ->expected(3);
  command->add_option("--structure", options->structures, "NAME=FILE: a tumour's or vessel's surface, more than once")
      ->check([](const std::string& given) {
        return given.find('=') == std::string::npos ? std::string("must be NAME=FILE") : std::string();
      });
  command->add_option("--out", options->out, "Folder for resection.json, parts.vtu and cut.vtp")->required();
  case_folder->excludes(mesh);
  plane->excludes(points);
  command->callback([&chosen, options] {
    if (!options->case_folder && !options->mesh_file) throw CLI::RequiredError("a case or --mesh");
    if (options->plane.empty() && !options->points_file) throw CLI::RequiredError("--plane or --points");
    chosen = [options](const Progress& progress) { return resect(*options, progress); };
  });
}

}  // namespace glisson::cli
