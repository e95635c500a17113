#pragma once
// What a plan takes out of a liver and what it leaves, fast enough for a cut that is being dragged.
//
// Opened once a liver. Every voxel then knows its segment, its tumour and its stiffness, and the point of the portal
// and of the hepatic tree that it hangs on. An answer passes over the voxels once. Tissue is perfused where no portal
// branch on its way from the stem is cut, and drained where no hepatic one is. Remnants counted so differ from plain
// volumes by 20 to 43 % in a third of patients (Lang et al. 2005, Arch Surg 140:629).
//
// Frame: patient coordinates, LPS, mm. Volumes are counts of voxels.

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "imaging/image.h"
#include "planning/cut.h"
#include "planning/resectogram.h"
#include "vasculature/systems.h"

namespace glisson::planning {

struct NamedTumour {
  std::string name;  // "tumour-1"
  imaging::Mask mask;
};

// What is known of a liver; images may lie on grids of their own, the nearest voxel counts.
struct LiverParts {
  imaging::Mask liver;
  std::vector<NamedTumour> tumours;                  // what of them lies beside the liver's outline counts as liver
  std::optional<imaging::LabelMap> segments;         // 1 to 8
  vasculature::VesselTrees trees;                    // arteries and bile ducts among them are cut, and feed nothing
  std::optional<imaging::LabelMap> portal, hepatic;  // territories: branch of `trees` + 1, 0 where none
  std::optional<imaging::Volume> youngs_kPa;         // positive where it is to be trusted
};

// Some tissue, tumours taken off, and how stiff it is where that is known.
struct Tissue {
  double ml = 0;
  std::optional<double> mean_kPa = {};  // Young's modulus
  double confident_share = 0;           // of the tissue with a trusted value
};

struct SegmentAnswer {
  int number = 0;
  double removed_ml = 0;  // both without tumours
  Tissue left;
  double living_ml = 0;  // of what is left: perfused and drained
};

// Where a branch enters what is taken out. What hangs on it is not listed again.
struct CutBranch {
  std::size_t branch = 0;  // of LiverParts::trees
  Eigen::Vector3d at_mm{0, 0, 0};
  double radius_mm = 0;
  double beyond_ml = 0;    // all that hung on it; none on arteries and bile ducts
  double affected_ml = 0;  // of that, what stays in the patient
  double beyond_mm = 0;    // of its centre line in the liver, with all that grows from it
  double left_mm = 0;      // of that, what runs in what stays
};
// What lies beyond a cut as a person is told: ml of tissue, or mm of an artery's or a bile duct's own length.
struct BeyondCut {
  double beyond = 0, left = 0;  // all of it, and of that what stays in the patient
  const char* unit = "ml";
};
// Nothing where it is less than 1 ml or 10 mm.
[[nodiscard]] std::optional<BeyondCut> beyond_cut(const CutBranch& cut, vasculature::System system);

enum class Side { removed, left, cut_through };
[[nodiscard]] const char* side_name(Side side);  // "removed", "left", "cut-through"

struct MarginAnswer {
  std::string tumour;
  Side side = Side::removed;
  double margin_mm = 0;      // to the cut inside the liver, within half a voxel; 0 where it goes through
  bool is_at_least = false;  // no cut within largest_margin_mm, which margin_mm then is
};

struct PlanAnswer {
  double liver_ml = 0, tumours_ml = 0;
  double removed_ml = 0, remnant_ml = 0;  // together the liver
  double ablated_ml = 0;                  // of what is removed, what no knife takes
  double functional_remnant_ml = 0;       // without tumours
  // Of the remnant; absent where the case has no trees of that system.
  std::optional<double> perfused_ml, ischaemic_ml, drained_ml, congested_ml, living_ml;
  Tissue left;                          // the remnant without tumours
  std::vector<SegmentAnswer> segments;  // those that the liver has
  std::vector<MarginAnswer> tumours;    // as given
  std::vector<CutBranch> branches;      // the most beyond_ml first, then the most beyond_mm
  std::optional<double> margin_mm;      // the smallest of tumours that are not left
  bool margin_is_at_least = false;

  [[nodiscard]] double functional_ml() const { return liver_ml - tumours_ml; }
  // Of the liver without tumours.
  [[nodiscard]] double remnant_percent() const;
  [[nodiscard]] double living_percent() const;  // the same of what lives; of the remnant without trees
};

class Planner {
 public:
  // Failures: "liver-empty", "plan-too-many-tumours" (255).
  static Result<Planner> open(const LiverParts& parts, const Progress& progress = {});

  // Failures, a sentence each: "plan-empty" (no cut), "cut-invalid", "cut-misses", "segment-unknown", "segment-empty",
  // "segments-missing", "branch-unknown", "territory-empty", "tumour-unknown", "margin-invalid", "ablation-invalid",
  // "nothing-left".
  [[nodiscard]] Result<PlanAnswer> answer(const std::vector<Cut>& cuts) const;

  // 1 where tissue stays and 2 where it goes, on the part of the liver's grid around it. Fails as answer() does.
  [[nodiscard]] Result<imaging::Mask> parts(const std::vector<Cut>& cuts) const;

  // The same answer with each plane and sheet among the cuts unrolled, in order. Fails as answer() does.
  struct Unrolled {
    PlanAnswer answer;
    std::vector<Resectogram> resectograms;
  };
  [[nodiscard]] Result<Unrolled> answer_unrolled(const std::vector<Cut>& cuts, double step_mm = 1) const;

  [[nodiscard]] const vasculature::VesselTrees& trees() const;
  [[nodiscard]] std::vector<std::string> tumours() const;
  [[nodiscard]] double tumours_ml() const;  // of all together
  // The whole tissue: of each segment (0: all), and of each branch by itself.
  [[nodiscard]] std::array<Tissue, 9> segments() const;
  [[nodiscard]] std::vector<Tissue> branches() const;

 private:
  struct Liver;
  explicit Planner(std::shared_ptr<const Liver> liver) : liver_(std::move(liver)) {}
  std::shared_ptr<const Liver> liver_;
};

}  // namespace glisson::planning
