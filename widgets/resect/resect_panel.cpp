#include "resect/resect_panel.h"

#include <Eigen/Geometry>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QScrollArea>
#include <QVBoxLayout>

#include "words/told.h"
#include "words/worded.h"

namespace glisson::widgets {
namespace {

using Eigen::Vector3d;
using Removed = casefile::PlannedCut::Removed;

constexpr scene::Colour cut_colour{0.20, 0.83, 0.85};
constexpr int farthest_apart_mm = 80;

NumberBox* number_box(double least, double most, double step, const char* name, QWidget* parent) {
  auto* box = new NumberBox(parent);
  box->setObjectName(name);
  box->setRange(least, most);
  box->setDecimals(1);
  box->setSingleStep(step);
  box->setKeyboardTracking(false);
  return box;
}

QPushButton* button(const char* name, QWidget* parent) {
  auto* made = new QPushButton(parent);
  made->setObjectName(name);
  return made;
}

QLabel* heading(QWidget* parent) {
  auto* label = new QLabel(parent);
  label->setObjectName("heading");
  return label;
}

std::filesystem::path folder_of_plan(const Patient& patient) { return patient.folder / "results" / "resection"; }

}  // namespace

ResectPanel::ResectPanel(Bench bench, QWidget* parent) : QWidget(parent), bench_(std::move(bench)) {
  setObjectName("panel");
  live_ = new LiveResection(this);
  handles_ = new CutHandles(bench_.views, this);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(14, 14, 4, 14);
  column->setSpacing(8);
  QLabel* title = heading(this);
  column->addWidget(title);
  missing_ = new QLabel(this);
  missing_->setObjectName("faint");
  missing_->setWordWrap(true);
  column->addWidget(missing_);
  auto* scroll = new QScrollArea(this);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  controls_ = new QWidget;
  controls_->setObjectName("panel");
  scroll->setWidget(controls_);
  column->addWidget(scroll, 1);
  auto* inner = new QVBoxLayout(controls_);
  inner->setContentsMargins(0, 0, 10, 0);
  inner->setSpacing(8);

  kind_ = new QComboBox(controls_);
  kind_->setObjectName("cut_kind");
  kind_->addItem({}, plane_cut);
  kind_->addItem({}, sheet_cut);
  inner->addWidget(kind_);
  kinds_ = new QStackedWidget(controls_);
  kinds_->addWidget(make_plane_controls());
  kinds_->addWidget(make_sheet_controls());
  inner->addWidget(kinds_);
  inner->addWidget(make_outcome());
  inner->addStretch(1);

  connect(kind_, &QComboBox::activated, this, &ResectPanel::choose_kind);
  connect(handles_, &CutHandles::plane_moved, this, &ResectPanel::move_plane);
  connect(handles_, &CutHandles::point_clicked, this, &ResectPanel::take_click);
  connect(handles_, &CutHandles::point_moved, this, [this](std::size_t point, const Vector3d& position_mm) {
    if (point >= points_mm_.size()) return;
    points_mm_[point] = position_mm;
    cut_changed();
  });
  connect(&bench_.views.space(), &SpaceView::clicked, this, [this](const scene::View::Pick& pick) {
    if (isVisible() && (by_clicks_->isChecked() || draw_->isChecked())) take_click(pick.position_mm);
  });
  connect(&bench_.patient_views, &PatientViews::slices_rebuilt, handles_, &CutHandles::draw_in_slices);
  connect(live_, &LiveResection::changed, this, &ResectPanel::show_result);
  worded(this, [=, this] {
    title->setText(tr("Plan a resection"));
    missing_->setText(tr("Needs a model of the liver. Build it first, or open the demo patient."));
    kind_->setItemText(plane_cut, tr("Cut by a plane"));
    kind_->setItemText(sheet_cut, tr("Cut by a smooth surface through points"));
    word_state();
    show_result();
  });
}

Workspace ResectPanel::workspace(Bench bench) {
  auto* panel = new ResectPanel(std::move(bench));
  return {.id = "resect",
          .name = [] { return tr("Resect"); },
          .about = [] { return tr("Set a cut: what goes, what stays, how near the tumours it passes."); },
          .widget = panel,
          .show_patient = [panel](const Patient& patient) { panel->show_patient(patient); },
          .missing =
              [](const Patient& patient) {
                return patient.rehearsal ? QString() : tr("Needs a model of the liver: build it first.");
              }};
}

QWidget* ResectPanel::make_plane_controls() {
  auto* group = new QWidget;
  auto* form = new QFormLayout(group);
  form->setContentsMargins(0, 0, 0, 0);
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  form->setLabelAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  across_ = new QComboBox(group);
  across_->setObjectName("cut_across");
  for (const Across across : {across_left, across_front, across_head}) across_->addItem({}, across);
  auto* across_name = new QLabel(group);
  form->addRow(across_name, across_);
  through_crosshair_ = button("cut_through_crosshair", group);
  by_clicks_ = button("cut_by_clicks", group);
  by_clicks_->setCheckable(true);
  auto* places = new QHBoxLayout;
  places->addWidget(through_crosshair_);
  places->addWidget(by_clicks_);
  form->addRow(places);
  shift_ = number_box(-400, 400, 1, "cut_shift", group);
  turn_ = number_box(-180, 180, 2, "cut_turn", group);
  turn_->setWrapping(true);
  tilt_ = number_box(-90, 90, 2, "cut_tilt", group);
  std::array<QLabel*, 3> names{};
  for (std::size_t k = 0; NumberBox * box : {shift_, turn_, tilt_}) {
    names[k] = new QLabel(group);
    names[k]->setBuddy(box);
    form->addRow(names[k++], box);
    connect(box, &QDoubleSpinBox::valueChanged, this, &ResectPanel::type_plane);
  }
  connect(through_crosshair_, &QPushButton::clicked, this, &ResectPanel::put_plane_through_crosshair);
  connect(by_clicks_, &QPushButton::toggled, this, &ResectPanel::set_drawing);
  worded(group, [=, this] {
    across_name->setText(tr("Divides"));
    across_->setItemText(across_left, tr("left from right"));
    across_->setItemText(across_front, tr("front from back"));
    across_->setItemText(across_head, tr("head from foot"));
    through_crosshair_->setText(tr("Through crosshair"));
    through_crosshair_->setToolTip(tr("Puts the plane through the crosshair, across the direction above"));
    by_clicks_->setText(tr("By three clicks"));
    by_clicks_->setToolTip(tr("Then click three places on the liver or in the slices"));
    names[0]->setText(tr("Shift"));
    names[1]->setText(tr("Turn"));
    names[2]->setText(tr("Tilt"));
    shift_->setSuffix(tr(" mm"));
    for (NumberBox* box : {turn_, tilt_}) box->setSuffix(tr("°"));
    shift_->setToolTip(tr("Distance of the plane from the middle of the liver, along its normal"));
    turn_->setToolTip(tr("The normal about the axis from feet to head: 0° to the patient's left, 90° to the back"));
    tilt_->setToolTip(tr("The normal upwards: 90° to the head"));
  });
  return group;
}

QWidget* ResectPanel::make_sheet_controls() {
  auto* group = new QWidget;
  auto* column = new QVBoxLayout(group);
  column->setContentsMargins(0, 0, 0, 0);
  draw_ = button("cut_draw", group);
  draw_->setCheckable(true);
  drop_last_ = button("cut_drop_last", group);
  clear_ = button("cut_clear", group);
  auto* row = new QHBoxLayout;
  for (QPushButton* each : {draw_, drop_last_, clear_}) row->addWidget(each);
  column->addLayout(row);
  points_told_ = new QLabel(group);
  points_told_->setObjectName("faint");
  points_told_->setWordWrap(true);
  column->addWidget(points_told_);
  column->addStretch(1);
  connect(draw_, &QPushButton::toggled, this, &ResectPanel::set_drawing);
  connect(drop_last_, &QPushButton::clicked, this, [this] {
    auto fewer_mm = points_mm_;
    if (!fewer_mm.empty()) fewer_mm.pop_back();
    set_points(std::move(fewer_mm));
  });
  connect(clear_, &QPushButton::clicked, this, [this] { set_points({}); });
  worded(group, [this] {
    draw_->setText(tr("Set points"));
    draw_->setToolTip(tr("Each click on the liver or in a slice sets a point; points can be dragged"));
    drop_last_->setText(tr("Drop the last"));
    clear_->setText(tr("Clear"));
  });
  return group;
}

QWidget* ResectPanel::make_outcome() {
  auto* group = new QWidget;
  auto* column = new QVBoxLayout(group);
  column->setContentsMargins(0, 6, 0, 0);
  column->setSpacing(8);
  results_ = new ResectionResults(group);
  column->addWidget(results_);
  auto* apart_name = new QLabel(group);
  apart_ = new QSlider(Qt::Horizontal, group);
  apart_->setObjectName("apart");
  apart_->setRange(0, farthest_apart_mm);
  apart_name->setBuddy(apart_);
  auto* row = new QHBoxLayout;
  row->addWidget(apart_name);
  row->addWidget(apart_, 1);
  column->addLayout(row);
  other_part_ = button("other_part", group);
  no_cut_ = button("no_cut", group);
  auto* choices = new QHBoxLayout;
  choices->addWidget(other_part_);
  choices->addWidget(no_cut_);
  column->addLayout(choices);
  save_ = button("primary", group);
  column->addWidget(save_);
  connect(apart_, &QSlider::valueChanged, this, [this](int apart_mm) {
    pieces_.draw_apart(bench_.views.space().view(), apart_mm);
    bench_.views.space().redraw();
  });
  connect(other_part_, &QPushButton::clicked, this, [this] {
    removed_ = removed_ == Removed::smaller ? Removed::larger : Removed::smaller;
    cut_changed();
  });
  connect(no_cut_, &QPushButton::clicked, this, [this] {
    plane_.reset();
    points_mm_.clear();
    clicks_mm_.clear();
    cut_changed();
  });
  connect(save_, &QPushButton::clicked, this, &ResectPanel::save);
  worded(group, [=, this] {
    apart_name->setText(tr("Apart"));
    apart_->setToolTip(tr("Draws the part that is removed away from the rest"));
    other_part_->setText(tr("Remove the other part"));
    no_cut_->setText(tr("No cut"));
    save_->setText(tr("Save this plan in the case"));
  });
  return group;
}

void ResectPanel::show_patient(const Patient& patient) {
  const bool other = patient.folder != patient_.folder || patient.name != patient_.name;
  patient_ = patient;
  missing_->setVisible(!patient.rehearsal);
  controls_->setVisible(patient.rehearsal != nullptr);
  live_->set_patient(patient);
  if (other) {
    plane_.reset();
    points_mm_.clear();
    clicks_mm_.clear();
    removed_ = Removed::smaller;
    kind_->setCurrentIndex(plane_cut);
    kinds_->setCurrentIndex(plane_cut);
    const auto kept = patient.folder.empty() ? Result<casefile::PlannedCut>(tl::unexpected(Error{}))
                                             : casefile::read_planned_cut(folder_of_plan(patient));
    if (kept && patient.rehearsal) {
      removed_ = kept->removed;
      points_mm_ = kept->through_mm;
      kind_->setCurrentIndex(points_mm_.empty() ? plane_cut : sheet_cut);
      kinds_->setCurrentIndex(kind_->currentIndex());
      if (points_mm_.empty()) {
        plane_ = CutPlane{geometry::bounding_box(patient.structures.front().surface->points_mm).center_mm(), 0, 0, 0};
        plane_->put(kept->point_mm, kept->normal);
      }
    }
  }
  cut_changed();
}

void ResectPanel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  handles_->set_active(true);
  show_scene();
}

