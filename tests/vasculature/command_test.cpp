// From masks to trees and segments through the program itself, on a generated patient.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <set>

#include "base/files.h"
#include "base/json.h"
#include "base/write_file.h"
#include "imaging/dicom_seg.h"
#include "imaging/label_names.h"
#include "imaging/volume_file.h"
#include "support/process.h"
#include "vasculature/couinaud.h"

namespace glisson::test {
namespace {

class GeneratedCase : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new TemporaryFolder;
    answer({"study", "anatomy", "--seed", "31", "--label-spacing-mm", "1.5", "--out", file("anatomy")});
    const auto liver = imaging::read_mask_file(label("liver"));
    ASSERT_TRUE(liver);
    imaging::Volume scan;
    scan.grid = liver->mask.grid;
    for (const std::uint8_t inside : liver->mask.values) scan.values.push_back(inside != 0 ? 110.0F : 20.0F);
    ASSERT_TRUE(imaging::write_volume_file(file("scan.nrrd"), scan));
    answer({"import", file("scan.nrrd"), "--case", patient()});
    answer({"segment", patient(), "--structure", "liver", "--labels", label("liver")});
  }
  static void TearDownTestSuite() { delete folder_; }

  static Json answer(std::vector<std::string> arguments) {
    arguments.insert(arguments.end(), {"--json", "--quiet"});
    const Finished finished = glisson_cli(arguments);
    EXPECT_EQ(finished.exit_code, 0) << arguments.front() << ": " << finished.err;
    return finished.json();
  }
  static std::string file(const std::string& name) { return (folder_->path() / name).string(); }
  static std::string label(const std::string& name) { return file("anatomy/labels/" + name + ".nrrd"); }
  static std::string patient() { return file("generated.glisson"); }

  // The first branch of these trees, of the other system than was found.
  static void tell_by_click(const Json& found) {
    const Finished unknown = glisson_cli({"vessels", patient(), "--click", "aorta=1,2,3", "--json", "--quiet"});
    EXPECT_EQ(unknown.exit_code, 1);
    EXPECT_EQ(unknown.json().at("error").at("code"), "click-invalid");
    const Finished beside =
        glisson_cli({"vessels", patient(), "--click", "right-hepatic-vein=999,0,0", "--json", "--quiet"});
    EXPECT_EQ(beside.exit_code, 1);
    EXPECT_EQ(beside.json().at("error").at("code"), "click-beside");
    const bool portal = found.at("branches").at(0).at("system") == "portal-vein";
    const Json before = read_json_file(found.at("file").get<std::string>()).value();
    const Json& place = before.at("branches").at(0).at("points").at(1);
    const Json told =
        answer({"vessels", patient(), "--structure", "vessels", "--click",
                fmt::format("{}={},{},{}", portal ? "right-hepatic-vein" : "umbilical-portion",
                            place.at(0).get<double>(), place.at(1).get<double>(), place.at(2).get<double>())});
    const Json after = read_json_file(told.at("file").get<std::string>()).value();
    EXPECT_EQ(after.at("clicks").size(), 1u);
    EXPECT_NE(after.at("branches"), before.at("branches"));
  }

  // A place 6 mm to the right of where the border of IV and VIII runs, of which vessels and territories are told.
  static void tell_a_border() {
    for (const auto& [border, place, code] :
         {std::tuple{"II-VII", "1,2,3", "border-invalid"}, std::tuple{"V-VIII", "1,2", "border-invalid"},
          std::tuple{"V-VIII", "999,0,0", "border-outside"}}) {
      const Finished refused = glisson_cli({"territories", patient(), "--from", "prior", "--border",
                                            fmt::format("{}={}", border, place), "--json", "--quiet"});
      EXPECT_EQ(refused.exit_code, 1);
      EXPECT_EQ(refused.json().at("error").at("code"), code);
    }
    const auto map = [](const Json& found) {
      return imaging::read_labels_file(found.at("file").get<std::string>()).value();
    };
    const auto drawn = vasculature::drawn_borders(map(answer({"territories", patient(), "--from", "prior"})));
    const auto& places_mm = drawn.at({4, 8});
    const Eigen::Vector3d place_mm = places_mm[places_mm.size() / 2] - Eigen::Vector3d(6, 0, 0);
    const std::string told = vasculature::border_text({{4, 8}, place_mm});
    const auto passes = [&](const imaging::LabelMap& segments) {
      const Eigen::Vector3d index = segments.grid.index_of(place_mm).array().floor();
      std::set<int> around;
      for (int corner = 0; corner < 8; ++corner) {
        around.insert(segments.at(static_cast<int>(index.x()) + (corner & 1),
                                  static_cast<int>(index.y()) + (corner >> 1 & 1),
                                  static_cast<int>(index.z()) + (corner >> 2)));
      }
      return around.contains(4) && around.contains(8);
    };
    EXPECT_TRUE(passes(map(answer({"territories", patient(), "--from", "prior", "--border", told}))));
    EXPECT_EQ(glisson_cli({"territories", patient(), "--border", told}).exit_code, 2) << "trees are told by vessels";
    const Json trees = answer({"vessels", patient(), "--structure", "vessels", "--border", told});
    EXPECT_EQ(read_json_file(trees.at("file").get<std::string>()).value().at("borders").size(), 1u);
    EXPECT_TRUE(passes(map(answer({"territories", patient()}))));
    EXPECT_FALSE(passes(map(answer({"territories", patient(), "--from", "prior"}))));
  }

