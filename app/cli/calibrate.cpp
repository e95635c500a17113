// glisson-cli calibrate --left ... --right ...: a stereo calibration from pictures of a board.

#include "vision/calibrate.h"

#include <fmt/format.h>

#include "command.h"
#include "eyes.h"
#include "one_of.h"
#include "shared_options.h"

namespace glisson::cli {
namespace {

using vision::Board;

struct CalibrateCommand {
  std::string out, known;
  vision::BoardPictures pictures;
};

Json difference(const vision::Camera& found, const vision::Camera& known);

Result<Outcome> run(const CalibrateCommand& command, const Progress& progress) {
  const auto fit = vision::calibrate(command.pictures, progress);
  if (!fit) return failure(fit.error());
  const auto eye = [](const vision::CameraFit& camera) {
    return Json{{"rms_px", camera.rms_px},
                {"focal_sd_px", camera.focal_sd_px},
                {"principal_point_sd_px", camera.principal_point_sd_px}};
  };
  Outcome outcome{
      {{"pairs", fit->pairs},
       {"points", fit->points},
       {"rms_px", fit->stereo_rms_px},
       {"pair_rms_px", fit->pair_rms_px},
       {"left", eye(fit->left)},
       {"right", eye(fit->right)},
       {"baseline_mm", fit->calibration.baseline_mm()},
       {"notes", fit->notes},
       {"file", command.out}},
      fmt::format("{} pairs, {} points: reprojection error {:.2f} px, baseline {:.2f} mm\n{}", fit->pairs, fit->points,
                  fit->stereo_rms_px, fit->calibration.baseline_mm(), bullet_list(fit->notes))};
  if (!command.known.empty()) {
    const auto known = vision::read_cameras(command.known);
    if (!known) return failure(known.error());
    outcome.document["known"] = {{"left", difference(fit->calibration.left, known->first)},
                                 {"right", difference(fit->calibration.right, known->second)}};
  }
  if (auto written = vision::write_stereo_calibration(command.out, fit->calibration); !written) {
    return failure(written.error());
  }
  return outcome;
}

// Found less known.
Json difference(const vision::Camera& found, const vision::Camera& known) {
  return {{"focal_x_px", found.matrix(0, 0) - known.matrix(0, 0)},
          {"focal_y_px", found.matrix(1, 1) - known.matrix(1, 1)},
          {"principal_x_px", found.matrix(0, 2) - known.matrix(0, 2)},
          {"principal_y_px", found.matrix(1, 2) - known.matrix(1, 2)},
          {"focal_percent", 100 * (found.matrix(0, 0) / known.matrix(0, 0) - 1)}};
}

}  // namespace

void add_calibrate(CLI::App& app, Action& chosen) {
  CLI::App* command = app.add_subcommand("calibrate", "Calibrate a stereo camera from pictures of a board");
  auto settings = std::make_shared<CalibrateCommand>();
  vision::BoardPictures& pictures = settings->pictures;
  command->add_option("--left", pictures.left, "The left eye's pictures: files, folders or videos")->required();
  CLI::Option* right =
      command->add_option("--right", pictures.right, "The right eye's, in the same order; none with --eyes");
  CLI::Option* eyes = add_eyes(*command, right, pictures.shared);
  command->add_option("--board", pictures.board.pattern, "chessboard, circles, or dots (circles, four of them larger)")
      ->transform(one_of(Words<Board::Pattern>{{"chessboard", Board::Pattern::chessboard},
                                               {"circles", Board::Pattern::circles},
                                               {"dots", Board::Pattern::dots}}))
      ->required();
  command->add_option("--columns", pictures.board.columns, "Inner corners, or circles, along a row")->required();
  command->add_option("--rows", pictures.board.rows, "The same down a column")->required();
  command->add_option("--spacing-mm", pictures.board.spacing_mm, "Between neighbours")->required();
  command->add_option("--every", pictures.every, "Take one picture of so many")->check(CLI::Range(1, 10000));
  command->add_option("--known", settings->known, "Folder of text files with the lenses to compare with");
  command->add_option("--out", settings->out, "The calibration (.json)")->required();
  command->callback([&chosen, settings, right, eyes] {
    check_eyes(*right, *eyes);
    chosen = [settings](const Progress& progress) { return run(*settings, progress); };
  });
}

}  // namespace glisson::cli
