#pragma once
// Thin vessels of a patient as tubes (casefile/drawn_vessels.h), for the views in space. They are found on another
// thread, from the masks of the case, while the vessels are shown as they are outlined.

#include <memory>
#include <QObject>
#include <string>
#include <vector>

#include "widgets/session/patient.h"

namespace glisson::widgets {

class VesselTubes : public QObject {
  Q_OBJECT

 public:
  struct Vessel {
    std::string name;
    std::shared_ptr<const geometry::Surface> outline;
    std::shared_ptr<const geometry::Surface> drawn;  // null: as it is outlined
    std::vector<int> follows;                        // each of its points a point of the outline
  };

  explicit VesselTubes(QObject* parent) : QObject(parent) {}

  // Those of this patient and no others; an outline that was looked at before is not looked at again.
  void look_for(const Patient& patient);
  // Of that structure; null where it is drawn as it is outlined, or not looked at yet.
  [[nodiscard]] const Vessel* of(const std::string& structure) const;

  // Where its points are when those of the outline are there. A tube's point goes with the outline's point nearest to
  // it, a voxel or two away.
  [[nodiscard]] static std::vector<Eigen::Vector3d> moved(const Vessel& vessel,
                                                          const std::vector<Eigen::Vector3d>& outline_now_mm);

 Q_SIGNALS:
  void found();  // of() says more than it did

 private:
  std::vector<Vessel> vessels_;
  int looks_ = 0;
};

}  // namespace glisson::widgets
