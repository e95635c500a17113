#pragma once
// What holds a liver in the body, found by its shape: the default supports of a case, which can be replaced.
//
// Two point fields (0 or 1) are put on the mesh, so that scenarios can name them as point arrays:
//   bare_area   where the organ has no peritoneum and is bound to the diaphragm and the vena cava: held
//   diaphragm   the dome under the diaphragm: on an elastic foundation
//
// Frame: patient LPS (x to the left, y to the back, z to the head), the patient supine, mm.

#include <vector>

#include "base/result.h"
#include "geometry/tetrahedra.h"
#include "mechanics/scenario/scenario.h"

namespace glisson::rehearsal {

// The rule, on the boundary's points with their outward normals and heights in the liver's bounding box:
//   bare area   normal to the back and the head in equal parts or nearer (within 45 degrees of (0, 1, 1)), in the upper
//               half and the rear half of the box
//   diaphragm   normal within 60 degrees of the head's direction, and not of the bare area
// A rule of thumb on the shape alone, as anatomy texts describe it (bare area: posterior superior surface of the right
// lobe); not a segmentation. Fails with "liver-no-attachment" where no face has all its points in the bare area.
Result<void> mark_attachments(geometry::TetMesh& liver);

// bare_area held; diaphragm on a foundation. Table 4.1 of the dissertation gives the abdominal wall 22 kPa. As a layer
// on a stiff ground it is a spring of E / thickness per unit area. For its thickness 20 mm is assumed, which makes 1.1
// kPa/mm: an abdominal wall with diaphragm measures 15 to 30 mm.
[[nodiscard]] std::vector<mechanics::Support> usual_supports();

}  // namespace glisson::rehearsal
