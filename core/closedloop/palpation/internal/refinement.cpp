#include "closedloop/palpation/internal/refinement.h"

#include <algorithm>
#include <Eigen/LU>
#include <map>

#include "mechanics/elements/shape_functions.h"
#include "mechanics/potentials/stiffness_matrix.h"

namespace glisson::closedloop {
namespace {

// Children of a cell by its local nodes: four at the corners, four around a diagonal of the octahedron that is left.
using Child = std::array<int, 4>;
std::vector<Child> children_of(const std::array<int, 10>& nodes, const std::vector<Eigen::Vector3d>& positions_mm);

struct FineBody {
  mechanics::Body body;
  Eigen::MatrixXd loads_mN;
  // A fine node's displacement by the coarse cell that holds it.
  std::vector<int> coarse_cell;
  std::vector<Eigen::Matrix<double, 10, 1>> weights;
};
Result<FineBody> fine_body(const PalpationSolver& solver, const std::vector<FaceLoad>& loads);

Eigen::MatrixXd prolonged(const FineBody& fine, const mechanics::NodeLayout& coarse, const Eigen::MatrixXd& coarse_u) {
  Eigen::MatrixXd u = Eigen::MatrixXd::Zero(3 * fine.body.layout.nodes(), coarse_u.cols());
  for (std::size_t n = 0; n < fine.weights.size(); ++n) {
    const auto& nodes = coarse.cells[static_cast<std::size_t>(fine.coarse_cell[n])];
    for (int k = 0; k < 10; ++k) {
      if (fine.weights[n][k] != 0) {
        u.middleRows<3>(3 * static_cast<Eigen::Index>(n)) += fine.weights[n][k] * coarse_u.middleRows<3>(3 * nodes[k]);
      }
    }
  }
  return u;
}

Eigen::MatrixXd restricted(const FineBody& fine, const mechanics::NodeLayout& coarse, const Eigen::MatrixXd& fine_f) {
  Eigen::MatrixXd f = Eigen::MatrixXd::Zero(3 * coarse.nodes(), fine_f.cols());
  for (std::size_t n = 0; n < fine.weights.size(); ++n) {
    const auto& nodes = coarse.cells[static_cast<std::size_t>(fine.coarse_cell[n])];
    for (int k = 0; k < 10; ++k) {
      if (fine.weights[n][k] != 0) {
        f.middleRows<3>(3 * nodes[k]) += fine.weights[n][k] * fine_f.middleRows<3>(3 * static_cast<Eigen::Index>(n));
      }
    }
  }
  return f;
}

}  // namespace

std::vector<FaceLoad> tool_loads(const Palpation& experiment, const std::vector<History>& histories,
                                 const mechanics::Body& body) {
  std::vector<FaceLoad> tools;
  for (std::size_t t = 0; t < histories.size(); ++t) {
    if (histories[t].load != static_cast<Eigen::Index>(tools.size())) continue;  // a tool that is known already
    const PalpationTool& tool = experiment.trials[t].tool;
    FaceLoad load{
        histories[t].load, mechanics::faces_within(body.boundary, tool.center_mm, tool.radius_mm).value(), {}};
    double area_mm2 = 0;
    for (const std::size_t face : load.faces) area_mm2 += body.boundary[face].area_mm2;
    load.traction_kPa = tool.direction / area_mm2;
    tools.push_back(std::move(load));
  }
  return tools;
}

Eigen::MatrixXd discretisation_error_mm(const PalpationSolver& solver,
                                        const std::vector<Eigen::Vector3d>& marker_places_mm,
                                        const std::vector<FaceLoad>& loads) {
  const SpecimenBody& specimen = solver.specimen();
  const mechanics::NodeLayout& coarse = specimen.body.layout;
  if (specimen.body.mesh.cells.size() > maximum_cells_refined || loads.empty()) return {};
  const auto declared = solver.solution({});
  const auto fine = fine_body(solver, loads);
  if (!declared || !fine) return {};

  const Eigen::SparseMatrix<double> lower = mechanics::assemble_stiffness(fine->body);
  const auto stiffness = lower.selfadjointView<Eigen::Lower>();
  Eigen::VectorXd is_free(lower.rows());
  for (Eigen::Index i = 0; i < is_free.size(); ++i) {
    is_free[i] = fine->body.resolved.fixed[static_cast<std::size_t>(i)] ? 0.0 : 1.0;
  }
  const Eigen::VectorXd inverse_diagonal = is_free.cwiseQuotient(lower.diagonal());
  const auto precondition = [&](const Eigen::MatrixXd& residual) -> Eigen::MatrixXd {
    const Eigen::MatrixXd long_ranged = PalpationSolver::solve(**declared, restricted(*fine, coarse, residual));
    return inverse_diagonal.asDiagonal() * residual + is_free.asDiagonal() * prolonged(*fine, coarse, long_ranged);
  };

  constexpr int steps = 12;  // enough for what is short-ranged: the header
  std::vector<Eigen::Index> columns;
  for (const FaceLoad& load : loads) columns.push_back(load.load);
  const Eigen::MatrixXd coarse_mm = (*declared)->u_mm(Eigen::all, columns);
  Eigen::MatrixXd correction_mm = Eigen::MatrixXd::Zero(lower.rows(), coarse_mm.cols());
  Eigen::MatrixXd residual =
      is_free.asDiagonal() * (fine->loads_mN - stiffness * prolonged(*fine, coarse, coarse_mm)).eval();
  Eigen::MatrixXd direction = precondition(residual);
  Eigen::RowVectorXd energy = residual.cwiseProduct(direction).colwise().sum();
  for (int step = 0; step < steps; ++step) {
    const Eigen::MatrixXd product = is_free.asDiagonal() * (stiffness * direction).eval();
    const Eigen::RowVectorXd curvature = direction.cwiseProduct(product).colwise().sum();
    const Eigen::RowVectorXd length =
        (curvature.array() > 0)
            .select(energy.array() / curvature.array(), 0.0);  // a load on what is held moves nothing
    correction_mm += direction * length.asDiagonal();
    residual -= product * length.asDiagonal();
    const Eigen::MatrixXd next = precondition(residual);
    const Eigen::RowVectorXd now = residual.cwiseProduct(next).colwise().sum();
    const Eigen::RowVectorXd turn = (energy.array() > 0).select(now.array() / energy.array(), 0.0);
    direction = (next + direction * turn.asDiagonal()).eval();
    energy = now;
  }

  const Interpolation at(fine->body.layout, mechanics::locate_points(fine->body.mesh, marker_places_mm));
  const Eigen::MatrixXd fine_mm = prolonged(*fine, coarse, coarse_mm) + correction_mm;
  return error_of_first_step * (at.at_places(fine_mm) - solver.markers().at_places(coarse_mm));
}

Result<PalpationSolver> refined_solver(const PalpationSolver& solver,
                                       const std::vector<Eigen::Vector3d>& marker_places_mm,
                                       const std::vector<FaceLoad>& loads) {
  auto fine = fine_body(solver, loads);
  if (!fine) return failure(std::move(fine.error()));
  SpecimenBody specimen;
  specimen.elements = elements_of(fine->body);
  specimen.body = std::move(fine->body);
  Interpolation markers(specimen.body.layout, mechanics::locate_points(specimen.body.mesh, marker_places_mm));
  return PalpationSolver::create(std::move(specimen), std::move(fine->loads_mN), std::move(markers), {});
}

geometry::TetMesh refined(const mechanics::Body& body) {
  geometry::TetMesh fine;
  fine.points_mm = body.layout.positions_mm;
  fine.cells.reserve(8 * body.layout.cells.size());
  for (const auto& nodes : body.layout.cells) {
    for (const Child& child : children_of(nodes, body.layout.positions_mm)) {
      fine.cells.push_back({nodes[child[0]], nodes[child[1]], nodes[child[2]], nodes[child[3]]});
    }
  }
  return fine;
}

namespace {

std::vector<Child> children_of(const std::array<int, 10>& nodes, const std::vector<Eigen::Vector3d>& positions_mm) {
  // Middles: 4 of 0-1, 5 of 1-2, 6 of 2-0, 7 of 0-3, 8 of 1-3, 9 of 2-3. The shortest of the three diagonals makes the
  // best cells.
  std::vector<Child> children{{0, 4, 6, 7}, {4, 1, 5, 8}, {6, 5, 2, 9}, {7, 8, 9, 3}};
  constexpr std::array<std::array<int, 2>, 3> diagonals{{{4, 9}, {5, 7}, {6, 8}}};
  constexpr std::array<std::array<int, 4>, 3> around{{{5, 8, 7, 6}, {4, 6, 9, 8}, {4, 5, 9, 7}}};
  const auto length = [&](const std::array<int, 2>& ends) {
    return (positions_mm[static_cast<std::size_t>(nodes[ends[0]])] -
            positions_mm[static_cast<std::size_t>(nodes[ends[1]])])
        .squaredNorm();
  };
  std::size_t shortest = 0;
  for (std::size_t d = 1; d < 3; ++d) {
    if (length(diagonals[d]) < length(diagonals[shortest])) shortest = d;
  }
  const auto [a, b] = diagonals[shortest];
  for (std::size_t i = 0; i < 4; ++i) {
    children.push_back({a, b, around[shortest][i], around[shortest][(i + 1) % 4]});
  }
  for (Child& child : children) {
    const auto at = [&](int i) -> const Eigen::Vector3d& {
      return positions_mm[static_cast<std::size_t>(nodes[child[static_cast<std::size_t>(i)]])];
    };
    Eigen::Matrix3d edges;
    edges << at(1) - at(0), at(2) - at(0), at(3) - at(0);
    if (edges.determinant() < 0) std::swap(child[2], child[3]);
  }
  return children;
}

// Barycentric coordinates of a coarse cell's ten nodes.
Eigen::Vector4d place_of(int local_node) {
  if (local_node < 4) return Eigen::Vector4d::Unit(local_node);
  const auto& [a, b] = mechanics::edges_of_cell[static_cast<std::size_t>(local_node - 4)];
  return 0.5 * (Eigen::Vector4d::Unit(a) + Eigen::Vector4d::Unit(b));
}

Result<FineBody> fine_body(const PalpationSolver& solver, const std::vector<FaceLoad>& loads) {
  const mechanics::Body& coarse = solver.specimen().body;
  geometry::TetMesh mesh = refined(coarse);
  std::vector<double> youngs_kPa;
  for (const double of_cell : coarse.youngs_kPa) youngs_kPa.insert(youngs_kPa.end(), 8, of_cell);

  // What is held stays held, direction by direction; whole coarse faces stay whole.
  std::vector<mechanics::Support> supports;
  for (int d = 0; d < 3; ++d) {
    geometry::Field field{"held_" + std::to_string(d), 1, {}};
    bool any = false;
    for (int n = 0; n < coarse.layout.nodes(); ++n) {
      field.values.push_back(coarse.resolved.fixed[static_cast<std::size_t>(3 * n + d)]);
      any |= field.values.back() != 0;
    }
    if (!any) continue;
    supports.push_back({mechanics::NamedPoints{field.name}, mechanics::Fixed{{d == 0, d == 1, d == 2}}});
    geometry::set_field(mesh.point_fields, std::move(field));
  }
  auto body = mechanics::prepare_body(std::move(mesh), std::move(youngs_kPa), std::move(supports), coarse.options,
                                      mechanics::Holding::optional);
  if (!body) return failure(std::move(body.error()));
  FineBody fine{std::move(*body), {}, {}, {}};

  // The four parts of each coarse face of the boundary.
  std::map<std::array<int, 3>, std::size_t> coarse_face;
  for (std::size_t f = 0; f < coarse.boundary.size(); ++f) {
    const auto& n = coarse.boundary[f].nodes;
    for (std::array<int, 3> part : {std::array{n[0], n[3], n[5]}, std::array{n[3], n[1], n[4]},
                                    std::array{n[5], n[4], n[2]}, std::array{n[3], n[4], n[5]}}) {
      std::sort(part.begin(), part.end());
      coarse_face[part] = f;
    }
  }
  std::vector<double> spring(coarse.boundary.size(), 0.0);
  for (const auto& foundation : coarse.resolved.foundations) spring[foundation.face] += foundation.stiffness_kPa_per_mm;

  fine.loads_mN = Eigen::MatrixXd::Zero(3 * fine.body.layout.nodes(), static_cast<Eigen::Index>(loads.size()));
  for (std::size_t f = 0; f < fine.body.boundary.size(); ++f) {
    const mechanics::BoundaryFace& face = fine.body.boundary[f];
    std::array<int, 3> corners = face.points;
    std::sort(corners.begin(), corners.end());
    const std::size_t parent = coarse_face.at(corners);
    if (spring[parent] > 0) fine.body.resolved.foundations.push_back({f, spring[parent]});
    for (std::size_t l = 0; l < loads.size(); ++l) {
      if (!std::binary_search(loads[l].faces.begin(), loads[l].faces.end(), parent)) continue;
      Eigen::VectorXd force_mN = fine.loads_mN.col(static_cast<Eigen::Index>(l));
      mechanics::add_traction(face, loads[l].traction_kPa, force_mN);
      fine.loads_mN.col(static_cast<Eigen::Index>(l)) = force_mN;
    }
  }

  // Where each fine node lies in a coarse cell: its points are coarse nodes, its middles lie between two of them.
  const auto nodes = static_cast<std::size_t>(fine.body.layout.nodes());
  fine.coarse_cell.assign(nodes, -1);
  fine.weights.resize(nodes);
  for (std::size_t c = 0; c < coarse.layout.cells.size(); ++c) {
    const auto children = children_of(coarse.layout.cells[c], coarse.layout.positions_mm);
    for (std::size_t i = 0; i < children.size(); ++i) {
      const auto& fine_nodes = fine.body.layout.cells[8 * c + i];
      const auto& fine_points = fine.body.mesh.cells[8 * c + i];
      const auto local = [&](int corner) {
        const auto& known = coarse.layout.cells[c];
        return static_cast<int>(std::find(known.begin(), known.end(), fine_points[static_cast<std::size_t>(corner)]) -
                                known.begin());
      };
      for (std::size_t k = 0; k < 10; ++k) {
        const auto node = static_cast<std::size_t>(fine_nodes[k]);
        if (fine.coarse_cell[node] >= 0) continue;
        const Eigen::Vector4d place = k < 4 ? place_of(local(static_cast<int>(k)))
                                            : (0.5 * (place_of(local(mechanics::edges_of_cell[k - 4][0])) +
                                                      place_of(local(mechanics::edges_of_cell[k - 4][1]))))
                                                  .eval();
        fine.coarse_cell[node] = static_cast<int>(c);
        fine.weights[node] = mechanics::tet_values(mechanics::ElementOrder::quadratic, place);
      }
    }
  }
  return fine;
}

}  // namespace
}  // namespace glisson::closedloop
