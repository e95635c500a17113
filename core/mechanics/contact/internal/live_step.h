#pragma once
// The parts of a live body, and one step of it. A step is places that touch, conjugate gradients, and the estimate of
// what is left (live_body.h says how they go together).

#include <algorithm>
#include <limits>
#include <vector>

#include "base/stopwatch.h"
#include "mechanics/contact/internal/contact_candidates.h"
#include "mechanics/contact/internal/contact_constraint.h"
#include "mechanics/contact/internal/live_cut.h"
#include "mechanics/contact/internal/quadratic_cells.h"
#include "mechanics/contact/internal/spline_levels.h"
#include "mechanics/contact/live_body.h"
#include "mechanics/elements/load_vector.h"
#include "mechanics/potentials/elastic.h"
#include "mechanics/potentials/potential.h"

namespace glisson::mechanics {

// What a live body is made of, and what does not change while it is moved.
struct LiveParts {
  // Of the dense inverse, 11 MB.
  static constexpr int most_wide_points = 560;

  StaticModel model;
  Body body;
  std::vector<Material> materials;
  Loads standing_loads;
  AppliedLoads standing;
  Potentials around;                          // what stands around the body, and inertia
  Eigen::SparseMatrix<double> inertia_mN_mm;  // of a body in motion; diagonal
  QuadraticCells cells;
  SplineLevels levels;
  geometry::Surface surface;
  std::vector<int> node_of_point;
  std::vector<PointInMesh> watched;
  std::size_t judged = 0;  // of the watched places
  std::shared_ptr<const Eigen::MatrixXf> adjoints =
      std::make_shared<Eigen::MatrixXf>();  // three columns a judged place
  std::shared_ptr<KeptAdjoints> of_last_cut = std::make_shared<KeptAdjoints>();
  bool finite_inside_out;  // the law's energy is
  double k_mN_mm = 0, pressing_kPa_mm = 0, settling_kPa_mm = 0, friction_kPa_mm = 0, k_wall_mN_mm = 0;
  LiveState untouched;

  LiveParts(StaticModel given, Body prepared, const ChosenLaw& law)
      : model(std::move(given)),
        body(std::move(prepared)),
        materials(materials_of(body, law.law, law.strain_stiffening)),
        cells(body, law),
        levels(body.layout.positions_mm, body.resolved.fixed, most_wide_points),
        finite_inside_out(law.law == MaterialLaw::neo_hookean) {}

  [[nodiscard]] Eigen::Index unknowns() const { return 3 * static_cast<Eigen::Index>(body.layout.nodes()); }
  void free(Eigen::VectorXd& values) const {
    for (Eigen::Index i = 0; i < unknowns(); ++i) {
      if (body.resolved.fixed[static_cast<std::size_t>(i)]) values[i] = 0;
    }
  }
  [[nodiscard]] Eigen::VectorXd surface_of(const Eigen::VectorXd& u_mm) const;
  [[nodiscard]] Eigen::MatrixXd unit_forces_at_judged() const;
  void show(LiveState& state) const;
};

// Forces on the unknowns: the nodes' displacements, the jumps across a cut, and after them the advances of pushed
// tools.
struct Unbalanced {
  Eigen::VectorXd resisting_mN;  // what the body and its supports resist with
  Eigen::VectorXd body_mN;       // of nodes and jumps, without the tools
  int inverted_points = 0;
};

enum class Until { shown, settled };

// One step of a live body, cut or not, from a state to the next. What it is given must outlive it.
class LiveStep {
 public:
  LiveStep(const LiveParts& parts, const LiveCut* cut, const LiveState& from, const std::vector<ContactTool>& tools,
           const LiveOptions& options, Progress progress)
      : parts_(parts),
        cut_(cut),
        tools_(tools),
        options_(options),
        progress_(std::move(progress)),
        n_(parts.unknowns() + (cut == nullptr ? 0 : 3 * Eigen::Index{cut->open.jumps()})),
        dead_mN_(n_) {
    dead_mN_.head(parts.unknowns()) = parts.standing.dead_mN;
    if (options.besides_mN) dead_mN_.head(parts.unknowns()) += *options.besides_mN;
    if (cut != nullptr) dead_mN_.tail(n_ - parts.unknowns()) = cut->standing_mN;
    state_.u_mm = Eigen::VectorXd::Zero(n_);  // what opens now has not moved apart yet
    state_.u_mm.head(from.u_mm.size()) = from.u_mm;
    state_.report.largest_strain = from.report.largest_strain;
  }

  Result<LiveState> run(const LiveState& from, Until until);

 private:
  struct Jaws {
    std::vector<int> nodes;
    std::vector<double> weights;
    Eigen::Vector3d wanted_mm;
    std::size_t tool;
  };
  // A force spread over a patch: what it puts on the nodes.
  struct Spread {
    std::size_t tool;
    std::vector<std::pair<int, Eigen::Vector3d>> force_mN;
  };
  // What a curved tool adds to the tangent at a place that it presses on: it may slide off.
  struct Bend {
    const ContactConstraint* place;
    Eigen::Matrix3d stiffness;
    int further;
    Eigen::Vector3d forward;
  };

