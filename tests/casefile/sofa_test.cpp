// The scene for SOFA, judged by what it says itself: its files are read by an XML parser and as plain text, its linear
// tetrahedra put together and solved by a slow program of their own, and that answer held against Glisson's.

#include "casefile/sofa.h"

#include <gmock/gmock.h>
#include <vtkSmartPointer.h>
#include <vtkXMLDataElement.h>
#include <vtkXMLUtilities.h>
#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <sstream>

#include "base/csv.h"
#include "base/files.h"
#include "casefile/model.h"
#include "casefile/structures.h"
#include "geometry/mesh_file.h"
#include "mechanics/bodies.h"
#include "mechanics/simulation.h"
#include "mechanics/statics/static_model.h"
#include "segmentation/edit.h"

namespace glisson::casefile {
namespace {

namespace fs = std::filesystem;
using Eigen::Vector3d;
using testing::Contains;
using testing::HasSubstr;

std::vector<double> numbers_in(const char* text) {
  std::istringstream words(text == nullptr ? "" : text);
  std::vector<double> all;
  for (double number = 0; words >> number;) all.push_back(number);
  return all;
}

// What a reader of the folder finds in it: one node with the body, the components in it by their type.
class ReadScene {
 public:
  explicit ReadScene(const fs::path& folder) {
    const std::string text = read_text_file(folder / "scene.scn").value();
    root_ = vtkSmartPointer<vtkXMLDataElement>::Take(vtkXMLUtilities::ReadElementFromString(text.c_str()));
    if (!root_) return;
    for (int n = 0; n < root_->GetNumberOfNestedElements(); ++n) {
      vtkXMLDataElement* node = root_->GetNestedElement(n);
      if (std::string(node->GetName()) == "Node" && std::string(node->GetAttribute("name")) == "liver") liver_ = node;
    }
    if (liver_ == nullptr) return;
    std::istringstream mesh(read_text_file(folder / attribute("MeshVTKLoader", "filename")).value());
    std::string word;
    std::size_t points = 0, cells = 0, size = 0;
    while (mesh >> word && word != "POINTS") continue;
    mesh >> points >> word;
    nodes_mm.resize(points);
    for (Vector3d& at : nodes_mm) mesh >> at.x() >> at.y() >> at.z();
    mesh >> word >> cells >> size;
    tetrahedra.resize(cells);
    for (auto& cell : tetrahedra) mesh >> size >> cell[0] >> cell[1] >> cell[2] >> cell[3];
    complete = static_cast<bool>(mesh);
  }
  [[nodiscard]] std::vector<vtkXMLDataElement*> components(const std::string& type) const {
    std::vector<vtkXMLDataElement*> found;
    for (int n = 0; n < liver_->GetNumberOfNestedElements(); ++n) {
      if (liver_->GetNestedElement(n)->GetName() == type) found.push_back(liver_->GetNestedElement(n));
    }
    return found;
  }
  [[nodiscard]] std::string attribute(const std::string& type, const char* name) const {
    return components(type).at(0)->GetAttribute(name);
  }
  [[nodiscard]] vtkXMLDataElement* child_node(const std::string& name) const {
    for (vtkXMLDataElement* node : components("Node")) {
      if (node->GetAttribute("name") == name) return node;
    }
    return nullptr;
  }

  bool complete = false;
  std::vector<Vector3d> nodes_mm;
  std::vector<std::array<int, 4>> tetrahedra;