  // The arteries get a tree beside `veins`, which stays as it was, and are told where a plan cuts them.
  static void outline_arteries(const Json& veins, const std::string& plane) {
    answer({"segment", patient(), "--structure", "artery", "--labels", label("artery")});
    const Json before = answer({"resect", patient(), plane, "--out", file("cut")}).at("living_remnant");
    answer({"segment", patient(), "--structure", "biliary-tract", "--labels", label("artery")});
    const Finished same = glisson_cli({"vessels", patient(), "--json", "--quiet"});
    EXPECT_EQ(same.exit_code, 1);
    EXPECT_EQ(same.json().at("error").at("code"), "vessels-overlap");
    EXPECT_THAT(same.json().at("error").at("message").get<std::string>(),
                testing::HasSubstr("artery and biliary-tract hold the same vessels"));
    answer({"segment", patient(), "--structure", "biliary-tract", "--subtract", "artery"});  // none of it is left
    const Finished text = glisson_cli({"resect", patient(), plane, "--out", file("cut"), "--quiet"});
    EXPECT_THAT(text.out, testing::HasSubstr("made before there was artery"));

    const Json with = answer({"vessels", patient()});
    Json of_veins = Json::array(), of_arteries = Json::array();
    for (const Json& branch : with.at("branches")) {
      (branch.at("system") == "artery" ? of_arteries : of_veins).push_back(branch);
    }
    EXPECT_EQ(of_veins, veins.at("branches"));
    EXPECT_GT(of_arteries.size(), 5u);
    for (const Json& branch : of_arteries) {
      EXPECT_THAT(branch.at("name").get<std::string>(), testing::StartsWith("hepatic-artery/"));
    }
    const Json kept = read_json_file(with.at("file").get<std::string>()).value();
    EXPECT_EQ(kept.at("branches").size(), of_veins.size()) << "as earlier versions read them";
    EXPECT_EQ(kept.at("arteries_and_ducts").size(), of_arteries.size());
    EXPECT_EQ(answer({"territories", patient()}).at("territories").size(), of_veins.size());

    const Json after = answer({"resect", patient(), plane, "--out", file("cut")}).at("living_remnant");
    for (const char* key : {"removed_ml", "living_ml", "ischaemic_ml", "congested_ml"}) {
      EXPECT_EQ(after.at(key), before.at(key)) << key;
    }
    const Json cut = after.at("branches").back();
    EXPECT_EQ(cut.at("system"), "artery");
    EXPECT_EQ(cut.at("beyond_ml"), 0.0);
    EXPECT_GT(after.at("branches").size(), before.at("branches").size());
  }

  static TemporaryFolder* folder_;
};
TemporaryFolder* GeneratedCase::folder_ = nullptr;

