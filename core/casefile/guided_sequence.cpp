#include "casefile/guided_sequence.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "vision/masks.h"

namespace glisson::casefile {

namespace {

constexpr std::size_t judged_on_organ = 48, judged_on_structure = 24;  // places whose error is an outline's

vision::Rgb byte_colour(const std::array<double, 3>& colour) {
  const auto byte = [](double share) {
    return static_cast<std::uint8_t>(std::lround(255 * std::clamp(share, 0.0, 1.0)));
  };
  return {byte(colour[0]), byte(colour[1]), byte(colour[2])};
}

// Colours that no tissue has and that differ from each other in lightness too; of a name not known, the case's own.
vision::Rgb outline_colour(const StructureSurface& structure) {
  static constexpr std::array<std::pair<std::string_view, vision::Rgb>, 10> known{{{"liver", {245, 240, 230}},
                                                                                   {"tumour", {255, 214, 40}},
                                                                                   {"tumor", {255, 214, 40}},
                                                                                   {"cyst", {150, 240, 245}},
                                                                                   {"portal-vein", {214, 140, 255}},
                                                                                   {"hepatic-vein", {70, 155, 255}},
                                                                                   {"vessel", {70, 155, 255}},
                                                                                   {"arter", {255, 90, 120}},
                                                                                   {"gallbladder", {110, 225, 110}},
                                                                                   {"bil", {60, 190, 100}}}};
  for (const auto& [beginning, colour] : known) {
    if (std::string_view(structure.name).starts_with(beginning)) return colour;
  }
  return byte_colour(structure.color_rgb);
}

std::string frame_id(std::size_t frame) { return fmt::format("f{:03}", frame); }

// That frame, those after it, then those before it.
std::vector<std::size_t> order_from(std::size_t first, std::size_t frames) {
  std::vector<std::size_t> order;
  for (std::size_t f = first; f < frames; ++f) order.push_back(f);
  for (std::size_t f = std::min(first, frames); f > 0; --f) order.push_back(f - 1);
  return order;
}

}  // namespace

Result<GuidedSequence> guided_sequence(const PatientModel& model, const registration_quality::SequenceFiles& sequence,
                                       const std::optional<Eigen::Isometry3d>& first_pose, double noise_mm,
                                       std::size_t first_frame) {
  GuidedSequence guided;
  guided.guidance.mesh = model.mesh;
  guided.guidance.youngs_kPa = youngs_kPa(model);
  if (!sequence.simulated.empty()) guided.guidance.notes.push_back(sequence.simulated);
  for (const mechanics::Landmark& landmark : model.landmarks) {
    guided.guidance.targets.push_back({landmark.id, landmark.position_mm});
  }
  for (std::size_t f = 0; f < sequence.clouds.size(); ++f) {
    auto cloud = registration_quality::read_cloud(sequence.clouds[f]);
    if (!cloud) return failure(std::move(cloud.error()));
    guidance::SeenFrame frame;
    frame.id = frame_id(f);
    frame.points_mm = std::move(cloud->points_mm);
    frame.noise_mm = noise_mm;
    for (const registration_quality::LandmarkTrack& track : sequence.landmarks) {
      if (track.positions_mm[f]) frame.tracked.push_back({track.id, *track.positions_mm[f]});
    }
    guided.guidance.frames.push_back(std::move(frame));
  }
  const auto add = [&](const StructureSurface& structure, std::size_t judged) {
    guidance::EmbeddedStructure added =
        guidance::embedded(structure.name, outline_colour(structure), structure.surface, model.mesh);
    std::vector<Eigen::Vector3d>& further_mm = guided.guidance.further_mm;
    const auto places_mm = guidance::spread_over(structure.surface, judged);
    added.first_judged = further_mm.size();
    added.judged = places_mm.size();
    further_mm.insert(further_mm.end(), places_mm.begin(), places_mm.end());
    guided.structures.push_back(std::move(added));
  };
  add(model.liver, judged_on_organ);
  for (const StructureSurface& structure : model.structures) add(structure, judged_on_structure);
  return begun_at(std::move(guided), first_frame, first_pose);
}

GuidedSequence begun_at(GuidedSequence guided, std::size_t first_frame,
                        const std::optional<Eigen::Isometry3d>& first_pose) {
  const std::vector<guidance::SeenFrame> all = std::move(guided.guidance.frames);
  guided.guidance.frames.clear();
  guided.frame_of = order_from(first_frame, all.size());
  for (const std::size_t f : guided.frame_of) {
    guidance::SeenFrame frame = all[f];
    // A sequence does not say how fast it was taken; the order matters.
    frame.time_s = static_cast<double>(guided.guidance.frames.size());
    frame.pose_guess = f == first_frame || f + 1 == first_frame ? first_pose : std::nullopt;
    guided.guidance.frames.push_back(std::move(frame));
  }
  return guided;
}

Result<FrameOverlay> overlay_of(const GuidedSequence& guided, const registration_quality::SequenceFiles& sequence,
                                std::size_t frame, const guidance::ElasticPlacement& placement) {
  FrameOverlay overlay;
  if (!sequence.camera || !placement.converged) return overlay;
  std::vector<std::uint8_t> instruments;
  if (const std::filesystem::path& image = sequence.images[frame]; !image.empty()) {
    const auto picture = vision::read_frame(image);
    if (!picture) return failure(picture.error());
    overlay.width = picture->width;
    overlay.height = picture->height;
    instruments = vision::tool_pixels(*picture);
  } else {
    overlay.width = static_cast<int>(std::lround(2 * sequence.camera->matrix(0, 2)));
    overlay.height = static_cast<int>(std::lround(2 * sequence.camera->matrix(1, 2)));
  }
  overlay.outlines = guidance::placed_outlines(*sequence.camera, overlay.width, overlay.height, guided.guidance.mesh,
                                               guided.structures, placement, instruments);
  return overlay;
}

Result<std::vector<std::filesystem::path>> write_overlays(const std::filesystem::path& folder,
                                                          const GuidedSequence& guided,
                                                          const registration_quality::SequenceFiles& sequence,
                                                          const std::vector<guidance::ElasticPlacement>& placements) {
  std::vector<std::filesystem::path> written;
  if (!sequence.camera) return written;
  for (std::size_t k = 0; k < std::min(placements.size(), guided.frame_of.size()); ++k) {
    const std::size_t f = guided.frame_of[k];
    if (sequence.images[f].empty() || !placements[k].converged) continue;
    auto picture = vision::read_frame(sequence.images[f]);
    if (!picture) return failure(std::move(picture.error()));
    const auto overlay = overlay_of(guided, sequence, f, placements[k]);
    if (!overlay) return failure(overlay.error());
    guidance::draw_outlines(*picture, guided.structures, overlay->outlines);
    const std::filesystem::path file = folder / (frame_id(f) + ".png");
    if (auto saved = vision::write_frame(*picture, file); !saved) return failure(std::move(saved.error()));
    written.push_back(file);
  }
  return written;
}

}  // namespace glisson::casefile
