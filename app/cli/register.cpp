// glisson-cli register SOURCE TARGET: the source moved onto the target, its points in their order.

#include "registration/register.h"

#include <fmt/format.h>
#include <chrono>

#include "command.h"
#include "geometry/mesh_file.h"
#include "mended_surface.h"
#include "one_of.h"

namespace glisson::cli {
namespace {

struct RegisterCommand {
  std::string source, target, out;
  registration::RegisterOptions options;
};

Result<Outcome> run(const RegisterCommand& command, const Progress& progress) {
  const auto start = std::chrono::steady_clock::now();
  // Distances along a surface need one piece.
  const auto pieces =
      command.options.method == registration::Method::geo ? geometry::Pieces::one : geometry::Pieces::several;
  const auto source = read_mended(command.source, pieces);
  if (!source) return failure(source.error());
  const auto target = read_mended(command.target, pieces);
  if (!target) return failure(target.error());
  const auto registered =
      registration::register_surfaces(source->mended.surface, target->mended.surface, command.options, progress);
  if (!registered) return failure(registered.error());
  const geometry::Surface moved = geometry::carried_back(source->given, source->mended, registered->surface.points_mm);
  if (auto written = geometry::write_surface(command.out, moved); !written) {
    return failure(written.error());
  }
  const double time_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  Outcome outcome{{{"rms_mm", registered->rms_mm},
                   {"iterations", registered->iterations},
                   {"time_s", time_s},
                   {"orientation_kept", registered->orientation_kept},
                   {"file", command.out}},
                  fmt::format("{:.2f} mm root mean square to the target after {} iterations, {:.1f} s\n",
                              registered->rms_mm, registered->iterations, time_s)};
  outcome.document["notes"] = Json::array();
  tell_mending(*source, outcome);
  tell_mending(*target, outcome);
  return outcome;
}

}  // namespace

void add_register(CLI::App& app, Action& chosen) {
  CLI::App* command = app.add_subcommand("register", "Move one surface onto another, as it bends");
  auto settings = std::make_shared<RegisterCommand>();
  command->add_option("source", settings->source, "Surface to move")->required();
  command->add_option("target", settings->target, "Surface to move it to; may be a part of the source")->required();
  command
      ->add_option("--method", settings->options.method,
                   "icp: nearest points, from where the surfaces lie; geo: distances along the surfaces, from anywhere")
      ->transform(
          one_of(Words<registration::Method>{{"icp", registration::Method::icp}, {"geo", registration::Method::geo}}))
      ->required();
  command->add_option("--out", settings->out, "The source, moved (.ply, .obj, .stl, .vtp)")->required();
  command->callback(
      [&chosen, settings] { chosen = [settings](const Progress& progress) { return run(*settings, progress); }; });
}

}  // namespace glisson::cli
