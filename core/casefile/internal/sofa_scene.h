#pragma once
// A body of linear tetrahedra as files that SOFA reads (names of version 24.06): its mesh as legacy VTK and the scene
// around it. Lengths mm, masses kg, times s, so forces mN, moduli kPa and springs mN/mm. Nodes are numbered as in the
// body's layout.

#include <array>
#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "mechanics/elements/body.h"

namespace glisson::casefile {

struct SofaNodeForces {
  std::string name;
  Eigen::VectorXd force_mN;  // 3 a node
};

struct SofaPoint {
  std::string name;
  Eigen::Vector3d position_mm{0, 0, 0};
};

struct SofaShape {
  std::string name;
  std::string file;  // beside the scene
  std::array<double, 3> color_rgb{};
};

struct SofaScene {
  std::string title;
  mechanics::MaterialLaw law = mechanics::MaterialLaw::linear;  // or corotational
  std::optional<mechanics::Motion> motion;
  std::string mesh_file;  // beside the scene
  std::vector<SofaNodeForces> loads;
  std::vector<SofaPoint> landmarks;
  std::vector<SofaShape> shapes;
};

// Legacy VTK, ASCII: the body's nodes and cells.
std::string sofa_mesh(const mechanics::NodeLayout& layout);

// The .scn file. A foundation is a spring at each node: its stiffness times a third of the area of each face there,
// which is the consistent matrix of the face with its rows summed. Whatever moves is mapped from the cells.
std::string sofa_scene(const mechanics::Body& body, const SofaScene& scene);

}  // namespace glisson::casefile
