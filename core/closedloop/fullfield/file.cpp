// Full-field planes from JSON: the mesh, the declared law, and of each trial the tables of displacements and reactions.

#include <algorithm>
#include <cmath>
#include <set>

#include "base/files.h"
#include "closedloop/experiment/internal/experiment_source.h"
#include "closedloop/fullfield/internal/boundaries.h"
#include "closedloop/fullfield/laws.h"
#include "geometry/triangles_file.h"

namespace glisson::closedloop {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t maximum_field_points = 50000;  // beyond that a factor takes minutes

geometry::Surface mesh_from(const Json& specimen, const Source& source, FullField& field);
void read_declared(const Json& json, FullField& field);
void read_noise(const Json& json, FullField& field);
Eigen::Matrix2Xd displacement_from(const fs::path& file, std::size_t points);
std::vector<ReactionRow> reactions_from(const fs::path& file);
std::vector<PrescribedRow> prescribed_from(const Json& json, const std::string& where);

}  // namespace

FullField full_field_from(const Json& json, const Source& source, Needs needs) {
  only_keys(
      json,
      {"format", "kind", "title", "units", "specimen", "boundaries", "declared", "noise", "noise_reaction", "trials"},
      "The experiment");
  FullField field;
  field.needs = needs;
  const geometry::Surface mesh = mesh_from(required(json, "specimen", "The experiment"), source, field);
  read_declared(required(json, "declared", "The experiment"), field);
  read_noise(json, field);

  const std::vector<std::string> ids = trial_ids(json);
  std::vector<std::vector<ReactionRow>> reactions;
  std::vector<std::vector<PrescribedRow>> prescribed;
  for (std::size_t t = 0; t < ids.size(); ++t) {
    const Json& trial = json["trials"][t];
    const std::string where = "trial " + ids[t];
    only_keys(trial, {"id", "displacement", "reactions", "prescribed"}, where);
    PlaneTrial made{
        ids[t], Eigen::Matrix2Xd::Constant(2, static_cast<Eigen::Index>(field.points.size()), not_given), {}, {}};
    const auto file_of = [&](const char* key) {
      return source.named_file(text_in(required(trial, key, where), where + ", " + key));
    };
    const bool must = needs == Needs::measurements;
    if (must || trial.contains("displacement"))
      made.displacement = displacement_from(file_of("displacement"), field.points.size());
    reactions.push_back(must || trial.contains("reactions") ? reactions_from(file_of("reactions"))
                                                            : std::vector<ReactionRow>());
    prescribed.push_back(trial.contains("prescribed") ? prescribed_from(trial["prescribed"], where + ", prescribed")
                                                      : std::vector<PrescribedRow>());
    field.trials.push_back(std::move(made));
  }
  assign_boundaries(json.contains("boundaries") ? json["boundaries"] : Json::object(), mesh, reactions, prescribed,
                    field);
  return field;
}

