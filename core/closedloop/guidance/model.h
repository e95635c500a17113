#pragma once
// The forward model of guidance, for the declared organ and with effects switched on. It says where the camera sees
// landmarks, and how far seen points lie from the surface. The organ answers its tools as a palpated specimen does:
// linear elasticity on quadratic tetrahedra (palpation/model.h). A kept factor gives unit responses. A frame is then a
// sum of them, and one search for the nearest places of its points.
//
// Observations are in mm, in the scan's frame, to which the declared pose brings what was seen. A landmark has three
// rows: its position less that at rest. A point of the surface has one: along the normal, from the rest place of what
// the declared model puts there. A prediction of such a row is what was measured less the signed distance of the point
// from the predicted surface. So the residual is that distance, with new nearest places for every set of effects.
//
// Effects, as a palpation has them: stiffness-scale, support-compliance, stiff-inclusion, frame-misalignment (the
// camera's pose, alike in all frames) and, where tools act, force-bias. Two are guidance's own (palpation/internal/
// effects.h): undeclared-attachment, and missing-attachment where several supports are declared, one form each. The
// systematic uncertainty is the discretisation error (palpation/internal/refinement.h).

#include <memory>

#include "base/progress.h"
#include "base/result.h"
#include "closedloop/experiment/experiment.h"
#include "closedloop/experiment/forward_model.h"

namespace glisson::closedloop {

// Failures: those of palpation_model() but "no-measurement".
Result<std::unique_ptr<ForwardModel>> guidance_model(Guidance experiment, const Progress& progress = {});

}  // namespace glisson::closedloop
