#include "guidance/force_modes.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/dense.h"
#include "base/units.h"
#include "geometry/nearest.h"
#include "mechanics/elements/body.h"
#include "mechanics/potentials/stiffness_matrix.h"
#include "mechanics/solvers/constrained_system.h"

namespace glisson::guidance {

using Eigen::MatrixXd;
using Eigen::Vector3d;

namespace {

constexpr double density_kg_mm3 = units::kg_mm3_from_kg_m3(1050.0);  // of liver; ICRU report 44 gives 1.05 to 1.06
constexpr double softest_spring = 1e-4;  // of the body's own stiffness: what makes the free body's matrix invertible

// Points that are as far from each other as can be (Gonzalez 1985), beginning with the one farthest from the middle.
std::vector<Vector3d> spread(const std::vector<Vector3d>& points_mm, int count) {
  const Vector3d middle =
      std::accumulate(points_mm.begin(), points_mm.end(), Vector3d(0, 0, 0)) / static_cast<double>(points_mm.size());
  std::vector<double> away(points_mm.size());
  std::transform(points_mm.begin(), points_mm.end(), away.begin(),
                 [&](const Vector3d& point) { return (point - middle).squaredNorm(); });
  std::vector<Vector3d> chosen;
  while (static_cast<int>(chosen.size()) < std::min<int>(count, static_cast<int>(points_mm.size()))) {
    const auto farthest = std::max_element(away.begin(), away.end()) - away.begin();
    chosen.push_back(points_mm[static_cast<std::size_t>(farthest)]);
    for (std::size_t p = 0; p < points_mm.size(); ++p) {
      const double from_this = (points_mm[p] - chosen.back()).squaredNorm();
      away[p] = chosen.size() == 1 ? from_this : std::min(away[p], from_this);
    }
  }
  return chosen;
}

// A third of the area of the triangles around each point of the surface.
std::vector<double> areas_of_points(const geometry::Surface& surface) {
  std::vector<double> areas(surface.points_mm.size(), 0.0);
  for (const auto& triangle : surface.triangles) {
    const Vector3d& a = surface.points_mm[static_cast<std::size_t>(triangle[0])];
    const double area = 0.5 * (surface.points_mm[static_cast<std::size_t>(triangle[1])] - a)
                                  .cross(surface.points_mm[static_cast<std::size_t>(triangle[2])] - a)
                                  .norm();
    for (const int point : triangle) areas[static_cast<std::size_t>(point)] += area / 3;
  }
  return areas;
}

}  // namespace

struct ForceModes::Impl {
  mechanics::Body body;
  geometry::Surface surface;
  std::vector<int> mesh_point_of;
  std::vector<double> areas_mm2;  // one a point of the surface
  std::vector<Vector3d> centers_mm;
  Vector3d centroid_mm{0, 0, 0};
  Eigen::VectorXd mass_kg;       // 3 equal values a point
  Eigen::MatrixXd rigid;         // 3 values a point x 6 motions, about the centroid
  Eigen::MatrixXd rigid_weight;  // takes displacements to the amounts of the six motions, weighed by mass
  bool is_supported = false;
  std::optional<mechanics::ConstrainedSystem> system;
  Eigen::MatrixXd modes_mm;
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> reduced_basis_mm;
  Eigen::MatrixXd reduced_amounts;
  std::vector<Vector3d> narrow_centers_mm;
  Eigen::MatrixXd narrow_modes_mm;

