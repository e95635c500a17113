#pragma once
// Input for CalculiX (ccx, Debian's calculix-ccx), an independent finite element code, and what it answers.

#include <array>
#include <cmath>
#include <cstdlib>
#include <Eigen/Core>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iomanip>
#include <sstream>
#include <string>
#include <vector>

#include "geometry/tetrahedra.h"
#include "mechanics/elements/body.h"
#include "mechanics/elements/node_layout.h"
#include "mechanics/elements/static_options.h"
#include "mechanics/materials/isochoric.h"

namespace glisson::mechanics::test {

// CalculiX's card of a cell's neo-Hookean material: W = C10 (I1 - 3) + (J - 1)^2 / D1.
inline std::string neo_hookean_card(const Body& body, std::size_t cell) {
  const NeoHookean law = neo_hookean_from(body.materials[cell]);
  std::ostringstream card;
  card << std::setprecision(12) << "*HYPERELASTIC, NEO HOOKE\n"
       << law.shear_kPa / 2 << ", " << 2 / law.bulk_kPa << "\n";
  return card.str();
}

// CalculiX's input: ten-node tetrahedra (C3D10), a material a cell, nodes held. Its units follow ours: mm, kg,
// s, so mN and kPa. It reads no number longer than 20 characters: 12 digits.
inline void write_body(std::ostream& out, const NodeLayout& layout,
                       const std::function<std::string(std::size_t)>& material,
                       const std::function<bool(const Eigen::Vector3d&)>& held) {
  out << std::setprecision(12) << "*NODE, NSET=NALL\n";
  for (int n = 0; n < layout.nodes(); ++n) {
    const Eigen::Vector3d& p = layout.positions_mm[n];
    out << n + 1 << ", " << p.x() << ", " << p.y() << ", " << p.z() << "\n";
  }
  for (std::size_t c = 0; c < layout.cells.size(); ++c) {
    out << "*ELEMENT, TYPE=C3D10, ELSET=E" << c + 1 << "\n" << c + 1;
    for (const int node : layout.cells[c]) out << ", " << node + 1;
    out << "\n*MATERIAL, NAME=M" << c + 1 << "\n"
        << material(c) << "*DENSITY\n"
        << StaticOptions{}.density_kg_mm3 << "\n*SOLID SECTION, ELSET=E" << c + 1 << ", MATERIAL=M" << c + 1 << "\n";
  }
  out << "*BOUNDARY\n";
  for (int n = 0; n < layout.nodes(); ++n) {
    if (held(layout.positions_mm[n])) out << n + 1 << ", 1, 3\n";
  }
}

// The faces of a body's boundary as a cell and CalculiX's number of its face: 1-2-3, 1-4-2, 2-4-3, 3-4-1.
inline std::vector<std::pair<int, int>> faces_of_calculix(const geometry::TetMesh& mesh) {
  constexpr std::array<std::array<int, 3>, 4> faces{{{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}}};
  const geometry::Surface surface = geometry::boundary_surface(mesh);
  const auto& mesh_point = geometry::find_field(surface.point_fields, "mesh_point")->values;
  const auto& mesh_cell = geometry::find_field(surface.cell_fields, "mesh_cell")->values;
  std::vector<std::pair<int, int>> outer;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    const auto cell = static_cast<std::size_t>(mesh_cell[t]);
    for (std::size_t f = 0; f < faces.size(); ++f) {
      int shared = 0;
      for (const int corner : faces[f]) {
        for (const int p : surface.triangles[t]) shared += int(mesh_point[p]) == mesh.cells[cell][corner] ? 1 : 0;
      }
      if (shared == 3) outer.emplace_back(static_cast<int>(cell), static_cast<int>(f) + 1);
    }
  }
  return outer;
}

// Node number and three displacements a line, after the table's title.
inline std::vector<Eigen::Vector3d> read_displacements(const std::filesystem::path& file, int nodes) {
  std::vector<Eigen::Vector3d> displacements(nodes, Eigen::Vector3d::Constant(NAN));
  std::ifstream in(file);
  std::string line;
  while (std::getline(in, line)) {
    std::istringstream columns(line);
    int node = 0;
    Eigen::Vector3d u;
    if (columns >> node >> u.x() >> u.y() >> u.z() && node >= 1 && node <= nodes) displacements[node - 1] = u;
  }
  return displacements;
}

#define GLISSON_NEEDS_CALCULIX()                                                     \
  if (std::system("command -v ccx > /dev/null 2>&1") != 0) {                         \
    GTEST_SKIP() << "CalculiX (ccx) is not installed: apt-get install calculix-ccx"; \
  }

inline int run_calculix(const std::filesystem::path& folder) {
  const std::string run = "cd '" + folder.string() + "' && OMP_NUM_THREADS=1 ccx body > ccx.log 2>&1";
  return std::system(run.c_str());
}

}  // namespace glisson::mechanics::test
