#pragma once
// A recording of power as it lies in a file, before anybody says which column is what. It is the table of an
// oscilloscope, a logger or a battery tester, or the log of a power analyser.
//
// The analyser's log is that of SPEC's PTDaemon, one reading a line, -2 where there was none:
//   Time,02-16-2022 08:59:37.009,Watts,2.304000,Volts,250.920000,Amps,0.027860,PF,0.329600,Mark,...

#include <filesystem>

#include "base/csv.h"
#include "base/result.h"
#include "hardware/power_trace.h"

namespace glisson::hardware {

// Columns of numbers. Of an analyser's log: "Time" in seconds from its first line, and its quantities by their names.
// Refused: as read_csv refuses, and a log whose first line has no time ("recording-without-time").
Result<CsvTable> read_recording(const std::filesystem::path& file);

// Which column is the time and which the power, as far as names, units and numbers tell. What it says of a file that
// nobody labelled is a proposal.
//   time    a name such as "time", "t (ms)"; else the first column that only grows; else none: rows follow each other
//           every second
//   power   a name with "power", "watt" or the unit W or mW; else the column that is the product of two others, as
//           voltage and current; else the first that is not the time. Where its mean is negative, its sign is turned.
[[nodiscard]] TraceFormat guessed_format(const CsvTable& table);

}  // namespace glisson::hardware
