#include "elastography/wave_images.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace glisson::elastography {
namespace {

// Scans take 3 to 12 instants of a period, nearly always 4 or 8; 24 volumes are three directions.
constexpr int maximum_instants_of_one_direction = 12;
constexpr int minimum_instants = 4;

// Where a volume belongs.
struct Place {
  double frequency_Hz;
  int direction;
  int instant;
};

Result<std::vector<Place>> places_of(const std::vector<PhaseImage>& images, const AskedFor& asked,
                                     std::vector<Sentence>& notes);
void scale_to_radians(std::vector<PhaseImage>& images, std::vector<Sentence>& notes);
Result<WaveImages> gather(std::vector<PhaseImage>& images, const std::vector<Place>& places, double frequency_Hz);

}  // namespace

Result<SortedWaves> sort_waves(std::vector<PhaseImage> images, const AskedFor& asked) {
  if (images.empty()) return failure("waves-none", GLISSON_TEXT("There are no wave or phase images."));
  for (const PhaseImage& image : images) {
    if (!imaging::same_grid(image.volume.grid, images.front().volume.grid, 0.1)) {
      return failure("waves-grids-differ", GLISSON_TEXT("The wave images do not all lie on one grid."));
    }
  }
  SortedWaves sorted;
  const auto places = places_of(images, asked, sorted.notes);
  if (!places) return failure(places.error());
  scale_to_radians(images, sorted.notes);

  std::vector<double> frequencies;
  for (const Place& place : *places) frequencies.push_back(place.frequency_Hz);
  std::sort(frequencies.begin(), frequencies.end());
  frequencies.erase(std::unique(frequencies.begin(), frequencies.end()), frequencies.end());
  for (const double frequency_Hz : frequencies) {
    auto waves = gather(images, *places, frequency_Hz);
    if (!waves) return failure(waves.error());
    sorted.frequencies.push_back(std::move(*waves));
  }
  return sorted;
}

