#pragma once
// Displacement fields of vibrated tissue as a forward model: do they obey the declared wave equation, patch by patch?
//
// With test functions w that vanish outside of a patch, the equation's weak form
//   density w^2 <u, w> + <u, L w> = 0,   L w = G laplacian w in the simplest case,
// takes no derivative of what was measured. It is one number <u, a> with a = density w^2 w + L w; white noise of u
// makes of several a covariance s^2 <a, a'>, which is known exactly whatever the law's numbers are. Divided by its
// root, what is left of the weak forms of a patch is white noise of variance 1 under the right law, under which noise
// on both sides of the equation biases nothing: to minimise it is total least squares with the weights that noise has.
//
// Rows: for each patch and group of test functions the real and the imaginary part of each component, in noises.
// `measured` is what the same test functions see of the wave and what does not share its noise with the rest; measured
// - predicted is what is left of the weak forms. The load is the frequency (Hz), the place the middle of the patch.
//
// Where each component obeys the equation by itself, w is a bump and its three first derivatives in each component;
// where a pressure is free, w is the curl of a bump, of which a pressure of any shape sees nothing.
//
// Bump: the product over axes of (1 - (x / R)^2)^8. Patches overlap where their test functions all but vanish.
//
// Weak forms of noisy fields: Messenger and Bortz, J. Comput. Phys. 443 (2021) 110525. Elastography by test functions:
// Romano, Shirron and Bucaro, IEEE Trans. Ultrason. Ferroelectr. Freq. Control 45 (1998) 751. Transversely isotropic,
// incompressible: Spencer 1984; Tweten et al., J. Biomech. 48 (2015) 4002. Springpot: Klatt et al., Phys. Med. Biol. 52
// (2007) 7281.

#include <memory>

#include "closedloop/experiment/forward_model.h"

namespace glisson::closedloop {

// Effects: stiffness-scale {factor}; stiff-inclusion {center_mm x 3, radius_mm, ratio}, a sphere; viscosity
// (kelvin-voigt {viscosity_Pa_s}, structural {loss_ratio}, springpot {factor, exponent}); anisotropy {azimuth_deg from
// x to y, elevation_deg from there to z (patient LPS), ratio of the modulus along to that across}, with two or more
// components; compression-waves (degree-2, -4, -6 {share}), where no pressure is free and all three components were
// measured: gradients of harmonic polynomials, their amplitudes free in each trial, are taken off what is left;
// slice-timing (sequential, interleaved {delay_ms}), with more than one slice; boundary-layer {depth_mm, ratio} along
// the region's border.
//
// Fails with "waves-no-patch" where the images are too small for a patch, or none lies within the region.
Result<std::unique_ptr<ForwardModel>> wave_model(Elastography waves);

}  // namespace glisson::closedloop
