#include "real_livers.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>

#include "imaging/volume_file.h"
#include "support/data.h"

namespace glisson::test {

using Eigen::Vector3d;

namespace {

std::filesystem::path file_of(const std::string& name, const std::string& what) {
  return shared_data() / "livers_couinaud" / (name + "_" + what + ".nii.gz");
}

imaging::Mask mask_of(const imaging::LabelMap& labels) {
  imaging::Mask mask{labels.grid, std::vector<std::uint8_t>(labels.values.size())};
  for (std::size_t i = 0; i < mask.values.size(); ++i) mask.values[i] = labels.values[i] != 0 ? 1 : 0;
  return mask;
}

// The segments on either side of the border along which a vessel runs, and all that lies beside it on its way.
struct Border {
  std::set<int> one, other, beside;
};
Border border_along(vasculature::Vessel vessel) {
  using vasculature::Vessel;
  switch (vessel) {
    case Vessel::middle_hepatic_vein: return {{4}, {5, 8}, {4, 5, 8}};
    case Vessel::right_hepatic_vein: return {{5, 8}, {6, 7}, {5, 6, 7, 8}};
    case Vessel::umbilical_portion: return {{3}, {4}, {2, 3, 4}};
    case Vessel::left_hepatic_vein: return {{2}, {3}, {2, 3}};
    default: return {};
  }
}

// How far a place is from the farther side of the border, and from what does not lie beside it, at most `farthest_mm`.
struct Away {
  double from_border_mm, from_others_mm;
};
constexpr double farthest_mm = 8;
Away away_from(const imaging::LabelMap& segments, const Border& border, const Vector3d& place_mm) {
  const imaging::Grid& grid = segments.grid;
  const Vector3d at = grid.index_of(place_mm);
  std::array<int, 3> low{}, high{};
  for (int a = 0; a < 3; ++a) {
    const double reach = farthest_mm / grid.spacing_mm[a];
    low.at(static_cast<std::size_t>(a)) = std::max(0, static_cast<int>(std::ceil(at[a] - reach)));
    high.at(static_cast<std::size_t>(a)) = std::min(grid.size[a] - 1, static_cast<int>(std::floor(at[a] + reach)));
  }
  double one = farthest_mm, other = farthest_mm, others = farthest_mm;
  for (int k = low[2]; k <= high[2]; ++k) {
    for (int j = low[1]; j <= high[1]; ++j) {
      for (int i = low[0]; i <= high[0]; ++i) {
        const int segment = segments.at(i, j, k);
        const double away = (grid.position_mm(i, j, k) - place_mm).norm();
        if (border.one.count(segment) != 0) one = std::min(one, away);
        if (border.other.count(segment) != 0) other = std::min(other, away);
        if (segment != 0 && border.beside.count(segment) == 0) others = std::min(others, away);
      }
    }
  }
  return {std::max(one, other), others};
}

}  // namespace

std::vector<std::string> real_livers(Kind kind, Half half) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(shared_data() / "livers_couinaud")) {
    const std::string file = entry.path().filename().string(), ending = "_couinaud.nii.gz";
    if (!file.ends_with(ending)) continue;
    const std::string name = file.substr(0, file.size() - ending.size());
    if (std::filesystem::exists(file_of(name, "vessels")) == (kind == Kind::with_vessels)) names.push_back(name);
  }
  std::sort(names.begin(), names.end());
  std::vector<std::string> chosen;
  for (std::size_t i = half == Half::tuning ? 0 : 1; i < names.size(); i += 2) chosen.push_back(names[i]);
  return chosen;
}

RealLiver read_real_liver(const std::string& name) {
  RealLiver liver;
  liver.segments = imaging::read_labels_file(file_of(name, "couinaud")).value();
  liver.liver = mask_of(liver.segments);
  if (std::filesystem::exists(file_of(name, "vessels"))) {
    liver.vessels = mask_of(imaging::read_labels_file(file_of(name, "vessels")).value());
  }
  if (std::filesystem::exists(file_of(name, "couinaud2"))) {
    liver.segments_by_another = imaging::read_labels_file(file_of(name, "couinaud2")).value();
  }
  return liver;
}

