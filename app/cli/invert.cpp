// glisson-cli invert CASE: wave images to a map of the shear stiffness, which the case then uses.

#include <fmt/format.h>

#include "casefile/waves.h"
#include "command.h"
#include "shared_options.h"

namespace glisson::cli {
namespace {

using elastography::InversionMethod;
using elastography::LongWaves;

struct InvertCommand {
  std::string case_folder;
  elastography::AskedFor asked;
  std::string method = "direct";
  std::string long_waves = "high-pass";
  bool directional = false;
};

Outcome describe_invert(const elastography::ModulusMap& map) {
  Json frequencies = map.frequencies_Hz;
  Outcome outcome{{{"method", elastography::method_name(map.method)},
                   {"frequency_Hz", map.frequencies_Hz.front()},
                   {"frequencies_Hz", std::move(frequencies)},
                   {"mean_kPa", map.mean_kPa},
                   {"confident_fraction", map.confident_fraction},
                   {"confident_voxels", map.confident.voxels},
                   {"wavelength_mm", map.typical_wavelength_mm},
                   {"notes", messages(map.notes)}},
                  {}};
  outcome.text = fmt::format(
      "Shear stiffness {:.2f} kPa on average over {} confident voxels ({:.0f} % of the region), middle half {:.2f} to "
      "{:.2f} kPa; typical wavelength {:.0f} mm\n",
      map.mean_kPa, map.confident.voxels, 100 * map.confident_fraction, map.confident.percentile_25,
      map.confident.percentile_75, map.typical_wavelength_mm);
  outcome.document["sd_kPa"] = map.confident.sd;
  outcome.document["median_kPa"] = map.confident.median;
  if (map.storage_kPa) {
    outcome.document["storage_kPa"] = map.mean_storage_kPa;
    outcome.document["loss_kPa"] = map.mean_loss_kPa;
    outcome.text += fmt::format("Storage {:.2f} kPa, loss {:.2f} kPa\n", map.mean_storage_kPa, map.mean_loss_kPa);
  }
  outcome.text += bullet_list(messages(map.notes));
  return outcome;
}

Result<Outcome> invert(const InvertCommand& options, const Progress& progress) {
  auto patient = casefile::Case::open(options.case_folder);
  if (!patient) return failure(patient.error());
  elastography::InversionOptions inversion;
  inversion.method = options.method == "lfe" ? InversionMethod::local_frequency : InversionMethod::direct;
  if (options.long_waves == "curl") inversion.long_waves = LongWaves::curl;
  if (options.long_waves == "keep") inversion.long_waves = LongWaves::keep;
  if (options.directional) inversion.directions = elastography::Directions::apart;
  return casefile::invert_waves(*patient, options.asked, inversion, progress).map(describe_invert);
}

}  // namespace

void add_invert(CLI::App& app, Action& chosen) {
  CLI::App* command = app.add_subcommand(
      "invert", "Compute the shear stiffness from the MRE waves; it takes the place of the case's stiffness map");
  auto options = std::make_shared<InvertCommand>();
  command->add_option("case", options->case_folder, "The case")->required();
  command->add_option("--frequency-Hz", options->asked.frequency_Hz, "Of the vibration, where the headers say nothing")
      ->check(CLI::Range(1.0, 2000.0));
  command
      ->add_option("--directions", options->asked.directions,
                   "How many motion directions a phase series holds, where the headers say nothing")
      ->check(CLI::Range(1, 100));
  command->add_option("--method", options->method, "direct: complex modulus; lfe: local frequency estimation")
      ->capture_default_str()
      ->check(CLI::IsMember({"direct", "lfe"}));
  command->add_option("--long-waves", options->long_waves, "How compression and bulk motion are taken off")
      ->capture_default_str()
      ->check(CLI::IsMember({"high-pass", "curl", "keep"}));
  command->add_flag("--directional", options->directional,
                    "See waves that run in different directions each by itself (direct; lfe always does)");
  command->callback(
      [&chosen, options] { chosen = [options](const Progress& progress) { return invert(*options, progress); }; });
}

}  // namespace glisson::cli
