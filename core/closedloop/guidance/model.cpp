#include "closedloop/guidance/model.h"

#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>
#include <map>
#include <mutex>

#include "base/parallel.h"
#include "base/units.h"
#include "closedloop/guidance/internal/grouped_rows.h"
#include "closedloop/guidance/internal/quadratic_surface.h"
#include "closedloop/guidance/internal/seen_row.h"
#include "closedloop/palpation/internal/effects.h"
#include "closedloop/palpation/internal/frame.h"
#include "closedloop/palpation/internal/linear_derivatives.h"
#include "closedloop/palpation/internal/loading.h"
#include "closedloop/palpation/internal/refinement.h"
#include "closedloop/palpation/internal/search.h"
#include "closedloop/palpation/internal/solver.h"
#include "closedloop/palpation/internal/state.h"

namespace glisson::closedloop {
namespace {

using Eigen::Vector3d;

class GuidanceModel : public ForwardModel {
 public:
  GuidanceModel(Guidance experiment, PalpationSolver solver, QuadraticSurface surface, LoadColumns columns,
                std::vector<History> histories);

  Result<void> observe();  // once, before anything else

  [[nodiscard]] const Observations& observations() const override { return observations_; }
  [[nodiscard]] const std::vector<Effect>& catalogue() const override { return catalogue_; }
  [[nodiscard]] Result<Eigen::VectorXd> predict(const Settings& settings) const override;
  [[nodiscard]] Result<Linearisation> linearise(const Settings& settings) const override;
  [[nodiscard]] SystematicUncertainty systematic_uncertainty() const override;
  [[nodiscard]] std::vector<Start> starts(const Effect& effect, const Settings& active,
                                          const Eigen::VectorXd& residual) const override;
  [[nodiscard]] bool predicts_quickly() const override { return false; }

 private:
  [[nodiscard]] PalpationState state(const Settings& settings) const { return state_of(settings, supports_); }
  [[nodiscard]] Loading loading(const PalpationState& state) const {
    return loading_of(shots_, histories_, columns_, experiment_.organ.gravity_mm_s2, state);
  }
  [[nodiscard]] double promise(const Effect& effect, const Settings& active, const Eigen::VectorXd& start,
                               const Eigen::VectorXd& residual) const;
  // How far each place is moved (mm; 3 rows a place, a column a frame): in the organ's frame, and as the camera sees
  // it.
  [[nodiscard]] Result<Eigen::MatrixXd> displacements(const PalpationState& state) const;
  [[nodiscard]] Result<Eigen::MatrixXd> seen(const Settings& settings) const;
  // Of a frame's points, on the surface as it is seen.
  [[nodiscard]] std::vector<QuadraticSurface::Place> nearest(std::size_t frame, const Eigen::MatrixXd& seen_mm) const;
  // `rows`, where asked for, become those of the places that are nearest now.
  [[nodiscard]] Eigen::VectorXd predicted(const Eigen::MatrixXd& seen_mm, std::vector<SeenRow>* rows) const;

