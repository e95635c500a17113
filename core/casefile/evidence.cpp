#include "casefile/evidence.h"

#include <algorithm>

#include "base/files.h"
#include "casefile/label_map.h"
#include "casefile/model.h"

namespace glisson::casefile {
namespace fs = std::filesystem;
namespace {

const std::string evidence_entry = "evidence/model";
const std::string effects_option = "effects";  // of its entry: the accepted kinds, by commas

std::vector<std::string> accepted_kinds(const Entry& entry);
Result<void> keep(Case& patient, const fs::path& model_file, std::map<std::string, std::string> sources,
                  const std::vector<std::string>& kinds);
Result<Evidence> evidence_of(const Case& patient);
Failure without_effect(const closedloop::LearntEffect& effect, const fs::path& model_file);

}  // namespace

bool is_of_patient(const closedloop::Specimen& specimen, const std::string& case_name) {
  if (specimen.this_organ) return true;
  constexpr std::size_t minimum_letters = 3;  // a shorter name stands in half of all titles
  const std::string title = "-" + structure_name(specimen.title) + "-";
  return case_name.size() >= minimum_letters && title.find("-" + structure_name(case_name) + "-") != std::string::npos;
}

Result<Evidence> accept_evidence(Case& patient, const fs::path& model_file, const std::vector<std::string>& kinds,
                                 Tissue tissue) {
  auto model = read_model_before_evidence(patient);
  if (!model) return failure(std::move(model.error()));
  const auto learnt = closedloop::learn_organ(organ_of(*model), model->mesh, model_file, kinds);
  if (!learnt) return failure(learnt.error());
  if (learnt->effects.empty()) {
    return failure(Error{"evidence-empty",
                         GLISSON_TEXT("{0} has no effect that could be accepted: nothing is missing."),
                         {model_file.filename().string()},
                         {},
                         model_file});
  }
  const std::string case_name = patient.folder().stem().string();
  if (tissue == Tissue::shown_by_file && !is_of_patient(learnt->specimen, case_name)) {
    return failure(Error{"evidence-not-this-patient",
                         GLISSON_TEXT("This was measured on \"{0}\", and nothing shows that it is tissue of {1}."),
                         {learnt->specimen.title, case_name},
                         GLISSON_TEXT("Where it is, name the case in the experiment's title, or say so with "
                                      "--of-this-patient."),
                         model_file});
  }
  Evidence accepted{{}, learnt->remarks};
  for (const closedloop::LearntEffect& effect : learnt->effects) {
    if (effect.carried) accepted.effects.push_back(effect);
    if (!effect.carried && !kinds.empty()) return without_effect(effect, model_file);
  }
  if (accepted.effects.empty()) return without_effect(learnt->effects.front(), model_file);
  auto content = sha256_of_file(model_file);
  if (!content) return failure(std::move(content.error()));
  std::vector<std::string> names;
  for (const closedloop::LearntEffect& effect : accepted.effects) names.push_back(effect.kind);
  if (auto kept = keep(patient, model_file, {{"file-00001", *content}}, names); !kept) {
    return failure(std::move(kept.error()));
  }
  return accepted;
}

Result<Evidence> take_back_evidence(Case& patient, const std::vector<std::string>& kinds) {
  const Entry* entry = patient.find(evidence_entry);
  std::vector<std::string> left = entry != nullptr ? accepted_kinds(*entry) : std::vector<std::string>{};
  for (const std::string& kind : kinds) {
    if (std::erase(left, kind) > 0) continue;
    return failure(Error{"effect-missing",
                         GLISSON_TEXT("The effect {0} was not accepted into {1}."),
                         {kind, patient.folder().string()},
                         {},
                         patient.folder()});
  }
  if (kinds.empty() || left.empty()) {
    return patient.remove(evidence_entry).map([] { return Evidence{}; });
  }
  const Provenance made = entry->made;
  return keep(patient, patient.folder() / entry->file, made.sources, left).and_then([&] {
    return evidence_of(patient);
  });
}

Result<OrganByEvidence> with_evidence(const Case& patient, closedloop::OrganModel organ,
                                      const geometry::TetMesh& mesh) {
  const Entry* entry = patient.find(evidence_entry);
  if (entry == nullptr) return OrganByEvidence{std::move(organ), {}};
  auto learnt = closedloop::learn_organ(std::move(organ), mesh, patient.folder() / entry->file, accepted_kinds(*entry));
  if (!learnt) {
    return failure(Error{"evidence-damaged",
                         GLISSON_TEXT("The accepted evidence of {0} cannot be read: {1}"),
                         {patient.folder().string(), learnt.error().message()},
                         GLISSON_TEXT("Take it back (glisson-cli accept CASE --take-back) and accept it again."),
                         patient.folder() / entry->file});
  }
  const Entry* model = patient.find("meshes/model");
  const auto then = entry->from_sha256.find("meshes/model");
  if (model != nullptr && then != entry->from_sha256.end() && then->second != model->sha256) {
    learnt->remarks.push_back(
        {GLISSON_TEXT("The model was made anew after this evidence had been accepted: see whether it still holds."),
         {}});
  }
  return OrganByEvidence{std::move(learnt->organ), {std::move(learnt->effects), std::move(learnt->remarks)}};
}

namespace {

Failure without_effect(const closedloop::LearntEffect& effect, const fs::path& model_file) {
  return failure(Error{"evidence-without-effect",
                       GLISSON_TEXT("The effect {0} would change nothing in the rehearsal: {1}"),
                       {effect.kind, effect.sentence.message()},
                       GLISSON_TEXT("Accept the others alone (--effect KIND)."),
                       model_file});
}

std::vector<std::string> accepted_kinds(const Entry& entry) {
  std::vector<std::string> kinds;
  const auto found = entry.made.options.find(effects_option);
  if (found == entry.made.options.end()) return kinds;
  for (std::size_t begin = 0; begin < found->second.size();) {
    const std::size_t end = std::min(found->second.find(',', begin), found->second.size());
    kinds.push_back(found->second.substr(begin, end - begin));
    begin = end + 1;
  }
  return kinds;
}

Result<void> keep(Case& patient, const fs::path& model_file, std::map<std::string, std::string> sources,
                  const std::vector<std::string>& kinds) {
  const auto text = read_text_file(model_file);
  if (!text) return failure(text.error());
  std::string accepted;
  for (const std::string& kind : kinds) accepted += (accepted.empty() ? "" : ",") + kind;
  return patient.add(evidence_entry, ".json",
                     Provenance{"accept", {{effects_option, accepted}}, {"meshes/model"}, std::move(sources), {}},
                     [&](const fs::path& file) { return write_text_file(file, *text); });
}

Result<Evidence> evidence_of(const Case& patient) {
  auto model = read_model_before_evidence(patient);
  if (!model) return failure(std::move(model.error()));
  return with_evidence(patient, organ_of(*model), model->mesh).map([](OrganByEvidence organ) {
    return std::move(organ.evidence);
  });
}

}  // namespace
}  // namespace glisson::casefile
