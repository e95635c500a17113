// Frames of a real liver's surface that breathes before a camera that moves, brought to one model by tracked landmarks.

#include "registration/global_alignment.h"

#include <gtest/gtest.h>
#include <cmath>
#include <random>

#include "geometry/mesh_file.h"
#include "geometry/nearest.h"
#include "support/data.h"

namespace glisson::registration {
namespace {

using Eigen::Vector3d;

struct Provenance {
  std::vector<geometry::Surface> surfaces;  // of each frame, in its own space
  Sightings sightings;
};

Vector3d in_frame(const Vector3d& rest, int t) {
  const double breath = std::sin(0.7 * t);
  const Vector3d bent = rest + breath * Vector3d(0, 2, 5 * std::sin(rest.x() / 60) + 3);
  return Eigen::AngleAxisd(0.05 * t, Vector3d(0.3, 1, 0.2).normalized()) * bent + Vector3d(2.0 * t, -t, 0.5 * t);
}

Provenance make(double noise_mm, double outlier_share) {
  const auto liver =
      geometry::read_surface(glisson::test::shared_data() / "pbsm_liver_insilico" / "Liver1" / "tgt.ply").value();
  std::mt19937 random(4);
  std::normal_distribution<double> noise(0, noise_mm);
  std::uniform_real_distribution<double> uniform(0, 1);
  Provenance made;
  constexpr int frames = 8, landmarks = 90;
  for (int t = 0; t < frames; ++t) {
    geometry::Surface surface = liver;
    for (Vector3d& point : surface.points_mm) point = in_frame(point, t);
    made.surfaces.push_back(std::move(surface));
  }
  for (int k = 0; k < landmarks; ++k) {
    const Vector3d rest = liver.points_mm[static_cast<std::size_t>(k) * liver.points_mm.size() / landmarks];
    auto& track = made.sightings.emplace_back();
    for (int t = 0; t < frames; ++t) {
      Vector3d seen = in_frame(rest, t) + Vector3d(noise(random), noise(random), noise(random));
      if (uniform(random) < outlier_share) seen += Vector3d(25, -10, 15);
      track.push_back(uniform(random) < 0.2 ? std::nullopt : std::optional(seen));
    }
  }
  return made;
}

// How far apart the frames put the same point of the tissue: root mean square from the mean over the frames.
double disagreement_mm(const Provenance& made, const GlobalAlignment& alignment) {
  double sum = 0, count = 0;
  for (std::size_t i = 0; i < made.surfaces.front().points_mm.size(); i += 37) {
    std::vector<Vector3d> places;
    Vector3d mean = Vector3d::Zero();
    for (std::size_t t = 0; t < made.surfaces.size(); ++t)
      places.push_back(alignment.frames[t]->warp(made.surfaces[t].points_mm[i]));
    for (const Vector3d& place : places) mean += place / static_cast<double>(places.size());
    for (const Vector3d& place : places) sum += (place - mean).squaredNorm();
    count += static_cast<double>(places.size());
  }
  return std::sqrt(sum / count);
}

// The tissue moves by centimetres, and bends by 8 mm either way, which no rigid motion takes off.
TEST(GlobalAlignment, BringsEachPointOfTheTissueToOnePlace) {
  GLISSON_NEEDS_DATA("pbsm_liver_insilico");
  const Provenance made = make(0.3, 0);
  const GlobalAlignment alignment = align_globally(made.sightings).value();
  EXPECT_GT(alignment.before_rms_mm, 10);
  EXPECT_LT(alignment.rigid_rms_mm, 5);
  EXPECT_LT(alignment.rms_mm, 1);
  EXPECT_LT(disagreement_mm(made, alignment), 1);
  EXPECT_TRUE(alignment.notes.empty());
  RecordProperty("before_rms_mm", std::to_string(alignment.before_rms_mm));
  RecordProperty("rigid_rms_mm", std::to_string(alignment.rigid_rms_mm));
  RecordProperty("disagreement_mm", std::to_string(disagreement_mm(made, alignment)));
}

TEST(GlobalAlignment, LeavesOutTracksThatJump) {
  GLISSON_NEEDS_DATA("pbsm_liver_insilico");
  const Provenance made = make(0.3, 0.05);
  const GlobalAlignment alignment = align_globally(made.sightings).value();
  EXPECT_GT(alignment.outliers, 15);
  EXPECT_LT(disagreement_mm(made, alignment), 1.2);
}

// S is one to one where it was fitted: no small tetrahedron of space at the surface turns over.
TEST(GlobalAlignment, NeverFoldsTheSurface) {
  GLISSON_NEEDS_DATA("pbsm_liver_insilico");
  const Provenance made = make(2, 0.05);  // noise that would make an exact warp fold
  const GlobalAlignment alignment = align_globally(made.sightings).value();
  for (std::size_t t = 0; t < made.surfaces.size(); ++t) {
    ASSERT_TRUE(alignment.frames[t].has_value());
    for (std::size_t i = 0; i < made.surfaces[t].points_mm.size(); i += 23) {
      EXPECT_GT(alignment.frames[t]->warp.jacobian(made.surfaces[t].points_mm[i]).determinant(), 0);
    }
  }
}

TEST(GlobalAlignment, MergesFramesIntoAModelWithLessNoise) {
  GLISSON_NEEDS_DATA("pbsm_liver_insilico");
  Provenance made = make(0.1, 0);
  const GlobalAlignment clean = align_globally(made.sightings).value();
  const geometry::Surface without_noise = merged_model(made.surfaces, clean);
  std::mt19937 random(9);
  std::normal_distribution<double> noise(0, 0.8);
  for (auto& surface : made.surfaces)
    for (Vector3d& point : surface.points_mm) point += Vector3d(noise(random), noise(random), noise(random));
  const geometry::Surface merged = merged_model(made.surfaces, clean);
  const auto one_frame = [&](std::size_t i) {
    const auto reference = static_cast<std::size_t>(clean.reference);
    return clean.frames[reference]->warp(made.surfaces[reference].points_mm[i]);
  };
  // Along the surface a nearest point says nothing; across it eight frames are averaged.
  const geometry::SurfaceDistance clean_surface(without_noise);
  double of_merged = 0, of_one = 0;
  for (std::size_t i = 0; i < merged.points_mm.size(); i += 11) {
    of_merged += std::pow(clean_surface.closest(merged.points_mm[i]).distance_mm, 2);
    of_one += std::pow(clean_surface.closest(one_frame(i)).distance_mm, 2);
  }
  EXPECT_LT(of_merged, 0.5 * of_one);
}

TEST(GlobalAlignment, RefusesWhatCannotBeAligned) {
  EXPECT_EQ(align_globally({}).error().code, "alignment-too-few-frames");
  const std::optional<Vector3d> here = Vector3d(1, 2, 3);
  EXPECT_EQ(align_globally({{here, here}, {here, here, here}}).error().code, "alignment-sizes");
  EXPECT_EQ(align_globally({{here, here}, {here, std::nullopt}}).error().code, "alignment-too-few-landmarks");
}

}  // namespace
}  // namespace glisson::registration
