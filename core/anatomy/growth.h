#pragma once
// A tree grows into an organ, one terminal branch after the other (constrained constructive optimisation). Each branch
// is joined where that adds the least volume of blood (Schreiner and Buxbaum 1993, IEEE Trans Biomed Eng 40:482; Karch
// et al. 1999, Comput Biol Med 29:19, for three dimensions and organs that are not convex).
//
// Radii follow Murray's law throughout, all terminal branches carrying the same flow. A joint is refused where a
// branch would leave the organ, run into a lesion or come near another branch.

#include <cstdint>
#include <vector>

#include "anatomy/lesions.h"
#include "anatomy/segments.h"
#include "anatomy/vessel_tree.h"

namespace glisson::anatomy {

// About `count` places spread over the liver's tissue, nowhere crowded. They are random ones, each at least as far from
// the others as lets that many in (Poisson discs: Cook 1986, ACM Trans Graph 5:51; random packing saturates at 0.38 of
// the volume). In random order. None lies in a lesion or under `depth_mm`.
[[nodiscard]] std::vector<Eigen::Vector3d> spread_places(const LiverBody& liver, const std::vector<Lesion>& lesions,
                                                         int count, double depth_mm, std::uint64_t seed);

struct GrowthSite {
  const LiverBody* liver = nullptr;
  const Segments* segments = nullptr;
  const std::vector<Lesion>* lesions = nullptr;
  std::vector<const VesselTree*> others;  // to be kept clear of
  bool by_segment = true;                 // a branch feeds one segment alone (portal vein), or any (hepatic veins)
  double root_radius_mm = 6;
};

// Between walls of different branches at least.
inline constexpr double clear_mm = 0.4;

// The trunk with branches to the places that could be reached, parents before children, radii set. What still met
// after growth, when radii are final, is cut off.
[[nodiscard]] VesselTree grown(VesselTree trunk, const std::vector<Eigen::Vector3d>& places, const GrowthSite& site);

}  // namespace glisson::anatomy
