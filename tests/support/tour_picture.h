#pragma once
// A picture of the whole window against its baseline. Times and rates that a machine reaches stand in it, so that it is
// never the same to the bit: blocks of 8 x 8 pixels whose mean grey is off by more than `noticed` are counted, and may
// be up to `allowed_share` of all. A panel that is missing, a text that is cut off, a colour gone wrong are more.
//
// What was drawn is kept in the build folder under pictures/; nothing here writes a baseline.

#include <cmath>
#include <QImage>
#include <QString>

#include "support/folders.h"
#include "widgets/kept_pictures.h"

namespace glisson::test {

struct PictureVerdict {
  bool alike = false;
  QString words;
};

inline double share_of_blocks_that_differ(const QImage& a, const QImage& b) {
  constexpr int block = 8;
  constexpr double noticed = 12;  // of 255
  int differing = 0;
  int all = 0;
  for (int top = 0; top + block <= a.height(); top += block) {
    for (int left = 0; left + block <= a.width(); left += block, ++all) {
      double apart[3] = {0, 0, 0};
      for (int y = top; y < top + block; ++y) {
        const uchar* one = a.constScanLine(y) + 3 * left;
        const uchar* other = b.constScanLine(y) + 3 * left;
        for (int k = 0; k < 3 * block; ++k) apart[k % 3] += double(one[k]) - double(other[k]);
      }
      for (const double channel : apart) {
        if (std::abs(channel) / (block * block) > noticed) {
          ++differing;
          break;
        }
      }
    }
  }
  return static_cast<double>(differing) / std::max(1, all);
}

inline PictureVerdict held_against_baseline(const QImage& drawn, const QString& name) {
  constexpr double allowed_share = 0.01;
  const QString kept = kept_pictures() + "/" + name + ".png";
  drawn.save(kept);
  const QString baseline_file =
      QString::fromStdString(source_folder().string()) + "/resources/manual/pictures/" + name + ".png";
  const QImage baseline = QImage(baseline_file).convertToFormat(QImage::Format_RGB888);
  if (baseline.isNull())
    return {false, QString("no baseline at %1; look at %2 and copy it there if it is right").arg(baseline_file, kept)};
  if (baseline.size() != drawn.size()) return {false, QString("%1 has another size than its baseline").arg(kept)};
  const double share = share_of_blocks_that_differ(drawn, baseline);
  return {share <= allowed_share,
          QString("%1: %2 % of it differs from %3").arg(kept).arg(100 * share, 0, 'f', 2).arg(baseline_file)};
}

}  // namespace glisson::test