void ResectPanel::hideEvent(QHideEvent* event) {
  by_clicks_->setChecked(false);
  draw_->setChecked(false);
  handles_->set_active(false);
  bench_.patient_views.set_workspace_scene({});
  QWidget::hideEvent(event);
}

void ResectPanel::put_plane_through_crosshair() {
  if (patient_.structures.empty()) return;
  const std::array<Vector3d, 3> normals{Vector3d::UnitX(), Vector3d::UnitY(), Vector3d::UnitZ()};
  CutPlane plane{geometry::bounding_box(patient_.structures.front().surface->points_mm).center_mm(), 0, 0, 0};
  plane.put(bench_.views.crosshair_mm(), normals[static_cast<std::size_t>(across_->currentData().toInt())]);
  by_clicks_->setChecked(false);
  move_plane(plane);
}

void ResectPanel::take_click(const Vector3d& position_mm) {
  if (draw_->isChecked()) {
    auto more_mm = points_mm_;
    more_mm.push_back(position_mm);
    set_points(std::move(more_mm));
    return;
  }
  if (!by_clicks_->isChecked()) return;
  clicks_mm_.push_back(position_mm);
  if (clicks_mm_.size() == 3) {
    const Vector3d normal = (clicks_mm_[1] - clicks_mm_[0]).cross(clicks_mm_[2] - clicks_mm_[0]);
    const Vector3d through_mm = clicks_mm_[0];
    const double widest_mm = (clicks_mm_[1] - clicks_mm_[0]).norm() * (clicks_mm_[2] - clicks_mm_[0]).norm();
    if (normal.norm() < 0.02 * widest_mm || patient_.structures.empty()) {
      clicks_mm_.clear();
      bench_.tell_status(tr("The three places lie almost on one line. Click three others."));
    } else {
      CutPlane plane{geometry::bounding_box(patient_.structures.front().surface->points_mm).center_mm(), 0, 0, 0};
      plane.put(through_mm, normal);
      plane_ = plane;
      by_clicks_->setChecked(false);
    }
  }
  cut_changed();
}