  // Equilibrium at small strain, from the files alone: K u = f, dense.
  [[nodiscard]] Eigen::VectorXd solved_mm() const {
    const auto youngs_kPa = numbers_in(components("TetrahedronFEMForceField").at(0)->GetAttribute("youngModulus"));
    const double nu = numbers_in(components("TetrahedronFEMForceField").at(0)->GetAttribute("poissonRatio")).at(0);
    const auto unknowns = 3 * static_cast<Eigen::Index>(nodes_mm.size());
    Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(unknowns, unknowns);
    for (std::size_t c = 0; c < tetrahedra.size(); ++c) {
      Eigen::Matrix4d corners;
      for (int i = 0; i < 4; ++i) corners.row(i) << 1, nodes_mm[std::size_t(tetrahedra[c][std::size_t(i)])].transpose();
      const Eigen::Matrix4d shape = corners.inverse();  // below the first row: the gradients
      const double volume = std::abs(corners.determinant()) / 6, youngs = youngs_kPa.at(c);
      const double lambda = youngs * nu / ((1 + nu) * (1 - 2 * nu)), mu = youngs / (2 * (1 + nu));
      for (std::size_t a = 0; a < 4; ++a) {
        for (std::size_t b = 0; b < 4; ++b) {
          const Vector3d ga = shape.col(Eigen::Index(a)).tail<3>(), gb = shape.col(Eigen::Index(b)).tail<3>();
          stiffness.block<3, 3>(3 * tetrahedra[c][a], 3 * tetrahedra[c][b]) +=
              volume *
              (lambda * ga * gb.transpose() + mu * gb * ga.transpose() + mu * ga.dot(gb) * Eigen::Matrix3d::Identity());
        }
      }
    }
    for (vtkXMLDataElement* springs : components("RestShapeSpringsForceField")) {
      const auto points = numbers_in(springs->GetAttribute("points"));
      const auto each = numbers_in(springs->GetAttribute("stiffness"));
      for (std::size_t n = 0; n < points.size(); ++n) {
        for (int axis = 0; axis < 3; ++axis) {
          const auto row = 3 * static_cast<Eigen::Index>(points[n]) + axis;
          stiffness(row, row) += each.at(n);
        }
      }
    }
    Eigen::VectorXd force_mN = Eigen::VectorXd::Zero(unknowns);
    for (vtkXMLDataElement* load : components("ConstantForceField")) {
      const auto indices = numbers_in(load->GetAttribute("indices")), forces = numbers_in(load->GetAttribute("forces"));
      for (std::size_t n = 0; n < indices.size(); ++n) {
        for (int axis = 0; axis < 3; ++axis) {
          force_mN[3 * static_cast<Eigen::Index>(indices[n]) + axis] += forces.at(3 * n + std::size_t(axis));
        }
      }
    }
    const auto hold = [&](double node, int axis) {
      const auto row = 3 * static_cast<Eigen::Index>(node) + axis;
      stiffness.row(row).setZero();
      stiffness.col(row).setZero();
      stiffness(row, row) = 1;
      force_mN[row] = 0;
    };
    for (vtkXMLDataElement* held : components("FixedProjectiveConstraint")) {
      for (const double node : numbers_in(held->GetAttribute("indices"))) {
        for (int axis = 0; axis < 3; ++axis) hold(node, axis);
      }
    }
    for (vtkXMLDataElement* held : components("PartialFixedProjectiveConstraint")) {
      const auto directions = numbers_in(held->GetAttribute("fixedDirections"));
      for (const double node : numbers_in(held->GetAttribute("indices"))) {
        for (int axis = 0; axis < 3; ++axis) {
          if (directions.at(std::size_t(axis)) != 0) hold(node, axis);
        }
      }
    }
    return stiffness.ldlt().solve(force_mN);
  }

  [[nodiscard]] Vector3d total_force_mN() const {
    Vector3d sum = Vector3d::Zero();
    for (vtkXMLDataElement* load : components("ConstantForceField")) {
      const auto forces = numbers_in(load->GetAttribute("forces"));
      for (std::size_t n = 0; n < forces.size(); ++n) sum[static_cast<Eigen::Index>(n % 3)] += forces[n];
    }
    return sum;
  }

