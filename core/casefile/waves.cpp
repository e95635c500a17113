#include "casefile/waves.h"

#include <fmt/format.h>
#include <algorithm>
#include <map>

#include "casefile/internal/motion_options.h"
#include "imaging/volume_file.h"

namespace glisson::casefile {
namespace fs = std::filesystem;
namespace {

// "volumes/phase", "volumes/phase-07": an entry of that kind.
bool is_of(const Entry& entry, const std::string& kind) { return entry.id == kind || entry.id.starts_with(kind + "-"); }

std::vector<const Entry*> entries_of(const Case& patient, const std::string& kind) {
  std::vector<const Entry*> found;
  for (const Entry& entry : patient.entries()) {
    if (is_of(entry, kind)) found.push_back(&entry);
  }
  return found;
}

Result<std::vector<float>> mean_magnitude(const Case& patient, const imaging::Grid& grid) {
  std::vector<float> mean;
  const auto entries = entries_of(patient, "volumes/magnitude");
  for (const Entry* entry : entries) {
    const auto volume = imaging::read_volume_file(patient.folder() / entry->file);
    if (!volume) return failure(volume.error());
    if (!imaging::same_grid(volume->grid, grid, 0.1)) {
      return failure("waves-grids-differ", GLISSON_TEXT("The magnitude images do not lie on the grid of the waves."));
    }
    mean.resize(volume->values.size(), 0);
    for (std::size_t v = 0; v < mean.size(); ++v) mean[v] += volume->values[v] / static_cast<float>(entries.size());
  }
  return mean;
}

const char* long_waves_name(elastography::LongWaves way) {
  switch (way) {
    case elastography::LongWaves::curl: return "curl";
    case elastography::LongWaves::keep: return "keep";
    case elastography::LongWaves::high_pass: break;
  }
  return "high-pass";
}

}  // namespace

Result<void> accept_waves(Case& patient, const InvertedWaves& inverted) {
  const elastography::ModulusMap& map = inverted.map;
  const auto save = [&](const char* id, const imaging::Volume& volume) {
    return patient.add(id, ".nrrd", inverted.made,
                       [&](const fs::path& file) { return imaging::write_volume_file(file, volume); });
  };
  return patient.together([&]() -> Result<void> {
    if (auto saved = save("volumes/shear-wave", map.wave_rad); !saved) return saved;
    for (const auto& [id, volume] : {std::pair{"volumes/storage", &map.storage_kPa}, {"volumes/loss", &map.loss_kPa}}) {
      Result<void> done;
      if (*volume) {
        done = save(id, **volume);
      } else if (patient.find(id) != nullptr) {
        done = patient.remove(id);  // that of an earlier inversion would not belong to this map
      }
      if (!done) return done;
    }
    if (auto saved = save("volumes/confidence", map.confidence); !saved) return saved;
    return save("volumes/stiffness", map.magnitude_kPa);
  });
}

bool has_waves(const Case& patient) {
  const auto& entries = patient.entries();
  return std::any_of(entries.begin(), entries.end(), [](const Entry& entry) {
    return entry.id.starts_with("volumes/phase") || entry.id.starts_with("volumes/wave");
  });
}

Result<elastography::SortedWaves> read_waves(const Case& patient, const elastography::AskedFor& asked) {
  std::vector<const Entry*> entries = entries_of(patient, "volumes/phase");
  const bool wrapped = !entries.empty();
  if (!wrapped) entries = entries_of(patient, "volumes/wave");
  if (entries.empty()) {
    return failure(Error{"waves-none",
                         GLISSON_TEXT("{0} holds no wave or phase images."),
                         {patient.folder().string()},
                         GLISSON_TEXT("Import the phase series of an elastography scan (glisson-cli import --phase)."),
                         patient.folder()});
  }
  std::vector<elastography::PhaseImage> images;
  std::map<std::string, int> number_of_series;
  for (const Entry* entry : entries) {
    auto volume = imaging::read_volume_file(patient.folder() / entry->file);
    if (!volume) return failure(volume.error());
    const auto series = entry->made.options.find("series");
    const std::string uid = series == entry->made.options.end() ? std::string() : series->second;
    const int number = number_of_series.try_emplace(uid, static_cast<int>(number_of_series.size())).first->second;
    images.push_back({std::move(*volume), motion_from(entry->made.options), number, wrapped});
  }
  const imaging::Grid grid = images.front().volume.grid;
  auto sorted = elastography::sort_waves(std::move(images), asked);
  if (!sorted) return sorted;
  auto magnitude = mean_magnitude(patient, grid);
  if (!magnitude) return failure(magnitude.error());
  for (elastography::WaveImages& waves : sorted->frequencies) waves.magnitude = *magnitude;
  return sorted;
}

Result<InvertedWaves> inverted_waves(const Case& patient, const elastography::AskedFor& asked,
                                     const elastography::InversionOptions& options, const Progress& progress) {
  progress.report(0, GLISSON_TEXT("Reading the waves"));
  const auto sorted = read_waves(patient, asked);
  if (!sorted) return failure(sorted.error());
  Provenance made{"invert",
                  {{"method", std::string(elastography::method_name(options.method))},
                   {"long-waves", long_waves_name(options.long_waves)},
                   {"directions", options.directions == elastography::Directions::apart ? "apart" : "together"}},
                  {},
                  {},
                  {}};
  if (asked.frequency_Hz) made.options["asked-frequency_Hz"] = fmt::format("{}", *asked.frequency_Hz);
  if (asked.directions) made.options["asked-directions"] = std::to_string(*asked.directions);
  for (const char* kind : {"volumes/phase", "volumes/wave", "volumes/magnitude"}) {
    for (const Entry* entry : entries_of(patient, kind)) made.from.push_back(entry->id);
  }
  std::optional<imaging::Mask> organ;
  if (patient.find("labels/liver") != nullptr) {
    auto liver =
        patient.file_of("labels/liver").and_then([](const fs::path& file) { return imaging::read_mask_file(file); });
    if (!liver) return failure(liver.error());
    organ = std::move(liver->mask);
    made.from.emplace_back("labels/liver");
  }
  auto map = elastography::invert(sorted->frequencies, organ, options, progress.part(0.1, 1));
  if (!map) return failure(map.error());
  map->notes.insert(map->notes.begin(), sorted->notes.begin(), sorted->notes.end());
  made.notes = map->notes;
  for (std::size_t f = 0; f < map->frequencies_Hz.size(); ++f) {
    const std::string name = f == 0 ? "frequency_Hz" : fmt::format("frequency_Hz-{}", f + 1);
    made.options[name] = fmt::format("{:g}", map->frequencies_Hz[f]);
  }
  return InvertedWaves{std::move(*map), std::move(made)};
}

Result<elastography::ModulusMap> invert_waves(Case& patient, const elastography::AskedFor& asked,
                                              const elastography::InversionOptions& options, const Progress& progress) {
  auto inverted = inverted_waves(patient, asked, options, progress.part(0, 0.9));
  if (!inverted) return failure(inverted.error());
  progress.report(0.9, GLISSON_TEXT("Saving the maps"));
  if (auto saved = accept_waves(patient, *inverted); !saved) return failure(saved.error());
  return std::move(inverted->map);
}

}  // namespace glisson::casefile
