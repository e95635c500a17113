#pragma once
// What this product does in a frame, timed on this machine with a patient's model. Chapter 6's plan is asked for that
// in place of the dissertation's block products. A live frame of the rehearsal at small and at large strain, one of the
// meshfree engine, a frame of the guidance, a registration.

#include "base/progress.h"
#include "base/result.h"
#include "casefile/model.h"
#include "hardware/task.h"

namespace glisson::studies {

struct ProductTaskOptions {
  int frames = 5;  // of each task; the median is told
  int meshfree_nodes = 300;
  int matched_points = 128;
};

struct ProductTasks {
  double memory_GB_per_s = 0;         // of this machine, which turns seconds into bytes
  std::vector<hardware::Task> tasks;  // rehearse, rehearse-large-strain, rehearse-meshfree, guide, match
  std::vector<std::string> remarks;   // which task could not be timed, and why
};

// Takes half a minute for 20,000 cells. Failures: "cancelled"; those of tool placement and of the rehearsal.
Result<ProductTasks> time_product_tasks(const casefile::PatientModel& model, const ProductTaskOptions& options = {},
                                        const Progress& progress = {});

}  // namespace glisson::studies
