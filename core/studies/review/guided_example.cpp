#include "studies/review/guided_example.h"

#include <fmt/format.h>
#include <algorithm>

#include "anatomy/patient.h"
#include "base/json.h"
#include "base/write_file.h"
#include "casefile/guided_sequence.h"
#include "guidance/guidance_answer.h"
#include "studies/review/example_sequence.h"
#include "studies/review/internal/example_scene.h"

namespace glisson::studies {

namespace {

namespace fs = std::filesystem;
using Eigen::Vector3d;

constexpr double ninety_percent_in_sd = 2.5;

Vector3d middle_of(const std::vector<Vector3d>& points_mm) { return geometry::bounding_box(points_mm).center_mm(); }

// The frame twice: the tumour where it was found, and where it truly is; what the error is stands below.
class Comparison {
 public:
  Comparison(const vision::Frame& frame, const std::string& words)
      : picture_{2 * frame.width + gap, frame.height + band, {}}, width_(frame.width) {
    picture_.rgb.assign(3 * static_cast<std::size_t>(picture_.width) * static_cast<std::size_t>(picture_.height), 18);
    for (int side = 0; side < 2; ++side) {
      for (int y = 0; y < frame.height; ++y) {
        std::copy_n(frame.at(0, y), 3 * frame.width, picture_.at(side * (frame.width + gap), y));
      }
    }
    constexpr vision::Rgb white{240, 240, 240};
    vision::draw_text(picture_, 12, frame.height + 30, 14, words, white);
    vision::draw_text(picture_, 12, frame.height + 62, 12,
                      "SIMULATED: a generated patient and video; not a medical device", {250, 205, 110});
    vision::draw_text(picture_, 12, 28, 14, "found", white);
    vision::draw_text(picture_, frame.width + gap + 12, 28, 14, "true", white);
  }

  void draw(int side, const std::vector<guidance::PlacedOutline>& outlines,
            const std::vector<guidance::EmbeddedStructure>& structures) {
    std::vector<guidance::PlacedOutline> there = outlines;
    for (guidance::PlacedOutline& outline : there) {
      for (guidance::OutlinePiece& piece : outline.pieces) {
        for (Eigen::Vector2d& pixel : piece.line_px) pixel.x() += side * (width_ + gap);
      }
    }
    guidance::draw_outlines(picture_, structures, there);
  }

  [[nodiscard]] const vision::Frame& picture() const { return picture_; }