 private:
  vtkSmartPointer<vtkXMLDataElement> root_;
  vtkXMLDataElement* liver_ = nullptr;
};

class SofaScenes : public testing::Test {
 protected:
  // A bar of 90 x 60 x 60 mm, as soft as 4 to 8 kPa from cell to cell, with a tumour in it.
  void SetUp() override {
    auto patient = Case::create(folder_);
    ASSERT_TRUE(patient);
    ASSERT_TRUE(save_structure(*patient, segmentation::make_structure("liver", ball({45, 30, 30}, 50)),
                               {"segment", {}, {}, {}, {}}));
    const auto tumour = segmentation::make_structure("tumour-1", ball({60, 30, 30}, 10));
    ASSERT_TRUE(save_structure(*patient, tumour, {"segment", {}, {}, {}, {}}));
    ASSERT_TRUE(patient->add(
        "surfaces/tumour-1", ".vtp", {"mesh", {}, {"labels/tumour-1"}, {}, {}},
        [&](const fs::path& file) { return geometry::write_surface(file, smooth_outline(tumour).value()); }));
    mesh_ = mechanics::test::box(6, 4, 4, {90, 60, 60});
    mechanics::test::disturb_inner_points(mesh_, 2);
    mechanics::test::name_points(mesh_, "bare_area", [](const Vector3d& p) { return p.x() == 0; });
    mechanics::test::name_points(mesh_, "diaphragm", [](const Vector3d& p) { return p.z() == 60; });
    ASSERT_TRUE(patient->add("meshes/liver", ".vtu", {"mesh", {}, {"labels/liver"}, {}, {}},
                             [&](const fs::path& file) { return geometry::write_tetrahedra(file, mesh_); }));
    ASSERT_TRUE(assign_stiffness(*patient, Uniform{5.0}));
    for (std::size_t c = 0; c < mesh_.cells.size(); ++c) youngs_kPa_.push_back(6 + 2 * std::sin(double(c)));
    geometry::set_field(mesh_.cell_fields, {"youngs_modulus_kPa", 1, youngs_kPa_});
    ASSERT_TRUE(geometry::write_tetrahedra(folder_ / "meshes/model.vtu", mesh_));
    mechanics::Landmark deep{"deep & dark", {52, 31, 29}};
    scenario_.poisson_ratio = 0.3;
    scenario_.supports = {{mechanics::NamedPoints{"bare_area"}, mechanics::Fixed{}}};
    scenario_.loads = {mechanics::ToolLoad{{90, 30, 30}, 20, {0, 30, 40}}};
    scenario_.landmarks = {deep};
  }
  static imaging::Mask ball(const Vector3d& center_mm, double radius_mm) {
    imaging::Mask mask;
    mask.grid.size = {60, 40, 40};
    mask.grid.spacing_mm = {3, 3, 3};
    mask.values.resize(mask.grid.voxels());
    return segmentation::paint(std::move(mask), {center_mm, radius_mm});
  }
  Result<SofaExport> exported(const std::optional<mechanics::Scenario>& scenario) const {
    return Case::open(folder_).and_then([&](const Case& patient) { return export_sofa(patient, scenario, out_); });
  }
  // Glisson's own linear tetrahedra.
  Eigen::VectorXd own_answer_mm() const {
    mechanics::StaticOptions options;
    options.poisson_ratio = scenario_.poisson_ratio;
    options.order = mechanics::ElementOrder::linear;
    const auto model = mechanics::StaticModel::create(mesh_, youngs_kPa_, scenario_.supports, options).value();
    const auto answer = model.solve(scenario_.loads).value();
    EXPECT_TRUE(answer.converged());
    Eigen::VectorXd u(3 * static_cast<Eigen::Index>(answer.displacement_mm.size()));
    for (std::size_t p = 0; p < answer.displacement_mm.size(); ++p) {
      u.segment<3>(3 * static_cast<Eigen::Index>(p)) = answer.displacement_mm[p];
    }
    return u;
  }
  [[nodiscard]] std::string code_of(const mechanics::Scenario& scenario) const {
    const auto written = exported(scenario);
    return written ? "written" : written.error().code;
  }

