#include "casefile/import.h"

#include <fmt/format.h>
#include <algorithm>
#include <set>
#include <utility>

#include "base/text.h"
#include "casefile/internal/motion_options.h"
#include "casefile/internal/new_case.h"
#include "imaging/read_series.h"
#include "imaging/stiffness_map.h"
#include "imaging/volume_file.h"

namespace glisson::casefile {
namespace {

constexpr const char* simulated_origin = GLISSON_TEXT("SIMULATED, not measured");

using imaging::Role;
using imaging::Series;
using imaging::Study;

struct Chosen {
  Role role;
  std::string id;
  const Series* series;
  std::optional<int> number_before = {};  // of the last volume of that role, where several series hold them
};

enum class Anatomy { needed, is_there };
Result<std::vector<Chosen>> choose(const Study& study, const ImportChoice& choice, Anatomy anatomy);
Result<std::vector<WantedLabels>> choose_labels(const Study& study, const ImportChoice& choice, const Series* anatomy);
Result<void> check_belonging(const Case& patient, const Study& study, const std::vector<SeriesRole>& roles,
                             Replacing replacing);
Result<imaging::Grid> anatomy_grid(const Case& patient);
Result<void> import_series(Case& patient, const Chosen& chosen, std::vector<ImportedVolume>& imported,
                           const Progress& progress);
std::string origin_of(const Study& study);
Result<const Series*> series_for(const Study& study, Role role, const std::optional<std::string>& uid,
                                 const std::string& option);
std::string id_of(Role role);

Result<Imported> import_series_of(Case& patient, const Study& study, const std::vector<Chosen>& chosen,
                                  const std::vector<WantedLabels>& labels, const Progress& progress) {
  Imported imported;
  const std::string origin = origin_of(study);
  if (!origin.empty()) {
    if (auto marked = patient.set_origin(origin); !marked) return failure(marked.error());
  }
  const Progress of_volumes = labels.empty() ? progress : progress.part(0, 0.7);
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    const double count = static_cast<double>(chosen.size());
    const Progress part = of_volumes.part(static_cast<double>(i) / count, static_cast<double>(i + 1) / count);
    if (auto done = import_series(patient, chosen[i], imported.volumes, part); !done) return failure(done.error());
  }
  if (!labels.empty()) {
    const auto grid = anatomy_grid(patient);
    if (!grid) return failure(grid.error());
    auto structures = import_labels(patient, labels, *grid, progress.part(0.7, 1));
    if (!structures) return failure(structures.error());
    imported.structures = *std::move(structures);
  }
  // What is simulated stays so, until another anatomy comes.
  const bool new_anatomy =
      std::any_of(chosen.begin(), chosen.end(), [](const Chosen& one) { return one.role == Role::anatomy; });
  if (new_anatomy) {
    if (auto saved = patient.set_origin(origin); !saved) return failure(saved.error());
  }
  return imported;
}

// All of it or nothing.
Result<Imported> import_chosen(Case& patient, const Study& study, const std::vector<Chosen>& chosen,
                               const std::vector<WantedLabels>& labels, const Progress& progress) {
  Imported imported;
  return patient
      .together([&] {
        return import_series_of(patient, study, chosen, labels, progress).map([&](Imported all) {
          imported = std::move(all);
        });
      })
      .map([&] { return std::move(imported); });
}

}  // namespace

Result<Imported> import_study(Case& patient, const Study& study, const ImportChoice& choice, const Progress& progress,
                              Replacing replacing) {
  const bool has_anatomy = patient.find("volumes/anatomy") != nullptr;
  const auto chosen = choose(study, choice, has_anatomy ? Anatomy::is_there : Anatomy::needed);
  if (!chosen) return failure(chosen.error());
  const Series* anatomy = nullptr;
  std::vector<SeriesRole> roles;
  for (const Chosen& one : *chosen) {
    roles.push_back({one.series->uid, one.role});
    if (one.role == Role::anatomy) anatomy = one.series;
  }
  const auto labels = choose_labels(study, choice, anatomy);
  if (!labels) return failure(labels.error());
  for (const WantedLabels& wanted : *labels) roles.push_back({wanted.series->uid, Role::segmentation});
  if (auto belongs = check_belonging(patient, study, roles, replacing); !belongs) return failure(belongs.error());
  return import_chosen(patient, study, *chosen, *labels, progress);
}

