#pragma once
// The series of a study with their middle slices, and what each is to be in the case: proposed, and correctable.

#include <memory>
#include <QComboBox>
#include <QThreadPool>
#include <QTreeWidget>
#include <stop_token>
#include <vector>

#include "casefile/import.h"
#include "imaging/study.h"

namespace glisson::widgets {

class SeriesTable : public QTreeWidget {
  Q_OBJECT

 public:
  explicit SeriesTable(QWidget* parent = nullptr);
  ~SeriesTable() override;  // gives up the pictures that are still being made

  void show_study(std::shared_ptr<const imaging::Study> study);
  [[nodiscard]] const imaging::Study* study() const { return study_.get(); }
  [[nodiscard]] std::vector<casefile::SeriesRole> roles() const;
  // How many series have a role.
  [[nodiscard]] int chosen() const;
  // Of these, those that are no segmentation.
  [[nodiscard]] int chosen_images() const;

 Q_SIGNALS:
  void roles_changed();

 private:
  void update_text();
  void make_pictures();

  std::shared_ptr<const imaging::Study> study_;
  std::vector<QComboBox*> roles_;
  QThreadPool painters_;
  std::shared_ptr<std::stop_source> stop_;
};

// The middle slice of a volume, transverse to its first two axes, in the window that it opens with; at most `side`
// pixels across.
[[nodiscard]] QImage middle_slice(const imaging::Volume& volume, int side);

// The slice of a label map that holds most of it, each value in the colour of its structure, else in one of its own.
[[nodiscard]] QImage label_slice(const casefile::ReadLabelMap& map, int side);

}  // namespace glisson::widgets
