#pragma once
// The structures of the open case while they are drawn: in memory as they look now, in the case after every stroke.
// Each change is one step of undo; what an undo gives back is read again from the case.

#include <atomic>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <QObject>
#include <QThreadPool>
#include <string>
#include <vector>

#include "segmentation/brush.h"
#include "widgets/session/patient.h"
#include "widgets/session/undo.h"

namespace glisson::widgets {

struct EditedStructure {
  std::string name;
  std::shared_ptr<imaging::Mask> mask;
  std::shared_ptr<const geometry::Surface> surface;  // follows the mask a little later; none while it is empty
  double volume_ml = 0;
  bool shown = true;
};

class StructureEditor : public QObject {
  Q_OBJECT

 public:
  explicit StructureEditor(Undo& undo, QObject* parent = nullptr);
  ~StructureEditor() override;  // waits for its workers

  // Reads the structures of the case on a worker; opened() follows. A patient without a case has none.
  void open(const Patient& patient);
  [[nodiscard]] const std::vector<EditedStructure>& structures() const { return structures_; }
  [[nodiscard]] const imaging::Volume* anatomy() const { return anatomy_.get(); }
  [[nodiscard]] std::shared_ptr<const imaging::Volume> shared_anatomy() const { return anatomy_; }
  // The mask of this name, for a worker to read while nothing is drawn; null where there is none.
  [[nodiscard]] std::shared_ptr<const imaging::Mask> mask_of(const std::string& name) const;
  [[nodiscard]] int active() const { return active_; }  // -1: none
  [[nodiscard]] const EditedStructure* active_structure() const;
  void set_active(int structure);
  void set_shown(int structure, bool shown);
  // False while an undo, a filter or reading is under way.
  [[nodiscard]] bool can_edit() const;

  // A movement of the brush on the active structure, at once; then the whole stroke into the case.
  void draw(const segmentation::Dab& dab, segmentation::Paint paint,
            const std::optional<segmentation::GreyRange>& only = std::nullopt);
  void end_stroke(const std::string& what);  // GLISSON_TEXT, {0} is the structure

  // A filter of the whole active structure, on a worker.
  using Edit = std::function<Result<imaging::Mask>(imaging::Mask)>;
  void apply(const std::string& what, const Edit& edit);

  void add(const std::string& name);
  void rename(const std::string& name);  // the active one
  void remove();                         // the active one

 Q_SIGNALS:
  void opened();                                                            // the list is new
  void listed();                                                            // names, volumes, which is active or shown
  void changed(int structure, const glisson::segmentation::IndexBox& box);  // its mask; an empty box: anywhere
  void surfaces_changed();
  void working(bool busy);
  void changed_nothing();
  void failed(const glisson::Error& error);

 private:
  void reread(const QStringList& ids);
  void change_entries(const std::string& what, const std::vector<std::string>& touches,
                      std::function<Result<void>()> change, const std::function<void()>& then);
  void follow(int structure);  // the surface is made anew
  void set_working(int more);
  [[nodiscard]] int find(const std::string& name) const;

  Undo& undo_;
  std::filesystem::path folder_;
  std::shared_ptr<const imaging::Volume> anatomy_;
  std::vector<EditedStructure> structures_;
  std::map<std::string, std::shared_ptr<std::atomic<int>>>
      surface_turn_;  // counts, so that a superseded surface is not made
  int active_ = -1;
  int working_ = 0;
  int opening_ = 0;  // counts openings, so that a superseded one is known when it arrives
  bool in_stroke_ = false;
  QThreadPool readers_;
  QThreadPool surfaces_;
};

}  // namespace glisson::widgets