namespace {

geometry::Surface mesh_from(const Json& specimen, const Source& source, FullField& field) {
  only_keys(specimen, {"mesh", "thickness", "state"}, "The specimen");
  if (specimen.contains("state") && specimen["state"] != "plane-strain")
    refuse("experiment-invalid", GLISSON_TEXT("The specimen's state must be \"plane-strain\"."), {},
           GLISSON_TEXT("Plane stress is not known here: a thin sheet needs a law for its thickness."));
  if (specimen.contains("thickness")) field.thickness = positive_in(specimen["thickness"], "specimen, thickness");
  const fs::path file = source.named_file(text_in(required(specimen, "mesh", "The specimen"), "specimen, mesh"));
  geometry::Surface mesh = taken(geometry::read_triangles(file));
  if (mesh.points_mm.size() > maximum_field_points)
    refuse("experiment-invalid", GLISSON_TEXT("{0} has {1} points; at most {2} are used."),
           {file.filename().string(), std::to_string(mesh.points_mm.size()), std::to_string(maximum_field_points)},
           GLISSON_TEXT("Give the field on a coarser mesh."), file);
  const geometry::Box box = geometry::bounding_box(mesh.points_mm);
  if (box.max_mm.z() - box.min_mm.z() > 1e-6 * box.diagonal_mm())
    refuse("experiment-invalid", GLISSON_TEXT("{0} does not lie in a plane of equal z."), {file.filename().string()},
           {}, file);
  for (const Eigen::Vector3d& point : mesh.points_mm) field.points.push_back(point.head<2>());
  for (std::array<int, 3> triangle : mesh.triangles) {
    const auto corner = [&](int i) {
      return field.points[static_cast<std::size_t>(triangle[static_cast<std::size_t>(i)])];
    };
    const Eigen::Vector2d a = corner(1) - corner(0), b = corner(2) - corner(0);
    const double area = (a.x() * b.y() - a.y() * b.x()) / 2;
    if (!(std::abs(area) > 1e-12 * box.diagonal_mm() * box.diagonal_mm()))
      refuse("experiment-invalid", GLISSON_TEXT("{0} has a triangle without area (at {1}, {2})."),
             {file.filename().string(), std::to_string(corner(0).x()), std::to_string(corner(0).y())}, {}, file);
    if (area < 0) std::swap(triangle[1], triangle[2]);
    field.triangles.push_back(triangle);
  }
  return mesh;
}

// Every way in which people write the two numbers that all laws have, as the law's own.
struct Alias {
  const char* name;
  LawNumber number;
  double factor;  // to C10 (times two where the law has mu), to D
};
constexpr std::array<Alias, 20> aliases{{{"C10", LawNumber::shear, 1},
                                         {"c10", LawNumber::shear, 1},
                                         {"C1", LawNumber::shear, 1},
                                         {"K1", LawNumber::shear, 1},
                                         {"mu", LawNumber::shear, 0.5},
                                         {"G", LawNumber::shear, 0.5},
                                         {"shear_modulus", LawNumber::shear, 0.5},
                                         {"shear_modulus_kPa", LawNumber::shear, 0.5},
                                         {"D", LawNumber::volume, 1},
                                         {"d", LawNumber::volume, 1},
                                         {"c", LawNumber::volume, 1},
                                         {"D1", LawNumber::volume, 1},
                                         {"(J-1)^2", LawNumber::volume, 1},
                                         {"J2", LawNumber::volume, 1},
                                         {"volume", LawNumber::volume, 1},
                                         {"K", LawNumber::volume, 0.5},
                                         {"kappa", LawNumber::volume, 0.5},
                                         {"bulk", LawNumber::volume, 0.5},
                                         {"bulk_modulus", LawNumber::volume, 0.5},
                                         {"bulk_modulus_kPa", LawNumber::volume, 0.5}}};

std::string names_of(const LawForm& form) {
  std::string names;
  for (const LawParameter& parameter : form.parameters)
    names += (names.empty() ? "" : ", ") + std::string(parameter.name);
  return names;
}

void read_declared(const Json& json, FullField& field) {
  const std::string name = text_in(required(json, "law", "declared"), "declared, law");
  const LawForm* form = plane_law(name);
  if (form == nullptr) {
    std::string known;
    for (const LawForm& law : plane_laws()) known += (known.empty() ? "" : ", ") + std::string(law.name);
    refuse("experiment-invalid", GLISSON_TEXT("The declared law \"{0}\" is not known."), {name, known},
           GLISSON_TEXT("The laws are {1}."));
  }
  field.law = form->name;
  const Json& numbers = json.contains("parameters") ? json["parameters"] : json;
  if (!numbers.is_object()) refuse_at("declared, parameters", GLISSON_TEXT("{0} must be an object in braces."));
  field.law_numbers = Eigen::VectorXd::Constant(static_cast<Eigen::Index>(form->parameters.size()), not_given);
  const auto set = [&](std::size_t which, double value) {
    field.law_numbers[static_cast<Eigen::Index>(which)] = value;
  };
  const auto set_number = [&](LawNumber wanted, double value) {
    for (std::size_t p = 0; p < form->parameters.size(); ++p) {
      if (form->parameters[p].number != wanted) continue;
      set(p, std::string_view(form->parameters[p].name) == "mu" ? 2 * value : value);
    }
  };
  std::size_t given = 0;
  for (const auto& entry : numbers.items()) {
    const std::string& key = entry.key();
    if (key == "law" || key == "parameters") continue;
    const double number = number_in(entry.value(), "declared, " + key);
    ++given;
    const auto own = std::find_if(form->parameters.begin(), form->parameters.end(),
                                  [&](const LawParameter& parameter) { return key == parameter.name; });
    const auto alias = std::find_if(aliases.begin(), aliases.end(), [&](const Alias& one) { return key == one.name; });
    if (own != form->parameters.end()) {
      set(static_cast<std::size_t>(own - form->parameters.begin()), number);
    } else if (alias != aliases.end()) {
      set_number(alias->number, alias->factor * number);
    } else if (key == "youngs_modulus" || key == "youngs_modulus_kPa" || key == "poisson_ratio") {
      const char* young = numbers.contains("youngs_modulus") ? "youngs_modulus" : "youngs_modulus_kPa";
      const double modulus = positive_in(required(numbers, young, "declared"), "declared, youngs_modulus");
      const double poisson = number_in(required(numbers, "poisson_ratio", "declared"), "declared, poisson_ratio");
      if (!(poisson > -1 && poisson < 0.5))
        refuse_at("declared, poisson_ratio", GLISSON_TEXT("{0} must lie between -1 and 0.5."));
      set_number(LawNumber::shear, modulus / (4 * (1 + poisson)));
      set_number(LawNumber::volume, modulus / (6 * (1 - 2 * poisson)));
    } else {
      refuse("experiment-invalid", GLISSON_TEXT("The law {0} has no number called \"{1}\"."),
             {field.law, key, names_of(*form)}, GLISSON_TEXT("Its numbers are {2}."));
    }
  }
  if (given == 0) {
    field.law_numbers.resize(0);
  } else if (!field.law_numbers.allFinite()) {
    refuse("experiment-invalid", GLISSON_TEXT("The declared law lacks some of its numbers: {0}."), {names_of(*form)},
           GLISSON_TEXT("Give all of them, or none: then they are found first, and the law's name alone is declared."));
  }
}

void read_noise(const Json& json, FullField& field) {
  const Json& noise = required(json, "noise", "The experiment");
  if (noise.is_object()) {
    only_keys(noise, {"displacement", "reaction"}, "noise");
    field.noise = positive_in(required(noise, "displacement", "noise"), "noise, displacement");
    field.noise_of_reactions = optional_positive(noise, "reaction", "noise");
  } else {
    field.noise = positive_in(noise, "noise");
  }
  if (json.contains("noise_reaction")) field.noise_of_reactions = positive_in(json["noise_reaction"], "noise_reaction");
}

// The place of the first of these names among the cells; none where there is none of them.
std::optional<std::size_t> column_called(const CsvRow& header, std::initializer_list<std::string_view> names) {
  for (const std::string_view name : names) {
    for (std::size_t cell = 0; cell < header.cells.size(); ++cell) {
      if (std::equal(
              name.begin(), name.end(), header.cells[cell].begin(), header.cells[cell].end(), [](char a, char b) {
                return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b));
              }))
        return cell;
    }
  }
  return std::nullopt;
}

