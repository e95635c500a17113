// Trees of arteries and bile ducts beside those of veins: of a patient's outlines from the aorta and the lower bile
// duct on, and of a generated patient whose arteries are known.

#include <gtest/gtest.h>
#include <algorithm>
#include <numeric>

#include "anatomy/patient.h"
#include "anatomy/write_patient.h"
#include "base/json.h"
#include "vasculature/tree_file.h"
#include "vasculature/ucl_patient.h"

namespace glisson::vasculature {
namespace {

using Eigen::Vector3d;

std::vector<const TreeBranch*> of_system(const VesselTrees& trees, System system) {
  std::vector<const TreeBranch*> branches;
  for (const TreeBranch& branch : trees.branches) {
    if (branch.system == system) branches.push_back(&branch);
  }
  return branches;
}

// The aorta, the coeliac trunk, the splenic artery and the arteries of the liver up to its hilum; the bile duct from
// its lower end to the hilum. Each as one tree from where blood comes in, and where bile goes out.
TEST(ArteriesAndDucts, APatientsGrowFromOutsideOfTheLiver) {
  GLISSON_NEEDS_DATA("liver_patient_models_ucl");
  const test::UclPatient patient = test::ucl_patient();
  EXPECT_EQ(trees_json(patient.all).at("branches"), trees_json(patient.veins).at("branches")) << "veins stay";

  const auto arteries = of_system(patient.all, System::artery), ducts = of_system(patient.all, System::biliary_tract);
  ASSERT_GT(arteries.size(), 15u);
  ASSERT_GE(ducts.size(), 1u);
  for (const auto* tree : {&arteries, &ducts}) {
    EXPECT_EQ(std::count_if(tree->begin(), tree->end(), [](const TreeBranch* branch) { return branch->parent < 0; }),
              1);
    for (const TreeBranch* branch : *tree) {
      EXPECT_EQ(branch->confidence, 1);
      if (branch->parent < 0) continue;
      const TreeBranch& parent = patient.all.branches[static_cast<std::size_t>(branch->parent)];
      EXPECT_EQ(parent.system, branch->system);
      EXPECT_LT(from_wall_mm(parent.points, branch->points.front().position_mm), 3) << branch->name;
      EXPECT_LE(parent.generation, branch->generation);
    }
  }
  EXPECT_EQ(arteries.front()->name, "hepatic-artery/stem");
  EXPECT_GT(arteries.front()->radius_mm, 8) << "the aorta";
  const double lowest = ducts.front()->points.front().position_mm.z();
  for (const TreeBranch* duct : ducts) {
    for (const CenterPoint& point : duct->points) EXPECT_GE(point.position_mm.z(), lowest - 3);
  }

  // Right and left hepatic artery, by the portal branches beside them.
  const auto named = [&](const std::string& name) {
    const auto found =
        std::find_if(arteries.begin(), arteries.end(), [&](const TreeBranch* branch) { return branch->name == name; });
    return found == arteries.end() ? nullptr : *found;
  };
  const TreeBranch* right = named("hepatic-artery/right");
  ASSERT_NE(right, nullptr);
  EXPECT_NEAR(2 * right->radius_mm, 3.7, 1);
  EXPECT_TRUE(std::any_of(arteries.begin(), arteries.end(),
                          [](const TreeBranch* branch) { return branch->name.starts_with("hepatic-artery/left"); }));
  for (const TreeBranch* branch : arteries) {
    if (branch->name.starts_with("hepatic-artery/left")) {
      EXPECT_GT(branch->points.front().position_mm.x(), right->points.back().position_mm.x()) << branch->name;
    }
  }
}

// Of the generated patient's arteries from 2 mm on, which run in the sheaths of portal branches.
TEST(ArteriesAndDucts, GeneratedOnesAreFoundAndNamedAsThePortalBranchesBesideThem) {
  anatomy::PatientOptions options;
  options.seed = 12;
  const anatomy::Patient patient = anatomy::make_patient(options).value();
  const geometry::Box box = geometry::bounding_box(patient.liver->surface.points_mm);
  const imaging::Grid grid =
      anatomy::grid_over({box.min_mm - Vector3d::Constant(25), box.max_mm + Vector3d::Constant(3)}, 0.8);
  const imaging::Mask liver = segmentation::rasterise(patient.liver->surface, grid);
  const auto lines = [&](const anatomy::VesselTree& tree) {
    const anatomy::Field field = anatomy::tree_field(tree, grid, 0.8);
    imaging::Mask mask{grid, std::vector<std::uint8_t>(grid.voxels(), 0)};
    for (std::size_t v = 0; v < mask.values.size(); ++v) mask.values[v] = field.values[v] < 0 ? 1 : 0;
    return center_lines(mask).value();
  };
  const VesselGraph portal = lines(patient.portal_vein), hepatic = lines(patient.hepatic_vein);
  const VesselEntries expected = expected_entries(liver).value();
  VesselEntries entries = possible_entries(portal, expected, {}, 1).front();
  entries.hepatic_mm = possible_entries(hepatic, expected, {}, 1).front().hepatic_mm;
  VesselTrees trees = known_vessels(portal, hepatic, entries);
  const CouinaudSegments segments = couinaud_segments(liver, &trees).value();
  add_known_vessels(lines(patient.artery), System::artery, liver, trees);
  name_branches(trees, segments);
  const auto arteries = of_system(trees, System::artery);
  const auto portals = of_system(trees, System::portal_vein);

  double all = 0, found = 0;
  std::vector<double> errors_mm;
  for (const anatomy::VesselNode& node : patient.artery.nodes) {
    if (node.parent < 0 || node.radius_mm < 1) continue;
    const Vector3d from = patient.artery.nodes[static_cast<std::size_t>(node.parent)].position_mm;
    const double length = (node.position_mm - from).norm();
    const CenterPoint* nearest = nullptr;
    double nearest_mm = 1e9;
    for (const TreeBranch* branch : arteries) {
      for (const CenterPoint& point : branch->points) {
        const double away = (point.position_mm - node.position_mm).norm();
        if (away < nearest_mm) nearest_mm = away, nearest = &point;
      }
    }
    all += length;
    if (nearest_mm > 1.5) continue;
    found += length;
    errors_mm.push_back(std::abs(nearest->radius_mm - node.radius_mm));
  }
  EXPECT_GT(found, 0.95 * all);
  std::nth_element(errors_mm.begin(), errors_mm.begin() + static_cast<std::ptrdiff_t>(errors_mm.size() / 2),
                   errors_mm.end());
  EXPECT_LT(errors_mm[errors_mm.size() / 2], 0.3);

  const auto side = [](const std::string& name) {
    return name.find("/right") != std::string::npos ? 1 : name.find("/left") != std::string::npos ? -1 : 0;
  };
  double told = 0, agree = 0;
  for (const TreeBranch* artery : arteries) {
    for (const CenterPoint& point : artery->points) {
      const TreeBranch* beside = *std::min_element(portals.begin(), portals.end(), [&](const auto* a, const auto* b) {
        return from_wall_mm(a->points, point.position_mm) < from_wall_mm(b->points, point.position_mm);
      });
      if (side(artery->name) == 0 || side(beside->name) == 0) continue;
      ++told;
      agree += side(artery->name) == side(beside->name) ? 1 : 0;
    }
  }
  EXPECT_GT(told, 300);
  EXPECT_GT(agree, 0.95 * told);
}

// Nothing to grow from outside: from near where the portal vein enters.
TEST(ArteriesAndDucts, APieceInsideOfTheLiverGrowsFromItsHilum) {
  imaging::Mask liver;
  liver.grid.size = {60, 60, 60};
  liver.values.assign(liver.grid.voxels(), 1);
  VesselGraph graph;
  graph.vertices_mm = {{50, 30, 30}, {20, 30, 30}};
  GraphBranch branch{0, 1, {}, Joint::vessel, 0, 0};
  for (int i = 0; i <= 30; ++i) branch.points.push_back({Vector3d(50 - i, 30, 30), 1.5});
  measure(branch);
  graph.branches.push_back(branch);
  VesselTrees trees;
  trees.portal_entry_mm = {15, 30, 30};
  add_known_vessels(graph, System::biliary_tract, liver, trees);
  ASSERT_EQ(trees.branches.size(), 1u);
  EXPECT_EQ(trees.branches.front().points.front().position_mm, Vector3d(20, 30, 30));
  EXPECT_EQ(trees.branches.front().system, System::biliary_tract);
}

}  // namespace
}  // namespace glisson::vasculature
