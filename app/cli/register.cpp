// glisson-cli register SOURCE TARGET: the source moved onto the target, its points in their order.

#include "registration/register.h"

#include <fmt/format.h>
#include <chrono>

#include "command.h"
#include "geometry/mesh_file.h"
#include "one_of.h"

namespace glisson::cli {
namespace {

struct RegisterCommand {
  std::string source, target, out;
  registration::RegisterOptions options;
};

Result<Outcome> run(const RegisterCommand& command, const Progress& progress) {
  const auto start = std::chrono::steady_clock::now();
  const auto source = geometry::read_surface(command.source);
  if (!source) return failure(source.error());
  const auto target = geometry::read_surface(command.target);
  if (!target) return failure(target.error());
  const auto registered = registration::register_surfaces(*source, *target, command.options, progress);
  if (!registered) return failure(registered.error());
  if (auto written = geometry::write_surface(command.out, registered->surface); !written) {
    return failure(written.error());
  }
  const double time_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return Outcome{{{"rms_mm", registered->rms_mm},
                  {"iterations", registered->iterations},
                  {"time_s", time_s},
                  {"orientation_kept", registered->orientation_kept},
                  {"file", command.out}},
                 fmt::format("{:.2f} mm root mean square to the target after {} iterations, {:.1f} s\n",
                             registered->rms_mm, registered->iterations, time_s)};
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