std::size_t needed_column(const CsvRow& header, std::initializer_list<std::string_view> names, const fs::path& file) {
  const auto column = column_called(header, names);
  if (!column)
    refuse("experiment-column-missing", GLISSON_TEXT("{0} has no column \"{1}\" in its first line."),
           {file.filename().string(), std::string(*names.begin())},
           GLISSON_TEXT("Displacements stand in point,ux,uy, reactions in boundary,fx,fy."), file);
  return *column;
}

std::vector<CsvRow> rows_of(const std::string& text, const fs::path& file) {
  std::vector<CsvRow> rows = csv_rows(text);
  if (rows.size() < 2)
    refuse("experiment-invalid", GLISSON_TEXT("{0} holds no row beneath its first line."), {file.filename().string()},
           {}, file);
  return rows;
}

Eigen::Matrix2Xd displacement_from(const fs::path& file, std::size_t points) {
  const std::string text = taken(read_text_file(file, std::uint64_t{64} << 20));
  const std::vector<CsvRow> rows = rows_of(text, file);
  const std::size_t point = needed_column(rows.front(), {"point", "node", "id", "point_id", "node_id"}, file);
  const std::size_t x = needed_column(rows.front(), {"ux", "ux_mm", "u_x", "u"}, file);
  const std::size_t y = needed_column(rows.front(), {"uy", "uy_mm", "u_y", "v"}, file);
  Eigen::Matrix2Xd displacement = Eigen::Matrix2Xd::Constant(2, static_cast<Eigen::Index>(points), not_given);
  for (std::size_t r = 1; r < rows.size(); ++r) {
    const double number = rows[r].number(point);
    if (!(number >= 0 && number < static_cast<double>(points)) || number != std::floor(number))
      refuse("experiment-invalid", GLISSON_TEXT("Line {0} of {1} names no point of the mesh, which has {2} from 0 on."),
             {std::to_string(rows[r].line), file.filename().string(), std::to_string(points)},
             GLISSON_TEXT("Points are numbered as in the mesh, from 0."), file);
    displacement.col(static_cast<Eigen::Index>(number)) << rows[r].number(x), rows[r].number(y);
  }
  return displacement;
}

std::vector<ReactionRow> reactions_from(const fs::path& file) {
  const std::string text = taken(read_text_file(file, std::uint64_t{1} << 20));
  const std::vector<CsvRow> rows = rows_of(text, file);
  const std::size_t name = needed_column(rows.front(), {"boundary", "group", "side", "name", "id"}, file);
  const auto x = column_called(rows.front(), {"fx", "fx_N", "rx", "f_x"});
  const auto y = column_called(rows.front(), {"fy", "fy_N", "ry", "f_y"});
  if (!x && !y) needed_column(rows.front(), {"fx"}, file);
  std::vector<ReactionRow> reactions;
  for (std::size_t r = 1; r < rows.size(); ++r) {
    if (name >= rows[r].cells.size()) continue;
    reactions.push_back({std::string(rows[r].cells[name]),
                         {x ? rows[r].number(*x) : not_given, y ? rows[r].number(*y) : not_given},
                         file.filename().string() + ", line " + std::to_string(rows[r].line)});
  }
  return reactions;
}

std::vector<PrescribedRow> prescribed_from(const Json& json, const std::string& where) {
  if (!json.is_object()) refuse_at(where, GLISSON_TEXT("{0} must be an object in braces."));
  std::vector<PrescribedRow> rows;
  for (const auto& entry : json.items()) {
    const std::string boundary = where + ", " + entry.key();
    only_keys(entry.value(), {"ux", "uy"}, boundary);
    const auto component = [&](const char* key) {
      return entry.value().contains(key) ? number_in(entry.value()[key], boundary + ", " + key) : not_given;
    };
    rows.push_back({entry.key(), {component("ux"), component("uy")}, where});
  }
  return rows;
}

}  // namespace
}  // namespace glisson::closedloop
