#pragma once
// What this machine says about the energy it uses: processor counters (RAPL), current sensors on the board (INA), the
// battery's gauge. Where it says nothing, the survey says why.
//
// RAPL: Intel's Software Developer's Manual, volume 3B, "Platform specific power management support". Each package has
// a counter, renewed about every millisecond, which contains the cores ("core", "uncore"). The memory ("dram") has one
// of its own beside it. Linux shows them in /sys/class/powercap (kernel documentation, power/powercap) and, since
// CVE-2020-8694, to root alone. Batteries: kernel documentation, ABI/testing/sysfs-class-power.

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "hardware/sentence.h"

namespace glisson::hardware {

enum class MeterKind {
  rapl,     // energy counters of the processor packages and their memory: no disk, no screen
  ina,      // INA219/226/3221 and kin: Jetson boards and their like; the board's input where it is labelled
  battery,  // the gauge of a discharging battery: the whole machine, but renewed only every few seconds
};
std::string to_string(MeterKind kind);  // "rapl", "ina", "battery"

// One or more files to be read together.
struct EnergyMeter {
  MeterKind kind = MeterKind::rapl;
  std::string name;  // "RAPL (packages: 1, memories: 1)"
  struct Source {
    std::filesystem::path counter;     // of energy, or of charge where voltage is named too
    double joules_per_count = 0;       // times the voltage, where there is one; negative for what is left in a battery
    double wraps_at = 0;               // in counts; 0: never
    std::filesystem::path power_uW;    // or a power
    std::filesystem::path voltage;     // or a voltage and a current, in the unit below
    std::filesystem::path current;     //
    double watts_per_product = 0;      // of voltage and current as the files hold them
    std::filesystem::path discharges;  // a battery's state, which must stay "Discharging"; empty for what has none
  };
  std::vector<Source> sources;      // their powers add up
  double shortest_useful_s = 60;    // below this a reading says nothing: the time in which it is renewed several times
  std::optional<double> renewal_s;  // how often it is renewed, where its maker says so
};

struct MeterSurvey {
  std::vector<EnergyMeter> meters;  // best first: a counter before sensors, sensors before the battery's gauge
  std::vector<Sentence> missing;    // a sentence for each that is not there or may not be read, with what to do
};

// `system_folder` is where the kernel shows its devices; another folder in tests.
[[nodiscard]] MeterSurvey survey_meters(const std::filesystem::path& system_folder = "/sys");

struct EnergyUse {
  double seconds = 0;
  double joules = 0;
  // One standard deviation of what the meter resolves; nothing of how true its readings are, which nothing here can
  // tell. Absent where the meter gave a single reading.
  //   a counter   when it was last renewed is anywhere within a renewal, at either end: power x renewal x sqrt(1/6)
  //   a power     the scatter of its different readings over the square root of their number, times the time
  std::optional<double> uncertain_J;
  std::optional<double> renewed_every_s;  // on average while it was read; absent where it never changed
  [[nodiscard]] double mean_W() const { return joules / seconds; }
};

// What the machine used while `work` ran on this thread. The meter is read every 20 ms on another thread, so that a
// counter may wrap as often as it likes. Fails with "meter-lost" where the meter stops answering, and with
// "meter-charging" where a battery stops discharging. Fails with "meter-too-coarse" where a counter did not move, and
// as the work itself does.
Result<EnergyUse> energy_during(const EnergyMeter& meter, const std::function<Result<void>()>& work);

}  // namespace glisson::hardware
