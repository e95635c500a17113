#pragma once
// The rehearsal as the window lives it: a tool is placed off the UI thread, its force and direction change at once.

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <QObject>

#include "rehearsal/static_rehearsal.h"
#include "rehearsal/tool_presets.h"

namespace glisson::widgets {

class LiveRehearsal : public QObject {
  Q_OBJECT

 public:
  explicit LiveRehearsal(QObject* parent = nullptr) : QObject(parent) {}

  // Starts anew with this body, no tool on it; nullptr for none.
  void set_body(std::shared_ptr<const rehearsal::StaticRehearsal> body);
  [[nodiscard]] const rehearsal::StaticRehearsal* body() const { return body_.get(); }

  // Solves for a tool there, on a worker thread, then answers with the present force. A later call supersedes this one.
  void place_tool(const Eigen::Vector3d& center_mm, double radius_mm);
  void take_tool_away();
  void set_force_N(double force_N);
  void set_direction(const Eigen::Vector3d& unit);  // of the force

  [[nodiscard]] bool has_tool() const { return tool_.has_value(); }
  [[nodiscard]] Eigen::Vector3d tool_center_mm() const { return tool_ ? tool_->center_mm() : Eigen::Vector3d::Zero(); }
  [[nodiscard]] double tool_radius_mm() const { return tool_ ? tool_->radius_mm() : 0; }
  [[nodiscard]] double force_N() const { return force_N_; }
  [[nodiscard]] const Eigen::Vector3d& direction() const { return direction_; }
  [[nodiscard]] const std::optional<rehearsal::RehearsalFrame>& frame() const { return frame_; }

 Q_SIGNALS:
  void frame_changed();  // frame() is new, or gone
  void placing();        // a solve has begun
  void placed(double solve_ms);
  void failed(const glisson::Error& error);

 private:
  void answer();

  std::shared_ptr<const rehearsal::StaticRehearsal> body_;
  std::optional<rehearsal::PlacedTool> tool_;
  std::optional<rehearsal::RehearsalFrame> frame_;
  double force_N_ = 0;
  Eigen::Vector3d direction_{0, -1, 0};
  int placements_ = 0;  // counts them, so that a superseded one is known when it arrives
};

}  // namespace glisson::widgets