  TemporaryFolder temporary_;
  fs::path folder_ = temporary_.path() / "patient.glisson", out_ = temporary_.path() / "sofa";
  geometry::TetMesh mesh_;
  std::vector<double> youngs_kPa_;
  mechanics::Scenario scenario_;
};

// Every point of this mesh is a node, in the same order.
TEST_F(SofaScenes, SayWhatGlissonsOwnLinearTetrahedraAnswer) {
  const auto written = exported(scenario_);
  ASSERT_TRUE(written) << written.error().message();
  const ReadScene scene(out_);
  ASSERT_TRUE(scene.complete);
  ASSERT_EQ(scene.tetrahedra.size(), mesh_.cells.size());
  ASSERT_EQ(scene.nodes_mm.size(), mesh_.points_mm.size());
  EXPECT_EQ(numbers_in(scene.components("TetrahedronFEMForceField")[0]->GetAttribute("youngModulus")), youngs_kPa_);
  EXPECT_EQ(scene.attribute("TetrahedronFEMForceField", "method"), "small");
  EXPECT_LT((scene.total_force_mN() - Vector3d(0, 30, 40)).norm(), 1e-9);
  const Eigen::VectorXd own_mm = own_answer_mm(), theirs_mm = scene.solved_mm();
  EXPECT_GT(own_mm.cwiseAbs().maxCoeff(), 1);
  EXPECT_LT((own_mm - theirs_mm).norm(), 1e-8 * own_mm.norm());

  // The table beside it: the same at the landmark and at the node that goes farthest, and Glisson's quadratic answer.
  const std::string text = read_text_file(out_ / "expected.csv").value();
  const std::vector<CsvRow> table = csv_rows(text);
  ASSERT_EQ(table.size(), 3u);
  const auto place = [&](std::size_t row, const std::string& of) {
    Vector3d place_mm(0, 0, 0);
    for (std::size_t cell = 0; cell < table[0].cells.size(); ++cell) {
      for (int axis = 0; axis < 3; ++axis) {
        if (table[0].cells[cell] == of + "xyz"[axis] + "_mm") place_mm[axis] = table[row].number(cell);
      }
    }
    return place_mm;
  };
  EXPECT_EQ(table[1].cells[0], "deep & dark");
  const auto moved_mm = [&](Eigen::Index node) { return theirs_mm.segment<3>(3 * node); };
  Vector3d landmark_mm = Vector3d::Zero();
  int holding = 0;
  for (const auto& cell : scene.tetrahedra) {
    Eigen::Matrix4d corners;
    for (int i = 0; i < 4; ++i) corners.col(i) << 1, scene.nodes_mm[std::size_t(cell[std::size_t(i)])];
    const Eigen::Vector4d share = corners.inverse() * Eigen::Vector4d(1, 52, 31, 29);
    if (share.minCoeff() < 0 || holding++ > 0) continue;
    for (int i = 0; i < 4; ++i) landmark_mm += share[i] * moved_mm(cell[std::size_t(i)]);
  }
  ASSERT_GT(holding, 0);
  EXPECT_LT((place(1, "scene_") - place(1, "") - landmark_mm).norm(), 3e-4);
  Eigen::Index farthest = 0;
  for (Eigen::Index n = 0; n < theirs_mm.size() / 3; ++n) {
    if (moved_mm(n).norm() > moved_mm(farthest).norm()) farthest = n;
  }
  EXPECT_LT((place(2, "scene_") - place(2, "") - moved_mm(farthest)).norm(), 3e-4);
  const auto simulated = mechanics::simulate(mesh_, scenario_).value();
  EXPECT_LT((place(1, "glisson_") - simulated.landmarks[0].displaced_mm).norm(), 3e-4);
  EXPECT_GT(simulated.landmarks[0].displacement_mm, landmark_mm.norm());  // linear tetrahedra are stiffer
  EXPECT_THAT(messages(written->remarks), Contains(HasSubstr("stiffer")));
}

TEST_F(SofaScenes, AFoundationIsAsStiffAsItsAreaAndNearlyActsAlike) {
  scenario_.supports.push_back({mechanics::NamedPoints{"diaphragm"}, mechanics::Foundation{0.02}});
  ASSERT_TRUE(exported(scenario_));
  const ReadScene scene(out_);
  ASSERT_TRUE(scene.complete);
  double sum_mN_per_mm = 0;
  for (const double each :
       numbers_in(scene.components("RestShapeSpringsForceField").at(0)->GetAttribute("stiffness"))) {
    sum_mN_per_mm += each;
  }
  EXPECT_NEAR(sum_mN_per_mm, 0.02 * 90 * 60, 1e-9);
  const Eigen::VectorXd own_mm = own_answer_mm(), theirs_mm = scene.solved_mm();
  scenario_.supports.pop_back();
  const Eigen::VectorXd without_mm = own_answer_mm();
  EXPECT_GT((own_mm - without_mm).norm(), 0.2 * own_mm.norm());
  EXPECT_LT((own_mm - theirs_mm).norm(), 0.02 * own_mm.norm());  // rows summed, against the consistent matrix
}

TEST_F(SofaScenes, HoldPointsInTheirDirectionsAlone) {
  scenario_.supports = {{mechanics::NamedPoints{"bare_area"}, mechanics::Fixed{{true, false, false}, {0, 0, 0}}},
                        {mechanics::Ball{{0, 0, 0}, 1}, mechanics::Fixed{}},
                        {mechanics::Ball{{0, 60, 0}, 1}, mechanics::Fixed{{false, false, true}, {0, 0, 0}}}};
  scenario_.loads = {mechanics::PressureLoad{0.2}, mechanics::GravityLoad{{0, 0, -9810}}};
  ASSERT_TRUE(exported(scenario_));
  const ReadScene scene(out_);
  ASSERT_TRUE(scene.complete);
  EXPECT_EQ(scene.components("PartialFixedProjectiveConstraint").size(), 2u);
  const double weight_mN = 9810 * 1e-6 * 90 * 60 * 60;  // of 1000 kg/m3; the gas's forces cancel
  EXPECT_LT((scene.total_force_mN() - Vector3d(0, 0, -weight_mN)).norm(), 1e-6 * weight_mN);
  const Eigen::VectorXd own_mm = own_answer_mm();
  EXPECT_LT((own_mm - scene.solved_mm()).norm(), 1e-8 * own_mm.norm());
}

TEST_F(SofaScenes, CarryLandmarksAndStructuresAlong) {
  ASSERT_TRUE(exported(scenario_));
  const ReadScene scene(out_);
  ASSERT_TRUE(scene.complete);
  vtkXMLDataElement* landmark = scene.child_node("landmark-deep___dark");
  ASSERT_NE(landmark, nullptr);
  ASSERT_NE(landmark->FindNestedElementWithName("BarycentricMapping"), nullptr);
  EXPECT_EQ(numbers_in(landmark->FindNestedElementWithName("MechanicalObject")->GetAttribute("position")),
            (std::vector<double>{52, 31, 29}));
  vtkXMLDataElement* tumour = scene.child_node("tumour-1");
  ASSERT_NE(tumour, nullptr);
  const auto surface =
      geometry::read_surface(out_ / tumour->FindNestedElementWithName("MeshOBJLoader")->GetAttribute("filename"));
  ASSERT_TRUE(surface);
  EXPECT_LT((geometry::mean_point_mm(*surface) - Vector3d(60, 30, 30)).norm(), 2);
}

TEST_F(SofaScenes, AMotionHasItsStepAndDamping) {
  scenario_.motion = mechanics::Motion{0.01, 20, 1.5, 0.02};
  scenario_.material = mechanics::MaterialLaw::corotational;
  ASSERT_TRUE(exported(scenario_));
  const ReadScene scene(out_);
  ASSERT_TRUE(scene.complete);
  EXPECT_EQ(scene.attribute("TetrahedronFEMForceField", "method"), "large");
  EXPECT_EQ(scene.attribute("EulerImplicitSolver", "rayleighMass"), "1.5");
  EXPECT_EQ(scene.attribute("EulerImplicitSolver", "rayleighStiffness"), "0.02");
  EXPECT_NEAR(numbers_in(scene.attribute("MeshMatrixMass", "massDensity").c_str()).at(0), 1e-6, 1e-18);
  EXPECT_FALSE(fs::exists(out_ / "expected.csv"));  // of an equilibrium alone
}

TEST_F(SofaScenes, WithoutAScenarioSegmentVIIsHoisted) {
  const auto written = exported(std::nullopt);
  ASSERT_TRUE(written) << written.error().message();
  EXPECT_THAT(messages(written->remarks), Contains(HasSubstr("hoists segment VI with 2 N")));
  const ReadScene scene(out_);
  ASSERT_TRUE(scene.complete);
  EXPECT_NEAR(scene.total_force_mN().norm(), 2000, 1e-6);
  EXPECT_NE(scene.child_node("landmark-tumour-1"), nullptr);
}

TEST_F(SofaScenes, WhatNoSceneCanHoldIsRefusedByItsName) {
  mechanics::Scenario other = scenario_;
  other.material = mechanics::MaterialLaw::neo_hookean;
  const auto refused = exported(other);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, "sofa-cannot-hold");
  EXPECT_THAT(refused.error().message(), HasSubstr("neo-hookean"));
  EXPECT_FALSE(fs::exists(out_));
  other = scenario_;
  other.engine = mechanics::Engine::meshfree;
  EXPECT_EQ(code_of(other), "sofa-cannot-hold");
  other = scenario_;
  other.relaxation = {{0.3, 5}};
  EXPECT_EQ(code_of(other), "sofa-cannot-hold");
  other = scenario_;
  other.supports.push_back({mechanics::NamedPoints{"diaphragm"}, mechanics::Ligament{{0, 0, 200}, 1, 0}});
  EXPECT_EQ(code_of(other), "sofa-cannot-hold");
  other = scenario_;
  other.supports[0].how = mechanics::Fixed{{true, true, true}, {0, 0, 1}};
  EXPECT_EQ(code_of(other), "sofa-cannot-hold");
  other = scenario_;
  other.material = mechanics::MaterialLaw::corotational;
  other.loads.emplace_back(mechanics::PressureLoad{1});
  EXPECT_EQ(code_of(other), "sofa-cannot-hold");
  other = scenario_;
  other.supports.clear();
  other.supports.push_back({mechanics::Ball{{0, 0, 0}, 1}, mechanics::Fixed{}});
  EXPECT_EQ(code_of(other), "body-free");
}

}  // namespace
}  // namespace glisson::casefile
