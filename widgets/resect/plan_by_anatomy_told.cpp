// What somebody tells of the anatomy by hand: which vessel runs at a place, which border of segments. Vessels and
// segments are found again by it.

#include "casefile/vascular.h"
#include "scene/anatomy.h"
#include "widgets/resect/plan_by_anatomy.h"
#include "widgets/session/load_patient.h"

namespace glisson::widgets {
namespace {

// The vessels and segments of a case, kept in it.
Result<void> find_anatomy(const std::filesystem::path& folder, const vasculature::Told& told,
                          const Progress& progress) {
  using casefile::SegmentsBy;
  auto patient = casefile::Case::open(folder);
  if (!patient) return failure(std::move(patient.error()));
  const bool has_vessels =
      patient->find("labels/vessels") != nullptr ||
      (patient->find("labels/portal-vein") != nullptr && patient->find("labels/hepatic-vein") != nullptr);
  if (has_vessels) {
    const auto trees = casefile::find_vessels(*patient, {}, told, progress.part(0, 0.6));
    if (!trees) return failure(trees.error());
  }
  const bool by_trees = patient->find(casefile::trees_id) != nullptr;
  const auto found = by_trees
                         ? casefile::find_territories(*patient, SegmentsBy::trees, {}, progress.part(0.6, 1))
                         : casefile::find_territories(*patient, SegmentsBy::shape, told.borders, progress.part(0.6, 1));
  return found ? Result<void>() : failure(found.error());
}

}  // namespace

void PlanByAnatomy::connect_what_is_told() {
  connect(vessel_click_, &VesselClick::told, this, [this](vasculature::Vessel vessel) {
    vasculature::Told more = told_before();
    more.clicks.push_back({vessel, context_.views.crosshair_mm()});
    find_segments(more);
  });
  connect(border_by_hand_, &BorderByHand::told, this, [this](const vasculature::SegmentPair& border) {
    vasculature::Told more = told_before();
    more.borders.push_back({border, context_.views.crosshair_mm()});
    find_segments(more);
  });
  connect(border_by_hand_, &BorderByHand::last_dropped, this, [this] {
    vasculature::Told fewer = told_before();
    if (!fewer.borders.empty()) fewer.borders.pop_back();
    find_segments(fewer);
  });
  connect(&context_.views, &LinkedViews::crosshair_moved, border_by_hand_, &BorderByHand::crosshair_moved);
  const auto settled = [this] {
    if (live_->opening()) return;
    looked_at_mm_.reset();
    Q_EMIT told_places_changed();
  };
  connect(live_, &LivePlan::opened, this, settled);
  // What came of the work is shown first, if anything did.
  connect(&context_.work, &BackgroundWork::finished, this, settled, Qt::QueuedConnection);
}

std::vector<ToldPlace> PlanByAnatomy::told_places() const {
  std::vector<ToldPlace> places;
  const vasculature::Told told = told_before();
  for (const vasculature::Click& click : told.clicks) {
    const char* system = vasculature::system_name(vasculature::system_of(click.vessel));
    places.push_back(
        {vessel_label(click.vessel).toStdString(), click.position_mm, scene::appearance_of(system).colour});
  }
  for (const vasculature::BorderPlace& place : told.borders) {
    places.push_back({border_label(place.segments).toStdString(), place.position_mm, {1, 1, 1}});
  }
  return places;
}

void PlanByAnatomy::move_told_place(std::size_t place, const Eigen::Vector3d& position_mm) {
  vasculature::Told told = told_before();
  const std::size_t border = place - told.clicks.size();
  if (place < told.clicks.size()) {
    told.clicks[place].position_mm = position_mm;
  } else if (border < told.borders.size()) {
    told.borders[border].position_mm = position_mm;
  }
  find_segments(told);
}

void PlanByAnatomy::drop_told_place(std::size_t place) {
  vasculature::Told told = told_before();
  const auto at = [&](std::size_t n) { return static_cast<std::ptrdiff_t>(n); };
  const std::size_t border = place - told.clicks.size();
  if (place < told.clicks.size()) {
    told.clicks.erase(told.clicks.begin() + at(place));
  } else if (border < told.borders.size()) {
    told.borders.erase(told.borders.begin() + at(border));
  }
  find_segments(told);
}

vasculature::Told PlanByAnatomy::told_before() const {
  return live_->anatomy() ? live_->anatomy()->told : vasculature::Told();
}

void PlanByAnatomy::find_segments(const vasculature::Told& told) {
  if (!context_.may_change()) {
    Q_EMIT told_places_changed();
    return;
  }
  looked_at_mm_ = context_.views.crosshair_mm();
  context_.change(tr("Finding vessels and segments"),
                  [folder = folder_, told](const Progress& progress) -> Result<Patient> {
                    auto found = find_anatomy(folder, told, progress.part(0, 0.8));
                    if (!found) return failure(std::move(found.error()));
                    return load_patient(folder, progress.part(0.8, 1));
                  });
}

}  // namespace glisson::widgets
