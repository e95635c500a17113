#pragma once
// The block of block_patient.h (120 x 80 x 80 mm, held at its left end) in Rehearse, seen as a surgeon sees it, with a
// probe in the middle of its free end that pushes with 1 N.

#include <memory>
#include <QSignalSpy>
#include <QtTest>

#include "block_patient.h"
#include "support/shapes.h"
#include "widgets/main_window.h"

namespace glisson::widgets {

constexpr int patience_ms = 30000;  // for solves on a machine that does other work too

inline Patient block_with_a_tumour() {
  return block_patient(
      {6, 4, 4}, {{"tumour-1", {100, 40, 40}}, {"hilum", {8, 40, 40}}},
      {{"tumour-1", std::make_shared<geometry::Surface>(test::sphere_surface(10, 2, {100, 40, 40})), 4.2}});
}

inline void show_probe_on_block(MainWindow& window) {
  window.show_patient(block_with_a_tumour());
  window.go_to("rehearse");
  window.views().space().look_from(scene::PatientView::surgeon);
  QSignalSpy placed(&window.rehearsal(), &LiveRehearsal::placed);
  window.rehearsal().hold({"palpation-probe", {120, 40, 40}, {1, 0, 0}, 15, {-1, 0, 0}, 1.0});
  QVERIFY(placed.wait(patience_ms));
}

}  // namespace glisson::widgets
