#pragma once
// A row of observations as the model at rest sees it: values at some places, along a direction.

#include <array>
#include <Eigen/Core>

namespace glisson::closedloop {

struct SeenRow {
  Eigen::Index shot = 0;
  std::array<Eigen::Index, 6> places{};
  Eigen::Matrix<double, 6, 1> weights = Eigen::Matrix<double, 6, 1>::Zero();
  Eigen::Vector3d direction{0, 0, 1};

  // Of a field of 3 rows a place.
  [[nodiscard]] Eigen::Vector3d of(const Eigen::Ref<const Eigen::VectorXd>& field) const {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < 6; ++i) {
      if (weights[static_cast<Eigen::Index>(i)] != 0)
        sum += weights[static_cast<Eigen::Index>(i)] * field.segment<3>(3 * places[i]);
    }
    return sum;
  }
};

}  // namespace glisson::closedloop
