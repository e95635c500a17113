#include "vasculature/tree_file.h"

#include <gmock/gmock.h>
#include <fstream>

#include "base/files.h"
#include "base/json.h"

namespace glisson::vasculature {
namespace {

VesselTrees two_branches() {
  VesselTrees trees;
  trees.portal_entry_mm = {1, 2, 3};
  trees.hepatic_entry_mm = {4, 5, 6};
  TreeBranch stem;
  stem.name = "portal/stem";
  stem.confidence = 0.9;
  stem.points = {{{0, 0, 0}, 5}, {{10, 0, 0}, 4.5}};
  stem.length_mm = 10;
  stem.radius_mm = 4.5;
  TreeBranch right = stem;
  right.name = "portal/right";
  right.parent = 0;
  right.generation = 1;
  right.joint = Joint::gap;
  trees.branches = {stem, right};
  trees.clicks = {{Vessel::right_hepatic_vein, {7, 8, 9.5}}};
  trees.borders = {{{5, 8}, {1, 2.5, -3}}, {{1, 7}, {4, 5, 6}}};
  trees.border_doubts = {{Vessel::umbilical_portion, 41.5}, {Vessel::middle_hepatic_vein, 3}};
  return trees;
}

TEST(TreeFile, ComesBackAsItWasWritten) {
  const TemporaryFolder folder;
  ASSERT_TRUE(write_trees(folder.path() / "trees.json", two_branches()));
  const auto read = read_trees(folder.path() / "trees.json");
  ASSERT_TRUE(read) << read.error().message();
  EXPECT_EQ(trees_json(*read), trees_json(two_branches()));
}

// By themselves, so that a program that knows veins alone reads the rest.
TEST(TreeFile, ArteriesAndDuctsStandBesideTheBranchesOfVeins) {
  const TemporaryFolder folder;
  VesselTrees trees = two_branches();
  for (const System system : {System::artery, System::biliary_tract}) {
    TreeBranch branch = trees.branches.front();
    branch.system = system;
    branch.name = system_name(system);
    trees.branches.push_back(branch);
  }
  trees.branches.push_back(trees.branches[2]);
  trees.branches.back().parent = 2;
  ASSERT_TRUE(write_trees(folder.path() / "trees.json", trees));
  const auto read = read_trees(folder.path() / "trees.json");
  ASSERT_TRUE(read) << read.error().message();
  EXPECT_EQ(trees_json(*read), trees_json(trees));
  EXPECT_EQ(trees_json(trees).at("branches"), trees_json(two_branches()).at("branches"));
  EXPECT_EQ(trees_json(trees).at("arteries_and_ducts").at(2).at("parent"), 2);
  EXPECT_FALSE(trees_json(two_branches()).contains("arteries_and_ducts"));
}

TEST(TreeFile, WhatIsDamagedIsNamed) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "trees.json";
  for (const auto& [what, text] :
       {std::pair{"format", R"({"format": "another/1"})"},
        std::pair{"branches",
                  R"({"format": "glisson-vessel-trees/1", "portal_entry_mm": [0,0,0], "hepatic_entry_mm": [0,0,0]})"},
        std::pair{"branches[0]", R"({"format": "glisson-vessel-trees/1", "portal_entry_mm": [0,0,0],
          "hepatic_entry_mm": [0,0,0], "branches": [{"system": "portal-vein", "name": "a", "joint": "vessel",
          "parent": 5, "points": [[0,0,0,1],[1,0,0,1]]}]})"},
        std::pair{"branches[0]", R"({"format": "glisson-vessel-trees/1", "portal_entry_mm": [0,0,0],
          "hepatic_entry_mm": [0,0,0], "branches": [{"system": "portal-vein", "name": "a", "joint": "vessel",
          "parent": -1, "generation": 1e300, "points": [[0,0,0,1],[1,0,0,1]]}]})"},
        std::pair{"arteries_and_ducts[0]", R"({"format": "glisson-vessel-trees/1", "portal_entry_mm": [0,0,0],
          "hepatic_entry_mm": [0,0,0], "branches": [], "arteries_and_ducts": [{"system": "portal-vein", "name": "a",
          "joint": "vessel", "parent": -1, "points": [[0,0,0,1],[1,0,0,1]]}]})"},
        std::pair{"clicks", R"({"format": "glisson-vessel-trees/1", "portal_entry_mm": [0,0,0],
          "hepatic_entry_mm": [0,0,0], "branches": [], "clicks": [{"vessel": "aorta", "position_mm": [0,0,0]}]})"},
        std::pair{"borders", R"({"format": "glisson-vessel-trees/1", "portal_entry_mm": [0,0,0],
          "hepatic_entry_mm": [0,0,0], "branches": [], "borders": [{"border": "II-VII", "position_mm": [0,0,0]}]})"},
        std::pair{"border_doubts", R"({"format": "glisson-vessel-trees/1", "portal_entry_mm": [0,0,0],
          "hepatic_entry_mm": [0,0,0], "branches": [], "border_doubts": [{"vessel": "hepatic-vein"}]})"}}) {
    std::ofstream(file) << text;
    const auto read = read_trees(file);
    ASSERT_FALSE(read);
    EXPECT_EQ(read.error().code, "trees-unreadable");
    EXPECT_THAT(read.error().message(), testing::HasSubstr(what));
  }
}

}  // namespace
}  // namespace glisson::vasculature