Result<Imported> import_series_as(Case& patient, const Study& study, const std::vector<SeriesRole>& roles,
                                  const Progress& progress, Replacing replacing) {
  std::vector<Chosen> chosen;
  std::vector<WantedLabels> labels;
  int phase_volumes = 0;
  const auto phases =
      std::count_if(roles.begin(), roles.end(), [](const SeriesRole& one) { return one.role == Role::mre_phase; });
  for (const SeriesRole& wanted : roles) {
    if (wanted.role == Role::other) continue;
    const auto series = series_for(study, wanted.role, wanted.uid, "");
    if (!series) return failure(series.error());
    if (wanted.role == Role::segmentation) {
      labels.push_back({*series, wanted.label_names});
      continue;
    }
    const bool twice =
        std::any_of(chosen.begin(), chosen.end(), [&](const Chosen& one) { return one.role == wanted.role; });
    if (twice && wanted.role != Role::mre_phase) {
      return failure(Error{"import-role-twice",
                           GLISSON_TEXT("Two series are to be the {0}: {1} is the second."),
                           {std::string(imaging::role_name(wanted.role)), (*series)->description},
                           GLISSON_TEXT("Leave one of them out, or give it another role."),
                           {}});
    }
    Chosen one{wanted.role, id_of(wanted.role), *series};
    if (wanted.role == Role::mre_phase && phases > 1)
      one.number_before = std::exchange(phase_volumes, phase_volumes + (*series)->volumes);
    chosen.push_back(std::move(one));
  }
  if (chosen.empty() && labels.empty()) {
    return failure("import-nothing", GLISSON_TEXT("No series is chosen: give at least one of them a role."));
  }
  if (auto belongs = check_belonging(patient, study, roles, replacing); !belongs) return failure(belongs.error());
  // The anatomy first: segmentations are carried to its grid. Magnitude images serve where there is none.
  std::stable_partition(chosen.begin(), chosen.end(), [](const Chosen& one) { return one.role == Role::anatomy; });
  const auto magnitude =
      std::find_if(chosen.begin(), chosen.end(), [](const Chosen& one) { return one.role == Role::mre_magnitude; });
  if (magnitude != chosen.end() && chosen.front().role != Role::anatomy && patient.find("volumes/anatomy") == nullptr) {
    chosen.insert(chosen.begin(), {Role::anatomy, "volumes/anatomy", magnitude->series});
  }
  return import_chosen(patient, study, chosen, labels, progress);
}

Result<NewCase> new_case_from(const Study& study, const std::filesystem::path& folder, const ImportChoice& choice,
                              const Progress& progress) {
  Imported imported;
  auto patient = make_case(folder, [&](Case& made) {
    return import_study(made, study, choice, progress).map([&](Imported all) { imported = std::move(all); });
  });
  return patient.map([&](Case made) { return NewCase{std::move(made), std::move(imported)}; });
}

