#pragma once
// The loop closed on the demo patient. Its liver is found on the frames of a simulated laparoscopy, and its tumour is
// drawn beside where it truly is. SIMULATED, and its pictures say so.
//
// What is judged is the guidance alone. The motion that the video was made with carries the tumour as the case has it.
// That is held against where it is found to be.

#include <filesystem>
#include <string>
#include <vector>

#include "base/json_forward.h"
#include "base/progress.h"
#include "base/result.h"

namespace glisson::studies {

struct GuidedExampleFrame {
  std::string id;  // "f000"
  bool placed = false;
  double error_mm = 0;   // of the tumour's middle
  double within_mm = 0;  // that 90 % of such errors are said to be within
};

struct GuidedExample {
  std::filesystem::path picture;  // of the last frame that was placed: found on the left, true on the right
  std::string structure;          // "tumour-1"
  std::vector<GuidedExampleFrame> frames;
  [[nodiscard]] double mean_error_mm() const;  // over the frames that were placed
};

// `case_folder` is the demo patient's. Writes folder/sequence/ (example_sequence.h), folder/tumour.png and
// folder/guidance.json. What an earlier run left in those places is replaced. Failures: those of writing the sequence,
// reading the case's model and answering; "guided-example-empty" (no tumour in the case, or no frame was placed).
Result<GuidedExample> guide_example(const std::filesystem::path& case_folder, const std::filesystem::path& folder,
                                    int frames = 12, const Progress& progress = {});

[[nodiscard]] Json guided_example_json(const GuidedExample& example);

}  // namespace glisson::studies