  void lay_out_rigid_motions();
  [[nodiscard]] double area_mm2() const { return std::accumulate(areas_mm2.begin(), areas_mm2.end(), 0.0); }
  // Of 1 mN in x, y and z in turn on each patch, by Gaussian weights of this standard deviation.
  [[nodiscard]] Eigen::MatrixXd patch_forces(const std::vector<Vector3d>& middles_mm, double width_mm) const;
  // Of a free body: without resultant and moment; displacements without rigid part.
  [[nodiscard]] Eigen::MatrixXd answer(Eigen::MatrixXd forces_mN) const;
  void scale_modes();
  void reduce_modes();
  void scale_narrow_modes();
};

Result<ForceModes> ForceModes::create(geometry::TetMesh mesh, const std::vector<double>& youngs_kPa,
                                      double poisson_ratio, const ForceModeOptions& options, const Progress& progress) {
  progress.report(0.0, GLISSON_TEXT("Preparing the organ"));
  mechanics::StaticOptions body_options;
  body_options.poisson_ratio = poisson_ratio;
  body_options.order = mechanics::ElementOrder::linear;
  body_options.prescribed_displacements = true;
  const bool is_supported = !options.supports.empty();
  auto body = mechanics::prepare_body(std::move(mesh), youngs_kPa, options.supports, body_options,
                                      is_supported ? mechanics::Holding::required : mechanics::Holding::optional);
  if (!body) return failure(std::move(body.error()));
  auto impl = std::make_shared<Impl>();
  impl->is_supported = is_supported;
  impl->body = *std::move(body);
  impl->surface = geometry::boundary_surface(impl->body.mesh);
  for (const double point : geometry::find_field(impl->surface.point_fields, "mesh_point")->values) {
    impl->mesh_point_of.push_back(static_cast<int>(point));
  }
  impl->areas_mm2 = areas_of_points(impl->surface);
  impl->centers_mm = spread(impl->surface.points_mm, options.patches);
  if (is_supported) impl->narrow_centers_mm = spread(impl->surface.points_mm, options.narrow_patches);
  impl->lay_out_rigid_motions();

  Eigen::SparseMatrix<double> matrix = mechanics::assemble_stiffness(impl->body);
  if (!is_supported) {
    const double mean_diagonal = matrix.diagonal().sum() / impl->mass_kg.sum();
    for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
      matrix.coeffRef(i, i) += softest_spring * mean_diagonal * impl->mass_kg[i] * 1e-2;
    }
  }
  auto system = mechanics::ConstrainedSystem::create(matrix, impl->body.resolved.fixed, body_options.memory_limit_bytes,
                                                     progress.part(0.1, 0.5));
  if (!system) return failure(std::move(system.error()));
  impl->system = std::move(*system);
  const double wide_mm = options.overlap * std::sqrt(impl->area_mm2() / static_cast<double>(impl->centers_mm.size()));
  impl->modes_mm = impl->answer(impl->patch_forces(impl->centers_mm, wide_mm));
  impl->scale_modes();
  impl->reduce_modes();
  impl->narrow_modes_mm = impl->answer(impl->patch_forces(impl->narrow_centers_mm, options.narrow_mm));
  impl->scale_narrow_modes();
  if (progress.cancelled()) return cancelled();
  return ForceModes(std::move(impl));
}

void ForceModes::Impl::lay_out_rigid_motions() {
  const geometry::TetMesh& mesh = body.mesh;
  const auto points = static_cast<Eigen::Index>(mesh.points_mm.size());
  mass_kg = Eigen::VectorXd::Zero(3 * points);
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    const double quarter_kg = 0.25 * density_kg_mm3 * geometry::cell_volume_mm3(mesh, c);
    for (const int p : mesh.cells[c]) mass_kg.segment<3>(3 * p).array() += quarter_kg;
  }
  centroid_mm.setZero();
  for (Eigen::Index p = 0; p < points; ++p) {
    centroid_mm += mass_kg[3 * p] * mesh.points_mm[static_cast<std::size_t>(p)] / (mass_kg.sum() / 3);
  }
  rigid = Eigen::MatrixXd::Zero(3 * points, 6);
  for (Eigen::Index p = 0; p < points; ++p) {
    const Vector3d arm_mm = mesh.points_mm[static_cast<std::size_t>(p)] - centroid_mm;
    rigid.block<3, 3>(3 * p, 0).setIdentity();
    for (int axis = 0; axis < 3; ++axis) rigid.block<3, 1>(3 * p, 3 + axis) = Vector3d::Unit(axis).cross(arm_mm);
  }
  const Eigen::MatrixXd weighed = mass_kg.asDiagonal() * rigid;
  const Eigen::Matrix<double, 6, 6> inertia = rigid.transpose() * weighed;
  rigid_weight = inertia.ldlt().solve(weighed.transpose());
}

Eigen::MatrixXd ForceModes::Impl::patch_forces(const std::vector<Vector3d>& middles_mm, double width_mm) const {
  Eigen::MatrixXd forces = Eigen::MatrixXd::Zero(rigid.rows(), 3 * static_cast<Eigen::Index>(middles_mm.size()));
  for (std::size_t k = 0; k < middles_mm.size(); ++k) {
    std::vector<double> weights(areas_mm2.size());
    for (std::size_t p = 0; p < weights.size(); ++p) {
      const double away = (surface.points_mm[p] - middles_mm[k]).squaredNorm() / (width_mm * width_mm);
      weights[p] = areas_mm2[p] * std::exp(-0.5 * away);
    }
    const double all = std::accumulate(weights.begin(), weights.end(), 0.0);
    for (std::size_t p = 0; p < weights.size(); ++p) {
      for (int axis = 0; axis < 3; ++axis) {
        forces(3 * mesh_point_of[p] + axis, 3 * static_cast<Eigen::Index>(k) + axis) = weights[p] / all;
      }
    }
  }
  return forces;
}

Eigen::MatrixXd ForceModes::Impl::answer(Eigen::MatrixXd forces_mN) const {
  if (is_supported) return system->respond(forces_mN).u;
  forces_mN -= rigid_weight.transpose() * (rigid.transpose() * forces_mN);
  Eigen::MatrixXd moved_mm = system->respond(forces_mN).u;
  moved_mm -= rigid * (rigid_weight * moved_mm);
  return moved_mm;
}

void ForceModes::Impl::scale_modes() {
  double sum = 0;
  for (const int p : mesh_point_of) sum += modes_mm.middleRows<3>(3 * p).squaredNorm();
  const double rms_mm = std::sqrt(sum / static_cast<double>(mesh_point_of.size()));
  if (rms_mm > 0) modes_mm /= rms_mm;
}

