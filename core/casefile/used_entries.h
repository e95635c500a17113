#pragma once
// What an answer from a case's files has to say of them, and when it may not be given.

#include <string>
#include <vector>

#include "base/sentence.h"
#include "casefile/case.h"
#include "geometry/tetrahedra.h"

namespace glisson::casefile {

// Of each of these entries whether another program has changed it, or what it was made from has changed since. Those
// that the case does not have are passed over. Reads the files to compare them.
[[nodiscard]] std::vector<Sentence> remarks_on(const Case& patient, const std::vector<std::string>& ids);

// The same of what read_model takes: the model, the labels, and outlines that another program has changed.
[[nodiscard]] std::vector<Sentence> model_remarks(const Case& patient);

// Where another program has replaced the model, the mesh or the liver's label: whether this is still a mesh of the
// liver of this case. It is where it has the points of an untouched meshes/liver, and at least half of its cells lie
// in labels/liver; fails with "model-of-another".
[[nodiscard]] Result<void> check_own_mesh(const Case& patient, const geometry::TetMesh& mesh);

}  // namespace glisson::casefile
