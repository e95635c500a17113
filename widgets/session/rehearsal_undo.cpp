#include "widgets/session/rehearsal_undo.h"

#include <QJsonArray>
#include <QJsonObject>

namespace glisson::widgets {
namespace {

constexpr int rest_ms = 400;
constexpr const char* key = "rehearse/tool";
constexpr const char* rigid = "rigid";
constexpr const char* deformations = "deformations";
constexpr const char* large = "large";

QJsonArray qt_json_of(const Eigen::Vector3d& vector) { return {vector.x(), vector.y(), vector.z()}; }

Eigen::Vector3d vector_of(const QJsonValue& value) {
  const QJsonArray numbers = value.toArray();
  return {numbers.at(0).toDouble(), numbers.at(1).toDouble(), numbers.at(2).toDouble()};
}

QJsonObject qt_json_of(const PlacedTool& tool) {
  return {{"preset", QString::fromStdString(tool.preset)},
          {"center_mm", qt_json_of(tool.center_mm)},
          {"outward", qt_json_of(tool.outward)},
          {"radius_mm", tool.radius_mm},
          {"force_N", tool.force_N},
          {"direction", qt_json_of(tool.direction)}};
}

PlacedTool tool_of(const QJsonObject& json) {
  PlacedTool tool;
  tool.preset = json["preset"].toString().toStdString();
  tool.center_mm = vector_of(json["center_mm"]);
  tool.outward = vector_of(json["outward"]);
  tool.radius_mm = json["radius_mm"].toDouble();
  tool.force_N = json["force_N"].toDouble();
  tool.direction = vector_of(json["direction"]);
  return tool;
}

Sentence name_of(const QJsonObject& before, const QJsonObject& after) {
  const QJsonArray were = before["tools"].toArray(), are = after["tools"].toArray();
  if (before["touch"] != after["touch"]) return {GLISSON_TEXT("Another way of touching"), {}};
  if ((before[deformations] == large) != (after[deformations] == large)) {
    return {GLISSON_TEXT("Small or large deformations"), {}};
  }
  if (were.isEmpty()) return {GLISSON_TEXT("Place the tool"), {}};
  if (were.size() < are.size()) return {GLISSON_TEXT("Place another tool"), {}};
  if (were.size() > are.size()) return {GLISSON_TEXT("Take the tool away"), {}};
  const bool moved = were.last().toObject()["center_mm"] != are.last().toObject()["center_mm"];
  return {moved ? GLISSON_TEXT("Move the tool") : GLISSON_TEXT("Change the force"), {}};
}

}  // namespace

RehearsalUndo::RehearsalUndo(LiveRehearsal& rehearsal, Undo& undo, QObject* parent)
    : QObject(parent), rehearsal_(rehearsal), undo_(undo) {
  rest_.setSingleShot(true);
  rest_.setInterval(rest_ms);
  connect(&rest_, &QTimer::timeout, this, &RehearsalUndo::note);
  connect(&rehearsal_, &LiveRehearsal::state_changed, this, [this] { rest_.start(); });
  undo_.keep(key, [this](const QJsonValue& now) { apply(now); });
}

void RehearsalUndo::begin() {
  rest_.stop();
  known_ = state();
}

QJsonValue RehearsalUndo::state() const {
  QJsonArray tools;
  for (const PlacedTool& tool : rehearsal_.tools()) tools.append(qt_json_of(tool));
  return QJsonObject{{"touch", rehearsal_.touch() == Touch::rigid ? rigid : "patch"},
                     {deformations, rehearsal_.deformations() == Deformations::large ? large : "small"},
                     {"tools", tools}};
}

void RehearsalUndo::note() {
  if (!rehearsal_.body() || rehearsal_.shown_moment() || rehearsal_.solving() == Solving::solving) return;
  const QJsonValue now = state();
  if (now == known_) return;
  undo_.value_changed(name_of(known_.toObject(), now.toObject()), key, known_, now);
  known_ = now;
}

void RehearsalUndo::apply(const QJsonValue& wanted) {
  known_ = wanted;
  if (!rehearsal_.body()) return;
  const QJsonObject state = wanted.toObject();
  std::vector<PlacedTool> tools;
  for (const auto& tool : state["tools"].toArray()) tools.push_back(tool_of(tool.toObject()));
  if (state.contains("preset")) tools.push_back(tool_of(state));  // a history from when there was one tool
  const Touch touch = state["touch"].toString() == rigid ? Touch::rigid : Touch::patch;
  const Deformations kind = state[deformations].toString() == large ? Deformations::large : Deformations::small;
  if (touch != rehearsal_.touch() || kind != rehearsal_.deformations()) {
    rehearsal_.hold_all({});
    rehearsal_.set_touch(touch);
    rehearsal_.set_deformations(kind);
  }
  rehearsal_.hold_all(tools);
}

}  // namespace glisson::widgets
