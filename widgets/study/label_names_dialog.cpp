#include "widgets/study/label_names_dialog.h"

#include <QDialogButtonBox>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>

#include "segmentation/structures.h"
#include "widgets/panels/parts.h"
#include "widgets/words/translated.h"

namespace glisson::widgets {

LabelNamesDialog::LabelNamesDialog(const QString& file, const std::vector<casefile::LabelledPart>& parts,
                                   QWidget* parent)
    : QDialog(parent) {
  setObjectName("label_names");
  setWindowTitle(tr("What the labels are"));
  auto* column = new QVBoxLayout(this);
  QLabel* words = wrapped_label("label_names_words", this);
  words->setText(tr("%1 does not say what its values are. Choose a structure for each that you want.").arg(file));
  column->addWidget(words);
  auto* lines = new QWidget;
  auto* grid = new QGridLayout(lines);
  const auto known_names = segmentation::known_structure_names();
  for (const casefile::LabelledPart& part : parts) {
    const int row = grid->rowCount();
    QString about = tr("%1: %2 ml").arg(part.value).arg(part.volume_ml, 0, 'f', 1);
    if (!part.written.empty()) about += " (" + QString::fromStdString(part.written) + ")";
    auto* choice = new QComboBox;
    choice->setObjectName(QString("label_%1").arg(part.value));
    choice->setEditable(true);  // another name is typed
    choice->addItem(tr("Leave out"), QString());
    for (const std::string& name : known_names) choice->addItem(structure_label(name), QString::fromStdString(name));
    const int known = choice->findData(QString::fromStdString(part.structure));
    choice->setCurrentIndex(std::max(known, 0));
    auto* value = new QLabel(about);
    value->setBuddy(choice);
    grid->addWidget(value, row, 0);
    grid->addWidget(choice, row, 1);
    values_.push_back(part.value);
    choices_.push_back(choice);
  }
  grid->setRowStretch(grid->rowCount(), 1);
  column->addWidget(scrolled(lines), 1);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
  QPushButton* take = buttons->addButton(tr("Take them"), QDialogButtonBox::AcceptRole);
  take->setObjectName("take_labels");
  const auto show_state = [this, take] { take->setEnabled(!this->names().empty()); };
  for (QComboBox* choice : choices_) connect(choice, &QComboBox::currentTextChanged, this, show_state);
  show_state();
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  column->addWidget(buttons);
  resize(460, std::min(640, 180 + 38 * static_cast<int>(parts.size())));
}

std::map<int, std::string> LabelNamesDialog::names() const {
  std::map<int, std::string> names;
  for (std::size_t k = 0; k < choices_.size(); ++k) {
    const QComboBox& choice = *choices_[k];
    const int listed = choice.findText(choice.currentText());
    const QString name = listed >= 0 ? choice.itemData(listed).toString() : choice.currentText().trimmed();
    if (!name.isEmpty()) names[values_[k]] = name.toStdString();
  }
  return names;
}

}  // namespace glisson::widgets
