#pragma once
// A shape model of nobody's: a simulated liver that may bend anywhere, smoothly.

#include "base/result.h"
#include "shapes/shape_model.h"

namespace glisson::shapes {

struct SmoothModelOptions {
  double reference_spacing_mm = 8;  // of the surface's points
  double deviation_mm = 11;         // of each coordinate: livers lie about so far from their mean (docs/shapes.md)
  double length_mm = 60;            // over which places move together
  int modes = 60;                   // at most; what they leave is residual_sd_mm
};

// The mean is reference_liver(); the modes are the leading ones of a Gaussian process of displacements with the kernel
// deviation^2 exp(-|a - b|^2 / (2 length^2)), the same along each axis (Lüthi et al., Gaussian process morphable
// models, IEEE PAMI 40:1860, 2018). `livers` is 0: no patient is in it.
Result<ShapeModel> smooth_model(const SmoothModelOptions& options = {});

}  // namespace glisson::shapes
