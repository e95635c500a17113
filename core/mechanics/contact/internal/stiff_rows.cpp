#include "mechanics/contact/internal/stiff_rows.h"

#include <map>

namespace glisson::mechanics {
namespace {

using Eigen::Vector3d;

// Points of faces see six nodes. Jaws see many, each of which they alone may see: they stay as they are.
bool sees_a_face(const StiffRow& row) { return row.on.size() <= 6; }

}  // namespace

CondensedRows condensed(const std::vector<StiffRow>& rows) {
  std::map<int, int> of_node, of_further;  // the first functional of each
  std::size_t at_faces = 0;
  for (const StiffRow& row : rows) {
    if (!sees_a_face(row)) continue;
    ++at_faces;
    for (const auto& share : row.on) of_node.try_emplace(share.first);
    if (row.further >= 0) of_further.try_emplace(row.further);
  }
  const bool by_node = 3 * of_node.size() + of_further.size() < at_faces;

  CondensedRows less;
  if (by_node) {
    for (auto& [node, first] : of_node) {
      first = static_cast<int>(less.functionals.size());
      for (int d = 0; d < 3; ++d) less.functionals.push_back({{{node, Vector3d::Unit(d)}}});
    }
    for (auto& [further, first] : of_further) {
      first = static_cast<int>(less.functionals.size());
      less.functionals.push_back({{}, further, 1});
    }
  }
  std::vector<Eigen::Triplet<double>> shares;
  for (int r = 0; r < static_cast<int>(rows.size()); ++r) {
    const StiffRow& row = rows[static_cast<std::size_t>(r)];
    if (!by_node || !sees_a_face(row)) {
      shares.emplace_back(r, static_cast<int>(less.functionals.size()), 1);
      less.functionals.push_back({row.on, row.further, row.along});
      continue;
    }
    for (const auto& [node, direction] : row.on) {
      for (int d = 0; d < 3; ++d) shares.emplace_back(r, of_node.at(node) + d, direction[d]);
    }
    if (row.further >= 0) shares.emplace_back(r, of_further.at(row.further), row.along);
  }
  less.shares.resize(static_cast<Eigen::Index>(rows.size()), static_cast<Eigen::Index>(less.functionals.size()));
  less.shares.setFromTriplets(shares.begin(), shares.end());
  return less;
}

}  // namespace glisson::mechanics
