#pragma once
// The raw waves of a case, and what their inversion gives back to it.

#include "base/progress.h"
#include "casefile/case.h"
#include "elastography/inversion.h"

namespace glisson::casefile {

// Whether a case holds raw elastography.
[[nodiscard]] bool has_waves(const Case& patient);

// The phase images of a case as they were imported (volumes/phase...; where there are none, the vendor's
// volumes/wave...) with the mean of volumes/magnitude.... Fails with "waves-none", or as elastography::sort_waves does.
Result<elastography::SortedWaves> read_waves(const Case& patient, const elastography::AskedFor& asked = {});

// What an inversion found and how, not yet in the case.
struct InvertedWaves {
  elastography::ModulusMap map;
  Provenance made;
};

// Inverts them inside labels/liver, where that exists; the case stays as it is.
Result<InvertedWaves> inverted_waves(const Case& patient, const elastography::AskedFor& asked = {},
                                     const elastography::InversionOptions& options = {}, const Progress& progress = {});

// Takes the outcome into the case:
//   volumes/stiffness    |G*| in kPa (for lfe density times squared wave speed): what `stiffness` and every later stage
//                        read. A map from the scanner, if there was one, gives way.
//   volumes/confidence   0 to 1
//   volumes/storage, volumes/loss    kPa; direct method only
//   volumes/shear-wave   the strongest component of the waves at one instant, in rad
Result<void> accept_waves(Case& patient, const InvertedWaves& inverted);

// Both.
Result<elastography::ModulusMap> invert_waves(Case& patient, const elastography::AskedFor& asked = {},
                                              const elastography::InversionOptions& options = {},
                                              const Progress& progress = {});

}  // namespace glisson::casefile
