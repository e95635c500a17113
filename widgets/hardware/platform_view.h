#pragma once
// What can be worn for this case, live. A person gives the liver's volume and stiffness, what is computed, and the
// wanted accuracy, duration and frame rate. A table of platforms begins with what they draw when idle, and one is named
// that is least obtrusive. One platform is shown in full, with its contours over volume and resolution. A task of this
// program has a size of its own: volume, accuracy and contours stand aside then. A recording of power that a person
// opens takes the place of the contours until it is closed; what it shows can be planned with.

#include <functional>
#include <optional>
#include <QComboBox>
#include <QLabel>
#include <QTextBrowser>
#include <QWidget>

#include "hardware/plan.h"
#include "widgets/hardware/platform_table.h"
#include "widgets/hardware/trace_view.h"
#include "widgets/panels/number_slider.h"
#include "widgets/plots/contour_plot.h"
#include "widgets/workspaces/workspace.h"

namespace glisson::widgets {

class PlatformView : public QWidget {
  Q_OBJECT

 public:
  PlatformView(std::vector<hardware::Device> devices, hardware::ConvergenceCurve curve,
               std::vector<hardware::Task> tasks = {}, QWidget* parent = nullptr);

  // As a workspace, with the tables and the curve that ship; a sentence in its place where they cannot be read.
  [[nodiscard]] static Workspace workspace();

  // Takes volume and mean Young's modulus over; 0 where the case does not know.
  void show_case(const QString& name, double liver_volume_cm3, double youngs_kPa, bool assumed = false);
  // Devices that a person measured or wrote; those with a known id take its place.
  void add_devices(std::vector<hardware::Device> devices);

  // Shows a recording of power, or a sentence on why it cannot be read.
  void open_trace(const std::filesystem::path& file);

  [[nodiscard]] const std::optional<hardware::Plan>& plan() const { return plan_; }

 private:
  enum Quantity { surface_C, frames, battery, power };

  QWidget* make_question();
  QWidget* make_answer();
  void choose_devices();
  void choose_trace();
  void plan_with_trace();
  void refuse(const Error& error);
  void show_lower_left();
  void update_case_text();
  void set_accuracy_range();
  void choose_task();
  void replan();
  void show_platform();
  void show_picture();
  [[nodiscard]] const hardware::Device* chosen_device() const;

  std::vector<hardware::Device> devices_;
  hardware::ConvergenceCurve curve_;
  std::vector<hardware::Task> tasks_;
  std::optional<hardware::Plan> plan_;
  std::function<QString()> case_name_words_;

  QLabel* case_name_;
  QComboBox* task_;
  NumberBox* volume_;
  NumberBox* youngs_;
  NumberSlider* accuracy_;
  NumberSlider* duration_;
  NumberSlider* frames_;
  NumberSlider* room_;
  NumberSlider* limit_;
  QLabel* workload_;
  QLabel* refusal_;
  QLabel* answer_;
  PlatformTable* table_;
  QWidget* plot_;
  QComboBox* quantity_;
  QLabel* quantity_text_;
  ContourPlot* contours_;
  TraceView* trace_;
  bool trace_open_ = false;
  QTextBrowser* details_;
  QLabel* notes_;
};

}  // namespace glisson::widgets
