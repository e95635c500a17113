#include "widgets/views/view_bar.h"

#include <algorithm>
#include <array>
#include <QHBoxLayout>
#include <QStandardItemModel>

#include "widgets/words/keep_translated.h"
#include "widgets/words/translated.h"

namespace glisson::widgets {
namespace {

constexpr int automatic = static_cast<int>(WindowPreset::automatic);
constexpr int own = static_cast<int>(WindowPreset::own);

}  // namespace

ViewBar::ViewBar(LinkedViews& views, MeasureTool& measure, QWidget* parent)
    : QWidget(parent), views_(views), measure_(measure) {
  setObjectName("view_bar");
  setAttribute(Qt::WA_StyledBackground);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(8, 2, 4, 2);
  row->setSpacing(2);

  for (const auto& [kind, name, icon, key] :
       {std::tuple(MeasureKind::distance, "measure_distance", ":/icons/distance.svg", "Ctrl+Shift+D"),
        std::tuple(MeasureKind::angle, "measure_angle", ":/icons/angle.svg", "Ctrl+Shift+A"),
        std::tuple(MeasureKind::ball, "measure_ball", ":/icons/ball.svg", "Ctrl+Shift+B")}) {
    QAction* action = add_action(name, icon, QKeySequence(key), {});
    action->setCheckable(true);
    connect(action, &QAction::triggered, this,
            [this, kind = kind](bool on) { measure_.begin(on ? std::optional(kind) : std::nullopt); });
    measuring_.push_back(action);
    add_button(action, name);
  }
  connect(&measure_, &MeasureTool::kind_changed, this, [this] {
    for (std::size_t k = 0; k < measuring_.size(); ++k) {
      measuring_[k]->setChecked(measure_.kind() == static_cast<MeasureKind>(k));
    }
  });
  volumes_ = new QMenu(this);
  auto* volumes_button = new QToolButton(this);
  volumes_button->setObjectName("measure_structure");
  volumes_button->setMenu(volumes_);
  volumes_button->setPopupMode(QToolButton::InstantPopup);
  row->addWidget(volumes_button);

  row->addSpacing(10);
  window_name_ = new QLabel(this);
  window_name_->setObjectName("view_name");
  window_name_->setContentsMargins(0, 0, 4, 0);
  row->addWidget(window_name_);
  window_ = new QComboBox(this);
  window_->setObjectName("grey_window");
  window_->setSizeAdjustPolicy(QComboBox::AdjustToContents);  // its words change with the language
  for (int k = 0; k <= own; ++k) window_->addItem({});
  row->addWidget(window_);
  window_text_ = new QLabel(this);
  window_text_->setObjectName("window_told");
  row->addWidget(window_text_);
  connect(window_, &QComboBox::activated, this, [this](int preset) {
    views_.choose_window(static_cast<WindowPreset>(preset));
    tell_window();
  });
  connect(&views_, &LinkedViews::window_shown, this, &ViewBar::tell_window);
  next_window_ = add_action("next_window", "", QKeySequence("Ctrl+Shift+W"), [this] {
    const int count = views_.shows_hounsfield_units() ? own : 1;
    views_.choose_window(static_cast<WindowPreset>((window_->currentIndex() + 1) % (own + 1) % count));
  });

  row->addSpacing(10);
  surgeon_ = add_action("surgeons_side", "", QKeySequence("Ctrl+Shift+R"), [this] { views_.turn_to_surgeon(); });
  straight_ = add_action("straight", "", QKeySequence("Ctrl+Shift+0"), [this] { views_.straighten(); });
  QToolButton* surgeon = add_button(surgeon_, "surgeons_side");
  QToolButton* straight = add_button(straight_, "straight");
  dispensable_ = {volumes_button, straight, surgeon, window_text_, window_name_};
  more_ = new QToolButton(this);
  more_->setObjectName("more");
  more_->setText("»");
  more_->setAutoRaise(true);
  more_->setPopupMode(QToolButton::InstantPopup);
  more_->setMenu(new QMenu(more_));
  more_->menu()->addMenu(volumes_);
  more_->menu()->addActions({surgeon_, straight_});
  row->addWidget(more_);

  row->addStretch();
  auto* group = new QActionGroup(this);
  for (const auto& [layout, name, icon, key] :
       {std::tuple(ViewLayout::square, "layout_square", ":/icons/layout-square.svg", Qt::Key_F5),
        std::tuple(ViewLayout::space_large, "layout_space", ":/icons/layout-space.svg", Qt::Key_F6),
        std::tuple(ViewLayout::slices_in_a_row, "layout_row", ":/icons/layout-row.svg", Qt::Key_F7),
        std::tuple(ViewLayout::one, "layout_one", ":/icons/layout-one.svg", Qt::Key_F8)}) {
    QAction* action = add_action(name, icon, QKeySequence(key), {});
    action->setCheckable(true);
    group->addAction(action);
    connect(action, &QAction::triggered, this, [this, layout = layout] { views_.set_layout(layout); });
    layouts_.push_back(action);
    add_button(action, name);
  }
  group->setExclusionPolicy(QActionGroup::ExclusionPolicy::ExclusiveOptional);
  const auto show_layout = [this] {
    for (std::size_t k = 0; k < layouts_.size(); ++k) {
      layouts_[k]->setChecked(views_.view_layout() == static_cast<ViewLayout>(k));
    }
  };
  connect(&views_, &LinkedViews::layout_changed, this, show_layout);
  show_layout();
  save_ = add_action("save_view", "", QKeySequence("Ctrl+Shift+S"), [this] { views_.save_view_in_use(); });

  keep_translated(this, [=, this] {
    measuring_[0]->setText(tr("Measure a &distance"));
    measuring_[0]->setToolTip(
        tr("A distance in mm: click its two ends, or press Enter at the crosshair; Escape gives up"));
    measuring_[1]->setText(tr("Measure an &angle"));
    measuring_[1]->setToolTip(tr("An angle in degrees: click one side, the vertex, the other side"));
    measuring_[2]->setText(tr("Measure a &ball"));
    measuring_[2]->setToolTip(tr("A ball's volume in ml: click its centre, then a point of its surface"));
    volumes_button->setText(tr("Volume"));
    volumes_button->setToolTip(tr("Lists the volume of a structure, in ml"));
    volumes_->setTitle(tr("&Volume of"));
    list_volumes();
    window_->setItemText(automatic, tr("Automatic"));
    window_->setItemText(1, tr("Abdomen"));
    window_->setItemText(2, tr("Liver"));
    window_->setItemText(3, tr("Lung"));
    window_->setItemText(4, tr("Bone"));
    window_->setItemText(own, tr("Own"));
    window_name_->setText(tr("Window"));
    tell_window();
    window_->setToolTip(
        tr("Brightness and contrast of the slices. The presets are for CT; MR has no fixed scale.\n"
           "By hand: drag with the right button"));
    window_->setAccessibleName(tr("Brightness and contrast"));
    next_window_->setText(tr("&Next brightness and contrast"));
    surgeon_->setText(tr("Surgeon's &side"));
    surgeon_->setToolTip(
        tr("Turns the three slices to where the surgeon stands. By hand: drag the knobs of the crosshair, "
           "or Ctrl and drag"));
    straight_->setText(tr("S&tandard planes"));
    straight_->setToolTip(tr("Transverse, coronal and sagittal slices again"));
    more_->setToolTip(tr("What there is no room for here"));
    more_->setAccessibleName(more_->toolTip());
    layouts_[0]->setText(tr("&Four views"));
    layouts_[1]->setText(tr("3D &large"));
    layouts_[2]->setText(tr("T&hree slices side by side"));
    layouts_[3]->setText(tr("&One view: the one in use"));
    save_->setText(tr("Save the &picture of the view in use..."));
    for (QAction* action : actions()) {
      const QString key = action->shortcut().toString(QKeySequence::NativeText);
      QString tip = action->toolTip();
      if (tip.isEmpty() || tip == action->text()) tip = QString(action->text()).remove('&');
      if (!tip.contains(key)) action->setToolTip(tr("%1 (%2)").arg(tip, key));
    }
    fit();
  });
}

QSize ViewBar::minimumSizeHint() const {
  return {width_without(dispensable_.size()), QWidget::minimumSizeHint().height()};
}

void ViewBar::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  fit();
}

