// The tour through the window: what each stop does on the demo patient.

#include <utility>

#include "widgets/guide/guide_page.h"
#include "widgets/help/tour_stops.h"
#include "widgets/main_window.h"
#include "widgets/register/register_page.h"

namespace glisson::widgets {

void MainWindow::take_tour() {
  if (patient_.name == demo_patient_name) return start_tour();
  open_demo_then([this] { start_tour(); });
}

// Who goes on before a stop has done is not kept waiting for it; of the stops passed meanwhile the last one acts.
void MainWindow::begin_instead(const std::function<void()>& begin) {
  if (!work_.busy()) return begin();
  next_of_tour_ = begin;
  constexpr auto once_later = static_cast<Qt::ConnectionType>(Qt::QueuedConnection | Qt::SingleShotConnection);
  const auto go_on = [this] {
    if (next_of_tour_) begin_instead(std::exchange(next_of_tour_, nullptr));
  };
  connect(&work_, &BackgroundWork::finished, this, go_on, once_later);
  work_.cancel();
}

void MainWindow::start_tour() {
  std::set<QString> there;
  for (const Workspace& workspace : workspaces_) there.insert(workspace.id);
  diary_.note("The tour begins.");
  const auto press = [this](const char* button) {
    return [this, button] {
      auto* found = findChild<QAbstractButton*>(button);
      if (found != nullptr && !work_.busy()) found->click();
    };
  };
  const auto place_the_liver = [this] {
    auto* page = findChild<GuidePage*>();
    if (page == nullptr || page->has_video()) return;
    connect(page, &GuidePage::opened, page, &GuidePage::place_some, Qt::SingleShotConnection);
    page->open_example();
  };
  const auto example_sequence = [this] {
    auto* page = findChild<RegisterPage*>();
    if (page == nullptr || page->has_sequence()) return;
    connect(page, &RegisterPage::opened, page, &RegisterPage::compute, Qt::SingleShotConnection);
    page->open_example();
  };
  const auto instead = [this](std::function<void()> begin) {
    return [this, begin = std::move(begin)] { begin_instead(begin); };
  };
  tour_->start(tour_stops(there, {{"rehearse", [this] { rehearse_panel_->hoist_segment_vi(); }},
                                  {"resect", press("cut_through_crosshair")},
                                  {"guide", instead(place_the_liver)},
                                  {"register", instead(example_sequence)},
                                  {"evidence", instead(press("evidence_example"))}}));
}

}  // namespace glisson::widgets
