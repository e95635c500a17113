#include "geometry/geodesic.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Heat_method_3/Surface_mesh_geodesic_distances_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_shortest_path.h>

#include "geometry/disjoint_sets.h"

namespace glisson::geometry {
namespace {

using GeodesicKernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<GeodesicKernel::Point_3>;
using Vertex = Mesh::Vertex_index;
using Heat = CGAL::Heat_method_3::Surface_mesh_geodesic_distances_3<Mesh>;

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

struct HeatGeodesics::Inside {
  explicit Inside(Mesh surface) : mesh(std::move(surface)), heat(mesh) {}

  Mesh mesh;
  Heat heat;
};

HeatGeodesics::HeatGeodesics(std::unique_ptr<Inside> inside) : inside_(std::move(inside)) {}
HeatGeodesics::HeatGeodesics(HeatGeodesics&&) noexcept = default;
HeatGeodesics& HeatGeodesics::operator=(HeatGeodesics&&) noexcept = default;
HeatGeodesics::~HeatGeodesics() = default;

Result<HeatGeodesics> HeatGeodesics::prepare(const Surface& surface) {
  auto mesh = cgal_mesh(surface);
  if (!mesh) return failure(mesh.error());
  try {
    return HeatGeodesics(std::make_unique<Inside>(std::move(*mesh)));
  } catch (const std::exception&) {
    return failure(Error{"geodesic-singular",
                         GLISSON_TEXT("Heat cannot spread over the surface: it has flat triangles."),
                         {},
                         GLISSON_TEXT("Mesh the surface anew, for example with MeshLab."),
                         {}});
  }
}

std::vector<double> HeatGeodesics::distances_mm(int from_point) {
  auto& [mesh, heat] = *inside_;
  GLISSON_ASSERT(from_point >= 0 && static_cast<std::size_t>(from_point) < mesh.number_of_vertices());
  const auto distance_of = mesh.add_property_map<Vertex, double>("v:distance_mm", 0.0).first;
  heat.clear_sources();
  heat.add_source(vertex(from_point));
  heat.estimate_geodesic_distances(distance_of);
  std::vector<double> distances_mm;
  distances_mm.reserve(mesh.number_of_vertices());
  for (const Vertex v : mesh.vertices()) distances_mm.push_back(distance_of[v]);
  return distances_mm;
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
