// The tour through the window: what each stop does on the demo patient.

#include "widgets/help/tour_stops.h"
#include "widgets/main_window.h"
#include "widgets/register/register_page.h"

namespace glisson::widgets {

void MainWindow::take_tour() {
  if (patient_.name == demo_patient_name) return start_tour();
  open_demo_then([this] { start_tour(); });
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
  const auto example_sequence = [this] {
    auto* page = findChild<RegisterPage*>();
    if (page == nullptr || page->has_sequence() || work_.busy()) return;
    connect(page, &RegisterPage::opened, page, &RegisterPage::compute, Qt::SingleShotConnection);
    page->open_example();
  };
  // Who goes on before Register has done is not kept waiting for it.
  const auto evidence_example = [this, begin = press("evidence_example")] {
    if (!work_.busy()) return begin();
    constexpr auto once_later = static_cast<Qt::ConnectionType>(Qt::QueuedConnection | Qt::SingleShotConnection);
    connect(&work_, &BackgroundWork::finished, this, begin, once_later);
    work_.cancel();
  };
  tour_->start(tour_stops(there, {{"rehearse", [this] { rehearse_panel_->hoist_segment_vi(); }},
                                  {"resect", press("cut_through_crosshair")},
                                  {"register", example_sequence},
                                  {"evidence", evidence_example}}));
}

}  // namespace glisson::widgets
