// The page of a patient says what the case holds and what it does not, and withholds the name unless it is given.

#include "report/patient_page.h"

#include <gmock/gmock.h>

#include "base/files.h"
#include "casefile/resection_folder.h"
#include "geometry/mesh_file.h"
#include "mechanics/scenario/scenario.h"
#include "report/html.h"
#include "support/shapes.h"

namespace glisson::report {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

class PatientPage : public testing::Test {
 protected:
  void SetUp() override { ASSERT_TRUE(casefile::Case::create(folder_)); }
  void add_model() {
    auto patient = casefile::Case::open(folder_).value();
    geometry::TetMesh mesh = glisson::test::box_of_tetrahedra({6, 4, 4}, {120, 80, 80});
    geometry::set_field(mesh.cell_fields,
                        {mechanics::youngs_modulus_field, 1, std::vector<double>(mesh.cells.size(), 6.0)});
    ASSERT_TRUE(patient.add("meshes/model", ".vtu", {"stiffness", {{"uniform_kPa", "6"}}, {}, {}, {}},
                            [&](const fs::path& file) { return geometry::write_tetrahedra(file, mesh); }));
    liver_ = std::move(mesh);
  }
  std::string html(const PatientPageContent& content = {}) {
    const auto page = patient_page(casefile::Case::open(folder_).value(), content);
    if (!page) return page.error().message();
    const fs::path file = temporary_.path() / "page.html";
    EXPECT_TRUE(write_html(file, *page));
    return read_text_file(file, 1 << 24).value();
  }

