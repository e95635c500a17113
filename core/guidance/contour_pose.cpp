#include "guidance/contour_pose.h"

#include <algorithm>

#include "base/parallel.h"
#include "guidance/internal/contour_fit.h"
#include "guidance/internal/search_parts.h"

namespace glisson::guidance {

using Eigen::Isometry3d;
using Eigen::Vector3d;

namespace {

constexpr std::size_t begun = 200;
constexpr double away_weight = 0.5;
constexpr double largest_cost = 0.8;  // of 1: nothing is explained
constexpr double alike = 1.15;        // a pose elsewhere whose cost is at most so many times the best's
constexpr Apart elsewhere{40, 30};

// A laparoscope enters through the front of the belly: it looks backwards or upwards (the scan's axes are LPS).
bool looks_from_the_belly(const Eigen::Matrix3d& turn) {
  const Vector3d sight = turn.transpose() * Vector3d::UnitZ();
  return sight.y() + sight.z() > 0;
}

std::vector<Scored> from_all_turns(const ContourFit& fit) {
  std::vector<Scored> poses;
  for (const Eigen::Matrix3d& turn : even_rotations()) {
    if (!looks_from_the_belly(turn)) continue;
    const Isometry3d pose = fit.begun_at(turn);
    poses.push_back({fit.wide_cost(pose), pose});
  }
  std::sort(poses.begin(), poses.end(), fits_better);
  poses.resize(std::min(poses.size(), begun));
  parallel_for(poses.size(), 2, [&](std::size_t begin, std::size_t end) {
    for (std::size_t p = begin; p < end; ++p) {
      poses[p].pose = fit.refined(poses[p].pose);
      poses[p].cost = fit.narrow_cost(poses[p].pose) + away_weight * fit.turned_away(poses[p].pose);
    }
  });
  std::erase_if(poses, [](const Scored& each) { return !looks_from_the_belly(each.pose.linear()); });
  std::sort(poses.begin(), poses.end(), fits_better);
  return poses;
}

}  // namespace

Result<ContourPose> pose_of_contours(const geometry::Surface& organ, const vision::Camera& camera,
                                     const std::vector<SeenContour>& contours, const std::optional<Isometry3d>& guess) {
  const ContourFit fit(organ, camera, contours);
  if (!guess && fit.lines_at_rest() < 2) {
    return failure(Error{"pose-not-found",
                         GLISSON_TEXT("One picture tells a pose by two lines of the organ and more; {0} are given."),
                         {std::to_string(fit.lines_at_rest())},
                         GLISSON_TEXT("Mark ridges and the falciform ligament, or give a pose_guess."),
                         {}});
  }
  std::vector<Scored> poses;
  if (guess) {
    poses.push_back({0, fit.refined(*guess)});
    poses.back().cost = fit.narrow_cost(poses.back().pose);
  } else {
    poses = from_all_turns(fit);
  }
  if (poses.empty() || poses.front().cost > largest_cost) {
    return failure(
        Error{"pose-not-found",
              GLISSON_TEXT("Under no pose do the lines of the organ lie on those of the picture."),
              {},
              GLISSON_TEXT("Check that lines have the same names on both sides, that lengths are in mm, and that "
                           "the picture is of this camera and patient."),
              {}});
  }
  const Scored& best = poses.front();
  const bool is_ambiguous = std::any_of(poses.begin(), poses.end(), [&](const Scored& other) {
    return other.cost < alike * best.cost && lie_apart(other.pose, best.pose, fit.middle_mm(), elsewhere);
  });
  if (is_ambiguous) {
    return failure(Error{"pose-not-found",
                         GLISSON_TEXT("The lines of the picture fit the organ in more than one place."),
                         {},
                         GLISSON_TEXT("Mark another line, or give a pose_guess."),
                         {}});
  }
  ContourPose found{best.pose, {}};
  for (std::size_t c = 0; c < contours.size(); ++c) found.off.push_back(fit.error(c, best.pose));
  return found;
}

std::optional<ContourError> error_of(const SeenContour& contour, const geometry::Surface& organ,
                                     const vision::Camera& camera, const Isometry3d& pose) {
  return ContourFit(organ, camera, {contour}).error(0, pose);
}

}  // namespace glisson::guidance
