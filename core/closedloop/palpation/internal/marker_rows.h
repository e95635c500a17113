#pragma once
// What is seen of a palpation's markers, as rows of observations: three a marker and moment.

#include <Eigen/Core>
#include <vector>

#include "base/result.h"
#include "closedloop/experiment/experiment.h"
#include "closedloop/experiment/observations.h"
#include "closedloop/palpation/internal/loading.h"
#include "closedloop/palpation/internal/state.h"

namespace glisson::closedloop {

struct MarkerRows {
  std::vector<Shot> shots;
  std::vector<Eigen::Vector3d> places_mm;  // of markers at rest, each once
  Observations observations;               // measured position minus rest (mm)

  // What the camera sees of displacements: 3 rows a place, a column a shot, in the specimen's frame.
  [[nodiscard]] Eigen::VectorXd seen(const PalpationState& state, const Eigen::MatrixXd& displacements_mm) const;

  // of_marker(place, shot), a vector, wherever a marker was seen.
  template <typename OfMarker>
  [[nodiscard]] Eigen::VectorXd rows(const OfMarker& of_marker) const {
    Eigen::VectorXd values(observations.rows());
    for (std::size_t s = 0; s < shots.size(); ++s) {
      Eigen::Index row = shots[s].first_row;
      for (const Eigen::Index place : shots[s].markers) {
        values.segment<3>(row) = of_marker(place, static_cast<Eigen::Index>(s));
        row += 3;
      }
    }
    return values;
  }
};

// Fails with "no-measurement" where no sample has markers.
[[nodiscard]] Result<MarkerRows> marker_rows(const Palpation& experiment);

}  // namespace glisson::closedloop
