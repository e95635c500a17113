#include "casefile/guide_case.h"

#include "base/files.h"
#include "base/write_file.h"
#include "casefile/guided_plan.h"
#include "casefile/model.h"

namespace glisson::casefile {

Result<GuidedCase> guide_case(const Case& patient, const std::filesystem::path& sequence, const GuidedFrom& from,
                              const Progress& progress) {
  progress.report(0.0, GLISSON_TEXT("Reading the guidance case"));
  const bool is_asked = !from.sequence_sha256.empty() || !from.lines.sequence.empty();
  const std::string content = is_asked ? sha256_of_file(sequence).value_or("") : "";
  for (const std::string& asked : {from.sequence_sha256, from.lines.sequence}) {
    if (asked.empty() || content == asked) continue;
    return failure(Error{"guide-other-sequence",
                         GLISSON_TEXT("{0} is not the sequence that was asked for: its SHA-256 is another than {1}."),
                         {sequence.string(), asked},
                         {},
                         sequence});
  }
  const auto model = read_model(patient);
  if (!model) return failure(model.error());
  auto files = registration_quality::read_sequence(sequence);
  if (!files) return failure(std::move(files.error()));
  if (from.frame >= files->clouds.size()) {
    return failure(Error{"guide-no-frame",
                         GLISSON_TEXT("{0} has no frame {1}: it has {2}, counted from 0."),
                         {sequence.string(), std::to_string(from.frame), std::to_string(files->clouds.size())},
                         {},
                         sequence});
  }
  auto guided = guided_sequence(*model, *files, from.pose, from.noise_mm, from.frame);
  if (!guided) return failure(std::move(guided.error()));
  add_lines(*guided, from.lines);
  add_plans(*guided, patient);
  auto answer = guidance::answer(guided->guidance, progress.part(0.0, 0.9));
  if (!answer) return failure(Error(answer.error()).in_file(patient.folder()));
  return GuidedCase{*std::move(files), *std::move(guided), *std::move(answer)};
}

Result<std::size_t> write_guided_case(const std::filesystem::path& folder, const GuidedCase& guided) {
  std::vector<guidance::ElasticPlacement> placements;
  for (const guidance::FrameAnswer& frame : guided.answer.frames) placements.push_back(frame.placement);
  std::size_t pictures = 0;
  auto written = write_together([&] {
    return guidance::write_answer(folder, guided.guided.guidance, guided.answer).and_then([&]() -> Result<void> {
      const auto drawn = write_overlays(folder, guided.guided, guided.sequence, placements);
      if (!drawn) return failure(drawn.error());
      pictures = drawn->size();
      return {};
    });
  });
  if (!written) return failure(std::move(written.error()));
  return pictures;
}

}  // namespace glisson::casefile
