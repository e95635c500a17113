#pragma once
// A map of where the declared law does not hold, for elastography: of each voxel what is left of the weak forms of the
// patches nearest to it (root mean square over trials, in noises: 1 is what noise alone leaves).

#include <filesystem>

#include "base/result.h"
#include "closedloop/explain.h"
#include "imaging/image.h"

namespace glisson::closedloop {

struct WhereItHolds {
  imaging::Volume before;  // with the declared law; 0 where no patch is near, unit "noise"
  imaging::Volume after;   // with the better model
};

[[nodiscard]] bool has_where_it_holds(const Experiment& experiment);
// Only of what has_where_it_holds.
[[nodiscard]] WhereItHolds where_it_holds(const Explained& explained);

// Both as residual_before.nrrd and residual_after.nrrd, which ParaView and Slicer open. Fails as write_volume_file.
Result<void> write_where_it_holds(const std::filesystem::path& folder, const Explained& explained);

}  // namespace glisson::closedloop
