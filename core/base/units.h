#pragma once
// The one page of units. Inside: mm, kg, s; so force is in mN, stress and stiffness in kPa, energy in uJ.
//
//   1 mN = 1e-3 kg m/s2 = 1 kg mm/s2          1 kPa = 1e3 N/m2 = 1 mN/mm2         1 uJ = 1 mN mm
//
// DICOM lengths (mm) and elastography moduli (kPa) need no factor. Files and the command line speak N and
// kg/m3 (contracts): convert with these functions where they are read or written, nowhere else.

namespace glisson::units {

constexpr double standard_gravity_mm_s2 = 9810.0;

constexpr double mN_from_N(double force_N) { return force_N * 1e3; }
constexpr double N_from_mN(double force_mN) { return force_mN * 1e-3; }
constexpr double kg_mm3_from_kg_m3(double density_kg_m3) { return density_kg_m3 * 1e-9; }
constexpr double kg_m3_from_kg_mm3(double density_kg_mm3) { return density_kg_mm3 * 1e9; }
constexpr double mm_s2_from_m_s2(double acceleration_m_s2) { return acceleration_m_s2 * 1e3; }
constexpr double m_s2_from_mm_s2(double acceleration_mm_s2) { return acceleration_mm_s2 * 1e-3; }
constexpr double kPa_from_Pa(double stress_Pa) { return stress_Pa * 1e-3; }
constexpr double ml_from_mm3(double volume_mm3) { return volume_mm3 * 1e-3; }

// Young's modulus of an isotropic material from its shear modulus: E = 2 G (1 + nu), eq. 4.1 of the
// dissertation and any text on elasticity.
constexpr double youngs_from_shear(double shear_modulus, double poisson_ratio) {
  return 2.0 * shear_modulus * (1.0 + poisson_ratio);
}
constexpr double shear_from_youngs(double youngs_modulus, double poisson_ratio) {
  return youngs_modulus / (2.0 * (1.0 + poisson_ratio));
}

}  // namespace glisson::units
