// A real patient whose portal and hepatic veins somebody outlined apart: put into one mask, they are told apart again.
// Nothing was tuned on it.

#include <gtest/gtest.h>
#include <iostream>

#include "imaging/filters.h"
#include "segmentation/edit.h"
#include "vasculature/ucl_patient.h"

namespace glisson::vasculature {
namespace {

TEST(UclPatient, PortalAndHepaticVeinsOfOneMaskAreToldApart) {
  GLISSON_NEEDS_DATA("liver_patient_models_ucl");
  const test::UclPatient patient = test::ucl_patient();
  const auto graph = center_lines(segmentation::united(patient.portal_vein, patient.hepatic_vein)).value();
  const VesselTrees trees = explain_vessels(graph, patient.liver).value().trees;
  const std::vector<float> to_portal_mm2 = imaging::squared_distances_mm2(patient.portal_vein),
                           to_hepatic_mm2 = imaging::squared_distances_mm2(patient.hepatic_vein);
  double right_mm = 0, all_mm = 0, doubtful_mm = 0;
  for (const TreeBranch& branch : trees.branches) {
    if (branch.joint != Joint::vessel) continue;
    for (std::size_t i = 1; i < branch.points.size(); ++i) {
      const Eigen::Vector3d a = branch.points[i - 1].position_mm, b = branch.points[i].position_mm;
      const Eigen::Vector3d index = patient.liver.grid.index_of(0.5 * (a + b)).array().round();
      const std::size_t voxel = patient.liver.grid.offset(static_cast<int>(index.x()), static_cast<int>(index.y()),
                                                          static_cast<int>(index.z()));
      const System known = to_portal_mm2[voxel] <= to_hepatic_mm2[voxel] ? System::portal_vein : System::hepatic_vein;
      all_mm += (b - a).norm();
      (known == branch.system ? right_mm : doubtful_mm) +=
          known == branch.system || branch.confidence < 0.8 ? (b - a).norm() : 0;
    }
  }
  std::cout << "of " << all_mm << " mm right " << 100 * right_mm / all_mm << " %, wrong and doubtful "
            << 100 * doubtful_mm / std::max(1e-9, all_mm - right_mm) << " %\n";
  EXPECT_GT(all_mm, 1000);
  EXPECT_GT(right_mm, 0.9 * all_mm);
}

}  // namespace
}  // namespace glisson::vasculature
