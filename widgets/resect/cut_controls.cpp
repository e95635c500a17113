#include "widgets/resect/cut_controls.h"

#include <QFormLayout>
#include <QHBoxLayout>
#include <QVBoxLayout>

#include "widgets/panels/parts.h"
#include "widgets/words/keep_translated.h"

namespace glisson::widgets {
namespace {

NumberBox* number_box(double minimum, double maximum, double step, const char* name, QWidget* parent) {
  auto* box = new NumberBox(parent);
  box->setObjectName(name);
  box->setRange(minimum, maximum);
  box->setDecimals(1);
  box->setSingleStep(step);
  return box;
}

}  // namespace

CutControls::CutControls(QWidget* parent) : QWidget(parent) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(8);
  kind_ = new QComboBox(this);
  kind_->setObjectName("cut_kind");
  kind_->addItem({}, plane_cut);
  kind_->addItem({}, sheet_cut);
  column->addWidget(kind_);
  kinds_ = new QStackedWidget(this);
  kinds_->addWidget(make_plane());
  kinds_->addWidget(make_sheet());
  column->addWidget(kinds_);
  connect(kind_, &QComboBox::activated, this, [this](int kind) {
    stop_drawing();
    kinds_->setCurrentIndex(kind);
    Q_EMIT kind_chosen();
    if (kind == sheet_cut && points_ == 0) draw_->setChecked(true);
  });
  keep_translated(this, [this] {
    kind_->setItemText(plane_cut, tr("Cut by a plane"));
    kind_->setItemText(sheet_cut, tr("Cut by a smooth surface through points"));
    update_points_text();
  });
}

QWidget* CutControls::make_plane() {
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
  through_crosshair_ = named_button("cut_through_crosshair", group);
  by_clicks_ = named_button("cut_by_clicks", group);
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
    connect(box, &NumberBox::valueChanged, this,
            [this] { Q_EMIT plane_typed(shift_->value(), turn_->value(), tilt_->value()); });
  }
  connect(through_crosshair_, &QPushButton::clicked, this, [this] {
    by_clicks_->setChecked(false);
    const std::array<Eigen::Vector3d, 3> normals{Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitY(),
                                                 Eigen::Vector3d::UnitZ()};
    Q_EMIT through_crosshair(normals[static_cast<std::size_t>(across_->currentData().toInt())]);
  });
  connect(by_clicks_, &QPushButton::toggled, this, &CutControls::drawing_changed);
  keep_translated(group, [=, this] {
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

QWidget* CutControls::make_sheet() {
  auto* group = new QWidget;
  auto* column = new QVBoxLayout(group);
  column->setContentsMargins(0, 0, 0, 0);
  draw_ = named_button("cut_draw", group);
  draw_->setCheckable(true);
  freehand_ = named_button("cut_freehand", group);
  freehand_->setCheckable(true);
  drop_last_ = named_button("cut_drop_last", group);
  clear_ = named_button("cut_clear", group);
  auto* row = new QHBoxLayout;
  for (QPushButton* each : {draw_, freehand_}) row->addWidget(each);
  column->addLayout(row);
  auto* fewer = new QHBoxLayout;
  for (QPushButton* each : {drop_last_, clear_}) fewer->addWidget(each);
  column->addLayout(fewer);
  points_text_ = new QLabel(group);
  points_text_->setObjectName("faint");
  points_text_->setWordWrap(true);
  column->addWidget(points_text_);
  column->addStretch(1);
  connect(draw_, &QPushButton::toggled, this, [this](bool on) {
    if (on) freehand_->setChecked(false);
    Q_EMIT drawing_changed(drawing());
  });
  connect(freehand_, &QPushButton::toggled, this, [this](bool on) {
    if (on) draw_->setChecked(false);
    Q_EMIT drawing_changed(drawing());
  });
  connect(drop_last_, &QPushButton::clicked, this, &CutControls::last_dropped);
  connect(clear_, &QPushButton::clicked, this, &CutControls::cleared);
  keep_translated(group, [this] {
    draw_->setText(tr("Set points"));
    draw_->setToolTip(tr("Each click on the liver or in a slice sets a point; points can be dragged"));
    freehand_->setText(tr("Draw a line"));
    freehand_->setToolTip(tr(
        "Then draw over the liver in the 3D view with the left button held: the cut goes straight down under the line, "
        "as it is seen from there"));
    drop_last_->setText(tr("Drop the last"));
    clear_->setText(tr("Clear"));
  });
  return group;
}

void CutControls::choose(Kind kind) {
  stop_drawing();
  kind_->setCurrentIndex(kind);
  kinds_->setCurrentIndex(kind);
}

void CutControls::stop_drawing() {
  by_clicks_->setChecked(false);
  draw_->setChecked(false);
  freehand_->setChecked(false);
}

void CutControls::show_plane(const std::optional<CutPlane>& plane) {
  for (NumberBox* box : {shift_, turn_, tilt_}) {
    const QSignalBlocker quiet(box);
    box->setEnabled(plane.has_value());
    if (plane) box->setValue(box == shift_ ? plane->shift_mm : box == turn_ ? plane->turn_deg : plane->tilt_deg);
  }
}

void CutControls::show_points(std::size_t count) {
  points_ = count;
  drop_last_->setEnabled(count > 0);
  clear_->setEnabled(count > 0);
  update_points_text();
}

void CutControls::update_points_text() {
  points_text_->setText(
      (points_ < 3 ? tr("Points set: %1. Three are needed.") : tr("Points set: %1. Drag them in any view."))
          .arg(points_));
}

}  // namespace glisson::widgets
