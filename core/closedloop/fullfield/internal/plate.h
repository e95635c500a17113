#pragma once
// A full-field experiment ready to be computed: what is prescribed, what is read, and equilibrium of each trial on
// linear or quadratic triangles.

#include <Eigen/Core>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "closedloop/experiment/experiment.h"
#include "closedloop/experiment/observations.h"
#include "closedloop/fullfield/internal/plane_elements.h"

namespace glisson::closedloop {

class Plate {
 public:
  explicit Plate(FullField field);

  [[nodiscard]] const FullField& field() const { return field_; }
  [[nodiscard]] const PlaneElements& elements(ElementOrder order) const { return body(order).elements; }

  // Displacements of at most so many points, and the reactions that are independent of each other. The forces on all
  // boundaries of a direction add up to nothing, which leaves one fewer. Trials one after the other.
  [[nodiscard]] const Observations& observations() const { return observations_; }
  [[nodiscard]] Eigen::Index first_row(std::size_t trial) const { return first_rows_[trial]; }
  [[nodiscard]] Eigen::Index row_count(std::size_t trial) const {
    return static_cast<Eigen::Index>(rows_[trial].size());
  }
  [[nodiscard]] bool is_reaction(Eigen::Index row) const {
    return observations_.direction[static_cast<std::size_t>(row)] >= 2;
  }
  void set_noise(const Eigen::VectorXd& noise) { observations_.noise = noise; }

  // The displacement that is prescribed in a trial, of all freedoms; what is free is as measured, 0 where it was not.
  [[nodiscard]] const Eigen::VectorXd& prescribed(std::size_t trial) const { return prescribed_[trial]; }
  [[nodiscard]] bool measured_everywhere(std::size_t trial) const;
  // Standard deviation of what is prescribed at each boundary and direction of moves(); 0 where the file says it.
  [[nodiscard]] const Eigen::VectorXd& doubt_of_prescribed(std::size_t trial) const { return doubts_[trial]; }

  // From `start` (of the same elements) or, without, from what was measured; from rest where neither leads there.
  [[nodiscard]] std::optional<Eigen::VectorXd> equilibrium(ElementOrder order, const PlaneLaw& law, std::size_t trial,
                                                           const Eigen::VectorXd* start = nullptr) const;

  // The rows of a trial. Forces are those at `displacement`.
  [[nodiscard]] Eigen::VectorXd read(ElementOrder order, std::size_t trial, const Eigen::VectorXd& displacement,
                                     const Eigen::VectorXd& forces) const;

  // About an equilibrium on linear triangles.
  [[nodiscard]] std::optional<PlaneElements::Tangent> tangent(const PlaneLaw& law,
                                                              const Eigen::VectorXd& displacement) const;
  // How the rows change where `forces` act that the law did not have (displacements of what is prescribed stay).
  [[nodiscard]] Eigen::VectorXd response(std::size_t trial, const PlaneElements::Tangent& about,
                                         const Eigen::VectorXd& forces) const;
  // ... where what is prescribed moves, a column each boundary and direction.
  [[nodiscard]] Eigen::MatrixXd response_to_moves(std::size_t trial, const PlaneElements::Tangent& about) const;

  // Force over area and strain, of what was measured: the order of the moduli. 0 where no reaction is known.
  [[nodiscard]] double order_of_stiffness() const;
  // Standard deviation of what neighbouring points do not share, as far as they were measured; 0 where it cannot be
  // told.
  [[nodiscard]] double roughness() const;
  // Neighbours differ by less than half of the stated noise: the rest of it is an error that they share.
  [[nodiscard]] bool is_smoothed() const {
    const double rough = roughness();
    return rough > 0 && rough < 0.5 * field_.noise;
  }
  // Root mean square by which reactions of opposite boundaries do not add up to nothing, a boundary; nothing where not
  // all of them were measured.
  [[nodiscard]] std::optional<double> imbalance() const;
  [[nodiscard]] double largest_reaction() const;

 private:
  struct Body {
    PlaneElements elements;
    Eigen::MatrixXd moves;  // one for each boundary and direction that is prescribed
  };
  struct Row {
    int point = -1;  // of a displacement
    int direction = 0;
    std::vector<std::pair<Eigen::Index, double>> of_moves;  // of a reaction: shares of the forces on boundaries
  };

  [[nodiscard]] const Body& body(ElementOrder order) const {
    return order == ElementOrder::linear ? linear_ : quadratic_;
  }
  [[nodiscard]] std::vector<bool> fixed() const;
  // Of a displacement and the forces on all boundaries and directions that are prescribed.
  [[nodiscard]] Eigen::VectorXd rows_of(std::size_t trial, const Eigen::VectorXd& displacement,
                                        const Eigen::VectorXd& on_boundaries) const;
  [[nodiscard]] Body make_body(ElementOrder order) const;
  void prescribe(std::size_t trial);
  void choose_rows();
  void add_reactions(std::size_t trial, std::vector<Observation>& all);
  [[nodiscard]] double extent() const;

  FullField field_;
  std::vector<std::pair<std::size_t, int>> moved_;  // boundary and direction of each column of moves
  Body linear_;
  Body quadratic_;
  std::vector<Eigen::VectorXd> prescribed_;
  std::vector<Eigen::VectorXd> doubts_;
  std::vector<std::vector<Row>> rows_;  // of each trial
  std::vector<Eigen::Index> first_rows_;
  Observations observations_;
};

}  // namespace glisson::closedloop
