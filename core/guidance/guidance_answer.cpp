#include "guidance/guidance_answer.h"

#include <fmt/format.h>
#include <algorithm>
#include <limits>
#include <map>

#include "base/json.h"
#include "base/stopwatch.h"
#include "base/units.h"
#include "base/upper_median.h"
#include "base/write_file.h"
#include "geometry/mesh_file.h"
#include "geometry/nearest.h"
#include "guidance/pose_search.h"

namespace glisson::guidance {

using Eigen::Vector3d;

namespace {

ElasticPlacement unanswered(Sentence why) {
  ElasticPlacement placement;
  placement.why_not = std::move(why);
  return placement;
}

// What no registration should be tried on: a sentence, or nothing.
std::optional<Sentence> problem_of(const SeenFrame& frame, const geometry::Surface& organ) {
  if (frame.points_mm.size() < 20) {
    return Sentence{GLISSON_TEXT("Fewer than 20 points of the surface were seen."), {}};
  }
  const double seen_mm = geometry::bounding_box(frame.points_mm).diagonal_mm();
  const double organ_mm = geometry::bounding_box(organ.points_mm).diagonal_mm();
  if (seen_mm < 0.05 * organ_mm) {
    return Sentence{
        GLISSON_TEXT("What was seen is twenty times smaller than the organ: lengths are in mm, are these in metres?"),
        {}};
  }
  if (seen_mm > 5 * organ_mm) {
    return Sentence{GLISSON_TEXT("What was seen is five times larger than the organ: lengths are in mm."), {}};
  }
  if (frame.curves.empty()) return std::nullopt;
  constexpr double beside_organ_mm = 30;
  const geometry::SurfaceDistance distance(organ);
  for (const SeenCurve& curve : frame.curves) {
    std::vector<double> off_mm;
    for (const Vector3d& place : curve.at_rest_mm) off_mm.push_back(distance.closest(place).distance_mm);
    const double median_mm = upper_median(off_mm);
    if (median_mm < beside_organ_mm) continue;
    return Sentence{
        GLISSON_TEXT("The feature {0} lies {1} mm from the organ at rest: it is of another organ, or in another "
                     "frame than the mesh."),
        {curve.id, fmt::format("{:.0f}", median_mm)}};
  }
  return std::nullopt;
}

// As it is deformed, in the scan's frame.
geometry::Surface surface_now(const ForceModes& modes, const ElasticPlacement& placed) {
  geometry::Surface now = modes.surface();
  for (std::size_t p = 0; p < now.points_mm.size(); ++p) {
    now.points_mm[p] += placed.displacement_mm[static_cast<std::size_t>(modes.mesh_point_of()[p])];
  }
  return now;
}

// Where on the organ the tracked points lie, told by the frames that were answered.
class TrackedPlaces {
 public:
  explicit TrackedPlaces(const ForceModes& modes) : modes_(modes) {}

  [[nodiscard]] std::vector<SeenPoint> known_in(const SeenFrame& frame) const {
    std::vector<SeenPoint> known;
    for (const TrackedPoint& point : frame.tracked) {
      const auto place = at_rest_mm_.find(point.id);
      if (place != at_rest_mm_.end()) known.push_back({place->second, point.seen_mm});
    }
    return known;
  }

  // Of the points seen for the first time, those that lie on the surface as it was placed.
  void learn(const SeenFrame& frame, const ElasticPlacement& placed) {
    constexpr double off_surface_mm = 5;
    const geometry::Surface now = surface_now(modes_, placed);
    const geometry::SurfaceDistance distance(now);
    for (const TrackedPoint& point : frame.tracked) {
      if (at_rest_mm_.contains(point.id)) continue;
      const auto closest = distance.closest(placed.pose.inverse() * point.seen_mm);
      if (closest.distance_mm > off_surface_mm) continue;
      const auto& corners = now.triangles[static_cast<std::size_t>(closest.triangle)];
      at_rest_mm_[point.id] = carried(now, modes_.surface(), corners, closest.point_mm);
    }
  }

 private:
  // The same place of the triangle in another state.
  static Vector3d carried(const geometry::Surface& from, const geometry::Surface& to, const std::array<int, 3>& corners,
                          const Vector3d& place_mm) {
    Eigen::Matrix3d frame;
    for (int k = 0; k < 3; ++k) frame.col(k) = from.points_mm[static_cast<std::size_t>(corners[k])];
    const Vector3d edge = frame.col(1) - frame.col(0), other = frame.col(2) - frame.col(0);
    Eigen::Matrix<double, 3, 2> edges;
    edges << edge, other;
    const Eigen::Vector2d along = edges.colPivHouseholderQr().solve(place_mm - frame.col(0));
    const auto point = [&](int k) { return to.points_mm[static_cast<std::size_t>(corners[k])]; };
    return point(0) + along[0] * (point(1) - point(0)) + along[1] * (point(2) - point(0));
  }

