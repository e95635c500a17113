// Records that programs leave for each other: ours, other laboratories' and measuring devices'. Seeds are what ships,
// what our writers write, and a few lines of text.

#include <sstream>

#include "base/files.h"
#include "closedloop/experiment/experiment.h"
#include "closedloop/explain.h"
#include "closedloop/explanation_file.h"
#include "fuzz/reader_target.h"
#include "geometry/mesh_file.h"
#include "hardware/cell.h"
#include "hardware/power_trace.h"
#include "hardware/task.h"
#include "imaging/label_names.h"
#include "registration_quality/benchmark.h"
#include "registration_quality/quality_file.h"
#include "shapes/model_file.h"
#include "studies/gate/choose_cases.h"
#include "studies/gate/gate.h"
#include "studies/gate/results.h"
#include "support/folders.h"
#include "support/shapes.h"

namespace glisson::fuzz {
namespace {

namespace fs = std::filesystem;

const fs::path resources = test::source_folder() / "resources";

constexpr const char* tolerances = R"({"metrics": {"tre_mm": {"better": "lower", "percent": 2, "absolute": 0.1},
 "dice": {"better": "higher", "each_case": true}, "cells": {"better": "same"}}, "false_alarms": 0.05,
 "similarity": 0.9, "masks": {"view.png": "mask.png"}})";

constexpr const char* results = "case,tre_mm,dice\na,1.5,0.9\nb,,0.8\nc,2.5,nan\n";
constexpr const char* history = "case,seconds,dice,tre_mm\na,60,0.9,2\nb,,0.8,\na,66,0.91,2.1\n";

constexpr const char* benchmark = "landmark,frame,x_mm,y_mm,z_mm\n1,model,1,2,3\n1,0,1,2,3.5\n7,1,4,5,6\n";

constexpr const char* descriptions =
    "# ITK-SNAP label descriptions\n0 0 0 0 0 0 0 \"Clear Label\"\n1 255 0 0 1 1 1 \"liver\"\n"
    "13 0 255 0 0.5 1 1 \"tumour, left\"\n";

constexpr const char* better_model = R"({"format": "glisson-closedloop-model/1", "kind": "material",
 "verdict": "explained", "effects": [{"kind": "stiffness-scale", "parameters": {"factor": 1.5}}],
 "mesh_error_share": 0.1, "reading": "as-measured", "smooth_correction": {"center": [0], "spread": [1],
 "length_scale": 0.5, "direction": [0], "directions": ["stress"], "weights": [0.1], "features": [[0.2]]}})";

constexpr const char* judged = R"({"sequence": "/s/sequence.json", "method": "icp", "judged_against": "benchmark",
 "tolerances_mm": [1, 2.5], "frames": 1, "mean_correlation": 0.5, "tre_per_frame_mm": [1.5],
 "rmse_per_frame_mm": [0.5], "notes": ["one"]})";

// A second each, a cell that is discharged while it warms.
std::string discharge() {
  std::ostringstream text;
  text << "time,current,voltage,power,temperature,charge,ambient\n";
  for (int second = 0; second < 30; ++second) {
    text << second << ",1.5," << 4.1 - 0.02 * second << ",6," << 25 + 0.1 * second << ",0,24.5\n";
  }
  return text.str();
}

std::string power_trace() {
  std::ostringstream text;
  text << "s;V;A\r\n";
  for (int second = 0; second < 20; ++second) text << second << ";12;" << 1 + second % 3 << "\r\n";
  return text.str();
}

void mesh_of_a_judgement(const fs::path& folder) {
  geometry::Surface ball = test::sphere_surface(10, 1);
  for (const char* name : {"correlation", "error_mm", "frames"}) {
    geometry::set_field(ball.cell_fields, {name, 1, std::vector<double>(ball.triangles.size(), 1)});
  }
  geometry::set_field(ball.point_fields, {"frame_000_mm", 3, std::vector<double>(3 * ball.points_mm.size(), 0.5)});
  promise(bool(geometry::write_surface(folder / "quality.vtp", ball)), "a judgement is written");
}

