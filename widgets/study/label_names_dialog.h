#pragma once
// Asks what the values of a label map are, where the file does not say: a line a value, with its volume.

#include <map>
#include <QComboBox>
#include <QDialog>
#include <string>
#include <vector>

#include "casefile/label_map.h"

namespace glisson::widgets {

class LabelNamesDialog : public QDialog {
  Q_OBJECT

 public:
  LabelNamesDialog(const QString& file, const std::vector<casefile::LabelledPart>& parts, QWidget* parent);

  // By value; what was left out has no name.
  [[nodiscard]] std::map<int, std::string> names() const;

 private:
  std::vector<int> values_;
  std::vector<QComboBox*> choices_;
};

}  // namespace glisson::widgets
