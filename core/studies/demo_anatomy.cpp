#include "studies/demo_anatomy.h"

#include "base/json.h"
#include "base/parallel.h"
#include "geometry/mesh_file.h"
#include "segmentation/rasterise.h"
#include "studies/demo_body.h"

namespace glisson::studies {
namespace fs = std::filesystem;
namespace {

using geometry::Surface;
using imaging::Grid;
using imaging::Mask;

Result<void> read_closed(const fs::path& file, Surface& surface);
Result<std::vector<DemoLandmark>> read_landmarks(const fs::path& file);
Surface scaled_about_center(Surface surface, double factor);

// Draws `tissue` where the surface's inside is and `where` allows.
template <typename Where>
void draw(TissueImage& image, const Surface& surface, Tissue tissue, Where where) {
  const Mask mask = segmentation::rasterise(surface, image.grid);
  for (std::size_t i = 0; i < image.values.size(); ++i) {
    if (mask.values[i] != 0 && where(i)) image.values[i] = tissue;
  }
}

}  // namespace

Result<DemoAnatomy> read_demo_anatomy(const fs::path& folder) {
  DemoAnatomy anatomy;
  for (const auto& [name, surface] : {std::pair{"liver.vtk", &anatomy.liver},
                                      {"portal_vein.vtk", &anatomy.portal_vein},
                                      {"hepatic_veins.vtk", &anatomy.hepatic_veins},
                                      {"arteries.vtk", &anatomy.arteries},
                                      {"gallbladder.vtk", &anatomy.gallbladder},
                                      {"liver_tumours.vtk", &anatomy.tumour},
                                      {"liver_cysts.vtk", &anatomy.cysts}}) {
    if (auto read = read_closed(folder / name, *surface); !read) return failure(std::move(read.error()));
  }
  // The files of the liver and the portal vein hold specks of five points beside the organ.
  for (Surface* surface : {&anatomy.liver, &anatomy.portal_vein}) {
    *surface = std::move(geometry::connected_pieces(*surface).front());
  }

  auto landmarks = read_landmarks(folder / "landmarks.json");
  if (!landmarks) return failure(std::move(landmarks.error()));
  anatomy.landmarks = std::move(*landmarks);
  anatomy.landmarks.push_back(
      {"tumour-1-centre", "tumour-1", geometry::bounding_box(anatomy.tumour.points_mm).center_mm()});
  return anatomy;
}

TissueImage draw_tissues(const DemoAnatomy& anatomy, const Grid& grid, std::uint64_t seed) {
  TissueImage image{grid, std::vector<Tissue>(grid.voxels(), Tissue::air)};
  const DemoBody body(anatomy.liver, seed);
  const auto width = static_cast<std::size_t>(grid.size[0]);
  parallel_for(grid.voxels() / width, 16, [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row) {
      const int j = static_cast<int>(row) % grid.size[1], k = static_cast<int>(row) / grid.size[1];
      for (int i = 0; i < grid.size[0]; ++i) image.at(i, j, k) = body.tissue_at(grid.position_mm(i, j, k));
    }
  });

  const auto anywhere = [](std::size_t) { return true; };
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

Result<void> read_closed(const fs::path& file, Surface& surface) {
  auto read = geometry::read_surface(file);
  if (!read) return failure(std::move(read.error()));
  if (!geometry::is_watertight(*read)) {
    return failure(Error{"demo-anatomy-not-closed",
                         GLISSON_TEXT("The surface in {0} is not closed, so nothing lies inside it."),
                         {file.string()},
                         GLISSON_TEXT("Use the anatomy that ships with the program."),
                         file});
  }
  surface = std::move(*read);
  return {};
}

Result<std::vector<DemoLandmark>> read_landmarks(const fs::path& file) {
  const auto document = read_json_file(file);
  if (!document) return failure(document.error());
  std::vector<DemoLandmark> landmarks;
  try {
    for (const Json& entry : document->at("landmarks")) {
      const auto position = entry.at("position_mm").get<std::array<double, 3>>();
      landmarks.push_back({entry.at("id"), entry.at("structure"), {position[0], position[1], position[2]}});
    }
  } catch (const Json::exception& exception) {
    return failure(Error{"demo-landmarks-invalid",
                         GLISSON_TEXT("{0} does not list the demo's landmarks: {1}."),
                         {file.string(), exception.what()},
                         GLISSON_TEXT("Use the anatomy that ships with the program."),
                         file});
  }
  return landmarks;
}

Surface scaled_about_center(Surface surface, double factor) {
  const Eigen::Vector3d center = geometry::bounding_box(surface.points_mm).center_mm();
  for (Eigen::Vector3d& point : surface.points_mm) point = center + factor * (point - center);
  return surface;
}

}  // namespace
}  // namespace glisson::studies
