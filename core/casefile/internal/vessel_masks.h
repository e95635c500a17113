#pragma once
// Outlines of vessels in a case: which arteries and bile ducts there are, on the liver's grid, and whether two outlines
// hold the same.

#include <filesystem>
#include <string>
#include <vector>

#include "base/progress.h"
#include "casefile/case.h"
#include "imaging/image.h"
#include "vasculature/couinaud.h"

namespace glisson::casefile {

struct NamedMask {
  std::string name;  // as the structure is called
  imaging::Mask mask;
};

// Structures of an artery or of bile ducts, by how their names begin: "artery-2", "hepatic-artery", "biliary-tract".
[[nodiscard]] std::vector<std::string> structures_beside_veins(const Case& patient, vasculature::System system);
// Those of both systems that the case's trees were made without.
[[nodiscard]] std::vector<std::string> missing_from_trees(const Case& patient);

Result<imaging::Mask> structure_mask(const Case& patient, const std::string& name);

// Fails with labels-grids-differ.
Result<NamedMask> vessel_mask(const Case& patient, const std::string& name, const imaging::Mask& liver);

// Fails with vessels-overlap: one holds most of the other too.
Result<void> hold_apart(const NamedMask& a, const NamedMask& b, const std::filesystem::path& folder);

// Trees of the case's arteries and bile ducts beside those of its veins, all named. Fails as vessel_mask, hold_apart
// and center_lines do; names the structure that is no vessel.
Result<void> add_arteries_and_ducts(const Case& patient, const imaging::Mask& liver,
                                    const std::vector<NamedMask>& veins, vasculature::LiverAnatomy& anatomy,
                                    const Progress& progress);

}  // namespace glisson::casefile
