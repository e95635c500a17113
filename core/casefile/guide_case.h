#pragma once
// A case's liver found on all frames of a laparoscope's sequence, and what is written of it.

#include <filesystem>
#include <optional>
#include <string>

#include "base/progress.h"
#include "casefile/case.h"
#include "casefile/guided_sequence.h"
#include "casefile/marked_lines.h"
#include "guidance/guidance_answer.h"

namespace glisson::casefile {

// Where it begins: the frame that is answered first, and about where the liver lies in it (scan to camera). Without a
// pose it is searched for, by marked lines where that frame has some.
struct GuidedFrom {
  std::size_t frame = 0;  // from 0
  std::optional<Eigen::Isometry3d> pose = {};
  double noise_mm = 0.5;             // standard deviation of each coordinate of the clouds
  std::string sequence_sha256 = {};  // of sequence.json, where another one is to be refused
  MarkedLines lines = {};
};

struct GuidedCase {
  registration_quality::SequenceFiles sequence;
  GuidedSequence guided;
  guidance::GuidanceAnswer answer;  // frames in the order in which they were answered
};

// As the workspace Guide answers it, to the bit. Failures: "guide-no-frame" (the sequence is shorter),
// "guide-other-sequence" (lines are of one too), and those of reading the case's model, the sequence and its clouds.
Result<GuidedCase> guide_case(const Case& patient, const std::filesystem::path& sequence, const GuidedFrom& from,
                              const Progress& progress = {});

// guidance.json and a mesh a frame (guidance/guidance_answer.h), and the pictures with outlines; how many pictures.
Result<std::size_t> write_guided_case(const std::filesystem::path& folder, const GuidedCase& guided);

}  // namespace glisson::casefile
