#include "widgets/resect/live_resection.h"

#include "geometry/clip_surface.h"
#include "widgets/work/run_in_background.h"

namespace glisson::widgets {

struct LyingPatient {
  LiveResection::Holding holding;
  rehearsal::LyingLiver liver;
  std::vector<PatientStructure> structures;
  std::vector<rehearsal::NamedStructure> inside;  // the same without the liver, with how far they were moved
};

namespace {

using rehearsal::ResectionSide;

struct Answer {
  std::shared_ptr<const LiveResectionResult> result;
  std::shared_ptr<const LyingPatient> lying;
};
using Outcome = Result<Answer>;

constexpr int pause_ms = 60;  // between movements of the hand that belong together

// Each structure's smooth surface on the two sides of the cut.
std::vector<ResectedPiece> pieces_of(const std::vector<PatientStructure>& structures, const geometry::CutSurface& cut,
                                     bool specimen_is_above) {
  std::vector<ResectedPiece> pieces;
  for (const PatientStructure& structure : structures) {
    for (const auto side : {geometry::CutSide::above, geometry::CutSide::below}) {
      auto piece = std::make_shared<geometry::Surface>(geometry::clipped(*structure.surface, cut, side));
      if (piece->triangles.empty()) continue;
      const bool specimen = (side == geometry::CutSide::above) == specimen_is_above;
      pieces.push_back({structure.name, specimen ? ResectionSide::specimen : ResectionSide::remnant, std::move(piece)});
    }
  }
  return pieces;
}

std::vector<rehearsal::NamedStructure> inside_of_liver(const std::vector<PatientStructure>& structures) {
  std::vector<rehearsal::NamedStructure> inside;
  for (const PatientStructure& structure : structures) {
    if (structure.name != "liver") {
      inside.push_back({structure.name, casefile::resection_kind(structure.name), *structure.surface});
    }
  }
  return inside;
}

// Under the tool; without one, at rest.
Result<std::shared_ptr<const LyingPatient>> lying_under(const rehearsal::StaticRehearsal& body,
                                                        const std::vector<PatientStructure>& structures,
                                                        const std::optional<LiveResection::Holding>& holding) {
  const geometry::TetMesh& rest = body.patient().mesh();
  auto lying = std::make_shared<LyingPatient>();
  lying->structures = structures;
  lying->inside = inside_of_liver(structures);
  if (!holding) {
    lying->liver = rehearsal::at_rest(rest);
    return lying;
  }
  lying->holding = *holding;
  const auto placed = body.place_tool(holding->center_mm, holding->radius_mm, rehearsal::StaticRehearsal::On::patient);
  if (!placed) return failure(placed.error());
  const std::vector<Eigen::Vector3d> moved_mm = placed->patient_displacement_mm(holding->force_N);
  auto displaced = rehearsal::displaced(rest, moved_mm);
  if (!displaced) return failure(std::move(displaced.error()));
  lying->liver = *std::move(displaced);
  lying->liver.validity = placed->answer(holding->force_N).validity;
  lying->inside = rehearsal::displaced(rest, moved_mm, std::move(lying->inside));
  std::size_t next = 0;
  for (PatientStructure& structure : lying->structures) {
    if (structure.name == "liver") {
      auto moved =
          rehearsal::displaced(rest, moved_mm, {{"liver", rehearsal::StructureKind::cyst, *structure.surface}});
      structure.surface = std::make_shared<geometry::Surface>(std::move(moved.front().surface));
    } else {
      structure.surface = std::make_shared<geometry::Surface>(lying->inside[next++].surface);
    }
  }
  return lying;
}

Outcome planned(std::shared_ptr<const LyingPatient> lying, const casefile::PlannedCut& cut) {
  auto surface = casefile::surface_of(cut);
  if (!surface) return failure(std::move(surface.error()));
  auto plan = casefile::plan_resection(lying->liver, cut, lying->inside);
  if (!plan) return failure(std::move(plan.error()));
  for (const PatientStructure& structure : lying->structures) {
    if (structure.name == "liver") casefile::measure_as_outlined(*plan, structure.volume_ml);
  }
  auto result = std::make_shared<LiveResectionResult>();
  result->cut = cut;
  result->pieces = pieces_of(lying->structures, *surface, plan->specimen_is_above);
  result->towards_specimen = (plan->specimen_is_above ? 1.0 : -1.0) * surface->normal();
  result->plan = *std::move(plan);
  return Answer{std::move(result), std::move(lying)};
}

}  // namespace

LiveResection::LiveResection(QObject* parent) : QObject(parent) {
  pause_.setSingleShot(true);
  pause_.setInterval(pause_ms);
  connect(&pause_, &QTimer::timeout, this, &LiveResection::compute);
}

void LiveResection::set_patient(const Patient& patient) {
  body_ = patient.rehearsal;
  structures_ = patient.structures;
  holding_.reset();
  lying_.reset();
  set_cut({});
}

void LiveResection::set_holding(const std::optional<Holding>& holding) {
  if (holding == holding_) return;
  holding_ = holding;
  lying_.reset();
  result_.reset();  // of a liver that lay elsewhere
  set_cut(wanted_);
}

void LiveResection::set_cut(const std::optional<casefile::PlannedCut>& cut) {
  ++asked_;
  wanted_ = cut;
  if (wanted_ && body_) {
    if (!pause_.isActive()) pause_.start();
    return;
  }
  pause_.stop();
  result_.reset();
  problem_.reset();
  Q_EMIT changed();
}

void LiveResection::compute() {
  if (computing_ || !wanted_ || !body_) return;
  computing_ = true;
  const auto show = [this, asked = asked_, holding = holding_](const Outcome& outcome) {
    computing_ = false;
    if (asked != asked_ && wanted_) pause_.start();
    // An answer to a cut that has moved on is shown all the same, unless there is none any more: it keeps pace.
    if (!wanted_ || !body_) return;
    if (holding != holding_) return;  // a new answer is on its way
    result_ = outcome ? outcome->result : nullptr;
    if (outcome) lying_ = outcome->lying;
    problem_ = outcome ? std::nullopt : std::optional(outcome.error());
    Q_EMIT changed();
  };
  run_in_background(
      this,
      [body = body_, structures = structures_, cut = *wanted_, holding = holding_, lying = lying_]() -> Outcome {
        if (lying) return planned(lying, cut);
        auto made = lying_under(*body, structures, holding);
        return made ? planned(*std::move(made), cut) : Outcome(failure(made.error()));
      },
      show);
}

}  // namespace glisson::widgets
