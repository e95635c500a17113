#pragma once
// An attachment of the surface that nobody declared, as an adhesion or a ligament is: springs per unit area, equal in
// all directions, under the part of the boundary that lies in a ball (ball_region.h).

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <vector>

#include "closedloop/palpation/internal/ball_region.h"
#include "mechanics/elements/body.h"

namespace glisson::closedloop {

struct Attachment {
  mechanics::Ball patch;
  double foundation_kPa_per_mm = 0;
};

// The springs under one face of the boundary, between its six nodes (mN/mm). A displacement's force is `directions`
// times it, alike for x, y and z unless said.
struct SpringFace {
  std::size_t face = 0;
  Eigen::Matrix<double, 6, 6> springs;
  Eigen::Matrix3d directions = Eigen::Matrix3d::Identity();
};

// Of the faces that it reaches; and how these change with the ball, per mm.
[[nodiscard]] std::vector<SpringFace> springs_of(const mechanics::Body& body, const Attachment& attachment);
[[nodiscard]] std::vector<SpringFace> springs_derivative(const mechanics::Body& body, const Attachment& attachment,
                                                         BallParameter by);

// How much of a boundary it holds, by its smooth border.
[[nodiscard]] double held_area_mm2(const geometry::TetMesh& mesh, const std::vector<mechanics::BoundaryFace>& boundary,
                                   const mechanics::Ball& patch);

// Of a foundation of 1 kPa/mm under all of a face.
[[nodiscard]] SpringFace whole_face(const mechanics::Body& body, std::size_t face);

void add_springs(const mechanics::Body& body, const std::vector<SpringFace>& faces, Eigen::SparseMatrix<double>& lower);
// What they resist a displacement with (mN).
void add_spring_forces(const mechanics::Body& body, const std::vector<SpringFace>& faces,
                       const Eigen::Ref<const Eigen::VectorXd>& u_mm, Eigen::VectorXd& force_mN);

}  // namespace glisson::closedloop
