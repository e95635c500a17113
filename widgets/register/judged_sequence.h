#pragma once
// What the register page shows, as values: a sequence, how an algorithm registered it, and SIRGn's judgement of that.

#include <filesystem>
#include <memory>

#include "quality/register_sequence.h"
#include "scene/heat_overlay.h"

namespace glisson::widgets {

struct OpenedSequence {
  std::filesystem::path file;
  quality::SequenceFiles files;
};

struct Judged {
  quality::SequenceMethod method = quality::SequenceMethod::icp;
  quality::Quality quality;
  double time_s = 0;  // registering and judging
};

// Long work. Failures: those of register_sequence and sirgn.
Result<Judged> judge(const OpenedSequence& sequence, quality::SequenceMethod method, const Progress& progress);

// Whether the sequence holds what the method needs.
[[nodiscard]] bool can_be_registered(const OpenedSequence& sequence, quality::SequenceMethod method);

// What the colours show.
enum class HeatValue { correlation, error, doubt };

// One a triangle.
[[nodiscard]] const std::vector<double>& values_of(const quality::Quality& quality, HeatValue value);

// The scale that one or two judgements are compared on; its title is left empty. Correlation and error, as a person
// reads them, begin and end at round numbers.
[[nodiscard]] scene::HeatScale scale_for(const quality::Quality* a, const quality::Quality* b, HeatValue value);

// Of the triangles, error_mm at or above the tolerance, as SIRGn counts them.
[[nodiscard]] double rejected_fraction(const quality::Quality& quality, double tolerance_mm);
[[nodiscard]] bool is_rejected(const quality::Quality& quality, std::size_t triangle, double tolerance_mm);

[[nodiscard]] scene::HeatMesh heat_mesh(const quality::Quality& quality, HeatValue value, std::size_t frame,
                                        double tolerance_mm);

}  // namespace glisson::widgets
