// On real livers (livers_couinaud, read only), six of those for tuning: they correspond, what is done is not done
// again, and bad headers are said.

#include <gmock/gmock.h>
#include <filesystem>

#include "base/files.h"
#include "geometry/mesh_file.h"
#include "imaging/volume_file.h"
#include "shapes/completion.h"
#include "shapes/correspondence.h"
#include "shapes/liver_outline.h"
#include "shapes/model_file.h"
#include "studies/dissertation/shapes_study.h"
#include "support/data.h"

namespace glisson::studies {
namespace {

namespace fs = std::filesystem;

fs::path livers() { return test::shared_data() / "livers_couinaud"; }

// Every liver's first label map whose number is even.
fs::path tuning_file(const std::string& id) {
  for (const ShapesLiver& liver : shapes_livers(livers())) {
    if (liver.id == id && liver.for_tuning) return liver.file;
  }
  return {};
}

double value_of(const BatchRow& row, const std::string& name) {
  for (const auto& [known, value] : row.values) {
    if (known == name) return value;
  }
  return -1;
}

}  // namespace

TEST(RealShapes, EveryOtherLiverIsForTuning) {
  GLISSON_NEEDS_DATA("livers_couinaud");
  const auto all = shapes_livers(livers());
  ASSERT_EQ(all.size(), 82u);
  EXPECT_EQ(all[0].id, "3Dircadb-10");
  EXPECT_TRUE(all[0].for_tuning);
  EXPECT_FALSE(all[1].for_tuning);
  EXPECT_TRUE(all[0].file.filename().string().ends_with("_couinaud.nii.gz"));
}

TEST(RealShapes, SixLiversMakeAModelAndAreNotDoneTwice) {
  GLISSON_NEEDS_DATA("livers_couinaud");
  const TemporaryFolder folder;
  fs::create_directories(folder.path() / "six");
  int linked = 0;
  for (const ShapesLiver& liver : shapes_livers(livers())) {
    if (!liver.for_tuning || linked == 6) continue;
    fs::create_symlink(liver.file, folder.path() / "six" / liver.file.filename());
    ++linked;
  }
  ShapesOptions options;
  options.judged = ShapesJudged::none;
  const auto study = run_shapes(folder.path() / "six", folder.path() / "out", options);
  ASSERT_TRUE(study) << study.error().message();
  EXPECT_EQ(study->used, 6u);
  for (const BatchRow& row : study->livers) {
    EXPECT_LT(value_of(row, "correspondence_mm"), 2) << row.id;
    EXPECT_GT(value_of(row, "mirrored_ratio"), 1) << row.id;
  }
  const auto model = shapes::read_model(folder.path() / "out" / "model.vtp");
  ASSERT_TRUE(model) << model.error().message();
  EXPECT_EQ(model->livers, 6);
  EXPECT_TRUE(is_watertight(model->mean));
  const double mean_ml = geometry::volume_mm3(model->mean) / 1000;
  EXPECT_GT(mean_ml, 1000);
  EXPECT_LT(mean_ml, 2500);

  // As after a kill: a row without its surface is made again, the others are taken as they are.
  const std::string first = study->livers.front().id;
  const auto before = sha256_of_file(folder.path() / "out" / "model.vtp").value();
  fs::remove(folder.path() / "out" / "livers" / (first + ".vtp"));
  const auto again = run_shapes(folder.path() / "six", folder.path() / "out", options);
  ASSERT_TRUE(again) << again.error().message();
  for (const BatchRow& row : again->livers) EXPECT_EQ(row.reused, row.id != first) << row.id;
  EXPECT_EQ(sha256_of_file(folder.path() / "out" / "model.vtp").value(), before);
}

TEST(RealShapes, BadHeadersOfARealLiverAreSaid) {
  GLISSON_NEEDS_DATA("livers_couinaud");
  const fs::path file = tuning_file("LiTS-56");
  ASSERT_FALSE(file.empty());
  const imaging::LabelMap labels = imaging::read_labels_file(file).value();
  const auto reference = shapes::reference_liver().value();

  imaging::LabelMap unit = labels;
  unit.grid.spacing_mm.setOnes();
  EXPECT_EQ(shapes::outline_of(unit).error().code, "shapes-unit-spacing");

  imaging::LabelMap mirrored = labels;
  mirrored.grid.direction.col(0) *= -1;
  const auto outline = shapes::outline_of(mirrored).value();
  const auto refused = shapes::correspond(reference, outline.surface, outline.coarse);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, "shapes-mirrored");

  // A band without labels parts it in two.
  imaging::LabelMap parted = labels;
  const int middle = parted.grid.size[0] / 2;
  for (int k = 0; k < parted.grid.size[2]; ++k) {
    for (int j = 0; j < parted.grid.size[1]; ++j) {
      for (int i = middle - 4; i < middle + 4; ++i) parted.at(i, j, k) = 0;
    }
  }
  EXPECT_EQ(shapes::outline_of(parted).error().code, "shapes-in-pieces");
}

}  // namespace glisson::studies