  const ForceModes& modes_;
  std::map<std::string, Vector3d> at_rest_mm_;
};

// From the guess that the frame brings, or where its cloud says.
ElasticPlacement place_anew(const ForceModes& modes, const SeenFrame& frame, const GuidanceCase& guidance,
                            const std::vector<mechanics::PointInMesh>& targets) {
  if (frame.pose_guess) return register_elastic(modes, frame, *frame.pose_guess, targets, guidance.gravity_mm_s2);
  const auto found = find_pose(modes.surface(), frame);
  if (!found) return unanswered({found.error().text, found.error().arguments});
  return register_elastic(modes, frame, *found, targets, guidance.gravity_mm_s2);
}

// Where a frame left the organ, for the frame that follows.
struct Left {
  Eigen::Isometry3d pose;
  double unexplained_mm = 0;  // of what that frame saw; not asked of an organ with supports
  double elastic_rms_mm = 0;
};

struct Placed {
  ElasticPlacement placement;
  std::optional<Left> left;  // of a frame that was placed and that another may follow
  [[nodiscard]] double unexplained_mm() const {
    return left ? left->unexplained_mm : std::numeric_limits<double>::infinity();
  }
};

Placed with_what_is_left(const ForceModes& modes, const SeenFrame& frame, ElasticPlacement placement) {
  Placed placed{std::move(placement), {}};
  const ElasticPlacement& now = placed.placement;
  if (!now.converged || !frame.time_s) return placed;
  const double left_mm = modes.is_supported() ? 0 : unexplained_mm(surface_now(modes, now), frame, now.pose);
  placed.left = Left{now.pose, left_mm, now.elastic_rms_mm};
  return placed;
}

// From where the frame before left a free organ. A bent organ may lie in part of a cloud anywhere: where it explains
// this frame much worse than the one before, or is bent much more, it is placed anew too, and what explains the frame
// better is taken. Where neither does, the organ is lost.
Placed follow(const ForceModes& modes, const SeenFrame& frame, const GuidanceCase& guidance,
              const std::vector<mechanics::PointInMesh>& targets, const Left& before) {
  // Of ten simulated videos that were followed, no frame left more than 1.4 mm or was bent by 4 mm more than the one
  // before. Lost ones left 1.1 to 25 mm, and were bent by 13 mm more or left 6.
  constexpr double doubtful_mm = 1.5, lost_mm = 3, worse = 2, suddenly_bent_mm = 5;
  Placed followed = with_what_is_left(
      modes, frame, register_elastic(modes, frame, before.pose, targets, guidance.gravity_mm_s2, following_options()));
  const double usual_mm = worse * before.unexplained_mm;
  const bool is_bent = followed.placement.elastic_rms_mm > before.elastic_rms_mm + suddenly_bent_mm;
  if (!is_bent && followed.unexplained_mm() <= std::max(doubtful_mm, usual_mm)) return followed;
  Placed anew = with_what_is_left(modes, frame, place_anew(modes, frame, guidance, targets));
  Placed& better = followed.unexplained_mm() <= anew.unexplained_mm() ? followed : anew;
  if (better.unexplained_mm() <= std::max(lost_mm, usual_mm)) return better;
  if (!followed.placement.converged) return followed;
  return {unanswered({GLISSON_TEXT("What was seen does not lie where the frame before left the organ, and no other "
                                   "place was found: the organ is lost here."),
                      {}}),
          {}};
}

// `before`: where the frame before left the organ, if this one follows it. One with supports cannot drift, and may be
// pulled far: no search by its shape at rest finds it.
Placed place(const ForceModes& modes, const SeenFrame& frame, const GuidanceCase& guidance,
             const std::vector<mechanics::PointInMesh>& targets, const std::optional<Left>& before) {
  if (auto problem = problem_of(frame, modes.surface())) return {unanswered(*std::move(problem)), {}};
  const bool follows = !frame.pose_guess && before;
  if (follows && !modes.is_supported()) return follow(modes, frame, guidance, targets, *before);
  return with_what_is_left(modes, frame,
                           follows ? register_elastic(modes, frame, before->pose, targets, guidance.gravity_mm_s2)
                                   : place_anew(modes, frame, guidance, targets));
}

// What was answered together: the targets, then the further places.
void part_further(ElasticPlacement& placement, std::size_t targets) {
  if (!placement.converged) return;
  const auto part = [&](auto& all, auto& further) {
    const auto from = all.begin() + static_cast<std::ptrdiff_t>(targets);
    further.assign(from, all.end());
    all.erase(from, all.end());
  };
  part(placement.target_mm, placement.further_mm);
  part(placement.target_sd_mm, placement.further_sd_mm);
}

Result<void> write_frames(const std::filesystem::path& folder, const GuidanceCase& guidance,
                          const GuidanceAnswer& answer);

Json json_of_frame(const GuidanceCase& guidance, const FrameAnswer& frame) {
  const ElasticPlacement& placed = frame.placement;
  Json json{{"id", frame.id},
            {"residual_rms_mm", placed.residual_rms_mm},
            {"converged", placed.converged},
            {"seconds", frame.seconds},
            {"visible_share", placed.visible_share},
            {"elastic_rms_mm", placed.elastic_rms_mm}};
  if (!placed.converged) {
    json["note"] = placed.why_not.message();
    json["targets"] = Json::array();
    return json;
  }
  json["pose"] = Json::array();
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) json["pose"].push_back(placed.pose.matrix()(row, column));
  }
  json["targets"] = Json::array();
  for (std::size_t t = 0; t < guidance.targets.size(); ++t) {
    json["targets"].push_back({{"id", guidance.targets[t].id},
                               {"position_mm", json_of(placed.target_mm[t])},
                               {"sd_mm", placed.target_sd_mm[t]}});
  }
  json["tools"] = Json::array();
  for (const FoundTool& tool : placed.tools) {
    json["tools"].push_back({{"id", tool.id},
                             {"force_N", json_of(Vector3d(units::N_from_mN(1.0) * tool.force_mN))},
                             {"sd_N", units::N_from_mN(tool.sd_mN)}});
  }
  return json;
}

}  // namespace

