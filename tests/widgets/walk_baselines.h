#pragma once
// The window on a person's way, held against pictures that somebody has looked at: at 1280 x 720 and 1600 x 1000, or,
// where the program runs at twice the size, at 2560 x 1440, in English and in German.
//
// A baseline (tests/baselines/walks/NAME-SIZE-LANGUAGE.png) has a pixel for each 16 x 16 of the window, five bits a
// channel, the steps below each other: a layout, and of the patient's images no more than where they are bright. Of
// each step blocks that are off by more than `noticed` are counted, and may be one in a hundred, as in the tour's
// pictures: times and rates stand in the window. What was drawn is kept whole, and as a baseline would be, under
// pictures/ in the build folder; nothing here writes a baseline.

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <QAbstractItemView>
#include <QDir>
#include <QHoverEvent>
#include <QImage>
#include <QtTest>
#include <utility>
#include <vector>

#include "kept_pictures.h"
#include "support/folders.h"
#include "widgets/main_window.h"
#include "widgets/words/language.h"

namespace glisson::widgets {

class WalkBaselines {
 public:
  WalkBaselines(MainWindow& window, QString walk) : window_(window), walk_(std::move(walk)) {}

  // The size that a walk goes at: the largest.
  static QSize size_of_walk() { return sizes().back(); }

  // `rests` says when nothing is computed any more; what changed in size or language may begin something anew.
  void take(const QString& step, const std::function<bool()>& rests) {
    for (const QSize& size : sizes()) {
      window_.resize(size);
      for (const char* language : {"en", "de"}) {
        choose_language(language);
        QTest::qWait(100);
        (void)QTest::qWaitFor(rests, 20'000);
        QTest::qWait(150);
        const QImage picture = drawn();
        const QString sheet = sheet_of(picture.size(), language);
        picture.save(test::kept_pictures() + QString("/walk-%1-%2.png").arg(sheet, QString(step).replace(' ', '-')));
        sheets_[sheet].push_back({step, in_blocks(picture)});
      }
    }
    choose_language("en");
    window_.resize(size_of_walk());
    QTest::qWait(150);
    (void)QTest::qWaitFor(rests, 20'000);
  }

  // What is not as it was; empty where everything is.
  [[nodiscard]] QStringList differences() const {
    QStringList told;
    for (const auto& [sheet, steps] : sheets_) {
      const QString kept = test::kept_pictures() + "/walks/" + sheet + ".png";
      QDir().mkpath(test::kept_pictures() + "/walks");
      const QImage all = below_each_other(steps);
      all.save(kept);
      const QString file =
          QString::fromStdString((test::source_folder() / "tests/baselines/walks").string()) + "/" + sheet + ".png";
      const QImage baseline = QImage(file).convertToFormat(QImage::Format_RGB888);
      if (baseline.isNull()) {
        told << QString("no baseline at %1; look at %2 and copy it there if it is right").arg(file, kept);
      } else if (baseline.size() != all.size()) {
        told << QString("%1 has another size than its baseline").arg(kept);
      } else {
        int top = 0;
        for (const auto& [step, picture] : steps) {
          const double share = share_that_differs(picture, baseline.copy(0, top, picture.width(), picture.height()));
          if (share > allowed_share) {
            told << QString("%1, %2: %3 % of it differs").arg(sheet, step).arg(100 * share, 0, 'f', 2);
          }
          top += picture.height();
        }
      }
    }
    return told;
  }

 private:
  static constexpr double noticed = 12;  // of 255
  static constexpr double allowed_share = 0.01;
  using Steps = std::vector<std::pair<QString, QImage>>;

  static std::vector<QSize> sizes() {
    const bool twice = qApp->devicePixelRatio() > 1;  // 2560 x 1440 pixels then
    return twice ? std::vector<QSize>{{1280, 720}} : std::vector<QSize>{{1280, 720}, {1600, 1000}};
  }

  // With each view as it is now, however long its drawing takes, and no row lit because the pointer happens to lie
  // there.
  QImage drawn() {
    for (auto* list : window_.findChildren<QAbstractItemView*>()) {
      QHoverEvent away(QEvent::HoverLeave, QPointF(-1, -1), QPointF(-1, -1), QPointF(-1, -1));
      QCoreApplication::sendEvent(list->viewport(), &away);
    }
    LinkedViews& views = window_.views();
    if (views.space().isVisible()) (void)views.space().picture();
    for (SliceView* slice : views.slices()) {
      if (slice->isVisible()) (void)slice->picture();
    }
    return window_.grab().toImage().convertToFormat(QImage::Format_RGB888);
  }

  [[nodiscard]] QString sheet_of(const QSize& pixels, const char* language) const {
    return QString("%1-%2x%3-%4").arg(walk_).arg(pixels.width()).arg(pixels.height()).arg(language);
  }

  // A pixel a block, as large on a finer screen as on a coarse one.
  static QImage in_blocks(const QImage& picture) {
    const int block = 16 * static_cast<int>(std::lround(qApp->devicePixelRatio()));
    QImage blocks(picture.width() / block, picture.height() / block, QImage::Format_RGB888);
    for (int row = 0; row < blocks.height(); ++row) {
      uchar* mean = blocks.scanLine(row);
      for (int column = 0; column < blocks.width(); ++column) {
        std::array<int, 3> sum{};
        for (int y = row * block; y < (row + 1) * block; ++y) {
          const uchar* pixels = picture.constScanLine(y) + static_cast<std::ptrdiff_t>(3 * column * block);
          for (int k = 0; k < 3 * block; ++k) sum[static_cast<std::size_t>(k % 3)] += pixels[k];
        }
        for (const int channel : sum) *mean++ = static_cast<uchar>((channel / (block * block)) & 0xF8);
      }
    }
    return blocks;
  }

  static QImage below_each_other(const Steps& steps) {
    int height = 0;
    for (const auto& [step, picture] : steps) height += picture.height();
    QImage all(steps.front().second.width(), height, QImage::Format_RGB888);
    int row = 0;
    for (const auto& [step, picture] : steps) {
      for (int y = 0; y < picture.height(); ++y, ++row) {
        std::copy_n(picture.constScanLine(y), 3 * picture.width(), all.scanLine(row));
      }
    }
    return all;
  }

  static double share_that_differs(const QImage& a, const QImage& b) {
    int differing = 0;
    for (int y = 0; y < a.height(); ++y) {
      for (int x = 0; x < a.width(); ++x) {
        const uchar* one = a.constScanLine(y) + 3 * x;
        const uchar* other = b.constScanLine(y) + 3 * x;
        int apart = 0;
        for (int channel = 0; channel < 3; ++channel) apart = std::max(apart, std::abs(one[channel] - other[channel]));
        if (apart > noticed) ++differing;
      }
    }
    return static_cast<double>(differing) / std::max(1, a.width() * a.height());
  }

  MainWindow& window_;
  QString walk_;
  std::map<QString, Steps> sheets_;
};

}  // namespace glisson::widgets
