#pragma once
// The plan of a resection while the cut is being moved: computed off the UI thread, one at a time, the newest cut next.

#include <array>
#include <memory>
#include <optional>
#include <QObject>
#include <QTimer>
#include <vector>

#include "casefile/resection_folder.h"
#include "widgets/session/patient.h"

namespace glisson::widgets {

// A structure's piece on one side of the cut, to be drawn.
struct ResectedPiece {
  std::string structure;  // "liver", "tumour-1"
  rehearsal::ResectionSide side = rehearsal::ResectionSide::remnant;
  std::shared_ptr<const geometry::Surface> surface;
};

struct LiveResectionResult {
  casefile::PlannedCut cut;  // of which this is the plan
  rehearsal::Resection plan;
  std::vector<ResectedPiece> pieces;
  Eigen::Vector3d towards_specimen{0, 0, 1};  // unit
};

// The liver and its structures where they lie under a tool.
struct LyingPatient;

class LiveResection : public QObject {
  Q_OBJECT

 public:
  explicit LiveResection(QObject* parent = nullptr);

  // Without a model there is nothing to cut.
  void set_patient(const Patient& patient);
  // The tool that holds the liver aside: a cut then lies, and is measured, on the liver as it lies under it. Nothing:
  // at rest. Failures of displaced(), and of placing the tool, are told as problem().
  struct Holding {
    Eigen::Vector3d center_mm{0, 0, 0};
    double radius_mm = 0;
    Eigen::Vector3d force_N{0, 0, 0};
    bool operator==(const Holding&) const = default;
  };
  void set_holding(const std::optional<Holding>& holding);
  [[nodiscard]] const std::optional<Holding>& holding() const { return holding_; }
  // Nothing: no cut. What came of an older one is gone at once.
  void set_cut(const std::optional<casefile::PlannedCut>& cut);

  [[nodiscard]] const std::shared_ptr<const LiveResectionResult>& result() const { return result_; }
  [[nodiscard]] const std::optional<Error>& problem() const { return problem_; }

 Q_SIGNALS:
  void changed();  // result() or problem() is new

 private:
  void compute();

  std::shared_ptr<const rehearsal::StaticRehearsal> body_;  // holds the mesh
  std::vector<PatientStructure> structures_;
  std::optional<Holding> holding_;
  std::shared_ptr<const LyingPatient> lying_;  // under that tool, once it was computed
  std::optional<casefile::PlannedCut> wanted_;
  std::shared_ptr<const LiveResectionResult> result_;
  std::optional<Error> problem_;
  QTimer pause_;
  int asked_ = 0;  // counts cuts, so that an answer to an older one is known when it arrives
  bool computing_ = false;
};

}  // namespace glisson::widgets
