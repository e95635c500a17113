#include "casefile/internal/sofa_scene.h"

#include <fmt/format.h>
#include <array>
#include <map>
#include <set>

#include "base/markup.h"

namespace glisson::casefile {
namespace {

using Eigen::Index;
using Eigen::Vector3d;
using mechanics::Body;

// A node's name in SOFA is part of paths: letters, digits, '-' and '_'.
std::string node_name(const std::string& text, std::set<std::string>& taken) {
  std::string name;
  for (const char c : text) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-';
    name += plain ? c : '_';
  }
  const std::string first = name;
  for (int other = 2; !taken.insert(name).second; ++other) name = fmt::format("{}_{}", first, other);
  return name;
}

std::string numbers(const Vector3d& v) { return fmt::format("{} {} {}", v.x(), v.y(), v.z()); }

std::string plugins(const SofaScene& scene) {
  std::vector<std::string> names{"Sofa.Component.Constraint.Projective",
                                 "Sofa.Component.IO.Mesh",
                                 "Sofa.Component.LinearSolver.Direct",
                                 "Sofa.Component.Mapping.Linear",
                                 "Sofa.Component.MechanicalLoad",
                                 "Sofa.Component.ODESolver.Backward",
                                 "Sofa.Component.SolidMechanics.FEM.Elastic",
                                 "Sofa.Component.SolidMechanics.Spring",
                                 "Sofa.Component.StateContainer",
                                 "Sofa.Component.Topology.Container.Dynamic",
                                 "Sofa.Component.Visual"};
  if (scene.motion) names.emplace_back("Sofa.Component.Mass");
  if (!scene.shapes.empty()) names.emplace_back("Sofa.GL.Component.Rendering3D");
  std::string text = "  <Node name=\"plugins\">\n";
  for (const std::string& name : names) text += fmt::format("    <RequiredPlugin name=\"{}\"/>\n", name);
  return text + "  </Node>\n";
}

std::string solvers(const SofaScene& scene) {
  const std::string time =
      scene.motion ? fmt::format("<EulerImplicitSolver name=\"solver\" rayleighMass=\"{}\" rayleighStiffness=\"{}\"/>",
                                 scene.motion->mass_damping_per_s, scene.motion->stiffness_damping_s)
                   : "<StaticSolver name=\"solver\"/>";
  return fmt::format(
      "    {}\n    <SparseLDLSolver name=\"linear_solver\" template=\"CompressedRowSparseMatrixMat3x3d\"/>\n", time);
}

std::string tissue(const Body& body, const SofaScene& scene) {
  std::string text = fmt::format(
      "    <MeshVTKLoader name=\"mesh\" filename=\"{}\"/>\n"
      "    <TetrahedronSetTopologyContainer name=\"topology\" src=\"@mesh\"/>\n"
      "    <TetrahedronSetGeometryAlgorithms name=\"geometry\" template=\"Vec3\"/>\n"
      "    <MechanicalObject name=\"nodes\" template=\"Vec3\" src=\"@mesh\"/>\n",
      scene.mesh_file);
  if (scene.motion) {
    text += fmt::format("    <MeshMatrixMass name=\"mass\" topology=\"@topology\" massDensity=\"{}\" lumping=\"1\"/>\n",
                        body.options.density_kg_mm3);
  }
  text += fmt::format(
      "    <TetrahedronFEMForceField name=\"tissue\" template=\"Vec3\" topology=\"@topology\" method=\"{}\" "
      "poissonRatio=\"{}\"\n        youngModulus=\"{}\"/>\n",
      scene.law == mechanics::MaterialLaw::linear ? "small" : "large", body.options.poisson_ratio,
      fmt::join(body.youngs_kPa, " "));
  return text;
}

// Nodes that are held in the same directions stand in one constraint.
std::string held_nodes(const Body& body) {
  std::map<std::array<int, 3>, std::vector<int>> held;
  for (int node = 0; node < body.layout.nodes(); ++node) {
    const auto* fixed = &body.resolved.fixed[3 * static_cast<std::size_t>(node)];
    const std::array<int, 3> directions{fixed[0], fixed[1], fixed[2]};
    if (directions != std::array<int, 3>{0, 0, 0}) held[directions].push_back(node);
  }
  std::string text;
  for (const auto& [directions, nodes] : held) {
    if (directions == std::array<int, 3>{1, 1, 1}) {
      text += fmt::format("    <FixedProjectiveConstraint name=\"held\" indices=\"{}\"/>\n", fmt::join(nodes, " "));
    } else {
      text += fmt::format(
          "    <PartialFixedProjectiveConstraint name=\"held_{0}{1}{2}\" fixedDirections=\"{0} {1} {2}\" "
          "indices=\"{3}\"/>\n",
          directions[0], directions[1], directions[2], fmt::join(nodes, " "));
    }
  }
  return text;
}

std::string foundations(const Body& body) {
  std::map<int, double> springs_mN_per_mm;
  for (const mechanics::FoundationFace& under : body.resolved.foundations) {
    const mechanics::BoundaryFace& face = body.boundary[under.face];
    for (std::size_t corner = 0; corner < 3; ++corner) {
      springs_mN_per_mm[face.nodes[corner]] += under.stiffness_kPa_per_mm * face.area_mm2 / 3;
    }
  }
  if (springs_mN_per_mm.empty()) return {};
  std::vector<int> nodes;
  std::vector<double> stiffness;
  for (const auto& [node, spring] : springs_mN_per_mm) {
    nodes.push_back(node);
    stiffness.push_back(spring);
  }
  return fmt::format("    <RestShapeSpringsForceField name=\"foundation\" points=\"{}\"\n        stiffness=\"{}\"/>\n",
                     fmt::join(nodes, " "), fmt::join(stiffness, " "));
}

std::string load(const SofaNodeForces& forces) {
  std::vector<Index> nodes;
  std::vector<std::string> on_nodes_mN;
  for (Index node = 0; 3 * node < forces.force_mN.size(); ++node) {
    const Vector3d force_mN = forces.force_mN.segment<3>(3 * node);
    if (force_mN.isZero(0)) continue;
    nodes.push_back(node);
    on_nodes_mN.push_back(numbers(force_mN));
  }
  if (nodes.empty()) return {};
  return fmt::format("    <ConstantForceField name=\"{}\" indices=\"{}\"\n        forces=\"{}\"/>\n", forces.name,
                     fmt::join(nodes, " "), fmt::join(on_nodes_mN, "  "));
}

std::string mapped(const SofaScene& scene) {
  std::set<std::string> taken;
  std::string text;
  for (const SofaPoint& landmark : scene.landmarks) {
    text += fmt::format(
        "    <Node name=\"{}\">\n"
        "      <MechanicalObject name=\"point\" template=\"Vec3\" position=\"{}\" showObject=\"1\" "
        "showObjectScale=\"5\"/>\n"
        "      <BarycentricMapping name=\"mapping\" input=\"@../nodes\" output=\"@point\"/>\n"
        "    </Node>\n",
        node_name("landmark-" + landmark.name, taken), numbers(landmark.position_mm));
  }
  for (const SofaShape& shape : scene.shapes) {
    text += fmt::format(
        "    <Node name=\"{}\">\n"
        "      <MeshOBJLoader name=\"surface\" filename=\"{}\"/>\n"
        "      <OglModel name=\"shape\" src=\"@surface\" color=\"{} {} {} 1\"/>\n"
        "      <BarycentricMapping name=\"mapping\" input=\"@../nodes\" output=\"@shape\"/>\n"
        "    </Node>\n",
        node_name(shape.name, taken), escaped_markup(shape.file), shape.color_rgb[0], shape.color_rgb[1],
        shape.color_rgb[2]);
  }
  return text;
}

}  // namespace

