#pragma once
// Portal and hepatic veins told apart, and each as a tree from where it enters. Arteries and bile ducts as trees beside
// them.
//
// Which system a branch belongs to follows from all of them at once: what is likely of trees of vessels
// (internal/forest.h), and that both systems reach every part of the liver (internal/told_apart.h). Then each system
// grows from where it enters, along its part of the graph. It costs a vessel to turn sharply, to grow wider on its way
// out and to pass a neck.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "vasculature/borders.h"
#include "vasculature/vessel_graph.h"

namespace glisson::vasculature {

enum class System { portal_vein, hepatic_vein, artery, biliary_tract };
inline constexpr std::array<System, 4> all_systems = {System::portal_vein, System::hepatic_vein, System::artery,
                                                      System::biliary_tract};
// Those that tissue is shared out by. Arteries and bile ducts run with portal branches, whose tissue is theirs.
inline constexpr std::array<System, 2> vein_systems = {System::portal_vein, System::hepatic_vein};
[[nodiscard]] constexpr bool is_vein(System system) {
  return system == System::portal_vein || system == System::hepatic_vein;
}
[[nodiscard]] const char* system_name(System system);  // "portal-vein", as the structure is called
[[nodiscard]] std::optional<System> system_named(const std::string& name);

// What a click may say of a vessel: its system, or its own name where it runs between segments.
enum class Vessel {
  portal_vein,
  hepatic_vein,
  middle_hepatic_vein,
  right_hepatic_vein,
  umbilical_portion,  // of the left portal vein
  left_hepatic_vein
};
inline constexpr std::array<Vessel, 6> all_vessels = {Vessel::portal_vein,         Vessel::hepatic_vein,
                                                      Vessel::middle_hepatic_vein, Vessel::right_hepatic_vein,
                                                      Vessel::umbilical_portion,   Vessel::left_hepatic_vein};
[[nodiscard]] const char* vessel_name(Vessel vessel);  // "middle-hepatic-vein"
[[nodiscard]] std::optional<Vessel> vessel_named(const std::string& name);
[[nodiscard]] System system_of(Vessel vessel);

struct Click {
  Vessel vessel = Vessel::portal_vein;
  Eigen::Vector3d position_mm{0, 0, 0};
};
using Clicks = std::vector<Click>;  // of two on one branch the later counts

// All that somebody told of one liver.
struct Told {
  Clicks clicks;
  BorderPlaces borders;
};

// One branch of a tree, its points from where it leaves its parent outwards.
struct TreeBranch {
  System system = System::portal_vein;
  double confidence = 1;  // of the system, 0.5 to 1
  int parent = -1;        // an earlier branch; -1 where a tree, or a piece that hangs on none, begins
  int generation = 0;     // divisions before it
  std::string name;       // "portal/right/posterior/VI/2"; set by name_branches (couinaud.h)
  std::vector<CenterPoint> points;
  Joint joint = Joint::vessel;
  double length_mm = 0, radius_mm = 0;
};

// How much of the liver is in doubt along the border where a vessel runs, which a click on that vessel would tell.
struct BorderDoubt {
  Vessel vessel = Vessel::middle_hepatic_vein;
  double doubt_ml = 0;
};

struct VesselTrees {
  Eigen::Vector3d portal_entry_mm{0, 0, 0}, hepatic_entry_mm{0, 0, 0};
  std::vector<TreeBranch> branches;        // parents first; systems in their order
  Clicks clicks;                           // what they were told by
  BorderPlaces borders;                    // where a hand set borders of segments
  std::vector<BorderDoubt> border_doubts;  // of segments by them, the largest first; of one class alone
};

// Where the portal vein divides and where the hepatic veins meet the vena cava, as far as the liver's shape says
// (expected_entries in couinaud.h). The scale is 1 for a liver of 1500 ml.
struct VesselEntries {
  Eigen::Vector3d portal_mm{0, 0, 0}, hepatic_mm{0, 0, 0};
  double scale = 1;
};

// Guesses at where vessels really enter, the best first. They are the thickest places near where they are expected,
// those of one system at least 20 mm apart. Each is joined with each of the other system; a click leaves no choice.
[[nodiscard]] std::vector<VesselEntries> possible_entries(const VesselGraph& graph, const VesselEntries& expected,
                                                          const Clicks& clicks = {}, int each = 3);

// From about where vessels enter. places_mm: spread over the liver, each to be fed and drained; none: this is not
// asked. A click tells the system of the branch whose wall is nearest: all else follows from it. Same graph, same
// trees.
[[nodiscard]] VesselTrees classify_vessels(const VesselGraph& graph, const VesselEntries& entries,
                                           const std::vector<Eigen::Vector3d>& places_mm = {},
                                           const Clicks& clicks = {});

// Where each system has a graph of its own.
[[nodiscard]] VesselTrees known_vessels(const VesselGraph& portal, const VesselGraph& hepatic,
                                        const VesselEntries& entries);

// Adds an artery or bile ducts, which are known to be that; veins stay as they are. Each connected piece grows from its
// end outside of the liver that is the widest and farthest: radius times distance. A piece without such an end grows
// from near where the portal vein enters.
void add_known_vessels(const VesselGraph& graph, System system, const imaging::Mask& liver, VesselTrees& trees);

}  // namespace glisson::vasculature