TEST_F(GeneratedCase, GoesFromVesselsToTreesToSegments) {
  const Finished early = glisson_cli({"territories", patient(), "--json", "--quiet"});
  EXPECT_EQ(early.exit_code, 1);
  EXPECT_EQ(early.json().at("error").at("code"), "vessels-missing");
  const Json prior = answer({"territories", patient(), "--from", "prior", "--couinaud"});
  EXPECT_EQ(prior.at("from"), "prior");
  EXPECT_EQ(prior.at("segments").size(), 8u);

  answer({"segment", patient(), "--structure", "portal-vein", "--labels", label("portal-vein")});
  answer({"segment", patient(), "--structure", "hepatic-vein", "--labels", label("portal-vein")});
  const Finished same = glisson_cli({"vessels", patient(), "--json", "--quiet"});
  EXPECT_EQ(same.exit_code, 1);
  EXPECT_EQ(same.json().at("error").at("code"), "vessels-overlap");
  answer({"segment", patient(), "--structure", "hepatic-vein", "--labels", label("hepatic-vein")});
  answer({"segment", patient(), "--structure", "vessels", "--unite", "portal-vein"});
  answer({"segment", patient(), "--structure", "vessels", "--unite", "hepatic-vein"});
  const Json together = answer({"vessels", patient(), "--structure", "vessels"});
  EXPECT_GT(together.at("branches").size(), 50u);
  EXPECT_EQ(together.at("border_doubts").size(), 4u);
  tell_by_click(together);
  tell_a_border();
  const Json apart = answer({"vessels", patient()});
  EXPECT_GT(apart.at("branches").size(), 50u);
  for (const Json& branch : apart.at("branches")) EXPECT_EQ(branch.at("confidence"), 1.0);

  const Json found = answer({"territories", patient()});
  EXPECT_EQ(found.at("from"), "tree");
  EXPECT_EQ(found.at("territories").size(), apart.at("branches").size());
  double portal_ml = 0, all_ml = 0;
  for (const Json& territory : found.at("territories")) {
    if (territory.at("system") == "portal-vein") portal_ml += territory.at("volume_ml").get<double>();
  }
  for (const Json& segment : found.at("segments")) all_ml += segment.at("volume_ml").get<double>();
  EXPECT_NEAR(portal_ml, all_ml, 0.01 * all_ml);
  const auto map = imaging::read_labels_file(found.at("file").get<std::string>());
  ASSERT_TRUE(map) << map.error().message();
  EXPECT_EQ(*std::max_element(map->values.begin(), map->values.end()), 8);
  const imaging::LabelNames names = imaging::label_names(found.at("file").get<std::string>());
  EXPECT_EQ(names.by, imaging::NamedBy::slicer_fields);
  EXPECT_EQ(names.name_of.at(8), "segment VIII");
  // Through the middle of the liver: some of what is left hangs on branches that were cut, and that is said.
  answer({"mesh", patient(), "--target-cells", "3000"});
  answer({"stiffness", patient(), "--uniform-kPa", "6"});
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  double voxels = 0;
  for (int k = 0; k < map->grid.size[2]; ++k) {
    for (int j = 0; j < map->grid.size[1]; ++j) {
      for (int i = 0; i < map->grid.size[0]; ++i) {
        if (map->at(i, j, k) == 0) continue;
        middle += map->grid.position_mm(i, j, k);
        ++voxels;
      }
    }
  }
  middle /= voxels;
  const std::string plane = fmt::format("--plane={:.1f},{:.1f},{:.1f},1,0,0", middle.x(), middle.y(), middle.z());
  const Json living = answer({"resect", patient(), plane, "--out", file("cut")}).at("living_remnant");
  const auto ml = [&](const char* key) { return living.at(key).get<double>(); };
  EXPECT_NEAR(ml("removed_ml") + ml("remnant_ml"), all_ml, 0.01 * all_ml);
  EXPECT_NEAR(ml("perfused_ml") + ml("ischaemic_ml"), ml("remnant_ml"), 1e-6);
  EXPECT_NEAR(ml("drained_ml") + ml("congested_ml"), ml("remnant_ml"), 1e-6);
  EXPECT_GT(ml("ischaemic_ml"), 0);
  EXPECT_LT(ml("living_ml"), ml("remnant_ml"));
  EXPECT_FALSE(living.at("branches").empty());

  // Both are kept: asked again, nothing is made anew.
  const auto made_when = [] {
    const auto document = read_json_file(file("generated.glisson/case.json"));
    std::map<std::string, std::string> when;
    for (const Json& entry : document->at("entries")) {
      when[entry.at("id").get<std::string>()] = entry.at("made").at("when").get<std::string>();
    }
    return when;
  };
  const auto before = made_when();
  EXPECT_TRUE(before.contains("territories/portal-vein") && before.contains("territories/hepatic-vein"));
  EXPECT_EQ(answer({"vessels", patient()}).at("branches").size(), apart.at("branches").size());
  const Json again = answer({"territories", patient()});
  EXPECT_EQ(made_when(), before);
  for (std::size_t s = 0; s < 8; ++s) {
    EXPECT_DOUBLE_EQ(again.at("segments")[s].at("volume_ml"), found.at("segments")[s].at("volume_ml"));
    EXPECT_NEAR(again.at("segments")[s].at("confidence"), found.at("segments")[s].at("confidence"), 1e-9);
  }

  const auto plan = [&](const std::string& text) {
    EXPECT_TRUE(write_file(file("plan.json"), text));
    return file("plan.json");
  };
  const auto refused = [&](const std::string& text) {
    const Finished finished = glisson_cli({"plan", patient(), "--add", plan(text), "--json", "--quiet"});
    EXPECT_EQ(finished.exit_code, 1);
    return finished.json().at("error").at("code").get<std::string>();
  };
  EXPECT_EQ(refused(R"({"name": "x", "segments": [9]})"), "plan-invalid");
  EXPECT_EQ(refused(R"({"name": "x", "around": "tumour-77", "margin_mm": 5})"), "tumour-unknown");
  EXPECT_EQ(refused(R"({"name": "x", "territory": "portal/nowhere"})"), "branch-unknown");
  EXPECT_EQ(refused(R"({"name": "x", "plane": {"point_mm": [0, 0, 9000], "normal": [0, 0, 1]}})"), "cut-misses");
  EXPECT_EQ(answer({"plan", patient(), "--list"}).at("plans").size(), 0u);
  EXPECT_EQ(glisson_cli({"plan", patient(), "--compare", "--json", "--quiet"}).exit_code, 1);

  const Json right = answer({"plan", patient(), "--add", plan(R"({"name": "V to VIII", "segments": [5, 6, 7, 8]})")})
                         .at("plans")
                         .front();
  double right_ml = 0;
  for (std::size_t s = 4; s < 8; ++s) right_ml += found.at("segments")[s].at("volume_ml").get<double>();
  EXPECT_NEAR(right.at("removed_ml"), right_ml, 0.01 * all_ml);
  EXPECT_NEAR(right.at("removed_ml").get<double>() + right.at("remnant_ml").get<double>(), all_ml, 0.01 * all_ml);
  EXPECT_GT(right.at("branches").size(), 0u);
  const Json by_branch =
      answer({"plan", patient(), "--add", plan(R"({"name": "Right portal vein", "territory": "portal/right"})")})
          .at("plans")
          .front();
  EXPECT_NEAR(by_branch.at("ischaemic_ml"), 0, 0.02 * all_ml);  // it takes all that it would starve
  answer({"plan", patient(), "--add", plan(R"({"name": "V to VIII", "segments": [5, 6, 7, 8]})")});  // in its place
  const Json list = answer({"plan", patient(), "--list"});
  ASSERT_EQ(list.at("plans").size(), 2u);
  for (const Json& kept : list.at("plans")) EXPECT_TRUE(kept.at("current").get<bool>());
  const Json compared = answer({"plan", patient(), "--compare", "--out", file("compared")});
  EXPECT_NEAR(compared.at("plans")[0].at("ischaemic_ml"), list.at("plans")[0].at("ischaemic_ml"), 1e-9);
  const Json by_living = answer({"plan", patient(), "--compare", "--rank-by", "living"}).at("plans");
  EXPECT_GE(by_living[0].at("living_ml").get<double>(), by_living[1].at("living_ml").get<double>());
  EXPECT_TRUE(by_living[0].at("beaten_by").empty());
  EXPECT_EQ(glisson_cli({"plan", patient(), "--list", "--rank-by", "living"}).exit_code, 2);
  const Json of_body = answer({"plan", patient(), "--compare", "--body-weight-kg", "80"}).at("plans")[0];
  EXPECT_NEAR(of_body.at("living_percent_of_body_weight"), of_body.at("living_ml").get<double>() / 800, 1e-9);
  EXPECT_EQ(glisson_cli({"plan", patient(), "--compare", "--body-weight-kg", "0"}).exit_code, 2);
  const Json after = answer({"plan", patient(), "--compare", "--embolise", "portal/right", "--growth-percent", "40"})
                         .at("plans")[0]
                         .at("after_embolisation");
  EXPECT_GT(after.at("embolised_ml"), 100.0);
  EXPECT_NEAR(after.at("grown_ml"), 1.4 * after.at("grows_ml").get<double>(), 1e-6);
  EXPECT_EQ(glisson_cli({"plan", patient(), "--list", "--embolise", "portal/right"}).exit_code, 2);
  EXPECT_THAT(answer({"plan", patient(), "--compare", "--embolise", "hepatic"}).at("plans")[0].at("remarks").dump(),
              testing::HasSubstr("no branch of the portal vein"));
  const auto csv = read_text_file(file("compared/plans.csv"));
  ASSERT_TRUE(csv);
  EXPECT_EQ(std::count(csv->begin(), csv->end(), '\n'), 3);  // a head and two plans
  const auto page = read_text_file(file("compared/plans.html"));
  ASSERT_TRUE(page);
  EXPECT_THAT(*page, testing::HasSubstr("Right portal vein"));
  EXPECT_EQ(page->find("unrolled flat"), std::string::npos) << "cuts along the anatomy have no surface";
  answer({"plan", patient(), "--add",
          plan(fmt::format(R"({{"name": "Plane", "plane": {{"point_mm": [{}, {}, {}], "normal": [1, 0.2, 0]}}}})",
                           middle.x(), middle.y(), middle.z()))});
  answer({"plan", patient(), "--compare", "--out", file("with-plane")});
  const auto unrolled = read_text_file(file("with-plane/plans.html"));
  ASSERT_TRUE(unrolled);
  EXPECT_THAT(*unrolled, testing::HasSubstr("Plane: the cut unrolled flat"));
  EXPECT_GT(std::count(unrolled->begin(), unrolled->end(), '<'), 200);
  answer({"plan", patient(), "--drop", "Plane"});
  // As other programs read it: the eight segments, and what the plan leaves and takes, voxel for voxel.
  const auto volumes = [&](const std::string& out) {
    std::map<std::string, double> by_name_ml;
    const auto segments = imaging::read_dicom_seg(file(out));
    EXPECT_TRUE(segments.has_value());
    for (const imaging::SegmentedMask& one : segments.value_or(std::vector<imaging::SegmentedMask>{})) {
      by_name_ml[one.info.name] = static_cast<double>(std::count(one.mask.values.begin(), one.mask.values.end(), 1)) *
                                  one.mask.grid.voxel_volume_mm3() / 1000;
    }
    return by_name_ml;
  };
  answer({"export", patient(), "--format", "dicom-seg", "--plan", "V to VIII", "--out", file("plan.dcm")});
  const auto exported_ml = volumes("plan.dcm");
  for (std::size_t s = 0; s < 8; ++s) {
    const std::string name = "segment " + std::string(vasculature::segment_name(s + 1));
    ASSERT_TRUE(exported_ml.contains(name)) << name;
    EXPECT_NEAR(exported_ml.at(name), found.at("segments")[s].at("volume_ml").get<double>(), 1e-6 * all_ml) << name;
  }
  EXPECT_NEAR(exported_ml.at("specimen"), right.at("removed_ml").get<double>(), 1e-6 * all_ml);
  EXPECT_NEAR(exported_ml.at("remnant"), right.at("remnant_ml").get<double>(), 1e-6 * all_ml);
  answer({"export", patient(), "--format", "dicom-seg", "--out", file("no-plan.dcm")});
  EXPECT_EQ(volumes("no-plan.dcm").size() + 2, exported_ml.size());
  EXPECT_EQ(glisson_cli({"export", patient(), "--format", "dicom-seg", "--plan", "none such", "--out", file("no.dcm")})
                .exit_code,
            1);
  EXPECT_FALSE(std::filesystem::exists(file("no.dcm")));
  answer({"export", patient(), "--format", "nrrd", "--out", file("nrrd")});
  EXPECT_EQ(imaging::read_labels_file(file("nrrd/couinaud.nrrd")).value().values,
            imaging::read_labels_file(file("generated.glisson/territories/couinaud.nrrd")).value().values);

  outline_arteries(apart, plane);

  // A structure that changes makes plans stale, and so it is told.
  answer({"segment", patient(), "--structure", "liver", "--unite", "portal-vein"});
  answer({"segment", patient(), "--structure", "liver", "--subtract", "hepatic-vein"});
  for (const Json& kept : answer({"plan", patient(), "--list"}).at("plans")) {
    EXPECT_FALSE(kept.at("current").get<bool>());
  }
  answer({"plan", patient(), "--drop", "V to VIII"});
  EXPECT_EQ(answer({"plan", patient(), "--list"}).at("plans").size(), 1u);
  EXPECT_EQ(glisson_cli({"plan", patient()}).exit_code, 2);

  EXPECT_EQ(glisson_cli({"vessels", patient(), "--seed", "1,2,3", "--seed", "1,2,3", "--seed", "1,2,3"}).exit_code, 2);
}

}  // namespace
}  // namespace glisson::test
