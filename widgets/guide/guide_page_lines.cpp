// Lines that are marked on a frame and on the model: kept in the case, undone like everything else.

#include <QJsonDocument>
#include <QJsonObject>

#include "base/json.h"
#include "guidance/seen_line.h"
#include "widgets/guide/guide_page.h"

namespace glisson::widgets {

namespace {

constexpr const char* lines_key = "guide/lines";

casefile::MarkedLine& line_in(casefile::MarkedLines& marked, const std::string& id) {
  const auto known = std::find_if(marked.lines.begin(), marked.lines.end(),
                                  [&](const casefile::MarkedLine& line) { return line.id == id; });
  return known != marked.lines.end() ? *known : marked.lines.emplace_back(casefile::MarkedLine{id, {}, {}});
}

}  // namespace

void GuidePage::connect_lines() {
  connect(&panel_->lines(), &LinePanel::turned, this, &GuidePage::set_marking);
  connect(&panel_->lines(), &LinePanel::line_chosen, this, &GuidePage::show_marks);
  connect(&panel_->lines(), &LinePanel::removing_wanted, this, [this] {
    const std::string id = panel_->lines().line();
    change_lines([&](casefile::MarkedLines& marked) {
      std::erase_if(marked.lines, [&](const casefile::MarkedLine& line) { return line.id == id; });
    });
  });
  connect(view_, &OverlayView::marked, this, &GuidePage::mark_on_frame);
  connect(space_, &SpaceView::clicked, this, &GuidePage::mark_on_model);
  context_.undo.keep(lines_key, [this](const QJsonValue& kept) {
    take_kept_lines(kept);
    show_marks();
    show_in_space();
  });
}

void GuidePage::set_marking(bool on) {
  if (on && !(has_video() && video_->sequence.camera && !size_px_.isEmpty())) return panel_->lines().set_on(false);
  if (on) panel_->set_by_hand(false);
  view_->set_marking(on);
  if (on) view_->setFocus();
  show_marks();
  show_in_space();
  update_text();
}

void GuidePage::mark_on_frame(const QPointF& at_px) {
  const auto place_mm = guidance::on_seen_surface(
      *video_->sequence.camera, video_->guided.guidance.frames[frame()].points_mm, {at_px.x(), at_px.y()});
  if (!place_mm) {
    return say([] { return tr("Nothing was seen of the surface there: an instrument, or a gap. Click beside it."); });
  }
  said_ = {};
  change_lines([&](casefile::MarkedLines& marked) {
    line_in(marked, panel_->lines().line()).seen_mm[frame()].push_back(*place_mm);
  });
}

void GuidePage::mark_on_model(const scene::View::Pick& pick) {
  if (!panel_->lines().is_on() || pick.surface != liver_in_space_) return;
  change_lines([&](casefile::MarkedLines& marked) {
    line_in(marked, panel_->lines().line()).at_rest_mm.push_back(pick.position_mm);
  });
}

void GuidePage::change_lines(const std::function<void(casefile::MarkedLines&)>& change) {
  casefile::MarkedLines changed = lines_;
  changed.sequence = video_->content;
  change(changed);
  const QByteArray text = QByteArray::fromStdString(casefile::json_of(changed).dump());
  const QJsonValue now = changed.lines.empty() ? QJsonValue(QJsonValue::Null) : QJsonDocument::fromJson(text).object();
  context_.undo.value_changed({GLISSON_TEXT("Mark a line"), {}}, lines_key, kept_lines_, now);
  take_kept_lines(now);
  show_marks();
  show_in_space();
  update_text();
}

void GuidePage::read_kept_lines() {
  const QJsonValue kept = context_.undo.value(lines_key);
  take_kept_lines(kept.isUndefined() ? QJsonValue::Null : kept);
}

// What is marked on the model serves the next video too; what is marked on frames does not.
void GuidePage::take_kept_lines(const QJsonValue& kept) {
  kept_lines_ = kept;
  lines_ = {};
  if (!has_video() || !kept.isObject()) return;
  const std::string text = QJsonDocument(kept.toObject()).toJson(QJsonDocument::Compact).toStdString();
  lines_ = casefile::marked_lines_from(Json::parse(text, nullptr, false)).value_or(casefile::MarkedLines{});
  if (lines_.sequence == video_->content) return;
  for (casefile::MarkedLine& line : lines_.lines) line.seen_mm.clear();
  lines_.sequence = video_->content;
}

void GuidePage::show_marks() {
  if (!has_video()) return;
  std::vector<OverlayView::Mark> marks;
  std::size_t on_frame = 0, on_model = 0;
  for (const casefile::MarkedLine& line : lines_.lines) {
    const bool is_current = line.id == panel_->lines().line();
    if (is_current) on_model = line.at_rest_mm.size();
    const auto seen = line.seen_mm.find(frame());
    if (seen == line.seen_mm.end() || !video_->sequence.camera) continue;
    if (is_current) on_frame = seen->second.size();
    OverlayView::Mark mark{{}, is_current};
    for (const auto& at_px : vision::project(*video_->sequence.camera, seen->second)) {
      if (at_px) mark.places_px << QPointF(at_px->x(), at_px->y());
    }
    marks.push_back(std::move(mark));
  }
  view_->show_marks(panel_->lines().is_on() ? std::move(marks) : std::vector<OverlayView::Mark>{});
  panel_->lines().show_places(on_frame, on_model);
}

}  // namespace glisson::widgets
