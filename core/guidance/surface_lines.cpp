#include "guidance/surface_lines.h"

#include <algorithm>
#include <map>
#include <optional>

namespace glisson::guidance {

namespace {

using Edge = std::array<int, 2>;

// Across one triangle, from edge to edge.
struct Crossing {
  int triangle = 0;
  std::array<Edge, 2> edges;
};

Edge edge_between(int a, int b) { return a < b ? Edge{a, b} : Edge{b, a}; }

// Crossings that meet on an edge become one line. Where three meet, lines end.
class Chain {
 public:
  Chain(std::vector<Crossing> crossings, std::map<Edge, double> shares)
      : crossings_(std::move(crossings)), shares_(std::move(shares)), used_(crossings_.size(), false) {
    for (std::size_t c = 0; c < crossings_.size(); ++c) {
      for (const Edge& edge : crossings_[c].edges) at_[edge].push_back(c);
    }
  }

  std::vector<SurfaceLine> lines() {
    std::vector<SurfaceLine> lines;
    // From open ends first: what is left then are rings.
    for (const bool from_ends : {true, false}) {
      for (std::size_t c = 0; c < crossings_.size(); ++c) {
        for (const Edge& edge : crossings_[c].edges) {
          if (used_[c] || (from_ends && at_[edge].size() == 2)) continue;
          lines.push_back(walk(c, edge));
        }
      }
    }
    return lines;
  }

 private:
  SurfaceLine walk(std::size_t crossing, Edge from) {
    SurfaceLine line;
    line.places.push_back(place(from));
    for (std::optional<std::size_t> next = crossing; next;) {
      const Crossing& here = crossings_[*next];
      used_[*next] = true;
      from = here.edges[0] == from ? here.edges[1] : here.edges[0];
      line.triangles.push_back(here.triangle);
      line.places.push_back(place(from));
      next.reset();
      for (const std::size_t other : at_[from]) {
        if (!used_[other] && at_[from].size() == 2) next = other;
      }
    }
    return line;
  }
  [[nodiscard]] EdgePlace place(const Edge& edge) const { return {edge[0], edge[1], shares_.at(edge)}; }

  std::vector<Crossing> crossings_;
  std::map<Edge, double> shares_;
  std::vector<bool> used_;
  std::map<Edge, std::vector<std::size_t>> at_;
};

// `share_of` says where an edge is crossed, if it is.
template <typename ShareOf>
std::vector<SurfaceLine> lines_across(const geometry::Surface& organ, const ShareOf& share_of) {
  std::vector<Crossing> crossings;
  std::map<Edge, double> shares;
  for (std::size_t t = 0; t < organ.triangles.size(); ++t) {
    const auto& [a, b, c] = organ.triangles[t];
    std::vector<Edge> crossed;
    for (const Edge& edge : {edge_between(a, b), edge_between(b, c), edge_between(c, a)}) {
      const std::optional<double> share = share_of(edge);
      if (!share) continue;
      shares[edge] = *share;
      crossed.push_back(edge);
    }
    // Three labels at one triangle: their borders meet within it.
    for (std::size_t k = 1; k < crossed.size(); ++k) {
      crossings.push_back({static_cast<int>(t), {crossed[k - 1], crossed[k]}});
    }
  }
  return Chain(std::move(crossings), std::move(shares)).lines();
}

}  // namespace

std::vector<SurfaceLine> zero_lines(const geometry::Surface& organ, const std::vector<double>& values) {
  return lines_across(organ, [&](const Edge& edge) -> std::optional<double> {
    const double a = values[static_cast<std::size_t>(edge[0])], b = values[static_cast<std::size_t>(edge[1])];
    if ((a < 0) == (b < 0)) return std::nullopt;
    return a / (a - b);
  });
}

std::vector<SurfaceLine> border_lines(const geometry::Surface& organ, const std::vector<int>& labels) {
  return lines_across(organ, [&](const Edge& edge) -> std::optional<double> {
    const int a = labels[static_cast<std::size_t>(edge[0])], b = labels[static_cast<std::size_t>(edge[1])];
    if (a == b || a == 0 || b == 0) return std::nullopt;
    return 0.5;
  });
}

std::vector<Eigen::Vector3d> places_of(const SurfaceLine& line, const std::vector<Eigen::Vector3d>& now_mm) {
  std::vector<Eigen::Vector3d> places;
  for (const auto& [a, b, share] : line.places) {
    places.emplace_back((1 - share) * now_mm[static_cast<std::size_t>(a)] +
                        share * now_mm[static_cast<std::size_t>(b)]);
  }
  return places;
}

}  // namespace glisson::guidance
