#pragma once
// A model laid onto what is seen of a liver. The answer is where the liver lies, which of the model's livers it is, and
// how sure each point of it is.
//
// The posterior of a Gaussian model given seen points (Albrecht, Lüthi, Gerig and Vetter, "Posterior shape models",
// Medical Image Analysis 17:959, 2013). It has the mean m, modes Q, seen rows s and noise N. The coefficients have the
// covariance C = (I + Q_s' N^-1 Q_s)^-1 and the mean C Q_s' N^-1 (seen - m_s). Here a small rigid motion is part of Q,
// with a wide prior. So not knowing where the liver lies widens the answer too. A nearest place says little of where
// along the surface a point belongs: the noise is wider along it than across it.

#include <Eigen/Geometry>
#include <optional>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "geometry/surface.h"
#include "shapes/shape_model.h"

namespace glisson::shapes {

struct FitOptions {
  double noise_mm = 1.5;  // of seen places, across the surface
  double along_mm = 15;   // and along it
  // Seen points are many and lie close, and no model is right: a whole liver counts as so many, a part as fewer. Fewer
  // make the answer less sure. Chosen on 41 real livers, of whose missing parts 85 % then lay within 1.96 deviations.
  int independent = 15;
  int iterations = 40;
  std::optional<Eigen::Isometry3d> pose = {};  // from the model to the patient, at first; else by the middles
};

struct ShapeFit {
  geometry::Surface surface;                    // the liver, in the patient's frame, with the model's points
  std::vector<double> sd_mm;                    // a point: root of the mean of the variances along x, y and z
  std::vector<Eigen::Matrix3d> covariance_mm2;  // a point
  Eigen::VectorXd coefficients;                 // of the modes, in standard deviations
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  double volume_ml = 0, volume_sd_ml = 0;  // of the surface; by the modes and the pose
  double residual_mm = 0;                  // root mean square of the seen points' distances from the surface
  // Mean square of the coefficients: about 1 or less for a liver as the model's.
  double mean_square = 0;
};

// `seen` may be open or closed, all of a liver or a part; whatever it does not cover follows by the posterior. Its
// frame is the patient's (LPS), turned by no more than some 30 degrees from the model's. Failures: those of
// check_surface; "shapes-no-overlap" (fewer than 30 points find the model); "cancelled".
Result<ShapeFit> fit_model(const ShapeModel& model, const geometry::Surface& seen, const FitOptions& options = {},
                           const Progress& progress = {});

}  // namespace glisson::shapes
