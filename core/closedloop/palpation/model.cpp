#include "closedloop/palpation/model.h"

#include <algorithm>
#include <cmath>
#include <Eigen/QR>
#include <limits>
#include <mutex>

#include "base/json.h"
#include "base/units.h"
#include "closedloop/inference/fit.h"
#include "closedloop/palpation/internal/effects.h"
#include "closedloop/palpation/internal/error_at_strain.h"
#include "closedloop/palpation/internal/frame.h"
#include "closedloop/palpation/internal/further.h"
#include "closedloop/palpation/internal/linear_derivatives.h"
#include "closedloop/palpation/internal/loading.h"
#include "closedloop/palpation/internal/marker_rows.h"
#include "closedloop/palpation/internal/refinement.h"
#include "closedloop/palpation/internal/search.h"
#include "closedloop/palpation/internal/solver.h"
#include "closedloop/palpation/internal/state.h"
#include "closedloop/palpation/internal/stiffened_response.h"

namespace glisson::closedloop {
namespace {

std::vector<LoadRange> load_ranges(const std::vector<History>& histories, const std::vector<FaceLoad>& tools);

class PalpationModel : public ForwardModel {
 public:
  PalpationModel(Palpation experiment, PalpationSolver solver, LoadColumns columns, std::vector<History> histories,
                 MarkerRows markers)
      : experiment_(std::move(experiment)),
        solver_(std::move(solver)),
        columns_(columns),
        histories_(std::move(histories)),
        markers_(std::move(markers)),
        catalogue_(palpation_catalogue(experiment_, solver_.specimen())),
        supports_(declared_supports(solver_.specimen())),
        tools_(tool_loads(experiment_, histories_, solver_.specimen().body)),
        error_at_strain_(solver_, markers_.places_mm, tools_, load_ranges(histories_, tools_)),
        stiffened_(
            solver_,
            [this](const Settings& settings) {
              const PalpationState at = state(settings);
              return Acting{at, loading(at).amounts / at.stiffness_factor};
            },
            [this](const Acting& acting) {
              return error_at_strain_.beyond_linear_mm(*acting.state.stiffening, acting.amounts);
            }) {}

  [[nodiscard]] const Observations& observations() const override { return markers_.observations; }
  [[nodiscard]] const std::vector<Effect>& catalogue() const override { return catalogue_; }
  [[nodiscard]] Result<Eigen::VectorXd> predict(const Settings& settings) const override;
  [[nodiscard]] Result<Linearisation> linearise(const Settings& settings) const override;
  [[nodiscard]] SystematicUncertainty systematic_uncertainty() const override;
  [[nodiscard]] Eigen::MatrixXd unlisted_shapes() const override;
  [[nodiscard]] std::vector<Start> starts(const Effect& effect, const Settings& active,
                                          const Eigen::VectorXd& residual) const override;

  [[nodiscard]] bool predicts_quickly() const override { return false; }
  [[nodiscard]] std::vector<FurtherTrial> further_trials() const override;
  [[nodiscard]] Result<Eigen::VectorXd> predict_further(const Settings& settings) const override;
  [[nodiscard]] Result<Linearisation> linearise_further(const Settings& settings) const override;

 private:
  [[nodiscard]] PalpationState state(const Settings& settings) const { return state_of(settings, supports_); }
  [[nodiscard]] Loading loading(const PalpationState& state) const {
    return loading_of(markers_.shots, histories_, columns_, experiment_.gravity_mm_s2, state);
  }
  [[nodiscard]] Result<Eigen::MatrixXd> displacements(const Settings& settings) const;
  [[nodiscard]] double promise_of_linear_fit(const Effect& effect, const Settings& active, const Start& start,
                                             const Eigen::VectorXd& residual) const;
  [[nodiscard]] double promise_of_stiffening(const Effect& effect, const Settings& active,
                                             const ResidualField& left) const;

  Palpation experiment_;
  PalpationSolver solver_;
  LoadColumns columns_;
  std::vector<History> histories_;
  MarkerRows markers_;
  std::vector<Effect> catalogue_;
  DeclaredSupports supports_;

  std::vector<FaceLoad> tools_;
  ErrorAtStrain error_at_strain_;
  StiffenedResponse stiffened_;
  [[nodiscard]] const ForwardModel* further() const;