void ViewBar::fit() {
  std::size_t gone = 0;
  while (gone < dispensable_.size() && width_without(gone) > width()) ++gone;
  for (std::size_t k = 0; k < dispensable_.size(); ++k) dispensable_[k]->setVisible(k >= gone);
  more_->setVisible(gone > 0);
}

int ViewBar::width_without(std::size_t dispensable) const {
  const auto gone_end = dispensable_.begin() + static_cast<std::ptrdiff_t>(dispensable);
  const QMargins margins = layout()->contentsMargins();
  int width = margins.left() + margins.right();
  for (int k = 0; k < layout()->count(); ++k) {
    QWidget* widget = layout()->itemAt(k)->widget();
    const bool gone =
        std::find(dispensable_.begin(), gone_end, widget) != gone_end || (widget == more_ && dispensable == 0);
    if (gone) continue;
    width += widget != nullptr ? widget->sizeHint().width() + layout()->spacing()
                               : layout()->itemAt(k)->minimumSize().width();
  }
  return width;
}

QAction* ViewBar::add_action(const char* name, const char* icon, const QKeySequence& key, std::function<void()> act) {
  auto* action = new QAction(QIcon(icon), {}, this);
  action->setObjectName(name);
  action->setShortcut(key);
  addAction(action);
  if (act) connect(action, &QAction::triggered, this, [act = std::move(act)] { act(); });
  return action;
}

