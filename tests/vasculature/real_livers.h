#pragma once
// Real livers with segments that somebody drew (livers_couinaud, read only), and how far ours are from them.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "vasculature/couinaud.h"

namespace glisson::test {

// Which half a liver belongs to, by a rule that stood before anything was tuned: the names of the livers with segments
// and vessels in ascending order of their bytes, counted from 0; even ones for tuning, odd ones for judging. The livers
// with segments and no vessels are counted by themselves in the same way.
enum class Half { tuning, judging };
enum class Kind { with_vessels, without_vessels };
[[nodiscard]] std::vector<std::string> real_livers(Kind kind, Half half);

struct RealLiver {
  imaging::LabelMap segments;
  imaging::Mask liver, vessels;           // vessels: empty where there are none
  imaging::LabelMap segments_by_another;  // the same liver labelled once more; empty where it was not
};
[[nodiscard]] RealLiver read_real_liver(const std::string& name);

// Where somebody who can tell the vein that runs along a border would click on it: in the middle of that branch, half
// of it within 4 mm of the drawn border, that is the longest and thickest. None: no branch runs there.
[[nodiscard]] std::optional<vasculature::Click> click_by_truth(const RealLiver& liver,
                                                               const vasculature::VesselGraph& graph,
                                                               vasculature::Vessel vessel);

// Asked for one vessel after the other, each time the one along the border that is most in doubt and can be seen.
[[nodiscard]] vasculature::LiverAnatomy explained_with_clicks(const RealLiver& liver,
                                                              const vasculature::VesselGraph& graph, int clicks);

// Where a hand would set borders: the middle of each that is drawn, the longest border first.
[[nodiscard]] vasculature::BorderPlaces middles_of_borders(const imaging::LabelMap& drawn);

struct SegmentScore {
  std::array<double, 9> dice{};          // by segment; 0: their mean
  std::array<double, 9> volume_error{};  // share of the true volume, absolute
};
[[nodiscard]] SegmentScore score_of(const imaging::LabelMap& found, const imaging::LabelMap& truth);

[[nodiscard]] double median(std::vector<double> values);

}  // namespace glisson::test