  mutable std::once_flag further_once_;
  mutable std::unique_ptr<ForwardModel> further_;  // of all further trials; nothing where they cannot be solved
  mutable std::once_flag uncertainty_once_;
  mutable SystematicUncertainty uncertainty_;
};

bool stiffens(const PalpationState& state) { return state.stiffening && state.stiffening->coefficient != 0; }

}  // namespace

Result<std::unique_ptr<ForwardModel>> palpation_model(Palpation experiment, const Progress& progress) {
  progress.report(0.0, GLISSON_TEXT("Preparing the specimen"));
  auto specimen = specimen_body(experiment.mesh, experiment.cell_young_kPa, experiment.supports,
                                experiment.poisson_ratio, experiment.density_kg_mm3);
  if (!specimen) return failure(std::move(specimen.error()));
  LoadColumns columns;
  Eigen::MatrixXd loads_mN;
  auto histories = histories_and_loads(experiment, *specimen, columns, loads_mN);
  if (!histories) return failure(std::move(histories.error()));

  auto seen = marker_rows(experiment);
  if (!seen) return failure(std::move(seen.error()));
  Interpolation markers(specimen->body.layout, mechanics::locate_points(specimen->body.mesh, seen->places_mm));
  auto solver =
      PalpationSolver::create(std::move(*specimen), std::move(loads_mN), std::move(markers), progress.part(0.1, 1.0));
  if (!solver) return failure(std::move(solver.error()));
  progress.report(1.0, GLISSON_TEXT("Solved the declared specimen"));
  return std::make_unique<PalpationModel>(std::move(experiment), std::move(*solver), columns, std::move(*histories),
                                          std::move(*seen));
}

namespace {

Result<Eigen::VectorXd> PalpationModel::predict(const Settings& settings) const {
  return displacements(settings).map([&](const Eigen::MatrixXd& u_mm) { return markers_.seen(state(settings), u_mm); });
}

Result<Linearisation> PalpationModel::linearise(const Settings& settings) const {
  const PalpationState at = state(settings);
  auto u_mm = displacements(settings);
  if (!u_mm) return failure(std::move(u_mm.error()));
  auto fields = at.stiffening ? stiffened_.derivatives_at_markers(settings)
                              : linear_derivatives(solver_, columns_, loading(at), at, settings);
  if (!fields) return failure(std::move(fields.error()));

  Linearisation result{markers_.seen(at, *u_mm),
                       Eigen::MatrixXd(markers_.observations.rows(), parameter_count(settings))};
  const Eigen::Matrix3d turn = rotation(at.rotation_deg);
  const auto turns = rotation_derivatives(at.rotation_deg);
  Eigen::Index column = 0;
  for (const Setting& setting : settings) {
    for (Eigen::Index p = 0; p < setting.parameters.size(); ++p, ++column) {
      const Eigen::MatrixXd& field = (*fields)[static_cast<std::size_t>(column)];
      result.derivatives.col(column) = markers_.rows([&](Eigen::Index place, Eigen::Index shot) -> Eigen::Vector3d {
        if (setting.kind != palpation::frame_misalignment) return turn * field.col(shot).segment<3>(3 * place);
        if (p >= 3) return Eigen::Vector3d::Unit(p - 3);
        return turns[static_cast<std::size_t>(p)] *
               (markers_.places_mm[static_cast<std::size_t>(place)] + u_mm->col(shot).segment<3>(3 * place));
      });
    }
  }
  return result;
}

// The discretisation error as the finer mesh shows it, tool by tool, at the loads that were read. The finer mesh is not
// exact either: what is still missing then is taken for a third as large at each marker, and mostly of the response's
// own shape, since coarse meshes are stiff: half of the error's share of it. (Both as seen against meshes four times
// as fine, of blocks, cylinders and a curved lobe.)
SystematicUncertainty PalpationModel::systematic_uncertainty() const {
  constexpr double at_each_marker = 1.0 / 3, of_the_response = 0.5;
  std::call_once(uncertainty_once_, [&] {
    const Eigen::MatrixXd error_mm = discretisation_error_mm(solver_, markers_.places_mm, tools_);
    const auto response_mm = solver_.at_markers({});
    const Eigen::Index loads = error_mm.cols();
    if (loads == 0 || !response_mm) return;
    const Eigen::MatrixXd amounts = loading({}).amounts;
    const auto of_rows = [&](Eigen::Index load, const auto& field_mm) {
      return markers_.rows([&](Eigen::Index place, Eigen::Index shot) -> Eigen::Vector3d {
        return amounts(load, shot) * field_mm.template segment<3>(3 * place);
      });
    };
    uncertainty_.directions.resize(markers_.observations.rows(), 2 * loads);
    uncertainty_.shared = Eigen::VectorXd::Zero(markers_.observations.rows());
    uncertainty_.group.assign(static_cast<std::size_t>(markers_.observations.rows()), 0);
    for (Eigen::Index l = 0; l < loads; ++l) {
      const Eigen::VectorXd error = error_mm.col(l), response = response_mm->col(l);
      uncertainty_.directions.col(l) = of_rows(l, error);
      const double share = of_the_response * error.norm() / response.norm();
      uncertainty_.directions.col(loads + l) = of_rows(l, (share * response).eval());
      const double size_mm = at_each_marker * error.norm() / std::sqrt(static_cast<double>(error.size()));
      uncertainty_.shared += of_rows(l, Eigen::VectorXd::Constant(error.size(), size_mm).eval());
    }
    for (const Shot& shot : markers_.shots) {
      Eigen::Index row = shot.first_row;
      for (const Eigen::Index place : shot.markers) {
        for (int d = 0; d < 3; ++d, ++row) {
          uncertainty_.group[static_cast<std::size_t>(row)] = static_cast<int>(
              histories_[shot.trial].load * static_cast<Eigen::Index>(3 * markers_.places_mm.size()) + 3 * place + d);
        }
      }
    }
    uncertainty_.expected = uncertainty_.directions.leftCols(loads).rowwise().sum();
    uncertainty_.indistinct = uncertainty_.directions.leftCols(loads).norm() /
                              std::sqrt(static_cast<double>(markers_.observations.rows())) / experiment_.noise_mm;
  });
  return uncertainty_;
}

std::vector<LoadRange> load_ranges(const std::vector<History>& histories, const std::vector<FaceLoad>& tools) {
  std::vector<LoadRange> ranges;
  for (const FaceLoad& tool : tools) {
    LoadRange range;
    for (const History& history : histories) {
      if (history.load != tool.load || history.reading_mN.size() == 0) continue;
      range.pulled_mN = std::min(range.pulled_mN, history.reading_mN.minCoeff());
      range.pressed_mN = std::max(range.pressed_mN, history.reading_mN.maxCoeff());
    }
    ranges.push_back(range);
  }
  return ranges;
}

// In each trial and direction a linear function of the place that grows with the load, as an elastic body's answer
// does.
Eigen::MatrixXd PalpationModel::unlisted_shapes() const {
  const Observations& all = markers_.observations;
  const Eigen::RowVector3d middle = all.place_mm.colwise().mean();
  const auto directions = static_cast<Eigen::Index>(all.directions.size());
  Eigen::MatrixXd shapes = Eigen::MatrixXd::Zero(all.rows(), 4 * directions * all.trial_count());
  for (Eigen::Index row = 0; row < all.rows(); ++row) {
    const auto i = static_cast<std::size_t>(row);
    const Eigen::Index first = 4 * (directions * all.trial[i] + all.direction[i]);
    shapes(row, first) = all.load[row];
    shapes.row(row).segment<3>(first + 1) = all.load[row] * (all.place_mm.row(row) - middle);
  }
  return shapes;
}

Result<Eigen::MatrixXd> PalpationModel::displacements(const Settings& settings) const {
  const PalpationState at = state(settings);
  if (stiffens(at)) {
    return stiffened_.at_markers(settings);
  }
  return solver_.at_markers(at.scaled_structure()).map([&](const Eigen::MatrixXd& response) {
    return (response * loading(at).amounts / at.stiffness_factor).eval();
  });
}

std::vector<Start> PalpationModel::starts(const Effect& effect, const Settings& active,
                                          const Eigen::VectorXd& residual) const {
  const PalpationState at = state(active);
  // Displacements of all places at all shots, from what was left over in the camera's frame.
  const Eigen::Matrix3d turn_back = rotation(at.rotation_deg).transpose();
  ResidualField left;
  left.residual_mm = Eigen::MatrixXd::Zero(3 * static_cast<Eigen::Index>(markers_.places_mm.size()),
                                           static_cast<Eigen::Index>(markers_.shots.size()));
  left.seen = Eigen::MatrixXd::Zero(left.residual_mm.rows(), left.residual_mm.cols());
  for (std::size_t s = 0; s < markers_.shots.size(); ++s) {
    Eigen::Index row = markers_.shots[s].first_row;
    for (const Eigen::Index place : markers_.shots[s].markers) {
      if (residual.segment<3>(row).allFinite()) {
        left.residual_mm.col(static_cast<Eigen::Index>(s)).segment<3>(3 * place) = turn_back * residual.segment<3>(row);
        left.seen.col(static_cast<Eigen::Index>(s)).segment<3>(3 * place).setOnes();
      }
      row += 3;
    }
  }
  left.amounts = loading(at).amounts / at.stiffness_factor;
  std::vector<Start> starts = palpation_starts(effect, solver_, at, left);
  if (starts.empty()) starts = ForwardModel::starts(effect, active, residual);
  if (effect.kind == palpation::strain_stiffening) starts.front().promise = promise_of_stiffening(effect, active, left);
  // A fit that is quick in the declared specimen is slow beside effects that change its equations.
  const bool is_slow = stiffens(at) || !(at.structure == Structure{});
  for (Start& start : starts) {
    if (is_slow && std::isinf(start.promise)) start.promise = promise_of_linear_fit(effect, active, start, residual);
    start.promise /= experiment_.noise_mm * experiment_.noise_mm;
  }
  return starts;
}

// mm2: what one linear fit of all parameters from the start would take of the residual.
double PalpationModel::promise_of_linear_fit(const Effect& effect, const Settings& active, const Start& start,
                                             const Eigen::VectorXd& residual) const {
  Settings begun = active;
  begun.push_back({effect.kind, effect.form, start.values});
  const auto linear = linearise(begun);
  if (!linear) return std::numeric_limits<double>::infinity();  // unknown
  Eigen::VectorXd left = markers_.observations.measured - linear->predicted;
  Eigen::VectorXd now = residual;
  Eigen::MatrixXd slopes = linear->derivatives;
  for (Eigen::Index row = 0; row < now.size(); ++row) {
    if (std::isfinite(now[row])) continue;  // not seen
    left[row] = now[row] = 0;
    slopes.row(row).setZero();
  }
  const Eigen::VectorXd change = slopes.colPivHouseholderQr().solve(left);
  return std::max(0.0, now.squaredNorm() - (left - slopes * change).squaredNorm());
}

// mm2. At small strain by the derivative where stiffening begins, which costs a few solves; at large strain by what the
// law does where its search begins.
double PalpationModel::promise_of_stiffening(const Effect& effect, const Settings& active,
                                             const ResidualField& left) const {
  constexpr double unknown = std::numeric_limits<double>::infinity();
  if (!bends_with_the_load(left, experiment_.noise_mm)) return 0;
  Settings begun = active;
  begun.push_back({effect.kind, effect.form, effect.starts.front()});
  const bool small_strain = effect.form == palpation::form_linear || effect.form == palpation::form_exponential;
  if (small_strain) {
    begun.back().parameters.setZero();
    const auto slopes = stiffened_.derivatives_at_markers(begun);
    return slopes ? match(left, slopes->back()).gain : unknown;
  }
  const auto before = displacements(active), after = displacements(begun);
  return before && after ? match(left, *after - *before).gain : unknown;
}

std::vector<FurtherTrial> PalpationModel::further_trials() const {
  std::vector<FurtherTrial> trials;
  for (const FurtherPalpation& further : further_palpations(experiment_, solver_.specimen().body.boundary)) {
    const PalpationTrial& trial = further.trial;
    const auto vector = [](const Eigen::Vector3d& v) { return Json{v.x(), v.y(), v.z()}; };
    Json samples = Json::array();
    Eigen::Index rows = 0;
    for (const PalpationSample& sample : trial.samples) {
      samples.push_back({{"time_s", sample.time_s}, {"force_N", units::N_from_mN(sample.force_mN)}});
      rows += 3 * static_cast<Eigen::Index>(sample.markers.size());
    }
    Json conditions{{"id", trial.id},
                    {"tool",
                     {{"center_mm", vector(trial.tool.center_mm)},
                      {"radius_mm", trial.tool.radius_mm},
                      {"direction", vector(trial.tool.direction)}}},
                    {"samples", std::move(samples)}};
    trials.push_back({further.sentence, std::make_shared<const Json>(std::move(conditions)), rows});
  }
  return trials;
}

const ForwardModel* PalpationModel::further() const {
  std::call_once(further_once_, [&] {
    Palpation all = experiment_;
    all.trials.clear();
    for (FurtherPalpation& further : further_palpations(experiment_, solver_.specimen().body.boundary))
      all.trials.push_back(std::move(further.trial));
    if (all.trials.empty()) return;
    if (auto model = palpation_model(std::move(all))) further_ = std::move(*model);
  });
  return further_.get();
}

// Its own catalogue may be another (what it can show depends on its trials), the meaning of settings is the same.
Result<Eigen::VectorXd> PalpationModel::predict_further(const Settings& settings) const {
  const ForwardModel* model = further();
  if (model == nullptr) return ForwardModel::predict_further(settings);
  return model->predict(settings).map(
      [&](const Eigen::VectorXd& predicted) { return Eigen::VectorXd(predicted / experiment_.noise_mm); });
}

Result<Linearisation> PalpationModel::linearise_further(const Settings& settings) const {
  const ForwardModel* model = further();
  if (model == nullptr) return failure(ForwardModel::predict_further(settings).error());
  return model->linearise(settings).map([&](const Linearisation& linear) {
    return Linearisation{linear.predicted / experiment_.noise_mm, linear.derivatives / experiment_.noise_mm};
  });
}

}  // namespace
}  // namespace glisson::closedloop
