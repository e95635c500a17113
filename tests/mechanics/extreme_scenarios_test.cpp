// Scenarios at the edges of what can be asked, each against theory: the answer is right, refused, or says what it is
// worth. The table stands in docs/validation.md too, "At the edges"; a row that is not there as it is here fails.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <chrono>
#include <cmath>
#include <limits>

#include "base/files.h"
#include "mechanics/bodies.h"
#include "mechanics/elements/body.h"
#include "mechanics/potentials/elastic.h"
#include "mechanics/simulation.h"
#include "mechanics/statics/displacements.h"
#include "mechanics/statics/equilibrium.h"
#include "support/folders.h"

namespace glisson::mechanics {
namespace {

using Eigen::Vector3d;

// A body that stands on its face z = 0, which is held.
struct Asked {
  geometry::TetMesh mesh;
  Scenario scenario;
  SimulationOptions options;
};

// What came of it, in the words of the table: "right: ...", "refused: CODE", "said: ..." or "wrong: ...".
using Judge = std::function<std::string(const Result<Simulation>&)>;

struct Row {
  std::string asked, theory, answer;
  std::function<Asked()> make;
  Judge judge;
};

Asked standing(int across, int up, double width_mm, double height_mm, double youngs_kPa) {
  Asked asked;
  asked.mesh = test::box(across, across, up, {width_mm, width_mm, height_mm});
  test::name_points(asked.mesh, "foot", [](const Vector3d& p) { return p.z() == 0; });
  asked.scenario.youngs_modulus = youngs_kPa;
  asked.scenario.supports = {test::fixed("foot")};
  asked.scenario.landmarks = {{"top", {width_mm / 2, width_mm / 2, height_mm}}};
  return asked;
}

Asked asked_with(Asked asked, Load load, MaterialLaw law = MaterialLaw::linear) {
  asked.scenario.loads = {std::move(load)};
  asked.scenario.material = law;
  return asked;
}

const GravityLoad weight{{0, 0, -9810}};

std::string refused(const Result<Simulation>& found) {
  return found ? "wrong: answered" : "refused: " + found.error().code;
}

// The state, and a note that holds the words.
Judge says(const std::string& state, const std::string& words, const std::string& in_short) {
  return [=](const Result<Simulation>& found) -> std::string {
    if (!found) return "wrong: " + found.error().message();
    std::string all = found->result.why_stopped;
    for (const std::string& note : found->result.notes) all += " " + note;
    const std::string is(to_string(validity_of(*found).state()));
    return is == state && all.find(words) != std::string::npos ? in_short : "wrong: " + is + "; " + all;
  };
}

// How far the landmark sinks or moves, within a share of what theory says.
Judge moves(Vector3d theory_mm, double within, const std::string& in_short) {
  return [=](const Result<Simulation>& found) -> std::string {
    if (!found) return "wrong: " + found.error().message();
    const Vector3d moved = found->landmarks[0].displaced_mm - found->landmarks[0].rest_mm;
    const bool near = (moved - theory_mm).norm() <= within * theory_mm.norm() + 1e-12;
    if (near && validity_of(*found).usable()) return in_short;
    return fmt::format("wrong: {} {} {}, {}", moved.x(), moved.y(), moved.z(), to_string(validity_of(*found).state()));
  };
}

Asked tangled() {
  Asked asked = asked_with(standing(2, 2, 20, 20, 5), weight);
  // The middle is pulled out of the body, and the cells that this turns inside out are turned back, as readers do.
  for (Vector3d& point : asked.mesh.points_mm) {
    if (point.isApprox(Vector3d(10, 10, 10))) point = {10, 10, 25};
  }
  for (std::size_t c = 0; c < asked.mesh.cells.size(); ++c) {
    if (geometry::cell_volume_mm3(asked.mesh, c) < 0) std::swap(asked.mesh.cells[c][2], asked.mesh.cells[c][3]);
  }
  return asked;
}

// A bar bent round by 1.05 turns: no two cells that share a face overlap, and those of its ends do.
Asked bent_round() {
  Asked asked;
  asked.mesh = test::bent_box(2, 2, 40, [](const Vector3d& unit) {
    const double radius_mm = 40 + 10 * unit.x(), angle = 1.05 * 2 * std::acos(-1.0) * unit.z();
    return Vector3d(radius_mm * std::cos(angle), radius_mm * std::sin(angle), 10 * unit.y());
  });
  test::name_points(asked.mesh, "foot", [](const Vector3d& p) { return p.y() == 0 && p.x() > 0; });
  asked.scenario.youngs_modulus = 5000.0;
  asked.scenario.supports = {test::fixed("foot")};
  return asked_with(std::move(asked), weight);
}

Asked far_away(double offset_mm) {
  Asked asked = asked_with(standing(3, 3, 30, 30, 5), weight);
  for (Vector3d& point : asked.mesh.points_mm) point.x() += offset_mm;
  asked.scenario.landmarks[0].position_mm.x() += offset_mm;
  return asked;
}

Asked near_incompressible() {
  Asked asked = asked_with(standing(4, 4, 30, 30, 5), PressureLoad{1.0});
  asked.scenario.poisson_ratio = 0.4999;
  return asked;
}

Asked two_stiffnesses() {
  // Two layers in series: the soft one takes all of the shortening.
  Asked asked = standing(3, 4, 10, 20, 5);
  geometry::Field youngs{"E", 1, {}};
  for (std::size_t c = 0; c < asked.mesh.cells.size(); ++c) {
    double z = 0;
    for (const int corner : asked.mesh.cells[c]) z += asked.mesh.points_mm[std::size_t(corner)].z() / 4;
    youngs.values.push_back(z < 10 ? 5e6 : 5);
  }
  geometry::set_field(asked.mesh.cell_fields, std::move(youngs));
  asked.scenario.youngs_modulus = std::string("E");
  asked.scenario.poisson_ratio = 0;
  return asked_with(std::move(asked), ToolLoad{{5, 5, 30}, 12, {0, 0, -5}});
}

Asked moving(double step_s, int steps) {
  Asked asked = asked_with(standing(2, 2, 20, 20, 5), weight, MaterialLaw::corotational);
  asked.scenario.motion = Motion{step_s, steps};
  return asked;
}

// Where the landmark of a moving body comes to rest: Newton's equilibrium of the linear cells that motions have.
Vector3d end_at_rest(const Asked& asked) {
  StaticOptions options;
  options.poisson_ratio = asked.scenario.poisson_ratio;
  options.density_kg_mm3 = asked.scenario.density_kg_mm3;
  options.order = ElementOrder::linear;
  const auto youngs_kPa = youngs_modulus_of_cells(asked.mesh, asked.scenario).value();
  const Body body = prepare_body(asked.mesh, youngs_kPa, asked.scenario.supports, options, Holding::required).value();
  const auto rest = find_equilibrium(body, materials_of(body, asked.scenario.material), asked.scenario.loads).value();
  const auto places = locate_landmarks(asked.mesh, asked.scenario.landmarks, 10).value();
  return displacement_at(body, rest, places).front();
}

Asked marked(Vector3d landmark_mm) {
  Asked asked = asked_with(standing(2, 2, 20, 20, 5), weight);
  asked.scenario.landmarks[0].position_mm = std::move(landmark_mm);
  return asked;
}

std::vector<Row> rows() {
  const double huge = 1e308;
  return {
      {"Young's modulus of 1e-300 kPa", "no matter is as soft", "refused: modulus-invalid",
       [] { return asked_with(standing(2, 2, 20, 20, 1e-300), weight); }, refused},
      {"Young's modulus of 1e300 kPa", "nor as stiff", "refused: modulus-invalid",
       [] { return asked_with(standing(2, 2, 20, 20, 1e300), weight); }, refused},
      {"corotational, 1e-9 kPa", "no matter is as soft", "refused: modulus-invalid",
       [] { return asked_with(standing(2, 2, 20, 20, 1e-9), weight, MaterialLaw::corotational); }, refused},
      {"corotational, 1e-5 kPa, under its weight", "strain of 1e4: no equilibrium that means anything",
       "said: not converged, far too soft",
       [] { return asked_with(standing(4, 4, 20, 20, 1e-5), weight, MaterialLaw::corotational); },
       says("not-converged", "far too soft", "said: not converged, far too soft")},
      {"neo-Hookean, 1e-5 kPa, under its weight", "the same", "said: not converged, far too soft",
       [] { return asked_with(standing(4, 4, 20, 20, 1e-5), weight, MaterialLaw::neo_hookean); },
       says("not-converged", "far too soft", "said: not converged, far too soft")},
      {"a column under its weight, q L^3 / E I = 29, linear", "buckles from 7.84 on (Greenhill)", "said: buckles",
       [] { return asked_with(standing(3, 15, 20, 99.5, 10), weight); },
       says("within", "the body buckles", "said: buckles")},
      {"a column under its weight, q L^3 / E I = 3.7, linear", "stands; its top sinks by q L^2 / 2 E A = 1.2 mm",
       "right: within 10 %",
       [] {
         Asked asked = asked_with(standing(3, 8, 20, 50, 10), weight);
         asked.scenario.poisson_ratio = 0;
         return asked;
       },
       [](const Result<Simulation>& found) -> std::string {
         const std::string sunk = moves({0, 0, -9.81e-3 * 50 * 50 / 20}, 0.1, "right: within 10 %")(found);
         for (const std::string& note : found->result.notes) {
           if (note.find("buckles") != std::string::npos) return "wrong: " + note;
         }
         return sunk;
       }},
      {"a beam of 10 kPa whose weight bends it double, linear", "tip at q L^4 / 8 E I = 118 times its length",
       "said: not to be used, cells inside out",
       [] {
         Asked asked = asked_with(standing(2, 30, 10, 200, 10), GravityLoad{{9810, 0, 0}});
         return asked;
       },
       says("unusable", "turned inside out", "said: not to be used, cells inside out")},
      {"a force of 1e12 N", "no tissue bears it", "said: not to be used, cells inside out",
       [] {
         return asked_with(standing(3, 3, 20, 20, 5), ToolLoad{{10, 10, 20}, 30, {0, 0, 1e15}});
       },
       says("unusable", "turned inside out", "said: not to be used, cells inside out")},
      {"no load", "nothing moves", "right: 0",
       [] {
         Asked asked = standing(2, 2, 20, 20, 5);
         return asked;
       },
       moves({0, 0, 0}, 0, "right: 0")},
      {"Poisson's ratio of 0.4999 under an even pressure, foot held", "hardly any volume to give: below 0.1 mm",
       "right: below 0.1 mm", near_incompressible,
       [](const Result<Simulation>& found) -> std::string {
         if (!found) return "wrong: " + found.error().message();
         const bool small = found->result.max_displacement_mm < 0.1 && validity_of(*found).usable();
         return small ? "right: below 0.1 mm" : fmt::format("wrong: {}", found->result.max_displacement_mm);
       }},
      {"Poisson's ratio of 0.5", "no finite bulk modulus", "refused: poisson-invalid",
       [] {
         Asked asked = asked_with(standing(2, 2, 20, 20, 5), weight);
         asked.scenario.poisson_ratio = 0.5;
         return asked;
       },
       refused},
      {"two layers, 5e6 and 5 kPa", "the soft one gives: F L / E A = 0.1 mm", "right: within 1 %", two_stiffnesses,
       moves({0, 0, -0.1}, 0.01, "right: within 1 %")},
      {"a body 100 m from the origin", "as at the origin", "right: within 1e-4", [] { return far_away(1e5); },
       [](const Result<Simulation>& found) -> std::string {
         const auto here = simulate(far_away(0).mesh, far_away(0).scenario).value();
         return moves(here.landmarks[0].displaced_mm - here.landmarks[0].rest_mm, 1e-4, "right: within 1e-4")(found);
       }},
      {"a body 1e12 mm from the origin", "no room for its digits", "refused: mesh-too-far",
       [] { return far_away(1e12); }, refused},
      {"a tangled mesh, its cells all of positive volume", "cells overlap", "refused: mesh-tangled", tangled, refused},
      {"a bar bent round until its ends overlap", "two tissues in one place", "said: cells lie in others", bent_round,
       says("within", "cells lie in others", "said: cells lie in others")},
      {"a landmark at 1e308 mm", "outside", "refused: landmark-outside",
       [=] {
         return marked({huge, 0, 0});
       },
       refused},
      {"a landmark that is no number", "nowhere", "refused: landmark-invalid",
       [] {
         return marked({std::numeric_limits<double>::quiet_NaN(), 0, 0});
       },
       refused},
      {"nothing holds the body", "it falls", "refused: body-free",
       [] {
         Asked asked = asked_with(standing(2, 2, 20, 20, 5), weight);
         asked.scenario.supports = {{geometry::Box{{-1, -1, -1}, {1, 1, 1}}, Fixed{}}};
         return asked;
       },
       refused},
      {"a motion in steps of 1e-9 s", "hardly begins: g t^2 / 2", "right: below 1e-6 mm",
       [] { return moving(1e-9, 3); },
       [](const Result<Simulation>& found) -> std::string {
         if (!found) return "wrong: " + found.error().message();
         return found->result.max_displacement_mm < 1e-6 ? "right: below 1e-6 mm" : "wrong";
       }},
      {"a motion in five steps of 1e6 s", "the equilibrium of its cells", "right: within 1 %",
       [] { return moving(1e6, 5); },
       [](const Result<Simulation>& found) -> std::string {
         return moves(end_at_rest(moving(1, 1)), 0.01, "right: within 1 %")(found);
       }},
  };
}

std::string line_of(const Row& row) { return fmt::format("| {} | {} | {} |", row.asked, row.theory, row.answer); }

TEST(ExtremeScenarios, AreAnsweredRightRefusedOrSaid) {
  for (const Row& row : rows()) {
    SCOPED_TRACE(row.asked);
    const Asked asked = row.make();
    const auto begin = std::chrono::steady_clock::now();
    const auto found = simulate(asked.mesh, asked.scenario, asked.options);
    EXPECT_EQ(row.judge(found), row.answer);
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(20));
  }
}

TEST(ExtremeScenarios, StandInTheDocumentAsTheyAreTested) {
  const std::string page = read_text_file(glisson::test::source_folder() / "docs" / "validation.md").value();
  std::size_t lines = 0;
  for (const Row& row : rows()) {
    EXPECT_NE(page.find(line_of(row)), std::string::npos) << "docs/validation.md lacks\n" << line_of(row);
    ++lines;
  }
  // And none that is not tested.
  const std::size_t begin = page.find("## At the edges"), end = page.find("\n## ", begin + 1);
  ASSERT_NE(begin, std::string::npos);
  const std::string section = page.substr(begin, end - begin);
  std::size_t shown = 0;
  for (std::size_t at = section.find("\n| "); at != std::string::npos; at = section.find("\n| ", at + 1)) ++shown;
  EXPECT_EQ(shown, lines + 1) << "with the heading";
}

}  // namespace
}  // namespace glisson::mechanics
