#include "widgets/register/judged_sequence.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace glisson::widgets {

using registration_quality::Quality;
using registration_quality::SequenceMethod;

Result<Judged> judge(const OpenedSequence& sequence, SequenceMethod method, const Progress& progress) {
  const auto start = std::chrono::steady_clock::now();
  const auto registered = registration_quality::register_sequence(sequence.files, method, progress.part(0, 0.95));
  if (!registered) return failure(registered.error());
  auto quality = registration_quality::sirgn(*registered, {}, progress.part(0.95, 1));
  if (!quality) return failure(quality.error());
  return Judged{method, std::move(*quality),
                std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count()};
}

bool can_be_registered(const OpenedSequence& sequence, SequenceMethod method) {
  switch (method) {
    case SequenceMethod::given: return !sequence.files.registered.empty();
    case SequenceMethod::icp:
    case SequenceMethod::geo: return sequence.files.model.has_value();
    case SequenceMethod::gnra: return true;
  }
  return false;
}

const std::vector<double>& values_of(const Quality& quality, HeatValue value) {
  switch (value) {
    case HeatValue::error: return quality.error_mm;
    case HeatValue::doubt: return quality.doubt_mm;
    case HeatValue::correlation: break;
  }
  return quality.correlation;
}

scene::HeatScale scale_for(const Quality* a, const Quality* b, HeatValue value) {
  std::vector<double> values[2];
  const Quality* judged[] = {a, b};
  for (int side = 0; side < 2; ++side) {
    if (judged[side] == nullptr) continue;
    for (std::size_t k = 0; k < judged[side]->frames_seen.size(); ++k) {
      if (judged[side]->frames_seen[k] >= registration_quality::fewest_frames)
        values[side].push_back(values_of(*judged[side], value)[k]);
    }
  }
  using Good = scene::HeatScale::Good;
  scene::HeatScale scale =
      scene::shared_scale(values[0], values[1], value == HeatValue::correlation ? Good::high : Good::low, {});
  if (value == HeatValue::correlation) {
    scale.range = {std::floor(10 * scale.range[0]) / 10, 1};
  } else {
    scale.range = {0, std::max(1.0, std::ceil(scale.range[1]))};
  }
  return scale;
}

bool is_rejected(const Quality& quality, std::size_t triangle, double tolerance_mm) {
  return quality.error_mm[triangle] >= tolerance_mm;
}

double rejected_fraction(const Quality& quality, double tolerance_mm) {
  if (quality.error_mm.empty()) return 0;
  const auto rejected = std::count_if(quality.error_mm.begin(), quality.error_mm.end(),
                                      [&](double error_mm) { return error_mm >= tolerance_mm; });
  return static_cast<double>(rejected) / static_cast<double>(quality.error_mm.size());
}

scene::HeatMesh heat_mesh(const Quality& quality, HeatValue value, std::size_t frame, double tolerance_mm) {
  scene::HeatMesh mesh;
  mesh.points_mm = quality.mesh_in_frames_mm[frame];
  mesh.triangles = quality.mesh.triangles;
  mesh.values = values_of(quality, value);
  for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
    using Verdict = scene::HeatMesh::Verdict;
    // A picture has one meaning: what is off in mm is hatched where the colours are mm.
    const bool hatched = value == HeatValue::error && is_rejected(quality, k, tolerance_mm);
    mesh.verdicts.push_back(quality.frames_seen[k] < registration_quality::fewest_frames ? Verdict::none
                            : hatched                                                    ? Verdict::rejected
                                                                                         : Verdict::accepted);
  }
  return mesh;
}

}  // namespace glisson::widgets
