#include "casefile/guided_sequence.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

namespace glisson::casefile {

namespace {

vision::Rgb byte_colour(const std::array<double, 3>& colour) {
  const auto byte = [](double share) {
    return static_cast<std::uint8_t>(std::lround(255 * std::clamp(share, 0.0, 1.0)));
  };
  return {byte(colour[0]), byte(colour[1]), byte(colour[2])};
}

std::string frame_id(std::size_t frame) { return fmt::format("f{:03}", frame); }

}  // namespace

Result<GuidedSequence> guided_sequence(const PatientModel& model, const registration_quality::SequenceFiles& sequence,
                                       const std::optional<Eigen::Isometry3d>& first_pose, double noise_mm) {
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
    frame.time_s = static_cast<double>(f);  // a sequence does not say how fast it was taken; the order matters
    if (f == 0) frame.pose_guess = first_pose;
    for (const registration_quality::LandmarkTrack& track : sequence.landmarks) {
      if (track.positions_mm[f]) frame.tracked.push_back({track.id, *track.positions_mm[f]});
    }
    guided.guidance.frames.push_back(std::move(frame));
  }
  const auto add = [&](const StructureSurface& structure) {
    guided.structures.push_back(
        guidance::embedded(structure.name, byte_colour(structure.color_rgb), structure.surface, model.mesh));
  };
  add(model.liver);
  for (const StructureSurface& structure : model.structures) add(structure);
  return guided;
}

Result<std::vector<std::filesystem::path>> write_overlays(const std::filesystem::path& folder,
                                                          const GuidedSequence& guided,
                                                          const registration_quality::SequenceFiles& sequence,
                                                          const std::vector<guidance::ElasticPlacement>& placements) {
  std::vector<std::filesystem::path> written;
  if (!sequence.camera) return written;
  for (std::size_t f = 0; f < std::min(placements.size(), sequence.images.size()); ++f) {
    if (sequence.images[f].empty() || !placements[f].converged) continue;
    auto picture = vision::read_frame(sequence.images[f]);
    if (!picture) return failure(std::move(picture.error()));
    guidance::draw_placed(*picture, *sequence.camera, guided.guidance.mesh, guided.structures, placements[f]);
    const std::filesystem::path file = folder / (frame_id(f) + ".png");
    if (auto saved = vision::write_frame(*picture, file); !saved) return failure(std::move(saved.error()));
    written.push_back(file);
  }
  return written;
}

}  // namespace glisson::casefile
