// Files that anybody may have made: changed at random places, each is read or refused, and what is read is sound.

#include <gtest/gtest.h>
#include <cmath>
#include <random>

#include "base/csv.h"
#include "base/files.h"
#include "hardware/plan.h"
#include "hardware/power_trace.h"
#include "platform_fixtures.h"

namespace glisson::hardware {
namespace {

// The text with a few of its bytes changed, lost or doubled; sometimes cut off.
std::string spoiled(std::string text, std::mt19937& random) {
  const auto any = [&random](std::size_t below) {
    return std::uniform_int_distribution<std::size_t>(0, below - 1)(random);
  };
  const char likely[] = {'-', '0', '9', 'e', '.', '"', '{', '}', '[', ']', ',', ':', '\n', '\0', '\xFF'};
  for (std::size_t change = any(8) + 1; change > 0 && !text.empty(); --change) {
    const std::size_t place = any(text.size());
    switch (any(4)) {
      case 0: text[place] = likely[any(sizeof likely)]; break;
      case 1: text.erase(place, any(40)); break;
      case 2: text.insert(place, text.substr(place, any(40))); break;
      default:
        if (any(10) == 0) text.resize(place);
    }
  }
  return text;
}

TEST(HostileFiles, SpoiledDeviceTablesAreReadSoundOrRefused) {
  const std::string sound = *read_text_file(test::devices_file());
  const ConvergenceCurve curve = test::shipped_curve();
  PlanRequest request;
  request.liver_volume_cm3 = 1200;
  request.accuracy_mm = 3;
  std::mt19937 random(1);
  const TemporaryFolder folder;
  int read_count = 0;
  for (int i = 0; i < 400; ++i) {
    ASSERT_TRUE(write_text_file(folder.path() / "d.json", spoiled(sound, random)));
    const auto devices = read_devices(folder.path() / "d.json");
    if (!devices) {
      EXPECT_FALSE(devices.error().message().empty());
      continue;
    }
    ++read_count;
    for (const Device& device : *devices) EXPECT_TRUE(check(device));
    EXPECT_TRUE(plan(request, *devices, curve));
  }
  // Most changes hit a note or a space and leave a table that means the same.
  EXPECT_GT(read_count, 0);
}

TEST(HostileFiles, SpoiledCurvesAreReadSoundOrRefused) {
  const std::string sound = *read_text_file(test::devices_file().parent_path() / "convergence.json");
  std::mt19937 random(2);
  const TemporaryFolder folder;
  for (int i = 0; i < 400; ++i) {
    ASSERT_TRUE(write_text_file(folder.path() / "c.json", spoiled(sound, random)));
    const auto curve = read_convergence_curve(folder.path() / "c.json");
    if (!curve) continue;
    for (const double accuracy_mm : {0.01, 1.0, 5.0, 100.0}) {
      const auto resolution_mm3 = resolution_for_accuracy_mm3(*curve, accuracy_mm);
      EXPECT_TRUE(!resolution_mm3 || *resolution_mm3 > 0);
    }
  }
}

TEST(HostileFiles, SpoiledRecordingsAreTakenApartOrRefused) {
  std::string sound = "t,w\n";
  for (int i = 0; i < 300; ++i) sound += std::to_string(i * 0.05) + (i % 100 < 50 ? ",3.0\n" : ",9.5\n");
  std::mt19937 random(3);
  const TemporaryFolder folder;
  for (int i = 0; i < 400; ++i) {
    ASSERT_TRUE(write_text_file(folder.path() / "t.csv", spoiled(sound, random)));
    const auto trace = read_power_trace(folder.path() / "t.csv", {"1", 1, {{"2", 1, 1, {}}}, {}});
    if (!trace) continue;
    const auto runs = find_runs(*trace);
    if (!runs) continue;
    for (const TraceRun& run : runs->runs) {
      EXPECT_GE(run.seconds(), 0);
      EXPECT_TRUE(std::isfinite(run.mean_W) && std::isfinite(run.joules_above_idle));
    }
  }
}

}  // namespace
}  // namespace glisson::hardware