void ResectPanel::type_plane() {
  if (!plane_) return;
  CutPlane plane = *plane_;
  plane.shift_mm = shift_->value();
  plane.turn_deg = turn_->value();
  plane.tilt_deg = tilt_->value();
  move_plane(plane);
}

void ResectPanel::move_plane(const CutPlane& plane) {
  plane_ = plane;
  cut_changed();
}

void ResectPanel::set_points(std::vector<Vector3d> points_mm) {
  points_mm_ = std::move(points_mm);
  cut_changed();
}

void ResectPanel::choose_kind(int kind) {
  kinds_->setCurrentIndex(kind);
  by_clicks_->setChecked(false);
  draw_->setChecked(false);
  cut_changed();
  if (kind == sheet_cut && points_mm_.empty()) draw_->setChecked(true);
}

void ResectPanel::set_drawing(bool drawing) {
  clicks_mm_.clear();
  handles_->set_drawing(drawing);
  if (drawing) apart_->setValue(0);
  bench_.tell_status(!drawing                  ? QString()
                     : by_clicks_->isChecked() ? tr("Click three places on the liver or in the slices.")
                                               : tr("Click on the liver or in the slices where the cut is to pass."));
  cut_changed();
}

std::optional<casefile::PlannedCut> ResectPanel::cut() const {
  casefile::PlannedCut cut;
  cut.removed = removed_;
  if (kind_->currentIndex() == sheet_cut) {
    if (points_mm_.size() < 3) return {};
    cut.through_mm = points_mm_;
  } else {
    if (!plane_ || by_clicks_->isChecked()) return {};
    cut.point_mm = plane_->point_mm();
    cut.normal = plane_->normal();
  }
  return cut;
}

