#pragma once
// The effects that a palpation may show, with their parameters, and what each does to the model:
//
// - stiffness-scale {factor}: Young's modulus everywhere.
// - strain-stiffening {coefficient}: StiffeningLaw in state.h.
// - support-compliance {foundation_kPa_per_mm}: structure.h. The form layer {foundation_kPa_per_mm,
//   sideways_kPa_per_mm} is another across the surface than along it.
// - stiff-inclusion {center_mm[3], radius_mm, ratio}: structure.h.
// - viscoelastic-creep, prony-1 or prony-2 {amplitude, time_s, each a vector}: the load that acts is the load that was
//   put on, by the creep function. Exact where all of the specimen creeps alike.
// - force-bias {zero_N, gain}: reading = gain * force + zero. Of guidance {gain}: a tool's stated force has no zero.
// - frame-misalignment {rotation_deg[3], translation_mm[3]}: seen = R place + t; R by its rotation vector, about the
//   origin of the coordinates.
// - anisotropy, fibres or engineering {axis[3], ratio}: structure.h; the axis's length has no meaning. The form
//   three-moduli {axis[3], ratio, shear_ratio} is engineering with a shear modulus of its own along the axis.
// - undeclared-attachment {center_mm[3], radius_mm, foundation_kPa_per_mm}: attachment.h.
// - missing-attachment, its form the declared support (DeclaredSupports::names) {left_kPa_per_mm}: that support is in
//   series with a spring as stiff as this.
// - capsule {stiffness_N_per_mm}: structure.h.
// - preload, gravity {gravity_m_s2[3]}: besides declared gravity.
// - preload, pressure {pressure_kPa}: on the whole boundary; positive compresses.

#include <string>
#include <vector>

#include "closedloop/experiment/effect.h"
#include "closedloop/experiment/experiment.h"
#include "closedloop/palpation/internal/state.h"
#include "closedloop/palpation/internal/structure.h"

namespace glisson::closedloop {

namespace palpation {
inline const std::string stiffness_scale = "stiffness-scale";
inline const std::string strain_stiffening = "strain-stiffening";
inline const std::string support_compliance = "support-compliance";
inline const std::string stiff_inclusion = "stiff-inclusion";
inline const std::string viscoelastic_creep = "viscoelastic-creep";
inline const std::string force_bias = "force-bias";
inline const std::string frame_misalignment = "frame-misalignment";
inline const std::string anisotropy = "anisotropy";
inline const std::string undeclared_attachment = "undeclared-attachment";
inline const std::string missing_attachment = "missing-attachment";
inline const std::string capsule = "capsule";
inline const std::string preload = "preload";

inline const std::string form_exponential = "exponential", form_linear = "linear", form_yeoh = "yeoh",
                         form_ogden = "ogden";
inline const std::string form_layer = "layer";
inline const std::string form_prony_1 = "prony-1", form_prony_2 = "prony-2";
inline const std::string form_fibres = "fibres", form_engineering = "engineering", form_three_moduli = "three-moduli";
inline const std::string form_gravity = "gravity", form_pressure = "pressure";
}  // namespace palpation

// Those that this experiment could show: no creep where nothing lasts, no compliance where nothing is fixed by faces.
[[nodiscard]] std::vector<Effect> palpation_catalogue(const Palpation& experiment, const SpecimenBody& specimen);

// What ties the specimen to what is around it: an attachment more or less than declared. Of guidance alone, where an
// organ lies in a body; none where a declared support is a ligament or holds some directions only.
[[nodiscard]] std::vector<Effect> attachment_effects(const Palpation& experiment, const SpecimenBody& specimen);

// Springs beyond its bounds are no springs, or none at all: those of what is searched.
[[nodiscard]] DeclaredSupports declared_supports(const SpecimenBody& specimen);

// What the untouched load cells read (mN), averaged over the trials that say so. Such a trial has a first sample that
// was not watched, or that shows less than a quarter of the trial's load.
[[nodiscard]] double untouched_reading_mN(const Palpation& experiment);

}  // namespace glisson::closedloop
