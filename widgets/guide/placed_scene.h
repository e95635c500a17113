#pragma once
// The liver as a frame deforms it, with what was seen of its surface, for the view in space beside the frame. In
// patient coordinates, so that it is looked at as everywhere else.

#include <vector>

#include "casefile/guided_sequence.h"
#include "casefile/marked_lines.h"
#include "scene/scene.h"

namespace glisson::widgets {

// `seen_mm`: the frame's cloud in the camera's frame, drawn as small dots; at most a few hundred of its points.
[[nodiscard]] scene::Scene placed_scene(const casefile::GuidedSequence& guided,
                                        const guidance::ElasticPlacement& placement,
                                        const std::vector<Eigen::Vector3d>& seen_mm);

// The liver at rest to mark lines on, with those that are marked; the one of that id stands out.
[[nodiscard]] scene::Scene marking_scene(const casefile::GuidedSequence& guided, const casefile::MarkedLines& marked,
                                         const std::string& current);

// As the laparoscope looks at it: its frame of that width fills a view of that shape from side to side. `aspect`: the
// view's width by its height.
[[nodiscard]] scene::Camera laparoscope_camera(const casefile::GuidedSequence& guided,
                                               const guidance::ElasticPlacement& placement,
                                               const vision::Camera& camera, int width_px, double aspect);

}  // namespace glisson::widgets
