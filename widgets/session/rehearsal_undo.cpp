#include "session/rehearsal_undo.h"

#include <QJsonArray>
#include <QJsonObject>

namespace glisson::widgets {
namespace {

constexpr int rest_ms = 400;
constexpr const char* key = "rehearse/tool";

QJsonArray json_of(const Eigen::Vector3d& vector) { return {vector.x(), vector.y(), vector.z()}; }

Eigen::Vector3d vector_of(const QJsonValue& value) {
  const QJsonArray numbers = value.toArray();
  return {numbers.at(0).toDouble(), numbers.at(1).toDouble(), numbers.at(2).toDouble()};
}

}  // namespace

RehearsalUndo::RehearsalUndo(LiveRehearsal& rehearsal, Undo& undo, QObject* parent)
    : QObject(parent), rehearsal_(rehearsal), undo_(undo) {
  rest_.setSingleShot(true);
  rest_.setInterval(rest_ms);
  connect(&rest_, &QTimer::timeout, this, &RehearsalUndo::note);
  connect(&rehearsal_, &LiveRehearsal::frame_changed, this, [this] { rest_.start(); });
  undo_.keep(key, [this](const QJsonValue& now) { apply(now); });
}

void RehearsalUndo::begin() {
  rest_.stop();
  known_ = state();
}

QJsonValue RehearsalUndo::state() const {
  if (!rehearsal_.has_tool()) return {};
  const ToolInHand& tool = rehearsal_.tools().back();
  return QJsonObject{{"preset", QString::fromStdString(tool.preset)},
                     {"center_mm", json_of(tool.center_mm)},
                     {"outward", json_of(tool.outward)},
                     {"radius_mm", tool.radius_mm},
                     {"force_N", tool.force_N},
                     {"direction", json_of(tool.direction)}};
}

void RehearsalUndo::note() {
  if (rehearsal_.touch() != Touch::patch || rehearsal_.shown_moment() || rehearsal_.solving() == Solving::solving)
    return;
  const QJsonValue now = state();
  if (now == known_) return;
  const QJsonObject before = known_.toObject(), after = now.toObject();
  const Sentence name = known_.isNull()                             ? Sentence{GLISSON_TEXT("Place the tool"), {}}
                        : now.isNull()                              ? Sentence{GLISSON_TEXT("Take the tool away"), {}}
                        : before["center_mm"] != after["center_mm"] ? Sentence{GLISSON_TEXT("Move the tool"), {}}
                                                                    : Sentence{GLISSON_TEXT("Change the force"), {}};
  undo_.value_changed(name, key, known_, now);
  known_ = now;
}

void RehearsalUndo::apply(const QJsonValue& wanted) {
  known_ = wanted;
  if (!rehearsal_.body() || rehearsal_.touch() != Touch::patch) return;
  if (wanted.isNull() || wanted.isUndefined()) {
    if (rehearsal_.has_tool()) rehearsal_.take_tool_away();
    return;
  }
  const QJsonObject tool = wanted.toObject();
  ToolInHand hand;
  hand.preset = tool["preset"].toString().toStdString();
  hand.center_mm = vector_of(tool["center_mm"]);
  hand.outward = vector_of(tool["outward"]);
  hand.radius_mm = tool["radius_mm"].toDouble();
  hand.force_N = tool["force_N"].toDouble();
  hand.direction = vector_of(tool["direction"]);
  rehearsal_.hold(hand);
}

}  // namespace glisson::widgets
