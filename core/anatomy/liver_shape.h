#pragma once
// The liver as an implicit surface of our own design, with what lies against it: gall bladder and vena cava.
//
// Frame: LPS axes (x to the patient's left, y to the back, z to the head), mm. The origin lies on the body's midline,
// in the height of the portal vein's bifurcation. About 2300 ml at this size; a body scales it to its volume.
//
// Design. The right lobe, the left lobe and the quadrate part between them are ellipsoids that run into each other.
// What they lie upon is taken away: stomach, kidney, duodenum and colon, spine. That leaves the visceral surface with
// its impressions, and the sharp inferior margin. The caudate is added behind the porta. Then the fissures (ligamentum
// teres and venosum), the porta, the gall bladder's fossa and the vena cava's groove are cut in.
//
// Proportions. Craniocaudal extent 140 mm (sd 17) in the midclavicular line (Kratzer et al. 2003, J Ultrasound Med
// 22:1155). Right lobe 65 % of the volume (49 to 82), segments II and III 16 % (5 to 27) (Abdalla et al. 2004, Surgery
// 135:404). Gall bladder 7 to 10 cm by 3 to 4 cm, 30 to 50 ml. Vena cava 20 to 25 mm wide (Gray's Anatomy, 41st ed.).
// The modes' widths are chosen, not fitted.

#include <cstdint>

#include "anatomy/implicit.h"

namespace glisson::anatomy {

// How one liver differs from the next; each 0 is the middle, 1 a standard deviation.
struct ShapeModes {
  double right_length = 0;    // the right lobe reaches lower (2: Riedel's lobe)
  double left_extent = 0;     // the left lobe reaches farther
  double left_thickness = 0;  // and is thicker
  double depth = 0;           // front to back against right to left
  double dome = 0;            // the diaphragm stands higher
  double quadrate = 0;        // the quadrate part is fuller
  double caudate = 0;         // the caudate is larger
  double margin = 0;          // the inferior margin is blunter
};

enum class LobeVariant {
  usual,
  no_left_lobe,      // the left lobe is missing, the quadrate part ends the liver (agenesis)
  small_right_lobe,  // the right lobe is a remnant, the left has grown
  turned             // mirrored left to right (situs inversus); applied by the patient, not by the shape
};

class LiverShape {
 public:
  LiverShape(const ShapeModes& modes, LobeVariant variant, std::uint64_t seed);

  // About how far outside the liver, mm; negative inside. First order near the surface, right in sign.
  [[nodiscard]] double distance_mm(const Eigen::Vector3d& position_mm) const;
  // The same without the fine waviness and fissures, for what only asks how deep a place lies.
  [[nodiscard]] double gall_bladder_mm(const Eigen::Vector3d& position_mm) const;

  [[nodiscard]] const Tube& vena_cava() const { return cava_; }
  [[nodiscard]] const Tube& gall_bladder() const { return gall_bladder_; }
  // Within this ellipsoid lies the caudate (segment I).
  [[nodiscard]] const Ellipsoid& caudate() const { return caudate_; }
  // The falciform ligament's plane: x of the umbilical fissure and how it leans with y.
  [[nodiscard]] double umbilical_plane_mm(const Eigen::Vector3d& position_mm) const;
  [[nodiscard]] double bound_mm() const { return 190; }  // half a side of a cube around the origin that holds all

 private:
  std::uint64_t seed_;
  Ellipsoid right_, left_, quadrate_, caudate_, papillary_;
  std::vector<Ellipsoid> neighbours_;
  Ellipsoid spine_;
  Tube cava_, gall_bladder_, porta_, teres_;
  Slab venosum_;
  double margin_mm_;
  bool has_left_;
};

}  // namespace glisson::anatomy
