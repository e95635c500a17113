#pragma once
// The matching of shapes, judged as chapter 3 of the dissertation judges it. Table 3.1 says how far the energy of few
// bits is from that of double precision. Figures 3.3, 3.6 and 3.13 show memory and arithmetic over the number of
// points, with what platforms give. Figure 3.8 shows widths of words, table 3.2 time, power and energy. Section 3.2.2
// is on the schedule.
//
// Table 3.1's measure is delta = |E - E_double| / E_double of the same field after the same passes. Nothing is done
// that the dissertation's solver does not do: no polish, no other starts. Its double precision is `trwls` in doubles,
// which is TRW-S but for the order of additions.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "registration/trwls.h"
#include "studies/dissertation/batch.h"

namespace glisson::studies {

struct MatchingOptions {
  std::vector<int> points{32, 64, 128};  // ascending; 8 to 1024
  // Poses of one shape each, two or more files; every ordered pair of poses is matched. Empty: SIMULATED livers.
  std::vector<std::vector<std::filesystem::path>> shapes;
  // Of the simulated livers: generated patients, each matched with itself bent by 40 degrees, and back.
  int livers = 4;
  std::uint64_t first_seed = 1;
  // At which point the sampling of the second surface begins: each makes another problem of a pair.
  std::vector<int> starts{0, 500};
  int passes = 20;                                   // section 3.3.5
  double scans_per_s = 20;                           // section 3.2.1
  int points_of_all_widths = 64;                     // 8 and 32 bits are plain code: judged up to so many points
  double seconds_a_timing = 0.5;                     // 0: nothing is timed
  std::optional<std::string> device = std::nullopt;  // of OpenCL, which is timed too (TrwlsOptions)
};

// One number of points and one width, over all problems.
struct MatchingQuality {
  int points = 0;
  registration::WordWidth width = registration::WordWidth::bits_16;
  std::size_t problems = 0;
  double mean_delta = 0;   // of |E / E_double - 1|: table 3.1's
  double worst_delta = 0;  // of the same
  double mean_signed = 0;  // of E / E_double - 1: negative where few bits end lower
};

// A way of solving, timed on one problem.
struct MatchingTiming {
  int points = 0;
  std::string name;
  int threads = 1;
  double seconds = 0;                 // a registration; the fastest of several
  std::optional<double> watts = {};   // above nothing: all that the meter sees
  std::optional<double> joules = {};  // a registration
};

// What a number of points asks for at the wanted rate (figures 3.3, 3.6 and 3.13). Bytes as the dissertation counts
// them: its 464 GB/s at 110 points and 66 MB at 64 follow.
struct MatchingDemand {
  int points = 0;
  double field_MB = 0;            // n (n - 1) / 2 matrices of n x n doubles
  double field_GB_per_s = 0;      // each read twice a pass
  double distances_GB_per_s = 0;  // 2 n^2 doubles a pass: the field made where it is needed
  double messages_GB_per_s = 0;   // n (n - 1) messages of n 16-bit words a pass
  double costs_G_per_s = 0;       // n^3 (n - 1) a pass
};
[[nodiscard]] MatchingDemand matching_demand(int points, int passes, double scans_per_s);

// What a platform gives, and up to how many points that serves.
struct MatchingDevice {
  std::string name;
  double memory_GB_per_s = 0;
  double costs_G_per_s = 0;
  int points_by_field = 0;     // with the field written out
  int points_by_messages = 0;  // with messages in memory
  int points_by_costs = 0;
};

struct MatchingStudy {
  MatchingOptions options;
  bool simulated = false;
  std::vector<BatchRow> rows;  // a problem each
  std::vector<MatchingQuality> quality;
  std::vector<std::vector<double>> energy_by_pass;  // of 64, 32, 16 and 8 bits on the first problem (figure 3.8)
  int points_by_pass = 0;
  std::vector<MatchingTiming> timings;
  std::vector<std::string> remarks;  // what could not be measured, and why
  std::vector<MatchingDemand> demands;
  std::vector<MatchingDevice> platforms;  // the dissertation's, and this machine where it was timed
};

// Problems that lie in out/patients whole are taken from there. Failures: "study-options" (a number out of range),
// those of reading and sampling a surface; "cancelled".
Result<MatchingStudy> run_matching(const std::filesystem::path& out, const MatchingOptions& options,
                                   const Progress& progress = {});

// problems.csv, quality.csv, timing.csv, demand.csv, summary.json and report.html with the figures.
Result<void> write_matching(const std::filesystem::path& out, const MatchingStudy& study);

[[nodiscard]] const char* name_of(registration::WordWidth width);  // "16 bits"; "64-bit floating point"

}  // namespace glisson::studies