std::optional<vasculature::Click> click_by_truth(const RealLiver& liver, const vasculature::VesselGraph& graph,
                                                 vasculature::Vessel vessel) {
  const Border border = border_along(vessel);
  const vasculature::GraphBranch* best = nullptr;
  double most = 0;
  for (const vasculature::GraphBranch& branch : graph.branches) {
    if (branch.joint != vasculature::Joint::vessel || branch.points.size() < 5) continue;
    std::vector<double> away_mm;
    double size = 0;
    for (const vasculature::CenterPoint& point : branch.points) {
      away_mm.push_back(away_from(liver.segments, border, point.position_mm).from_border_mm);
      size += std::max(0.0, point.radius_mm - 1);
    }
    const Vector3d& middle_mm = branch.points[branch.points.size() / 2].position_mm;
    if (size <= most || median(away_mm) > 4) continue;
    if (away_from(liver.segments, border, middle_mm).from_others_mm < farthest_mm) continue;
    most = size;
    best = &branch;
  }
  if (best == nullptr) return {};
  return vasculature::Click{vessel, best->points[best->points.size() / 2].position_mm};
}

vasculature::LiverAnatomy explained_with_clicks(const RealLiver& liver, const vasculature::VesselGraph& graph,
                                                int clicks) {
  vasculature::Clicks clicked;
  auto found = vasculature::explain_vessels(graph, liver.liver).value();
  std::set<vasculature::Vessel> asked;
  while (static_cast<int>(clicked.size()) < clicks) {
    const auto& doubts = found.segments.border_doubts;
    const auto next =
        std::find_if(doubts.begin(), doubts.end(), [&](const auto& doubt) { return asked.count(doubt.vessel) == 0; });
    if (next == doubts.end()) break;
    const vasculature::Vessel vessel = next->vessel;
    asked.insert(vessel);
    const auto click = click_by_truth(liver, graph, vessel);
    if (!click) continue;
    clicked.push_back(*click);
    found = vasculature::explain_vessels(graph, liver.liver, {clicked, {}}).value();
  }
  return found;
}

vasculature::BorderPlaces middles_of_borders(const imaging::LabelMap& drawn) {
  std::vector<std::pair<double, vasculature::BorderPlace>> found;
  for (const auto& [pair, places_mm] : vasculature::drawn_borders(drawn)) {
    if (places_mm.size() < 100) continue;
    Vector3d mean = Vector3d::Zero();
    double away_mm = 0;
    for (const Vector3d& p : places_mm) mean += p / static_cast<double>(places_mm.size());
    for (const Vector3d& p : places_mm) away_mm = std::max(away_mm, (p - mean).norm());
    const auto nearer = [&](const Vector3d& a, const Vector3d& b) { return (a - mean).norm() < (b - mean).norm(); };
    found.emplace_back(away_mm, vasculature::BorderPlace{
                                    pair, *std::min_element(places_mm.begin(), places_mm.end(), nearer)});
  }
  std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  vasculature::BorderPlaces places;
  for (const auto& [away_mm, place] : found) places.push_back(place);
  return places;
}

SegmentScore score_of(const imaging::LabelMap& found, const imaging::LabelMap& truth) {
  std::array<double, 9> a{}, b{}, both{};
  for (std::size_t i = 0; i < truth.values.size(); ++i) {
    ++a[found.values[i]], ++b[truth.values[i]];
    if (found.values[i] == truth.values[i]) ++both[truth.values[i]];
  }
  SegmentScore score;
  for (std::size_t s = 1; s <= 8; ++s) {
    score.dice[s] = a[s] + b[s] > 0 ? 2 * both[s] / (a[s] + b[s]) : 1;
    score.dice[0] += score.dice[s] / 8;
    score.volume_error[s] = b[s] > 0 ? std::abs(a[s] - b[s]) / b[s] : 1;
  }
  return score;
}

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

}  // namespace glisson::test
