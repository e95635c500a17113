#pragma once
// Asking for a file or folder. Each question begins in the folder where the last one ended, whatever it was about, and
// also after Glisson was started anew.

#include <QString>
#include <QWidget>

namespace glisson::widgets {

// Empty where the person thinks better of it.
[[nodiscard]] QString ask_for_file(QWidget* parent, const QString& title, const QString& filter);
[[nodiscard]] QString ask_for_folder(QWidget* parent, const QString& title);
// A file, or by "Take this folder" the folder that is open in the dialog.
[[nodiscard]] QString ask_for_file_or_folder(QWidget* parent, const QString& title);
[[nodiscard]] QString ask_where_to_save(QWidget* parent, const QString& title, const QString& proposed_name,
                                        const QString& filter);

}  // namespace glisson::widgets
