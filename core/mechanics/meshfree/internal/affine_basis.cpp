#include "mechanics/meshfree/internal/affine_basis.h"

#include <cmath>
#include <numeric>

#include "base/parallel.h"

namespace glisson::mechanics {
namespace {

using Eigen::Vector3d;
using AffineField = Eigen::Matrix<double, 3, 4>;  // the value at its place, and its slope along x, y and z (1/mm)

// The field that a share makes of its handle, and the transpose of that.
AffineField seen_by(const AffineBasis::Share& share, const AffineField& handle) {
  AffineField field;
  field.col(0) = share.weight * handle.col(0) + handle.rightCols<3>() * share.arm;
  field.rightCols<3>() = share.slope_per_mm * handle.rightCols<3>();
  return field;
}
AffineField given_back(const AffineBasis::Share& share, const AffineField& force) {
  AffineField handle;
  handle.col(0) = share.weight * force.col(0);
  handle.rightCols<3>() = force.col(0) * share.arm.transpose() + share.slope_per_mm * force.rightCols<3>();
  return handle;
}

// What a leader gives to a handle, which takes fields as points do.
AffineBasis::Share field_from(const HandleLead& lead, std::size_t k, const Vector3d& place_mm) {
  const int leader = lead.leaders[k];
  const double slope = lead.weights[k] / lead.lengths_mm[leader];
  return {leader, lead.weights[k], slope * (place_mm - lead.leaders_mm[leader]), slope};
}

Eigen::Map<const AffineField> handle_of(const Eigen::VectorXd& q, int handle) {
  return Eigen::Map<const AffineField>(q.data() + Eigen::Index{handle_size} * handle);
}
Eigen::Map<AffineField> handle_of(Eigen::VectorXd& q, int handle) {
  return Eigen::Map<AffineField>(q.data() + Eigen::Index{handle_size} * handle);
}

}  // namespace

double handle_length_mm(const ShapeFunctions& shape, int handle) {
  return std::cbrt(std::max(shape.node_volumes_mm3[handle], 1e-9));
}

Eigen::VectorXd affine_handles(const ShapeFunctions& shape, const std::function<Vector3d(const Vector3d&)>& field) {
  Eigen::VectorXd q(handle_size * static_cast<Eigen::Index>(shape.nodes_mm.size()));
  for (int handle = 0; handle < static_cast<int>(shape.nodes_mm.size()); ++handle) {
    const Vector3d here_mm = shape.nodes_mm[handle];
    const Vector3d here = field(here_mm);
    q.segment<3>(handle_size * handle) = here;
    for (int axis = 0; axis < 3; ++axis) {
      q.segment<3>(handle_size * handle + 3 * (axis + 1)) =
          field(here_mm + handle_length_mm(shape, handle) * Vector3d::Unit(axis)) - here;
    }
  }
  return q;
}

AffineBasis::AffineBasis(const geometry::TetMesh& mesh, const NodeLayout& layout, const ShapeFunctions& shape)
    : positions_mm_(shape.nodes_mm),
      fixed_nodes_(shape.fixed_nodes),
      points_mm_(mesh.points_mm),
      share_starts_(shape.starts) {
  for (int handle = 0; handle < handles(); ++handle) lengths_mm_.push_back(handle_length_mm(shape, handle));
  shares_.reserve(shape.nodes.size());
  for (int p = 0; p < points(); ++p) {
    for (std::size_t k = shape.starts[p]; k < shape.starts[p + 1]; ++k) {
      const int handle = shape.nodes[k];
      const double slope_per_mm = shape.weights[k] / lengths_mm_[handle];
      shares_.push_back(
          {handle, shape.weights[k], slope_per_mm * (points_mm_[p] - positions_mm_[handle]), slope_per_mm});
    }
  }
  find_reach();

  ends_.resize(static_cast<std::size_t>(layout.nodes()));
  std::vector<std::vector<int>> places(mesh.points_mm.size());
  for (int p = 0; p < points(); ++p) {
    if (layout.node_of_point[p] < 0) continue;
    ends_[layout.node_of_point[p]][0] = {p, 1.0, Vector3d::Zero()};
    places[p].push_back(layout.node_of_point[p]);
  }
  for (std::size_t e = 0; e < layout.edges.size(); ++e) {
    const int place = layout.corner_nodes + static_cast<int>(e);
    for (int end = 0; end < 2; ++end) {
      const int p = layout.edges[e][end];
      ends_[place][end] = {p, 0.5, layout.positions_mm[place] - points_mm_[p]};
      places[p].push_back(place);
    }
  }
  places_of_point_.starts.push_back(0);
  for (const auto& list : places) {
    places_of_point_.items.insert(places_of_point_.items.end(), list.begin(), list.end());
    places_of_point_.starts.push_back(places_of_point_.items.size());
  }
}

void AffineBasis::find_reach() {
  points_of_.assign(positions_mm_.size(), {});
  for (int p = 0; p < points(); ++p) {
    for (const Share* share = shares_begin(p); share != shares_end(p); ++share) {
      points_of_[share->handle].push_back({p, static_cast<int>(share - shares_begin(p))});
    }
  }
}

Eigen::VectorXd AffineBasis::displacement(const Eigen::VectorXd& q) const {
  std::vector<AffineField> fields(points_mm_.size());
  parallel_for(fields.size(), 256, [&](std::size_t begin, std::size_t end) {
    for (std::size_t p = begin; p < end; ++p) {
      AffineField sum = AffineField::Zero();
      for (const Share* share = shares_begin(static_cast<int>(p)); share != shares_end(static_cast<int>(p)); ++share) {
        sum += seen_by(*share, handle_of(q, share->handle));
      }
      fields[p] = sum;
    }
  });
  Eigen::VectorXd u(3 * static_cast<Eigen::Index>(ends_.size()));
  parallel_for(ends_.size(), 1024, [&](std::size_t begin, std::size_t end) {
    for (std::size_t place = begin; place < end; ++place) {
      Vector3d sum = Vector3d::Zero();
      for (const End& from : ends_[place]) {
        if (from.point < 0) break;
        const AffineField& field = fields[from.point];
        sum += from.part * (field.col(0) + field.rightCols<3>() * from.away_mm);
      }
      u.segment<3>(3 * static_cast<Eigen::Index>(place)) = sum;
    }
  });
  return u;
}

Eigen::VectorXd AffineBasis::reduce(const Eigen::VectorXd& force) const {
  std::vector<AffineField> on_points(points_mm_.size());
  parallel_for(on_points.size(), 256, [&](std::size_t begin, std::size_t end) {
    for (std::size_t p = begin; p < end; ++p) {
      AffineField sum = AffineField::Zero();
      const auto point = static_cast<int>(p);
      for (const int* place = places_of_point_.begin(point); place != places_of_point_.end(point); ++place) {
        const End& at = ends_[*place][ends_[*place][0].point == point ? 0 : 1];
        const Vector3d part = at.part * force.segment<3>(3 * Eigen::Index{*place});
        sum.col(0) += part;
        sum.rightCols<3>() += part * at.away_mm.transpose();
      }
      on_points[p] = sum;
    }
  });
  Eigen::VectorXd reduced_force(unknowns());
  parallel_for(points_of_.size(), 64, [&](std::size_t begin, std::size_t end) {
    for (auto handle = static_cast<int>(begin); handle < static_cast<int>(end); ++handle) {
      AffineField sum = AffineField::Zero();
      for (const Reach& reach : points_of_[handle]) {
        const Share& share = shares_begin(reach.point)[reach.share];
        sum += given_back(share, on_points[reach.point]);
      }
      handle_of(reduced_force, handle) = sum;
    }
  });
  return reduced_force;
}

Eigen::SparseMatrix<double> AffineBasis::columns(const std::vector<int>& handles) const {
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t h = 0; h < handles.size(); ++h) {
    const int first = handle_size * static_cast<int>(h);
    for (const Reach& reach : points_of_[handles[h]]) {
      const Share& share = shares_begin(reach.point)[reach.share];
      for (const int* place = places_of_point_.begin(reach.point); place != places_of_point_.end(reach.point);
           ++place) {
        const End& at = ends_[*place][ends_[*place][0].point == reach.point ? 0 : 1];
        const Vector3d arm = share.arm + share.slope_per_mm * at.away_mm;
        for (int axis = 0; axis < 3; ++axis) {
          entries.emplace_back(3 * *place + axis, first + axis, at.part * share.weight);
          for (int k = 0; k < 3; ++k) {
            entries.emplace_back(3 * *place + axis, first + 3 * (k + 1) + axis, at.part * arm[k]);
          }
        }
      }
    }
  }
  Eigen::SparseMatrix<double> part(3 * static_cast<Eigen::Index>(ends_.size()),
                                   handle_size * static_cast<Eigen::Index>(handles.size()));
  part.setFromTriplets(entries.begin(), entries.end());
  return part;
}

