#include "widgets/segment/segment_panel.h"

#include <QHideEvent>
#include <QInputDialog>
#include <QShortcut>
#include <QVBoxLayout>

#include "casefile/label_map.h"
#include "casefile/structures.h"
#include "scene/anatomy.h"
#include "segmentation/grow_contrast.h"
#include "segmentation/resample.h"
#include "widgets/panels/parts.h"
#include "widgets/panels/swatch.h"
#include "widgets/session/load_patient.h"
#include "widgets/words/keep_translated.h"
#include "widgets/words/translated.h"

namespace glisson::widgets {
namespace {

// "tumour" -> "tumour-3" where tumour-1 and tumour-2 are there; what there is one of keeps its bare name.
std::string free_name(const std::string& base, const std::vector<EditedStructure>& taken) {
  const auto is_taken = [&](const std::string& name) {
    return std::any_of(taken.begin(), taken.end(), [&](const EditedStructure& one) { return one.name == name; });
  };
  const bool numbered = base == "tumour" || base == "cyst";
  if (!numbered && !is_taken(base)) return base;
  for (int number = numbered ? 1 : 2;; ++number) {
    if (const std::string name = base + "-" + std::to_string(number); !is_taken(name)) return name;
  }
}

}  // namespace

Workspace SegmentPanel::workspace(const WorkspaceContext& context) {
  auto* panel = new SegmentPanel(context);
  return {.id = "segment",
          .name = [] { return tr("Segment"); },
          .about = [] { return tr("Outline the liver, its vessels and its tumours."); },
          .widget = panel,
          .show_patient = [panel](const Patient& patient) { panel->show_patient(patient); },
          .missing =
              [](const Patient& patient) {
                if (!patient.folder.empty() && patient.anatomy) return QString();
                return patient.folder.empty() ? tr("Needs a case: open one, or import images.")
                                              : tr("Needs anatomical images: import them in Study.");
              }};
}

SegmentPanel::SegmentPanel(const WorkspaceContext& context, QWidget* parent)
    : QWidget(parent),
      context_(context),
      editor_(context.undo),
      overlay_(context.views, editor_),
      tools_(context.views, editor_, overlay_) {
  setObjectName("panel");
  setAttribute(Qt::WA_StyledBackground);
  auto* inner = new QWidget;
  inner->setObjectName("panel");
  auto* column = new QVBoxLayout(inner);
  column->setContentsMargins(14, 14, 14, 14);
  column->setSpacing(8);
  column->addWidget(make_list(), 1);
  column->addWidget(new UnsurePlaces(context.views, editor_, overlay_));
  column->addWidget(make_tools());
  column->addWidget(make_options());
  column->addWidget(make_filters());
  column->addWidget(operations_ = new StructureOperations);
  auto* whole = new QVBoxLayout(this);
  whole->setContentsMargins(0, 0, 0, 0);
  whole->addWidget(scrolled(inner));
  connect_parts();
  keep_translated(this, [this] { update_text(); });
  choose_tool(Tool::none);
}

void SegmentPanel::connect_parts() {
  connect(&editor_, &StructureEditor::opened, this, &SegmentPanel::list_structures);
  connect(&editor_, &StructureEditor::listed, this, &SegmentPanel::list_structures);
  connect(&editor_, &StructureEditor::changed, this, [this] { has_drawn_ = true; });
  connect(&editor_, &StructureEditor::surfaces_changed, this, &SegmentPanel::show_space);
  connect(&editor_, &StructureEditor::working, this, &SegmentPanel::show_state);
  connect(&editor_, &StructureEditor::failed, this, context_.tell_error);
  connect(&editor_, &StructureEditor::changed_nothing, this, [this] { context_.tell_status(tr("Nothing changed.")); });
  connect(&context_.undo, &Undo::entries_moved, this, [this] { has_drawn_ = true; });
  connect(&tools_, &SliceTools::refused, this, context_.tell_status);
  connect(&tools_, &SliceTools::radius_changed, radius_, &NumberSlider::set_value);
  connect(&tools_, &SliceTools::points_changed, this, &SegmentPanel::show_state);

  connect(list_, &QTreeWidget::currentItemChanged, this, [this](QTreeWidgetItem* item) {
    if (item != nullptr) editor_.set_active(list_->indexOfTopLevelItem(item));
  });
  connect(list_, &QTreeWidget::itemChanged, this, [this](QTreeWidgetItem* item, int column) {
    if (column == 0) editor_.set_shown(list_->indexOfTopLevelItem(item), item->checkState(0) == Qt::Checked);
  });
  connect(add_->menu(), &QMenu::aboutToShow, this, [this] {
    list_names(*add_->menu(), [this](const std::string& name) { editor_.add(free_name(name, editor_.structures())); });
    QAction* program =
        add_->menu()->addAction(tr("Outline with another program..."), this, [this] { outline_with_program(); });
    program->setObjectName("outline_with_program");
  });
  connect(rename_->menu(), &QMenu::aboutToShow, this, [this] {
    list_names(*rename_->menu(),
               [this](const std::string& name) { editor_.rename(free_name(name, editor_.structures())); });
  });
  connect(remove_, &QPushButton::clicked, this, [this] { editor_.remove(); });

  connect(tool_buttons_, &QButtonGroup::idClicked, this, [this](int tool) { choose_tool(static_cast<Tool>(tool)); });
  auto* none = new QShortcut(QKeySequence(Qt::Key_Escape), this);
  connect(none, &QShortcut::activated, this, [this] { choose_tool(Tool::none); });
  connect(radius_, &NumberSlider::changed, this, [this](double radius_mm) { tools_.options().radius_mm = radius_mm; });
  connect(likeness_, &NumberSlider::changed, this, [this](double spread) { tools_.options().likeness = spread; });
  connect(shape_, &QComboBox::currentIndexChanged, this,
          [this](int shape) { tools_.options().shape = static_cast<ToolOptions::Shape>(shape); });
  connect(cut_side_, &QComboBox::currentIndexChanged, this,
          [this](int side) { tools_.options().cut = static_cast<segmentation::CutSide>(side); });
  connect(cut_depth_, &QComboBox::currentIndexChanged, this, [this](int depth) {
    tools_.options().depth = static_cast<ToolOptions::Depth>(depth);
    cut_depth_mm_->setVisible(tools_.options().depth == ToolOptions::Depth::both_sides);
  });
  connect(cut_depth_mm_, &NumberSlider::changed, this, [this](double mm) { tools_.options().depth_mm = mm; });
  cut_depth_->setCurrentIndex(static_cast<int>(tools_.options().depth));
  connect(grow_, &QPushButton::clicked, this, &SegmentPanel::grow);
  connect(find_, &QPushButton::clicked, this, &SegmentPanel::find);
  connect(forget_seeds_, &QPushButton::clicked, &tools_, &SliceTools::clear_points);

  connect_operations();
  // What the controls say is read when the button is pressed; the filter itself runs on a worker.
  using segmentation::with_margin;
  filter(filters_[fill_between], GLISSON_TEXT("Fill between slices of {0}"), [this]() -> StructureEditor::Edit {
    const SliceView& view = *context_.views.slices()[static_cast<std::size_t>(fill_along_->currentIndex())];
    return [direction = view.normal()](imaging::Mask mask) {
      const int axis = segmentation::axis_along(mask.grid, direction);
      return segmentation::fill_between_layers(std::move(mask), axis);
    };
  });
  filter(filters_[fill_holes], GLISSON_TEXT("Fill holes of {0}"), []() -> StructureEditor::Edit {
    return [](const imaging::Mask& mask) { return segmentation::fill_holes(mask); };
  });
  filter(filters_[keep_largest], GLISSON_TEXT("Keep the largest piece of {0}"), []() -> StructureEditor::Edit {
    return [](imaging::Mask mask) { return segmentation::keep_largest(std::move(mask)); };
  });
  filter(filters_[drop_small], GLISSON_TEXT("Remove small pieces of {0}"), [this]() -> StructureEditor::Edit {
    return [minimum_ml = minimum_ml_->value()](imaging::Mask mask) {
      return segmentation::without_small_pieces(std::move(mask), minimum_ml);
    };
  });
  filter(filters_[smooth], GLISSON_TEXT("Smooth {0}"), [this]() -> StructureEditor::Edit {
    return [radius_mm = smooth_mm_->value()](imaging::Mask mask) {
      return segmentation::smooth(std::move(mask), radius_mm);
    };
  });
  filter(filters_[grow_margin], GLISSON_TEXT("Margin around {0}"), [this]() -> StructureEditor::Edit {
    return [by_mm = margin_mm_->value()](imaging::Mask mask) { return with_margin(std::move(mask), by_mm); };
  });
  filter(filters_[shrink_margin], GLISSON_TEXT("Shrink {0}"), [this]() -> StructureEditor::Edit {
    return [by_mm = margin_mm_->value()](imaging::Mask mask) { return with_margin(std::move(mask), -by_mm); };
  });
}

void SegmentPanel::connect_operations() {
  connect(operations_, &StructureOperations::brush_range_changed, this,
          [this] { tools_.options().only = operations_->brush_range(); });
  connect(operations_, &StructureOperations::range_wanted_from_crosshair, this, [this] {
    if (editor_.anatomy() == nullptr) return;
    const auto& slice = *context_.views.slices().front();
    if (const auto range = segmentation::grey_range_at(*editor_.anatomy(), slice.crosshair_mm())) {
      operations_->set_range(*range);
    }
  });
  connect(operations_, &StructureOperations::take_asked, this, &SegmentPanel::take_grey_values);
  connect(operations_, &StructureOperations::combine_asked, this, &SegmentPanel::combine);
}

void SegmentPanel::take_grey_values() {
  const auto anatomy = editor_.shared_anatomy();
  if (!anatomy) return;
  editor_.apply(GLISSON_TEXT("Grey values for {0}"),
                [anatomy, range = operations_->range(),
                 within = editor_.mask_of(operations_->within())](const imaging::Mask& mask) -> Result<imaging::Mask> {
                  std::optional<imaging::Mask> inside;
                  if (within) inside = segmentation::resample(*within, anatomy->grid);
                  auto taken = segmentation::in_range(*anatomy, range, inside ? &*inside : nullptr);
                  return segmentation::resample(taken, mask.grid);
                });
}

void SegmentPanel::combine() {
  const auto other = editor_.mask_of(operations_->other());
  if (!other) return;
  editor_.apply(GLISSON_TEXT("{0} and another structure"),
                [other, how = operations_->combination()](imaging::Mask mask) -> Result<imaging::Mask> {
                  const imaging::Mask here = segmentation::resample(*other, mask.grid);
                  switch (how) {
                    case StructureOperations::unite: return segmentation::united(std::move(mask), here);
                    case StructureOperations::intersect: return segmentation::intersected(std::move(mask), here);
                    case StructureOperations::subtract: return segmentation::subtracted(std::move(mask), here);
                  }
                  return mask;
                });
}

void SegmentPanel::filter(QAbstractButton* button, const char* what,
                          const std::function<StructureEditor::Edit()>& edit) {
  connect(button, &QAbstractButton::clicked, this, [this, what, edit] { editor_.apply(what, edit()); });
}

void SegmentPanel::show_patient(const Patient& patient) {
  const bool same = patient.folder == patient_.folder;
  patient_ = patient;
  if (!same) tools_.clear_points();
  has_drawn_ = false;
  to_open_ = true;
  if (isVisible()) {
    to_open_ = false;
    editor_.open(patient);
    overlay_.refresh();
  }
}

void SegmentPanel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  overlay_.set_on(true);
  if (to_open_) editor_.open(patient_);
  to_open_ = false;
  tell_volumes();
  show_space();
}