  TemporaryFolder temporary_;
  fs::path folder_ = temporary_.path() / "Doe_Jane.glisson";
  geometry::TetMesh liver_;
};

TEST_F(PatientPage, WithholdsTheNameUnlessItIsGiven) {
  EXPECT_THAT(html(), HasSubstr("name withheld"));
  EXPECT_THAT(html(), Not(HasSubstr("Doe")));
  PatientPageContent named;
  named.name = "Doe, Jane";
  EXPECT_THAT(html(named), HasSubstr("Doe, Jane"));
}

TEST_F(PatientPage, SaysWhatIsNotThereYet) {
  const std::string page = html();
  EXPECT_THAT(page, HasSubstr("There is no model yet."));
  EXPECT_THAT(page, HasSubstr("No resection was saved."));
  EXPECT_THAT(page, HasSubstr("None: the model is as declared."));
  EXPECT_THAT(page, HasSubstr("Not a medical device"));
}

TEST_F(PatientPage, TellsModelAndResectionWithTheirWarnings) {
  add_model();
  const casefile::PlannedCut cut{{}, {90.5, 0, 0}, {1, 0, 0}, {}};
  const std::vector<rehearsal::NamedStructure> tumour{
      {"tumour-1", rehearsal::StructureKind::tumour, glisson::test::sphere_surface(9, 2, {100, 40, 40})}};
  const auto plan = casefile::plan_resection(liver_, cut, tumour);
  ASSERT_TRUE(plan);
  ASSERT_TRUE(casefile::write_resection(folder_ / "results" / "resection", cut, *plan));
  const std::string page = html();
  EXPECT_THAT(page, HasSubstr("6.00 kPa on average"));
  EXPECT_THAT(page, HasSubstr("one value for all cells, 6 kPa"));
  EXPECT_THAT(page, Not(HasSubstr("768 ml")));  // the cells' volume: the liver's is its outline's
  EXPECT_THAT(page, HasSubstr("assumed: one value"));
  EXPECT_THAT(page, HasSubstr("removes 189 ml and leaves 579 ml"));  // 29.5 of 120 mm
  EXPECT_THAT(page, HasSubstr("R1 !"));
}

TEST_F(PatientPage, MarksLandmarksFromFiveMillimetresOn) {
  PatientPageContent content;
  content.retraction = RehearsedRetraction{
      {{"retractor", 2.0, 15}}, 13.2, {{"tumour-1", 4.9, 0.2}, {"portal-vein-1", 5.0, std::nullopt}}, {true, 0.1, 0}};
  const std::string page = html(content);
  EXPECT_THAT(page, HasSubstr("retractor with 2.0 N"));
  EXPECT_THAT(page, HasSubstr("Computed with small deformations (linear)."));
  EXPECT_THAT(page, Not(HasSubstr("come to rest")));
  EXPECT_THAT(page, HasSubstr("<td>4.9</td>"));
  EXPECT_THAT(page, HasSubstr("<td class=\"flag\">5.0 !</td>"));
}

TEST_F(PatientPage, SaysThatALiverAtLargeDeformationsHadNotComeToRest) {
  PatientPageContent content;
  content.retraction = RehearsedRetraction{{{"grasper", 2.0, 6}}, 13.2, {{"tumour-1", 4.9, 0.2}}, {true, 0.3, 0, 1e9}};
  content.retraction->large_deformations = true;
  content.retraction->error_bound_mm = 0.84;
  const std::string page = html(content);
  EXPECT_THAT(page, HasSubstr("Computed with large deformations (neo-Hookean)."));
  EXPECT_THAT(page, HasSubstr("landmarks are within 0.8 mm of it"));
}

TEST_F(PatientPage, PrintsNoFigureOfAnAnswerThatMayNotBeUsed) {
  PatientPageContent content;
  content.retraction = RehearsedRetraction{{{"grasper", 2.0, 6}}, 133.7, {{"tumour-1", 44.9, 8.1}}, {true, 2.1, 31}};
  const std::string page = html(content);
  EXPECT_THAT(page, HasSubstr("Grasper with 2.0 N"));
  EXPECT_THAT(page, HasSubstr("Not to be used: cells turned inside out: 31."));
  for (const char* figure : {"133.7", "44.9", "8.1"}) EXPECT_THAT(page, Not(HasSubstr(figure)));
  EXPECT_THAT(page, HasSubstr("<td>-</td>"));
  content.retraction->validity = {true, 0.42, 0};
  EXPECT_THAT(html(content), HasSubstr("Outside of the model: strains reach 42 %"));
  EXPECT_THAT(html(content), HasSubstr("44.9 !"));
}

TEST_F(PatientPage, BeginsWithTheAnswerAndEndsWithWhereItComesFrom) {
  add_model();
  PatientPageContent content;
  content.retraction =
      RehearsedRetraction{{{"grasper", 1.0, 6}}, 3, {{"portal-vein-1", 2.0, std::nullopt}}, {true, 0.1, 0}};
  const std::string page = html(content);
  std::size_t at = 0;
  for (const char* heading : {"Planned resection", "Rehearsed retraction", "Structures", "Images", "Model",
                              "Evidence accepted", "Where it comes from"}) {
    const std::size_t found = page.find("<h2>" + std::string(heading));
    ASSERT_NE(found, std::string::npos) << heading;
    EXPECT_GT(found, at) << heading;
    at = found;
  }
  EXPECT_THAT(page, HasSubstr("Portal vein 1"));
  for (const char* internal : {"portal-vein-1", "meshes/model", "What can be worn", "Atlas off"}) {
    EXPECT_THAT(page, Not(HasSubstr(internal)));
  }
}

TEST_F(PatientPage, FlagsAFileThatAnotherProgramChanged) {
  add_model();
  EXPECT_THAT(html(), Not(HasSubstr("another program")));
  const fs::path file = casefile::Case::open(folder_)->file_of("meshes/model").value();
  ASSERT_TRUE(geometry::write_tetrahedra(file, glisson::test::box_of_tetrahedra({2, 2, 2}, {10, 10, 10})));
  EXPECT_THAT(html(), HasSubstr("changed by another program"));
}

}  // namespace
}  // namespace glisson::report
