#pragma once
// A SIMULATED patient's anatomy: liver, vessels, lesions and what lies around, all of it known and all of it ours.
//
// The same options give the same patient, to the bit, whatever the number of threads. Frame: patient coordinates,
// LPS, mm (liver_body.h says where). Nothing of it comes from any patient's images.

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "anatomy/growth.h"
#include "anatomy/lesions.h"
#include "anatomy/liver_body.h"
#include "anatomy/segments.h"
#include "anatomy/vessel_tree.h"
#include "base/progress.h"
#include "base/result.h"

namespace glisson::anatomy {

// Of the liver's tissue.
struct TissueOptions {
  double fat_fraction = 0.04;  // proton density fat fraction, 0 to 0.5; steatosis from 0.05
  int fibrosis_stage = 0;      // 0 to 4 (METAVIR)
};

// Mean shear stiffness at 60 Hz of a stage: the middles of the bands of Venkatesh et al. 2013 (J Magn Reson Imaging
// 37:544). These are: normal below 2.5 kPa, then 2.9 to 3.5, 3.5 to 4, 4 to 5, above 5.
[[nodiscard]] double shear_kPa_of(int fibrosis_stage);
// T1-weighted brightness with fat suppressed, against tissue without fat: the fat's share is gone.
[[nodiscard]] double relative_t1_of(double fat_fraction);

struct PatientOptions {
  std::uint64_t seed = 1;
  double volume_ml = 0;  // 800 to 2800; 0: drawn from the seed, 1500 (sd 300) within 1000 to 2400
  LobeVariant lobes = LobeVariant::usual;
  bool modes_from_seed = true;  // else `modes`
  ShapeModes modes;
  TissueOptions tissue;
  std::vector<LesionWish> lesions;
  int portal_terminals = 320, hepatic_terminals = 240, arterial_terminals = 120;
};

struct Patient {
  PatientOptions options;  // with what the seed drew
  std::shared_ptr<const LiverBody> liver;
  std::shared_ptr<const Segments> segments;
  VesselTree portal_vein, hepatic_vein, artery;
  Tube vena_cava, gall_bladder;
  std::vector<Lesion> lesions;
  bool turned = false;  // all positions above are of the unturned patient; what is written is mirrored
};

// Fails with anatomy-volume (not 800 to 2800 ml), anatomy-tissue, what place_lesions says, and cancelled.
Result<Patient> make_patient(const PatientOptions& options, const Progress& progress = {});

// The liver's surface alone of the same patient, placed: much faster, since nothing grows. A wider grid than the
// patient's own of 3 mm rounds the margins off, and is faster still. Lesions are not looked at. Fails with
// anatomy-volume and anatomy-tissue.
Result<geometry::Surface> make_liver_surface(const PatientOptions& options, double spacing_mm = 3);

// A named surface, ready to be written: "liver", "portal-vein", "hepatic-vein", "artery", "gallbladder", "vena-cava",
// "tumour-1", "cyst-1". Vessels as far as they are at least `minimum_radius_mm` wide, which images show.
struct NamedSurface {
  std::string name;
  geometry::Surface surface;
};
[[nodiscard]] std::vector<NamedSurface> surfaces_of(const Patient& patient, double minimum_radius_mm = 1.0);

// Mirrored left to right where the patient is turned, else as it is.
[[nodiscard]] Eigen::Vector3d placed(const Patient& patient, const Eigen::Vector3d& position_mm);

// The segment of a placed position.
[[nodiscard]] int segment_at(const Patient& patient, const Eigen::Vector3d& placed_mm);

}  // namespace glisson::anatomy
