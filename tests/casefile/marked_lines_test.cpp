// Lines that a person marks on the model and on frames: they tell how an organ lies whose shape alone does not.

#include "casefile/marked_lines.h"

#include <gmock/gmock.h>

#include "base/files.h"
#include "base/json.h"
#include "base/write_file.h"
#include "guidance/guidance_answer.h"
#include "support/egg.h"

namespace glisson::casefile {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

MarkedLines some_lines() {
  return {std::string(64, 'a'),
          {{"falciform", {{1, 2, 3}, {4.5, 5, 6}}, {{2, {{7, 8, 90}, {1.0 / 3, 0, 100}}}, {11, {}}}},
           {"lower-edge", {{1, 1, 1}}, {{0, {{1, 2, 100}, {3, 4, 100}}}}}}};
}

TEST(MarkedLines, AreReadAsTheyWereWritten) {
  const MarkedLines lines = some_lines();
  const Json document = json_of(lines);
  const auto again = marked_lines_from(document);
  ASSERT_TRUE(again);
  EXPECT_EQ(json_of(*again), document);
  EXPECT_EQ(again->lines.front().seen_mm.at(2).back(), Vector3d(1.0 / 3, 0, 100));
}

// The other line has one place on the model.
TEST(MarkedLines, CountFromTwoPlacesOnEachSide) {
  EXPECT_EQ(first_marked_frame(some_lines()), 2u);
  EXPECT_FALSE(first_marked_frame({}));
}

TEST(MarkedLines, WhatIsNoneIsRefused) {
  for (const char* text :
       {"[]", "{}", R"({"format": "glisson-marked-lines/2", "lines": []})", R"({"format": 1, "lines": []})",
        R"({"format": "glisson-marked-lines/1", "lines": 3})", R"({"format": "glisson-marked-lines/1", "lines": [{}]})",
        R"({"format": "glisson-marked-lines/1", "lines": [{"id": "a", "at_rest": [[1, 2]]}]})",
        R"({"format": "glisson-marked-lines/1", "lines": [{"id": "a", "at_rest": [[1, 2, 1e999]]}]})",
        R"({"format": "glisson-marked-lines/1", "lines": [{"id": "a", "seen": {"-1": []}}]})",
        R"({"format": "glisson-marked-lines/1", "lines": [{"id": "a", "seen": {"99999999999999999999": []}}]})",
        R"({"format": "glisson-marked-lines/1", "lines": [{"id": "a", "seen": [1]}]})"}) {
    EXPECT_FALSE(marked_lines_from(Json::parse(text, nullptr, false))) << text;
  }
  const TemporaryFolder folder;
  ASSERT_TRUE(write_text_file(folder.path() / "lines.json", "{}"));
  const auto read = read_marked_lines(folder.path() / "lines.json");
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().code, "lines-invalid");
  EXPECT_THAT(read.error().message(), testing::HasSubstr("lines.json"));
}

// Where the upper side of the egg lies at (x, y).
Vector3d on_egg(double x_mm, double y_mm) {
  const double y = y_mm / 30, x = x_mm / (40 * (1 + 0.25 * y));
  return {x_mm, y_mm, 20 * std::sqrt(1 - x * x - y * y)};
}

// Half a turn about its longest side takes the egg nearly to itself; a line on it does not come to lie on itself.
TEST(MarkedLines, TellHowAnOrganLiesWhereItsShapeDoesNot) {
  const geometry::TetMesh mesh = guidance::egg();
  const Isometry3d pose =
      Eigen::Translation3d(5, -3, 150) * Eigen::AngleAxisd(2.9, Vector3d(1, 0.1, 0.05).normalized());
  GuidedSequence guided;
  guided.guidance.mesh = mesh;
  guided.guidance.youngs_kPa.assign(mesh.cells.size(), 5.0);
  guided.guidance.frames = {guidance::half_seen(mesh, pose)};
  guided.guidance.targets = {{"deep", {20, 5, 0}}};
  guided.frame_of = {0};
  guided.structures = {guidance::embedded("liver", {255, 255, 255}, geometry::boundary_surface(mesh), mesh)};
  const auto without = guidance::answer(guided.guidance);
  ASSERT_TRUE(without);
  const auto off_mm = [&](const guidance::ElasticPlacement& placed) {
    return (placed.target_mm.front() - pose * Vector3d(20, 5, 0)).norm();
  };
  const auto& alone = without->frames.front().placement;
  EXPECT_TRUE(!alone.converged || off_mm(alone) > 5);

  // What is seen of the line begins and ends elsewhere than on the model.
  MarkedLines marked{"", {{"ridge", {}, {}}}};
  for (const double x_mm : {-28.0, -14.0, 0.0, 12.0, 24.0})
    marked.lines[0].at_rest_mm.push_back(on_egg(x_mm, 8 - 0.4 * x_mm));
  for (const double x_mm : {-20.0, -8.0, 4.0, 20.0, 28.0}) {
    marked.lines[0].seen_mm[0].push_back(pose * on_egg(x_mm, 8 - 0.4 * x_mm));
  }
  add_lines(guided, marked);
  ASSERT_EQ(guided.guidance.frames.front().curves.size(), 1u);
  const auto with = guidance::answer(guided.guidance);
  ASSERT_TRUE(with);
  const auto& placed = with->frames.front().placement;
  ASSERT_TRUE(placed.converged) << placed.why_not.message();
  EXPECT_LT(off_mm(placed), 3);
}

}  // namespace
}  // namespace glisson::casefile
