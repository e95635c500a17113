#pragma once
// The Segment workspace: which structures there are, the tools that draw them in the slices, and filters for one whole.

#include <array>
#include <QAbstractButton>
#include <QButtonGroup>
#include <QComboBox>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QStackedWidget>
#include <QTreeWidget>

#include "casefile/structures.h"
#include "widgets/panels/number_slider.h"
#include "widgets/segment/slice_tools.h"
#include "widgets/segment/structure_operations.h"
#include "widgets/segment/unsure_places.h"
#include "widgets/workspaces/workspace.h"

namespace glisson::widgets {

class SegmentPanel : public QWidget {
  Q_OBJECT

 public:
  static Workspace workspace(const WorkspaceContext& context);

  explicit SegmentPanel(const WorkspaceContext& context, QWidget* parent = nullptr);

  void show_patient(const Patient& patient);
  [[nodiscard]] StructureEditor& editor() { return editor_; }
  [[nodiscard]] SliceTools& tools() { return tools_; }

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  enum OptionPage { no_options, brush_options, cut_options, seed_options };
  enum Filter { fill_between, fill_holes, keep_largest, drop_small, smooth, grow_margin, shrink_margin };

  QWidget* make_list();
  QWidget* make_tools();
  QWidget* make_options();
  QWidget* make_filters();
  void connect_parts();
  void update_text();
  void list_structures();
  void tell_volumes();
  void list_names(QMenu& menu, const std::function<void(const std::string&)>& chosen);
  void name_otherwise(const std::function<void(const std::string&)>& chosen);
  void outline_with_program();
  void choose_tool(Tool tool);
  void show_space();
  void show_state();
  void grow();
  void find();  // the liver by its shape, vessels by theirs
  // Makes the chosen structure anew, on a worker; `what` says so, with its name as %1.
  using Make = std::function<Result<casefile::SavedStructure>(casefile::Case& patient, const std::string& name,
                                                              const Progress& progress)>;
  void replace_active(const QString& what, Make make);
  void connect_operations();
  void take_grey_values();
  void combine();
  void read_patient_again();
  void filter(QAbstractButton* button, const char* what, const std::function<StructureEditor::Edit()>& edit);

  WorkspaceContext context_;
  StructureEditor editor_;
  SliceOverlay overlay_;
  SliceTools tools_;
  Patient patient_;
  std::string points_of_;   // the structure that was clicked into
  bool to_open_ = false;    // the patient has not been read here yet
  bool has_drawn_ = false;  // so that the others see it when this one is left

  QLabel* list_title_ = nullptr;
  QTreeWidget* list_ = nullptr;
  QPushButton* add_ = nullptr;
  QPushButton* rename_ = nullptr;
  QPushButton* remove_ = nullptr;
  QLabel* tools_title_ = nullptr;
  QButtonGroup* tool_buttons_ = nullptr;
  QStackedWidget* options_ = nullptr;
  QLabel* option_hint_ = nullptr;
  QLabel* radius_title_ = nullptr;
  NumberSlider* radius_ = nullptr;
  QComboBox* shape_ = nullptr;
  QWidget* likeness_row_ = nullptr;
  QLabel* likeness_title_ = nullptr;
  NumberSlider* likeness_ = nullptr;
  QComboBox* cut_side_ = nullptr;
  QComboBox* cut_depth_ = nullptr;
  NumberSlider* cut_depth_mm_ = nullptr;
  QLabel* seeds_text_ = nullptr;
  QPushButton* grow_ = nullptr;
  QPushButton* find_ = nullptr;  // where the chosen structure is the liver or a vessel
  QPushButton* forget_seeds_ = nullptr;
  StructureOperations* operations_ = nullptr;
  QLabel* filters_title_ = nullptr;
  QComboBox* fill_along_ = nullptr;
  std::array<QPushButton*, 7> filters_{};
  NumberBox* minimum_ml_ = nullptr;
  NumberBox* smooth_mm_ = nullptr;
  NumberBox* margin_mm_ = nullptr;
};

}  // namespace glisson::widgets
