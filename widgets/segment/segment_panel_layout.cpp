// What stands where in the Segment workspace, and its words.

#include <QGridLayout>
#include <QHeaderView>
#include <QVBoxLayout>

#include "widgets/panels/parts.h"

#include "widgets/segment/segment_panel.h"

namespace glisson::widgets {
namespace {

constexpr int across = 3;  // buttons beside each other

QWidget* page_of(QLayout* layout) {
  auto* page = new QWidget;
  layout->setContentsMargins(0, 0, 0, 0);
  page->setLayout(layout);
  return page;
}

}  // namespace

QWidget* SegmentPanel::make_list() {
  auto* column = new QVBoxLayout;
  column->setSpacing(6);
  column->addWidget(list_title_ = heading());
  list_ = new QTreeWidget;
  list_->setObjectName("segment_structures");
  list_->setColumnCount(2);
  list_->header()->setStretchLastSection(false);
  list_->header()->setSectionResizeMode(0, QHeaderView::Stretch);
  list_->header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
  list_->setRootIsDecorated(false);
  list_->setUniformRowHeights(true);
  list_->setMinimumHeight(150);
  column->addWidget(list_, 1);
  auto* row = new QHBoxLayout;
  for (QPushButton** button : {&add_, &rename_}) {
    *button = new QPushButton;
    (*button)->setMenu(new QMenu(*button));
    row->addWidget(*button, 1);
  }
  add_->setObjectName("add_structure");
  rename_->setObjectName("rename_structure");
  remove_ = new QPushButton;
  remove_->setObjectName("remove_structure");
  row->addWidget(remove_, 1);
  column->addLayout(row);
  return page_of(column);
}

QWidget* SegmentPanel::make_tools() {
  auto* grid = new QGridLayout;
  grid->setSpacing(6);
  grid->addWidget(tools_title_ = heading(), 0, 0, 1, across);
  tool_buttons_ = new QButtonGroup(this);
  const std::array<std::pair<const char*, Qt::Key>, 7> tools{{{"tool_none", Qt::Key_N},
                                                              {"tool_brush", Qt::Key_B},
                                                              {"tool_eraser", Qt::Key_E},
                                                              {"tool_smart_brush", Qt::Key_M},
                                                              {"tool_scissors", Qt::Key_S},
                                                              {"tool_seeds", Qt::Key_G},
                                                              {"tool_piece", Qt::Key_I}}};
  for (std::size_t k = 0; k < tools.size(); ++k) {
    auto* button = new QPushButton;
    button->setObjectName(tools[k].first);
    button->setCheckable(true);
    button->setProperty("key", QKeySequence(tools[k].second).toString());
    tool_buttons_->addButton(button, static_cast<int>(k));
    const int n = static_cast<int>(k);
    grid->addWidget(button, 1 + n / across, n % across);
  }
  for (int k = 0; k < across; ++k) grid->setColumnStretch(k, 1);
  return page_of(grid);
}

QWidget* SegmentPanel::make_options() {
  options_ = new QStackedWidget;
  auto* nothing = new QVBoxLayout;
  option_hint_ = new QLabel;
  option_hint_->setObjectName("faint");
  option_hint_->setWordWrap(true);
  nothing->addWidget(option_hint_);
  nothing->addStretch();
  options_->addWidget(page_of(nothing));

  auto* brush = new QVBoxLayout;
  brush->setSpacing(6);
  shape_ = new QComboBox;
  shape_->setObjectName("brush_shape");
  shape_->addItems({{}, {}});
  brush->addWidget(shape_);
  brush->addWidget(radius_title_ = new QLabel);
  radius_ = new NumberSlider(minimum_radius_mm, maximum_radius_mm, 0.5, 1);
  radius_->setObjectName("brush_radius");
  radius_->set_suffix(" mm");
  radius_->set_value(tools_.options().radius_mm);
  brush->addWidget(radius_);
  auto* like = new QVBoxLayout;
  like->addWidget(likeness_title_ = new QLabel);
  likeness_ = new NumberSlider(0.5, 6, 0.1, 1);
  likeness_->setObjectName("likeness");
  likeness_->set_value(tools_.options().likeness);
  like->addWidget(likeness_);
  brush->addWidget(likeness_row_ = page_of(like));
  brush->addStretch();
  options_->addWidget(page_of(brush));

  auto* cut = new QVBoxLayout;
  cut->setSpacing(6);
  cut_side_ = new QComboBox;
  cut_side_->setObjectName("cut_side");
  cut_side_->addItems({{}, {}});
  cut_depth_ = new QComboBox;
  cut_depth_->setObjectName("cut_depth");
  cut_depth_->addItems({{}, {}, {}, {}, {}});
  cut_depth_mm_ = new NumberSlider(1, 100, 1, 0);
  cut_depth_mm_->setObjectName("cut_depth_mm");
  cut_depth_mm_->set_suffix(" mm");
  cut_depth_mm_->set_value(tools_.options().depth_mm);
  cut->addWidget(cut_side_);
  cut->addWidget(cut_depth_);
  cut->addWidget(cut_depth_mm_);
  cut->addStretch();
  options_->addWidget(page_of(cut));

  auto* seeds = new QVBoxLayout;
  seeds->setSpacing(6);
  seeds->addWidget(seeds_text_ = new QLabel);
  seeds_text_->setObjectName("faint");
  seeds_text_->setWordWrap(true);
  auto* row = new QHBoxLayout;
  grow_ = new QPushButton;
  grow_->setObjectName("grow");
  find_ = new QPushButton;
  find_->setObjectName("find");
  forget_seeds_ = new QPushButton;
  forget_seeds_->setObjectName("forget_seeds");
  row->addWidget(grow_, 1);
  row->addWidget(find_, 1);
  row->addWidget(forget_seeds_, 1);
  seeds->addLayout(row);
  seeds->addStretch();
  options_->addWidget(page_of(seeds));
  return options_;
}

QWidget* SegmentPanel::make_filters() {
  auto* grid = new QGridLayout;
  grid->setSpacing(6);
  grid->addWidget(filters_title_ = heading(), 0, 0, 1, 2);
  const std::array<const char*, 7> names{"fill_between", "fill_holes",  "keep_largest", "drop_small",
                                         "smooth",       "grow_margin", "shrink_margin"};
  for (std::size_t k = 0; k < names.size(); ++k) {
    filters_[k] = new QPushButton;
    filters_[k]->setObjectName(names[k]);
  }
  const auto number = [](const char* name, double value, double minimum, double maximum, double step,
                         const char* unit) {
    auto* box = new NumberBox;
    box->setObjectName(name);
    box->setRange(minimum, maximum);
    box->setDecimals(1);
    box->setSingleStep(step);
    box->setValue(value);
    box->setSuffix(unit);
    return box;
  };
  fill_along_ = new QComboBox;
  fill_along_->setObjectName("fill_along");
  fill_along_->addItems({{}, {}, {}});
  minimum_ml_ = number("least_ml", 1, 0.1, 500, 0.5, " ml");
  smooth_mm_ = number("smooth_mm", 2, 0.5, 20, 0.5, " mm");
  margin_mm_ = number("margin_mm", 3, 0.5, 50, 0.5, " mm");
  grid->addWidget(filters_[fill_between], 1, 0);
  grid->addWidget(fill_along_, 1, 1);
  grid->addWidget(filters_[fill_holes], 2, 0);
  grid->addWidget(filters_[keep_largest], 2, 1);
  grid->addWidget(filters_[drop_small], 3, 0);
  grid->addWidget(minimum_ml_, 3, 1);
  grid->addWidget(filters_[smooth], 4, 0);
  grid->addWidget(smooth_mm_, 4, 1);
  auto* margins = new QHBoxLayout;
  margins->setSpacing(6);
  margins->addWidget(filters_[grow_margin], 1);
  margins->addWidget(filters_[shrink_margin], 1);
  grid->addLayout(margins, 5, 0);
  grid->addWidget(margin_mm_, 5, 1);
  grid->setColumnStretch(0, 3);
  grid->setColumnStretch(1, 2);
  return page_of(grid);
}

void SegmentPanel::update_text() {
  list_title_->setText(tr("Structures"));
  list_->setHeaderLabels({tr("Structure"), tr("ml")});
  list_->setToolTip(tr("The chosen one is drawn on. The box shows or hides it."));
  add_->setText(tr("Add"));
  add_->setToolTip(tr("A new, empty structure"));
  rename_->setText(tr("Rename"));
  rename_->setToolTip(tr("Another name, and with it another colour, for the chosen structure"));
  remove_->setText(tr("Remove"));
  remove_->setToolTip(tr("Takes the chosen structure out of the case; Ctrl+Z brings it back"));

  tools_title_->setText(tr("Tools"));
  const std::array<QString, 7> names{tr("Crosshair"), tr("Brush"), tr("Eraser"),    tr("Smart brush"),
                                     tr("Scissors"),  tr("Grow"),  tr("Pick piece")};
  const std::array<QString, 7> abouts{
      tr("Clicks move the crosshair"),
      tr("Drag to add. Ctrl: erase instead. Shift+wheel: radius in mm"),
      tr("Drag to take away. Ctrl: add instead. Shift+wheel: radius in mm"),
      tr("Adds only where the grey values are like those under the click"),
      tr("Draw around something, and cut away what is inside or outside"),
      tr("Click points into the tissue, then let the structure grow over what looks alike; vessels are found without"),
      tr("Click on the piece that is to stay; all others go. Ctrl: takes off the part under the pointer")};
  for (int k = 0; k < static_cast<int>(names.size()); ++k) {
    QAbstractButton* button = tool_buttons_->button(k);
    const QString key = button->property("key").toString();
    button->setText(names[static_cast<std::size_t>(k)]);
    button->setShortcut(QKeySequence(key));
    button->setToolTip(tr("%1 (key %2)").arg(abouts[static_cast<std::size_t>(k)], key));
  }

  radius_title_->setText(tr("Radius (Shift+wheel)"));
  radius_->setToolTip(tr("Radius of the brush in mm"));
  radius_->setAccessibleName(tr("Radius of the brush in mm"));
  shape_->setItemText(0, tr("Disc in this slice"));
  shape_->setItemText(1, tr("Ball through the slices"));
  shape_->setToolTip(tr("Whether the brush reaches into the neighbouring slices"));
  likeness_title_->setText(tr("Tolerance (standard deviations)"));
  likeness_->setToolTip(tr("How far a grey value may be from that under the click, in standard deviations around it"));
  likeness_->setAccessibleName(likeness_title_->text());
  cut_side_->setItemText(0, tr("Cut away what is inside"));
  cut_side_->setItemText(1, tr("Cut away what is outside"));
  cut_depth_->setItemText(0, tr("In this slice only"));
  cut_depth_->setItemText(1, tr("Through all slices"));
  cut_depth_->setItemText(2, tr("So far to both sides"));
  cut_depth_->setItemText(3, tr("This slice and all towards you"));
  cut_depth_->setItemText(4, tr("This slice and all behind it"));
  cut_depth_->setToolTip(tr("How deep the scissors cut along your line of sight, in tilted slices too"));
  cut_depth_mm_->setToolTip(tr("How far the scissors cut before and behind this slice, in mm"));
  cut_depth_mm_->setAccessibleName(cut_depth_mm_->toolTip());
  grow_->setText(tr("Grow"));
  find_->setText(tr("Find"));
  forget_seeds_->setText(tr("Forget the points"));

  filters_title_->setText(tr("The whole structure"));
  const std::array<QString, 7> filters{tr("Fill between slices"),
                                       tr("Fill holes"),
                                       tr("Keep the largest"),
                                       tr("Remove pieces below"),
                                       tr("Smooth"),
                                       tr("Grow by"),
                                       tr("Shrink by")};
  const std::array<QString, 7> filter_abouts{
      tr("Fills the slices between drawn ones by their shapes"), tr("Fills what is enclosed on all sides"),
      tr("Keeps the largest piece and drops the others"),        tr("Drops pieces of less than this volume in ml"),
      tr("Rounds what is smaller than about this many mm"),      tr("Adds a margin of this many mm all around"),
      tr("Takes a margin of this many mm away all around")};
  const std::array<Qt::Key, 7> keys{Qt::Key_F, Qt::Key_H, Qt::Key_L, Qt::Key_P, Qt::Key_O, Qt::Key_Plus, Qt::Key_Minus};
  for (std::size_t k = 0; k < filters.size(); ++k) {
    const QKeySequence key(keys[k]);
    filters_[k]->setText(filters[k]);
    filters_[k]->setShortcut(key);
    filters_[k]->setProperty("about", tr("%1 (key %2)").arg(filter_abouts[k], key.toString(QKeySequence::NativeText)));
  }
  fill_along_->setItemText(0, tr("Transverse"));
  fill_along_->setItemText(1, tr("Coronal"));
  fill_along_->setItemText(2, tr("Sagittal"));
  fill_along_->setToolTip(tr("The slices that were drawn in"));
  minimum_ml_->setAccessibleName(tr("Least volume in ml"));
  smooth_mm_->setAccessibleName(tr("Radius of smoothing in mm"));
  margin_mm_->setAccessibleName(tr("Margin in mm"));
  list_structures();
}

}  // namespace glisson::widgets
