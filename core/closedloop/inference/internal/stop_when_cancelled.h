#pragma once
// Ends a minimisation by Ceres where the person who waits for it gave up.

#include <ceres/iteration_callback.h>

#include "base/progress.h"

namespace glisson::closedloop {

class StopWhenCancelled : public ceres::IterationCallback {
 public:
  explicit StopWhenCancelled(const Progress& progress) : progress_(progress) {}
  ceres::CallbackReturnType operator()(const ceres::IterationSummary&) override {
    return progress_.cancelled() ? ceres::SOLVER_ABORT : ceres::SOLVER_CONTINUE;
  }

 private:
  const Progress& progress_;
};

}  // namespace glisson::closedloop
