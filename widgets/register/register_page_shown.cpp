// What the Register workspace shows of its sequence: pictures, heat meshes, figures, a place's history, and its words.

#include <cmath>
#include <QLocale>

#include "widgets/panels/parts.h"
#include "widgets/register/reading_sentence.h"
#include "widgets/register/register_page.h"
#include "widgets/words/numbers.h"
#include "widgets/words/paths.h"
#include "widgets/words/translated.h"

namespace glisson::widgets {

void RegisterPage::show_frame() {
  if (!has_sequence()) return;
  const int frame = timeline_->frame();
  const auto read = images_.image(frame, sequence_->files.images[static_cast<std::size_t>(frame)]);
  if (!read) say([error = read.error()] { return translated(error); });
  const QImage image = read.value_or(QImage());
  if (!image.isNull()) size_px_ = image.size();
  // Without a picture the mesh is drawn on black, as large as the camera's middle tells.
  if (size_px_.isEmpty() && sequence_->files.camera) size_px_ = picture_size(sequence_->files.camera->matrix);
  for (HeatVideo* video : videos_) video->show_frame(image, size_px_);
}

void RegisterPage::show_meshes() {
  if (!has_sequence()) return;
  const auto quality_of = [&](int side) { return judged(side) != nullptr ? &judged(side)->quality : nullptr; };
  const scene::HeatScale scale = scale_for(quality_of(0), quality_of(1), reading_->value());
  legend_->show_scale(scale);
  legend_->setVisible(quality_of(0) != nullptr || quality_of(1) != nullptr);
  for (const int side : {0, 1}) {
    HeatVideo& video = *videos_[static_cast<std::size_t>(side)];
    const auto frame = static_cast<std::size_t>(timeline_->frame());
    if (quality_of(side) != nullptr && sequence_->files.camera) {
      video.show_mesh(heat_mesh(*quality_of(side), reading_->value(), frame, tolerance_mm()), *sequence_->files.camera,
                      scale);
    } else {
      video.show_no_mesh();
    }
  }
}

void RegisterPage::show_figures() {
  reading_->figures().show_figures({judged(0), judged(1)}, {side_name(0), side_name(1)}, tolerance_mm(),
                                   timeline_->frame());
  const QString reading =
      has_sequence() ? reading_of({NamedJudgement{side_name(0), judged(0)}, NamedJudgement{side_name(1), judged(1)}},
                                  tolerance_mm(), static_cast<std::size_t>(timeline_->frame()), sequence_->files.camera)
                     : QString();
  show_text(reading_text_, reading);
}

void RegisterPage::choose_at(const QPointF& pixel) {
  choose(videos_[0]->triangle_at(pixel), videos_[1]->triangle_at(pixel));
}

void RegisterPage::choose_triangle(std::optional<std::size_t> triangle) {
  const auto middle = triangle ? videos_[0]->middle_of(*triangle) : std::nullopt;
  choose(triangle, middle ? videos_[1]->triangle_at(*middle) : std::nullopt);
}

void RegisterPage::choose(std::optional<std::size_t> first, std::optional<std::size_t> second) {
  chosen_ = {first, second};
  for (const std::size_t side : {0, 1}) videos_[side]->choose(chosen_[side]);
  history_->show_triangle(judged(0) != nullptr ? judged(0)->quality.mesh.triangles.size() : 0, first);
  show_history();
}

void RegisterPage::show_history() {
  std::array<std::optional<TriangleHistory::Line>, 2> lines;
  for (const int side : {0, 1}) {
    const auto& triangle = chosen_[static_cast<std::size_t>(side)];
    if (!triangle || judged(side) == nullptr) continue;
    lines[static_cast<std::size_t>(side)] = {side_name(side), judged(side)->quality.courses[*triangle]};
  }
  history_->show_courses(lines, tolerance_mm());
  std::array<std::optional<TriangleHistory::Frames>, 2> frames;
  for (const int side : {0, 1}) {
    if (judged(side) == nullptr) continue;
    const registration_quality::Quality& quality = judged(side)->quality;
    frames[static_cast<std::size_t>(side)] = {side_name(side), quality.tre_mm, quality.rmse_mm};
  }
  history_->show_frames(frames);
  say_of_place();
}

void RegisterPage::say_of_place() {
  QStringList sentences;
  for (const int side : {0, 1}) {
    if (const auto& triangle = chosen_[static_cast<std::size_t>(side)]) sentences << hint(side, *triangle);
  }
  const bool something = judged(0) != nullptr || judged(1) != nullptr;
  history_->say(!sentences.isEmpty() ? sentences.join("\n")
                : something          ? tr("Click a triangle to see its history.")
                                     : QString());
}

QString RegisterPage::hint(int side, std::size_t triangle) const {
  if (judged(side) == nullptr) return {};
  const registration_quality::Quality& quality = judged(side)->quality;
  const double here_mm = quality.courses[triangle].error_mm[static_cast<std::size_t>(timeline_->frame())];
  const QString here = std::isfinite(here_mm) ? tr("%1 mm in this frame").arg(number(here_mm))
                                              : tr("not all its corners are seen in this frame");
  const QString verdict = is_rejected(quality, triangle, tolerance_mm()) ? tr("rejected") : tr("accepted");
  return tr("%1, triangle %2: correlation %3; off by %4 mm on average, %5; %6")
      .arg(side_name(side))
      .arg(triangle + 1)
      .arg(number(quality.correlation[triangle], 2), number(quality.error_mm[triangle]), here, verdict);
}

// ---- Words ----

void RegisterPage::update_text() {
  bool known = true;
  for (const int side : {0, 1}) known = known && (!algorithms_->method(side) || judged(side) != nullptr);
  using Work = AlgorithmChoice::Work;
  algorithms_->show_work(!has_sequence() ? Work::none_open
                         : working_      ? Work::under_way
                         : known         ? Work::done
                                         : Work::to_do);
  if (has_sequence()) {
    file_->setText(tr("%1: %2 frames, %3 landmarks")
                       .arg(text_of(sequence_->file.parent_path().filename()))
                       .arg(sequence_->files.clouds.size())
                       .arg(sequence_->files.landmarks.size()));
    origin_->setText(translated(sequence_->files.simulated));
    origin_->setVisible(!sequence_->files.simulated.empty());
  }
  const QString said = said_ ? said_() : QString();
  welcome_->say(working_ ? tr("One moment...") : said);
  QStringList notes;
  if (!said.isEmpty()) notes << said;
  for (const int side : {0, 1}) {
    if (judged(side) == nullptr) continue;
    for (const Sentence& note : judged(side)->quality.notes) notes << side_name(side) + ": " + translated(note) + ".";
  }
  show_text(notes_, notes.join(" "));
  update_view_text();
  show_figures();
  show_history();
}

void RegisterPage::update_view_text() {
  for (const int side : {0, 1}) {
    HeatVideo& video = *videos_[static_cast<std::size_t>(side)];
    const auto chosen = algorithms_->method(side);
    video.setVisible(chosen.has_value());
    if (!chosen || !has_sequence()) continue;
    video.setToolTip(tr("Click a triangle to see its history; hover over it for its figures"));
    const Judged* one = judged(side);
    if (one == nullptr) {
      video.set_words(long_name(*chosen), tr("Not registered yet: press \"Register and judge\"."));
      continue;
    }
    video.set_words(
        tr("%1: %2 % of %3 triangles rejected at %4 mm")
            .arg(short_name(*chosen), number(100 * rejected_fraction(one->quality, tolerance_mm())))
            .arg(one->quality.mesh.triangles.size())
            .arg(number(tolerance_mm())),
        !sequence_->files.camera ? tr("The sequence names no camera, so that no mesh can be drawn over the video.")
        : sequence_->files.images.front().empty() ? tr("The sequence names no pictures; the mesh is drawn on black.")
                                                  : QString());
  }
  const HeatValue value = reading_->value();
  legend_->set_words(
      value == HeatValue::correlation ? tr("Correlation")
      : value == HeatValue::error     ? tr("Error\n(mm)")
                                      : tr("Doubt\n(mm)"),
      tr("good"), tr("bad"),
      value == HeatValue::error ? tr("rejected: off by %1 mm or more").arg(number(tolerance_mm())) : QString());
}

QString RegisterPage::side_name(int side) const {
  const auto chosen = algorithms_->method(side);
  return chosen ? short_name(*chosen) : QString::fromUtf8("–");
}

}  // namespace glisson::widgets
