#include "mechanics/cutting/opening.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>
#include <mutex>
#include <utility>

#include "mechanics/cutting/internal/opening_state.h"
#include "mechanics/elements/load_vector.h"

namespace glisson::mechanics {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

Result<Opening> Opening::of(StaticModel model, Loads standing_loads, SeenPart seen) {
  const Body& body = model.body();
  auto force_mN = load_vector(body.mesh, body.layout, body.boundary, body.options.density_kg_mm3, standing_loads);
  if (!force_mN) return failure(std::move(force_mN.error()));
  return Opening(
      std::make_shared<State>(std::move(model), std::move(standing_loads), std::move(*force_mN), std::move(seen)));
}

Result<Opening> Opening::advanced(const CutStrip& strip) const {
  const Body& body = state_->model.body();
  if (body.options.capsule) {
    return failure(Error{"not-available",
                         GLISSON_TEXT("A cut cannot advance through a body with a capsule."),
                         {},
                         GLISSON_TEXT("Leave the capsule out, or cut before the rehearsal."),
                         {}});
  }
  if (!((strip.to_mm - strip.from_mm).norm() > 0) || !strip.from_mm.allFinite() || !strip.to_mm.allFinite()) {
    return failure("cut-invalid", GLISSON_TEXT("The cut's advance needs two different places to go between."));
  }
  auto next = std::make_shared<State>(*state_);
  const auto leads_on = [&](const PartlyCut& known) {
    return strip.surface.is_same(known.along->surface) || strip.surface.goes_on(known.along->surface);
  };
  auto cut = std::find_if(next->cuts.begin(), next->cuts.end(), leads_on);
  if (cut == next->cuts.end()) {
    cut = next->cuts.insert(cut, {surface_in_body(next->model, next->standing_loads, strip), {}, {}});
  } else if (!strip.surface.is_same(cut->along->surface)) {
    if (state_->model.reduced_functions() != nullptr) {
      return failure(Error{"not-available",
                           GLISSON_TEXT("Meshfree nodes reach ahead of a cut: its line cannot be drawn further once it "
                                        "is cut along."),
                           {},
                           GLISSON_TEXT("Give the whole line before its first advance, or begin a new cut."),
                           {}});
    }
    if (auto led = next->lead_on(*cut, strip); !led) return failure(std::move(led.error()));
  }
  const std::vector<WholeWall> before = std::exchange(cut->walls, {});
  cut->strips.push_back(strip);
  cut->walls = whole_walls(body.mesh, cut->along->crossing, cut->strips);
  const double whole_before_mm2 = before.empty() ? all_area_mm2(cut->walls) : whole_area_mm2(before);

  const std::vector<int> functions = next->functions_to_open(*cut);
  if (next->meets_another_cut(functions, *cut->along)) {
    return failure(Error{"cuts-meet",
                         GLISSON_TEXT("The cut crosses an earlier one, whose walls would have to be divided too."),
                         {},
                         GLISSON_TEXT("Go on along the earlier cut, or keep farther away from it."),
                         {}});
  }
  if (functions.empty() && whole_area_mm2(cut->walls) == whole_before_mm2) {
    return failure("cut-misses", GLISSON_TEXT("The cut opens nothing: all that lies along it is open already, held, or "
                                              "outside of the body."));
  }
  if (auto opened = next->open_functions(functions, cut->along); !opened) return failure(std::move(opened.error()));
  if (auto factorised = next->factorise(); !factorised) return failure(std::move(factorised.error()));
  return Opening(std::move(next));
}

Result<bool> Opening::prepare(const CutStrip& ahead) const {
  const auto cut = std::find_if(state_->cuts.begin(), state_->cuts.end(),
                                [&](const PartlyCut& known) { return known.along->surface.is_same(ahead.surface); });
  if (cut == state_->cuts.end() || ahead.surface.is_swept()) return false;
  const SurfaceInBody& along = *cut->along;
  const double from_mm = (ahead.from_mm - along.begin_mm).dot(along.forward);
  const double until_mm = (ahead.to_mm - along.begin_mm).dot(along.forward);
  const std::vector<double>& at_mm = along.functions->at_mm;
  for (std::size_t f = 0; f < at_mm.size(); ++f) {
    if (at_mm[f] < from_mm || at_mm[f] > until_mm) continue;
    {
      const std::lock_guard lock(along.mutex);
      if (along.solved[f]) continue;
    }
    auto one = state_->solved(along, static_cast<int>(f));
    if (!one) return failure(std::move(one.error()));
    return true;
  }
  return false;
}

const std::vector<int>& Opening::points() const { return state_->points; }
const std::vector<Vector3d>& Opening::normals() const { return state_->normals; }
bool Opening::is_cut(std::size_t point) const { return state_->is_cut[point] != 0; }
const VectorXd& Opening::standing_load() const { return state_->standing_load; }
double Opening::relative_residual() const { return state_->relative_residual; }

VectorXd Opening::load_of_force(Index row, const Vector3d& force_mN) const {
  VectorXd load(state_->standing_load.size());
  for (const OpenFunction& open : state_->open) {
    load.segment(open.first, open.size()) = -open.solved->v.middleRows<3>(row).transpose() * force_mN;
  }
  return load;
}

VectorXd Opening::load_of_push(std::size_t point, const Vector3d& direction) const {
  return state_->jumps.middleRows(3 * static_cast<Index>(point), 3).transpose() * direction;
}

MatrixXd Opening::amplitudes_mm(const MatrixXd& load) const {
  return state_->open.empty() ? load : MatrixXd(state_->factor->solve(load));
}

VectorXd Opening::jumps_mm(const VectorXd& amplitudes_mm) const { return state_->jumps * amplitudes_mm; }

VectorXd Opening::seen_mm(const VectorXd& amplitudes_mm) const {
  return state_->open.empty() ? VectorXd() : seen_mm(amplitudes_mm, state_->open.front().solved->v.rows());
}

VectorXd Opening::seen_mm(const VectorXd& amplitudes_mm, Index rows) const {
  VectorXd sum_mm = VectorXd::Zero(rows);
  for (const OpenFunction& open : state_->open) {
    sum_mm -= open.solved->v.topRows(rows) * amplitudes_mm.segment(open.first, open.size());
  }
  return sum_mm;
}

double Opening::open_mm2() const {
  double sum_mm2 = 0;
  for (const PartlyCut& cut : state_->cuts) sum_mm2 += all_area_mm2(cut.walls) - whole_area_mm2(cut.walls);
  return sum_mm2;
}

double Opening::whole_mm2() const {
  double sum_mm2 = 0;
  for (const PartlyCut& cut : state_->cuts) {
    if (!cut.along->surface.is_swept()) sum_mm2 += whole_area_mm2(cut.walls);
  }
  return sum_mm2;
}

VectorXd Opening::force_on_nodes_mN(const VectorXd& amplitudes_mm) const {
  VectorXd force_mN = VectorXd::Zero(state_->standing_force_mN.size());
  for (const OpenFunction& open : state_->open) {
    force_mN -= open.of().coupling.middleCols(Index{open.size()} * open.function, open.size()) *
                amplitudes_mm.segment(open.first, open.size());
  }
  return force_mN;
}

VectorXd Opening::of_nodes_mm(const VectorXd& amplitudes_mm) const {
  VectorXd moved_mm = VectorXd::Zero(state_->standing_force_mN.size());
  for (const OpenFunction& open : state_->open) {
    moved_mm += open.of().of_nodes_mm(open.function, amplitudes_mm.segment(open.first, open.size()));
  }
  return moved_mm;
}

}  // namespace glisson::mechanics