// Following leaders is what points do, but for the handles' own lengths.
Eigen::VectorXd AffineBasis::follow(const HandleLead& lead, const Eigen::VectorXd& leaders) const {
  Eigen::VectorXd q(unknowns());
  parallel_for(positions_mm_.size(), 256, [&](std::size_t begin, std::size_t end) {
    for (auto i = static_cast<int>(begin); i < static_cast<int>(end); ++i) {
      AffineField sum = AffineField::Zero();
      for (std::size_t k = lead.starts[i]; k < lead.starts[i + 1]; ++k) {
        sum += seen_by(field_from(lead, k, positions_mm_[i]), handle_of(leaders, lead.leaders[k]));
      }
      sum.rightCols<3>() *= lengths_mm_[i];
      handle_of(q, i) = sum;
    }
  });
  return q;
}

Eigen::VectorXd AffineBasis::gather(const HandleLead& lead, const Eigen::VectorXd& handles) const {
  Eigen::VectorXd gathered = Eigen::VectorXd::Zero(Eigen::Index{handle_size} * Eigen::Index(lead.leaders_mm.size()));
  for (int i = 0; i < static_cast<int>(positions_mm_.size()); ++i) {
    AffineField force = handle_of(handles, i);
    force.rightCols<3>() *= lengths_mm_[i];
    for (std::size_t k = lead.starts[i]; k < lead.starts[i + 1]; ++k) {
      handle_of(gathered, lead.leaders[k]) += given_back(field_from(lead, k, positions_mm_[i]), force);
    }
  }
  return gathered;
}

