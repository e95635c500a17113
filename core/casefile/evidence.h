#pragma once
// What measurements showed of a patient's tissue, and a person accepted. It is kept as evidence/model: the model.json
// of explain with the effects that were wanted. `read_model` (model.h) puts it into the organ that is rehearsed, so
// that an accepted effect changes what the surgeon sees. Once it is taken back, the organ is what it was, to the bit.
//
// What was measured must be this patient's tissue: the palpated mesh is this organ in this place, or the experiment's
// title names the case. An effect that changes nothing in the rehearsal is not accepted.
//
// A case holds one such model; accepting another puts it in its place. Each change is one transaction of the case.

#include <filesystem>
#include <string>
#include <vector>

#include "casefile/case.h"
#include "closedloop/learnt_organ.h"

namespace glisson::casefile {

struct Evidence {
  std::vector<closedloop::LearntEffect> effects;  // accepted, whether the organ can carry them or not
  std::vector<Sentence> remarks;
};

// Who says that the specimen is of this patient.
enum class Tissue { shown_by_file, told_by_person };

// Whether the specimen is this organ, or its title names the case (as a word of its own, in whatever case).
[[nodiscard]] bool is_of_patient(const closedloop::Specimen& specimen, const std::string& case_name);

// Accepts the effects of these kinds; where none is named, all that change the rehearsal. Fails with "case-lacks-entry"
// before there is a model, and with "evidence-empty" where the model found nothing missing. Fails with
// "evidence-not-this-patient". Fails with "evidence-without-effect" where a named kind, or every one, leaves the
// rehearsal as it is. Fails as closedloop::learn_organ does. Then the case is as it was.
Result<Evidence> accept_evidence(Case& patient, const std::filesystem::path& model_file,
                                 const std::vector<std::string>& kinds = {}, Tissue tissue = Tissue::shown_by_file);

// Takes back the effects of these kinds, all where none is named; what is left of them is answered. Refused:
// "effect-missing" where one was not accepted.
Result<Evidence> take_back_evidence(Case& patient, const std::vector<std::string>& kinds = {});

// The organ with the evidence that the case holds; as it came, where it holds none. Refused: "evidence-damaged".
struct OrganByEvidence {
  closedloop::OrganModel organ;
  Evidence evidence;
};
Result<OrganByEvidence> with_evidence(const Case& patient, closedloop::OrganModel organ, const geometry::TetMesh& mesh);

}  // namespace glisson::casefile
