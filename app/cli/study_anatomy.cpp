// glisson-cli study anatomy --seed N --out DIR: a simulated patient's liver, vessels and lesions, with their truth.

#include <fmt/format.h>
#include <array>
#include <charconv>
#include <filesystem>

#include "anatomy/write_patient.h"
#include "study_commands.h"

namespace glisson::cli {
namespace {

struct StudyAnatomyCommand {
  std::string out, lobes = "usual";
  std::vector<std::string> tumours, cysts;
  int patients = 1;
  anatomy::PatientOptions patient;
  anatomy::WriteOptions write;
};

// "30", "30@7" (in segment VII) or "30@-60,-150,-270" (there).
Result<anatomy::LesionWish> lesion_wish(anatomy::LesionKind kind, const std::string& text) {
  const auto refused = [&] {
    return failure("anatomy-lesion-unreadable",
                   GLISSON_TEXT("The lesion {0} is not understood: give its diameter in mm, as 30, and if you like its "
                                "segment, 30@7, or its place, 30@x,y,z."),
                   {text});
  };
  std::vector<double> numbers;
  const char* at = text.data();
  const char* const end = at + text.size();
  while (at < end) {
    double value = 0;
    const auto [next, problem] = std::from_chars(at, end, value);
    if (problem != std::errc()) return refused();
    numbers.push_back(value);
    if (next != end && *next != (numbers.size() == 1 ? '@' : ',')) return refused();
    at = next == end ? end : next + 1;
  }
  anatomy::LesionWish wish;
  wish.kind = kind;
  if (numbers.empty() || !(numbers[0] >= 2 && numbers[0] <= 150)) return refused();
  wish.diameter_mm = numbers[0];
  if (numbers.size() == 4) {
    wish.position_mm = Eigen::Vector3d(numbers[1], numbers[2], numbers[3]);
  } else if (numbers.size() == 2 && numbers[1] >= 1 && numbers[1] <= 8) {
    wish.segment = static_cast<int>(numbers[1]);
  } else if (numbers.size() != 1) {
    return refused();
  }
  return wish;
}

Result<anatomy::PatientOptions> patient_options(const StudyAnatomyCommand& options) {
  anatomy::PatientOptions patient = options.patient;
  for (const auto& [kind, texts] : {std::pair{anatomy::LesionKind::tumour, &options.tumours},
                                    std::pair{anatomy::LesionKind::cyst, &options.cysts}}) {
    for (const std::string& text : *texts) {
      auto wish = lesion_wish(kind, text);
      if (!wish) return failure(std::move(wish.error()));
      patient.lesions.push_back(*wish);
    }
  }
  constexpr std::array<const char*, 4> names = {"usual", "no-left-lobe", "small-right-lobe", "turned"};
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (options.lobes == names[i]) patient.lobes = static_cast<anatomy::LobeVariant>(i);
  }
  return patient;
}

std::string described(const anatomy::Patient& patient) {
  std::string text =
      fmt::format("Seed {}: {:.0f} ml; segments I to VIII", patient.options.seed, patient.options.volume_ml);
  for (int segment = 1; segment <= 8; ++segment) {
    text += fmt::format(" {:.0f}", patient.segments->volume_ml(segment));
  }
  return text + fmt::format(" ml; {} lesions\n", patient.lesions.size());
}

Result<Outcome> run(const StudyAnatomyCommand& options, const Progress& progress) {
  auto patient_wish = patient_options(options);
  if (!patient_wish) return failure(std::move(patient_wish.error()));
  Outcome outcome;
  Json list = Json::array();
  const std::filesystem::path out = options.out;
  for (int i = 0; i < options.patients; ++i) {
    const auto patient = anatomy::make_patient(*patient_wish, progress);
    if (!patient) return failure(patient.error());
    const std::filesystem::path folder = options.patients == 1 ? out : out / fmt::format("seed-{}", patient_wish->seed);
    if (auto written = anatomy::write_patient(folder, *patient, options.write); !written)
      return failure(written.error());
    auto truth = read_json_file(folder / "truth.json");
    if (!truth) return failure(std::move(truth.error()));
    (*truth)["folder"] = folder.string();
    list.push_back(std::move(*truth));
    outcome.text += described(*patient);
    ++patient_wish->seed;
  }
  outcome.document = options.patients == 1 ? list.front() : Json{{"patients", list}};
  return outcome;
}

}  // namespace

void add_study_anatomy(CLI::App& study, Action& chosen) {
  CLI::App* command = study.add_subcommand(
      "anatomy",
      "A simulated patient: liver, segments, vessel trees and lesions, with their truth; nobody's real anatomy");
  auto options = std::make_shared<StudyAnatomyCommand>();
  anatomy::PatientOptions& patient = options->patient;
  command->add_option("--out", options->out, "Folder for surfaces, labels, trees and truth.json")->required();
  command->add_option("--seed", patient.seed, "The same seed gives the same patient")->capture_default_str();
  command->add_option("--patients", options->patients, "So many, with seeds from --seed on, a folder each")
      ->capture_default_str()
      ->check(CLI::Range(1, 10000));
  command->add_option("--volume-ml", patient.volume_ml, "Of the liver, 800 to 2800; drawn from the seed if not given");
  command->add_option("--lobes", options->lobes, "usual, no-left-lobe, small-right-lobe or turned")
      ->capture_default_str()
      ->check(CLI::IsMember({"usual", "no-left-lobe", "small-right-lobe", "turned"}));
  command->add_option("--tumour", options->tumours,
                      "DIAMETER, DIAMETER@SEGMENT or DIAMETER@X,Y,Z in mm; may be repeated");
  command->add_option("--cyst", options->cysts, "The same for a cyst");
  command->add_option("--fat", patient.tissue.fat_fraction, "Fat fraction of the tissue, 0 to 0.5")
      ->capture_default_str();
  command->add_option("--fibrosis", patient.tissue.fibrosis_stage, "Stage 0 to 4")->capture_default_str();
  command->add_option("--label-spacing-mm", options->write.label_spacing_mm, "Of the labels' voxels")
      ->capture_default_str()
      ->check(CLI::Range(0.5, 10.0));
  command->callback(
      [&chosen, options] { chosen = [options](const Progress& progress) { return run(*options, progress); }; });
}

}  // namespace glisson::cli
