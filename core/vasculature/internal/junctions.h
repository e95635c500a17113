#pragma once
// A graph of centre lines as pieces of vessel that meet in junctions.
//
// A junction is where blood can pass on: vertices joined by contacts, by gaps, or by stretches shorter than the vessel
// is wide. Within it any end of a piece may go on into any other, over the passage between them.

#include <array>
#include <Eigen/Core>
#include <vector>

#include "vasculature/vessel_graph.h"

namespace glisson::vasculature {

struct PieceEnd {
  int vertex = -1, junction = -1;
  Eigen::Vector3d position_mm{0, 0, 0};
  Eigen::Vector3d outwards{0, 0, 0};  // unit vector along which the piece leaves itself here
  double radius_mm = 0;               // beyond what the junction's own width covers
};

struct Piece {
  int branch = -1;                 // of the graph
  std::array<PieceEnd, 2> ends;    // at the branch's first and last point
  std::array<double, 2> widens{};  // the most that it widens from that end to the other: logarithm of the radii's ratio
};

// What lies between two ends of one junction.
struct Passage {
  bool contact = false;
  double neck = 1;            // the narrowest contact's radius against the thinner vessel's, at most 1
  double gap_mm = 0;          // of interrupted mask
  std::vector<int> branches;  // of the graph
};

// An end has the number 2 piece + (0 or 1).
struct Junctions {
  std::vector<Piece> pieces;
  std::vector<std::vector<int>> ends_at;       // by junction
  std::vector<int> place_of;                   // of each end among those of its junction
  std::vector<std::vector<Passage>> passages;  // by junction: place times ends + place

  [[nodiscard]] const PieceEnd& end(int number) const {
    return pieces[static_cast<std::size_t>(number / 2)].ends.at(static_cast<std::size_t>(number % 2));
  }
  // Where between two ends something stands in a table as `passages`.
  [[nodiscard]] std::size_t between(int end, int other) const;
};

[[nodiscard]] Junctions junctions_of(const VesselGraph& graph);

// The most that a branch widens on its way, as a logarithm, along radii meant over five points.
[[nodiscard]] double widening(const GraphBranch& branch, bool backwards);

}  // namespace glisson::vasculature