  Guidance experiment_;
  PalpationSolver solver_;
  QuadraticSurface surface_;
  LoadColumns columns_;
  std::vector<History> histories_;
  std::vector<Shot> shots_;  // one a frame
  DeclaredSupports supports_;
  std::vector<Effect> catalogue_;
  Observations observations_;
  std::vector<SeenRow> rows_;
  std::vector<Vector3d> places_mm_;                         // at rest: the surface's nodes, then the landmarks
  std::vector<std::vector<Eigen::Index>> landmark_places_;  // of each frame, among them
  mutable std::once_flag uncertainty_once_;
  mutable SystematicUncertainty uncertainty_;
};

// Where values are asked for: at the surface's nodes, then at the landmarks, each once.
struct Places {
  std::vector<Vector3d> rest_mm;
  std::vector<std::vector<Eigen::Index>> landmarks;  // of each frame, among rest_mm
};
Places places_of(const QuadraticSurface& surface, const Guidance& experiment);
std::vector<Effect> catalogue_of(const Guidance& experiment, const SpecimenBody& specimen);

}  // namespace

Result<std::unique_ptr<ForwardModel>> guidance_model(Guidance experiment, const Progress& progress) {
  progress.report(0.0, GLISSON_TEXT("Preparing the specimen"));
  const Palpation& organ = experiment.organ;
  auto specimen =
      specimen_body(organ.mesh, organ.cell_young_kPa, organ.supports, organ.poisson_ratio, organ.density_kg_mm3);
  if (!specimen) return failure(std::move(specimen.error()));
  LoadColumns columns;
  Eigen::MatrixXd loads_mN;
  auto histories = histories_and_loads(organ, *specimen, columns, loads_mN);
  if (!histories) return failure(std::move(histories.error()));
  QuadraticSurface surface(specimen->body);
  Interpolation places(specimen->body.layout,
                       mechanics::locate_points(specimen->body.mesh, places_of(surface, experiment).rest_mm));
  auto solver =
      PalpationSolver::create(std::move(*specimen), std::move(loads_mN), std::move(places), progress.part(0.1, 1.0));
  if (!solver) return failure(std::move(solver.error()));
  auto model = std::make_unique<GuidanceModel>(std::move(experiment), std::move(*solver), std::move(surface), columns,
                                               std::move(*histories));
  if (auto observed = model->observe(); !observed) return failure(std::move(observed.error()));
  progress.report(1.0, GLISSON_TEXT("Solved the declared specimen"));
  return model;
}

namespace {

Places places_of(const QuadraticSurface& surface, const Guidance& experiment) {
  Places places{surface.rest_mm(), {}};
  std::map<std::array<double, 3>, Eigen::Index> known;
  for (const PalpationTrial& frame : experiment.organ.trials) {
    auto& of_frame = places.landmarks.emplace_back();
    for (const Marker& landmark : frame.samples.back().markers) {
      const Vector3d& at = landmark.rest_mm;
      const auto [place, is_new] =
          known.try_emplace({at.x(), at.y(), at.z()}, static_cast<Eigen::Index>(places.rest_mm.size()));
      if (is_new) places.rest_mm.push_back(at);
      of_frame.push_back(place->second);
    }
  }
  return places;
}

std::vector<Effect> catalogue_of(const Guidance& experiment, const SpecimenBody& specimen) {
  bool pushed = false;
  for (const PalpationTrial& frame : experiment.organ.trials) pushed = pushed || frame.samples.back().force_mN != 0;
  std::vector<Effect> catalogue;
  for (Effect& effect : palpation_catalogue(experiment.organ, specimen)) {
    const bool of_frames = effect.kind == palpation::stiffness_scale ||
                           (effect.kind == palpation::support_compliance && effect.form != palpation::form_layer) ||
                           effect.kind == palpation::stiff_inclusion || effect.kind == palpation::frame_misalignment ||
                           (effect.kind == palpation::force_bias && pushed);
    if (!of_frames) continue;
    if (effect.kind == palpation::stiffness_scale)
      effect.sentence =
          GLISSON_TEXT("The whole organ is stiffer or softer than declared, everywhere by the same factor.");
    if (effect.kind == palpation::support_compliance)
      effect.sentence =
          GLISSON_TEXT("What holds the organ gives way like a spring: all of it moves when a tool moves it.");
    if (effect.kind == palpation::stiff_inclusion)
      effect.sentence =
          GLISSON_TEXT("Somewhere inside lies a stiff lump, as a tumour would: around it the organ gives way less.");
    if (effect.kind == palpation::frame_misalignment)
      effect.sentence =
          GLISSON_TEXT("The camera stands elsewhere than declared: everything is seen turned and shifted alike.");
    if (effect.kind == palpation::force_bias) {
      effect.sentence =
          GLISSON_TEXT("The tools push with another force than declared, by the same factor in all frames.");
      effect.parameters.erase(effect.parameters.begin());  // the zero of a load cell
      for (Eigen::VectorXd& start : effect.starts) start = start.tail(1).eval();
    }
    catalogue.push_back(std::move(effect));
  }
  for (Effect& effect : attachment_effects(experiment.organ, specimen)) catalogue.push_back(std::move(effect));
  return catalogue;
}

GuidanceModel::GuidanceModel(Guidance experiment, PalpationSolver solver, QuadraticSurface surface, LoadColumns columns,
                             std::vector<History> histories)
    : experiment_(std::move(experiment)),
      solver_(std::move(solver)),
      surface_(std::move(surface)),
      columns_(columns),
      histories_(std::move(histories)),
      supports_(declared_supports(solver_.specimen())),
      catalogue_(catalogue_of(experiment_, solver_.specimen())) {
  Places places = places_of(surface_, experiment_);
  places_mm_ = std::move(places.rest_mm);
  landmark_places_ = std::move(places.landmarks);
  for (std::size_t f = 0; f < experiment_.organ.trials.size(); ++f) shots_.push_back({f, 1, 0, {}});
}

Result<void> GuidanceModel::observe() {
  const auto declared_mm = seen({});
  if (!declared_mm) return failure(declared_mm.error());
  observations_.unit = "mm";
  observations_.directions = {"x", "y", "z", "surface"};
  std::vector<Observation> rows;
  int point = 0;
  for (std::size_t trial = 0; trial < experiment_.trials.size(); ++trial) {
    observations_.trials.push_back(experiment_.trials[trial].id);
    int sample = 0;
    for (const std::size_t f : experiment_.trials[trial].frames) {
      const PalpationTrial& frame = experiment_.organ.trials[f];
      const PalpationSample& seen = frame.samples.back();
      const auto shot = static_cast<Eigen::Index>(f);
      shots_[f].first_row = static_cast<Eigen::Index>(rows.size());
      const auto row = [&](double measured, double noise, int direction, const Vector3d& place_mm) {
        const Vector3d& tool_mm = frame.tool.center_mm;
        rows.push_back({.measured = measured,
                        .noise = noise,
                        .trial = static_cast<int>(trial),
                        .sample = sample,
                        .direction = direction,
                        .point = point,
                        .time_s = experiment_.time_s[f],
                        .load = units::N_from_mN(seen.force_mN),
                        .place_mm = place_mm,
                        .conditions = {tool_mm.x(), tool_mm.y(), tool_mm.z()}});
      };
      for (std::size_t l = 0; l < seen.markers.size(); ++l, ++point) {
        const Marker& landmark = seen.markers[l];
        for (int d = 0; d < 3; ++d) {
          row(landmark.position_mm[d] - landmark.rest_mm[d], experiment_.landmark_noise_mm, d, landmark.rest_mm);
          SeenRow& as_seen = rows_.emplace_back();
          as_seen.shot = shot;
          as_seen.places[0] = landmark_places_[f][l];
          as_seen.weights[0] = 1;
          as_seen.direction = Vector3d::Unit(d);
        }
      }
      const auto& points_mm = experiment_.points_mm[f];
      const auto places = nearest(f, *declared_mm);
      for (std::size_t p = 0; p < points_mm.size(); ++p, ++point) {
        SeenRow& as_seen = rows_.emplace_back(SeenRow{shot, places[p].nodes, places[p].weights, places[p].normal});
        Vector3d rest_mm = Vector3d::Zero();
        for (std::size_t i = 0; i < 6; ++i) {
          rest_mm += as_seen.weights[static_cast<Eigen::Index>(i)] *
                     surface_.rest_mm()[static_cast<std::size_t>(as_seen.places[i])];
        }
        row(as_seen.direction.dot(points_mm[p] - rest_mm), experiment_.organ.noise_mm, 3, rest_mm);
      }
      ++sample;
    }
  }
  observations_.add(rows);
  return {};
}

Result<Eigen::MatrixXd> GuidanceModel::displacements(const PalpationState& at) const {
  return solver_.at_markers(at.scaled_structure()).map([&](const Eigen::MatrixXd& response) {
    return (response * loading(at).amounts / at.stiffness_factor).eval();
  });
}

Result<Eigen::MatrixXd> GuidanceModel::seen(const Settings& settings) const {
  const PalpationState at = state(settings);
  auto u_mm = displacements(at);
  if (!u_mm) return u_mm;
  const Eigen::Matrix3d turn_less_one = rotation(at.rotation_deg) - Eigen::Matrix3d::Identity();
  for (Eigen::Index shot = 0; shot < u_mm->cols(); ++shot) {
    for (std::size_t i = 0; i < places_mm_.size(); ++i) {
      auto u = u_mm->col(shot).segment<3>(3 * static_cast<Eigen::Index>(i));
      u += (turn_less_one * (places_mm_[i] + u) + at.translation_mm).eval();
    }
  }
  return u_mm;
}

std::vector<QuadraticSurface::Place> GuidanceModel::nearest(std::size_t frame, const Eigen::MatrixXd& seen_mm) const {
  std::vector<Vector3d> positions = surface_.rest_mm();
  for (std::size_t i = 0; i < positions.size(); ++i) {
    positions[i] += seen_mm.col(static_cast<Eigen::Index>(frame)).segment<3>(3 * static_cast<Eigen::Index>(i));
  }
  return surface_.nearest(positions, experiment_.points_mm[frame]);
}

Result<Eigen::VectorXd> GuidanceModel::predict(const Settings& settings) const {
  const auto seen_mm = seen(settings);
  if (!seen_mm) return failure(seen_mm.error());
  return predicted(*seen_mm, nullptr);
}

// A row's derivative is that of the place that is nearest now: that it slides along the surface changes the distance
// to second order only. Differences of distances would jump where another face becomes the nearest.
Result<Linearisation> GuidanceModel::linearise(const Settings& settings) const {
  const PalpationState at = state(settings);
  const auto here_mm = seen(settings);
  if (!here_mm) return failure(here_mm.error());
  const auto fields = linear_derivatives(solver_, columns_, loading(at), at, settings);
  if (!fields) return failure(fields.error());
  const auto u_mm = displacements(at);
  if (!u_mm) return failure(u_mm.error());
  std::vector<SeenRow> rows = rows_;
  Linearisation result{predicted(*here_mm, &rows), Eigen::MatrixXd(observations_.rows(), parameter_count(settings))};
  const Eigen::Matrix3d turn = rotation(at.rotation_deg);
  const auto turns = rotation_derivatives(at.rotation_deg);
  Eigen::VectorXd rest_mm(u_mm->rows());
  for (std::size_t i = 0; i < places_mm_.size(); ++i)
    rest_mm.segment<3>(3 * static_cast<Eigen::Index>(i)) = places_mm_[i];
  Eigen::Index column = 0;
  for (const Setting& setting : settings) {
    for (Eigen::Index p = 0; p < setting.parameters.size(); ++p, ++column) {
      const Eigen::MatrixXd& field = (*fields)[static_cast<std::size_t>(column)];
      const auto change = [&](const SeenRow& row) -> Vector3d {
        if (setting.kind != palpation::frame_misalignment) return turn * row.of(field.col(row.shot));
        if (p >= 3) return Vector3d::Unit(p - 3) * row.weights.sum();
        return turns[static_cast<std::size_t>(p)] * (row.of(rest_mm) + row.of(u_mm->col(row.shot)));
      };
      for (std::size_t r = 0; r < rows.size(); ++r)
        result.derivatives(static_cast<Eigen::Index>(r), column) = rows[r].direction.dot(change(rows[r]));
    }
  }
  return result;
}

// What sits at a place is looked for everywhere at once; a declared attachment that is missing promises what it takes
// of the residual; the rest has its own starts.
std::vector<Start> GuidanceModel::starts(const Effect& effect, const Settings& active,
                                         const Eigen::VectorXd& residual) const {
  std::vector<Start> starts;
  if (effect.kind == palpation::stiff_inclusion || effect.kind == palpation::undeclared_attachment) {
    const PalpationState at = state(active);
    const SeenNumbers left = grouped_rows(rows_, observations_, residual, loading(at).amounts / at.stiffness_factor,
                                          rotation(at.rotation_deg), solver_);
    starts = effect.kind == palpation::stiff_inclusion ? inclusion_starts(effect, solver_, at, left)
                                                       : attachment_starts(effect, solver_, at, left);
  }
  if (starts.empty()) starts = ForwardModel::starts(effect, active, residual);
  if (effect.kind == palpation::missing_attachment) {
    for (Start& start : starts) start.promise = promise(effect, active, start.values, residual);
  }
  return starts;
}

// Of the square of the residual, in noises.
double GuidanceModel::promise(const Effect& effect, const Settings& active, const Eigen::VectorXd& start,
                              const Eigen::VectorXd& residual) const {
  Settings begun = active;
  begun.push_back({effect.kind, effect.form, start});
  const auto after = predict(begun);
  if (!after) return 0;
  const Eigen::VectorXd left = (observations_.measured - *after).cwiseQuotient(observations_.noise);
  return std::max(0.0, residual.cwiseQuotient(observations_.noise).squaredNorm() - left.squaredNorm());
}

Eigen::VectorXd GuidanceModel::predicted(const Eigen::MatrixXd& seen_mm, std::vector<SeenRow>* rows) const {
  Eigen::VectorXd predicted(observations_.rows());
  parallel_for(shots_.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t f = begin; f < end; ++f) {
      const auto shot = static_cast<Eigen::Index>(f);
      Eigen::Index row = shots_[f].first_row;
      for (const Eigen::Index place : landmark_places_[f]) {
        predicted.segment<3>(row) = seen_mm.col(shot).segment<3>(3 * place);
        row += 3;
      }
      for (const auto& place : nearest(f, seen_mm)) {
        predicted[row] = observations_.measured[row] - place.distance_mm;
        if (rows != nullptr) (*rows)[static_cast<std::size_t>(row)] = {shot, place.nodes, place.weights, place.normal};
        ++row;
      }
    }
  });
  return predicted;
}

