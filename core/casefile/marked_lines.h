#pragma once
// Lines of the liver that a person recognises on both sides: marked on the model, and on frames of a laparoscope's
// sequence. They say where the liver lies, and how its surface has slid, where the shape alone does not.
//
//   {"format": "glisson-marked-lines/1", "sequence": SHA-256 of its sequence.json,
//    "lines": [{"id": "falciform", "at_rest": [[x, y, z], ...], "seen": {"2": [[x, y, z], ...]}}]}
//
// `at_rest` in the scan's frame (LPS), `seen` in the camera's, by the frame's number from 0; all mm.

#include <Eigen/Core>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/json_forward.h"
#include "casefile/guided_sequence.h"

namespace glisson::casefile {

struct MarkedLine {
  std::string id;
  std::vector<Eigen::Vector3d> at_rest_mm;
  std::map<std::size_t, std::vector<Eigen::Vector3d>> seen_mm;  // by frame
};

struct MarkedLines {
  std::string sequence;  // SHA-256 of sequence.json
  std::vector<MarkedLine> lines;
};

[[nodiscard]] Json json_of(const MarkedLines& marked);
// Nothing where it is none: another format, no numbers, numbers that are not finite.
[[nodiscard]] std::optional<MarkedLines> marked_lines_from(const Json& json);
// Failures: those of reading JSON; "lines-invalid".
Result<MarkedLines> read_marked_lines(const std::filesystem::path& file);

// The first frame on which a line of at least two places stands that has two on the model too; nothing where none does.
[[nodiscard]] std::optional<std::size_t> first_marked_frame(const MarkedLines& marked);

// Such lines become what was seen on their frames.
void add_lines(GuidedSequence& guided, const MarkedLines& marked);

}  // namespace glisson::casefile
