#pragma once
// What is asked of a body: what it is made of, what holds it, what pulls at it, and which points are followed. Plain
// values are in the units of base/units.h (mm, mN, kPa, kg). Positions are patient coordinates (LPS) at rest. JSON
// speaks N and kg/m3, and scenario_file.h reads it.

#include <array>
#include <Eigen/Core>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "base/tissue.h"
#include "base/units.h"
#include "geometry/surface.h"
#include "mechanics/materials/anisotropy.h"
#include "mechanics/materials/capsule.h"
#include "mechanics/materials/relaxation.h"
#include "mechanics/scenario/cut.h"
#include "mechanics/scenario/meshfree_options.h"
#include "mechanics/scenario/rigid_tool.h"

namespace glisson::mechanics {

enum class Engine { fem, meshfree };
enum class MaterialLaw { linear, corotational, neo_hookean, veronda_westmann };

// A law with what it needs besides the elastic constants.
struct ChosenLaw {
  MaterialLaw law = MaterialLaw::linear;
  double strain_stiffening = 0;  // Veronda and Westmann's c2 (isochoric.h), read by that law alone

  // NOLINTNEXTLINE(google-explicit-constructor): a law that needs nothing else is a choice
  ChosenLaw(MaterialLaw chosen, double stiffening = 0) : law(chosen), strain_stiffening(stiffening) {}
};

// Which points of a mesh are meant: those where a point array is not zero, or those inside a ball or a box.
struct NamedPoints {
  std::string point_array;
};
struct Ball {
  Eigen::Vector3d center_mm{0, 0, 0};
  double radius_mm = 0;
};
using Region = std::variant<NamedPoints, Ball, geometry::Box>;

// A Dirichlet condition: the named points move by the displacement, in the directions (x, y, z) that are fixed; by
// nothing where none is prescribed. A mid-side node moves with them when it belongs to a face all three of whose points
// are named. A displacement other than zero is known in equilibrium by finite elements without tools.
struct Fixed {
  std::array<bool, 3> directions{true, true, true};
  Eigen::Vector3d displacement_mm{0, 0, 0};
};

// A spring per unit area under the boundary faces all three of whose points are named. It pushes back equally in all
// directions with `stiffness_kPa_per_mm` times the displacement.
struct Foundation {
  double stiffness_kPa_per_mm = 0;
};

// A band from the named part of the surface to a fixed place in the body wall. It is a fan of springs that pull and
// never push, one from each named point of the surface. They share the stiffness by the area around them. Each begins
// to pull when it is `slack_mm` longer than at rest. It alone holds no body.
struct Ligament {
  Eigen::Vector3d anchor_mm{0, 0, 0};
  double stiffness_mN_per_mm = 0;  // of the whole band
  double slack_mm = 0;
};

struct Support {
  Region where;
  std::variant<Fixed, Foundation, Ligament> how;
};

// A dead load: a uniform traction over the boundary faces whose centroid at rest lies within the radius.
struct ToolLoad {
  Eigen::Vector3d center_mm{0, 0, 0};
  double radius_mm = 0;
  Eigen::Vector3d force_mN{0, 0, 0};
};

// Acts against the outward normal of the whole boundary: positive compresses, as insufflation gas does. It follows the
// surface, in direction and area, wherever the material knows large deformation; in linear elasticity the surface is
// that at rest.
struct PressureLoad {
  double pressure_kPa = 0;
};

struct GravityLoad {
  Eigen::Vector3d acceleration_mm_s2{0, 0, 0};
};

using Load = std::variant<ToolLoad, PressureLoad, GravityLoad>;
using Loads = std::vector<Load>;

// A tool in contact (contact.h). A rigid one begins at its position and goes along the direction, by an advance or
// until the body pushes back with a force. Jaws hold a patch of the surface and draw it, by a displacement or with a
// force.
struct ScenarioRigidTool {
  ToolShape shape;
  Eigen::Vector3d position_mm{0, 0, 0};
  Eigen::Vector3d direction{0, 0, 1};
  double advance_mm = 0;
  std::optional<double> push_mN;  // instead of the advance
  double friction = 0;            // Coulomb's coefficient, between the tool and the surface
};
struct ScenarioGrasp {
  Eigen::Vector3d center_mm{0, 0, 0};
  double radius_mm = 0;
  Eigen::Vector3d displacement_mm{0, 0, 0};
  std::optional<Eigen::Vector3d> pull_mN;  // instead of the displacement
};
struct ScenarioTool {
  std::string id;
  std::variant<ScenarioRigidTool, ScenarioGrasp> what;
};

struct Landmark {
  std::string id;
  Eigen::Vector3d position_mm{0, 0, 0};  // at rest
};

// Present when motion is asked for; absent means equilibrium. Rayleigh damping is mass_damping times the mass and
// stiffness_damping times the stiffness.
struct Motion {
  double step_s = 0.02;
  int steps = 0;
  double mass_damping_per_s = 0;
  double stiffness_damping_s = 0;
};

// One modulus for the whole body, or the name of a cell field that holds one a cell (kPa).
using YoungsModulus = std::variant<double, std::string>;

// The name under which this project's own meshes carry Young's modulus, one value a cell.
inline const std::string youngs_modulus_field = "youngs_modulus_kPa";

struct Scenario {
  Engine engine = Engine::fem;
  MaterialLaw material = MaterialLaw::linear;
  double strain_stiffening = 0;  // Veronda and Westmann's c2 (isochoric.h), read by that law alone
  double poisson_ratio = usual_poisson_ratio;
  double density_kg_mm3 = units::kg_mm3_from_kg_m3(1000.0);
  std::optional<YoungsModulus> youngs_modulus;  // absent: the mesh's own field `youngs_modulus_kPa`
  std::vector<Support> supports;
  std::optional<Capsule> capsule;
  std::optional<TransverseIsotropy> anisotropy;  // equilibrium by finite elements, material `linear`
  // How the tissue's stress relaxes; moduli are then those at once. An equilibrium is that after long.
  Relaxation relaxation = {};
  Loads loads;
  std::optional<Motion> motion;
  std::vector<Landmark> landmarks;
  std::vector<Cut> cuts;  // opened in the body before anything acts on it, one after the other
  // Apart: walls that would pass through each other slide along each other; equilibrium by finite elements, by Newton's
  // method and therefore far slower. Free: nothing keeps them apart, and the result says how far they passed.
  enum class Walls { free, apart };
  Walls cut_walls = Walls::free;
  std::vector<ScenarioTool> tools;
  MeshfreeOptions meshfree;  // read where the engine is meshfree
};

}  // namespace glisson::mechanics
