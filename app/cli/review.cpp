// glisson-cli review A B: two registrations of one video side by side, with a timeline.

#include "studies/review/review.h"

#include <fmt/format.h>

#include "command.h"
#include "one_of.h"

namespace glisson::cli {
namespace {

struct ReviewCommand {
  std::string a, b, out;
  studies::ReviewOptions options;
};

Result<Outcome> run(const ReviewCommand& command, const Progress& progress) {
  const auto a = registration_quality::read_quality(command.a);
  if (!a) return failure(a.error());
  const auto b = registration_quality::read_quality(command.b);
  if (!b) return failure(b.error());
  const auto review = studies::write_review(*a, *b, command.out, command.options, progress);
  if (!review) return failure(review.error());
  return Outcome{
      {{"frames", review->frames}, {"scale", {review->range[0], review->range[1]}}, {"file", review->page.string()}},
      fmt::format("{} frames of {} and {}: {}\n", review->frames, a->method, b->method, review->page.string())};
}

}  // namespace

void add_review(CLI::App& app, Action& chosen) {
  using studies::ReviewedValue;
  CLI::App* command = app.add_subcommand("review", "Show two registrations of a video side by side, with a timeline");
  auto settings = std::make_shared<ReviewCommand>();
  command->add_option("a", settings->a, "Folder that sirgn wrote")->required();
  command->add_option("b", settings->b, "Another, of the same sequence")->required();
  command->add_option("--value", settings->options.value, "What the colours show: correlation or error")
      ->transform(
          one_of(Words<ReviewedValue>{{"correlation", ReviewedValue::correlation}, {"error", ReviewedValue::error}}));
  command->add_option("--tolerance-mm", settings->options.tolerance_mm, "Triangles off by as much are grey")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  command->add_option("--out", settings->out, "Folder for review.html and its pictures")->required();
  command->callback(
      [&chosen, settings] { chosen = [settings](const Progress& progress) { return run(*settings, progress); }; });
}

}  // namespace glisson::cli