void SegmentPanel::hideEvent(QHideEvent* event) {
  QWidget::hideEvent(event);
  if (event->spontaneous() || !window()->isVisible()) return;  // minimised, or closed: nobody looks elsewhere
  choose_tool(Tool::none);
  overlay_.set_on(false);
  context_.list_structures(std::nullopt);
  context_.patient_views.set_workspace_scene(std::nullopt);
  // A patient without a model is shown by the outlines; one with a model by that, until it is built anew.
  if (!has_drawn_ || patient_.rehearsal != nullptr) return;
  has_drawn_ = false;
  if (context_.undo.busy()) {
    connect(&context_.undo, &Undo::settled, this, &SegmentPanel::read_patient_again, Qt::SingleShotConnection);
  } else {
    read_patient_again();
  }
}

void SegmentPanel::read_patient_again() {
  if (patient_.folder.empty() || context_.work.busy()) return;
  context_.change(tr("Reading the structures"),
                  [folder = patient_.folder](const Progress& progress) { return load_patient(folder, progress); });
}

void SegmentPanel::list_structures() {
  const QSignalBlocker quiet(list_);
  const auto& structures = editor_.structures();
  while (list_->topLevelItemCount() > static_cast<int>(structures.size())) delete list_->takeTopLevelItem(0);
  while (list_->topLevelItemCount() < static_cast<int>(structures.size())) new QTreeWidgetItem(list_);
  for (int k = 0; k < static_cast<int>(structures.size()); ++k) {
    const EditedStructure& structure = structures[static_cast<std::size_t>(k)];
    QTreeWidgetItem* row = list_->topLevelItem(k);
    row->setText(0, structure_label(structure.name));
    row->setIcon(0, swatch(scene::appearance_of(structure.name).colour));
    row->setCheckState(0, structure.shown ? Qt::Checked : Qt::Unchecked);
    row->setText(1, QLocale().toString(structure.volume_ml, 'f', structure.volume_ml < 100 ? 1 : 0));
    row->setTextAlignment(1, Qt::AlignRight | Qt::AlignVCenter);
  }
  list_->setCurrentItem(editor_.active() < 0 ? nullptr : list_->topLevelItem(editor_.active()));
  tell_volumes();
  show_state();
}

