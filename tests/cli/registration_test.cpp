// glisson-cli match, register and sirgn, in the contract's words.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <cmath>

#include "base/files.h"
#include "geometry/mesh_file.h"
#include "support/data.h"
#include "support/process.h"

namespace glisson::test {
namespace {

std::string wolf(int pose) {
  return (shared_data() / "tosca_nonrigid_shapes" / fmt::format("wolf{}.off", pose)).string();
}

std::string liver(const char* file) { return (shared_data() / "pbsm_liver_insilico" / "Liver1" / file).string(); }

TEST(MatchCommand, WritesAPairForEachPointAndSaysHowGoodTheyAre) {
  GLISSON_NEEDS_DATA("tosca_nonrigid_shapes");
  const TemporaryFolder folder;
  const std::string out = (folder.path() / "matches.csv").string();
  const Finished finished =
      glisson_cli({"match", wolf(0), wolf(1), "--points", "48", "--out", out, "--json", "--quiet"});
  ASSERT_EQ(finished.exit_code, 0) << finished.err;
  const Json answer = finished.json();
  EXPECT_EQ(answer.at("points"), 48);
  for (const char* key : {"energy", "lower_bound", "iterations", "solve_ms"}) EXPECT_TRUE(answer.contains(key)) << key;
  EXPECT_LE(answer.at("lower_bound").get<double>(), answer.at("energy").get<double>());
  const std::string csv = read_text_file(out).value();
  EXPECT_TRUE(csv.starts_with("source_vertex,target_vertex\n"));
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 49);
}

// A wolf as shape collections have them: ten triangles turned, three doubled.
std::filesystem::path damaged_wolf(const std::filesystem::path& folder) {
  geometry::Surface surface = geometry::read_surface(wolf(0)).value();
  for (std::size_t t = 100; t < 1100; t += 100) std::swap(surface.triangles[t][0], surface.triangles[t][1]);
  for (const std::size_t t : {7U, 77U, 777U}) surface.triangles.push_back(surface.triangles[t]);
  const auto file = folder / "damaged.obj";
  EXPECT_TRUE(geometry::write_surface(file, surface));
  return file;
}

TEST(MatchCommand, MendsTurnedAndDoubledTrianglesAndSaysSo) {
  GLISSON_NEEDS_DATA("tosca_nonrigid_shapes");
  const TemporaryFolder folder;
  const auto damaged = damaged_wolf(folder.path());
  const std::string out = (folder.path() / "m.csv").string(), sound = (folder.path() / "sound.csv").string();
  const Finished finished =
      glisson_cli({"match", damaged.string(), wolf(1), "--points", "48", "--out", out, "--json", "--quiet"});
  ASSERT_EQ(finished.exit_code, 0) << finished.err;
  ASSERT_FALSE(finished.json().at("notes").empty());
  EXPECT_THAT(finished.json().at("notes")[0].get<std::string>(), ::testing::HasSubstr("damaged.obj"));
  ASSERT_EQ(glisson_cli({"match", wolf(0), wolf(1), "--points", "48", "--out", sound, "--quiet"}).exit_code, 0);
  EXPECT_EQ(read_text_file(out).value(), read_text_file(sound).value());
}

TEST(RegisterCommand, MendsTheSourceAndGivesItBackAsItWas) {
  GLISSON_NEEDS_DATA("tosca_nonrigid_shapes");
  const TemporaryFolder folder;
  const auto damaged = damaged_wolf(folder.path());
  const std::string out = (folder.path() / "moved.obj").string();
  const Finished finished =
      glisson_cli({"register", damaged.string(), wolf(0), "--method", "icp", "--out", out, "--json", "--quiet"});
  ASSERT_EQ(finished.exit_code, 0) << finished.err;
  EXPECT_FALSE(finished.json().at("notes").empty());
  const geometry::Surface given = geometry::read_surface(damaged).value();
  const geometry::Surface moved = geometry::read_surface(out).value();
  EXPECT_EQ(moved.triangles, given.triangles);
  EXPECT_EQ(moved.points_mm.size(), given.points_mm.size());
}

TEST(MatchCommand, RefusesMorePointsThanTheSurfaceHas) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "tetrahedron.obj";
  ASSERT_TRUE(write_text_file(file, "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n"));
  const Finished finished = glisson_cli({"match", file.string(), file.string(), "--points", "48", "--out",
                                         (folder.path() / "m.csv").string(), "--json", "--quiet"});
  EXPECT_EQ(finished.exit_code, 1);
  EXPECT_EQ(finished.json().at("error").at("code"), "too-few-points");
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "m.csv"));
}

TEST(RegisterCommand, MovesTheSourceOntoTheTarget) {
  GLISSON_NEEDS_DATA("pbsm_liver_insilico");
  const TemporaryFolder folder;
  const std::string out = (folder.path() / "moved.ply").string();
  const Finished finished = glisson_cli(
      {"register", liver("src.ply"), liver("tgt.ply"), "--method", "icp", "--out", out, "--json", "--quiet"});
  ASSERT_EQ(finished.exit_code, 0) << finished.err;
  EXPECT_LT(finished.json().at("rms_mm").get<double>(), 1.0);
  EXPECT_GT(finished.json().at("iterations").get<int>(), 1);
  EXPECT_TRUE(std::filesystem::exists(out));
}