  // Where two points that were one press on each other across a cut.
  struct Facing {
    double multiplier_mN;
    Eigen::Vector3d normal{0, 0, 1};  // as its wall lay when the round began
  };

  Result<void> take_cut(const LiveState& from);
  void face_walls();
  [[nodiscard]] double gap_mm(std::size_t wall, const Eigen::VectorXd& u_mm) const {
    return walls_[wall].normal.dot(u_mm.segment<3>(parts_.unknowns() + 3 * static_cast<Eigen::Index>(wall)));
  }
  [[nodiscard]] double pressing_mN(std::size_t wall, const Eigen::VectorXd& u_mm) const {
    return std::max(0.0, walls_[wall].multiplier_mN - parts_.k_wall_mN_mm * gap_mm(wall, u_mm));
  }
  void look_at_walls(const Eigen::VectorXd& u_mm);
  [[nodiscard]] double overlap_mm() const;
  void show_cut();
  [[nodiscard]] const QuadraticCells& cells() const { return cut_ == nullptr ? parts_.cells : cut_->others; }

  Result<void> take_tools(const LiveState& from, Until until);
  Result<void> take_touching(std::size_t tool, const TouchingTool& touching, const LiveState& from);
  void begin(const LiveState& from, Until until);
  Result<void> take_patch(std::size_t tool, const ToolLoad& patch);
  Result<void> find_places();
  void add_near_places();
  Result<void> slide_on(std::size_t tool);
  void add_place(std::size_t tool, std::size_t rod, const ContactPoint& at);
  void place_rods();
  void limit_friction();
  [[nodiscard]] Pose pose_of(std::size_t tool) const;
  [[nodiscard]] Eigen::Vector3d forward_of(std::size_t tool) const {
    return std::get<TouchingTool>(tools_[tool].what).pose.forward();
  }
  Unbalanced unbalanced(const Eigen::VectorXd& u_mm);
  int add_whole_cells(const Eigen::VectorXd& nodes_mm, Eigen::VectorXd& force_mN);
  [[nodiscard]] Unbalanced under_loads(Eigen::VectorXd resisting_mN, int inverted_points) const;
  Eigen::VectorXd with_tools(const Unbalanced& balance, const Eigen::VectorXd& u_mm);
  void look_at_rows(const Eigen::VectorXd& u_mm);
  void add_friction_rows(const ContactConstraint& place, const Eigen::VectorXd& u_mm, const Eigen::Vector3d& forward);
  Eigen::VectorXd alone(const Unbalanced& balance) const;
  enum class Presses { then, now };  // once the step is made, as the levels expect, or before it
  Eigen::VectorXd direction(const SplineLevels::WithRows& levels, const Eigen::VectorXd& r_mN, Presses when);
  void add_rows_times(const std::vector<std::uint8_t>& presses, const Eigen::VectorXd& p,
                      Eigen::VectorXd& product) const;
  [[nodiscard]] Error turned_inside_out() const;
  [[nodiscard]] bool swallows_a_tool() const;
  [[nodiscard]] Error swallowed() const;
  [[nodiscard]] Error slides_past(std::size_t tool) const;
  [[nodiscard]] double longest_part(const Eigen::VectorXd& step) const;
  void go(const Eigen::VectorXd& step, const Eigen::VectorXd& r_mN);
  [[nodiscard]] double estimate(const SplineLevels::WithRows& levels) const;
  void press_harder();
  enum class Moves { all, all_but_smooth };
  void move_multipliers_on(Moves which = Moves::all);
  [[nodiscard]] double deepest_mm() const;
  LiveState finished(const Stopwatch& watch);

  const LiveParts& parts_;
  const LiveCut* cut_;  // nullptr: nothing is cut
  const std::vector<ContactTool>& tools_;
  const LiveOptions& options_;
  Until until_ = Until::shown;
  Progress progress_;
  Eigen::Index n_;
  Eigen::VectorXd dead_mN_;  // standing loads, patches, and jaws that pull
  LiveState state_;
  Unbalanced now_;
  std::vector<int> further_of_;  // of each tool its unknown; -1: it stays where it is
  int further_ = 0;
  Eigen::VectorXd advance_mm_;  // one a tool
  std::vector<Jaws> jaws_;
  std::vector<Gripped> grips_;
  std::vector<Spread> patches_;
  std::vector<ContactConstraint> places_;
  std::vector<Facing> walls_;  // one a jump
  std::shared_ptr<const Eigen::MatrixXf> adjoints_;
  std::shared_ptr<const LiveBegin> began_;
  std::vector<StiffRow> rows_;
  std::vector<Bend> bends_;
  double tools_mN_ = 0, moved_mm_ = std::numeric_limits<double>::infinity();
  std::vector<double>
      squared_;  // of the cells, as the last forces found them: those of where it is now; empty: it has not moved
};

}  // namespace glisson::mechanics
