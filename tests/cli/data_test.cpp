// Straight from measured strain and stress, through the program itself.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <algorithm>
#include <array>

#include "base/files.h"
#include "support/process.h"

namespace glisson::test {
namespace {

// A cube of 20 mm, as ParaView would save it as text: eight smaller cubes of six tetrahedra each.
std::string cube_vtu() {
  std::string points, cells, ends, types;
  for (int p = 0; p < 27; ++p) points += fmt::format("{} {} {} ", 10 * (p % 3), 10 * (p / 3 % 3), 10 * (p / 9));
  const std::array<int, 3> stride{1, 3, 9};
  int count = 0;
  for (int small = 0; small < 8; ++small) {
    std::array<int, 3> axes{0, 1, 2};
    do {
      std::array<int, 4> corners{(small & 1) + 3 * (small >> 1 & 1) + 9 * (small >> 2), 0, 0, 0};
      for (int k = 0; k < 3; ++k) corners[k + 1] = corners[k] + stride[axes[k]];
      const bool even = axes[0] == 0 ? axes[1] == 1 : axes[0] == 1 ? axes[1] == 2 : axes[1] == 0;
      if (!even) std::swap(corners[1], corners[2]);
      for (const int corner : corners) cells += fmt::format("{} ", corner);
      ends += fmt::format("{} ", 4 * ++count);
      types += "10 ";
    } while (std::next_permutation(axes.begin(), axes.end()));
  }
  return fmt::format(
      R"(<VTKFile type="UnstructuredGrid" version="0.1" byte_order="LittleEndian"><UnstructuredGrid>
<Piece NumberOfPoints="27" NumberOfCells="{}">
<Points><DataArray type="Float64" NumberOfComponents="3" format="ascii">{}</DataArray></Points>
<Cells><DataArray type="Int64" Name="connectivity" format="ascii">{}</DataArray>
<DataArray type="Int64" Name="offsets" format="ascii">{}</DataArray>
<DataArray type="UInt8" Name="types" format="ascii">{}</DataArray></Cells></Piece></UnstructuredGrid></VTKFile>)",
      count, points, cells, ends, types);
}

TEST(SimulateFromData, MeasuredPointsOnALineMoveTheBodyAsTheLineDoes) {
  const TemporaryFolder folder;
  const auto at = [&](const char* name) { return (folder.path() / name).string(); };
  const auto scenario = [](const std::string& modulus) {
    return R"({"engine": "fem", "material": "linear", "poisson_ratio": 0.45, )" + modulus + R"(
      "supports": [{"box": {"min_mm": [-1, -1, -1], "max_mm": [21, 21, 0.1]}}],
      "loads": [{"tool": {"center_mm": [10, 10, 20], "radius_mm": 15, "force_N": [0, 0, 0.02]}}],
      "landmarks": [{"id": "top", "position_mm": [10, 10, 20]}]})";
  };
  std::string measured = "strain,stress_kPa\n";  // Young's modulus 6 kPa
  for (int percent = -10; percent <= 10; ++percent) measured += fmt::format("{},{}\n", 0.01 * percent, 0.06 * percent);
  ASSERT_TRUE(write_text_file(at("cube.vtu"), cube_vtu()));
  ASSERT_TRUE(write_text_file(at("measured.csv"), measured));
  ASSERT_TRUE(write_text_file(at("by-data.json"), scenario("")));
  ASSERT_TRUE(write_text_file(at("by-law.json"), scenario("\"youngs_modulus_kPa\": 6,")));
  ASSERT_TRUE(write_text_file(at("nonsense.csv"), "strain,stress_kPa\n0.1,much\n"));

  const Finished by_data = glisson_cli({"simulate", "--mesh", at("cube.vtu"), "--scenario", at("by-data.json"),
                                        "--data", at("measured.csv"), "--out", at("data"), "--json", "--quiet"});
  const Finished by_law = glisson_cli(
      {"simulate", "--mesh", at("cube.vtu"), "--scenario", at("by-law.json"), "--out", at("law"), "--json", "--quiet"});
  ASSERT_EQ(by_data.exit_code, 0) << by_data.err;
  ASSERT_EQ(by_law.exit_code, 0) << by_law.err;
  EXPECT_TRUE(by_data.json().at("converged").get<bool>());
  const double moved_mm = by_law.json().at("landmarks")[0].at("displacement_mm").get<double>();
  EXPECT_GT(moved_mm, 0.05);
  EXPECT_NEAR(by_data.json().at("landmarks")[0].at("displacement_mm").get<double>(), moved_mm, 1e-6);
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "data" / "result.vtu"));

  const Finished refused = glisson_cli({"simulate", "--mesh", at("cube.vtu"), "--scenario", at("by-data.json"),
                                        "--data", at("nonsense.csv"), "--out", at("none"), "--quiet"});
  EXPECT_EQ(refused.exit_code, 1);
  for (const char* said : {"nonsense.csv", "line 2", "stress_kPa"}) EXPECT_THAT(refused.err, testing::HasSubstr(said));
  ASSERT_TRUE(write_text_file(at("few.csv"), "strain,stress_kPa\n0.1,0.6\n"));
  const Finished too_few = glisson_cli({"simulate", "--mesh", at("cube.vtu"), "--scenario", at("by-data.json"),
                                        "--data", at("few.csv"), "--out", at("none"), "--quiet"});
  EXPECT_EQ(too_few.exit_code, 1);
  for (const char* said : {"few.csv", "at least 3 measurements"}) EXPECT_THAT(too_few.err, testing::HasSubstr(said));
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "none"));
}

}  // namespace
}  // namespace glisson::test
