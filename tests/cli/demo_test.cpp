// The main job through the program itself: the demo's own DICOM files, read back, to moved landmarks, a report, and the
// tumour on the frames of a video.

#include <gmock/gmock.h>

#include "base/files.h"
#include "support/process.h"

namespace glisson::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

// One test, since the study takes half a minute to make and read.
TEST(Demo, GoesFromDicomToAReportWithoutADisplay) {
  const TemporaryFolder folder;
  const fs::path out = folder.path() / "demo";
  const char* display = std::getenv("DISPLAY");
  const std::string kept = display ? display : "";
  unsetenv("DISPLAY");
  const Finished finished = glisson_cli({"demo", "--guide", "--out", out.string(), "--json", "--quiet"});
  if (display) setenv("DISPLAY", kept.c_str(), 1);
  ASSERT_EQ(finished.exit_code, 0) << finished.err;
  const Json summary = finished.json();

  // What a person would check: the liver is found, the model is the patient's, the equilibrium is one.
  EXPECT_GT(summary.at("liver_dice").get<double>(), 0.9);
  EXPECT_NEAR(summary.at("cells").get<double>(), 20000, 0.15 * 20000);
  EXPECT_LT(summary.at("stiffness").at("mean_error_kPa").get<double>(),
            0.25 * summary.at("stiffness").at("mean_kPa").get<double>());
  EXPECT_LT(summary.at("relative_residual").get<double>(), 1e-9);
  EXPECT_GT(summary.at("max_displacement_mm").get<double>(), 5.0);
  EXPECT_GE(summary.at("landmarks").size(), 10u);

  const std::string report = read_text_file(out / "report.html").value();
  EXPECT_THAT(report, HasSubstr("SIMULATED"));
  EXPECT_THAT(report, HasSubstr("Not a medical device"));
  for (const char* picture : {"anatomy", "liver", "stiffness", "model", "displacement", "comparison"}) {
    EXPECT_TRUE(fs::exists(out / "pictures" / (std::string(picture) + ".png"))) << picture;
  }

  // Its tumour on a laparoscope's frames, beside where it truly is.
  const Json& guided = summary.at("guided");
  EXPECT_EQ(guided.at("frames").size(), 12u);
  EXPECT_EQ(guided.at("structure"), "tumour-1");
  EXPECT_LT(guided.at("mean_error_mm").get<double>(), 5.0);  // the line that matters
  EXPECT_TRUE(fs::exists(out / "guided" / "tumour.png"));

  // The case is one for the other commands, and a second demo does not overwrite what is not a demo.
  const std::string patient = (out / "demo.glisson").string();
  const Finished exported = glisson_cli(
      {"export", patient, "--format", "dicom-seg", "--out", (folder.path() / "seg.dcm").string(), "--json", "--quiet"});
  EXPECT_EQ(exported.exit_code, 0) << exported.err;

  // What the program does in a frame, timed with that patient, is what a plan is then asked for.
  const std::string tasks = (folder.path() / "tasks.json").string();
  const Finished timed = glisson_cli({"platform", "measure", "--out", (folder.path() / "mine.json").string(),
                                      "--largest-MB", "1", "--seconds-per-point", "0.001", "--product", patient,
                                      "--tasks-out", tasks, "--product-frames", "1", "--json", "--quiet"});
  ASSERT_EQ(timed.exit_code, 0) << timed.err;
  const Json timed_tasks = timed.json().at("tasks");
  ASSERT_EQ(timed_tasks.size(), 5u) << timed.out;
  for (const Json& task : timed_tasks) {
    const std::string id = task.at("id");
    EXPECT_GT(task.at("seconds").get<double>(), 0) << id;
    const Finished planned = glisson_cli({"platform", "plan", "--for", id, "--tasks", tasks, "--json", "--quiet"});
    ASSERT_EQ(planned.exit_code, 0) << planned.err;
    const Json workload = planned.json().at("workload");
    EXPECT_EQ(workload.at("what"), task.at("what"));
    EXPECT_EQ(workload.at("frame_bytes"), task.at("bytes"));
  }

  // Predicted landmarks over the scan: by themselves, and a picture a group in the case's report.
  const fs::path results = out / "demo.glisson" / "results";
  const std::string picture = (folder.path() / "tumour.png").string();
  const Finished drawn = glisson_cli({"render", (results / "mre").string(), "--scene", "landmarks", "--atlas",
                                      (results / "atlas").string(), "--group", "tumour", "--size", "400x300", "--out",
                                      picture, "--quiet"});
  EXPECT_EQ(drawn.exit_code, 0) << drawn.err;
  EXPECT_TRUE(fs::exists(picture));
  const std::string page = (folder.path() / "report.html").string();
  ASSERT_EQ(glisson_cli({"report", patient, "--out", page, "--quiet"}).exit_code, 0);
  const auto text = read_text_file(page);
  ASSERT_TRUE(text);
  for (const char* group : {"tumour", "portal-vein", "hepatic-vein"})
    EXPECT_NE(text->find(std::string("Where the retraction brings ") + group), std::string::npos) << group;

  const Json found = glisson_cli({"scan", (folder.path() / "seg.dcm").string(), "--json", "--quiet"}).json();
  EXPECT_EQ(found.at("series")[0].at("role"), "segmentation");
  ASSERT_TRUE(write_text_file(folder.path() / "taken" / "thesis.txt", "precious"));
  EXPECT_EQ(glisson_cli({"demo", "--out", (folder.path() / "taken").string(), "--quiet"}).exit_code, 1);
}

}  // namespace
}  // namespace glisson::test