 private:
  static constexpr int gap = 8, band = 76;
  vision::Frame picture_;
  int width_;
};

// The liver and the tumour, of all that is drawn.
void keep_tumour(casefile::GuidedSequence& guided, std::size_t tumour) {
  guided.structures = {guided.structures.front(), guided.structures[tumour]};
}

}  // namespace

double GuidedExample::mean_error_mm() const {
  double sum = 0, placed = 0;
  for (const GuidedExampleFrame& frame : frames) {
    if (frame.placed) sum += frame.error_mm, ++placed;
  }
  return placed > 0 ? sum / placed : 0;
}

Result<GuidedExample> guide_example(const fs::path& case_folder, const fs::path& folder, int frames,
                                    const Progress& progress) {
  std::error_code ignored;
  fs::remove_all(folder / "sequence", ignored);
  ExampleSequenceOptions options;
  options.frames = frames;
  const auto file = write_example_sequence(folder / "sequence", options, progress.part(0, 0.1));
  if (!file) return failure(file.error());
  const auto sequence = registration_quality::read_sequence(*file);
  if (!sequence) return failure(sequence.error());
  const auto patient = casefile::Case::open(case_folder);
  if (!patient) return failure(patient.error());
  const auto model = casefile::read_model(*patient);
  if (!model) return failure(model.error());
  auto guided = casefile::guided_sequence(*model, *sequence, std::nullopt);
  if (!guided) return failure(guided.error());
  const auto empty = [&](const char* why) {
    return failure(Error{"guided-example-empty", why, {case_folder.string()}, GLISSON_TEXT("Make the demo anew."), {}});
  };
  const auto is_tumour = [](const guidance::EmbeddedStructure& one) { return one.name.starts_with("tumour"); };
  const auto found = std::find_if(guided->structures.begin(), guided->structures.end(), is_tumour);
  if (found == guided->structures.end()) return empty(GLISSON_TEXT("{0} has no tumour to be found."));
  keep_tumour(*guided, static_cast<std::size_t>(found - guided->structures.begin()));
  const auto answer = guidance::answer(guided->guidance, progress.part(0.1, 1));
  if (!answer) return failure(answer.error());

  anatomy::PatientOptions demo;
  demo.seed = options.patient;
  const auto liver = anatomy::make_liver_surface(demo);
  if (!liver) return failure(liver.error());
  const ExampleScene scene(*liver);
  const guidance::EmbeddedStructure& tumour = guided->structures.back();
  GuidedExample example{folder / "tumour.png", tumour.name, {}};
  std::optional<vision::Frame> drawn;
  for (std::size_t f = 0; f < answer->frames.size(); ++f) {
    const guidance::ElasticPlacement& placed = answer->frames[f].placement;
    GuidedExampleFrame judged{answer->frames[f].id, placed.converged, 0, 0};
    if (placed.converged) {
      std::vector<Vector3d> truth_mm;
      for (const Vector3d& point : tumour.at_rest.points_mm) {
        truth_mm.push_back(scene.moved(scene.pose() * point, static_cast<double>(f)));
      }
      const auto overlay = casefile::overlay_of(*guided, *sequence, f, placed);
      if (!overlay) return failure(overlay.error());
      const auto of_tumour = std::find_if(overlay->outlines.begin(), overlay->outlines.end(),
                                          [](const guidance::PlacedOutline& one) { return one.structure == 1; });
      judged.error_mm =
          (middle_of(guidance::placed_points_mm(tumour, guided->guidance.mesh, placed)) - middle_of(truth_mm)).norm();
      judged.within_mm = ninety_percent_in_sd * of_tumour->sd_mm;
      const auto frame = vision::read_frame(sequence->images[f]);
      if (!frame) return failure(frame.error());
      // Truly: the same lines, of the tumour where the video's own motion has it.
      guidance::EmbeddedStructure there = tumour;
      there.at_rest.points_mm = truth_mm;
      const auto truth = guidance::outlines_of(*sequence->camera, overlay->width, overlay->height, there.at_rest);
      Comparison comparison(
          *frame, fmt::format("{}, frame {} of {}: off by {:.1f} mm (stated: 90 % within {:.1f} mm)", tumour.name,
                              f + 1, answer->frames.size(), judged.error_mm, judged.within_mm));
      comparison.draw(0, overlay->outlines, guided->structures);
      comparison.draw(1, {{1, 0, 0, {}, truth}}, guided->structures);
      drawn = comparison.picture();
    }
    example.frames.push_back(judged);
  }
  if (!drawn) return empty(GLISSON_TEXT("The liver of {0} was found in no frame of its own video."));
  auto written = write_together([&] {
    return vision::write_frame(*drawn, example.picture).and_then([&] {
      return write_json_file(folder / "guidance.json", guided_example_json(example));
    });
  });
  if (!written) return failure(written.error());
  return example;
}

Json guided_example_json(const GuidedExample& example) {
  Json frames = Json::array();
  for (const GuidedExampleFrame& frame : example.frames) {
    Json json{{"id", frame.id}, {"converged", frame.placed}};
    if (frame.placed) {
      json["error_mm"] = frame.error_mm;
      json["within_mm"] = frame.within_mm;
    }
    frames.push_back(std::move(json));
  }
  return {{"structure", example.structure},
          {"mean_error_mm", example.mean_error_mm()},
          {"picture", example.picture.string()},
          {"frames", std::move(frames)}};
}

}  // namespace glisson::studies
