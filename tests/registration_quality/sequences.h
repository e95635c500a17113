#pragma once
// Sequences whose truth is known: the front of a real liver's surface, breathing and pressed by a tool, registered
// perfectly but for a fault in a known place.

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <numeric>
#include <random>

#include "base/files.h"
#include "base/json.h"
#include "geometry/mesh_file.h"
#include "registration/rigid.h"
#include "registration_quality/benchmark.h"

namespace glisson::registration_quality::test {

using Eigen::Vector3d;

struct Fault {
  Vector3d center_mm{0, 0, 0};
  double radius_mm = 25;
  double largest_mm = 15;
  enum class Course { with_time, constant, irregular } course = Course::irregular;
};

struct SequenceSpec {
  int frames = 40;
  int landmarks = 60;
  double cloud_noise_mm = 0.3;
  double tracking_noise_mm = 0.3;
  double lost_share = 0.1;     // of the sightings of landmarks
  double outlier_share = 0.0;  // of the landmarks, which jump by 20 mm half way
  std::vector<Fault> faults;
  unsigned seed = 1;
};

struct MadeSequence {
  RegisteredSequence sequence;
  std::vector<std::vector<double>> true_error_mm;  // [frame][point]: how far the registration put it from its place
  std::vector<Vector3d> rest_mm;                   // of the points, in the model's space
  std::vector<Vector3d> landmarks_mm;              // at rest
};

inline double bump(const Vector3d& point, const Vector3d& center, double radius) {
  return std::exp(-(point - center).squaredNorm() / (radius * radius));
}

inline MadeSequence make_sequence(const geometry::Surface& liver, const SequenceSpec& spec) {
  MadeSequence made;
  std::mt19937 random(spec.seed);
  std::normal_distribution<double> normal(0, 1);
  std::uniform_real_distribution<double> uniform(0, 1);
  const auto jitter = [&](double sd_mm) {
    return Vector3d(sd_mm * normal(random), sd_mm * normal(random), sd_mm * normal(random));
  };

  // What a camera in front sees: points whose normal looks along -y.
  const auto normals = geometry::point_normals(liver);
  for (std::size_t i = 0; i < liver.points_mm.size(); ++i) {
    if (normals[i].y() < -0.3) made.rest_mm.push_back(liver.points_mm[i]);
  }
  const auto box = geometry::bounding_box(made.rest_mm);
  const Vector3d tool = box.center_mm() + Vector3d(0.25 * (box.max_mm - box.min_mm).x(), 0, 0);
  const auto in_frame = [&](const Vector3d& rest, int t) {
    const double breath = std::sin(2 * std::numbers::pi * t / 20.0);
    const double across = (rest.x() - box.min_mm.x()) / (box.max_mm - box.min_mm).x();
    const double press = std::max(0.0, std::sin(2 * std::numbers::pi * t / 27.0 + 1));
    return Vector3d(rest + breath * Vector3d(1, 2, 8 + 6 * across) +
                    8 * press * bump(rest, tool, 30) * Vector3d::UnitY());
  };
  std::vector<std::vector<double>> course(spec.faults.size());
  for (std::size_t f = 0; f < spec.faults.size(); ++f) {
    double walk = 0;
    for (int t = 0; t < spec.frames; ++t) {
      walk = std::clamp(walk + 0.5 * normal(random), -1.0, 1.0);
      course[f].push_back(spec.faults[f].course == Fault::Course::constant    ? 1.0
                          : spec.faults[f].course == Fault::Course::with_time ? static_cast<double>(t) / spec.frames
                                                                              : walk);
    }
  }
  const auto fault_at = [&](const Vector3d& rest, int t) {
    Vector3d fault = Vector3d::Zero();
    for (std::size_t f = 0; f < spec.faults.size(); ++f) {
      fault += spec.faults[f].largest_mm * course[f][static_cast<std::size_t>(t)] *
               bump(rest, spec.faults[f].center_mm, spec.faults[f].radius_mm) * Vector3d(0.6, 0.2, 0.77);
    }
    return fault;
  };

  for (int t = 0; t < spec.frames; ++t) {
    RegisteredFrame frame;
    std::vector<double> errors;
    for (const Vector3d& rest : made.rest_mm) {
      const Vector3d fault = fault_at(rest, t);
      frame.cloud_mm.push_back(in_frame(rest, t) + jitter(spec.cloud_noise_mm));
      frame.registered_mm.push_back(rest + fault);
      errors.push_back(fault.norm());
    }
    made.sequence.frames.push_back(std::move(frame));
    made.true_error_mm.push_back(std::move(errors));
  }
  std::vector<std::size_t> order(made.rest_mm.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::shuffle(order.begin(), order.end(), random);
  for (int k = 0; k < spec.landmarks; ++k) {
    LandmarkTrack track{"g" + std::to_string(k), {}};
    made.landmarks_mm.push_back(made.rest_mm[order[static_cast<std::size_t>(k)]]);
    const bool outlier = uniform(random) < spec.outlier_share;
    for (int t = 0; t < spec.frames; ++t) {
      const Vector3d seen = in_frame(made.rest_mm[order[static_cast<std::size_t>(k)]], t) +
                            jitter(spec.tracking_noise_mm) +
                            (outlier && t > spec.frames / 2 ? Vector3d(20, 0, 0) : Vector3d(0, 0, 0));
      track.positions_mm.push_back(uniform(random) < spec.lost_share ? std::nullopt : std::optional(seen));
    }
    made.sequence.landmarks.push_back(std::move(track));
  }
  return made;
}

// What `sequence` keeps with a video: all frames aligned by the tracks, whatever the registration under test did. Only
// its space, in a real video the model's own, is brought to the one of these sequences: as a rigid body.
inline Benchmark benchmark_for(const MadeSequence& made) {
  registration::Sightings sightings;
  for (const LandmarkTrack& track : made.sequence.landmarks) sightings.push_back(track.positions_mm);
  const auto alignment = registration::align_globally(sightings).value();
  Benchmark benchmark = benchmark_of(alignment);
  std::vector<Vector3d> from_mm, to_mm;
  for (std::size_t k = 0; k < sightings.size(); ++k) {
    if (!benchmark.on_model_mm[k]) continue;
    from_mm.push_back(*benchmark.on_model_mm[k]);
    to_mm.push_back(made.landmarks_mm[k]);
  }
  const auto to_model = registration::align_points(from_mm, to_mm).value();
  for (auto& place : benchmark.on_model_mm) {
    if (place) place = to_model * *place;
  }
  return benchmark;
}

// As a sequence on disk that was registered by somebody else: sequence.json with its benchmark, alone.json without, and
// truth.csv: each point at rest, and its mean true error over the frames.
inline void write_made(const MadeSequence& made, const std::filesystem::path& folder) {
  namespace fs = std::filesystem;
  fs::create_directories(folder);
  Json document{{"frames", Json::array()}, {"landmarks", "tracks.csv"}, {"registered", Json::array()}};
  for (std::size_t t = 0; t < made.sequence.frames.size(); ++t) {
    const auto& frame = made.sequence.frames[t];
    for (const auto& [letter, points_mm] : {std::pair{'f', &frame.cloud_mm}, std::pair{'r', &frame.registered_mm}}) {
      geometry::Surface cloud;
      cloud.points_mm = *points_mm;
      cloud.triangles = {{0, 1, 2}};
      EXPECT_TRUE(geometry::write_surface(folder / fmt::format("{}{:03}.ply", letter, t), cloud));
    }
    document["frames"].push_back({{"cloud", fmt::format("f{:03}.ply", t)}});
    document["registered"].push_back(fmt::format("r{:03}.ply", t));
  }
  std::string tracks = "landmark,frame,x_mm,y_mm,z_mm\n", truth = "x_mm,y_mm,z_mm,error_mm\n";
  for (const LandmarkTrack& track : made.sequence.landmarks) {
    for (std::size_t t = 0; t < track.positions_mm.size(); ++t) {
      if (!track.positions_mm[t]) continue;
      const Vector3d& seen = *track.positions_mm[t];
      tracks += fmt::format("{},{},{},{},{}\n", track.id, t, seen.x(), seen.y(), seen.z());
    }
  }
  for (std::size_t k = 0; k < made.rest_mm.size(); ++k) {
    double sum_mm = 0;
    for (const auto& frame : made.true_error_mm) sum_mm += frame[k] / static_cast<double>(made.true_error_mm.size());
    const Vector3d& rest = made.rest_mm[k];
    truth += fmt::format("{},{},{},{}\n", rest.x(), rest.y(), rest.z(), sum_mm);
  }
  EXPECT_TRUE(write_text_file(folder / "tracks.csv", tracks));
  EXPECT_TRUE(write_text_file(folder / "truth.csv", truth));
  EXPECT_TRUE(write_json_file(folder / "alone.json", document));
  EXPECT_TRUE(write_benchmark(folder / "benchmark.csv", made.sequence.landmarks, benchmark_for(made)));
  document["benchmark"] = "benchmark.csv";
  EXPECT_TRUE(write_json_file(folder / "sequence.json", document));
}

// The true error of each triangle: the mean, over all frames, of the points that lie over it.
inline std::vector<double> true_triangle_errors_mm(const MadeSequence& made, const geometry::Surface& mesh) {
  std::vector<double> errors;
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vector3d center = (mesh.points_mm[static_cast<std::size_t>(a)] + mesh.points_mm[static_cast<std::size_t>(b)] +
                             mesh.points_mm[static_cast<std::size_t>(c)]) /
                            3;
    // The nearest ten points to its middle stand for it: triangles are about as large as that.
    std::vector<std::size_t> nearest(made.rest_mm.size());
    std::iota(nearest.begin(), nearest.end(), std::size_t{0});
    std::partial_sort(nearest.begin(), nearest.begin() + 10, nearest.end(), [&](std::size_t x, std::size_t y) {
      return (made.rest_mm[x] - center).squaredNorm() < (made.rest_mm[y] - center).squaredNorm();
    });
    double sum = 0;
    for (int i = 0; i < 10; ++i) {
      for (const auto& frame : made.true_error_mm) sum += frame[nearest[static_cast<std::size_t>(i)]];
    }
    errors.push_back(sum / (10.0 * static_cast<double>(made.true_error_mm.size())));
  }
  return errors;
}

inline std::vector<double> ranks(const std::vector<double>& values) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
  std::vector<double> rank(values.size());
  for (std::size_t i = 0; i < order.size(); ++i) rank[order[i]] = static_cast<double>(i);
  return rank;
}

