#include "studies/demo/anatomy.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "anatomy/landmarks.h"
#include "base/parallel.h"
#include "segmentation/rasterise.h"
#include "studies/demo/internal/body.h"

namespace glisson::studies {
namespace {

using geometry::Surface;
using imaging::Grid;
using imaging::Mask;

Surface scaled_about_center(Surface surface, double factor);
void append(Surface& whole, const Surface& part);

// Draws `tissue` where the surface's inside is and `where` allows.
template <typename Where>
void draw(TissueImage& image, const Surface& surface, Tissue tissue, Where where) {
  const Mask mask = segmentation::rasterise(surface, image.grid);
  for (std::size_t i = 0; i < image.values.size(); ++i) {
    if (mask.values[i] != 0 && where(i)) image.values[i] = tissue;
  }
}

}  // namespace

// A tumour that would be cut out (Milan criteria: one of up to 50 mm; Mazzaferro et al. 1996, N Engl J Med 334:693), in
// the segment that the demo hoists.
anatomy::PatientOptions demo_patient_options() {
  using anatomy::LesionKind;
  anatomy::PatientOptions options;
  options.seed = 1;
  options.lesions = {{LesionKind::tumour, 30, 6, {}}, {LesionKind::cyst, 16, 8, {}}, {LesionKind::cyst, 11, 4, {}}};
  return options;
}

Result<DemoAnatomy> make_demo_anatomy(const anatomy::PatientOptions& options, const Progress& progress) {
  constexpr double body_of_ml = 2300, drawn_radius_mm = 1.8, drawn_spacing_mm = 1.4;
  const auto patient = anatomy::make_patient(options, progress);
  if (!patient) return failure(patient.error());

  DemoAnatomy demo;
  demo.size = std::cbrt(patient->options.volume_ml / body_of_ml);
  const std::map<std::string, Surface*> places = {
      {"liver", &demo.liver},         {"portal-vein", &demo.portal_vein}, {"hepatic-vein", &demo.hepatic_veins},
      {"vena-cava", &demo.vena_cava}, {"artery", &demo.arteries},         {"gallbladder", &demo.gallbladder}};
  for (const auto& [name, surface] : anatomy::surfaces_of(*patient)) {
    const auto place = places.find(name);
    append(place != places.end() ? *place->second : name.starts_with("tumour") ? demo.tumour : demo.cysts, surface);
  }
  demo.drawn_portal_vein = anatomy::tree_surface(patient->portal_vein, drawn_radius_mm, drawn_spacing_mm);
  demo.drawn_hepatic_veins = anatomy::tree_surface(patient->hepatic_vein, drawn_radius_mm, drawn_spacing_mm);
  for (const anatomy::Landmark& landmark : anatomy::landmarks_of(*patient)) {
    // Within segments, those of the left lobe and of the one that is hoisted.
    constexpr std::array<const char*, 3> segments = {"portal-segment-2-division", "portal-segment-3-division",
                                                     "portal-segment-6-division"};
    if (landmark.id.starts_with("portal-segment") &&
        std::find(segments.begin(), segments.end(), landmark.id) == segments.end()) {
      continue;
    }
    demo.landmarks.push_back({landmark.id, landmark.structure, landmark.position_mm});
  }
  for (const anatomy::Lesion& lesion : patient->lesions) {
    if (lesion.kind != anatomy::LesionKind::tumour) continue;
    demo.landmarks.push_back({lesion.name + "-centre", lesion.name, anatomy::placed(*patient, lesion.center_mm)});
  }
  return demo;
}

TissueImage draw_tissues(const DemoAnatomy& anatomy, const Grid& grid, std::uint64_t seed) {
  TissueImage image{grid, std::vector<Tissue>(grid.voxels(), Tissue::air)};
  const DemoBody body(anatomy.liver, anatomy.size, seed);
  const auto width = static_cast<std::size_t>(grid.size[0]);
  parallel_for(grid.voxels() / width, 16, [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row) {
      const int j = static_cast<int>(row) % grid.size[1], k = static_cast<int>(row) / grid.size[1];
      for (int i = 0; i < grid.size[0]; ++i) image.at(i, j, k) = body.tissue_at(grid.position_mm(i, j, k));
    }
  });

  const auto anywhere = [](std::size_t) { return true; };
  draw(image, anatomy.vena_cava, Tissue::hepatic_vein, anywhere);
  draw(image, anatomy.gallbladder, Tissue::bile, anywhere);
  draw(image, anatomy.liver, Tissue::liver, anywhere);
  draw(image, anatomy.tumour, Tissue::tumour, anywhere);
  const auto in_tumour = [&](std::size_t i) { return image.values[i] == Tissue::tumour; };
  const Mask within_rim = segmentation::rasterise(scaled_about_center(anatomy.tumour, 0.9), grid);
  for (std::size_t i = 0; i < image.values.size(); ++i) {
    if (in_tumour(i) && within_rim.values[i] == 0) image.values[i] = Tissue::tumour_rim;
  }
  draw(image, scaled_about_center(anatomy.tumour, 0.45), Tissue::tumour_core, in_tumour);
  draw(image, anatomy.cysts, Tissue::cyst, anywhere);
  draw(image, anatomy.hepatic_veins, Tissue::hepatic_vein, anywhere);
  draw(image, anatomy.portal_vein, Tissue::portal_vein, anywhere);
  draw(image, anatomy.arteries, Tissue::artery, anywhere);
  return image;
}

Mask liver_mask(const DemoAnatomy& anatomy, const Grid& grid) { return segmentation::rasterise(anatomy.liver, grid); }

namespace {

Surface scaled_about_center(Surface surface, double factor) {
  const Eigen::Vector3d center = geometry::bounding_box(surface.points_mm).center_mm();
  for (Eigen::Vector3d& point : surface.points_mm) point = center + factor * (point - center);
  return surface;
}

void append(Surface& whole, const Surface& part) {
  const int before = static_cast<int>(whole.points_mm.size());
  whole.points_mm.insert(whole.points_mm.end(), part.points_mm.begin(), part.points_mm.end());
  for (const auto& [a, b, c] : part.triangles) whole.triangles.push_back({a + before, b + before, c + before});
}

}  // namespace
}  // namespace glisson::studies