// As a palpation's (palpation/model.cpp): the error that a finer mesh shows, mostly of the response's own shape, and a
// third as much at each place by itself.
SystematicUncertainty GuidanceModel::systematic_uncertainty() const {
  constexpr double at_each_place = 1.0 / 3, of_the_response = 0.5;
  std::call_once(uncertainty_once_, [&] {
    const std::vector<FaceLoad> tools = tool_loads(experiment_.organ, histories_, solver_.specimen().body);
    const Eigen::MatrixXd error_mm = discretisation_error_mm(solver_, places_mm_, tools);
    const auto response_mm = solver_.at_markers({});
    const Eigen::Index loads = error_mm.cols();
    if (loads == 0 || !response_mm) return;
    const Eigen::MatrixXd amounts = loading({}).amounts;
    uncertainty_.directions.resize(observations_.rows(), 2 * loads);
    uncertainty_.shared = Eigen::VectorXd::Zero(observations_.rows());
    uncertainty_.group.resize(rows_.size());
    for (Eigen::Index l = 0; l < loads; ++l) {
      const Eigen::VectorXd error = error_mm.col(l), response = response_mm->col(l);
      const double share = of_the_response * error.norm() / response.norm();
      const double size_mm = at_each_place * error.norm() / std::sqrt(static_cast<double>(error.size()));
      for (std::size_t r = 0; r < rows_.size(); ++r) {
        const auto row = static_cast<Eigen::Index>(r);
        const double amount = amounts(l, rows_[r].shot);
        uncertainty_.directions(row, l) = amount * rows_[r].direction.dot(rows_[r].of(error));
        uncertainty_.directions(row, loads + l) = amount * share * rows_[r].direction.dot(rows_[r].of(response));
        uncertainty_.shared[row] += std::abs(amount) * size_mm;
      }
    }
    // Rows of one load at one place are off together.
    const auto places = static_cast<Eigen::Index>(error_mm.rows() / 3);
    for (std::size_t r = 0; r < rows_.size(); ++r) {
      Eigen::Index heaviest = 0;
      rows_[r].weights.maxCoeff(&heaviest);
      const Eigen::Index place = rows_[r].places[static_cast<std::size_t>(heaviest)];
      uncertainty_.group[r] = static_cast<int>(
          4 * (histories_[static_cast<std::size_t>(rows_[r].shot)].load * places + place) + observations_.direction[r]);
    }
    uncertainty_.expected = uncertainty_.directions.leftCols(loads).rowwise().sum();
    uncertainty_.indistinct = uncertainty_.directions.leftCols(loads).norm() /
                              std::sqrt(static_cast<double>(observations_.rows())) / experiment_.organ.noise_mm;
  });
  return uncertainty_;
}

}  // namespace
}  // namespace glisson::closedloop