// Spearman's: the correlation of the ranks.
inline double rank_correlation(const std::vector<double>& a, const std::vector<double>& b) {
  const std::vector<double> ranks_a = ranks(a), ranks_b = ranks(b);
  const double mean = (static_cast<double>(a.size()) - 1) / 2;
  double covariance = 0, variance = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    covariance += (ranks_a[i] - mean) * (ranks_b[i] - mean);
    variance += (ranks_a[i] - mean) * (ranks_a[i] - mean);
  }
  return covariance / variance;
}

// How often a triangle beyond the limit is rated worse than one within it (the area under the ROC curve).
inline double roc_area(const std::vector<double>& rated_bad, const std::vector<double>& truth_mm, double limit_mm) {
  double won = 0, pairs = 0;
  for (std::size_t i = 0; i < truth_mm.size(); ++i) {
    for (std::size_t j = 0; j < truth_mm.size(); ++j) {
      if (truth_mm[i] < limit_mm || truth_mm[j] >= limit_mm) continue;
      won += rated_bad[i] > rated_bad[j] ? 1 : rated_bad[i] == rated_bad[j] ? 0.5 : 0;
      ++pairs;
    }
  }
  return pairs > 0 ? won / pairs : 0.5;
}

}  // namespace glisson::registration_quality::test
