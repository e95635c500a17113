#pragma once
// What the window shows of one patient: values, loaded elsewhere, never changed.

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/sentence.h"
#include "casefile/evidence.h"
#include "geometry/surface.h"
#include "imaging/image.h"
#include "rehearsal/static_rehearsal.h"

namespace glisson::widgets {

struct PatientStructure {
  std::string name;  // as in the case: "tumour-1"
  std::shared_ptr<const geometry::Surface> surface;
  double volume_ml = 0;
  bool fixed = false;  // no part of the model: drawn where it was outlined, whatever moves
};

struct Patient {
  std::string name;
  std::string origin;            // "SIMULATED ...", or empty for a real patient
  std::filesystem::path folder;  // of the case; empty for none
  std::shared_ptr<const imaging::Volume> anatomy;
  std::shared_ptr<const imaging::Volume> stiffness;  // absent where there was no elastography
  std::vector<PatientStructure> structures;          // the liver first
  std::vector<PatientStructure> around;              // fixed: outside of the model, or outlined since it was built
  // Absent until the model was built. Its structures are those of `structures`, in their order.
  std::shared_ptr<const rehearsal::StaticRehearsal> rehearsal;
  std::shared_ptr<const rehearsal::RehearsalSetup> rehearsal_setup;  // what that was made from
  std::vector<Sentence> remarks;                                     // what the last step found worth looking at
  casefile::Evidence evidence;                     // accepted of measurements: in the rehearsal, or said why not
  double mean_youngs_kPa = 0;                      // of the model's cells
  std::optional<Sentence> assumed_stiffness = {};  // what was assumed of it, where it was not measured
  bool preparing = false;                          // there is a model, and the rehearsal is still being made of it

  // Whether this is the patient shown before as being prepared: what is seen of it stays as it is.
  [[nodiscard]] bool completes(const Patient& before) const {
    return before.preparing && before.folder == folder && before.name == name;
  }
  [[nodiscard]] std::vector<PatientStructure> all_structures() const {
    std::vector<PatientStructure> all = structures;
    all.insert(all.end(), around.begin(), around.end());
    return all;
  }
  // The outlined liver; null where there is none.
  [[nodiscard]] const PatientStructure* liver() const {
    return !structures.empty() && structures.front().name == "liver" ? &structures.front() : nullptr;
  }
};

}  // namespace glisson::widgets
