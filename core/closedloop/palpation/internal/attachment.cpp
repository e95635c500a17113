#include "closedloop/palpation/internal/attachment.h"

#include <cmath>

#include "mechanics/elements/quadrature.h"
#include "mechanics/elements/shape_functions.h"

namespace glisson::closedloop {
namespace {

// Of the regular triangle as large as the face.
double edge_mm(const mechanics::BoundaryFace& face) { return std::sqrt(4 / std::sqrt(3.0) * face.area_mm2); }

constexpr double border_edges = 4;  // beyond the ball: there it is nothing to the last digit

// The integral over a face of value_at(place, barycentric coordinates).
template <typename Value, typename ValueAt>
Value over_face(const geometry::TetMesh& mesh, const mechanics::BoundaryFace& face, Value sum,
                const ValueAt& value_at) {
  for (const mechanics::TrianglePoint& at : mechanics::triangle_points_degree_4()) {
    Eigen::Vector3d place_mm = Eigen::Vector3d::Zero();
    for (int i = 0; i < 3; ++i)
      place_mm += at.barycentric[i] * mesh.points_mm[static_cast<std::size_t>(face.points[std::size_t(i)])];
    sum += at.weight * face.area_mm2 * value_at(place_mm, at.barycentric);
  }
  return sum;
}

bool is_near(const mechanics::BoundaryFace& face, const mechanics::Ball& ball) {
  return (face.centroid_mm - ball.center_mm).norm() <= ball.radius_mm + border_edges * edge_mm(face);
}

// stiffness_at(place, edge) in kPa/mm, or its derivative.
template <typename StiffnessAt>
std::vector<SpringFace> faces_near(const mechanics::Body& body, const mechanics::Ball& ball,
                                   const StiffnessAt& stiffness_at) {
  using Springs = Eigen::Matrix<double, 6, 6>;
  std::vector<SpringFace> faces;
  for (std::size_t f = 0; f < body.boundary.size(); ++f) {
    const mechanics::BoundaryFace& face = body.boundary[f];
    if (!is_near(face, ball)) continue;
    const double edge = edge_mm(face);
    const auto springs_at = [&](const Eigen::Vector3d& place_mm, const Eigen::Vector3d& at) -> Springs {
      const Eigen::Matrix<double, 6, 1> values = mechanics::quadratic_triangle_values(at);
      return stiffness_at(place_mm, edge) * values * values.transpose();
    };
    faces.push_back({f, over_face<Springs>(body.mesh, face, Springs::Zero(), springs_at)});
  }
  return faces;
}

}  // namespace

std::vector<SpringFace> springs_of(const mechanics::Body& body, const Attachment& attachment) {
  return faces_near(body, attachment.patch, [&](const Eigen::Vector3d& place_mm, double edge) {
    return attachment.foundation_kPa_per_mm * inside(attachment.patch, place_mm, edge);
  });
}

std::vector<SpringFace> springs_derivative(const mechanics::Body& body, const Attachment& attachment,
                                           BallParameter by) {
  return faces_near(body, attachment.patch, [&](const Eigen::Vector3d& place_mm, double edge) {
    return attachment.foundation_kPa_per_mm * inside_derivative(attachment.patch, place_mm, edge, by);
  });
}

double held_area_mm2(const geometry::TetMesh& mesh, const std::vector<mechanics::BoundaryFace>& boundary,
                     const mechanics::Ball& patch) {
  double area_mm2 = 0;
  for (const mechanics::BoundaryFace& face : boundary) {
    if (!is_near(face, patch)) continue;
    area_mm2 = over_face<double>(mesh, face, area_mm2, [&](const Eigen::Vector3d& place_mm, const auto& /*at*/) {
      return inside(patch, place_mm, edge_mm(face));
    });
  }
  return area_mm2;
}

SpringFace whole_face(const mechanics::Body& body, std::size_t face) {
  return {face, mechanics::face_mass_mm2(body.boundary[face], body.options.order)};
}

void add_springs(const mechanics::Body& body, const std::vector<SpringFace>& faces,
                 Eigen::SparseMatrix<double>& lower) {
  for (const SpringFace& under : faces) {
    const auto& nodes = body.boundary[under.face].nodes;
    for (std::size_t a = 0; a < 6; ++a) {
      for (std::size_t b = 0; b < 6; ++b) {
        const Eigen::Matrix3d block = under.springs(Eigen::Index(a), Eigen::Index(b)) * under.directions;
        for (int d = 0; d < 3; ++d) {
          for (int e = 0; e < 3; ++e) {
            const int row = 3 * nodes[a] + d, column = 3 * nodes[b] + e;
            if (row >= column && block(d, e) != 0) lower.coeffRef(row, column) += block(d, e);
          }
        }
      }
    }
  }
}

void add_spring_forces(const mechanics::Body& body, const std::vector<SpringFace>& faces,
                       const Eigen::Ref<const Eigen::VectorXd>& u_mm, Eigen::VectorXd& force_mN) {
  for (const SpringFace& under : faces) {
    const auto& nodes = body.boundary[under.face].nodes;
    for (std::size_t a = 0; a < 6; ++a) {
      for (std::size_t b = 0; b < 6; ++b)
        force_mN.segment<3>(3 * nodes[a]) +=
            under.springs(Eigen::Index(a), Eigen::Index(b)) * (under.directions * u_mm.segment<3>(3 * nodes[b]));
    }
  }
}

}  // namespace glisson::closedloop
