#include "real_livers.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>

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
  return liver;
}

vasculature::Clicks clicks_by_truth(const RealLiver& liver, const vasculature::VesselGraph& graph) {
  const auto expected = vasculature::expected_entries(liver.liver).value();
  const imaging::Grid& grid = liver.segments.grid;
  static constexpr std::array<int, 9> sector = {0, 0, 1, 1, 2, 3, 4, 4, 3};
  const auto on_border = [&](const Vector3d& position_mm) {
    int first = 0;
    for (int n = 0; n < 27; ++n) {
      const Vector3d beside = position_mm + 4 * Vector3d(n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1);
      const Vector3d at = grid.index_of(beside);
      const int i = static_cast<int>(std::lround(at.x())), j = static_cast<int>(std::lround(at.y())),
                k = static_cast<int>(std::lround(at.z()));
      const int here = grid.contains(i, j, k) ? sector.at(liver.segments.at(i, j, k)) : 0;
      if (here != 0 && first != 0 && here != first) return true;
      if (here != 0) first = here;
    }
    return false;
  };
  vasculature::Clicks best;
  double most = -1e30;
  for (const vasculature::VesselEntries& entries : vasculature::possible_entries(graph, expected)) {
    double score = 0;
    for (const vasculature::TreeBranch& branch : vasculature::classify_vessels(graph, entries).branches) {
      for (const vasculature::CenterPoint& point : branch.points) {
        if (point.radius_mm < 2 || (point.position_mm - entries.portal_mm).norm() < 25) continue;
        const double sign = branch.system == vasculature::System::hepatic_vein ? 1 : -1;
        if (on_border(point.position_mm)) score += sign * (point.radius_mm - 1);
      }
    }
    if (score <= most) continue;
    most = score;
    best = {entries.portal_mm, entries.hepatic_mm};
  }
  return best;
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
