#include "widgets/segment/structure_editor.h"

#include "casefile/model.h"
#include "casefile/structures.h"
#include "widgets/work/run_in_background.h"

namespace glisson::widgets {
namespace {

namespace fs = std::filesystem;

std::string id_of(const std::string& name) { return "labels/" + name; }

Result<std::vector<EditedStructure>> read_all(const fs::path& folder, const std::vector<PatientStructure>& known) {
  const auto opened = casefile::Case::open(folder);
  if (!opened) return failure(opened.error());
  auto read = casefile::read_structures(*opened);
  if (!read) return failure(read.error());
  std::vector<EditedStructure> all;
  for (segmentation::Structure& structure : *read) {
    EditedStructure edited{structure.name, std::make_shared<imaging::Mask>(std::move(structure.mask)), nullptr, 0,
                           true};
    for (std::uint8_t& value : edited.mask->values) value = value != 0 ? 1 : 0;
    edited.volume_ml = segmentation::volume_ml(*edited.mask);
    for (const PatientStructure& seen : known) {
      if (seen.name == edited.name) edited.surface = seen.surface;
    }
    all.push_back(std::move(edited));
  }
  return all;
}

Result<void> save(const fs::path& folder, const std::string& name, const imaging::Mask& mask) {
  auto opened = casefile::Case::open(folder);
  if (!opened) return failure(opened.error());
  casefile::Provenance made{"segment", {{"method", "drawn"}}, {}, {}, {}};
  if (const casefile::Entry* before = opened->find(id_of(name))) {
    made = before->made;
    made.options["edited"] = "drawn";
  }
  made.from.clear();
  if (opened->find("volumes/anatomy") != nullptr) made.from = {"volumes/anatomy"};
  return casefile::save_structure(*opened, segmentation::make_structure(name, mask), std::move(made))
      .map([](const casefile::SavedStructure&) {});
}

}  // namespace

StructureEditor::StructureEditor(Undo& undo, QObject* parent) : QObject(parent), undo_(undo) {
  readers_.setMaxThreadCount(1);
  surfaces_.setMaxThreadCount(1);
  connect(&undo_, &Undo::entries_moved, this, &StructureEditor::reread);
}

StructureEditor::~StructureEditor() {
  for (const auto& [name, turn] : surface_turn_) ++*turn;
  readers_.waitForDone();
  surfaces_.waitForDone();
}

void StructureEditor::open(const Patient& patient) {
  const std::string kept = patient.folder == folder_ && active_structure() != nullptr ? active_structure()->name : "";
  folder_ = patient.folder;
  anatomy_ = patient.anatomy;
  structures_.clear();
  active_ = -1;
  in_stroke_ = false;
  const int opening = ++opening_;
  Q_EMIT opened();
  if (folder_.empty()) return;
  set_working(1);
  run_in_background(
      this, &readers_, [folder = folder_, known = patient.structures] { return read_all(folder, known); },
      [this, opening, kept](const Result<std::vector<EditedStructure>>& read) {
        set_working(-1);
        if (opening != opening_) return;
        if (!read) {
          Q_EMIT failed(read.error());
          return;
        }
        structures_ = *read;
        active_ = std::max(find(kept), structures_.empty() ? -1 : 0);
        for (int k = 0; k < static_cast<int>(structures_.size()); ++k) {
          if (!structures_[static_cast<std::size_t>(k)].surface) follow(k);
        }
        Q_EMIT opened();
        Q_EMIT surfaces_changed();
      });
}

const EditedStructure* StructureEditor::active_structure() const {
  return active_ < 0 ? nullptr : &structures_[static_cast<std::size_t>(active_)];
}

std::shared_ptr<const imaging::Mask> StructureEditor::mask_of(const std::string& name) const {
  const int found = find(name);
  return found < 0 ? nullptr : structures_[static_cast<std::size_t>(found)].mask;
}

void StructureEditor::set_active(int structure) {
  if (structure == active_ || structure >= static_cast<int>(structures_.size())) return;
  active_ = structure;
  Q_EMIT listed();
}

void StructureEditor::set_shown(int structure, bool shown) {
  bool& now = structures_.at(static_cast<std::size_t>(structure)).shown;
  if (now == shown) return;
  now = shown;
  Q_EMIT listed();
  Q_EMIT surfaces_changed();
}

bool StructureEditor::can_edit() const { return active_ >= 0 && working_ == 0 && !undo_.moving(); }

void StructureEditor::draw(const segmentation::Dab& dab, segmentation::Paint paint,
                           const std::optional<segmentation::GreyRange>& only) {
  if (!can_edit()) return;
  in_stroke_ = true;
  imaging::Mask& mask = *structures_[static_cast<std::size_t>(active_)].mask;
  const bool knows_grey = only && anatomy_ && imaging::same_grid(anatomy_->grid, mask.grid);
  if (only && !knows_grey) return;
  const auto where = only ? std::optional(segmentation::Only{*anatomy_, *only}) : std::nullopt;
  const segmentation::IndexBox box = segmentation::draw(mask, dab, paint, where);
  if (!box.empty()) Q_EMIT changed(active_, box);
}

void StructureEditor::end_stroke(const std::string& what) {
  if (!in_stroke_ || active_ < 0) return;
  in_stroke_ = false;
  EditedStructure& structure = structures_[static_cast<std::size_t>(active_)];
  structure.volume_ml = segmentation::volume_ml(*structure.mask);
  undo_.change(
      {what, {structure.name}}, {id_of(structure.name)},
      [folder = folder_, name = structure.name, mask = imaging::Mask(*structure.mask)] {
        return save(folder, name, mask);
      },
      [this, id = QString::fromStdString(id_of(structure.name))](const Result<void>& saved) {
        if (!saved) reread({id});
      });
  follow(active_);
  Q_EMIT listed();
}

void StructureEditor::apply(const std::string& what, const Edit& edit) {
  if (!can_edit()) return;
  const std::string name = structures_[static_cast<std::size_t>(active_)].name;
  const auto before = std::make_shared<const imaging::Mask>(*structures_[static_cast<std::size_t>(active_)].mask);
  const auto after = std::make_shared<imaging::Mask>();
  change_entries(
      what, {id_of(name)},
      [folder = folder_, name, before, after, edit]() -> Result<void> {
        auto edited = edit(*before);
        if (!edited) return failure(edited.error());
        if (edited->values == before->values) return {};
        *after = std::move(*edited);
        return save(folder, name, *after);
      },
      [this, name, after] {
        const int structure = find(name);
        if (structure < 0) return;
        if (after->values.empty()) {
          Q_EMIT changed_nothing();
          return;
        }
        EditedStructure& edited = structures_[static_cast<std::size_t>(structure)];
        edited.mask = after;
        edited.volume_ml = segmentation::volume_ml(*after);
        Q_EMIT changed(structure, {});
        Q_EMIT listed();
        follow(structure);
      });
}

void StructureEditor::add(const std::string& name) {
  if (folder_.empty() || !anatomy_ || working_ > 0 || find(name) >= 0) return;
  const auto mask = std::make_shared<imaging::Mask>();
  mask->grid = anatomy_->grid;
  mask->values.assign(mask->grid.voxels(), 0);
  change_entries(
      GLISSON_TEXT("New structure {0}"), {id_of(name)},
      [folder = folder_, name, mask] { return save(folder, name, *mask); },
      [this, name, mask] {
        structures_.push_back({name, mask, nullptr, 0, true});
        active_ = static_cast<int>(structures_.size()) - 1;
        Q_EMIT opened();
      });
}

void StructureEditor::rename(const std::string& name) {
  if (!can_edit() || find(name) >= 0) return;
  EditedStructure& structure = structures_[static_cast<std::size_t>(active_)];
  change_entries(
      GLISSON_TEXT("Rename {0}"), {id_of(structure.name), id_of(name)},
      [folder = folder_, before = structure.name, name, mask = structure.mask]() -> Result<void> {
        auto saved = save(folder, name, *mask);
        if (!saved) return saved;
        auto opened = casefile::Case::open(folder);
        return opened ? opened->remove(id_of(before)) : failure(opened.error());
      },
      [this, before = structure.name, name] {
        if (const int renamed = find(before); renamed >= 0) structures_[static_cast<std::size_t>(renamed)].name = name;
        Q_EMIT opened();
        Q_EMIT surfaces_changed();
      });
}

void StructureEditor::remove() {
  if (!can_edit()) return;
  const std::string name = structures_[static_cast<std::size_t>(active_)].name;
  change_entries(
      GLISSON_TEXT("Remove {0}"), {id_of(name)},
      [folder = folder_, name]() -> Result<void> {
        auto opened = casefile::Case::open(folder);
        return opened ? opened->remove(id_of(name)) : failure(opened.error());
      },
      [this, name] {
        if (const int gone = find(name); gone >= 0) structures_.erase(structures_.begin() + gone);
        active_ = structures_.empty() ? -1 : 0;
        Q_EMIT opened();
        Q_EMIT surfaces_changed();
      });
}

void StructureEditor::change_entries(const std::string& what, const std::vector<std::string>& touches,
                                     std::function<Result<void>()> change, const std::function<void()>& then) {
  const std::string about = touches.front().substr(id_of("").size());
  set_working(1);
  undo_.change({what, {about}}, touches, std::move(change), [this, then, opening = opening_](const Result<void>& done) {
    set_working(-1);
    if (done && opening == opening_) then();
  });
}

// What an undo gave back, or what could not be saved: as it is in the case.
void StructureEditor::reread(const QStringList& ids) {
  const bool concerns = std::any_of(ids.begin(), ids.end(), [](const QString& id) { return id.startsWith("labels/"); });
  if (folder_.empty() || !concerns) return;
  in_stroke_ = false;
  set_working(1);
  std::vector<PatientStructure> known;
  for (const EditedStructure& structure : structures_) {
    if (!ids.contains(QString::fromStdString(id_of(structure.name))))
      known.push_back({structure.name, structure.surface, 0});
  }
  run_in_background(
      this, &readers_, [folder = folder_, known] { return read_all(folder, known); },
      [this, opening = opening_](const Result<std::vector<EditedStructure>>& read) {
        set_working(-1);
        if (opening != opening_) return;
        if (!read) {
          Q_EMIT failed(read.error());
          return;
        }
        const std::string active = active_structure() != nullptr ? active_structure()->name : std::string();
        std::map<std::string, bool> shown;
        for (const EditedStructure& structure : structures_) shown[structure.name] = structure.shown;
        structures_ = *read;
        for (EditedStructure& structure : structures_) {
          if (shown.count(structure.name) != 0) structure.shown = shown[structure.name];
        }
        active_ = std::max(find(active), structures_.empty() ? -1 : 0);
        for (int k = 0; k < static_cast<int>(structures_.size()); ++k) {
          if (!structures_[static_cast<std::size_t>(k)].surface) follow(k);
        }
        Q_EMIT opened();
        Q_EMIT surfaces_changed();
      });
}

void StructureEditor::follow(int structure) {
  const EditedStructure& edited = structures_[static_cast<std::size_t>(structure)];
  auto& turn = surface_turn_[edited.name];
  if (!turn) turn = std::make_shared<std::atomic<int>>(0);
  const int mine = ++*turn;
  run_in_background(
      this, &surfaces_,
      [turn, mine,
       drawn = segmentation::make_structure(edited.name, *edited.mask)]() -> std::shared_ptr<geometry::Surface> {
        if (*turn != mine || segmentation::voxel_count(drawn.mask) == 0) return nullptr;
        auto surface = casefile::smooth_outline(drawn);
        return surface ? std::make_shared<geometry::Surface>(*std::move(surface)) : nullptr;
      },
      [this, turn, mine, name = edited.name](const std::shared_ptr<geometry::Surface>& surface) {
        const int found = find(name);
        if (*turn != mine || found < 0) return;
        structures_[static_cast<std::size_t>(found)].surface = surface;
        Q_EMIT surfaces_changed();
      });
}

void StructureEditor::set_working(int more) {
  const bool before = working_ > 0;
  working_ += more;
  if (before != (working_ > 0)) Q_EMIT working(working_ > 0);
}

int StructureEditor::find(const std::string& name) const {
  for (std::size_t k = 0; k < structures_.size(); ++k) {
    if (structures_[k].name == name) return static_cast<int>(k);
  }
  return -1;
}

}  // namespace glisson::widgets
