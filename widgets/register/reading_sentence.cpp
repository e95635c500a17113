#include "widgets/register/reading_sentence.h"

#include <cmath>
#include <QCoreApplication>
#include <QLocale>

#include "vision/draw.h"

namespace glisson::widgets {
namespace {

using registration_quality::Quality;

struct ReadingWords {
  Q_DECLARE_TR_FUNCTIONS(glisson::widgets::RegisterPage)
};

constexpr double same_correlation = 0.02, same_share = 0.05;

// -1: the first is better, 1: the second, 0: neither.
int better_of(const Quality& a, const Quality& b, double tolerance_mm) {
  const double correlation = b.mean_correlation - a.mean_correlation;
  const double rejected = rejected_fraction(b, tolerance_mm) - rejected_fraction(a, tolerance_mm);
  const int by_correlation = std::abs(correlation) < same_correlation ? 0 : correlation > 0 ? 1 : -1;
  const int by_share = std::abs(rejected) < same_share ? 0 : rejected < 0 ? 1 : -1;
  if (by_correlation * by_share < 0) return 0;
  return by_correlation != 0 ? by_correlation : by_share;
}

// Where the rejected triangles lie in the picture, against all: "its left edge"; empty where they lie all over it.
QString place_of_rejected(const Quality& quality, double tolerance_mm, std::size_t frame,
                          const std::optional<vision::Camera>& camera) {
  if (!camera || frame >= quality.mesh_in_frames_mm.size()) return {};
  const auto pixels = vision::project(*camera, quality.mesh_in_frames_mm[frame]);
  Eigen::Vector2d sum = Eigen::Vector2d::Zero(), square = Eigen::Vector2d::Zero(), rejected = Eigen::Vector2d::Zero();
  double count = 0, rejected_count = 0;
  for (std::size_t k = 0; k < quality.mesh.triangles.size(); ++k) {
    Eigen::Vector2d middle = Eigen::Vector2d::Zero();
    bool seen = true;
    for (const int corner : quality.mesh.triangles[k]) {
      const auto& pixel = pixels[static_cast<std::size_t>(corner)];
      seen = seen && pixel.has_value();
      if (pixel) middle += *pixel / 3;
    }
    if (!seen) continue;
    sum += middle;
    square += middle.cwiseProduct(middle);
    ++count;
    if (!is_rejected(quality, k, tolerance_mm)) continue;
    rejected += middle;
    ++rejected_count;
  }
  if (count < 3 || rejected_count == 0) return {};
  const Eigen::Vector2d mean = sum / count;
  const Eigen::Vector2d spread = (square / count - mean.cwiseProduct(mean)).cwiseMax(1e-9).cwiseSqrt();
  const Eigen::Vector2d off = (rejected / rejected_count - mean).cwiseQuotient(spread);
  constexpr double clearly = 0.5;
  if (off.cwiseAbs().maxCoeff() < clearly) return {};
  if (std::abs(off.x()) >= std::abs(off.y())) {
    return off.x() < 0 ? ReadingWords::tr("the left edge") : ReadingWords::tr("the right edge");
  }
  return off.y() < 0 ? ReadingWords::tr("the upper edge") : ReadingWords::tr("the lower edge");
}

QString trust_in(const NamedJudgement& one, double tolerance_mm, std::size_t frame,
                 const std::optional<vision::Camera>& camera) {
  const double rejected = rejected_fraction(one.judged->quality, tolerance_mm);
  const QString mm = QLocale().toString(tolerance_mm, 'f', 1);
  if (rejected == 0) return ReadingWords::tr("%1 is nowhere off by %2 mm or more.").arg(one.name, mm);
  constexpr double maximum = 0.5;
  if (rejected > maximum)
    return ReadingWords::tr("Do not trust %1: on most of it landmarks are off by %2 mm or more.").arg(one.name, mm);
  const QString place = place_of_rejected(one.judged->quality, tolerance_mm, frame, camera);
  return place.isEmpty() ? ReadingWords::tr("Of %1 do not trust single places: %2 % of it is off by %3 mm or more.")
                               .arg(one.name, QLocale().toString(100 * rejected, 'f', 0), mm)
                         : ReadingWords::tr("Of %1 do not trust %2: landmarks are off by %3 mm or more there.")
                               .arg(one.name, place, mm);
}

}  // namespace

QString reading_of(const std::array<NamedJudgement, 2>& sides, double tolerance_mm, std::size_t frame,
                   const std::optional<vision::Camera>& camera) {
  const auto trust = [&](const NamedJudgement& one) { return trust_in(one, tolerance_mm, frame, camera); };
  if (sides[0].judged == nullptr && sides[1].judged == nullptr) return {};
  if (sides[0].judged == nullptr || sides[1].judged == nullptr) {
    return trust(sides[0].judged != nullptr ? sides[0] : sides[1]);
  }
  const int better = better_of(sides[0].judged->quality, sides[1].judged->quality, tolerance_mm);
  if (better == 0) {
    return ReadingWords::tr("Neither %1 nor %2 is clearly better here.").arg(sides[0].name, sides[1].name) + " " +
           trust(sides[0]);
  }
  const NamedJudgement& first = better < 0 ? sides[0] : sides[1];
  const NamedJudgement& second = better < 0 ? sides[1] : sides[0];
  return ReadingWords::tr("%1 is better here than %2.").arg(first.name, second.name) + " " + trust(first);
}

}  // namespace glisson::widgets
