#pragma once
// A drawing of a report in the window: scaled to fit, in the colours of the theme, with its caption below.

#include <QLabel>
#include <QWidget>

#include "widgets/evidence/evidence_record.h"

namespace glisson::widgets {

class SvgView : public QWidget {
  Q_OBJECT

 public:
  explicit SvgView(EvidenceDrawing drawing, QWidget* parent = nullptr);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  EvidenceDrawing drawing_;
  QString caption_;  // in the language of the window
};

}  // namespace glisson::widgets
