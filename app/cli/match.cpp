// glisson-cli match SOURCE TARGET: non-rigid correspondence by geodesic distances.

#include <fmt/format.h>
#include <set>

#include "base/files.h"
#include "command.h"
#include "mended_surface.h"
#include "one_of.h"
#include "registration/geo.h"
#include "shared_options.h"

namespace glisson::cli {
namespace {

struct MatchCommand {
  std::string source, target, out;
  bool dense = false;
  registration::GeoOptions options;
};

const char* words(registration::StopReason reason) {
  switch (reason) {
    case registration::StopReason::bound_met: return "the lower bound is met";
    case registration::StopReason::energy_stopped_falling: return "the energy has stopped falling";
    case registration::StopReason::all_passes_done: return "all passes are done";
    case registration::StopReason::cancelled: return "cancelled";
    case registration::StopReason::not_run: break;
  }
  return "not run";
}

// Vertices are told as they are numbered in the files, whatever mending did to them.
std::string table_of(const MatchCommand& command, const registration::SurfaceMatch& match,
                     const geometry::Mended& source, const geometry::Mended& target) {
  std::string csv = "source_vertex,target_vertex\n";
  const auto add = [&](int from, int to) {
    csv += fmt::format("{},{}\n", source.point_from[static_cast<std::size_t>(from)],
                       target.point_from[static_cast<std::size_t>(to)]);
  };
  if (!command.dense) {
    for (std::size_t i = 0; i < match.source_points.size(); ++i) add(match.source_points[i], match.target_points[i]);
    return csv;
  }
  const std::vector<int> target_of = registration::densify(match);
  std::set<int> told;  // a vertex where sheets were parted stands for several
  for (std::size_t point = 0; point < target_of.size(); ++point) {
    if (told.insert(source.point_from[point]).second) add(static_cast<int>(point), target_of[point]);
  }
  return csv;
}

Result<Outcome> run(const MatchCommand& command, const Progress& progress) {
  if (command.options.device && (command.options.solver != registration::Solver::trwls ||
                                 command.options.width != registration::WordWidth::bits_16)) {
    return failure("not-available", GLISSON_TEXT("An OpenCL device matches by trwls in 16 bits."));
  }
  const auto source = read_mended(command.source);
  if (!source) return failure(source.error());
  const auto target = read_mended(command.target);
  if (!target) return failure(target.error());
  const auto match =
      registration::match_surfaces(source->mended.surface, target->mended.surface, command.options, progress);
  if (!match) return failure(match.error());

  const std::string csv = table_of(command, *match, source->mended, target->mended);
  if (auto written = write_text_file(command.out, csv); !written) return failure(written.error());

  const auto& solution = match->solution;
  Outcome outcome{{{"points", match->source_points.size()},
                   {"energy", solution.energy},
                   {"lower_bound", solution.lower_bound},
                   {"iterations", solution.passes.size()},
                   {"stopped", words(solution.stopped)},
                   {"solve_ms", solution.solve_ms},
                   {"orientation_kept", match->orientation_kept},
                   {"notes", Json::array()},
                   {"file", command.out}},
                  fmt::format("{} points matched in {} passes ({}), {:.1f} ms; energy {:.1f}, lower bound {:.1f}\n",
                              match->source_points.size(), solution.passes.size(), words(solution.stopped),
                              solution.solve_ms, solution.energy, solution.lower_bound)};
  tell_mending(*source, outcome);
  tell_mending(*target, outcome);
  constexpr double doubtful = 0.6;
  if (match->orientation_kept < doubtful) {
    const std::string note = fmt::format(
        "Only {:.0f} % of neighbours keep their orientation: the match may be mirrored. Try more points, or align the "
        "surfaces and use --prior positions.",
        100 * match->orientation_kept);
    outcome.document["notes"].push_back(note);
    outcome.text += note + "\n";
  }
  return outcome;
}

}  // namespace

void add_match(CLI::App& app, Action& chosen) {
  CLI::App* command = app.add_subcommand("match", "Match two surfaces by distances along them, however they bend");
  auto match = std::make_shared<MatchCommand>();
  command->add_option("source", match->source, "Surface (.ply, .obj, .off, .stl, .vtp, .vtk)")->required();
  command->add_option("target", match->target, "Surface")->required();
  command->add_option("--points", match->options.points, "Points to match")
      ->check(CLI::Range(8, 1024))
      ->capture_default_str();
  command->add_option("--solver", match->options.solver, "trwls, or trws: the slow one in double precision")
      ->transform(one_of(
          Words<registration::Solver>{{"trwls", registration::Solver::trwls}, {"trws", registration::Solver::trws}}));
  command->add_option("--bits", match->options.width, "Of the words that trwls computes in; 64: floating point")
      ->transform(one_of(Words<registration::WordWidth>{{"8", registration::WordWidth::bits_8},
                                                        {"16", registration::WordWidth::bits_16},
                                                        {"32", registration::WordWidth::bits_32},
                                                        {"64", registration::WordWidth::double_precision}}));
  command
      ->add_option("--prior", match->options.prior,
                   "none: any pose; positions: the surfaces are roughly aligned; auto: positions for a part of a whole")
      ->transform(one_of(Words<registration::Prior>{{"auto", registration::Prior::automatic},
                                                    {"none", registration::Prior::none},
                                                    {"positions", registration::Prior::positions}}));
  add_opencl(*command, match->options.device);
  command->add_flag("--dense", match->dense, "Lead every point of the source to the target");
  command->add_option("--out", match->out, "CSV file: source_vertex,target_vertex")->required();
  command->callback([&chosen, match] { chosen = [match](const Progress& progress) { return run(*match, progress); }; });
}

}  // namespace glisson::cli
