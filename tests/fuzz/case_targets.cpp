// Documents that lie in a case, beside its pictures: they are ours, and a disc, a person or another program may have
// changed them.

#include "base/files.h"
#include "base/json.h"
#include "casefile/case.h"
#include "casefile/history.h"
#include "casefile/internal/history_journal.h"
#include "casefile/marked_lines.h"
#include "casefile/placed_landmarks.h"
#include "casefile/resection_folder.h"
#include "casefile/result_folder.h"
#include "fuzz/reader_target.h"
#include "geometry/mesh_file.h"
#include "planning/plan_file.h"
#include "support/shapes.h"
#include "vasculature/tree_file.h"

namespace glisson::fuzz {
namespace {

namespace fs = std::filesystem;

constexpr const char* plan = R"({"format": "glisson-plan/1", "name": "right", "cuts": [
 {"plane": {"point_mm": [1, 2, 3], "normal": [0, 1, 0], "removed": "larger"}},
 {"sheet": {"through_mm": [[0, 0, 0], [9, 0, 0], [0, 9, 1]], "removed": "above"}}, {"segments": [6, 7]},
 {"territory": "portal/right/posterior"}, {"around": "tumour-1", "margin_mm": 12.5}]})";

constexpr const char* trees = R"({"format": "glisson-vessel-trees/1", "frame": "patient coordinates, LPS, mm",
 "portal_entry_mm": [1, 2, 3], "hepatic_entry_mm": [4, 5, 6], "branches": [{"id": 0, "name": "portal/stem",
 "parent": -1, "system": "portal-vein", "radius_mm": 5, "length_mm": 10, "confidence": 0.9, "generation": 0,
 "joint": "vessel", "points": [[0, 0, 0, 5], [10, 0, 0, 4.5]]}, {"id": 1, "name": "portal/right", "parent": 0,
 "system": "portal-vein", "radius_mm": 3, "length_mm": 9, "confidence": 0.5, "generation": 1, "joint": "gap",
 "points": [[10, 0, 0, 4], [14, 8, 0, 3]]}]})";

constexpr const char* resection = R"({"format": "glisson-resection/1", "cut": {"point_mm": [90, 0, 0],
 "normal": [1, 0, 0], "liver": "held-aside", "removed": "larger"}})";

constexpr const char* sheet_resection = R"({"format": "glisson-resection/1", "cut": {"through_mm": [[0, 0, 0],
 [9, 0, 0], [0, 9, 1]], "removed": "smaller"}})";

// A case of two texts, one of them changed and the change taken back.
fs::path case_in(const fs::path& folder) {
  const fs::path made = folder / "hers.glisson";
  fs::remove_all(made);
  auto opened = casefile::Case::create(made);
  promise(bool(opened), "a case is made");
  const auto add = [&](const char* id, const char* text) {
    const auto added = opened->add(id, ".vtu", {"mesh", {}, {}, {}, {}},
                                   [&](const fs::path& file) { return write_text_file(file, text); });
    promise(bool(added), "a file is added");
  };
  add("meshes/model", "one");
  auto history = casefile::History::open(made);
  promise(bool(history), "a history is begun");
  const auto recorded = (*history)->record({"change", {}}, [&]() -> Result<void> {
    add("meshes/model", "another");
    return {};
  });
  promise(bool(recorded) && bool((*history)->record_values({"tool", {}}, {{"tool", "0", "1"}})), "steps are kept");
  promise(bool((*history)->undo()), "a step is taken back");
  return made;
}

constexpr const char* result = R"({"format": "glisson-result/1", "engine": "fem", "converged": true, "state": "within",
 "largest_strain": 0.1, "inverted_cells": 0, "landmarks": [{"id": "tumour-1", "rest_mm": [1, 2, 3],
 "displaced_mm": [1, 2, 4], "displacement_mm": 1}]})";

constexpr const char* landmarks = R"({"format": "glisson-landmarks/1", "landmarks": [{"name": "hilum",
 "position_mm": [1, 2.5, -3]}, {"name": "tip", "position_mm": [0, 0, 1e2]}]})";

