#pragma once
// SIRGn: how good a registration of a video is, triangle by triangle (section 2.2 of the dissertation; Barrow, Ho,
// Althoff, Tueller, Kastner, ISVC 2019). It needs no truth but landmarks G that were followed through the sequence.
//
// Model M, the landmarks' places on it and the warps S are the benchmark's (2.1). A global alignment of all frames
// makes them, whatever algorithm is under test (benchmark.h). What the text leaves open is settled so:
// - The most heavily warped point of a triangle (2.3) is sought among 15 places evenly over it, by the benchmark's S.
//   Its distance vector is taken "identically": from where the benchmark has the point in the frame to where the
//   registration under test puts it on the model.
// - A sequence without a benchmark is judged against itself. That cannot see a fault that never changes, and a note
//   says so. S is then fitted to the registration under test. S^-1(.; t), from the model's space to frame t, is a
//   thin-plate spline through control points spread over where the registration put the frames' clouds. The centres
//   are the same for all frames, so that one factorisation serves them all. The landmarks are no centres. A landmark
//   on the model is the mean of where the registration put it: M holds "the average location of all the landmarks".
//   Where a surface of the model is given, it is brought to that.
// - In (2.4), c_k,t of each frame t gives one vector omega_k,t over all frames. The correlations with the mean of the
//   corners' landmark vectors are averaged over t.

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "base/sentence.h"
#include "geometry/surface.h"

namespace glisson::registration_quality {

constexpr int fewest_frames = 3;  // fewer have no correlation

// One frame: what was seen, and where a registration put it in the model's space, point for point.
struct RegisteredFrame {
  std::vector<Eigen::Vector3d> cloud_mm;
  std::vector<Eigen::Vector3d> registered_mm;
};

// Where a landmark was seen in each frame, in that frame's space; nothing where it was not seen.
struct LandmarkTrack {
  std::string id;
  std::vector<std::optional<Eigen::Vector3d>> positions_mm;
};

// What a registration is judged against, in the model's space; a landmark each, in the order of the sequence's. Nothing
// for a landmark, or for all in a frame, that the global alignment left out.
struct Benchmark {
  std::vector<std::optional<Eigen::Vector3d>> on_model_mm;                // where it is on M
  std::vector<std::vector<std::optional<Eigen::Vector3d>>> in_frames_mm;  // [landmark][frame]: S^-1 of that place
};

struct RegisteredSequence {
  std::vector<RegisteredFrame> frames;
  std::vector<LandmarkTrack> landmarks;
  std::optional<geometry::Surface> model;
  std::optional<Benchmark> benchmark;
  std::vector<Sentence> notes;  // of how it was registered
};

struct SirgnOptions {
  std::vector<double> tolerances_mm{10, 5, 3};  // section 2.3
  int control_points = 300;                     // of the warp: one a square centimetre or so of what a scope sees
  double stiffness_mm = 2;                      // of the warp, against noise in the clouds
  int maximum_cloud_points = 5000;              // of a frame, evenly chosen: enough for a smooth warp
};

// What a triangle's values are made of, frame by frame, mm; NaN in frames that do not hold all three corners.
struct TriangleCourse {
  std::vector<double> landmarks_mm;  // eq. 2.2: how far the corners, as seen, are from where they are on the model
  std::vector<double> warp_mm;       // eq. 2.3: how far the registration displaces the most heavily warped point
  std::vector<double> error_mm;      // how far the corners, as registered, are from where they are on the model
};

struct Quality {
  // The correlation mesh: landmarks on the model, triangulated; cell fields correlation, error_mm, doubt_mm, frames
  // and accepted_<E> for each tolerance.
  geometry::Surface mesh;
  std::vector<double> correlation;  // eq. 2.4, -1..1, one a triangle
  std::vector<double> error_mm;     // mean distance of the corners, as registered, from where they are on the model
  // Not the dissertation's: (1 - correlation) times the motion that the registration leaves unexplained around the
  // triangle. That motion has two parts, joined in squares. One is how far landmarks wander on the model: the median of
  // the triangle's and its neighbours', which one that jumps does not sway. The other is how far S^-1 is from moving
  // the neighbourhood as one rigid body. It ranks triangles as correlation does where faults come and go. It ranks them
  // better where a fault never changes and landmarks are dense enough to show its slope. To be compared within one
  // sequence; it is no error in mm.
  std::vector<double> doubt_mm;
  std::vector<int> frames_seen;         // n of eq. 2.4: frames that hold all three corners
  std::vector<TriangleCourse> courses;  // one a triangle

  // [frame][point of the mesh]: where S^-1 puts the mesh in each frame. So it is where the registration says that the
  // landmarks' places are. It is in the frame's space, for drawing over its picture.
  std::vector<std::vector<Eigen::Vector3d>> mesh_in_frames_mm;

  double mean_correlation = 0;            // over the triangles
  std::vector<double> rejected_fraction;  // of the triangles, a tolerance each: error_mm >= it

  // The traditional figures, one a frame. They are the distance of the registered cloud from the model (none without a
  // model), and of the registered landmarks from where they are on the model.
  std::vector<double> rmse_mm;
  std::vector<double> tre_mm;

  bool against_benchmark = false;  // or against the registration's own landmarks
  std::vector<Sentence> notes;     // what was left out, and why
};

// Fails with "sirgn-too-few-frames" (fewer than three) or "sirgn-too-few-landmarks" (fewer than four seen in three
// frames, or all on a line). Fails with "sirgn-landmarks-off" where fewer than four are left. The others' median
// distance from the points of their frames is then above half of these points' reach. Fails with
// "sirgn-not-point-for-point" where a frame's cloud and its registered cloud differ in number. Fails with
// "sirgn-tracks" where a track, of the sequence or of its benchmark, does not have an entry a frame. Fails with
// "sirgn-empty-frame", "sirgn-tolerance" or "cancelled".
Result<Quality> sirgn(const RegisteredSequence& sequence, const SirgnOptions& options = {},
                      const Progress& progress = {});

}  // namespace glisson::registration_quality
