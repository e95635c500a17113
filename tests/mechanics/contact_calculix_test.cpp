// A rigid ball pressed into a hyperelastic block, at large deformation, against CalculiX with its contact from surface
// to surface: on the same mesh, and on one twice as fine.

#include <gtest/gtest.h>
#include <numbers>

#include "base/files.h"
#include "mechanics/bodies.h"
#include "mechanics/calculix.h"
#include "mechanics/contact/large_contact.h"
#include "mechanics/materials/isochoric.h"
#include "mechanics/statics/displacements.h"

namespace glisson::mechanics {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double radius_mm = 10, depth_mm = 3;
const Vector3d touches_at_mm(16, 14, 15);  // at no node of either mesh

// 30 x 30 x 15 mm of 10 kPa, fixed below.
Body block(int fineness) {
  auto mesh = test::box(4 * fineness, 4 * fineness, 2 * fineness, {30, 30, 15});
  test::disturb_inner_points(mesh, 0.8 / fineness);
  test::name_points(mesh, "ground", [](const Vector3d& p) { return p.z() < 1e-9; });
  return prepare_body(mesh, test::uniform(mesh, 10), {test::fixed("ground")}, {.poisson_ratio = 0.45},
                      Holding::required)
      .value();
}

// The ball's lower side as one layer of wedges, all of whose nodes are moved down.
void write_ball(std::ostream& out, int first_node, int first_cell) {
  constexpr int rings = 18, sectors = 60;
  constexpr double widest = 55 * std::numbers::pi / 180;
  const auto node = [&](int ring, int sector, int layer) {
    const int at = ring == 0 ? 0 : 1 + (ring - 1) * sectors + sector % sectors;
    return first_node + 2 * at + layer;
  };
  const Vector3d center_mm = touches_at_mm + Vector3d(0, 0, radius_mm);
  out << "*NODE, NSET=BALL\n";
  for (int ring = 0; ring <= rings; ++ring) {
    for (int sector = 0; sector < (ring == 0 ? 1 : sectors); ++sector) {
      const double down = widest * ring / rings, around = 2 * std::numbers::pi * sector / sectors;
      const Vector3d way(std::sin(down) * std::cos(around), std::sin(down) * std::sin(around), -std::cos(down));
      for (int layer = 0; layer < 2; ++layer) {
        const Vector3d p = center_mm + (radius_mm - (layer == 0 ? 1 : 0)) * way;
        out << node(ring, sector, layer) << ", " << p.x() << ", " << p.y() << ", " << p.z() << "\n";
      }
    }
  }
  out << "*ELEMENT, TYPE=C3D6, ELSET=EBALL\n";
  int cell = first_cell;
  const auto wedge = [&](const std::array<std::pair<int, int>, 3>& corners) {
    out << cell++;
    for (int layer = 0; layer < 2; ++layer) {
      for (const auto& [ring, sector] : corners) out << ", " << node(ring, sector, layer);
    }
    out << "\n";
  };
  for (int s = 0; s < sectors; ++s) {
    wedge({{{0, 0}, {1, s + 1}, {1, s}}});
    for (int r = 1; r < rings; ++r) {
      wedge({{{r, s}, {r, s + 1}, {r + 1, s}}});
      wedge({{{r, s + 1}, {r + 1, s + 1}, {r + 1, s}}});
    }
  }
  out << "*MATERIAL, NAME=MBALL\n*ELASTIC\n1000, 0.3\n*SOLID SECTION, ELSET=EBALL, MATERIAL=MBALL\n"
      << "*SURFACE, NAME=OUTSIDE, TYPE=ELEMENT\nEBALL, S2\n";
}

// By parts of the way, which may be as large as that. CalculiX turns its contact's normals from part to part: with
// thirds in place of fiftieths a node of the coarse mesh lies 0.05 mm elsewhere, with tenths 0.014 mm.
void write_input(const std::filesystem::path& file, const Body& body, double part) {
  std::ofstream out(file);
  test::write_body(
      out, body.layout, [&](std::size_t c) { return test::neo_hookean_card(body, c); },
      [](const Vector3d& p) { return p.z() < 1e-9; });
  write_ball(out, body.layout.nodes() + 1, static_cast<int>(body.layout.cells.size()) + 1);
  out << "*SURFACE, NAME=TOP, TYPE=ELEMENT\n";
  for (const auto& [cell, face] : test::faces_of_calculix(body.mesh)) {
    double lowest_mm = 15;
    constexpr std::array<std::array<int, 3>, 4> faces{{{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}}};
    for (const int corner : faces[face - 1]) {
      lowest_mm = std::min(lowest_mm, body.mesh.points_mm[body.mesh.cells[cell][corner]].z());
    }
    if (lowest_mm > 15 - 1e-9) out << cell + 1 << ", S" << face << "\n";
  }
  out << "*SURFACE INTERACTION, NAME=PRESS\n*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR\n2000.\n"
      << "*CONTACT PAIR, INTERACTION=PRESS, TYPE=SURFACE TO SURFACE\nTOP, OUTSIDE\n"
      << "*STEP, NLGEOM, INC=1000\n*STATIC\n"
      << part << ", 1., 1e-5, " << part << "\n*BOUNDARY\nBALL, 1, 2, 0\nBALL, 3, 3, " << -depth_mm
      << "\n*NODE PRINT, NSET=NALL, FREQUENCY=999\nU\n*NODE PRINT, NSET=BALL, TOTALS=ONLY, FREQUENCY=999\nRF\n"
      << "*END STEP\n";
}

double force_of_ball_mN(const std::filesystem::path& file) {
  std::ifstream in(file);
  std::string line;
  while (std::getline(in, line) && line.find("total force") == std::string::npos) {
  }
  double x = NAN, y = NAN, z = NAN;
  in >> x >> y >> z;
  return z;
}

TEST(ContactAgainstCalculix, ABallInABlockPressesAsThereOnTheSameMeshAndOnAFinerOne) {
  GLISSON_NEEDS_CALCULIX();
  const Body body = block(1);
  std::vector<Material> materials;
  for (const Lame& lame : body.materials) materials.emplace_back(neo_hookean_from(lame));
  std::vector<std::vector<ContactTool>> stations;
  for (double deep_mm = 0.5; deep_mm <= depth_mm; deep_mm += 0.5) {
    stations.push_back(
        {{"ball", TouchingTool{palpation_probe(radius_mm),
                               pose_towards(touches_at_mm + Vector3d(0, 0, radius_mm - deep_mm), {0, 0, -1}),
                               {}}}});
  }
  const AppliedLoads nothing{VectorXd::Zero(3 * body.layout.nodes()), 0};
  ContactOptions tight;
  tight.penetration_tolerance_mm = 0.02;
  const auto ours = find_equilibrium_in_contact(body, materials, nothing, stations, tight).value();
  ASSERT_TRUE(ours.result.may_be_used()) << ours.result.why_stopped;
  const VectorXd u_mm = nodal_displacements(body.layout, ours.result);

  for (const int fineness : {1, 2}) {
    const Body theirs = block(fineness);
    const TemporaryFolder folder;
    write_input(folder.path() / "body.inp", theirs, fineness == 1 ? 0.1 : 0.25);
    ASSERT_EQ(test::run_calculix(folder.path()), 0) << read_text_file(folder.path() / "ccx.log").value_or("");
    const auto there_mm = test::read_displacements(folder.path() / "body.dat", theirs.layout.nodes());
    const double force_mN = force_of_ball_mN(folder.path() / "body.dat");
    double largest_mm = 0, mean_square = 0, largest_u_mm = 0, from_axis_mm = 0;
    int seen = 0;
    for (int n = 0; n < body.layout.nodes(); ++n) {
      for (int m = 0; m < theirs.layout.nodes(); ++m) {
        if ((theirs.layout.positions_mm[m] - body.layout.positions_mm[n]).norm() > 1e-6) continue;
        const double off = (u_mm.segment<3>(3 * n) - there_mm[m]).norm();
        if (off > largest_mm) {
          largest_mm = off;
          from_axis_mm = (body.layout.positions_mm[n] - touches_at_mm).head<2>().norm();
        }
        largest_u_mm = std::max(largest_u_mm, there_mm[m].norm());
        mean_square += off * off;
        ++seen;
      }
    }
    const std::string on = fineness == 1 ? "same_mesh_" : "finer_mesh_";
    RecordProperty(on + "largest_off_mm", std::to_string(largest_mm));
    RecordProperty(on + "largest_off_from_axis_mm", std::to_string(from_axis_mm));
    RecordProperty(on + "mean_square_off_mm", std::to_string(std::sqrt(mean_square / seen)));
    RecordProperty(on + "force_is", std::to_string(ours.tools[0].force_mN.z() / force_mN));
    EXPECT_LT(std::sqrt(mean_square / seen), (fineness == 1 ? 0.01 : 0.05) * largest_u_mm);
    // The worst is a corner that the faces about it lift off the ball, where few points of either contact press.
    EXPECT_LT(largest_mm, (fineness == 1 ? 0.05 : 0.15) * largest_u_mm) << "at " << from_axis_mm;
  }
}

}  // namespace
}  // namespace glisson::mechanics