// The list of the patient beside the views, as drawn.
void SegmentPanel::tell_volumes() {
  if (!isVisible() || editor_.structures().empty()) return;
  std::vector<PatientStructure> drawn;
  for (const EditedStructure& structure : editor_.structures()) {
    drawn.push_back({structure.name, structure.surface, structure.volume_ml});
  }
  context_.list_structures(drawn);
}

void SegmentPanel::list_names(QMenu& menu, const std::function<void(const std::string&)>& chosen) {
  menu.clear();
  for (const std::string& name : segmentation::known_structure_names()) {
    QAction* action = menu.addAction(swatch(scene::appearance_of(name).colour), structure_label(name),
                                     [name, chosen] { chosen(name); });
    action->setObjectName(QString::fromStdString(name));
  }
  menu.addSeparator();
  menu.addAction(tr("Another name..."), this, [this, chosen] { name_otherwise(chosen); });
}

void SegmentPanel::name_otherwise(const std::function<void(const std::string&)>& chosen) {
  const QString typed = QInputDialog::getText(this, tr("Name of the structure"), tr("Letters, digits and hyphens:"));
  const std::string name = casefile::structure_name(typed.toStdString());
  if (!name.empty()) chosen(name);
}

void SegmentPanel::choose_tool(Tool tool) {
  tool_buttons_->button(static_cast<int>(tool))->setChecked(true);
  tools_.set_tool(tool);
  const bool brush = tool == Tool::brush || tool == Tool::eraser || tool == Tool::smart_brush;
  options_->setCurrentIndex(brush                    ? brush_options
                            : tool == Tool::scissors ? cut_options
                            : tool == Tool::seeds    ? seed_options
                                                     : no_options);
  likeness_row_->setVisible(tool == Tool::smart_brush);
  show_state();
}

