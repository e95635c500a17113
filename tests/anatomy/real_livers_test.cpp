// Generated livers beside real ones (livers_couinaud, read only): volume aside, are size along each axis, surface,
// curvature by scale, share of each segment and calibres of the vessels those of real livers? Prints the table of
// docs/anatomy.md.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <algorithm>
#include <cmath>
#include <iostream>
#include <map>

#include "anatomy/level_surface.h"
#include "anatomy/patient.h"
#include "imaging/filters.h"
#include "imaging/volume_file.h"
#include "meshing/mask_surface.h"
#include "segmentation/rasterise.h"
#include "support/data.h"
#include "vasculature/center_lines.h"

namespace glisson::anatomy {
namespace {

using Eigen::Vector3d;
using geometry::Surface;
using imaging::Grid;
using imaging::LabelMap;
using imaging::Mask;

using Figures = std::map<std::string, std::vector<double>>;  // by what was measured, a number a liver

// Real and generated livers are looked at through the same eyes: cubic voxels, then the same smooth surface.
constexpr double voxel_mm = 3;

Grid cubic_over(const geometry::Box& box, double spacing_mm) {
  return grid_over({box.min_mm - Vector3d::Constant(4 * spacing_mm), box.max_mm + Vector3d::Constant(4 * spacing_mm)},
                   spacing_mm);
}

geometry::Box box_of(const Grid& grid) {
  std::vector<Vector3d> corners;
  for (int c = 0; c < 8; ++c) {
    corners.push_back(grid.position_mm((c & 1) * (grid.size[0] - 1), ((c >> 1) & 1) * (grid.size[1] - 1),
                                       (c >> 2) * (grid.size[2] - 1)));
  }
  return geometry::bounding_box(corners);
}

LabelMap resampled(const LabelMap& labels, double spacing_mm) {
  LabelMap cubic{cubic_over(box_of(labels.grid), spacing_mm), {}};
  cubic.values.assign(cubic.grid.voxels(), 0);
  for (int k = 0; k < cubic.grid.size[2]; ++k) {
    for (int j = 0; j < cubic.grid.size[1]; ++j) {
      for (int i = 0; i < cubic.grid.size[0]; ++i) {
        const Vector3d at = labels.grid.index_of(cubic.grid.position_mm(i, j, k));
        const int x = static_cast<int>(std::lround(at.x())), y = static_cast<int>(std::lround(at.y())),
                  z = static_cast<int>(std::lround(at.z()));
        if (labels.grid.contains(x, y, z)) cubic.at(i, j, k) = labels.at(x, y, z);
      }
    }
  }
  return cubic;
}

Mask mask_of(const LabelMap& labels) {
  Mask mask{labels.grid, std::vector<std::uint8_t>(labels.values.size())};
  for (std::size_t i = 0; i < mask.values.size(); ++i) mask.values[i] = labels.values[i] != 0 ? 1 : 0;
  return mask;
}

// How much a surface bends outwards and inwards: half the sum over edges of length times angle between the triangles
// (the integral of mean curvature; Steiner 1840), over the cube root of the volume.
std::pair<double, double> bending(const Surface& surface) {
  std::map<std::pair<int, int>, std::size_t> first;
  double outwards = 0, inwards = 0;
  const auto point = [&](int i) { return surface.points_mm[static_cast<std::size_t>(i)]; };
  const auto normal = [&](std::size_t t) {
    const auto& [a, b, c] = surface.triangles[t];
    return (point(b) - point(a)).cross(point(c) - point(a)).normalized().eval();
  };
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    for (std::size_t e = 0; e < 3; ++e) {
      const int a = surface.triangles[t][e], b = surface.triangles[t][(e + 1) % 3];
      const auto [entry, is_new] = first.try_emplace(std::minmax(a, b), t);
      if (is_new) continue;
      const Vector3d n = normal(entry->second), m = normal(t);
      const double angle = std::atan2(n.cross(m).norm(), n.dot(m));
      const double length = (point(a) - point(b)).norm();
      const int opposite = surface.triangles[t][(e + 2) % 3];
      (n.dot(point(opposite) - point(a)) < 0 ? outwards : inwards) += 0.5 * length * angle;
    }
  }
  return {outwards, inwards};
}

// The shape without what is smaller than about `scale_mm`: where its mask, blurred so far, is half full.
Surface seen_at_scale(const Mask& mask, double scale_mm) {
  Field field{mask.grid, {mask.values.begin(), mask.values.end()}};
  field.values = imaging::gaussian_blur(std::move(field.values), mask.grid, scale_mm);
  for (float& value : field.values) value = 0.5F - value;
  return geometry::connected_pieces(level_surface(std::move(field))).front();
}

// Bending that is left at coarser and coarser scales: how much of a shape is folds, and how much is lobes.
void measure_curvature_spectrum(const LabelMap& labels, double side_mm, Figures& figures) {
  for (const double scale : {0.03, 0.06, 0.12}) {
    const auto [outwards, inwards] = bending(seen_at_scale(mask_of(labels), scale * side_mm));
    figures[fmt::format("bending outwards at {} V^1/3", scale)].push_back(outwards / side_mm);
    figures[fmt::format("bending inwards at {} V^1/3", scale)].push_back(inwards / side_mm);
  }
}

void measure_shape(const LabelMap& labels, Figures& figures) {
  Surface surface = meshing::mask_surface(mask_of(labels), meshing::organ_smoothing).value();
  surface = geometry::connected_pieces(surface).front();
  const double volume = geometry::volume_mm3(surface), side = std::cbrt(volume);
  const geometry::Box box = geometry::bounding_box(surface.points_mm);
  const Vector3d size = (box.max_mm - box.min_mm) / side;
  figures["volume, ml"].push_back(volume / 1000);
  figures["right to left / V^1/3"].push_back(size.x());
  figures["front to back / V^1/3"].push_back(size.y());
  figures["down to up / V^1/3"].push_back(size.z());
  figures["surface / V^2/3"].push_back(geometry::area_mm2(surface) / (side * side));
  const auto [outwards, inwards] = bending(surface);
  figures["bending outwards / V^1/3"].push_back(outwards / side);
  figures["bending inwards / V^1/3"].push_back(inwards / side);
  measure_curvature_spectrum(labels, side, figures);
}

void measure_segments(const LabelMap& labels, Figures& figures) {
  std::array<double, 9> voxels{};
  double all = 0;
  for (const std::uint16_t value : labels.values) {
    if (value >= 1 && value <= 8) voxels.at(value) += 1, all += 1;
  }
  for (std::size_t s = 1; s <= 8; ++s) {
    constexpr std::array<const char*, 9> roman = {"", "I", "II", "III", "IV", "V", "VI", "VII", "VIII"};
    figures[fmt::format("segment {}, %", roman.at(s))].push_back(100 * voxels.at(s) / all);
  }
}

// Voxels deepest among their neighbours stand for the middle line, about one a millimetre; their depth for the radius.
void measure_vessels(const Mask& vessels, double liver_ml, Figures& figures) {
  Mask outside = vessels;
  for (std::uint8_t& value : outside.values) value = value == 0 ? 1 : 0;
  const std::vector<float> squared = imaging::squared_distances_mm2(outside);
  const auto& size = vessels.grid.size;
  std::array<double, 3> length_mm{};
  for (int k = 1; k + 1 < size[2]; ++k) {
    for (int j = 1; j + 1 < size[1]; ++j) {
      for (int i = 1; i + 1 < size[0]; ++i) {
        const float here = squared[vessels.grid.offset(i, j, k)];
        if (here <= 0) continue;
        bool deepest = true;
        for (int n = 0; n < 27 && deepest; ++n) {
          deepest = squared[vessels.grid.offset(i + n % 3 - 1, j + n / 3 % 3 - 1, k + n / 9 - 1)] <= here;
        }
        if (!deepest) continue;
        const double radius = std::sqrt(static_cast<double>(here)) - 0.5 * vessels.grid.spacing_mm.x();
        length_mm.at(radius < 2 ? 0 : radius < 3.5 ? 1 : 2) += vessels.grid.spacing_mm.x();
      }
    }
  }
  figures["vessels 2 to 3.5 mm wide (radius), mm / V^1/3"].push_back(length_mm[1] / std::cbrt(liver_ml * 1000));
  figures["vessels beyond 3.5 mm (radius), mm / V^1/3"].push_back(length_mm[2] / std::cbrt(liver_ml * 1000));
  const auto graph = vasculature::center_lines(vessels);
  ASSERT_TRUE(graph) << graph.error().message();
  std::array<double, 3> branches{};
  for (const vasculature::GraphBranch& branch : graph->branches) {
    if (branch.joint == vasculature::Joint::vessel)
      ++branches.at(branch.radius_mm < 2 ? 0 : branch.radius_mm < 3.5 ? 1 : 2);
  }
  figures["branches 2 to 3.5 mm wide (radius)"].push_back(branches[1]);
  figures["branches beyond 3.5 mm (radius)"].push_back(branches[2]);
}

Figures of_generated_livers(int count) {
  Figures figures;
  for (int seed = 1; seed <= count; ++seed) {
    PatientOptions options;
    options.seed = static_cast<std::uint64_t>(seed);
    const Patient patient = make_patient(options).value();
    const Grid grid = cubic_over(geometry::bounding_box(patient.liver->surface.points_mm), voxel_mm);
    const Mask liver = segmentation::rasterise(patient.liver->surface, grid);
    LabelMap labels{grid, std::vector<std::uint16_t>(grid.voxels(), 0)};
    for (int k = 0; k < grid.size[2]; ++k) {
      for (int j = 0; j < grid.size[1]; ++j) {
        for (int i = 0; i < grid.size[0]; ++i) {
          if (liver.at(i, j, k) == 0) continue;
          labels.at(i, j, k) = static_cast<std::uint16_t>(segment_at(patient, grid.position_mm(i, j, k)));
        }
      }
    }
    measure_shape(labels, figures);
    measure_segments(labels, figures);

    // Portal and hepatic veins as one, inside the liver, as the real masks have them.
    const Grid fine = cubic_over(geometry::bounding_box(patient.liver->surface.points_mm), 1);
    const Field portal = tree_field(patient.portal_vein, fine, 0), hepatic = tree_field(patient.hepatic_vein, fine, 0);
    Mask vessels = segmentation::rasterise(patient.liver->surface, fine);
    for (std::size_t i = 0; i < vessels.values.size(); ++i) {
      if (std::min(portal.values[i], hepatic.values[i]) >= 0) vessels.values[i] = 0;
    }
    measure_vessels(vessels, patient.options.volume_ml, figures);
    const auto branches = branches_of(patient.portal_vein);
    figures["portal branches"].push_back(static_cast<double>(branches.size()));
  }
  return figures;
}

Figures of_real_livers(const std::filesystem::path& folder) {
  Figures figures;
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  int seen = 0;
  for (const auto& file : files) {
    const std::string name = file.filename().string();
    const auto beside = [&](const char* what) {
      return folder / (name.substr(0, name.find('_')) + "_" + what + ".nii.gz");
    };
    if (name.ends_with("_couinaud.nii.gz") && seen++ % 3 == 0) {  // a third of them: 23 livers
      const LabelMap labels = resampled(imaging::read_labels_file(file).value(), voxel_mm);
      measure_shape(labels, figures);
      measure_segments(labels, figures);
    }
    if (name.starts_with("3Dircadb") && name.ends_with("_vessels.nii.gz")) {  // the completest masks
      const LabelMap liver = resampled(imaging::read_labels_file(beside("liver")).value(), voxel_mm);
      const double ml = static_cast<double>(std::count_if(liver.values.begin(), liver.values.end(),
                                                          [](std::uint16_t v) { return v != 0; })) *
                        liver.grid.voxel_volume_mm3() / 1000;
      measure_vessels(mask_of(resampled(imaging::read_labels_file(file).value(), 1)), ml, figures);
    }
  }
  return figures;
}

struct Spread {
  double minimum, median, maximum;
};
Spread spread_of(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return {values.front(), values[values.size() / 2], values.back()};
}

TEST(GeneratedLivers, LieWithinTheSpreadOfRealOnes) {
  GLISSON_NEEDS_DATA("livers_couinaud");
  const Figures real = of_real_livers(test::shared_data() / "livers_couinaud");
  const Figures generated = of_generated_livers(16);
  std::cout << "| | real: minimum | median | maximum | generated: minimum | median | maximum "
               "|\n|---|---|---|---|---|---|---|\n";
  for (const auto& [what, values] : real) {
    const Spread r = spread_of(values), g = spread_of(generated.at(what));
    std::cout << fmt::format("| {} | {:.2f} | {:.2f} | {:.2f} | {:.2f} | {:.2f} | {:.2f} |\n", what, r.minimum,
                             r.median, r.maximum, g.minimum, g.median, g.maximum);
    EXPECT_GE(g.median, r.minimum) << what;
    EXPECT_LE(g.median, r.maximum) << what;
    const auto within = std::count_if(generated.at(what).begin(), generated.at(what).end(),
                                      [&](double value) { return value >= r.minimum && value <= r.maximum; });
    EXPECT_GE(within, 14) << what;  // of 16; real ones are 23 (vessels: 8), and the next would not always lie within
  }
}

}  // namespace
}  // namespace glisson::anatomy
