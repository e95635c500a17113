#include "widgets/session/rehearsal_undo.h"

#include <algorithm>
#include <array>
#include <QJsonArray>
#include <QJsonObject>

namespace glisson::widgets {
namespace {

constexpr int rest_ms = 400;
constexpr const char* key = "rehearse/tool";
constexpr const char* rigid = "rigid";
constexpr const char* deformations = "deformations";
constexpr std::array<const char*, 4> kinds{"small", "large", "meshfree", "moving"};  // of Deformations
constexpr const char* cut_key = "cut";
// What answered it, and after how many of its commands; of no matter for how things stand.
constexpr const char* session_key = "session";
constexpr const char* commands_key = "commands";

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

// Small in a history that says nothing of it.
Deformations kind_of(const QJsonObject& state) {
  const QString kind = state[deformations].toString();
  const auto found = std::find(kinds.begin(), kinds.end(), kind);
  return found == kinds.end() ? Deformations::small : static_cast<Deformations>(found - kinds.begin());
}

Sentence name_of(const QJsonObject& before, const QJsonObject& after) {
  const QJsonArray were = before["tools"].toArray(), are = after["tools"].toArray();
  if (before["touch"] != after["touch"]) return {GLISSON_TEXT("Another way of touching"), {}};
  if (kind_of(before) != kind_of(after)) return {GLISSON_TEXT("Small or large deformations"), {}};
  if (before[cut_key] != after[cut_key]) {
    const bool by_hand = (before[cut_key].toString() + after[cut_key].toString()).contains("into_mm");
    return {by_hand ? GLISSON_TEXT("Cut freehand") : GLISSON_TEXT("Cut along the plan"), {}};
  }
  if (were.isEmpty()) return {GLISSON_TEXT("Place the tool"), {}};
  if (were.size() < are.size()) return {GLISSON_TEXT("Place another tool"), {}};
  if (were.size() > are.size()) return {GLISSON_TEXT("Take the tool away"), {}};
  const bool moved = were.last().toObject()["center_mm"] != are.last().toObject()["center_mm"];
  return {moved ? GLISSON_TEXT("Move the tool") : GLISSON_TEXT("Change the force"), {}};
}

QJsonObject how_things_stand(QJsonObject state) {
  state.remove(session_key);
  state.remove(commands_key);
  return state;
}

// As commands of a session, which read back to the same bits.
QString words_of(const std::vector<mechanics::CutStrip>& strips) {
  rehearsal::Recording advances;
  for (const mechanics::CutStrip& strip : strips) advances.emplace_back(rehearsal::AdvanceCut{strip}, "");
  return QString::fromStdString(rehearsal::recording_text(advances));
}

std::vector<mechanics::CutStrip> strips_of(const QString& text) {
  std::vector<mechanics::CutStrip> strips;
  const auto advances = rehearsal::parse_recording(text.toStdString());
  if (!advances) return strips;
  for (const auto& [command, digest] : *advances) {
    if (const auto* advance = std::get_if<rehearsal::AdvanceCut>(&command)) strips.push_back(advance->strip);
  }
  return strips;
}

}  // namespace

RehearsalUndo::RehearsalUndo(LiveRehearsal& rehearsal, Undo& undo, QObject* parent)
    : QObject(parent), rehearsal_(rehearsal), undo_(undo) {
  rest_.setSingleShot(true);
  rest_.setInterval(rest_ms);
  connect(&rest_, &QTimer::timeout, this, &RehearsalUndo::note);
  connect(&rehearsal_, &LiveRehearsal::state_changed, this, [this] {
    const bool never_rests = rehearsal_.deformations() == Deformations::moving;
    if (!never_rests || !rest_.isActive()) rest_.start();
  });
  undo_.keep(key, [this](const QJsonValue& now) { apply(now); });
}

void RehearsalUndo::begin() {
  rest_.stop();
  known_ = state();
}

QJsonValue RehearsalUndo::state() const {
  QJsonArray tools;
  for (const PlacedTool& tool : rehearsal_.tools()) tools.append(qt_json_of(tool));
  QJsonObject state{{"touch", rehearsal_.touch() == Touch::rigid ? rigid : "patch"},
                    {deformations, kinds[static_cast<std::size_t>(rehearsal_.deformations())]},
                    {"tools", tools}};
  const auto strips = rehearsal_.cut_along();
  if (!strips.empty()) state[cut_key] = words_of(strips);
  return state;
}

void RehearsalUndo::note() {
  if (!rehearsal_.body() || rehearsal_.shown_moment() || rehearsal_.solving() == Solving::solving) return;
  QJsonObject now = state().toObject();
  if (now == how_things_stand(known_.toObject())) return;
  const Sentence name = name_of(known_.toObject(), now);
  std::optional<casefile::RecordingBeside> beside;
  if (!rehearsal_.session_name().empty()) {
    const rehearsal::Recording recording = rehearsal_.recording();
    now[session_key] = QString::fromStdString(rehearsal_.session_name());
    now[commands_key] = static_cast<int>(recording.size());
    beside = casefile::RecordingBeside{rehearsal_.session_name(), rehearsal::recording_text(recording)};
  }
  undo_.values_changed(name, {{key, known_, now}}, Undo::Joins::never, beside);
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
  const Deformations kind = kind_of(state);
  if (touch != rehearsal_.touch() || kind != rehearsal_.deformations()) {
    rehearsal_.hold_all({});
    rehearsal_.set_touch(touch);
    rehearsal_.set_deformations(kind);
  }
  rehearsal_.hold_all(tools);
  rehearsal_.cut_all(strips_of(state[cut_key].toString()));
}

}  // namespace glisson::widgets
