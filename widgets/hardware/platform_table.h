#pragma once
// Platforms, the least obtrusive first: what they draw when idle before anything else, then what they can do for the
// case and what limits them. A number that rests on an assumed figure carries the sign for "about".

#include <QTableWidget>

#include "hardware/plan.h"

namespace glisson::widgets {

class PlatformTable : public QTableWidget {
  Q_OBJECT

 public:
  enum Column { name, worn, idle, allowed, left, frames, lasts, surface, sure, limit, assumed, columns };

  explicit PlatformTable(QWidget* parent = nullptr);

  // Keeps the chosen platform where it is still there, and takes the recommended one (or the first) otherwise.
  void show_plan(const hardware::Plan& plan, const std::vector<hardware::Device>& devices);
  [[nodiscard]] QString chosen() const;  // an id; empty for none
  void choose(const QString& id);

 Q_SIGNALS:
  void platform_chosen(const QString& id);

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  void fit_columns();
};

// "fails: battery, too hot", or what would bound its frame rate next.
[[nodiscard]] QString limit_of(const hardware::DevicePlan& answer);

}  // namespace glisson::widgets
