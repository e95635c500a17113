#pragma once
// GEO: non-rigid correspondence of two surfaces by geodesic distances alone. Points of both surfaces are matched so
// that distances along the surface are kept. It follows Chen and Koltun 2015 ("Robust nonrigid registration by convex
// optimization"), as the dissertation uses it (section 3.2). Here they are spread evenly; how is not said there.
//
// Distances along a surface do not tell it from its mirror image. Orientation does: a matching that turns neighbours
// the wrong way round, seen from outside, is a mirrored one, and the other is looked for.

#include <memory>
#include <optional>

#include "base/progress.h"
#include "geometry/surface.h"
#include "registration/mrf.h"
#include "registration/samples.h"
#include "registration/trwls.h"

namespace glisson::registration {

enum class Solver { trwls, trws };

// What is known of where things are, before matching.
enum class Prior {
  automatic,  // positions where one surface is only a part of the other, which distances along it do not place; else
              // none
  none,       // nothing: any pose, any frame
  positions   // both surfaces lie in one frame, roughly aligned: a match that leads far away costs
};

struct GeoOptions {
  int points = 128;  // of each surface; the dissertation's size (table 3.1)
  // sigma and tau of eq. 3.1 over the square root of the larger area. Chosen on the TOSCA wolves and cats: half and
  // twice of either match about as well.
  double relative_sigma = 0.5;
  double relative_tau = 0.3;
  Solver solver = Solver::trwls;
  WordWidth width = WordWidth::bits_16;              // of trwls
  std::optional<std::string> device = std::nullopt;  // of trwls in 16 bits, as TrwlsOptions
  SolverOptions solving;
  Prior prior = Prior::automatic;
  double prior_weight = 0.5;  // a match as far off as tau costs this much of what all its pairs can cost
};

struct SurfaceMatch {
  // Match i: point source_points[i] of the source belongs to point target_points[i] of the target.
  std::vector<int> source_points;
  std::vector<int> target_points;
  MatchingSolution solution;       // of the field that the matches were read from
  double orientation_kept = 0;     // share of neighbours that turn the same way on both surfaces: 1 for a good match,
                                   // 0 for a mirrored one, 0.5 for none at all
  bool swapped = false;            // whether the target's points were the nodes, being the smaller surface
  GeodesicSamples source_samples;  // what was matched, for densify()
  GeodesicSamples target_samples;
};

// The surface of the smaller area gives the nodes, each of which gets a match; so a part can be matched to a whole.
// Failures: those of sample_surface for either surface, of store() for Solver::trws; "cancelled".
Result<SurfaceMatch> match_surfaces(const geometry::Surface& source, const geometry::Surface& target,
                                    const GeoOptions& options = {}, const Progress& progress = {});

// Surfaces of a video, matched one after the other to a model that stays. The model's distances are found once. A frame
// begins at the match before it: each of its points belongs where the nearest one of the last frame did. Where that
// leads to a match that is turned, or far worse than the last one, the frame is matched as match_surfaces does.
class FrameMatcher {
 public:
  // Failures: those of sample_surface.
  static Result<FrameMatcher> create(geometry::Surface model, const GeoOptions& options = {},
                                     const Progress& progress = {});

  // The frame is the source, the model the target. Failures: those of match_surfaces.
  Result<SurfaceMatch> match(const geometry::Surface& frame, const Progress& progress = {});
  // Whether the last frame was looked for anew.
  [[nodiscard]] bool searched() const { return searched_; }

 private:
  struct Model;
  struct Last {
    std::vector<Eigen::Vector3d> places_mm;  // of the frame
    std::vector<int> samples;                // of the model, where they belong
    double misfit = 0;                       // the energy over tau
  };
  static Labelling start_from(const Last& last, const std::vector<Eigen::Vector3d>& frame_mm, bool nodes_are_frame);
  explicit FrameMatcher(std::shared_ptr<const Model> model) : model_(std::move(model)) {}

  std::shared_ptr<const Model> model_;
  std::optional<Last> last_;
  bool searched_ = false;
};

// A target point for each point of the source. It is the one whose distances from the matches nearby are most like its
// own, among those around where the nearest match leads. (The expansion step of the dissertation's baseline.)
std::vector<int> densify(const SurfaceMatch& match);

}  // namespace glisson::registration