void ResectPanel::cut_changed() {
  const bool by_plane = kind_->currentIndex() == plane_cut;
  const auto shown = by_plane && !by_clicks_->isChecked() ? plane_ : std::nullopt;
  handles_->set_plane(shown);
  handles_->set_points(by_plane ? clicks_mm_ : points_mm_);
  if (shown && square_) {
    // Where it was drawn it moves along; the plan follows when it is made.
    const auto corners = corners_mm(*shown, reach_mm());
    const std::vector<Vector3d> moved_mm(corners.begin(), corners.end());
    bench_.views.space().view().move_surface(square_, moved_mm);
    for (SliceView* slice : bench_.views.slices()) slice->view().move_surface(square_, moved_mm);
  }
  live_->set_cut(cut());
  word_state();
  if (!live_->result() || !square_ || !shown) show_scene();
  bench_.views.redraw();
}

void ResectPanel::show_result() {
  results_->show(live_->result().get(), live_->problem() ? told(*live_->problem()) : why_nothing());
  pieces_ = ResectionScene(live_->result());
  show_scene();
  word_state();
}

void ResectPanel::show_scene() {
  if (!isVisible()) return;
  WorkspaceScene scene;
  const bool drawing = by_clicks_->isChecked() || draw_->isChecked();
  const bool in_parts = live_->result() != nullptr && !drawing;
  scene.patient = in_parts ? WorkspaceScene::Patient::at_rest_in_slices_only : WorkspaceScene::Patient::at_rest;
  if (in_parts) {
    pieces_.add_to(scene);
    scene.key = {{specimen_colour(), tr("Removed").toStdString()}, {remnant_colour(), tr("Stays").toStdString()}};
  }
  if (kind_->currentIndex() == plane_cut && plane_ && !by_clicks_->isChecked()) {
    square_ = std::make_shared<geometry::Surface>(square_of(*plane_, reach_mm()));
    scene.surfaces.push_back({"cut", square_, cut_colour, 0.14, scene::Finish::solid, {}});
    scene.cuts.push_back({square_, cut_colour, 2.0});
  } else {
    square_.reset();
    if (live_->result()) {
      scene.cuts.push_back({std::make_shared<geometry::Surface>(live_->result()->plan.cut), cut_colour, 2.0});
    }
  }
  scene.marks = handles_->marks_in_space();
  scene.arrows = handles_->arrows_in_space();
  bench_.patient_views.set_workspace_scene(std::move(scene));
  if (in_parts) pieces_.draw_apart(bench_.views.space().view(), apart_->value());
  handles_->draw_in_slices();
}

