#include "studies/review/review.h"

#include <fmt/format.h>

#include "base/write_file.h"
#include "registration_quality/sequence_file.h"
#include "scene/heat_overlay.h"
#include "studies/review/internal/review_page.h"
#include "vision/frame.h"

namespace glisson::studies {
namespace {

namespace fs = std::filesystem;
using registration_quality::StoredQuality;
using scene::HeatScale;

Result<registration_quality::SequenceFiles> drawable(const StoredQuality& judged);
Result<void> draw_all(const StoredQuality& judged, const registration_quality::SequenceFiles& files,
                      const HeatScale& scale, double tolerance_mm, const fs::path& folder, const std::string& prefix,
                      const Progress& progress);

// Of the triangles that could be judged.
std::vector<double> values_of(const StoredQuality& judged, ReviewedValue value) {
  std::vector<double> values;
  for (std::size_t k = 0; k < judged.quality.frames_seen.size(); ++k) {
    if (judged.quality.frames_seen[k] < registration_quality::fewest_frames) continue;
    values.push_back(value == ReviewedValue::correlation ? judged.quality.correlation[k] : judged.quality.error_mm[k]);
  }
  return values;
}

}  // namespace

Result<int> write_heat_pictures(const StoredQuality& judged, const fs::path& folder, const ReviewOptions& options,
                                const Progress& progress) {
  const auto files = drawable(judged);
  if (!files) return failure(files.error());
  HeatScale scale;
  scale.title = "correlation";
  if (options.value == ReviewedValue::error) {
    scale.range = {0, 2 * options.tolerance_mm};
    scale.good = HeatScale::Good::low;
    scale.title = "error (mm)";
  }
  const auto drawn =
      write_together([&] { return draw_all(judged, *files, scale, options.tolerance_mm, folder, "f", progress); });
  if (!drawn) return failure(drawn.error());
  return static_cast<int>(judged.quality.mesh_in_frames_mm.size());
}

Result<Review> write_review(const StoredQuality& a, const StoredQuality& b, const fs::path& folder,
                            const ReviewOptions& options, const Progress& progress) {
  if (a.sequence != b.sequence || a.quality.mesh_in_frames_mm.size() != b.quality.mesh_in_frames_mm.size()) {
    return failure(Error{"review-different-videos",
                         GLISSON_TEXT("The two judge different videos: {0} and {1}."),
                         {a.sequence.string(), b.sequence.string()},
                         GLISSON_TEXT("Judge both registrations on the same sequence.json."),
                         {}});
  }
  const auto files = drawable(a);
  if (!files) return failure(files.error());
  const bool error = options.value == ReviewedValue::error;
  const HeatScale scale =
      scene::shared_scale(values_of(a, options.value), values_of(b, options.value),
                          error ? HeatScale::Good::low : HeatScale::Good::high, error ? "error (mm)" : "correlation");
  Review review;
  review.frames = static_cast<int>(a.quality.mesh_in_frames_mm.size());
  review.range = scale.range;
  review.page = folder / "review.html";
  const auto written = write_together([&] {
    return draw_all(a, *files, scale, options.tolerance_mm, folder, "a", progress.part(0, 0.5))
        .and_then([&] { return draw_all(b, *files, scale, options.tolerance_mm, folder, "b", progress.part(0.5, 1)); })
        .and_then([&] { return write_review_page(review.page, a, b, options.tolerance_mm); });
  });
  if (!written) return failure(written.error());
  return review;
}

namespace {

Result<registration_quality::SequenceFiles> drawable(const StoredQuality& judged) {
  auto files = registration_quality::read_sequence(judged.sequence);
  if (!files) return files;
  if (!files->camera) {
    return failure(Error{"review-no-camera",
                         GLISSON_TEXT("The sequence names no camera to draw with."),
                         {},
                         GLISSON_TEXT("Add \"camera\": {\"matrix\": [3x3], \"distortion\": [..]}."),
                         judged.sequence});
  }
  for (std::size_t t = 0; t < judged.quality.mesh_in_frames_mm.size(); ++t) {
    if (t < files->images.size() && !files->images[t].empty()) continue;
    return failure(Error{"review-no-images",
                         GLISSON_TEXT("Frame {0} of the sequence names no image."),
                         {std::to_string(t)},
                         GLISSON_TEXT("Add \"image\" to each frame."),
                         judged.sequence});
  }
  return files;
}

Result<void> draw_all(const StoredQuality& judged, const registration_quality::SequenceFiles& files,
                      const HeatScale& scale, double tolerance_mm, const fs::path& folder, const std::string& prefix,
                      const Progress& progress) {
  scene::HeatMesh mesh;
  mesh.triangles = judged.quality.mesh.triangles;
  mesh.values = scale.good == HeatScale::Good::low ? judged.quality.error_mm : judged.quality.correlation;
  for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
    using Verdict = scene::HeatMesh::Verdict;
    mesh.verdicts.push_back(judged.quality.frames_seen[k] < registration_quality::fewest_frames ? Verdict::none
                            : judged.quality.error_mm[k] >= tolerance_mm                        ? Verdict::rejected
                                                                                                : Verdict::accepted);
  }
  const std::size_t frames = judged.quality.mesh_in_frames_mm.size();
  for (std::size_t t = 0; t < frames; ++t) {
    if (progress.cancelled()) return cancelled();
    const auto frame = vision::read_frame(files.images[t]);
    if (!frame) return failure(frame.error());
    mesh.points_mm = judged.quality.mesh_in_frames_mm[t];
    const auto file = folder / fmt::format("{}{:03}.jpg", prefix, t);
    if (auto written = vision::write_frame(scene::heat_overlay(*frame, *files.camera, mesh, scale), file); !written) {
      return written;
    }
    progress.report(static_cast<double>(t + 1) / static_cast<double>(frames), GLISSON_TEXT("pictures"));
  }
  return {};
}

}  // namespace
}  // namespace glisson::studies
