#include "widgets/resect/live_resection.h"

#include <QFutureWatcher>
#include <QtConcurrentRun>

#include "geometry/clip_surface.h"

namespace glisson::widgets {
namespace {

using rehearsal::ResectionSide;
using Outcome = Result<std::shared_ptr<const LiveResectionResult>>;

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

Outcome planned(const geometry::TetMesh& liver, const std::vector<PatientStructure>& structures,
                const casefile::PlannedCut& cut) {
  std::vector<rehearsal::NamedStructure> inside;
  for (const PatientStructure& structure : structures) {
    if (structure.name != "liver") {
      inside.push_back({structure.name, casefile::resection_kind(structure.name), *structure.surface});
    }
  }
  auto surface = casefile::surface_of(cut);
  if (!surface) return failure(std::move(surface.error()));
  auto plan = casefile::plan_resection(liver, cut, inside);
  if (!plan) return failure(std::move(plan.error()));
  auto result = std::make_shared<LiveResectionResult>();
  result->cut = cut;
  result->pieces = pieces_of(structures, *surface, plan->specimen_is_above);
  result->towards_specimen = (plan->specimen_is_above ? 1.0 : -1.0) * surface->normal();
  result->plan = *std::move(plan);
  return result;
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
  set_cut({});
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
  auto* watcher = new QFutureWatcher<std::shared_ptr<Outcome>>(this);
  connect(watcher, &QFutureWatcherBase::finished, this, [this, watcher, asked = asked_] {
    watcher->deleteLater();
    computing_ = false;
    if (asked != asked_ && wanted_) pause_.start();
    // An answer to a cut that has moved on is shown all the same, unless there is none any more: it keeps pace.
    if (!wanted_ || !body_) return;
    const std::shared_ptr<Outcome> outcome = watcher->result();
    result_ = *outcome ? **outcome : nullptr;
    problem_ = *outcome ? std::nullopt : std::optional(outcome->error());
    Q_EMIT changed();
  });
  watcher->setFuture(QtConcurrent::run([body = body_, structures = structures_, cut = *wanted_] {
    return std::make_shared<Outcome>(planned(body->patient().mesh(), structures, cut));
  }));
}

}  // namespace glisson::widgets