// The structures as drawn, in place of the patient's own surfaces.
void SegmentPanel::show_space() {
  if (!isVisible()) return;
  WorkspaceScene scene;
  scene.patient = WorkspaceScene::Patient::hidden;
  for (const EditedStructure& structure : editor_.structures()) {
    if (!structure.surface || !structure.shown) continue;
    const scene::Appearance look = scene::appearance_of(structure.name);
    scene.surfaces.push_back({structure.name, structure.surface, look.colour, look.opacity, look.finish, {}});
  }
  context_.patient_views.set_workspace_scene(std::move(scene));
}

void SegmentPanel::show_state() {
  const bool has_case = !patient_.folder.empty() && patient_.anatomy != nullptr;
  const bool has_active = editor_.active_structure() != nullptr;
  add_->setEnabled(has_case);
  for (QWidget* needs_one : {static_cast<QWidget*>(rename_), static_cast<QWidget*>(remove_)}) {
    needs_one->setEnabled(has_active);
  }
  const QString why = has_active ? QString() : tr("Choose a structure first, or add one.");
  for (QPushButton* button : filters_) {
    button->setEnabled(has_active);
    button->setToolTip(has_active ? button->property("about").toString() : why);
  }
  operations_->list(editor_.structures(), editor_.active());
  if (has_active && points_of_ != editor_.active_structure()->name) {
    points_of_ = editor_.active_structure()->name;
    tools_.clear_points();  // comes back here
    return;
  }
  const auto seeds = tools_.points().inside_mm.size(), outside = tools_.points().outside_mm.size();
  grow_->setEnabled(has_active && seeds > 0 && outside == 0);
  grow_->setToolTip(!has_active   ? why
                    : outside > 0 ? tr("Points outside count for Find alone.")
                    : seeds == 0  ? tr("Click into the structure first, in any slice.")
                                  : tr("Replaces the outline by the tissue around the points"));
  forget_seeds_->setEnabled(seeds + outside > 0);
  const auto kind = has_active ? segmentation::contrast_of(editor_.active_structure()->name) : std::nullopt;
  using segmentation::Contrast;
  const bool is_vessel = kind.value_or(Contrast::lesion) == Contrast::vessel,
             has_liver = editor_.mask_of("liver") != nullptr;
  const bool is_liver = has_active && editor_.active_structure()->name == "liver";
  find_->setVisible(is_vessel || is_liver);
  find_->setEnabled(is_liver || has_liver || !operations_->within().empty());
  find_->setToolTip(is_liver ? tr("Replaces the outline by the liver that brightness and shape show; it needs no point")
                    : !has_liver ? tr("Outline the liver first.")
                    : seeds == 0 ? tr("Replaces the outline by all that is shaped like a vessel in the liver")
                                 : tr("Replaces the outline by the vessels in the liver that hang on the points"));
  seeds_text_->setText((
      is_liver ? tr("Click into the liver, away from large vessels; Ctrl and click into what is wrongly taken for it. "
                    "A click on a point takes it away. Points so far: %1 inside, %2 outside")
                     .arg(seeds)
                     .arg(outside)
      : !kind     ? tr("Click into the tissue, away from large vessels. Points so far: %1").arg(seeds)
      : is_vessel ? tr("Click into the vessel where it stands out best, or let all vessels be found. Points so far: %1")
                        .arg(seeds)
                  : tr("Click into the middle of it. Points so far: %1").arg(seeds)));
  option_hint_->setText(
      tools_.tool() == Tool::piece
          ? tr("Click on the piece that is to stay; all others go. Ctrl and click: the part under the "
               "pointer goes, from where it is narrowest.")
          : tr("Choose a tool to draw in the slices. Without one, clicks move the crosshair."));
}

}  // namespace glisson::widgets
