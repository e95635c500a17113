#pragma once
// Whose stiffness a cohort's studies look at: maps and cases found in a folder.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "elastography/cell_stiffness.h"
#include "imaging/image.h"
#include "imaging/study.h"
#include "mechanics/scenario/scenario.h"

namespace glisson::studies {

// What stands for a map that nobody measured (real_livers.h).
struct DrawnStiffness {
  unsigned seed = 1;
  std::filesystem::path vessels;  // mask of the liver's vessels; empty where there is none
};

// A stiffness map, as a series of its own or in a case; or a liver's shape, with a stiffness that is drawn.
struct Subject {
  std::string id;                         // serves as a file name; no other subject of the folder has it
  std::filesystem::path path;             // of the map's first file, of the case, or of the label map
  std::optional<imaging::Series> series;  // absent: a case or a shape
  std::optional<DrawnStiffness> drawn = {};
};

// The maps in a folder (what imaging::scan takes for one) and the cases in it (NAME.glisson), by name. Fails where the
// folder cannot be read.
Result<std::vector<Subject>> find_subjects(const std::filesystem::path& folder);

// Of the subject's content; "unreadable" where it cannot be read.
[[nodiscard]] std::string fingerprint_of(const Subject& subject);

// Landmarks that are looked at together, by their places in MeasuredLiver::landmarks.
struct LandmarkGroup {
  std::string name;  // begins names of columns: "portal_forks"
  std::vector<std::size_t> members;
};

struct MeasuredLiver {
  imaging::Volume shear_kPa;  // positive where something is known
  imaging::Mask organ;        // on a grid of its own: the case's labels/liver, or else the voxels that hold a value
  std::optional<imaging::Mask> confident;
  std::vector<mechanics::Landmark> landmarks;  // of the structures of a case, or forks of vessels
  std::vector<LandmarkGroup> groups;           // the first holds them all; none without landmarks

  [[nodiscard]] elastography::Reliability reliability() const { return {confident, organ}; }
  [[nodiscard]] std::vector<double> values_kPa() const;  // those inside the organ
};
Result<MeasuredLiver> read_subject(const Subject& subject);

}  // namespace glisson::studies
