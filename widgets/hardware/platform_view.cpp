#include "widgets/hardware/platform_view.h"

#include <algorithm>
#include <cmath>
#include <QHBoxLayout>
#include <QLocale>
#include <QSignalBlocker>

#include "base/files.h"
#include "hardware/device_file.h"
#include "hardware/measure.h"
#include "widgets/hardware/platform_words.h"
#include "widgets/panels/ask_path.h"
#include "widgets/panels/parts.h"
#include "widgets/words/keep_translated.h"
#include "widgets/words/numbers.h"
#include "widgets/words/paths.h"
#include "widgets/words/translated.h"

namespace glisson::widgets {

using hardware::Device;
using hardware::DevicePlan;

namespace {

QString whole(double value) { return QLocale().toString(value, 'f', 0); }

// Figure 6.4's ten volumes, widened where a case lies outside, by ten resolutions; these in equal ratios, since what
// costs and what fails lies at the fine end.
hardware::ProblemGrid grid_around(double volume_cm3, double resolution_mm3) {
  hardware::ProblemGrid grid = hardware::dissertation_grid();
  const double minimum = std::min(grid.volumes_cm3.front(), volume_cm3);
  const double maximum = std::max(grid.volumes_cm3.back(), volume_cm3);
  const auto last = static_cast<double>(grid.volumes_cm3.size() - 1);
  for (std::size_t i = 0; i < grid.volumes_cm3.size(); ++i)
    grid.volumes_cm3[i] = minimum + (maximum - minimum) * static_cast<double>(i) / last;
  const double finest_mm3 = grid.resolutions_mm3.front();
  const double ratio = std::max(grid.resolutions_mm3.back(), resolution_mm3) / finest_mm3;
  for (std::size_t i = 0; i < grid.resolutions_mm3.size(); ++i)
    grid.resolutions_mm3[i] = finest_mm3 * std::pow(ratio, static_cast<double>(i) / last);
  return grid;
}

// With the tables and the curve that ship; a sentence in its place where they cannot be read.
QWidget* shipped_view() {
  const auto resources = resource_folder();
  const auto devices = resources.and_then(
      [](const std::filesystem::path& folder) { return hardware::read_devices(folder / "devices" / "devices.json"); });
  const auto curve = resources.and_then([](const std::filesystem::path& folder) {
    return hardware::read_convergence_curve(folder / "devices" / "convergence.json");
  });
  const auto tasks = resources.and_then(
      [](const std::filesystem::path& folder) { return hardware::read_tasks(folder / "devices" / "tasks.json"); });
  if (devices && curve && tasks) return new PlatformView(*devices, *curve, *tasks);
  auto* sorry = new QLabel;
  keep_translated(sorry, [sorry, error = !devices ? devices.error()
                                         : !curve ? curve.error()
                                                  : tasks.error()] { sorry->setText(translated(error)); });
  sorry->setWordWrap(true);
  sorry->setAlignment(Qt::AlignCenter);
  return sorry;
}

}  // namespace

PlatformView::PlatformView(std::vector<Device> devices, hardware::ConvergenceCurve curve,
                           std::vector<hardware::Task> tasks, QWidget* parent)
    : QWidget(parent), devices_(std::move(devices)), curve_(std::move(curve)), tasks_(std::move(tasks)) {
  setObjectName("platform_view");
  auto* across = new QHBoxLayout(this);
  across->setContentsMargins(0, 0, 0, 0);
  across->setSpacing(0);
  QScrollArea* question = scrolled(make_question());
  question->setFixedWidth(330);
  across->addWidget(question);
  across->addWidget(make_answer(), 1);
  set_accuracy_range();
  accuracy_->set_value(5);
  for (NumberSlider* slider : {accuracy_, duration_, frames_, room_, limit_})
    connect(slider, &NumberSlider::changed, this, &PlatformView::replan);
  connect(volume_, &NumberBox::valueChanged, this, &PlatformView::replan);
  connect(youngs_, &NumberBox::valueChanged, this, [this] {
    set_accuracy_range();
    replan();
  });
  connect(table_, &PlatformTable::platform_chosen, this, [this] {
    show_platform();
    show_picture();
  });
  connect(quantity_, &QComboBox::currentIndexChanged, this, &PlatformView::show_picture);
  connect(task_, &QComboBox::currentIndexChanged, this, &PlatformView::choose_task);
  connect(trace_, &TraceView::refused, this, &PlatformView::refuse);
  connect(trace_, &TraceView::plan_with_it, this, &PlatformView::plan_with_trace);
  connect(trace_, &TraceView::opened, this, [this] {
    refusal_->hide();
    trace_open_ = true;
    show_lower_left();
  });
  connect(trace_, &TraceView::closed, this, [this] {
    trace_open_ = false;
    show_lower_left();
  });
  keep_translated(this, [this] {
    update_case_text();
    replan();
  });
}

Workspace PlatformView::workspace() {
  QWidget* shown = shipped_view();
  return {.id = "platform",
          .name = [] { return tr("Platform"); },
          .about = [] { return tr("Find what can be worn for this case."); },
          .widget = shown,
          .place = Workspace::Place::whole_window,
          .group = Workspace::Group::research,
          .show_patient =
              [view = qobject_cast<PlatformView*>(shown)](const Patient& patient) {
                if (view == nullptr || patient.name.empty()) return;
                const PatientStructure* liver = patient.liver();
                view->show_case(QString::fromStdString(patient.name), liver != nullptr ? liver->volume_ml : 0,
                                patient.mean_youngs_kPa, patient.assumed_stiffness.has_value());
              }};
}

void PlatformView::show_case(const QString& name, double liver_volume_cm3, double youngs_kPa, bool assumed) {
  const QSignalBlocker quiet_volume(volume_);
  const QSignalBlocker quiet_youngs(youngs_);
  if (liver_volume_cm3 > 0) volume_->setValue(liver_volume_cm3);
  if (youngs_kPa > 0) youngs_->setValue(youngs_kPa);
  case_name_words_ = [name = name.toStdString(), volume = liver_volume_cm3 > 0, stiffness = youngs_kPa > 0, assumed] {
    const QString shown = patient_label(name);
    return assumed && volume     ? tr("Volume of %1; its stiffness is assumed").arg(shown)
           : volume && stiffness ? tr("Volume and stiffness of %1").arg(shown)
           : volume              ? tr("Volume of %1; its stiffness is not known").arg(shown)
           : stiffness           ? tr("Stiffness of %1; its volume is not known").arg(shown)
                                 : tr("%1 has no outlined liver yet: type its volume").arg(shown);
  };
  update_case_text();
  set_accuracy_range();
  replan();
}

void PlatformView::update_case_text() {
  case_name_->setText(case_name_words_ ? case_name_words_() : tr("No case is open: type its figures"));
}

void PlatformView::add_devices(std::vector<Device> devices) {
  hardware::take_in(std::move(devices), devices_);
  replan();
}

void PlatformView::choose_devices() {
  const QString file = ask_for_file(this, tr("Add devices"), tr("Device tables (*.json)"));
  if (file.isEmpty()) return;
  auto devices = hardware::read_devices(path_of(file));
  if (devices) {
    add_devices(*std::move(devices));
  } else {
    refuse(devices.error());
  }
}

void PlatformView::refuse(const Error& error) {
  refusal_->setText(translated(error));
  refusal_->show();
}

void PlatformView::choose_trace() {
  const QString file = ask_for_file(this, tr("Read a power recording"), tr("Recordings (*.csv *.txt *.log *.tsv)"));
  if (!file.isEmpty()) open_trace(path_of(file));
}

void PlatformView::open_trace(const std::filesystem::path& file) { trace_->open(file); }

// The chosen platform once more, beside itself; a further recording takes that copy's place.
void PlatformView::plan_with_trace() {
  const Device* declared = chosen_device();
  if (declared == nullptr || !trace_->runs()) return;
  const std::string recorded = "-recorded";
  Device device = *declared;
  if (!device.id.ends_with(recorded)) {
    device.id += recorded;
    device.name = tr("%1, as recorded").arg(QString::fromStdString(device.name)).toStdString();
  }
  hardware::take_power_from(*trace_->runs(), device);
  device.idle_W.note += " (" + trace_->file_name().toStdString() + ")";
  device.kernel.active_W.note += " (" + trace_->file_name().toStdString() + ")";
  if (const auto checked = hardware::check(device); !checked) {
    refuse(checked.error());
    return;
  }
  const QString id = QString::fromStdString(device.id);
  add_devices({std::move(device)});
  table_->choose(id);
}

void PlatformView::show_lower_left() {
  trace_->setVisible(trace_open_);
  plot_->setVisible(!trace_open_ && task_->currentIndex() <= 0);
}

// What the convergence study reaches in this tissue; beyond its coarsest end it says nothing.
void PlatformView::set_accuracy_range() {
  const hardware::ConvergenceCurve here = hardware::in_tissue(curve_, youngs_->value());
  const QSignalBlocker quiet(accuracy_);
  accuracy_->set_range(std::ceil(10 * here.points.front().error_mm) / 10,
                       std::max(1.0, std::floor(10 * here.points.back().error_mm) / 10));
}

// What only the dissertation's product asks for: how large a body, how exactly.
void PlatformView::choose_task() {
  const bool product = task_->currentIndex() <= 0;
  for (QWidget* only_then : std::initializer_list<QWidget*>{volume_, youngs_, accuracy_})
    only_then->setEnabled(product);
  show_lower_left();
  replan();
}

void PlatformView::replan() {
  hardware::PlanRequest request;
  request.liver_volume_cm3 = volume_->value();
  request.youngs_kPa = youngs_->value();
  request.accuracy_mm = accuracy_->value();
  request.duration_h = duration_->value();
  request.frames_per_s = frames_->value();
  request.ambient_C = room_->value();
  request.limit_C = limit_->value();
  if (task_->currentIndex() > 0) request.task = tasks_.at(static_cast<std::size_t>(task_->currentIndex() - 1));
  const auto planned = hardware::plan(request, devices_, curve_);
  refusal_->setVisible(!planned);
  if (!planned) {
    plan_.reset();
    refusal_->setText(translated(planned.error()));
    answer_->clear();
    table_->setRowCount(0);
    details_->clear();
    return;
  }
  plan_ = *planned;
  const hardware::Workload& work = plan_->workload;
  workload_->setText(request.task
                         ? tr("A frame of it: %1 MB to move, %2 million operations.")
                               .arg(significant(work.frame_bytes * 1e-6), significant(work.frame_flops * 1e-6))
                         : tr("%1 nodes of %2 mm³. A frame is %3 block products: %4 MB to move, %5 million operations.")
                               .arg(whole(work.nodes), significant(work.resolution_mm3))
                               .arg(work.products_per_frame)
                               .arg(significant(work.frame_bytes * 1e-6), significant(work.frame_flops * 1e-6)));
  const auto best = std::find_if(plan_->platforms.begin(), plan_->platforms.end(),
                                 [&](const DevicePlan& answer) { return plan_->recommended == answer.id; });
  const QString name = best != plan_->platforms.end() ? QString::fromStdString(best->name) : QString();
  answer_->setText(best == plan_->platforms.end()       ? tr("None of these platforms holds.")
                   : best->worn == hardware::Worn::head ? tr("Least obtrusive that holds, on the head: %1").arg(name)
                   : best->worn == hardware::Worn::belt ? tr("Least obtrusive that holds, on the belt: %1").arg(name)
                                                        : tr("Least obtrusive that holds, on the back: %1").arg(name));
  table_->show_plan(*plan_, devices_);
  QStringList notes;
  for (const hardware::Sentence& note : plan_->notes) notes << translated(note);
  notes_->setText(notes.join(" "));
  show_platform();
  show_picture();
}

const Device* PlatformView::chosen_device() const {
  const std::string id = table_->chosen().toStdString();
  const auto found = std::find_if(devices_.begin(), devices_.end(), [&](const Device& d) { return d.id == id; });
  return found != devices_.end() ? &*found : nullptr;
}

void PlatformView::show_platform() {
  const Device* device = chosen_device();
  trace_->set_platform(device != nullptr ? QString::fromStdString(device->name) : QString());
  if (!plan_ || device == nullptr) return;
  const auto answer = std::find_if(plan_->platforms.begin(), plan_->platforms.end(),
                                   [&](const DevicePlan& known) { return known.id == device->id; });
  if (answer != plan_->platforms.end()) details_->setHtml(platform_in_full(*answer, *device, plan_->request));
}

void PlatformView::show_picture() {
  const Device* device = chosen_device();
  if (!plan_ || device == nullptr || plan_->request.task) return;
  const auto surfaces =
      hardware::surfaces_over(grid_around(volume_->value(), plan_->workload.resolution_mm3), *device, plan_->request);
  if (!surfaces) return;
  ContourPicture picture;
  QString quantity_told;
  const double wanted = plan_->request.frames_per_s;
  switch (static_cast<Quantity>(quantity_->currentData().toInt())) {
    case surface_C:
      picture.surface = surfaces->temperature_C;
      quantity_told =
          tr("Surface after %1 h at %2 frames/s (°C)").arg(significant(duration_->value()), significant(wanted));
      picture.contours = {{plan_->request.limit_C, tr("%1 °C").arg(significant(plan_->request.limit_C)), true}};
      // At less than a tenth of a degree nobody would feel it.
      picture.hot_spots = hardware::hot_spots(picture.surface, 0.1);
      break;
    case frames:
      picture.surface = surfaces->fps;
      quantity_told = tr("Frames/s that hold for %1 h").arg(significant(duration_->value()));
      for (const double level : {10.0, 15.0, 20.0, 25.0}) {
        if (level != wanted) picture.contours.push_back({level, tr("%1 /s").arg(level), false});
      }
      picture.contours.push_back({wanted, tr("%1 /s").arg(wanted), true});
      break;
    case battery:
      picture.surface = surfaces->battery_h;
      quantity_told = tr("Battery lasts at %1 frames/s (h)").arg(significant(wanted));
      picture.contours = {{plan_->request.duration_h, tr("%1 h").arg(significant(plan_->request.duration_h)), true}};
      break;
    case power:
      picture.surface = surfaces->power_W;
      quantity_told = tr("Mean power at %1 frames/s (W)").arg(significant(wanted));
      for (const DevicePlan& answer : plan_->platforms) {
        if (answer.id != device->id) continue;
        const double allowed_W = answer.idle.allowed_W * device->supply_efficiency.value;
        picture.contours = {{allowed_W, tr("%1 W: the battery").arg(significant(allowed_W)), true}};
      }
      break;
  }
  picture.case_volume_cm3 = volume_->value();
  picture.case_resolution_mm3 = plan_->workload.resolution_mm3;
  const hardware::ConvergenceCurve here = hardware::in_tissue(curve_, youngs_->value());
  for (const double error_mm : {0.5, 1.0, 1.5, 2.0, 3.0, 5.0, 8.0, 12.0, 20.0, 30.0}) {
    const auto resolution_mm3 = hardware::resolution_for_accuracy_mm3(here, error_mm);
    if (resolution_mm3 && error_mm <= here.points.back().error_mm)
      picture.accuracies.push_back({*resolution_mm3, error_mm});
  }
  quantity_text_->setText(quantity_told);
  contours_->show_picture(picture);
}

}  // namespace glisson::widgets