QToolButton* ViewBar::add_button(QAction* action, const char* name) {
  auto* button = new QToolButton(this);
  button->setObjectName(QString(name) + "_button");
  button->setDefaultAction(action);
  button->setAutoRaise(true);
  if (action->icon().isNull()) button->setToolButtonStyle(Qt::ToolButtonTextOnly);
  static_cast<QHBoxLayout*>(layout())->addWidget(button);
  return button;
}

void ViewBar::show_patient(const Patient& patient) {
  structures_ = patient.all_structures();
  list_volumes();
}

// What is shown now, and which of the presets that is.
void ViewBar::tell_window() {
  const bool hounsfield = views_.shows_hounsfield_units();
  auto* items = qobject_cast<QStandardItemModel*>(window_->model());
  for (int k = automatic + 1; k < own; ++k) items->item(k)->setEnabled(hounsfield);
  items->item(own)->setEnabled(views_.window_preset() == WindowPreset::own);
  window_->setCurrentIndex(static_cast<int>(views_.window_preset()));
  const GreyWindow window = views_.window();
  const int digits = window.width < 20 ? 1 : 0;
  window_text_->setText(tr("W %1  L %2").arg(window.width, 0, 'f', digits).arg(window.center, 0, 'f', digits));
  fit();
}

void ViewBar::list_volumes() {
  volumes_->clear();
  for (const PatientStructure& structure : structures_) {
    volumes_->addAction(structure_label(structure.name), this, [this, structure] {
      measure_.add({MeasureKind::structure, {}, structure.name, structure.volume_ml});
    });
  }
  volumes_->setEnabled(!structures_.empty());
}

void ViewBar::fill(QMenu& menu) {
  for (QAction* action : layouts_) menu.addAction(action);
  menu.addSeparator();
  for (QAction* action : measuring_) menu.addAction(action);
  menu.addMenu(volumes_);
  menu.addSeparator();
  for (QAction* action : {next_window_, surgeon_, straight_, save_}) menu.addAction(action);
}

}  // namespace glisson::widgets
