#pragma once
// What the liver's anatomy says of a cut while it is moved, and the plans that the case keeps. It is worked out off the
// UI thread, one cut at a time, the newest next.

#include <array>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <QObject>
#include <QString>
#include <vector>

#include "casefile/plans.h"
#include "geometry/surface.h"
#include "planning/two_stage.h"

namespace glisson::widgets {

// What a named branch and all that grows from it feed or drain, without tumours.
struct NamedTerritory {
  std::string branch;  // "portal/right/posterior"
  double ml = 0;
};

// One state of a case, opened for planning.
struct OpenedAnatomy {
  planning::Planner planner;
  std::vector<Sentence> remarks;
  bool has_segments = false, has_trees = false;
  vasculature::Told told;                                            // by which vessels and segments were found
  vasculature::DrawnBorders borders;                                 // of the segments
  std::array<std::shared_ptr<const geometry::Surface>, 9> segments;  // to be drawn; null where there is none
  std::vector<NamedTerritory> territories;                           // those with a name of their own, by name
  std::map<std::string, std::string> territory_around;               // by tumour: the smallest portal one that holds it
};

struct LivePlanResult {
  std::vector<planning::Cut> cuts;  // of which this is the answer
  planning::PlanAnswer answer;
  std::shared_ptr<const geometry::Surface> removed, left;  // to be drawn, where the cut is no surface
  std::vector<planning::Resectogram> resectograms;         // of each plane and sheet, where asked for
  std::optional<planning::TwoStages> stages;               // where a branch is embolised before
  std::optional<Error> stages_problem;                     // why they cannot be told
};

// A portal branch that is embolised before the cut, and by how much the rest then grows.
struct Embolisation {
  std::string branch;
  double growth_percent = planning::mean_growth_percent;
};

struct KeptPlanAnswer {
  casefile::KeptPlan kept;
  std::optional<planning::PlanAnswer> answer;  // by what the case holds now
  std::optional<Error> problem;                // where it no longer holds
  bool followed = false;                       // by Rehearse, Guide and the report
};

class LivePlan : public QObject {
  Q_OBJECT

 public:
  explicit LivePlan(QObject* parent = nullptr);

  // Reads this case anew; an empty path: none.
  void open(const std::filesystem::path& case_folder);
  void set_cuts(const std::vector<planning::Cut>& cuts);  // none: nothing is cut
  void read_kept();
  // Whether each answer comes with its planes and sheets unrolled.
  void set_unrolling(bool unrolling);
  void set_embolisation(const std::optional<Embolisation>& embolisation);

  [[nodiscard]] const std::shared_ptr<const OpenedAnatomy>& anatomy() const { return anatomy_; }
  [[nodiscard]] bool opening() const { return opening_; }
  [[nodiscard]] const std::shared_ptr<const LivePlanResult>& result() const { return result_; }
  [[nodiscard]] const std::optional<Error>& problem() const { return problem_; }
  [[nodiscard]] const std::vector<KeptPlanAnswer>& kept() const { return kept_; }

 Q_SIGNALS:
  void opened();        // anatomy() is new
  void changed();       // result() or problem() is new
  void kept_changed();  // kept() is new

 private:
  void compute();

  std::filesystem::path folder_;
  std::shared_ptr<const OpenedAnatomy> anatomy_;
  std::vector<planning::Cut> wanted_;
  std::optional<Embolisation> embolisation_;
  std::shared_ptr<const LivePlanResult> result_;
  std::optional<Error> problem_;
  std::vector<KeptPlanAnswer> kept_;
  int openings_ = 0;  // counts them, so that an answer of an older one is known when it arrives
  int asked_ = 0;
  bool opening_ = false, computing_ = false, unrolling_ = false;
};

}  // namespace glisson::widgets
