// Finite elements: jumps at points of crossed cells (jump_functions.h), three amplitudes each.

#include <algorithm>

#include "mechanics/cutting/internal/jump_functions.h"
#include "mechanics/cutting/internal/opening_functions.h"

namespace glisson::mechanics {
namespace {

std::vector<double> volumes_around_mm3(const geometry::TetMesh& mesh);
bool is_fixed(const Body& body, int point);

class PointJumps : public OpeningFunctions {
 public:
  PointJumps(const Body& body, const Crossing& crossing, const Eigen::Vector3d& begin_mm,
             const Eigen::Vector3d& forward);

  [[nodiscard]] Eigen::MatrixXd stiffness_between(const std::vector<int>& rows,
                                                  const std::vector<int>& columns) const override {
    return mechanics::stiffness_between(body_, crossing_, of(rows), of(columns));
  }
  [[nodiscard]] Eigen::VectorXd load_on(const Loads& loads) const override {
    return mechanics::load_on(body_, crossing_, loads, points_);
  }
  void take_off(const SeenPart& part, const std::vector<int>& functions, Eigen::MatrixXd& seen_mm) const override;
  // A node's displacement stays what it was without the cut.
  [[nodiscard]] Eigen::VectorXd of_nodes_mm(int /*function*/, const Eigen::VectorXd& /*amplitudes*/) const override {
    return Eigen::VectorXd::Zero(coupling.rows());
  }
  [[nodiscard]] bool meets(int /*function*/, const OpeningFunctions& /*others*/, int /*other*/) const override {
    return false;  // but in cells that they share, which is looked for apart
  }

 private:
  [[nodiscard]] std::vector<int> of(const std::vector<int>& functions) const {
    std::vector<int> points;
    for (const int f : functions) points.push_back(points_[static_cast<std::size_t>(f)]);
    return points;
  }

  const Body& body_;
  const Crossing& crossing_;
  std::vector<int> points_;  // of the mesh, one a function
};

}  // namespace

std::unique_ptr<const OpeningFunctions> point_jumps(const Body& body, const Crossing& crossing,
                                                    const Eigen::Vector3d& begin_mm, const Eigen::Vector3d& forward) {
  return std::make_unique<PointJumps>(body, crossing, begin_mm, forward);
}

namespace {

// Points that are fixed stay together, and so do those whose function would fill next to nothing of their cells.
PointJumps::PointJumps(const Body& body, const Crossing& crossing, const Eigen::Vector3d& begin_mm,
                       const Eigen::Vector3d& forward)
    : body_(body), crossing_(crossing) {
  const std::vector<double> around_mm3 = volumes_around_mm3(body.mesh);
  std::vector<std::pair<double, int>> in_order;
  for (std::size_t p = 0; p < body.mesh.points_mm.size(); ++p) {
    const int point = static_cast<int>(p);
    if (crossing.cells_of_point[p].empty() || is_fixed(body, point)) continue;
    constexpr double next_to_nothing = 1e-4;
    if (share_filled(body.mesh, crossing, point, around_mm3) < next_to_nothing) continue;
    in_order.emplace_back((body.mesh.points_mm[p] - begin_mm).dot(forward), point);
  }
  std::sort(in_order.begin(), in_order.end());
  std::vector<Eigen::Triplet<double>> ones;
  for (const auto& [along_mm, point] : in_order) {
    for (int axis = 0; axis < 3; ++axis) {
      ones.emplace_back(3 * point + axis, 3 * static_cast<int>(points_.size()) + axis, 1.0);
    }
    points_.push_back(point);
    points_of.push_back({point});
    at_mm.push_back(along_mm);
  }
  coupling = mechanics::coupling(body, crossing, points_);
  jumps.resize(3 * static_cast<Eigen::Index>(body.mesh.points_mm.size()), coupling.cols());
  jumps.setFromTriplets(ones.begin(), ones.end());
}

void PointJumps::take_off(const SeenPart& part, const std::vector<int>& functions, Eigen::MatrixXd& seen_mm) const {
  const std::vector<int> points = of(functions);
  for (const SeenPart::Place& place : part.places) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double value = value_at(body_.mesh, crossing_, points[i], place.at);
      if (value != 0) seen_mm.block<3, 3>(place.row, 3 * static_cast<Eigen::Index>(i)).diagonal().array() -= value;
    }
  }
}

std::vector<double> volumes_around_mm3(const geometry::TetMesh& mesh) {
  std::vector<double> volumes_mm3(mesh.points_mm.size(), 0.0);
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    for (const int point : mesh.cells[c]) volumes_mm3[point] += geometry::cell_volume_mm3(mesh, c);
  }
  return volumes_mm3;
}

bool is_fixed(const Body& body, int point) {
  const auto first = body.resolved.fixed.begin() + 3 * static_cast<std::ptrdiff_t>(body.layout.node_of_point[point]);
  return std::any_of(first, first + 3, [](std::uint8_t fixed) { return fixed != 0; });
}

}  // namespace
}  // namespace glisson::mechanics
