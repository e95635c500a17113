#pragma once
// What this machine says about the energy it uses: processor counters (RAPL), current sensors on the board (INA), the
// battery's gauge. Where it says nothing, the survey says why.

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "base/result.h"
#include "hardware/sentence.h"

namespace glisson::hardware {

enum class MeterKind {
  rapl,     // energy counters of the processor packages: no memory on some machines, no disk, no screen
  ina,      // INA219/226/3221 and kin: Jetson boards and their like; the board's input where it is labelled
  battery,  // the gauge of a discharging battery: the whole machine, but renewed only every few seconds
};

// One or more files to be read together.
struct EnergyMeter {
  MeterKind kind = MeterKind::rapl;
  std::string name;  // "RAPL, 1 package"
  struct Source {
    std::filesystem::path energy_uJ;  // a counter (rapl)
    double wraps_at_uJ = 0;
    std::filesystem::path power_uW;  // or a power
    std::filesystem::path voltage;   // or a voltage and a current, in the unit below
    std::filesystem::path current;
    double watts_per_product = 0;  // of voltage and current as the files hold them
  };
  std::vector<Source> sources;  // their powers add up

  // Below this, a reading of the meter says nothing: the time in which it is renewed several times.
  [[nodiscard]] double shortest_useful_s() const;
};

struct MeterSurvey {
  std::vector<EnergyMeter> meters;  // best first: a counter before sensors, sensors before the battery's gauge
  std::vector<Sentence> missing;    // a sentence for each that is not there or may not be read
};

// `system_folder` is where the kernel shows its devices; another folder in tests.
[[nodiscard]] MeterSurvey survey_meters(const std::filesystem::path& system_folder = "/sys");

struct EnergyUse {
  double seconds = 0;
  double joules = 0;
  [[nodiscard]] double mean_W() const { return joules / seconds; }
};

// What the machine used while `work` ran on this thread. Counters are read before and after (and wrap at most once,
// about a minute at full power); powers are sampled every 20 ms on another thread.
// Refused: a meter that stops answering ("meter-lost"); a failure of the work itself.
Result<EnergyUse> energy_during(const EnergyMeter& meter, const std::function<Result<void>()>& work);

}  // namespace glisson::hardware