void ResectPanel::word_state() {
  for (NumberBox* box : {shift_, turn_, tilt_}) {
    const QSignalBlocker quiet(box);
    box->setEnabled(plane_.has_value());
    if (plane_) box->setValue(box == shift_ ? plane_->shift_mm : box == turn_ ? plane_->turn_deg : plane_->tilt_deg);
  }
  points_told_->setText((points_mm_.size() < 3 ? tr("Points set: %1. Three are needed.")
                                               : tr("Points set: %1. Drag them in any view."))
                            .arg(points_mm_.size()));
  drop_last_->setEnabled(!points_mm_.empty());
  clear_->setEnabled(!points_mm_.empty());
  const bool planned = live_->result() != nullptr;
  for (QWidget* each : std::initializer_list<QWidget*>{apart_, other_part_}) each->setEnabled(planned);
  no_cut_->setEnabled(plane_ || !points_mm_.empty());
  save_->setEnabled(planned && !patient_.folder.empty());
  save_->setToolTip(patient_.folder.empty() ? tr("This patient is not kept in a case folder")
                    : planned               ? tr("Writes resection.json, parts.vtu and cut.vtp into results/resection")
                                            : tr("Needs a cut through the liver"));
}

QString ResectPanel::why_nothing() const {
  if (live_->result()) return {};
  if (kind_->currentIndex() == sheet_cut) {
    return tr("Set three or more points where the cut is to pass: on the liver, or in the slices.");
  }
  if (by_clicks_->isChecked()) return tr("Click three places through which the plane is to pass.");
  return plane_ ? tr("Planning...")
                : tr("Put the crosshair where the cut is to pass, then the plane through it. "
                     "Drag its line in a slice to shift it, a line's end to tilt it.");
}

double ResectPanel::reach_mm() const {
  if (patient_.structures.empty()) return 100;
  return 0.5 * geometry::bounding_box(patient_.structures.front().surface->points_mm).diagonal_mm();
}

void ResectPanel::save() {
  const auto result = live_->result();
  if (!result || patient_.folder.empty()) return;
  const bool begun =
      bench_.work.start(tr("Saving the plan"), [this, result, folder = folder_of_plan(patient_)](const Progress&) {
        auto written = std::make_shared<Result<void>>(casefile::write_resection(folder, result->cut, result->plan));
        return BackgroundWork::Then([this, written, folder] {
          if (!*written) {
            bench_.tell_error(written->error());
          } else {
            bench_.tell_status(tr("The plan is in %1").arg(QString::fromStdU16String(folder.u16string())));
          }
        });
      });
  if (!begun) bench_.tell_status(tr("Something else is still under way. Wait for it, or cancel it first."));
}

}  // namespace glisson::widgets
