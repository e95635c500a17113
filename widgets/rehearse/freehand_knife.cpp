#include "widgets/rehearse/freehand_knife.h"

#include <algorithm>

#include "widgets/words/translated.h"

namespace glisson::widgets {
namespace {

using Eigen::Vector3d;
using rehearsal::Stroke;

constexpr int look_every_ms = 15;
constexpr scene::Colour line_colour{1.0, 0.85, 0.30};

std::optional<scene::View::Pick> under(const SpaceView& space, const QPointF& position) {
  const QPointF at = position * space.devicePixelRatioF();
  return space.view().pick(at.x(), at.y());
}

// Away from the eye, through what lies there.
Vector3d sight_through(const SpaceView& space, const Vector3d& place_mm, const QPointF& position) {
  constexpr double deeper_mm = 100;
  const QPointF at = position * space.devicePixelRatioF();
  const Vector3d behind_mm = place_mm + deeper_mm * space.view().camera().sight;
  return (space.view().position_beside(behind_mm, at.x(), at.y()) - place_mm).normalized();
}

}  // namespace

FreehandKnife::FreehandKnife(LinkedViews& views, PatientViews& patient_views, LiveRehearsal& rehearsal, QObject* parent)
    : QObject(parent), views_(views), patient_views_(patient_views), rehearsal_(rehearsal) {
  timer_.setInterval(look_every_ms);
  connect(&timer_, &QTimer::timeout, this, &FreehandKnife::advance);
}

std::array<SpaceView*, 2> FreehandKnife::spaces() const { return {&views_.space(), &views_.second_space()}; }

void FreehandKnife::take_in_hand(bool in_hand) {
  if (in_hand == in_hand_) return;
  in_hand_ = in_hand;
  for (SpaceView* space : spaces()) {
    in_hand ? space->installEventFilter(this) : space->removeEventFilter(this);
    in_hand ? space->setCursor(Qt::CrossCursor) : space->unsetCursor();
  }
  pressed_ = false;
  if (drawing_) lift();
}

bool FreehandKnife::eventFilter(QObject* watched, QEvent* event) {
  const auto type = event->type();
  if (type != QEvent::MouseButtonPress && type != QEvent::MouseMove && type != QEvent::MouseButtonRelease) return false;
  const auto all = spaces();
  const auto space = std::find(all.begin(), all.end(), watched);
  if (space == all.end()) return false;
  const auto& mouse = static_cast<const QMouseEvent&>(*event);
  if (type == QEvent::MouseButtonPress) {
    if (!pressed_) pressed_ = begin(**space, mouse);
    return pressed_;
  }
  if (!pressed_) return false;
  if (drawing_) draw(**space, mouse.position());
  if (type == QEvent::MouseButtonRelease) {
    pressed_ = false;
    if (drawing_) lift();
  }
  return true;
}

bool FreehandKnife::begin(const SpaceView& space, const QMouseEvent& event) {
  if (event.button() != Qt::LeftButton || event.modifiers() != Qt::NoModifier || space.over_grip(event.position()))
    return false;
  const auto pick = under(space, event.position());
  const auto place = pick ? patient_views_.place_on_liver(*pick) : std::nullopt;
  if (!place || rehearsal_.frozen()) return false;
  if (stroke_) {
    Q_EMIT said(tr("The last line is still being cut."));
    return true;
  }
  const Vector3d sight = sight_through(space, pick->position_mm, event.position());
  constexpr double flattest = 0.3;  // cosine: 73 degrees
  if (-sight.dot(pick->normal) < flattest) {
    Q_EMIT said(tr("The cut would skim the liver here: turn it until you look onto its surface."));
    return true;
  }
  // From the end of the last line its cut goes on.
  const auto strips = rehearsal_.cut_along();
  constexpr double near_mm = 8;
  if (!strips.empty() && strips.back().surface.is_swept() &&
      (strips.back().surface.through_mm().back() - place->at_rest_mm).norm() < near_mm) {
    stroke_ = Stroke::going_on(strips.back());
  } else {
    stroke_.emplace(place->at_rest_mm, depth_mm_ * (place->turned_to_rest * sight));
  }
  drawing_ = true;
  asked_ = false;
  ahead_mm_ = {pick->position_mm};
  timer_.start();
  return true;
}

void FreehandKnife::draw(const SpaceView& space, const QPointF& position) {
  const auto pick = under(space, position);
  if (pick && patient_views_.on_wall(*pick)) return;  // into the gap behind, which says nothing of the way
  const auto place = pick ? patient_views_.place_on_liver(*pick) : std::nullopt;
  if (!place) {
    Q_EMIT said(tr("The line left the liver: the cut ends at its edge."));
    lift();
    return;
  }
  const std::size_t before = stroke_->line_mm().size();
  if (auto drawn = stroke_->draw_to(place->at_rest_mm); !drawn) {
    Q_EMIT said(translated(drawn.error()));
    lift();
    return;
  }
  if (stroke_->line_mm().size() > before) {
    ahead_mm_.push_back(pick->position_mm);
    show_line();
  }
  advance();
}

void FreehandKnife::lift() {
  drawing_ = false;
  advance();
}

void FreehandKnife::advance() {
  if (!stroke_ || !rehearsal_.answered()) return;
  if (asked_ && rehearsal_.refusal()) return end();  // the window says why; what was cut before stays
  const bool all_at_once = rehearsal_.deformations() == Deformations::meshfree;
  if (drawing_ && all_at_once) return;
  const double before_mm = stroke_->cut_mm();
  const auto strip = stroke_->next_advance(drawing_ ? Stroke::Hand::draws : Stroke::Hand::lifted);
  if (!strip) {
    if (!drawing_) end();
    return;
  }
  asked_ = true;
  const auto cut = static_cast<std::size_t>((stroke_->cut_mm() - before_mm) / Stroke::apart_mm);
  ahead_mm_.erase(ahead_mm_.begin(),
                  ahead_mm_.begin() + static_cast<std::ptrdiff_t>(std::min(cut, ahead_mm_.size() - 1)));
  rehearsal_.advance_cut(*strip);
  show_line();
}

void FreehandKnife::end() {
  stroke_.reset();
  drawing_ = false;
  timer_.stop();
  ahead_mm_.clear();
  show_line();
}

void FreehandKnife::show_line() {
  std::vector<scene::DrawnLines> lines;
  if (ahead_mm_.size() > 1) {
    scene::DrawnLines& line = lines.emplace_back(scene::DrawnLines{{}, line_colour, 3});
    const Vector3d lifted_mm = -1.5 * views_.space().view().camera().sight;  // off the surface, which would hide it
    for (std::size_t p = 1; p < ahead_mm_.size(); ++p) {
      line.ends_mm.insert(line.ends_mm.end(), {ahead_mm_[p - 1] + lifted_mm, ahead_mm_[p] + lifted_mm});
    }
  }
  for (SpaceView* space : spaces()) {
    space->view().set_drawn_lines(lines);
    space->redraw();
  }
}

}  // namespace glisson::widgets
