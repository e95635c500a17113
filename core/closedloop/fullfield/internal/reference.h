#pragma once
// What a plate's measurements say before any effect is fitted. A law near the best is found, then the equilibrium of
// each trial at it. From there, to first order, each law's coefficients follow by linear least squares: there fits
// begin. The weak form of equilibrium is weighed by the stiffness, so that its error is a displacement. Flaschel, Kumar
// and De Lorenzis 2021 weigh it by forces.

#include <string>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "base/sentence.h"
#include "closedloop/experiment/forward_model.h"
#include "closedloop/fullfield/internal/plate.h"

namespace glisson::closedloop {

// What the given numbers are. Those of a plate follow quadratic triangles. Published data may be, in part or
// altogether, a solution on the mesh's own linear triangles. Then they carry the error of those.
enum class FieldReading { measured, reactions_of_linear_triangles, linear_triangles };
[[nodiscard]] const char* name_of(FieldReading reading);  // "", "linear-reactions", "linear"

struct Reference {
  PlaneLaw law;
  std::vector<Eigen::VectorXd> displacement;  // on linear triangles, of each trial
  FieldReading reading = FieldReading::measured;
  Eigen::VectorXd correction;  // of all rows, to be added to what linear triangles predict
  Eigen::VectorXd noise;       // of all rows
  SystematicUncertainty systematic;
  std::vector<std::vector<Start>> starts;  // of each law in the order of plane_laws()
};

// Fails where no law of the library has an equilibrium.
Result<Reference> find_reference(const Plate& plate, const Progress& progress);

// Standard deviations of rows as stated, or as the data show them. Displacements show more by their roughness,
// reactions by what opposite ones lack to balance. `remarks` says what was assumed.
[[nodiscard]] Eigen::VectorXd noise_of(const Plate& plate, std::vector<Sentence>& remarks);

}  // namespace glisson::closedloop
