#include "anatomy/patient.h"

#include <fmt/format.h>
#include <algorithm>

#include "anatomy/internal/artery_trunk.h"
#include "anatomy/internal/trunks.h"
#include "base/noise.h"

namespace glisson::anatomy {

using Eigen::Vector3d;
using geometry::Surface;

namespace {

// Calibres (diameters): portal vein 11 mm by ultrasound (Weinreb et al. 1982, AJR 139:497) and 15.5 mm by CT (Stamm et
// al. 2016, Abdom Radiol 41:1931), the middle taken; hepatic veins 8 to 11 mm before the vena cava, proper hepatic
// artery 4 to 5 mm (Gray's Anatomy, 41st ed.). Hepatic veins: all together, as one vessel by Murray's law.
constexpr double portal_radius_mm = 6.6, portal_radius_sd_mm = 0.5, hepatic_radius_mm = 7.2, artery_radius_mm = 2.4;

Result<void> check(const PatientOptions& options) {
  if (options.volume_ml != 0 && !(options.volume_ml >= 800 && options.volume_ml <= 2800)) {
    return failure("anatomy-volume", GLISSON_TEXT("A liver of {0} ml cannot be made: ask for 800 to 2800 ml."),
                   {fmt::format("{:g}", options.volume_ml)});
  }
  const TissueOptions& tissue = options.tissue;
  if (!(tissue.fat_fraction >= 0 && tissue.fat_fraction <= 0.5) || tissue.fibrosis_stage < 0 ||
      tissue.fibrosis_stage > 4) {
    return failure("anatomy-tissue",
                   GLISSON_TEXT("A fat fraction of {0} with fibrosis of stage {1} cannot be made: the first is 0 to "
                                "0.5, the second 0 to 4."),
                   {fmt::format("{:g}", tissue.fat_fraction), std::to_string(tissue.fibrosis_stage)});
  }
  return {};
}

// What the seed decides where the options leave it open.
PatientOptions drawn(PatientOptions options) {
  Random random(mixed(options.seed, 1));
  for (double* mode :
       {&options.modes.right_length, &options.modes.left_extent, &options.modes.left_thickness, &options.modes.depth,
        &options.modes.dome, &options.modes.quadrate, &options.modes.caudate, &options.modes.margin}) {
    const double value = random.bell();
    if (options.modes_from_seed) *mode = std::clamp(value, -2.0, 2.0);
  }
  const double volume = std::clamp(1500 + 300 * random.bell(), 1000.0, 2400.0);
  if (options.volume_ml == 0) options.volume_ml = volume;
  return options;
}

SegmentShares drawn_shares(std::uint64_t seed) {
  Random random(mixed(seed, 2));
  SegmentShares shares;
  shares.posterior_of_right += 0.05 * random.bell();
  shares.seventh_of_posterior += 0.06 * random.bell();
  shares.eighth_of_anterior += 0.06 * random.bell();
  shares.second_of_left += 0.06 * random.bell();
  return shares;
}

// `options` as drawn() leaves them.
LiverBody body_of(const PatientOptions& options, double spacing_mm = 3) {
  return make_liver_body(LiverShape(options.modes, options.lobes, mixed(options.seed, 3)), options.volume_ml,
                         spacing_mm);
}

Vector3d mirrored(const Vector3d& position_mm) { return {-position_mm.x(), position_mm.y(), position_mm.z()}; }

void mirror(Surface& surface) {
  for (Vector3d& point : surface.points_mm) point = mirrored(point);
  for (auto& triangle : surface.triangles) std::swap(triangle[1], triangle[2]);
}

}  // namespace

double shear_kPa_of(int fibrosis_stage) {
  constexpr std::array<double, 5> kPa = {2.2, 3.1, 3.6, 4.4, 6.0};
  return kPa[static_cast<std::size_t>(std::clamp(fibrosis_stage, 0, 4))];
}

double relative_t1_of(double fat_fraction) { return 1 - fat_fraction; }

Result<Patient> make_patient(const PatientOptions& asked, const Progress& progress) {
  if (auto checked = check(asked); !checked) return failure(std::move(checked.error()));
  Patient patient;
  patient.options = drawn(asked);
  const PatientOptions& options = patient.options;
  patient.turned = options.lobes == LobeVariant::turned;

  progress.report(0, GLISSON_TEXT("shaping the liver"));
  patient.liver = std::make_shared<LiverBody>(body_of(options));
  patient.segments = std::make_shared<Segments>(patient.liver, drawn_shares(options.seed));
  patient.vena_cava = patient.liver->to_patient(patient.liver->shape.vena_cava());
  patient.gall_bladder = patient.liver->to_patient(patient.liver->shape.gall_bladder());
  if (progress.cancelled()) return cancelled();

  progress.report(0.3, GLISSON_TEXT("growing the vessels"));
  Random random(mixed(options.seed, 4));
  const double portal_radius = portal_radius_mm + portal_radius_sd_mm * std::clamp(random.bell(), -2.0, 2.0);
  const double hepatic_radius = hepatic_radius_mm * (1 + 0.06 * std::clamp(random.bell(), -2.0, 2.0));
  VesselTree portal = portal_trunk(*patient.liver, *patient.segments);
  set_radii(portal, portal_radius);
  VesselTree hepatic = hepatic_trunk(*patient.liver, *patient.segments, portal, hepatic_radius);
  set_radii(hepatic, hepatic_radius);

  auto lesions =
      place_lesions(options.lesions, *patient.liver, *patient.segments, {&portal, &hepatic}, mixed(options.seed, 5));
  if (!lesions) return failure(std::move(lesions.error()));
  patient.lesions = std::move(*lesions);
  portal = cut_at_lesions(portal, patient.lesions);
  set_radii(portal, portal_radius);

  VesselTree artery = cut_at_lesions(artery_trunk(portal, hepatic, artery_radius_mm), patient.lesions);
  set_radii(artery, artery_radius_mm);
  const auto places = [&](int count, double depth_mm, std::uint64_t stream) {
    return spread_places(*patient.liver, patient.lesions, count, depth_mm, mixed(options.seed, stream));
  };
  GrowthSite site{patient.liver.get(), patient.segments.get(), &patient.lesions, {&hepatic, &artery}, true,
                  portal_radius};
  patient.portal_vein = grown(std::move(portal), places(options.portal_terminals, 4, 6), site);
  if (progress.cancelled()) return cancelled();
  progress.report(0.6, GLISSON_TEXT("growing the vessels"));
  site.by_segment = false;
  site.others = {&patient.portal_vein, &artery};
  site.root_radius_mm = hepatic_radius;
  patient.hepatic_vein = grown(std::move(hepatic), places(options.hepatic_terminals, 5, 7), site);
  site.others = {&patient.portal_vein, &patient.hepatic_vein};
  site.root_radius_mm = artery_radius_mm;
  patient.artery = grown(std::move(artery), places(options.arterial_terminals, 4, 8), site);
  progress.report(1, GLISSON_TEXT("done"));
  return patient;
}

namespace {

Surface surface_of(const std::function<double(const Vector3d&)>& distance_mm, geometry::Box box, double spacing_mm) {
  box.min_mm.array() -= 4 * spacing_mm;
  box.max_mm.array() += 4 * spacing_mm;
  return level_surface(sampled(grid_over(box, spacing_mm), distance_mm));
}

Surface surface_of(const Tube& tube, double spacing_mm) {
  geometry::Box box = geometry::bounding_box(tube.points_mm);
  const double widest = *std::max_element(tube.radii_mm.begin(), tube.radii_mm.end());
  box.min_mm.array() -= widest;
  box.max_mm.array() += widest;
  return surface_of([&](const Vector3d& p) { return tube.distance_mm(p); }, box, spacing_mm);
}

Surface surface_of(const Lesion& lesion) {
  const Vector3d reach = Vector3d::Constant(1.2 * lesion.radius_mm);
  return surface_of([&](const Vector3d& p) { return lesion.distance_mm(p); },
                    {lesion.center_mm - reach, lesion.center_mm + reach}, std::clamp(lesion.radius_mm / 10, 0.4, 2.0));
}

}  // namespace

std::vector<NamedSurface> surfaces_of(const Patient& patient, double minimum_radius_mm) {
  constexpr double vessel_spacing_mm = 1.1;
  std::vector<NamedSurface> surfaces = {{"liver", patient.liver->surface}};
  surfaces.push_back({"portal-vein", tree_surface(patient.portal_vein, minimum_radius_mm, vessel_spacing_mm)});
  surfaces.push_back({"hepatic-vein", tree_surface(patient.hepatic_vein, minimum_radius_mm, vessel_spacing_mm)});
  surfaces.push_back({"artery", tree_surface(patient.artery, 0.7 * minimum_radius_mm, 0.7 * vessel_spacing_mm)});
  surfaces.push_back({"gallbladder", surface_of(patient.gall_bladder, 1.5)});
  surfaces.push_back({"vena-cava", surface_of(patient.vena_cava, 2)});
  for (const Lesion& lesion : patient.lesions) surfaces.push_back({lesion.name, surface_of(lesion)});
  if (patient.turned) {
    for (auto& [name, surface] : surfaces) mirror(surface);
  }
  return surfaces;
}

Result<Surface> make_liver_surface(const PatientOptions& asked, double spacing_mm) {
  if (auto checked = check(asked); !checked) return failure(std::move(checked.error()));
  Surface liver = body_of(drawn(asked), spacing_mm).surface;
  if (asked.lobes == LobeVariant::turned) mirror(liver);
  return liver;
}

Vector3d placed(const Patient& patient, const Vector3d& position_mm) {
  return patient.turned ? mirrored(position_mm) : position_mm;
}

int segment_at(const Patient& patient, const Vector3d& placed_mm) {
  return patient.segments->at(placed(patient, placed_mm));
}

}  // namespace glisson::anatomy
