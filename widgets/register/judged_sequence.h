#pragma once
// What the register page shows, as values: a sequence, how an algorithm registered it, and SIRGn's judgement of that.

#include <filesystem>
#include <memory>

#include "registration_quality/register_sequence.h"
#include "scene/heat_overlay.h"

namespace glisson::widgets {

struct OpenedSequence {
  std::filesystem::path file;
  registration_quality::SequenceFiles files;
};

struct Judged {
  registration_quality::SequenceMethod method = registration_quality::SequenceMethod::icp;
  registration_quality::Quality quality;
  double time_s = 0;  // registering and judging
};

// Long work. Failures: those of register_sequence and sirgn.
Result<Judged> judge(const OpenedSequence& sequence, registration_quality::SequenceMethod method,
                     const Progress& progress);

// Whether the sequence holds what the method needs.
[[nodiscard]] bool can_be_registered(const OpenedSequence& sequence, registration_quality::SequenceMethod method);

// What the colours show.
enum class HeatValue { correlation, error, doubt };

// One a triangle.
[[nodiscard]] const std::vector<double>& values_of(const registration_quality::Quality& quality, HeatValue value);

// The scale that one or two judgements are compared on; its title is left empty. Correlation and error, as a person
// reads them, begin and end at round numbers.
[[nodiscard]] scene::HeatScale scale_for(const registration_quality::Quality* a, const registration_quality::Quality* b,
                                         HeatValue value);

// Of the triangles, error_mm at or above the tolerance, as SIRGn counts them.
[[nodiscard]] double rejected_fraction(const registration_quality::Quality& quality, double tolerance_mm);
[[nodiscard]] bool is_rejected(const registration_quality::Quality& quality, std::size_t triangle, double tolerance_mm);

[[nodiscard]] scene::HeatMesh heat_mesh(const registration_quality::Quality& quality, HeatValue value,
                                        std::size_t frame, double tolerance_mm);

}  // namespace glisson::widgets
