// Section 4.4 on real livers (livers_couinaud, read only), on some of those for tuning: their forks are landmarks,
// whose displacements are those of the mesh; what is done is not done again; a liver cut off is refused.

#include "studies/dissertation/real_livers.h"

#include <gmock/gmock.h>
#include <cmath>
#include <Eigen/LU>

#include "base/files.h"
#include "imaging/volume_file.h"
#include "studies/dissertation/landmarks.h"
#include "studies/dissertation/liver_retraction.h"
#include "support/data.h"

namespace glisson::studies {
namespace {

namespace fs = std::filesystem;
using Eigen::Vector3d;

constexpr const char* with_vessels = "3Dircadb-10";
constexpr const char* without_vessels = "LiTS-22";
constexpr const char* cut_off = "MSD-112";

fs::path livers() { return test::shared_data() / "livers_couinaud"; }

Subject subject_of(const std::string& id, unsigned seed = 1) {
  const std::vector<Subject> all = find_livers(livers(), seed).value();
  for (const Subject& subject : all) {
    if (subject.id == id) return subject;
  }
  ADD_FAILURE() << "no liver " << id;
  return {};
}

// A folder that holds these livers alone.
void link_livers(const fs::path& folder, const std::vector<std::string>& ids) {
  fs::create_directories(folder);
  for (const auto& entry : fs::directory_iterator(livers())) {
    const std::string name = entry.path().filename().string();
    for (const std::string& id : ids) {
      if (name.starts_with(id + "_")) fs::create_symlink(entry.path(), folder / name);
    }
  }
}

// By looking into every cell: the corners' displacements, as far as each is near. Nothing outside of all cells.
std::optional<Vector3d> slow_displacement_mm(const mechanics::Simulation& simulation, const Vector3d& at_mm) {
  const geometry::Field* field = geometry::find_field(simulation.mesh.point_fields, mechanics::displacement_field);
  const auto of_point = [&](int p) { return Vector3d(field->values.data() + 3 * static_cast<std::ptrdiff_t>(p)); };
  for (const auto& cell : simulation.mesh.cells) {
    Eigen::Matrix4d corners;
    for (int c = 0; c < 4; ++c) {
      corners.col(c) << simulation.mesh.points_mm[static_cast<std::size_t>(cell[static_cast<std::size_t>(c)])], 1;
    }
    const Eigen::Vector4d share = corners.inverse() * Eigen::Vector4d(at_mm.x(), at_mm.y(), at_mm.z(), 1);
    if (share.minCoeff() < -1e-9) continue;
    Vector3d displacement = Vector3d::Zero();
    for (int c = 0; c < 4; ++c) displacement += share[c] * of_point(cell[static_cast<std::size_t>(c)]);
    return displacement;
  }
  return std::nullopt;
}

TEST(RealLiversLandmarks, ForksAreTheLiversOwnAndItsStiffnessFollowsFromSeedAndName) {
  GLISSON_NEEDS_DATA("livers_couinaud");
  const Subject subject = subject_of(with_vessels);
  const auto liver = read_liver(subject);
  ASSERT_TRUE(liver) << liver.error().message();
  const imaging::LabelMap vessels = imaging::read_labels_file(subject.drawn->vessels).value();
  const imaging::LabelMap labels = imaging::read_labels_file(subject.path).value();
  ASSERT_GT(liver->landmarks.size(), 10u);
  ASSERT_EQ(liver->groups.size(), 5u);
  EXPECT_EQ(liver->groups[0].members.size(), liver->landmarks.size());
  EXPECT_EQ(liver->groups[1].members.size() + liver->groups[2].members.size(), liver->landmarks.size());
  EXPECT_EQ(liver->groups[3].members.size() + liver->groups[4].members.size(), liver->landmarks.size());
  for (const mechanics::Landmark& fork : liver->landmarks) {
    const Eigen::Vector3i at = vessels.grid.index_of(fork.position_mm).array().round().cast<int>();
    ASSERT_TRUE(vessels.grid.contains(at.x(), at.y(), at.z()));
    EXPECT_NE(vessels.at(at.x(), at.y(), at.z()), 0) << fork.id;
    EXPECT_NE(labels.at(at.x(), at.y(), at.z()), 0) << fork.id;
  }
  const auto voxels = static_cast<double>(std::count(liver->organ.values.begin(), liver->organ.values.end(), 1));
  EXPECT_NEAR(voxels * 27 / 1000, 1586, 40);  // ml, as index.csv has it

  EXPECT_EQ(read_liver(subject)->shear_kPa.values, liver->shear_kPa.values);
  EXPECT_NE(read_liver(subject_of(with_vessels, 2))->shear_kPa.values, liver->shear_kPa.values);
}

TEST(RealLiversLandmarks, AForkGoesWithTheCellThatItLiesIn) {
  GLISSON_NEEDS_DATA("livers_couinaud");
  const auto liver = read_liver(subject_of(with_vessels));
  ASSERT_TRUE(liver) << liver.error().message();
  RetractionOptions options;
  options.target_cells = 5000;
  const auto retraction = retract(*liver, options);
  ASSERT_TRUE(retraction) << retraction.error().message();
  double sum_mm = 0;
  std::size_t compared = 0;
  for (std::size_t n = 0; n < liver->landmarks.size(); ++n) {
    const Vector3d& at_mm = liver->landmarks[n].position_mm;
    const auto measured = slow_displacement_mm(retraction->measured, at_mm);
    const auto reference = slow_displacement_mm(retraction->reference, at_mm);
    if (!measured || !reference) continue;  // between the outline and the mesh
    ++compared;
    const double off_mm =
        std::abs((*measured - *reference).norm() - retraction->measured_against_reference.landmarks[n].difference_mm);
    sum_mm += off_mm;
    EXPECT_LT(off_mm, 0.5) << liver->landmarks[n].id;  // cells bend between their corners
  }
  EXPECT_GT(static_cast<double>(compared), 0.9 * static_cast<double>(liver->landmarks.size()));
  EXPECT_LT(sum_mm / static_cast<double>(compared), 0.05);
}

TEST(RealLiversLandmarks, RowsHoldForksWhereThereAreVesselsAndAreNotMadeTwice) {
  GLISSON_NEEDS_DATA("livers_couinaud");
  const TemporaryFolder folder;
  link_livers(folder.path() / "livers", {with_vessels, without_vessels, cut_off});
  LandmarksOptions options;
  options.livers_seed = 1;
  options.retraction.target_cells = 3000;
  options.retraction.law = RetractionLaw::by_strain;
  options.pictures = 1;
  const auto summary = run_landmarks(folder.path() / "livers", folder.path() / "out", options);
  ASSERT_TRUE(summary) << summary.error().message();
  ASSERT_EQ(summary->rows.size(), 3u);
  EXPECT_EQ(summary->patients, 2u);
  EXPECT_THAT(summary->rows[2].error, testing::HasSubstr("cuts the liver off"));
  const auto has = [&](std::size_t row, const char* column) {
    return !column_of({summary->rows[row]}, column).empty();
  };
  EXPECT_TRUE(has(0, "forks_max_mm"));
  EXPECT_TRUE(has(0, "by_supports_mm"));
  EXPECT_FALSE(has(1, "forks_max_mm"));
  EXPECT_TRUE(has(1, "atlas_near_tool_mm"));
  ASSERT_FALSE(summary->groups.empty());
  EXPECT_EQ(summary->groups[0].mm.voxels, 1u);  // patients who have it
  EXPECT_THAT(summary->groups[0].examples, testing::ElementsAre(with_vessels));

  // The median patient by forks, whose vessels are drawn.
  EXPECT_TRUE(fs::exists(folder.path() / "out" / "examples" / with_vessels / "atlas-and-mre.png"));

  // What linear elasticity strains by more than 20 % is answered by another law, or said not to be.
  for (const std::size_t row : {0, 1}) {
    const auto value = [&](const char* column) { return column_of({summary->rows[row]}, column).at(0); };
    EXPECT_EQ(value("linear_strain") > 0.2, value("at_large_strain") + value("beyond_linear") > 0);
    EXPECT_EQ(value("at_large_strain") > 0, value("linear_atlas_near_tool_mm") != value("atlas_near_tool_mm"));
  }

  // The table has all columns, and an empty cell where a liver lacks one.
  const std::string table = read_text_file(folder.path() / "out" / "landmarks.csv").value();
  EXPECT_THAT(table, testing::HasSubstr("near_tool_forks_count"));
  const auto again = run_landmarks(folder.path() / "livers", folder.path() / "out", options);
  ASSERT_TRUE(again);
  EXPECT_EQ(again->reused, 2u);
  options.pictures = 0;
  options.livers_seed = 2;
  options.part.patient = without_vessels;
  const auto other = run_landmarks(folder.path() / "livers", folder.path() / "out", options);
  ASSERT_TRUE(other);
  EXPECT_EQ(other->reused, 0u);  // another stiffness
}

TEST(RealLiversLandmarks, AFolderWithoutLiversIsRefused) {
  const TemporaryFolder folder;
  EXPECT_EQ(find_livers(folder.path(), 1).error().code, "shapes-no-livers");
}

}  // namespace
}  // namespace glisson::studies
