#pragma once
// The demo's report as a page.

#include "base/result.h"
#include "study/demo.h"

namespace glisson::study {

// Writes summary.report from the summary and its pictures.
Result<void> write_demo_report(const DemoSummary& summary);

}  // namespace glisson::study
