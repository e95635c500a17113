#include "widgets/evidence/residual_scene.h"

#include <algorithm>
#include <map>

#include "geometry/nearest.h"
#include "scene/anatomy.h"

namespace glisson::widgets {
namespace {

using closedloop::Explained;
using closedloop::Observations;
using Eigen::Vector3d;

constexpr const char* heat_field = "residual_mm";
constexpr int neighbours = 4;  // markers between which the heat is interpolated
constexpr scene::Colour arrow_colour{1.0, 0.86, 0.45};
constexpr double arrow_share = 0.012;   // of the specimen: how thick an arrow is
constexpr double longest_share = 0.12;  // of the specimen: the longest arrow

struct Residual {
  Vector3d place_mm{0, 0, 0};
  Vector3d vector_mm{0, 0, 0};
};

const closedloop::Palpation& palpation_of(const Explained& explained) {
  return std::get<closedloop::Palpation>(explained.experiment.setup);
}

// The sample of that trial at which the declared model is farthest off.
int worst_sample(const Explained& explained, int trial) {
  const Observations& seen = explained.model->observations();
  std::map<int, double> squares;
  for (Eigen::Index row = 0; row < seen.rows(); ++row) {
    const auto i = static_cast<std::size_t>(row);
    if (seen.trial[i] != trial) continue;
    const double off = seen.measured[row] - explained.explanation.predicted_before[row];
    squares[seen.sample[i]] += off * off;
  }
  const auto worst = std::max_element(squares.begin(), squares.end(),
                                      [](const auto& a, const auto& b) { return a.second < b.second; });
  return worst == squares.end() ? 0 : worst->first;
}

std::vector<Residual> residuals_at(const Explained& explained, int trial, int sample,
                                   const Eigen::VectorXd& predicted) {
  const Observations& seen = explained.model->observations();
  std::map<int, Residual> by_point;
  for (Eigen::Index row = 0; row < seen.rows(); ++row) {
    const auto i = static_cast<std::size_t>(row);
    if (seen.trial[i] != trial || seen.sample[i] != sample) continue;
    Residual& residual = by_point[seen.point[i]];
    residual.place_mm = seen.place_mm.row(row).transpose();
    residual.vector_mm[seen.direction[i]] = seen.measured[row] - predicted[row];
  }
  std::vector<Residual> residuals;
  for (const auto& [point, residual] : by_point) residuals.push_back(residual);
  return residuals;
}

double longest_mm(const std::vector<Residual>& residuals) {
  double longest = 0;
  for (const Residual& residual : residuals) longest = std::max(longest, residual.vector_mm.norm());
  return longest;
}

// The residual's length at each point of the surface, between its nearest markers by the inverse square of distance.
std::vector<double> heat_on(const geometry::Surface& surface, const std::vector<Residual>& residuals) {
  std::vector<Vector3d> places_mm;
  for (const Residual& residual : residuals) places_mm.push_back(residual.place_mm);
  const geometry::NearestPoint markers(places_mm);
  std::vector<double> heat;
  for (const Vector3d& point : surface.points_mm) {
    double sum = 0, weights = 0;
    for (const auto& found : markers.nearest(point, neighbours)) {
      const double weight = 1 / (found.squared_distance_mm2 + 1e-3);
      sum += weight * residuals[static_cast<std::size_t>(found.point)].vector_mm.norm();
      weights += weight;
    }
    heat.push_back(sum / weights);
  }
  return heat;
}

}  // namespace

bool has_residual_scene(const Explained& explained) {
  return std::holds_alternative<closedloop::Palpation>(explained.experiment.setup) &&
         explained.model->observations().has_places();
}

std::size_t worst_trial(const Explained& explained) {
  const Observations& seen = explained.model->observations();
  std::vector<double> squares(seen.trials.size(), 0), rows(seen.trials.size(), 0);
  for (Eigen::Index row = 0; row < seen.rows(); ++row) {
    const auto trial = static_cast<std::size_t>(seen.trial[static_cast<std::size_t>(row)]);
    squares[trial] += std::pow(seen.measured[row] - explained.explanation.predicted_before[row], 2);
    rows[trial] += 1;
  }
  std::size_t worst = 0;
  for (std::size_t k = 1; k < squares.size(); ++k) {
    if (squares[k] * rows[worst] > squares[worst] * rows[k]) worst = k;
  }
  return worst;
}

ResidualScene residual_scene(const Explained& explained, std::size_t trial, ResidualOf of, const std::string& legend) {
  const int sample = worst_sample(explained, static_cast<int>(trial));
  const auto declared =
      residuals_at(explained, static_cast<int>(trial), sample, explained.explanation.predicted_before);
  const auto shown = of == ResidualOf::declared ? declared
                                                : residuals_at(explained, static_cast<int>(trial), sample,
                                                               explained.explanation.predicted_after);
  ResidualScene made;
  made.largest_mm = std::max(longest_mm(declared), 1e-6);
  geometry::Surface specimen = geometry::boundary_surface(palpation_of(explained).mesh);
  const double size_mm = geometry::bounding_box(specimen.points_mm).diagonal_mm();
  made.magnification = longest_share * size_mm / made.largest_mm;
  if (!shown.empty()) geometry::set_field(specimen.point_fields, {heat_field, 1, heat_on(specimen, shown)});
  scene::SurfaceItem item{"specimen",
                          std::make_shared<geometry::Surface>(std::move(specimen)),
                          scene::appearance_of("liver").colour,
                          0.75,
                          scene::Finish::solid,
                          {}};
  if (!shown.empty()) {
    item.colouring = scene::Colouring{heat_field, scene::ColourMap::viridis, {0, made.largest_mm}, legend};
  }
  made.scene.surfaces.push_back(std::move(item));
  for (const Residual& residual : shown) {
    const Vector3d way_mm = made.magnification * residual.vector_mm;
    if (way_mm.norm() < 0.004 * size_mm) continue;
    made.scene.arrows.push_back(
        {residual.place_mm, residual.place_mm + way_mm, arrow_share * size_mm, arrow_colour, {}});
  }
  made.scene.annotations.orientation = scene::Annotations::Orientation::hidden;
  return made;
}

}  // namespace glisson::widgets
