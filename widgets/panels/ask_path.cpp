#include "widgets/panels/ask_path.h"
#include "widgets/settings/program_settings.h"

#include <QCoreApplication>
#include <QDialogButtonBox>
#include <QDir>
#include <QFileDialog>
#include <QPushButton>

namespace glisson::widgets {
namespace {

QString last_folder() {
  const QString folder = program_settings().value(last_folder_key).toString();
  return QDir(folder).exists() ? folder : QString();
}

QString kept(const QString& chosen) {
  if (!chosen.isEmpty()) program_settings().setValue(last_folder_key, QFileInfo(chosen).absolutePath());
  return chosen;
}

// Qt's own dialog takes a file or a folder, never either: a folder that is chosen is entered, and taken by a button.
class FileOrFolder : public QFileDialog {
 public:
  FileOrFolder(QWidget* parent, const QString& title) : QFileDialog(parent, title, last_folder()) {
    setOption(QFileDialog::DontUseNativeDialog);
    setFileMode(QFileDialog::ExistingFile);
    auto* take = new QPushButton(QCoreApplication::translate("AskPath", "Take this folder"), this);
    take->setObjectName("take_folder");
    take->setAutoDefault(false);
    connect(take, &QPushButton::clicked, this, [this] {
      const QStringList marked = selectedFiles();
      const bool is_folder = marked.size() == 1 && QFileInfo(marked.front()).isDir();
      folder_ = is_folder ? marked.front() : directory().absolutePath();
      done(QDialog::Accepted);
    });
    if (auto* buttons = findChild<QDialogButtonBox*>()) buttons->addButton(take, QDialogButtonBox::ActionRole);
  }
  [[nodiscard]] QString chosen() const { return !folder_.isEmpty() ? folder_ : selectedFiles().value(0); }

 private:
  QString folder_;
};

}  // namespace

QString ask_for_file(QWidget* parent, const QString& title, const QString& filter) {
  return kept(QFileDialog::getOpenFileName(parent, title, last_folder(), filter));
}

QString ask_for_folder(QWidget* parent, const QString& title) {
  return kept(QFileDialog::getExistingDirectory(parent, title, last_folder()));
}

QString ask_for_file_or_folder(QWidget* parent, const QString& title) {
  FileOrFolder dialog(parent, title);
  return dialog.exec() == QDialog::Accepted ? kept(dialog.chosen()) : QString();
}

QString ask_where_to_save(QWidget* parent, const QString& title, const QString& proposed_name, const QString& filter) {
  return kept(QFileDialog::getSaveFileName(parent, title, QDir(last_folder()).filePath(proposed_name), filter));
}

}  // namespace glisson::widgets