void ForceModes::Impl::reduce_modes() {
  reduced_amounts = leading_vectors(modes_mm.transpose() * modes_mm, reduced_share).transpose();
  reduced_basis_mm = modes_mm * reduced_amounts.transpose();
}

void ForceModes::Impl::scale_narrow_modes() {
  constexpr double barely = 1e-3;  // of what moves most: beside a support, which no force moves
  const geometry::NearestPoint nearest(surface.points_mm);
  Eigen::VectorXd own_mm(static_cast<Eigen::Index>(narrow_centers_mm.size()));
  for (Eigen::Index k = 0; k < own_mm.size(); ++k) {
    const int at = nearest.nearest(narrow_centers_mm[static_cast<std::size_t>(k)]).point;
    own_mm[k] =
        narrow_modes_mm.block<3, 3>(3 * mesh_point_of[static_cast<std::size_t>(at)], 3 * k).norm() / std::sqrt(3.0);
  }
  const double most_mm = own_mm.size() > 0 ? own_mm.maxCoeff() : 0;
  for (Eigen::Index k = 0; k < own_mm.size(); ++k) {
    narrow_modes_mm.middleCols<3>(3 * k) *= own_mm[k] > barely * most_mm ? 1 / own_mm[k] : 0.0;
  }
}

const geometry::TetMesh& ForceModes::mesh() const { return impl_->body.mesh; }
const geometry::Surface& ForceModes::surface() const { return impl_->surface; }
const std::vector<int>& ForceModes::mesh_point_of() const { return impl_->mesh_point_of; }
const Eigen::MatrixXd& ForceModes::displacement_mm() const { return impl_->modes_mm; }
const std::vector<Vector3d>& ForceModes::centers_mm() const { return impl_->centers_mm; }
const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>& ForceModes::reduced_basis_mm() const {
  return impl_->reduced_basis_mm;
}
const Eigen::MatrixXd& ForceModes::reduced_amounts() const { return impl_->reduced_amounts; }
const Eigen::MatrixXd& ForceModes::narrow_displacement_mm() const { return impl_->narrow_modes_mm; }
const std::vector<Vector3d>& ForceModes::narrow_centers_mm() const { return impl_->narrow_centers_mm; }
bool ForceModes::is_supported() const { return impl_->is_supported; }
const Vector3d& ForceModes::centroid_mm() const { return impl_->centroid_mm; }
const mechanics::Body& ForceModes::body() const { return impl_->body; }

MatrixXd ForceModes::forces_mN(const MatrixXd& displacement_mm) const {
  return impl_->system->lower().selfadjointView<Eigen::Lower>() * displacement_mm;
}

Eigen::MatrixXd ForceModes::under_tool_mm_mN(const Vector3d& center_mm, double radius_mm) const {
  std::vector<double> weights(impl_->areas_mm2.size(), 0.0);
  std::size_t nearest = 0;
  for (std::size_t p = 0; p < weights.size(); ++p) {
    const double away_mm = (impl_->surface.points_mm[p] - center_mm).norm();
    if (away_mm <= radius_mm) weights[p] = impl_->areas_mm2[p];
    if (away_mm < (impl_->surface.points_mm[nearest] - center_mm).norm()) nearest = p;
  }
  if (std::all_of(weights.begin(), weights.end(), [](double weight) { return weight == 0; })) weights[nearest] = 1;
  const double all = std::accumulate(weights.begin(), weights.end(), 0.0);
  Eigen::MatrixXd forces = Eigen::MatrixXd::Zero(impl_->rigid.rows(), 3);
  for (std::size_t p = 0; p < weights.size(); ++p) {
    for (int axis = 0; axis < 3; ++axis) forces(3 * impl_->mesh_point_of[p] + axis, axis) += weights[p] / all;
  }
  return impl_->answer(std::move(forces));
}

Eigen::VectorXd ForceModes::known_mm(const Vector3d& acceleration_mm_s2) const {
  Eigen::MatrixXd forces = impl_->mass_kg;
  for (Eigen::Index p = 0; p < forces.rows() / 3; ++p)
    forces.block<3, 1>(3 * p, 0).array() *= acceleration_mm_s2.array();
  if (impl_->is_supported) return impl_->system->solve(forces, impl_->body.resolved.prescribed_mm, {}).front().u;
  // A free body in a uniform field falls without deforming: what deforms it is what holds it, which is not known.
  // Held by all of its surface evenly, as by its neighbours, the interior sinks against the surface.
  const Vector3d weight_mN = 1.0 / 3.0 * impl_->mass_kg.sum() * acceleration_mm_s2;
  const double area_mm2 = impl_->area_mm2();
  for (std::size_t p = 0; p < impl_->areas_mm2.size(); ++p) {
    forces.block<3, 1>(3 * impl_->mesh_point_of[p], 0) -= impl_->areas_mm2[p] / area_mm2 * weight_mN;
  }
  return impl_->answer(std::move(forces));
}

}  // namespace glisson::guidance
