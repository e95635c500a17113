#pragma once
// One patient's liver with portal and hepatic veins, arteries and bile ducts as somebody outlined them: closed surfaces
// in one frame (shared data, liver_patient_models_ucl).

#include <array>
#include <string>

#include "geometry/mesh_file.h"
#include "segmentation/rasterise.h"
#include "support/data.h"
#include "vasculature/center_lines.h"
#include "vasculature/couinaud.h"

namespace glisson::test {

struct UclPatient {
  imaging::Mask liver, portal_vein, hepatic_vein;
  vasculature::VesselTrees veins, all;  // by themselves, and with arteries and ducts
  vasculature::CouinaudSegments segments;
};

// On voxels of 0.9 mm.
inline UclPatient ucl_patient() {
  const auto surface = [](const char* name) {
    return geometry::read_surface(shared_data() / "liver_patient_models_ucl" / "models" / "Liver" /
                                  (std::string(name) + ".vtk"))
        .value();
  };
  const geometry::Surface liver = surface("liver");
  const geometry::Box box = geometry::bounding_box(liver.points_mm);
  imaging::Grid grid;
  grid.spacing_mm = {0.9, 0.9, 0.9};
  grid.origin_mm = box.min_mm.array() - 5;
  for (std::size_t a = 0; a < 3; ++a) {
    const auto axis = static_cast<Eigen::Index>(a);
    grid.size[a] = static_cast<int>((box.max_mm[axis] - box.min_mm[axis] + 10) / grid.spacing_mm[axis]);
  }
  const auto lines = [&](const char* name) {
    return vasculature::center_lines(segmentation::rasterise(surface(name), grid)).value();
  };
  UclPatient patient{segmentation::rasterise(liver, grid),
                     segmentation::rasterise(surface("portal_vein"), grid),
                     segmentation::rasterise(surface("hepatic_veins"), grid),
                     {},
                     {},
                     {}};
  const auto portal = vasculature::center_lines(patient.portal_vein).value(),
             hepatic = vasculature::center_lines(patient.hepatic_vein).value();
  const auto expected = vasculature::expected_entries(patient.liver).value();
  auto entries = vasculature::possible_entries(portal, expected, {}, 1).front();
  entries.hepatic_mm = vasculature::possible_entries(hepatic, expected, {}, 1).front().hepatic_mm;
  patient.veins = vasculature::known_vessels(portal, hepatic, entries);
  patient.segments = vasculature::couinaud_segments(patient.liver, &patient.veins).value();
  patient.all = patient.veins;
  vasculature::name_branches(patient.veins, patient.segments);
  vasculature::add_known_vessels(lines("arteries"), vasculature::System::artery, patient.liver, patient.all);
  vasculature::add_known_vessels(lines("biliary_tract"), vasculature::System::biliary_tract, patient.liver,
                                 patient.all);
  vasculature::name_branches(patient.all, patient.segments);
  return patient;
}

}  // namespace glisson::test
