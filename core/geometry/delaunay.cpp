#include "geometry/delaunay.h"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

namespace glisson::geometry {

std::vector<std::array<int, 3>> delaunay_triangles(const std::vector<Eigen::Vector2d>& points) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Vertex = CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>;
  using Delaunay = CGAL::Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<Vertex>>;
  std::vector<std::pair<Kernel::Point_2, int>> numbered;
  for (std::size_t i = 0; i < points.size(); ++i) {
    numbered.emplace_back(Kernel::Point_2(points[i].x(), points[i].y()), static_cast<int>(i));
  }
  const Delaunay delaunay(numbered.begin(), numbered.end());
  std::vector<std::array<int, 3>> triangles;
  for (const auto face : delaunay.finite_face_handles()) {
    triangles.push_back({face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()});
  }
  return triangles;
}

}  // namespace glisson::geometry