// The fields of a judgement are numbers from a file too.
Target mesh_of_quality() {
  const auto seeds = [](const fs::path& folder) {
    mesh_of_a_judgement(folder);
    return std::vector<std::string>{read_text_file(folder / "quality.vtp").value()};
  };
  const auto run = [](const std::string& bytes, const fs::path& folder) {
    file_of(bytes, folder, "quality.vtp");
    file_of(judged, folder, "sirgn.json");
    const auto read = registration_quality::read_quality(folder);
    if (!read) promise(!read.error().message().empty(), "a refusal says why");
  };
  return {"quality-mesh", seeds, run};
}

Target shape_model() {
  const auto seeds = [](const fs::path& folder) {
    shapes::ShapeModel model;
    model.mean = test::sphere_surface(10, 1);
    const auto points = static_cast<Eigen::Index>(model.mean.points_mm.size());
    model.modes_mm = Eigen::MatrixXd::Constant(3 * points, 2, 0.5);
    model.residual_sd_mm = Eigen::VectorXd::Constant(points, 0.1);
    model.livers = 5;
    promise(bool(shapes::write_model(folder / "model.vtp", model)), "a shape model is written");
    return std::vector<std::string>{read_text_file(folder / "model.vtp").value()};
  };
  const auto run = [](const std::string& bytes, const fs::path& folder) {
    const auto model = shapes::read_model(file_of(bytes, folder, "model.vtp"));
    if (!model) return promise(!model.error().message().empty(), "a refusal says why");
    const auto points = static_cast<Eigen::Index>(model->mean.points_mm.size());
    promise(model->modes_mm.rows() == 3 * points && model->residual_sd_mm.size() == points, "a mode of each point");
    promise(model->modes_mm.allFinite() && model->residual_sd_mm.allFinite(), "modes that are numbers");
  };
  return {"shapes", seeds, run};
}

// For the experiment that ships.
Result<closedloop::BetterModel> model_of_the_example(const fs::path& file) {
  static const auto experiment = closedloop::read_experiment(resources / "examples/tissue/experiment.json").value();
  static const auto forward = closedloop::forward_model(experiment).value();
  return closedloop::read_model(file, *forward, experiment);
}

// No descriptions are an answer, too.
Target label_descriptions() {
  return {"labels", [](const fs::path&) { return std::vector<std::string>{descriptions}; },
          [](const std::string& bytes, const fs::path&) { (void)imaging::label_descriptions(bytes); }};
}

}  // namespace

std::vector<Target> targets() {
  const std::vector<registration_quality::LandmarkTrack> tracks{{"1", {}}, {"7", {}}};
  const hardware::TraceFormat clamps{"1", 1, {{"A", 1, 12, {}}}, -2};
  return {
      reader_of("tasks", "t.json", {read_text_file(resources / "devices/tasks.json").value()},
                [](const fs::path& file) { return hardware::read_tasks(file); }),
      reader_of("discharge", "d.csv", {discharge()},
                [](const fs::path& file) { return hardware::read_discharge(file, {}); }),
      reader_of("power-trace", "p.csv", {power_trace()},
                [clamps](const fs::path& file) { return hardware::read_power_trace(file, clamps); }),
      reader_of("tolerances", "t.json", {tolerances},
                [](const fs::path& file) { return studies::read_tolerances(file); }),
      reader_of("gate-results", "metrics.csv", {results},
                [](const fs::path& file) { return studies::read_results(file.parent_path()); }),
      reader_of("gate-history", "h.csv", {history},
                [](const fs::path& file) { return studies::read_gate_history(file); }),
      reader_of("benchmark", "b.csv", {benchmark},
                [tracks](const fs::path& file) { return registration_quality::read_benchmark(file, tracks, 2); }),
      reader_of(
          "quality", "sirgn.json", {judged},
          [](const fs::path& file) { return registration_quality::read_quality(file.parent_path()); },
          mesh_of_a_judgement),
      mesh_of_quality(),
      shape_model(),
      reader_of("model", "model.json", {better_model}, model_of_the_example),
      label_descriptions(),
  };
}

}  // namespace glisson::fuzz
