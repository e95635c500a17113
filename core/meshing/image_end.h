#pragma once
// Where the image ends before the body does. A body is closed there by a flat cap (label_pieces.h), which is no surface
// of the organ: what touches it touches nothing that is there.

#include <Eigen/Core>

#include "geometry/surface.h"
#include "imaging/image.h"

namespace glisson::meshing {

// The side of the patient that a direction (LPS) points to most: "the head", marked for translation.
[[nodiscard]] const char* side_of_patient(const Eigen::Vector3d& towards);

// The side at which the image cuts the body off under a tool that touches what lies within `radius_mm` of its centre.
// It is nullptr where the tool touches the body's own surface. It is the cap where more than a quarter of the area
// touched lies within a voxel of the image's end and faces it.
[[nodiscard]] const char* cut_off_under(const geometry::Surface& body, const imaging::Grid& image,
                                        const Eigen::Vector3d& center_mm, double radius_mm);

}  // namespace glisson::meshing
