#pragma once
// What a diagnosis learnt from a specimen, as changes of the organ that is rehearsed:
//
// - stiffness-scale: Young's modulus of every cell, by the factor.
// - viscoelastic-creep: Young's modulus of every cell, to what is left of it after long: a retractor stays. How it gets
//   there is the organ's relaxation: a palpation's creep function and a material test's relaxation function are that
//   exactly, term for term (mechanics/materials/relaxation.h). Explain lets the springs that hold a specimen and its
//   skin creep along; here they do not.
// - stiff-inclusion: the modulus of the cells in the ball, where the specimen was this organ in this place.
// - anisotropy: a fibre direction (mechanics/materials/anisotropy.h), its axis taken as a direction of the patient.
// - support-compliance: what holds it gives way by so much more a kPa: springs in series, in place of what is fixed.
// - undeclared-attachment: springs under the faces of the surface in its ball, where the specimen was this organ.
// - missing-attachment: the support of that point array holds by what is left of it alone, where it was this organ.
// - capsule: a membrane (mechanics/materials/capsule.h), besides one that there is.
// - preload: acts always, where the specimen was this organ.
// - strain-stiffening of a palpation: at large strain the organ is Veronda and Westmann's, with the c2 by which a bar
//   that is pressed by a fifth resists as by the law that was found.
//
// Nothing is dropped in silence: each effect of the model is listed with a sentence, carried over or not. Not carried:
// a material test's strain-stiffening, softening, hysteresis and tension-compression-asymmetry, which no rehearsal
// holds.
// Force-bias and frame-misalignment are faults of the measurement, and leave the organ alone. A preload of a material
// test is of the machine.
//
// A capsule here is incompressible, in explain it has the specimen's Poisson's ratio: where that is 0.45, its stiffness
// differs by 6 % at most.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/sentence.h"
#include "geometry/tetrahedra.h"
#include "mechanics/scenario/scenario.h"

namespace glisson::closedloop {

// What of an organ may change; its mesh does not.
struct OrganModel {
  std::vector<double> youngs_kPa;  // one a cell
  std::vector<mechanics::Support> supports;
  std::optional<mechanics::Capsule> capsule;
  std::optional<mechanics::TransverseIsotropy> anisotropy;
  mechanics::Loads standing_loads;
  std::optional<double> strain_stiffening = {};  // Veronda and Westmann's c2 (mechanics/materials/isochoric.h)
  mechanics::Relaxation relaxation = {};         // of what the moduli above are left after long
};

struct LearntEffect {
  std::string kind;
  bool carried = false;
  Sentence sentence;  // what it does to the organ, or why it does nothing
};

// What was measured.
struct Specimen {
  std::string title;        // the experiment's; of a file without one, the file it was learnt from
  bool this_organ = false;  // its mesh was this organ in this place; a material test has none
};

struct LearntOrgan {
  OrganModel organ;
  Specimen specimen;
  std::vector<LearntEffect> effects;  // in the model's order
  std::vector<Sentence> remarks;      // a verdict that is no proof, a smooth correction
};

// `model_file` is the model.json that explain wrote for a palpation or a material test; `kinds` are the effects that
// are wanted, all where it is empty. Refused: "model-invalid"; "effect-missing" where the model has no effect of a kind
// that is wanted.
Result<LearntOrgan> learn_organ(OrganModel declared, const geometry::TetMesh& mesh,
                                const std::filesystem::path& model_file, const std::vector<std::string>& kinds = {});

// Where a specimen was and how large, kept in its model.json. A specimen is this organ in this place where its box and
// volume are the organ's to a hundredth. Another mesh of the same organ is, then; another body practically never.
struct SpecimenPlace {
  Eigen::Vector3d min_mm{0, 0, 0};
  Eigen::Vector3d max_mm{0, 0, 0};
  double volume_mm3 = 0;
};
[[nodiscard]] SpecimenPlace place_of(const geometry::TetMesh& mesh);
[[nodiscard]] bool same_place(const SpecimenPlace& a, const SpecimenPlace& b);

}  // namespace glisson::closedloop
