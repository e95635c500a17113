#pragma once
// A sequence on disk, registered: each frame's cloud moved to the model, ready to be judged.

#include <string_view>

#include "base/progress.h"
#include "registration_quality/sequence_file.h"
#include "registration_quality/sirgn.h"

namespace glisson::registration_quality {

enum class SequenceMethod {
  given,  // as somebody else's algorithm left it: the clouds that the sequence names as registered
  icp,    // each frame by itself to the model, by nearest points
  geo,    // each frame by itself to the model, by distances along the surface
  gnra    // all frames at once, by the landmarks; each point without those of the fold of the landmark next to it
};
inline constexpr SequenceMethod sequence_methods[] = {SequenceMethod::icp, SequenceMethod::geo, SequenceMethod::gnra,
                                                      SequenceMethod::given};

// "given", "icp", "geo", "gnra".
[[nodiscard]] std::string_view name_of(SequenceMethod method);

// What gnra does to a landmark was not fitted to that landmark. An alignment that is judged by landmarks which it was
// fitted to would agree with itself. It is judged without the sequence's benchmark, which is a gnra of its own. Fails
// with "sequence-not-registered" where the method is `given` and the sequence names no registered clouds. Fails with
// "sequence-no-model" where it is `icp` or `geo` and the sequence names no model. Fails with
// "sequence-frame-not-aligned" (gnra). Fails as read_cloud, read_surface, register_surfaces and align_globally do, with
// the frame's file, and with "cancelled".
Result<RegisteredSequence> register_sequence(const SequenceFiles& files, SequenceMethod method,
                                             const Progress& progress = {});

}  // namespace glisson::registration_quality