// A handle that does what affine fields say blends them as points would: a leader's weight at a point is the sum over
// handles of theirs there times its own with them.
AffineBasis AffineBasis::led_by(const HandleLead& lead) const {
  AffineBasis basis;
  basis.positions_mm_ = lead.leaders_mm;
  basis.lengths_mm_ = lead.lengths_mm;
  basis.points_mm_ = points_mm_;
  basis.ends_ = ends_;
  basis.places_of_point_ = places_of_point_;
  basis.share_starts_.push_back(0);
  std::vector<double> weight(lead.leaders_mm.size(), 0.0);
  std::vector<int> here;
  for (int p = 0; p < points(); ++p) {
    here.clear();
    for (const Share* share = shares_begin(p); share != shares_end(p); ++share) {
      for (std::size_t k = lead.starts[share->handle]; k < lead.starts[share->handle + 1]; ++k) {
        const int leader = lead.leaders[k];
        if (share->weight * lead.weights[k] == 0) continue;
        if (weight[leader] == 0) here.push_back(leader);
        weight[leader] += share->weight * lead.weights[k];
      }
    }
    std::sort(here.begin(), here.end());
    for (const int leader : here) {
      const double slope_per_mm = weight[leader] / lead.lengths_mm[leader];
      basis.shares_.push_back(
          {leader, weight[leader], slope_per_mm * (points_mm_[p] - lead.leaders_mm[leader]), slope_per_mm});
      weight[leader] = 0;
    }
    basis.share_starts_.push_back(basis.shares_.size());
  }
  basis.find_reach();
  return basis;
}

}  // namespace glisson::mechanics
