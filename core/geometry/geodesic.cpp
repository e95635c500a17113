#include "geometry/geodesic.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_shortest_path.h>

#include "base/parallel.h"
#include "geometry/disjoint_sets.h"
#include "geometry/internal/heat_method.h"

namespace glisson::geometry {
namespace {

using GeodesicKernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<GeodesicKernel::Point_3>;
using Vertex = Mesh::Vertex_index;

Vertex vertex(int point) { return Vertex(static_cast<Mesh::size_type>(point)); }

bool is_in_pieces(const Surface& surface) {
  DisjointSets sets(surface.points_mm.size());
  for (const auto& [a, b, c] : surface.triangles) {
    sets.join(static_cast<std::size_t>(a), static_cast<std::size_t>(b));
    sets.join(static_cast<std::size_t>(b), static_cast<std::size_t>(c));
  }
  for (std::size_t point = 1; point < surface.points_mm.size(); ++point) {
    if (sets.root(point) != sets.root(0)) return true;
  }
  return false;
}

Result<Mesh> cgal_mesh(const Surface& surface) {
  if (auto good = check_surface(surface); !good) return failure(good.error());
  if (is_in_pieces(surface)) {
    return failure(Error{"surface-in-pieces",
                         GLISSON_TEXT("The surface is in pieces, between which there is no way along it."),
                         {},
                         GLISSON_TEXT("Keep its largest piece."),
                         {}});
  }
  Mesh mesh;
  mesh.reserve(static_cast<Mesh::size_type>(surface.points_mm.size()),
               static_cast<Mesh::size_type>(surface.triangles.size() * 3 / 2),
               static_cast<Mesh::size_type>(surface.triangles.size()));
  for (const Eigen::Vector3d& point : surface.points_mm) mesh.add_vertex({point.x(), point.y(), point.z()});
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    const auto& [a, b, c] = surface.triangles[t];
    if (mesh.add_face(vertex(a), vertex(b), vertex(c)) == Mesh::null_face()) {
      return failure(Error{"surface-not-manifold",
                           GLISSON_TEXT("Triangle {0} does not fit its neighbours: an edge has more than two "
                                        "triangles, or they are turned against each other."),
                           {std::to_string(t)},
                           GLISSON_TEXT("Mesh the surface anew, for example with MeshLab."),
                           {}});
    }
  }
  return mesh;
}

}  // namespace

HeatGeodesics::HeatGeodesics(std::unique_ptr<const HeatMethod> method) : method_(std::move(method)) {}
HeatGeodesics::HeatGeodesics(HeatGeodesics&&) noexcept = default;
HeatGeodesics& HeatGeodesics::operator=(HeatGeodesics&&) noexcept = default;
HeatGeodesics::~HeatGeodesics() = default;

Result<HeatGeodesics> HeatGeodesics::prepare(const Surface& surface) {
  if (const auto mesh = cgal_mesh(surface); !mesh) return failure(mesh.error());
  const auto points = static_cast<Eigen::Index>(surface.points_mm.size());
  if (auto method = HeatMethod::on(intrinsic_delaunay(surface), points)) {
    return HeatGeodesics(std::make_unique<const HeatMethod>(std::move(*method)));
  }
  return failure(Error{"geodesic-singular",
                       GLISSON_TEXT("Heat cannot spread over the surface: it has flat triangles."),
                       {},
                       GLISSON_TEXT("Mesh the surface anew, for example with MeshLab."),
                       {}});
}

Eigen::VectorXd HeatGeodesics::distances_mm(int from_point) const {
  GLISSON_ASSERT(from_point >= 0 && from_point < method_->points());
  return method_->distances_mm<1>(&from_point, 1);
}

Eigen::MatrixXd HeatGeodesics::distances_mm(const std::vector<int>& from_points) const {
  const auto sources = static_cast<Eigen::Index>(from_points.size());
  const Eigen::Index groups = (sources + sources_together - 1) / sources_together;
  Eigen::MatrixXd distances(sources, method_->points());
  parallel_for(static_cast<std::size_t>(groups), 1, [&](std::size_t begin, std::size_t end) {
    for (auto group = static_cast<Eigen::Index>(begin); group < static_cast<Eigen::Index>(end); ++group) {
      const Eigen::Index first = group * sources_together;
      const Eigen::Index count = std::min<Eigen::Index>(sources_together, sources - first);
      distances.middleRows(first, count) =
          method_->distances_mm<sources_together>(from_points.data() + first, static_cast<int>(count))
              .leftCols(count)
              .transpose();
    }
  });
  return distances;
}

Result<std::vector<double>> exact_geodesic_distances_mm(const Surface& surface, int from_point) {
  const auto mesh = cgal_mesh(surface);
  if (!mesh) return failure(mesh.error());
  using Traits = CGAL::Surface_mesh_shortest_path_traits<GeodesicKernel, Mesh>;
  CGAL::Surface_mesh_shortest_path<Traits> paths(*mesh);
  paths.add_source_point(vertex(from_point));
  std::vector<double> distances_mm;
  distances_mm.reserve(mesh->number_of_vertices());
  for (const Vertex v : mesh->vertices()) distances_mm.push_back(paths.shortest_distance_to_source_points(v).first);
  return distances_mm;
}

}  // namespace glisson::geometry
