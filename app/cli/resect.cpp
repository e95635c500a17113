// glisson-cli resect (CASE | --mesh FILE.vtu) (--plane ... | --points FILE.csv) [--result DIR/result.vtu] --out DIR:
// volumes, margins and vessels of a planned resection, and the liver in its parts; at rest, or as tools hold it aside.

#include <fmt/format.h>

#include "base/csv.h"
#include "casefile/model.h"
#include "casefile/plans.h"
#include "casefile/resection_folder.h"
#include "casefile/result_folder.h"
#include "casefile/used_entries.h"
#include "command.h"
#include "geometry/mesh_file.h"
#include "mechanics/simulation.h"
#include "mended_surface.h"
#include "planning/plan_file.h"
#include "rehearsal/resection.h"
#include "shared_options.h"

namespace glisson::cli {
namespace {

struct ResectCommand {
  std::optional<std::string> case_folder;
  std::optional<std::string> mesh_file;
  std::vector<double> plane;
  std::optional<std::string> points_file;
  std::vector<double> specimen_mm;
  std::vector<std::string> structures;  // NAME=FILE
  std::optional<std::string> result;    // result.vtu: the liver lies as it says
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

Result<casefile::PlannedCut> cut_of(const ResectCommand& options) {
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
  std::vector<Sentence> remarks;     // on the case's files
  std::optional<double> outline_ml;  // of a case
};

Result<Liver> liver_of(const ResectCommand& options) {
  Liver liver;
  if (options.mesh_file) {
    auto mesh = geometry::read_tetrahedra(*options.mesh_file);
    if (!mesh) return failure(mesh.error());
    liver.mesh = std::move(*mesh);
  } else {
    const auto patient = casefile::Case::open(*options.case_folder);
    if (!patient) return failure(patient.error());
    auto model = casefile::read_model(*patient);
    if (!model) return failure(model.error());
    liver.mesh = std::move(model->mesh);
    liver.outline_ml = model->liver.volume_ml;
    liver.remarks = casefile::model_remarks(*patient);
    for (auto& structure : model->structures) {
      liver.structures.push_back(
          {structure.name, casefile::resection_kind(structure.name), std::move(structure.surface)});
    }
  }
  for (const std::string& given : options.structures) {
    const auto equals = given.find('=');
    auto surface = read_mended(given.substr(equals + 1), geometry::Pieces::several);
    if (!surface) return failure(surface.error());
    for (const std::string& note : surface->notes) liver.remarks.push_back({note, {}});
    const std::string name = given.substr(0, equals);
    liver.structures.push_back({name, casefile::resection_kind(name), std::move(surface->mended.surface)});
  }
  return liver;
}

// As the tools of a result hold the liver: each point of it displaced. The result must be of this very mesh.
Result<std::vector<Eigen::Vector3d>> displacement_mm(const geometry::TetMesh& rest, const std::filesystem::path& file) {
  const auto result = geometry::read_tetrahedra(file);
  if (!result) return failure(result.error());
  const geometry::Field* field = geometry::find_field(result->point_fields, mechanics::displacement_field);
  if (field == nullptr || field->components != 3) {
    return failure(Error{"not-a-result",
                         GLISSON_TEXT("{0} has no displacement."),
                         {file.string()},
                         GLISSON_TEXT("Make one with glisson-cli simulate --out DIR."),
                         file});
  }
  constexpr double same_place_mm = 1e-3;
  const bool same = result->points_mm.size() == rest.points_mm.size() &&
                    std::equal(rest.points_mm.begin(), rest.points_mm.end(), result->points_mm.begin(),
                               [](const auto& a, const auto& b) { return (a - b).norm() <= same_place_mm; });
  if (!same) {
    return failure(Error{"retraction-mismatch",
                         GLISSON_TEXT("The result {0} is not of this model: its points at rest are others."),
                         {file.string()},
                         GLISSON_TEXT("Simulate it again with the model as it is now."),
                         file});
  }
  std::vector<Eigen::Vector3d> moved_mm;
  for (std::size_t p = 0; p < field->items(); ++p) moved_mm.emplace_back(&field->values[3 * p]);
  return moved_mm;
}

// The liver with its structures where it lies.
struct Lying {
  rehearsal::LyingLiver liver;
  std::vector<rehearsal::NamedStructure> structures;
};

Result<Lying> lying(const Liver& liver, const std::optional<std::string>& result) {
  if (auto checked = geometry::check_tetrahedra(liver.mesh); !checked) return failure(std::move(checked.error()));
  if (!result) return Lying{rehearsal::at_rest(liver.mesh), liver.structures};
  // Either the file or the folder that simulate writes.
  const std::filesystem::path given = *result;
  std::error_code problem;
  const std::filesystem::path file = std::filesystem::is_directory(given, problem) ? given / "result.vtu" : given;
  const auto moved_mm = displacement_mm(liver.mesh, file);
  if (!moved_mm) return failure(moved_mm.error());
  const auto validity = casefile::read_validity(file.parent_path());
  if (!validity) return failure(validity.error());
  if (*validity && !(*validity)->usable()) {
    return failure(Error{"retraction-unusable",
                         GLISSON_TEXT("The result {0} is not to be used: {1}."),
                         {file.string(), (*validity)->why_not().message()},
                         GLISSON_TEXT("Simulate it again with less force."),
                         file});
  }
  auto displaced = rehearsal::displaced(liver.mesh, *moved_mm);
  if (!displaced) return failure(std::move(displaced.error()));
  if (*validity) displaced->validity = **validity;
  return Lying{*std::move(displaced), rehearsal::displaced(liver.mesh, *moved_mm, liver.structures)};
}

std::string in_words(const casefile::PlannedCut& cut, const rehearsal::Resection& plan) {
  std::string text = cut.liver == casefile::PlannedCut::Liver::held_aside
                         ? "As the tools hold the liver: margins and widths there, volumes of the tissue at rest\n"
                         : "";
  if (plan.retraction) text += plan.retraction->sentence().message() + "\n";
  text += fmt::format("Specimen {:.1f} ml, remnant {:.1f} ml ({:.1f} %), volumes to {:.2f} ml\n", plan.specimen_ml,
                      plan.remnant_ml, plan.remnant_percent(), plan.volume_error_ml);
  for (const auto& tumour : plan.tumours) {
    text += fmt::format("  {:24} {:9} margin {:6.1f} mm{}{}\n", tumour.name, to_string(tumour.side), tumour.margin_mm,
                        tumour.shift_mm > 0 ? fmt::format(", moved by {:.1f} mm", tumour.shift_mm) : "",
                        tumour.r1()       ? "  < 1 mm: R1"
                        : tumour.narrow() ? "  < 5 mm"
                                          : "");
  }
  for (const auto& cyst : plan.cysts) text += fmt::format("  {:24} {}\n", cyst.name, to_string(cyst.side));
  for (const auto& vessel : plan.vessels) text += fmt::format("  {:24} {}\n", vessel.name, to_string(vessel.side));
  for (const auto& crossing : plan.crossings) {
    text += fmt::format("  crosses {:16} {:.1f} mm wide{}\n", crossing.name, crossing.diameter_mm,
                        crossing.vena_cava_by_calibre() ? ": too wide for a hepatic vein, the vena cava" : "");
  }
  return text + bullet_list(plan.notes);
}

struct Living {
  planning::PlanAnswer answer;
  vasculature::VesselTrees trees;
  std::vector<Sentence> remarks;
};

std::string in_words(const Living& living) {
  std::string text =
      fmt::format("Of the remnant {:.0f} ml stay perfused and drained; {:.0f} ml ischaemic, {:.0f} ml congested\n",
                  *living.answer.living_ml, *living.answer.ischaemic_ml, *living.answer.congested_ml);
  for (const planning::CutBranch& cut : living.answer.branches) {
    const vasculature::TreeBranch& branch = living.trees.branches[cut.branch];
    const auto told = planning::beyond_cut(cut, branch.system);
    if (!told || (vasculature::is_vein(branch.system) && told->left < 1)) continue;
    text += fmt::format("  cuts {:32} {:.1f} mm wide, {:.0f} {} in the remnant hang on it\n", branch.name,
                        2 * cut.radius_mm, told->left, told->unit);
  }
  for (const Sentence& remark : living.remarks) text += "- " + remark.message() + "\n";
  return text;
}

// By the trees of the case. Nothing for a mesh, without trees of both systems, or as tools hold the liver: the trees
// are those at rest.
Result<std::optional<Living>> living_remnant(const ResectCommand& options, const casefile::PlannedCut& cut,
                                             const rehearsal::Resection& plan) {
  if (!options.case_folder || options.result) return std::nullopt;
  const auto patient = casefile::Case::open(*options.case_folder);
  if (!patient) return failure(patient.error());
  if (patient->find("vessels/trees") == nullptr) return std::nullopt;
  const auto opened = casefile::open_planner(*patient);
  if (!opened) return failure(opened.error());
  const auto answer = opened->planner.answer({casefile::cut_of(cut, plan.specimen_is_above)});
  if (!answer) return failure(answer.error());
  if (!answer->living_ml) return std::nullopt;
  return Living{*answer, opened->planner.trees(), opened->remarks};
}

Result<Outcome> resect(const ResectCommand& options, const Progress& progress) {
  progress.report(0.0, GLISSON_TEXT("Reading the liver"));
  auto cut = cut_of(options);
  if (!cut) return failure(cut.error());
  if (options.result) cut->liver = casefile::PlannedCut::Liver::held_aside;
  const auto liver = liver_of(options);
  if (!liver) return failure(liver.error());
  progress.report(0.3, GLISSON_TEXT("Cutting"));
  std::optional<Eigen::Vector3d> specimen_mm;
  if (!options.specimen_mm.empty()) specimen_mm = Eigen::Vector3d(options.specimen_mm.data());
  const auto surface = casefile::surface_of(*cut);
  if (!surface) return failure(surface.error());
  const auto lies = lying(*liver, options.result);
  if (!lies) return failure(lies.error());
  auto plan = rehearsal::plan_resection(lies->liver, *surface, lies->structures, specimen_mm);
  if (!plan) return failure(plan.error());
  if (liver->outline_ml) casefile::measure_as_outlined(*plan, *liver->outline_ml);
  for (const Sentence& said : liver->remarks) plan->notes.push_back(said.message());
  if (auto written = casefile::write_resection(options.out, *cut, *plan); !written) {
    return failure(std::move(written.error()));
  }
  const auto living = living_remnant(options, *cut, *plan);
  if (!living) return failure(living.error());
  Json document = casefile::resection_json(*cut, *plan);
  document["out"] = options.out;
  if (*living) document["living_remnant"] = planning::answer_json((*living)->answer, (*living)->trees);
  return Outcome{std::move(document), in_words(*cut, *plan) + (*living ? in_words(**living) : "")};
}

}  // namespace

void add_resect(CLI::App& app, Action& chosen) {
  CLI::App* command = app.add_subcommand(
      "resect", "Divide the liver: volumes, margins to tumours (< 1 mm: R1; < 5 mm flagged), vessels crossed");
  auto options = std::make_shared<ResectCommand>();
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
  command->add_option("--result", options->result,
                      "result.vtu of simulate: the cut is set and measured on the liver as its tools hold it");
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