constexpr const char* lines = R"({"format": "glisson-marked-lines/1", "sequence": "aa", "lines": [{"id": "falciform",
 "at_rest": [[0, 0, 0], [9, 0, 1]], "seen": {"2": [[0, 0, 99], [8, 0, 99]], "11": []}}, {"id": "lower-edge"}]})";

void files_of_a_result(const fs::path& folder) {
  promise(bool(geometry::write_tetrahedra(folder / "result.vtu", test::box_of_tetrahedra({2, 1, 1}, {20, 10, 10}))),
          "the mesh is written");
  file_of(R"({"supports": [{"point_array": "fixed"}], "loads": [{"tool": {"center_mm": [1, 2, 3], "radius_mm": 8,
          "force_N": [0, 0, 1]}}]})",
          folder, "scenario.json");
}

void case_with_landmarks(const fs::path& folder) {
  auto patient = casefile::Case::create(folder / "hers.glisson");
  promise(patient && casefile::keep_landmarks(*patient, {{"hilum", {1, 2, 3}}}), "landmarks are kept");
}

Result<std::vector<mechanics::Landmark>> landmarks_of_a_case(const fs::path& file) {
  const fs::path patient = file.parent_path() / "hers.glisson";
  fs::copy_file(file, patient / "landmarks" / "placed.json", fs::copy_options::overwrite_existing);
  return casefile::Case::open(patient).and_then(casefile::placed_landmarks);
}

// Of a step of the history.
Target changes() {
  const auto seeds = [](const fs::path& folder) {
    return std::vector<std::string>{read_text_file(case_in(folder) / "history" / "steps" / "1.json").value()};
  };
  const auto run = [](const std::string& bytes, const fs::path& folder) {
    const auto read = casefile::read_changes(file_of(bytes, folder, "1.json"));
    if (!read) promise(read.error().code == "history-damaged", "a refusal says why");
  };
  return {"changes", seeds, run};
}

// What `file` of a case holds, and its case opened with other bytes there.
template <typename Open>
Target part_of_a_case(const std::string& name, const std::string& file, Open open) {
  const auto run = [=](const std::string& bytes, const fs::path& folder) {
    const fs::path patient = folder / "hers.glisson";
    if (!fs::exists(patient / "case.json")) case_in(folder);
    fs::create_directories((patient / file).parent_path());
    file_of(bytes, (patient / file).parent_path(), fs::path(file).filename().string());
    open(patient);
    // Opening may have put a damaged history aside, and made another.
    fs::remove_all(patient / "history.damaged");
  };
  const auto seeds = [=](const fs::path& folder) {
    return std::vector<std::string>{read_text_file(case_in(folder) / file).value()};
  };
  return {name, seeds, run};
}

}  // namespace

std::vector<Target> targets() {
  return {
      part_of_a_case("case", "case.json",
                     [](const fs::path& patient) {
                       const auto opened = casefile::Case::open(patient);
                       if (!opened) return promise(!opened.error().message().empty(), "a refusal says why");
                       for (const casefile::Entry& entry : opened->entries()) (void)opened->freshness(entry.id);
                     }),
      part_of_a_case("history", "history/journal.json",
                     [](const fs::path& patient) {
                       const auto opened = casefile::History::open(patient);
                       promise(bool(opened), "a damaged history keeps nobody from the case");
                       while ((*opened)->steps_to_undo() > 0 && (*opened)->undo()) continue;
                     }),
      reader_of("plan", "plan.json", {plan}, [](const fs::path& file) { return planning::read_plan(file); }),
      reader_of("trees", "trees.json", {trees}, [](const fs::path& file) { return vasculature::read_trees(file); }),
      reader_of("resection", "resection.json", {resection, sheet_resection},
                [](const fs::path& file) { return casefile::read_planned_cut(file.parent_path()); }),
      changes(),
      reader_of(
          "result", "result.json", {result},
          [](const fs::path& file) {
            (void)casefile::read_validity(file.parent_path());
            return casefile::read_result(file.parent_path());
          },
          files_of_a_result),
      reader_of("landmarks", "placed.json", {landmarks}, landmarks_of_a_case, case_with_landmarks),
      reader_of("marked-lines", "lines.json", {lines},
                [](const fs::path& file) { return casefile::read_marked_lines(file); }),
  };
}

}  // namespace glisson::fuzz
