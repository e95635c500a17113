#pragma once
// All frames of a guidance case answered, and the answer on disk.
//
//   guidance.json   {"format": "glisson-guidance-answer/1", "frames": [{"id", "residual_rms_mm", "converged",
//   "seconds",
//                    "pose": [16 numbers, row-major, scan to camera], "targets": [{"id", "position_mm", "sd_mm"}],
//                    "tools": [{"id", "force_N", "sd_N"}], "note"}]}
//   FRAME.vtu       the organ at rest with displacement_mm: a place x of the scan lies at pose (x + displacement)
//
// `sd_mm` is the standard deviation of each coordinate of the error: 90 % of the targets lie within 2.5 of it.

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "base/json_forward.h"
#include "base/progress.h"
#include "base/result.h"
#include "guidance/elastic_registration.h"
#include "guidance/guidance_file.h"

namespace glisson::guidance {

struct FrameAnswer {
  std::string id;
  double seconds = 0;
  ElasticPlacement placement;
};

struct GuidanceAnswer {
  std::vector<FrameAnswer> frames;
  std::vector<std::string> notes;
};

// Called with each frame as soon as it is answered, on the thread that answers.
using FrameHeard = std::function<void(std::size_t frame, const FrameAnswer& answer)>;

// A frame that cannot be answered says why and does not keep the others from theirs. Failures: those of
// ForceModes::create; "cancelled".
Result<GuidanceAnswer> answer(const GuidanceCase& guidance, const Progress& progress = {});

// The same with modes that are there already, of the same mesh. Failure: "cancelled".
Result<GuidanceAnswer> answer(const ForceModes& modes, const GuidanceCase& guidance, const Progress& progress = {},
                              const FrameHeard& heard = {});

// The document as it is written.
[[nodiscard]] Json answer_json(const GuidanceCase& guidance, const GuidanceAnswer& answer);

// Makes the folder where it is missing.
Result<void> write_answer(const std::filesystem::path& folder, const GuidanceCase& guidance,
                          const GuidanceAnswer& answer);

}  // namespace glisson::guidance
