#pragma once
// Hyperelastic laws in plane strain, as energies a volume at rest. F is the deformation gradient in the plane
// (F33 = 1), J = det F, I1 = F:F + 1, I2 = I1 + J^2 - 1. Without their part of the volume they are K1 = I1 J^(-2/3) - 3
// and K2 = I2 J^(-4/3) - 3. Each law is
//   neo-hookean    C10 K1                                 mooney-rivlin  C10 K1 + C01 K2
//   gent-thomas    C10 K1 + C2 ln((K2 + 3) / 3)           isihara        C10 K1 + C01 K2 + C20 K1^2
//   yeoh           C10 K1 + C20 K1^2 + C30 K1^3           haines-wilson  C10 K1 + C01 K2 + C11 K1 K2 + C30 K1^3
//   arruda-boyce   mu (five terms in I1 J^(-2/3), N)      gent           -mu Jm / 2 ln(1 - K1 / Jm)
//   ogden          2 mu / alpha^2 (l1^alpha + l2^alpha + l3^alpha - 3), l the stretches times J^(-1/3)
//   fibre          C10 K1 + k (Ia - 1)^2
//   holzapfel      C10 K1 + k1 / (2 k2) sum (exp(k2 (Ia - 1)^2) - 1)
// and D (J - 1)^2. Along fibres a, Ia = J^(-2/3) |F a|^2. They lie at `angle_deg` from x (fibre), or at plus and minus
// that (holzapfel). Fibres act in compression as in tension.
//
// Treloar 1943; Mooney 1940; Isihara, Hashitsume and Tatibana 1951; Gent and Thomas 1958; Haines and Wilson 1979;
// Yeoh 1993; Arruda and Boyce 1993; Gent 1996; Ogden 1972; Holzapfel, Gasser and Ogden 2000. As a library for
// discovery: Flaschel, Kumar and De Lorenzis, Comput. Methods Appl. Mech. Engrg. 381 (2021) 113852.

#include <Eigen/Core>
#include <string>
#include <string_view>
#include <vector>

namespace glisson::closedloop {

// What a law's number is. The energy is linear in coefficients, which come first.
enum class LawNumber { shear, volume, coefficient, shape, angle };

struct LawParameter {
  const char* name;
  LawNumber number;
  double usual;      // of shapes and angles; coefficients have the unit of stress and no usual value
  double lower = 0;  // bounds of a shape
  double upper = 0;
  std::vector<double> tried;  // values of a shape from which fits begin
};

struct LawForm {
  const char* name;
  const char* sentence;  // for a person: how such a material behaves
  std::vector<LawParameter> parameters;
  [[nodiscard]] Eigen::Index coefficients() const;
};

// In order of increasing freedom, the plainest first.
[[nodiscard]] const std::vector<LawForm>& plane_laws();

// By name, however its words are joined ("Neo-Hookean", "NeoHookean"); nullptr where there is none.
[[nodiscard]] const LawForm* plane_law(std::string_view name);

struct PlaneLaw {
  const LawForm* form = nullptr;
  Eigen::VectorXd parameters;
};

// First Piola-Kirchhoff stress and its derivative by F; F and P row by row: 11, 12, 21, 22.
struct PlaneStress {
  Eigen::Vector4d stress = Eigen::Vector4d::Zero();
  Eigen::Matrix4d tangent = Eigen::Matrix4d::Zero();
};

// Not finite where a law is used beyond its range (J <= 0, beyond gent's locking).
void add_stress(const PlaneLaw& law, const Eigen::Vector4d& deformation, bool with_tangent, PlaneStress& to);

// The first derivative of the stress at rest by a stretch: what a test under small strain would call the shear modulus.
[[nodiscard]] double shear_modulus(const PlaneLaw& law);

}  // namespace glisson::closedloop