Result<GuidanceAnswer> answer(const GuidanceCase& guidance, const Progress& progress) {
  ForceModeOptions options;
  options.supports = guidance.supports;
  const auto modes =
      ForceModes::create(guidance.mesh, guidance.youngs_kPa, guidance.poisson_ratio, options, progress.part(0.0, 0.3));
  if (!modes) return failure(modes.error());
  return answer(*modes, guidance, progress.part(0.3, 1.0));
}

Result<GuidanceAnswer> answer(const ForceModes& modes, const GuidanceCase& guidance, const Progress& progress,
                              const FrameHeard& heard) {
  std::vector<Vector3d> at_rest_mm;
  for (const Target& target : guidance.targets) at_rest_mm.push_back(target.at_rest_mm);
  at_rest_mm.insert(at_rest_mm.end(), guidance.further_mm.begin(), guidance.further_mm.end());
  const auto targets = mechanics::locate_points(modes.mesh(), at_rest_mm);
  GuidanceAnswer answer{{}, guidance.notes};
  std::optional<Left> before;
  TrackedPlaces tracked(modes);
  for (std::size_t f = 0; f < guidance.frames.size(); ++f) {
    if (progress.cancelled()) return cancelled();
    progress.report(static_cast<double>(f) / static_cast<double>(guidance.frames.size()),
                    GLISSON_TEXT("Placing the organ"));
    const Stopwatch watch;
    SeenFrame frame = guidance.frames[f];
    frame.known_points = tracked.known_in(frame);
    Placed placed = place(modes, frame, guidance, targets, frame.time_s ? before : std::nullopt);
    ElasticPlacement& placement = placed.placement;
    if (placed.left) {
      before = placed.left;
      tracked.learn(frame, placement);
    }
    part_further(placement, guidance.targets.size());
    answer.frames.push_back({frame.id, watch.seconds(), std::move(placement)});
    if (heard) heard(f, answer.frames.back());
  }
  return answer;
}

Json answer_json(const GuidanceCase& guidance, const GuidanceAnswer& answer) {
  Json json{{"format", "glisson-guidance-answer/1"}, {"title", guidance.title}, {"frames", Json::array()}};
  for (const FrameAnswer& frame : answer.frames) json["frames"].push_back(json_of_frame(guidance, frame));
  if (!answer.notes.empty()) json["notes"] = answer.notes;
  return json;
}

Result<void> write_answer(const std::filesystem::path& folder, const GuidanceCase& guidance,
                          const GuidanceAnswer& answer) {
  return write_together([&] {
    return write_frames(folder, guidance, answer).and_then([&] {
      return write_json_file(folder / "guidance.json", answer_json(guidance, answer));
    });
  });
}

namespace {

Result<void> write_frames(const std::filesystem::path& folder, const GuidanceCase& guidance,
                          const GuidanceAnswer& answer) {
  for (const FrameAnswer& frame : answer.frames) {
    if (!frame.placement.converged) continue;
    geometry::TetMesh mesh{guidance.mesh.points_mm, guidance.mesh.cells, {}, {}};
    geometry::Field field{"displacement_mm", 3, {}};
    for (const Vector3d& u : frame.placement.displacement_mm)
      field.values.insert(field.values.end(), u.begin(), u.end());
    mesh.point_fields.push_back(std::move(field));
    if (auto written = geometry::write_tetrahedra(folder / (frame.id + ".vtu"), mesh); !written) return written;
  }
  return {};
}

}  // namespace
}  // namespace glisson::guidance
