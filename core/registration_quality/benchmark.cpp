#include "registration_quality/benchmark.h"

#include <fmt/format.h>
#include <cmath>
#include <Eigen/LU>
#include <map>
#include <string_view>

#include "base/csv.h"
#include "base/files.h"
#include "base/parallel.h"

namespace glisson::registration_quality {
namespace {

namespace fs = std::filesystem;
using Eigen::Vector3d;

constexpr std::string_view header = "landmark,frame,x_mm,y_mm,z_mm", model = "model";

// Where the warp comes from the place.
std::optional<Vector3d> inverse(const registration::FrameAlignment& frame, const Vector3d& place_mm) {
  constexpr int iterations = 30;
  constexpr double near_enough_mm = 1e-3;
  Vector3d at = frame.rigid.inverse() * place_mm;
  for (int i = 0; i < iterations; ++i) {
    const Vector3d off = place_mm - frame.warp(at);
    if (off.norm() < near_enough_mm) return at;
    const Vector3d step = frame.warp.jacobian(at).fullPivLu().solve(off);
    if (!step.allFinite()) return std::nullopt;
    // The kernel has kinks at the landmarks: half a step where a whole one leads away.
    at += (place_mm - frame.warp(at + step)).norm() < off.norm() ? step : Vector3d(0.5 * step);
  }
  return std::nullopt;
}

}  // namespace

Benchmark benchmark_of(const registration::GlobalAlignment& alignment) {
  const std::size_t landmarks = alignment.landmarks_mm.size(), frames = alignment.frames.size();
  Benchmark benchmark{alignment.landmarks_mm,
                      std::vector(landmarks, std::vector<std::optional<Vector3d>>(frames, std::nullopt))};
  parallel_for(landmarks, 8, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      if (!alignment.landmarks_mm[k]) continue;
      for (std::size_t t = 0; t < frames; ++t) {
        if (alignment.frames[t])
          benchmark.in_frames_mm[k][t] = inverse(*alignment.frames[t], *alignment.landmarks_mm[k]);
      }
    }
  });
  return benchmark;
}

Result<void> write_benchmark(const fs::path& file, const std::vector<LandmarkTrack>& landmarks,
                             const Benchmark& benchmark) {
  std::string csv = fmt::format("{}\n", header);
  const auto add = [&](std::size_t k, const std::string& frame, const std::optional<Vector3d>& at) {
    if (at) csv += fmt::format("{},{},{:.4f},{:.4f},{:.4f}\n", landmarks[k].id, frame, at->x(), at->y(), at->z());
  };
  for (std::size_t k = 0; k < landmarks.size(); ++k) {
    add(k, std::string(model), benchmark.on_model_mm[k]);
    for (std::size_t t = 0; t < benchmark.in_frames_mm[k].size(); ++t) {
      add(k, std::to_string(t), benchmark.in_frames_mm[k][t]);
    }
  }
  return write_text_file(file, csv);
}

Result<Benchmark> read_benchmark(const fs::path& file, const std::vector<LandmarkTrack>& landmarks,
                                 std::size_t frames) {
  const auto text = read_text_file(file);
  if (!text) return failure(text.error());
  const std::vector<CsvRow> rows = csv_rows(*text);
  if (rows.empty() || fmt::format("{}", fmt::join(rows.front().cells, ",")) != header) {
    return failure(Error{"benchmark-invalid",
                         GLISSON_TEXT("The first line of {0} is not {1}."),
                         {file.filename().string(), std::string(header)},
                         GLISSON_TEXT("Name the columns so, in this order, with commas between them."),
                         file});
  }
  std::map<std::string_view, std::size_t> place_of;
  for (std::size_t k = 0; k < landmarks.size(); ++k) place_of.emplace(landmarks[k].id, k);
  Benchmark benchmark{std::vector<std::optional<Vector3d>>(landmarks.size()),
                      std::vector(landmarks.size(), std::vector<std::optional<Vector3d>>(frames))};
  for (auto row = rows.begin() + 1; row != rows.end(); ++row) {
    const bool whole = row->cells.size() == 5;
    const Vector3d at = whole ? Vector3d(row->number(2), row->number(3), row->number(4)) : Vector3d::Zero();
    const auto place = whole ? place_of.find(row->cells[0]) : place_of.end();
    const bool on_model = whole && row->cells[1] == model;
    const double frame = whole && !on_model ? row->number(1) : 0;
    const bool is_frame = frame >= 0 && frame < static_cast<double>(frames) && frame == std::floor(frame);
    if (place == place_of.end() || !at.allFinite() || !is_frame) {
      return failure(Error{"benchmark-invalid",
                           GLISSON_TEXT("Line {1} of {0} is not landmark,frame,x_mm,y_mm,z_mm of a landmark in the "
                                        "tracks, with \"model\" or a frame below {2}."),
                           {file.filename().string(), std::to_string(row->line), std::to_string(frames)},
                           GLISSON_TEXT("Make the sequence anew, or leave \"benchmark\" out of it."),
                           file});
    }
    (on_model ? benchmark.on_model_mm[place->second]
              : benchmark.in_frames_mm[place->second][static_cast<std::size_t>(frame)]) = at;
  }
  return benchmark;
}

}  // namespace glisson::registration_quality