namespace {

std::string id_of(Role role) {
  switch (role) {
    case Role::mre_magnitude: return "volumes/magnitude";
    case Role::mre_phase: return "volumes/phase";
    case Role::mre_wave: return "volumes/wave";
    case Role::mre_stiffness: return "volumes/stiffness";
    case Role::mre_confidence: return "volumes/confidence";
    default: return "volumes/anatomy";
  }
}

std::string list_of(const std::vector<const Series*>& candidates) {
  std::string list;
  for (const Series* series : candidates) {
    list += fmt::format("\n  {}  {} ({} x {} x {})", series->uid, series->description, series->grid.size[0],
                        series->grid.size[1], series->grid.size[2]);
  }
  return list;
}

// The series for a role: the one with that uid, else the only candidate. nullptr where there is none.
Result<const Series*> series_for(const Study& study, Role role, const std::optional<std::string>& uid,
                                 const std::string& option) {
  std::vector<const Series*> candidates;
  for (const Series& series : study.series) {
    if (uid && series.uid == *uid) return &series;
    if (series.role == role) candidates.push_back(&series);
  }
  if (uid) {
    return failure(Error{"import-unknown-uid",
                         GLISSON_TEXT("The study has no series {0}."),
                         {*uid},
                         GLISSON_TEXT("glisson-cli scan lists them."),
                         {}});
  }
  if (candidates.size() > 1) {
    return failure(
        Error{"import-ambiguous",
              GLISSON_TEXT("{0} series could be the {1}:{2}"),
              {std::to_string(candidates.size()), std::string(imaging::role_name(role)), list_of(candidates), option},
              GLISSON_TEXT("Name one with {3} UID."),
              {}});
  }
  return candidates.empty() ? nullptr : candidates.front();
}

// The second and later phase series that were named; all of them are then numbered through.
Result<void> add_further_phases(const Study& study, const ImportChoice& choice, std::vector<Chosen>& chosen) {
  if (choice.phase_uids.size() < 2) return {};
  const auto first =
      std::find_if(chosen.begin(), chosen.end(), [](const Chosen& one) { return one.role == Role::mre_phase; });
  GLISSON_ASSERT(first != chosen.end());
  first->number_before = 0;
  int volumes = first->series->volumes;
  for (std::size_t n = 1; n < choice.phase_uids.size(); ++n) {
    const auto series = series_for(study, Role::mre_phase, choice.phase_uids[n], "--phase");
    if (!series) return failure(series.error());
    chosen.push_back({Role::mre_phase, "volumes/phase", *series, volumes});
    volumes += (*series)->volumes;
  }
  return {};
}

Result<std::vector<Chosen>> choose(const Study& study, const ImportChoice& choice, Anatomy anatomy) {
  struct Wanted {
    Role role;
    const char* id;
    const std::optional<std::string>& uid;
    const char* option;
  };
  const std::optional<std::string> unnamed;
  std::optional<std::string> one_phase_uid;
  if (!choice.phase_uids.empty()) one_phase_uid = choice.phase_uids.front();
  const Wanted wanted[] = {
      {Role::anatomy, "volumes/anatomy", choice.anatomy_uid, "--anatomy"},
      {Role::mre_stiffness, "volumes/stiffness", choice.stiffness_uid, "--stiffness"},
      {Role::mre_magnitude, "volumes/magnitude", choice.magnitude_uid, "--magnitude"},
      {Role::mre_phase, "volumes/phase", one_phase_uid, "--phase"},
      {Role::mre_wave, "volumes/wave", unnamed, ""},
      {Role::mre_confidence, "volumes/confidence", unnamed, ""},
  };
  std::vector<Chosen> chosen;
  for (const Wanted& want : wanted) {
    const auto series = series_for(study, want.role, want.uid, want.option);
    // Of waves and confidence, which no option names, several are no reason to stop: none is taken.
    if (!series && *want.option == '\0') continue;
    if (!series) return failure(series.error());
    if (*series) chosen.push_back({want.role, want.id, *series});
  }
  if (auto more = add_further_phases(study, choice, chosen); !more) return failure(more.error());
  const auto magnitude =
      std::find_if(chosen.begin(), chosen.end(), [](const Chosen& one) { return one.role == Role::mre_magnitude; });
  if (anatomy == Anatomy::is_there) return chosen;
  if (magnitude != chosen.end() && chosen.front().role != Role::anatomy) {
    chosen.insert(chosen.begin(), {Role::anatomy, "volumes/anatomy", magnitude->series});
  }
  if (chosen.empty() || chosen.front().role != Role::anatomy) {
    // One unlabelled volume is the anatomy; of several, the person must say which.
    std::vector<const Series*> images;
    for (const Series& series : study.series) {
      if (series.role == Role::other) images.push_back(&series);
    }
    if (images.size() == 1) {
      chosen.insert(chosen.begin(), {Role::anatomy, "volumes/anatomy", images.front()});
    } else {
      return failure(Error{"import-no-anatomy",
                           GLISSON_TEXT("No series is recognised as the anatomy.{0}"),
                           {list_of(images)},
                           images.empty() ? GLISSON_TEXT("glisson-cli scan says what is there, and what was skipped.")
                                          : GLISSON_TEXT("Name one with --anatomy UID."),
                           {}});
    }
  }
  return chosen;
}

// Without a word of the person: every DICOM SEG, and the label maps that were drawn on the anatomy; where none comes
// with them, those of the study.
Result<std::vector<WantedLabels>> choose_labels(const Study& study, const ImportChoice& choice, const Series* anatomy) {
  std::vector<WantedLabels> labels;
  for (const std::string& uid : choice.label_uids) {
    const auto series = series_for(study, Role::segmentation, uid, "");
    if (!series) return failure(series.error());
    labels.push_back({*series, choice.label_names});
  }
  if (!labels.empty()) return labels;
  std::set<std::size_t> maps;
  if (anatomy != nullptr) {
    for (const std::size_t map : label_maps_on(study, *anatomy)) maps.insert(map);
  }
  for (std::size_t k = 0; k < study.series.size(); ++k) {
    const Series& series = study.series[k];
    if (series.role != Role::segmentation) continue;
    if (is_label_map(series) && anatomy != nullptr && !maps.contains(k)) continue;
    labels.push_back({&series, is_label_map(series) ? choice.label_names : std::map<int, std::string>{}});
  }
  return labels;
}

Result<void> check_belonging(const Case& patient, const Study& study, const std::vector<SeriesRole>& roles,
                             Replacing replacing) {
  if (replacing == Replacing::wanted) return {};
  const auto doubts = doubts_of_belonging(patient, study, roles);
  const char* hint = GLISSON_TEXT("Make a case of their own, or take them all the same with --replace.");
  if (!doubts.empty()) {
    std::string said;
    for (const std::string& doubt : messages(doubts)) said += " " + doubt;
    return failure(Error{"import-not-this-patient",
                         GLISSON_TEXT("These images may not belong to {0}.{1}"),
                         {patient.folder().string(), said},
                         hint,
                         patient.folder()});
  }
  if (would_replace_anatomy(patient, roles)) {
    return failure(Error{"import-would-replace",
                         GLISSON_TEXT("{0} has an anatomy already, which these images would replace."),
                         {patient.folder().string()},
                         hint,
                         patient.folder()});
  }
  return {};
}

Result<imaging::Grid> anatomy_grid(const Case& patient) {
  const auto file = patient.file_of("volumes/anatomy");
  if (!file) return failure(file.error());
  return imaging::read_volume_file_header(*file).map([](const auto& header) { return header.grid; });
}

// With whose images they are, by which later ones are judged.
Provenance made_of_anatomy(const Series& series) {
  Provenance made = made_from(series);
  made.options.merge(whose(series));
  return made;
}

// The magnitude images of all directions and instants show the same anatomy; their mean shows it with the least noise.
Result<void> import_mean_as_anatomy(Case& patient, const Chosen& chosen, std::vector<ImportedVolume>& imported,
                                    const Progress& progress) {
  const Series& series = *chosen.series;
  imaging::Volume mean;
  for (int index = 0; index < series.volumes; ++index) {
    if (progress.cancelled()) return cancelled();
    const double count = series.volumes;
    auto volume = imaging::read_series(series, index, progress.part(index / count, (index + 1) / count));
    if (!volume) return failure(volume.error());
    if (index == 0) mean = imaging::Volume{{volume->grid, std::vector<float>(volume->values.size(), 0)}, volume->unit};
    for (std::size_t v = 0; v < mean.values.size(); ++v) {
      mean.values[v] += volume->values[v] / static_cast<float>(count);
    }
  }
  Provenance made = made_of_anatomy(series);
  made.notes.push_back({GLISSON_TEXT("The mean of the elastography's magnitude images serves as the anatomy."), {}});
  imported.push_back({chosen.id, chosen.role, mean.grid, messages(made.notes)});
  return patient.add(chosen.id, ".nrrd", std::move(made),
                     [&](const auto& file) { return imaging::write_volume_file(file, mean); });
}

Result<void> import_series(Case& patient, const Chosen& chosen, std::vector<ImportedVolume>& imported,
                           const Progress& progress) {
  const Series& series = *chosen.series;
  if (chosen.role == Role::anatomy && series.role == Role::mre_magnitude) {
    return import_mean_as_anatomy(patient, chosen, imported, progress);
  }
  const Provenance source = chosen.role == Role::anatomy ? made_of_anatomy(series) : made_from(series);
  for (int index = 0; index < series.volumes; ++index) {
    if (progress.cancelled()) return cancelled();
    const double count = series.volumes;
    auto volume = imaging::read_series(series, index, progress.part(index / count, (index + 1) / count));
    if (!volume) return failure(volume.error());

    Provenance made = source;
    if (series.volumes > 1) made.options["volume"] = std::to_string(index + 1);
    if (chosen.role == Role::mre_stiffness) {
      auto stiffness = imaging::stiffness_in_kPa(std::move(*volume), series.unit_evidence);
      if (!stiffness) return failure(stiffness.error());
      made.notes.push_back({stiffness->evidence, {}});
      volume = std::move(stiffness->shear_kPa);
    }
    if (!series.motion.empty()) put_motion(series.motion[static_cast<std::size_t>(index)], made.options);
    const bool alone = series.volumes == 1 && !chosen.number_before;
    const std::string id =
        alone ? chosen.id : fmt::format("{}-{:02}", chosen.id, chosen.number_before.value_or(0) + index + 1);
    auto added =
        patient.add(id, ".nrrd", made, [&](const auto& file) { return imaging::write_volume_file(file, *volume); });
    if (!added) return added;
    imported.push_back({id, chosen.role, volume->grid, messages(made.notes)});
  }
  return {};
}

// The demo patient's series say in their descriptions what they are; a case made from them says it too.
std::string origin_of(const Study& study) {
  for (const Series& series : study.series) {
    if (in_lower_case(series.description).find("simulated") != std::string::npos) return simulated_origin;
  }
  return {};
}

}  // namespace
}  // namespace glisson::casefile
