#include "hardware/energy_meter.h"

#include <fmt/format.h>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <mutex>
#include <thread>

#include "base/stopwatch.h"
#include "hardware/internal/system_file.h"

namespace glisson::hardware {
namespace {

constexpr auto sampling_interval = std::chrono::milliseconds(20);
constexpr double share_at_both_ends = 0.408;  // sqrt(1/12 + 1/12): two times within one renewal, each anywhere in it

// One source while it is read.
class SourceReader {
 public:
  explicit SourceReader(const EnergyMeter::Source& source) : source_(source) {}

  // False where the source does not answer.
  bool begin() {
    last_ = counts() ? number_in(source_.counter) : power_W();
    if (last_) distinct_.push_back(*last_);
    return last_.has_value();
  }
  bool read(double since_last_s) {
    const auto now = counts() ? number_in(source_.counter) : power_W();
    if (!now) return false;
    if (counts()) {
      double count = *now - *last_;
      if (count < 0 && source_.wraps_at > 0) count += source_.wraps_at;
      const auto volts = source_.voltage.empty() ? std::optional(1.0) : number_in(source_.voltage);
      if (!volts) return false;
      joules_ += count * source_.joules_per_count * *volts;
    } else {
      joules_ += since_last_s * (*last_ + *now) / 2;
    }
    if (*now != *last_) distinct_.push_back(*now);
    last_ = now;
    return true;
  }

  [[nodiscard]] bool counts() const { return !source_.counter.empty(); }
  [[nodiscard]] bool discharges() const {
    return source_.discharges.empty() || first_line(source_.discharges) == "Discharging";
  }
  [[nodiscard]] double joules() const { return joules_; }
  [[nodiscard]] std::size_t renewals() const { return distinct_.size() - 1; }
  [[nodiscard]] std::optional<double> uncertain_J(double seconds, const std::optional<double>& renewal_s) const {
    if (counts()) {
      const double renewed_every_s =
          renewal_s.value_or(seconds / static_cast<double>(std::max<std::size_t>(1, renewals())));
      return std::abs(joules_) / seconds * renewed_every_s * share_at_both_ends;
    }
    if (distinct_.size() < 2) return {};
    const double count = static_cast<double>(distinct_.size());
    double mean = 0, variance = 0;
    for (const double value : distinct_) mean += value / count;
    for (const double value : distinct_) variance += (value - mean) * (value - mean) / (count - 1);
    return std::sqrt(variance / count) * seconds;
  }

 private:
  [[nodiscard]] std::optional<double> power_W() const {
    if (!source_.power_uW.empty()) {
      const auto power_uW = number_in(source_.power_uW);
      // Some gauges count what leaves the battery as negative.
      return power_uW ? std::optional(std::abs(*power_uW) * 1e-6) : std::nullopt;
    }
    const auto voltage = number_in(source_.voltage);
    const auto current = number_in(source_.current);
    if (!voltage || !current) return {};
    return std::abs(*voltage * *current) * source_.watts_per_product;
  }

  const EnergyMeter::Source& source_;
  std::optional<double> last_;
  double joules_ = 0;
  std::vector<double> distinct_;  // readings that differ from the one before
};

Failure lost(const EnergyMeter& meter) {
  return failure("meter-lost", GLISSON_TEXT("The energy meter {0} stopped answering."), {meter.name});
}

EnergyUse use_of(const EnergyMeter& meter, const std::vector<SourceReader>& readers, double seconds) {
  EnergyUse use;
  use.seconds = seconds;
  std::size_t renewals = 0;
  double variance = 0;
  bool known = true;
  for (const SourceReader& reader : readers) {
    use.joules += reader.joules();
    renewals = std::max(renewals, reader.renewals());
    const auto uncertain_J = reader.uncertain_J(seconds, meter.renewal_s);
    known = known && uncertain_J.has_value();
    variance += uncertain_J.value_or(0) * uncertain_J.value_or(0);
  }
  if (known) use.uncertain_J = std::sqrt(variance);
  if (renewals > 0) use.renewed_every_s = seconds / static_cast<double>(renewals);
  return use;
}

}  // namespace

std::string to_string(MeterKind kind) {
  switch (kind) {
    case MeterKind::rapl: return "rapl";
    case MeterKind::ina: return "ina";
    case MeterKind::battery: return "battery";
  }
  return {};
}

Result<EnergyUse> energy_during(const EnergyMeter& meter, const std::function<Result<void>()>& work) {
  std::vector<SourceReader> readers(meter.sources.begin(), meter.sources.end());
  const Stopwatch watch;
  bool answering = !readers.empty();
  bool discharging = true;
  for (SourceReader& reader : readers) answering = reader.begin() && answering;
  if (!answering) return lost(meter);

  std::mutex mutex;
  std::condition_variable finished;
  bool done = false;
  double last_s = 0;
  const auto read_all = [&] {
    const double now_s = watch.seconds();
    answering = true;
    for (SourceReader& reader : readers) {
      answering = reader.read(now_s - last_s) && answering;
      discharging = discharging && reader.discharges();
    }
    if (answering) last_s = now_s;
  };
  std::thread sampler([&] {
    std::unique_lock lock(mutex);
    while (!finished.wait_for(lock, sampling_interval, [&] { return done; })) read_all();
    read_all();
  });
  const auto worked = work();
  {
    const std::scoped_lock lock(mutex);
    done = true;
  }
  finished.notify_one();
  sampler.join();
  if (!worked) return failure(worked.error());
  if (!discharging) {
    return failure(Error{"meter-charging",
                         GLISSON_TEXT("The battery stopped discharging while it was measured."),
                         {},
                         GLISSON_TEXT("Keep the machine unplugged until the measurement ends."),
                         {}});
  }
  if (!answering) return lost(meter);
  const bool all_still = std::all_of(readers.begin(), readers.end(), [](const SourceReader& reader) {
    return reader.counts() && reader.renewals() == 0;
  });
  if (all_still) {
    return failure(Error{"meter-too-coarse",
                         GLISSON_TEXT("The counter of {0} did not move in {1} s."),
                         {meter.name, fmt::format("{:.2g}", last_s)},
                         GLISSON_TEXT("Measure for longer."),
                         {}});
  }
  return use_of(meter, readers, last_s);
}

}  // namespace glisson::hardware
