#include "widgets/views/vessel_tubes.h"

#include <algorithm>

#include "casefile/case.h"
#include "casefile/drawn_vessels.h"
#include "casefile/structures.h"
#include "geometry/nearest.h"
#include "widgets/work/run_in_background.h"

namespace glisson::widgets {
namespace {

using Vessel = VesselTubes::Vessel;
using Outlines = std::vector<PatientStructure>;

const Vessel* named(const std::vector<Vessel>& vessels, const std::string& name) {
  const auto found = std::find_if(vessels.begin(), vessels.end(), [&](const Vessel& one) { return one.name == name; });
  return found == vessels.end() ? nullptr : &*found;
}

bool same(const geometry::Surface& a, const geometry::Surface& b) {
  return &a == &b || (a.triangles == b.triangles && a.points_mm == b.points_mm);
}

Vessel vessel_of(const segmentation::Structure& mask, const PatientStructure& shown) {
  Vessel vessel{shown.name, shown.surface, nullptr, {}};
  auto drawn = casefile::drawn_vessel(mask, *shown.surface);
  if (!drawn) return vessel;
  const geometry::NearestPoint outline(shown.surface->points_mm);
  for (const Eigen::Vector3d& point : drawn->points_mm) vessel.follows.push_back(outline.nearest(point).point);
  vessel.drawn = std::make_shared<const geometry::Surface>(*std::move(drawn));
  return vessel;
}

// A case that cannot be read is told of elsewhere; its vessels are then drawn as they are outlined.
std::vector<Vessel> vessels_of(const std::filesystem::path& folder, const Outlines& outlines,
                               const std::vector<Vessel>& known) {
  std::vector<Vessel> vessels;
  Outlines unknown;
  for (const PatientStructure& shown : outlines) {
    const Vessel* before = named(known, shown.name);
    if (before != nullptr && same(*before->outline, *shown.surface)) {
      vessels.push_back(*before);
    } else {
      unknown.push_back(shown);
    }
  }
  if (unknown.empty()) return vessels;
  const auto patient = casefile::Case::open(folder);
  if (!patient) return vessels;
  const auto masks = casefile::read_structures(*patient);
  if (!masks) return vessels;
  for (const PatientStructure& shown : unknown) {
    const auto mask =
        std::find_if(masks->begin(), masks->end(), [&](const auto& structure) { return structure.name == shown.name; });
    if (mask != masks->end()) vessels.push_back(vessel_of(*mask, shown));
  }
  return vessels;
}

}  // namespace

void VesselTubes::look_for(const Patient& patient) {
  const int look = ++looks_;
  Outlines outlines = patient.all_structures();
  std::erase_if(outlines, [](const PatientStructure& shown) { return !casefile::may_be_drawn_as_tubes(shown.name); });
  if (patient.folder.empty() || outlines.empty()) {
    vessels_.clear();
    return;
  }
  const auto take = [this, look](const std::vector<Vessel>& vessels) {
    if (look != looks_) return;
    vessels_ = vessels;
    const auto is_drawn = [](const Vessel& vessel) { return vessel.drawn != nullptr; };
    if (std::any_of(vessels_.begin(), vessels_.end(), is_drawn)) Q_EMIT found();
  };
  run_in_background(
      this,
      [folder = patient.folder, outlines = std::move(outlines), known = std::move(vessels_)] {
        return vessels_of(folder, outlines, known);
      },
      take);
  vessels_.clear();
}

const VesselTubes::Vessel* VesselTubes::of(const std::string& structure) const {
  const Vessel* vessel = named(vessels_, structure);
  return vessel != nullptr && vessel->drawn ? vessel : nullptr;
}

std::vector<Eigen::Vector3d> VesselTubes::moved(const Vessel& vessel,
                                                const std::vector<Eigen::Vector3d>& outline_now_mm) {
  std::vector<Eigen::Vector3d> points_mm = vessel.drawn->points_mm;
  for (std::size_t p = 0; p < points_mm.size(); ++p) {
    const auto outline = static_cast<std::size_t>(vessel.follows[p]);
    points_mm[p] += outline_now_mm[outline] - vessel.outline->points_mm[outline];
  }
  return points_mm;
}

}  // namespace glisson::widgets
