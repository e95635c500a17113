#pragma once
// Points and weights for integrals over tetrahedra and triangles, in barycentric coordinates. Weights sum to 1, so an
// integral is the volume (or area) times the weighted sum.

#include <array>
#include <Eigen/Core>

namespace glisson::mechanics {

struct TetPoint {
  Eigen::Vector4d barycentric;
  double weight;
};
struct TrianglePoint {
  Eigen::Vector3d barycentric;
  double weight;
};

// Exact for polynomials of degree 2: Hammer and Stroud's four points. Enough for the stiffness of a straight-edged
// quadratic tetrahedron, whose strains are linear.
inline std::array<TetPoint, 4> tet_points_degree_2() {
  constexpr double a = 0.58541019662496845446, b = 0.13819660112501051518;  // (5 + 3 sqrt 5) / 20, (5 - sqrt 5) / 20
  return {{{{a, b, b, b}, 0.25}, {{b, a, b, b}, 0.25}, {{b, b, a, b}, 0.25}, {{b, b, b, a}, 0.25}}};
}

// Exact for degree 4: the six points of Dunavant (1985), table II. Enough for products of two quadratic functions.
inline std::array<TrianglePoint, 6> triangle_points_degree_4() {
  constexpr double a = 0.44594849091596488632, wa = 0.22338158967801146570;
  constexpr double b = 0.09157621350977074346, wb = 0.10995174365532186764;
  return {{{{a, a, 1 - 2 * a}, wa},
           {{a, 1 - 2 * a, a}, wa},
           {{1 - 2 * a, a, a}, wa},
           {{b, b, 1 - 2 * b}, wb},
           {{b, 1 - 2 * b, b}, wb},
           {{1 - 2 * b, b, b}, wb}}};
}

}  // namespace glisson::mechanics