namespace {

Result<std::vector<double>> frequencies_of(const std::vector<PhaseImage>& images, const AskedFor& asked) {
  std::vector<double> found;
  std::size_t known = 0;
  double first = 0;
  bool several = false;
  for (const PhaseImage& image : images) {
    if (!image.motion.frequency_Hz) continue;
    if (known++ == 0) first = *image.motion.frequency_Hz;
    several = several || *image.motion.frequency_Hz != first;
  }
  for (const PhaseImage& image : images) {
    const bool ask = !several && asked.frequency_Hz.has_value();
    const std::optional<double> frequency = ask ? asked.frequency_Hz : image.motion.frequency_Hz;
    if (!frequency) {
      return failure(Error{"waves-no-frequency",
                           GLISSON_TEXT("The headers do not say at which frequency the organ was shaken."),
                           {},
                           GLISSON_TEXT("Give it with --frequency-Hz; liver scans mostly use 60."),
                           {}});
    }
    if (!(*frequency > 0) || !std::isfinite(*frequency)) {
      return failure("waves-bad-frequency", GLISSON_TEXT("A vibration of {0} Hz is not possible."),
                     {fmt::format("{:g}", *frequency)});
    }
    found.push_back(*frequency);
  }
  return found;
}

// Direction and instant by counting, for the volumes of one series that say neither.
Result<void> count_through(const std::vector<std::size_t>& series, int first_direction, const AskedFor& asked,
                           std::vector<Place>& places, std::vector<Sentence>& notes) {
  const int volumes = static_cast<int>(series.size());
  if (!asked.directions && volumes > maximum_instants_of_one_direction) {
    return failure(Error{"waves-no-directions",
                         GLISSON_TEXT("The headers do not say which of the {0} wave images belong to which direction."),
                         {std::to_string(volumes)},
                         GLISSON_TEXT("Say how many directions were measured with --directions; mostly 1 or 3."),
                         {}});
  }
  const int directions = asked.directions.value_or(1);
  if (directions < 1 || volumes % directions != 0) {
    return failure("waves-uneven", GLISSON_TEXT("{0} wave images cannot be shared out among {1} directions."),
                   {std::to_string(volumes), std::to_string(directions)});
  }
  const int instants = volumes / directions;
  for (int v = 0; v < volumes; ++v) {
    Place& place = places[series[static_cast<std::size_t>(v)]];
    place.direction = first_direction + v / instants;
    place.instant = v % instants;
  }
  notes.push_back(
      {GLISSON_TEXT("The headers name no directions: the {0} images were taken as {1} x {2} instants in their order."),
       {std::to_string(volumes), std::to_string(directions), std::to_string(instants)}});
  return {};
}

Result<std::vector<Place>> places_of(const std::vector<PhaseImage>& images, const AskedFor& asked,
                                     std::vector<Sentence>& notes) {
  const auto frequencies = frequencies_of(images, asked);
  if (!frequencies) return failure(frequencies.error());
  std::vector<Place> places(images.size());
  std::map<std::pair<double, int>, std::vector<std::size_t>> uncounted;  // by frequency and series
  std::map<double, int> directions_at;                                   // how many each frequency has so far
  for (std::size_t v = 0; v < images.size(); ++v) {
    const imaging::MotionEncoding& motion = images[v].motion;
    places[v] = {(*frequencies)[v], motion.direction.value_or(0), motion.offset.value_or(0)};
    if (motion.direction && motion.offset) {
      directions_at[places[v].frequency_Hz] = std::max(directions_at[places[v].frequency_Hz], *motion.direction + 1);
    } else {
      uncounted[{places[v].frequency_Hz, images[v].series}].push_back(v);
    }
  }
  for (const auto& [of, series] : uncounted) {
    int& first = directions_at[of.first];
    if (auto counted = count_through(series, first, asked, places, notes); !counted) return failure(counted.error());
    first += asked.directions.value_or(1);
  }
  return places;
}

void scale_to_radians(std::vector<PhaseImage>& images, std::vector<Sentence>& notes) {
  float minimum = std::numeric_limits<float>::max();
  float maximum = std::numeric_limits<float>::lowest();
  for (const PhaseImage& image : images) {
    if (image.volume.unit == "rad" || !image.wrapped) return;
    for (const float value : image.volume.values) {
      minimum = std::min(minimum, value);
      maximum = std::max(maximum, value);
    }
  }
  if (!(maximum > minimum)) return;
  const double scale = 2 * std::numbers::pi / (static_cast<double>(maximum) - static_cast<double>(minimum));
  for (PhaseImage& image : images) {
    for (float& value : image.volume.values) {
      value =
          static_cast<float>((static_cast<double>(value) - static_cast<double>(minimum)) * scale - std::numbers::pi);
    }
    image.volume.unit = "rad";
  }
  notes.push_back({GLISSON_TEXT("The phase images have no unit: their full range, {0} to {1}, was taken as one turn."),
                   {fmt::format("{:g}", minimum), fmt::format("{:g}", maximum)}});
}

Result<WaveImages> gather(std::vector<PhaseImage>& images, const std::vector<Place>& places, double frequency_Hz) {
  WaveImages waves;
  waves.frequency_Hz = frequency_Hz;
  waves.grid = images.front().volume.grid;
  std::map<int, std::map<int, std::size_t>> by_direction;
  for (std::size_t v = 0; v < places.size(); ++v) {
    if (places[v].frequency_Hz != frequency_Hz) continue;
    by_direction[places[v].direction].emplace(places[v].instant, v);
  }
  bool all_known = true;
  for (const auto& [direction, instants] : by_direction) {
    if (instants.size() != by_direction.begin()->second.size()) {
      return failure("waves-uneven",
                     GLISSON_TEXT("At {0} Hz direction {1} has {2} instants and the first direction {3}."),
                     {fmt::format("{:g}", frequency_Hz), std::to_string(direction + 1), std::to_string(instants.size()),
                      std::to_string(by_direction.begin()->second.size())});
    }
    if (static_cast<int>(instants.size()) < minimum_instants) {
      return failure("waves-too-few-offsets",
                     GLISSON_TEXT("Only {0} instants of the wave were measured; at least {1} are needed to tell the "
                                  "wave from noise."),
                     {std::to_string(instants.size()), std::to_string(minimum_instants)});
    }
    waves.phase_rad.emplace_back();
    for (const auto& [instant, v] : instants) {
      PhaseImage& image = images[v];
      waves.wrapped = image.wrapped;
      if (instant == instants.begin()->first) {
        const std::vector<double>& times_s = image.motion.slice_times_s;
        if (times_s.size() == static_cast<std::size_t>(waves.grid.size[2])) waves.slice_times_s = times_s;
        all_known = all_known && image.motion.along.has_value();
        waves.along.push_back(image.motion.along.value_or(Eigen::Vector3d::Zero()));
      }
      waves.phase_rad.back().push_back(std::move(image.volume.values));
    }
  }
  if (!all_known) waves.along.clear();
  return waves;
}

}  // namespace
}  // namespace glisson::elastography
