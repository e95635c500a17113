#include "casefile/guided_plan.h"

#include <cmath>

#include "casefile/resection_folder.h"

namespace glisson::casefile {

namespace {

using Eigen::Vector3d;

void add_lines(GuidedSequence& guided, const char* name, const vision::Rgb& colour,
               std::vector<guidance::SurfaceLine> lines) {
  if (lines.empty()) return;
  guidance::EmbeddedStructure added{name, colour, {}, {}};
  added.on_organ = std::move(lines);
  guided.structures.push_back(std::move(added));
}

// The label of the nearest voxel that has one, within a few voxels: the surface runs between them.
int label_near(const imaging::Volume& segments, const Vector3d& position_mm) {
  constexpr int reach = 2;
  const Vector3d index = segments.grid.index_of(position_mm);
  double nearest = reach * reach + 1;
  int label = 0;
  const auto& size = segments.grid.size;
  const int i = static_cast<int>(std::lround(index.x())), j = static_cast<int>(std::lround(index.y())),
            k = static_cast<int>(std::lround(index.z()));
  for (int z = std::max(0, k - reach); z <= std::min(size[2] - 1, k + reach); ++z) {
    for (int y = std::max(0, j - reach); y <= std::min(size[1] - 1, j + reach); ++y) {
      for (int x = std::max(0, i - reach); x <= std::min(size[0] - 1, i + reach); ++x) {
        const double away = (Vector3d(x, y, z) - index).squaredNorm();
        const int here = static_cast<int>(std::lround(segments.at(x, y, z)));
        if (here != 0 && away < nearest) nearest = away, label = here;
      }
    }
  }
  return label;
}

}  // namespace

void add_plans(GuidedSequence& guided, const Case& patient) {
  const geometry::Surface& liver = guided.structures.front().at_rest;
  const auto cut = read_planned_cut(patient.folder() / "results" / "resection");
  if (cut && cut->liver == PlannedCut::Liver::at_rest) {
    if (const auto sheet = surface_of(*cut)) {
      std::vector<double> heights_mm;
      for (const Vector3d& point : liver.points_mm) heights_mm.push_back(sheet->height_mm(point));
      add_lines(guided, "planned-cut", {90, 255, 120}, guidance::zero_lines(liver, heights_mm));
    }
  }
  if (patient.find("territories/couinaud") == nullptr) return;
  if (const auto segments = patient.volume("territories/couinaud")) {
    std::vector<int> labels;
    for (const Vector3d& point : liver.points_mm) labels.push_back(label_near(*segments, point));
    add_lines(guided, "segments", {255, 160, 70}, guidance::border_lines(liver, labels));
  }
}

}  // namespace glisson::casefile
