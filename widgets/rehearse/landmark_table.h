#pragma once
// Each landmark: how far it moves, how far from there the atlas puts it, and a flag in words from 5 mm on.

#include <QTableWidget>
#include <set>
#include <string>

#include "rehearsal/static_rehearsal.h"

namespace glisson::widgets {

class LandmarkTable : public QTableWidget {
  Q_OBJECT

 public:
  enum Column { name_column, moves_column, apart_column, flag_column };

  explicit LandmarkTable(QWidget* parent = nullptr);

  // Empty without a state. Rows keep their order while the same landmarks come.
  void show_state(const rehearsal::RehearsalState* state);
  // Those that were set by hand: a double click renames them.
  void set_own(std::set<std::string> ids) { own_ = std::move(ids); }
  // The chosen one, if it was set by hand; else empty.
  [[nodiscard]] std::string chosen_own() const;

 Q_SIGNALS:
  void landmark_chosen(const std::string& id);
  void rename_wanted(const std::string& id, const QString& name);

 private:
  void fill_row(int row, const mechanics::DisplacedLandmark& landmark, const rehearsal::LandmarkDifference* difference);

  std::set<std::string> own_;
  bool filling_ = false;  // what changes in it is not typed
};

// The same as CSV, every landmark a line, lengths in mm, with what the answer is worth. An answer that is not usable
// has where the landmarks lie at rest.
[[nodiscard]] std::string landmark_csv(const rehearsal::RehearsalState& state);

}  // namespace glisson::widgets
