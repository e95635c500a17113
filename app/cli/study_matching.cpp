// glisson-cli study matching [POSE,POSE,... ...] --out DIR: chapter 3 of the dissertation, tables and figures.

#include <fmt/format.h>
#include <filesystem>
#include <sstream>

#include "shared_options.h"
#include "studies/dissertation/matching_study.h"
#include "study_commands.h"

namespace glisson::cli {
namespace {

struct StudyMatchingCommand {
  std::vector<std::string> shapes;  // files of one shape's poses each, with commas between
  std::string out;
  studies::MatchingOptions study;
};

std::vector<std::vector<std::filesystem::path>> poses_of(const std::vector<std::string>& shapes) {
  std::vector<std::vector<std::filesystem::path>> poses;
  for (const std::string& shape : shapes) {
    std::istringstream files(shape);
    poses.emplace_back();
    for (std::string file; std::getline(files, file, ',');) poses.back().emplace_back(file);
  }
  return poses;
}

Result<Outcome> run(const StudyMatchingCommand& options, const Progress& progress) {
  studies::MatchingOptions asked = options.study;
  asked.shapes = poses_of(options.shapes);
  const auto study = studies::run_matching(options.out, asked, progress);
  if (!study) return failure(study.error());
  if (auto written = studies::write_matching(options.out, *study); !written) return failure(written.error());
  auto document = read_json_file(std::filesystem::path(options.out) / "summary.json");
  if (!document) return failure(document.error());
  Outcome outcome{std::move(*document), {}};
  outcome.document["report"] = (std::filesystem::path(options.out) / "report.html").string();
  for (const studies::MatchingQuality& of : study->quality) {
    outcome.text += fmt::format(
        "{:4} points, {:8}: {:.2f} % from double precision on average ({:+.2f} % with its sign), "
        "{:.1f} % at most, {} problems\n",
        of.points, studies::name_of(of.width), 100 * of.mean_delta, 100 * of.mean_signed, 100 * of.worst_delta,
        of.problems);
  }
  for (const studies::MatchingTiming& timing : study->timings) {
    outcome.text += fmt::format("{:4} points, {} thread(s): {:9.1f} ms{}  {}\n", timing.points, timing.threads,
                                1e3 * timing.seconds,
                                timing.joules ? fmt::format(", {:.2f} J", *timing.joules) : std::string(), timing.name);
  }
  for (const studies::MatchingDevice& of : study->platforms) {
    outcome.text += fmt::format(
        "{}: {:g} scans a second of {} points by arithmetic, {} by messages in memory, {} with the field in memory\n",
        of.name, asked.scans_per_s, of.points_by_costs, of.points_by_messages, of.points_by_field);
  }
  for (const std::string& remark : study->remarks) outcome.text += "Note: " + remark + "\n";
  return outcome;
}

}  // namespace

void add_study_matching(CLI::App& study, Action& chosen) {
  CLI::App* command = study.add_subcommand(
      "matching", "The matching of shapes as chapter 3 judges it: bits, memory, time, energy; run again, it goes on");
  auto options = std::make_shared<StudyMatchingCommand>();
  studies::MatchingOptions& asked = options->study;
  command->add_option("shapes", options->shapes,
                      "Files of one shape's poses, with commas between; several shapes. None: simulated livers, bent");
  command->add_option("--out", options->out, "Folder for the problems, the tables and the report")->required();
  command->add_option("--points", asked.points, "Numbers of points, ascending")->delimiter(',')->capture_default_str();
  command->add_option("--starts", asked.starts, "Points at which the second surface's sampling begins")
      ->delimiter(',')
      ->capture_default_str();
  command->add_option("--livers", asked.livers, "How many simulated livers")->capture_default_str();
  command->add_option("--seed", asked.first_seed, "Of the first of them")->capture_default_str();
  command->add_option("--passes", asked.passes, "Of each solution")->capture_default_str();
  command->add_option("--scans-per-s", asked.scans_per_s, "What memory and arithmetic are counted for")
      ->capture_default_str();
  command->add_option("--seconds-a-timing", asked.seconds_a_timing, "0: nothing is timed")->capture_default_str();
  add_opencl(*command, asked.device);
  command->callback(
      [&chosen, options] { chosen = [options](const Progress& progress) { return run(*options, progress); }; });
}

}  // namespace glisson::cli
