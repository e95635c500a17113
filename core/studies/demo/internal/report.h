#pragma once
// The demo's report as a page.

#include "base/result.h"
#include "studies/demo/demo.h"

namespace glisson::studies {

// Writes summary.report from the summary and its pictures.
Result<void> write_demo_report(const DemoSummary& summary);

}  // namespace glisson::studies