std::string sofa_mesh(const mechanics::NodeLayout& layout) {
  std::string text = fmt::format(
      "# vtk DataFile Version 3.0\nliver, mm\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS {} double\n", layout.nodes());
  for (const Vector3d& position_mm : layout.positions_mm) text += numbers(position_mm) + "\n";
  text += fmt::format("CELLS {} {}\n", layout.cells.size(), 5 * layout.cells.size());
  for (const auto& cell : layout.cells) text += fmt::format("4 {} {} {} {}\n", cell[0], cell[1], cell[2], cell[3]);
  text += fmt::format("CELL_TYPES {}\n", layout.cells.size());
  for (std::size_t cell = 0; cell < layout.cells.size(); ++cell) text += "10\n";
  return text;
}

std::string sofa_scene(const Body& body, const SofaScene& scene) {
  std::string text = fmt::format(
      "<?xml version=\"1.0\"?>\n<!-- {} -->\n"
      "<!-- For SOFA 24.06 and later. Lengths mm, masses kg, times s, so forces mN and moduli kPa. -->\n"
      "<Node name=\"root\" gravity=\"0 0 0\" dt=\"{}\">\n",
      scene.title, scene.motion ? scene.motion->step_s : 1.0);
  text += plugins(scene);
  text +=
      "  <DefaultAnimationLoop name=\"loop\"/>\n"
      "  <VisualStyle name=\"style\" displayFlags=\"showVisual showBehaviorModels\"/>\n"
      "  <Node name=\"liver\">\n";
  text += solvers(scene) + tissue(body, scene) + held_nodes(body) + foundations(body);
  for (const SofaNodeForces& forces : scene.loads) text += load(forces);
  return text + mapped(scene) + "  </Node>\n</Node>\n";
}

}  // namespace glisson::casefile
