// glisson-cli shapes complete | draw: what a shape model ("study shapes") says of a liver that is seen in part, and
// livers drawn from it.

#include <fmt/format.h>
#include <algorithm>
#include <filesystem>

#include "command.h"
#include "geometry/mesh_file.h"
#include "imaging/volume_file.h"
#include "one_of.h"
#include "shapes/completion.h"
#include "shapes/liver_outline.h"
#include "shapes/model_file.h"
#include "studies/dissertation/drawn_cohort.h"

namespace glisson::cli {
namespace {

struct CompleteCommand {
  std::string model, liver, out;
  bool spacing_is_true = false;
};

struct DrawCommand {
  std::string model, out;
  studies::DrawnCohortOptions options;
};

// What is seen: open where the image, or a flat end, cuts the liver off.
Result<geometry::Surface> seen_liver(const CompleteCommand& command) {
  const std::filesystem::path file = command.liver;
  if (!imaging::has_volume_file_name(file)) {
    return geometry::read_surface(file).map([](const geometry::Surface& s) { return shapes::without_flat_ends(s); });
  }
  const auto labels = imaging::read_labels_file(file);
  if (!labels) return failure(labels.error());
  shapes::OutlineOptions options;
  options.believe_unit_spacing = command.spacing_is_true;
  auto outline = shapes::outline_of(*labels, options);
  if (!outline) {
    Error error = outline.error();
    return failure(std::move(error).in_file(file));
  }
  return std::move(outline->surface);
}

Result<Outcome> run_complete(const CompleteCommand& command, const Progress& progress) {
  const auto model = shapes::read_model(command.model);
  if (!model) return failure(model.error());
  const auto seen = seen_liver(command);
  if (!seen) return failure(seen.error());
  const auto completed = shapes::complete(*model, *seen, {}, progress);
  const auto inside = completed.and_then([&](const shapes::Completion& of) {
    return shapes::check_not_mirrored(*model, *seen, of.fit).and_then([&] {
      return shapes::check_inside(*model, of.fit);
    });
  });
  if (!inside) {
    Error error = inside.error();
    return failure(std::move(error).in_file(command.liver));
  }
  if (auto written = geometry::write_surface(command.out, completed->surface); !written) {
    return failure(written.error());
  }
  const auto& sd_mm = geometry::find_field(completed->surface.point_fields, "sd_mm")->values;
  const auto& is_seen = geometry::find_field(completed->surface.point_fields, "seen")->values;
  double sum = 0, largest = 0, points = 0;
  for (std::size_t p = 0; p < sd_mm.size(); ++p) {
    if (is_seen[p] != 0) continue;
    sum += sd_mm[p];
    largest = std::max(largest, sd_mm[p]);
    ++points;
  }
  const double mean_mm = points > 0 ? sum / points : 0, ml = geometry::volume_mm3(completed->surface) / 1000;
  return Outcome{
      Json{{"volume_ml", ml},
           {"volume_sd_ml", completed->fit.volume_sd_ml},
           {"seen_fraction", completed->seen_fraction},
           {"residual_mm", completed->fit.residual_mm},
           {"unseen_mean_sd_mm", mean_mm},
           {"unseen_max_sd_mm", largest},
           {"livers_of_the_model", model->livers},
           {"file", command.out}},
      fmt::format("{:.0f} % of the surface was seen; the rest is the model's, by a standard deviation of {:.1f} mm on "
                  "average ({:.1f} at most)\nVolume {:.0f} ml, standard deviation {:.0f} ml\n",
                  100 * completed->seen_fraction, mean_mm, largest, ml, completed->fit.volume_sd_ml)};
}

Result<Outcome> run_draw(const DrawCommand& command, const Progress& progress) {
  const auto cohort = studies::draw_cohort(command.model, command.out, command.options, progress);
  if (!cohort) return failure(cohort.error());
  Outcome outcome{Json{{"livers", cohort->livers},
                       {"failed", cohort->failed},
                       {"reused", cohort->reused},
                       {"simulated", true},
                       {"mean_volume_ml", cohort->mean_volume_ml},
                       {"sd_volume_ml", cohort->sd_volume_ml},
                       {"cpu_seconds_a_liver", cohort->cpu_seconds_a_liver},
                       {"folder", command.out}},
                  fmt::format("{} SIMULATED livers ({} from an earlier run), {} failed; volume {:.0f} ml (sd {:.0f}); "
                              "{:.1f} s of processor a liver\n",
                              cohort->livers, cohort->reused, cohort->failed, cohort->mean_volume_ml,
                              cohort->sd_volume_ml, cohort->cpu_seconds_a_liver)};
  return outcome;
}

void add_complete(CLI::App& shapes, Action& chosen) {
  CLI::App* command =
      shapes.add_subcommand("complete", "Complete a liver that is cut off, with a standard deviation at each point");
  auto options = std::make_shared<CompleteCommand>();
  command->add_option("model", options->model, "model.vtp of \"study shapes\"")->required();
  command->add_option("liver", options->liver, "Labels, or a surface: open, or with a flat end where it was cut off")
      ->required();
  command->add_option("--out", options->out, "Surface (.vtp) with the point arrays sd_mm and seen")->required();
  command->add_flag("--spacing-is-true", options->spacing_is_true,
                    "Believe labels of 1 x 1 x 1 mm, which are refused as having lost their spacing");
  command->callback([&chosen, options] {
    chosen = [options](const Progress& progress) { return run_complete(*options, progress); };
  });
}

void add_draw(CLI::App& shapes, Action& chosen) {
  CLI::App* command = shapes.add_subcommand(
      "draw",
      "SIMULATED livers drawn from a model, meshed, with vessels and stiffness by section 4.3; run again, it goes on");
  auto options = std::make_shared<DrawCommand>();
  command->add_option("model", options->model, "model.vtp of \"study shapes\"")->required();
  command->add_option("--out", options->out, "Folder for the livers and their table")->required();
  command->add_option("--count", options->options.count, "How many")
      ->capture_default_str()
      ->check(CLI::Range(1, 1000000));
  command->add_option("--seed", options->options.seed, "The same seed gives the same livers")->capture_default_str();
  using Vessels = studies::DrawnCohortOptions::Vessels;
  command
      ->add_option("--vessels", options->options.vessels,
                   "carried: those of the generated liver by whose points the model describes livers, carried along by "
                   "each shape's warp, as ID_trees.json; none")
      ->transform(one_of(Words<Vessels>{{"carried", Vessels::carried}, {"none", Vessels::none}}));
  command
      ->add_option("--reference-spacing-mm", options->options.reference_spacing_mm,
                   "As study shapes was given it for the model")
      ->capture_default_str()
      ->check(CLI::Range(4.0, 20.0));
  command->add_option("--target-cells", options->options.target_cells, "Tetrahedra of each")
      ->capture_default_str()
      ->check(CLI::Range(200, 1000000));
  command->callback(
      [&chosen, options] { chosen = [options](const Progress& progress) { return run_draw(*options, progress); }; });
}

}  // namespace

void add_shapes(CLI::App& app, Action& chosen) {
  CLI::App* shapes = app.add_subcommand("shapes", "What a model of real livers' shapes says: completion, drawn livers");
  shapes->require_subcommand(1);
  add_complete(*shapes, chosen);
  add_draw(*shapes, chosen);
  for (CLI::App* subcommand : shapes->get_subcommands({})) subcommand->fallthrough();
}

}  // namespace glisson::cli
