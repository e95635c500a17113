#pragma once
// The forward model of a palpation: where each marker is seen, for the declared specimen and with effects switched on.
//
// Declared is linear elasticity at small strain, with quadratic tetrahedra on the given mesh (its cells promoted, edges
// straight). The supports' named points are fixed, with the mid-side nodes between them. The tool's force is a uniform
// dead traction over the boundary faces whose centroid at rest lies within its radius. The declared gravity acts in
// every measured state. How each effect changes this is said in internal/effects.h, how they compose in
// internal/state.h.
//
// Assumptions that hold for all of it: strains and turns are small, so that the response is linear in the load (but for
// strain-stiffening). What stiffens does so at small strain. Everything creeps alike. Preload and declared gravity have
// acted since long before the first sample, and do not creep. Markers move with the specimen's material and have no
// size.
//
// Observations are displacements, measured position minus rest (mm): three rows a marker and moment. Derivatives are
// exact, with strain-stiffening to 1e-3 of themselves.
// The systematic uncertainty is the discretisation error (internal/refinement.h). Where tissue stiffens with strain, the
// part of it that is not linear in the load is in the prediction itself (internal/error_at_strain.h).

#include <memory>

#include "base/progress.h"
#include "base/result.h"
#include "closedloop/experiment/experiment.h"
#include "closedloop/experiment/forward_model.h"

namespace glisson::closedloop {

// Failures: those of mechanics/elements/body.h, "tool-touches-nothing" (the trial is named), "no-measurement" (no
// sample has markers), those of mechanics/solvers/cholesky_factor.h, "cancelled".
Result<std::unique_ptr<ForwardModel>> palpation_model(Palpation experiment, const Progress& progress = {});

}  // namespace glisson::closedloop