// Nine points that rise and fall, "registered" by leaving the motion in one corner.
void write_sequence(const std::filesystem::path& folder, int frames) {
  Json document{{"frames", Json::array()}, {"landmarks", "tracks.csv"}, {"registered", Json::array()}};
  std::string tracks = "landmark, frame, x_mm, y_mm, z_mm\n";  // as people type it
  for (int t = 0; t < frames; ++t) {
    const double height_mm = 5 * std::sin(t);
    const std::string header =
        "ply\nformat ascii 1.0\nelement vertex 9\nproperty float x\nproperty float y\nproperty float z\nend_header\n";
    std::string seen = header, registered = header;
    for (int k = 0; k < 9; ++k) {
      const int x = 10 * (k % 3), y = 10 * (k / 3);
      seen += fmt::format("{} {} {}\n", x, y, height_mm);
      registered += fmt::format("{} {} {}\n", x, y, k == 8 ? height_mm : 0.0);
      tracks += fmt::format("g{},{},{},{},{}\n", k, t, x, y, height_mm);
    }
    ASSERT_TRUE(write_text_file(folder / fmt::format("f{}.ply", t), seen));
    ASSERT_TRUE(write_text_file(folder / fmt::format("r{}.ply", t), registered));
    document["frames"].push_back({{"cloud", fmt::format("f{}.ply", t)}});
    document["registered"].push_back(fmt::format("r{}.ply", t));
  }
  ASSERT_TRUE(write_text_file(folder / "tracks.csv", tracks));
  ASSERT_TRUE(write_json_file(folder / "sequence.json", document));
}

TEST(SirgnCommand, JudgesWhatSomebodyElseRegistered) {
  const TemporaryFolder folder;
  write_sequence(folder.path(), 8);
  const std::string sequence = (folder.path() / "sequence.json").string();
  const std::string out = (folder.path() / "quality").string();
  const Finished finished = glisson_cli(
      {"sirgn", sequence, "--method", "given", "--tolerance-mm", "10,2", "--out", out, "--json", "--quiet"});
  ASSERT_EQ(finished.exit_code, 0) << finished.err;
  const Json answer = finished.json();
  EXPECT_EQ(answer.at("landmarks"), 9);
  EXPECT_EQ(answer.at("frames"), 8);
  EXPECT_GE(answer.at("triangles").get<int>(), 8);  // and slivers along the hull, whose points no longer lie in line
  EXPECT_EQ(answer.at("rejected").at("10"), 0);
  for (const char* key : {"mean_correlation", "tre_mm", "time_s"}) EXPECT_TRUE(answer.contains(key)) << key;
  EXPECT_TRUE(std::filesystem::exists(std::filesystem::path(out) / "quality.vtp"));
}

TEST(StudyExampleSequenceCommand, MakesASequenceThatSaysThatItIsSimulated) {
  const TemporaryFolder folder;
  const std::string out = (folder.path() / "example").string();
  const Finished made = glisson_cli({"study", "example-sequence", "--frames", "4", "--out", out, "--json", "--quiet"});
  ASSERT_EQ(made.exit_code, 0) << made.err;
  EXPECT_EQ(made.json().at("frames"), 4);
  const std::string quality = (folder.path() / "quality").string();
  const Finished judged = glisson_cli(
      {"sirgn", made.json().at("file").get<std::string>(), "--method", "given", "--out", quality, "--json", "--quiet"});
  ASSERT_EQ(judged.exit_code, 0) << judged.err;
  EXPECT_TRUE(judged.json().at("simulated").get<std::string>().starts_with("SIMULATED"));
  EXPECT_EQ(judged.json().at("frames"), 4);
}

// What `spoil` does to a sound sequence is refused; the answer's error.
template <typename Spoil>
Json refusal_of_spoiled(const Spoil& spoil) {
  const TemporaryFolder folder;
  write_sequence(folder.path(), 5);
  spoil(folder.path());
  const Finished finished = glisson_cli({"sirgn", (folder.path() / "sequence.json").string(), "--method", "given",
                                         "--out", (folder.path() / "quality").string(), "--json", "--quiet"});
  EXPECT_EQ(finished.exit_code, 1);
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "quality"));
  return finished.json().at("error");
}

TEST(SirgnCommand, RefusesTracksWhoseColumnsAreNamedOtherwise) {
  for (const char* text : {"landmark,frame,y_mm,x_mm,z_mm\ng0,0,1,2,3\n", "g0,0,1,2,3\n", ""}) {
    const Json error = refusal_of_spoiled(
        [&](const std::filesystem::path& folder) { ASSERT_TRUE(write_text_file(folder / "tracks.csv", text)); });
    EXPECT_EQ(error.at("code"), "tracks-invalid");
    EXPECT_EQ(error.at("message"), "The first line of tracks.csv is not landmark,frame,x_mm,y_mm,z_mm.");
  }
}

TEST(SirgnCommand, RefusesACameraThatLooksBackwards) {
  const Json error = refusal_of_spoiled([](const std::filesystem::path& folder) {
    Json document = read_json_file(folder / "sequence.json").value();
    document["camera"] = {{"matrix", {{-560, 0, 320}, {0, 560, 240}, {0, 0, 1}}}};
    ASSERT_TRUE(write_json_file(folder / "sequence.json", document));
  });
  EXPECT_EQ(error.at("code"), "sequence-invalid");
  EXPECT_NE(error.at("message").get<std::string>().find("positive focal lengths"), std::string::npos);
}

TEST(SirgnCommand, NamesTheFrameThatIsMissing) {
  const Json error =
      refusal_of_spoiled([](const std::filesystem::path& folder) { std::filesystem::remove(folder / "f3.ply"); });
  EXPECT_EQ(error.at("code"), "sequence-frame-missing");
}

}  // namespace
}  // namespace glisson::test
