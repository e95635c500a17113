#pragma once
// What a laparoscope or a stylus saw of an organ at one moment. Seen positions are in the camera's frame, positions at
// rest in the scan's (patient LPS), all in mm.

#include <array>
#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <vector>

namespace glisson::guidance {

// A line of the organ that is recognised on both sides: a ridge, the falciform ligament. What is seen of it is a part.
struct SeenCurve {
  std::string id;
  std::vector<Eigen::Vector3d> at_rest_mm;
  std::vector<Eigen::Vector3d> seen_mm;
  double noise_mm = 1.5;  // standard deviation of each coordinate
};

// A tool that touches the organ. Its force, on the organ, is known or is to be found.
struct SeenTool {
  std::string id;
  Eigen::Vector3d contact_mm{0, 0, 0};
  double radius_mm = 10;
  std::optional<Eigen::Vector3d> force_mN;
};

// A feature of the surface that is followed through a video. The first frame that is answered says where on the organ
// it is. From then on it tells how the surface slides, which a smooth cloud does not show.
struct TrackedPoint {
  std::string id;
  Eigen::Vector3d seen_mm{0, 0, 0};
};

// The same, once its place at rest is known.
struct SeenPoint {
  Eigen::Vector3d at_rest_mm{0, 0, 0};
  Eigen::Vector3d seen_mm{0, 0, 0};
};

struct SeenFrame {
  std::string id;
  std::vector<Eigen::Vector3d> points_mm;       // of the surface: incomplete, noisy, some of them wrong
  double noise_mm = 0.5;                        // standard deviation of each coordinate
  std::optional<Eigen::Isometry3d> pose_guess;  // scan to camera
  std::optional<double> time_s;                 // given: the search begins where the frame before left the organ
  std::vector<SeenCurve> curves;
  std::vector<SeenTool> tools;
  std::vector<TrackedPoint> tracked;
  std::vector<SeenPoint> known_points;
  double tracking_noise_mm = 1.0;  // standard deviation of each coordinate of both
};

}  // namespace glisson::guidance
