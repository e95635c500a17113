#pragma once
// An example of a sequence for SIRGn, to try the judging of registrations without a video at hand. It is a generated
// patient's liver, breathing and pressed by a tool, as a laparoscope would see it. SIMULATED, and its file says so.

#include <cstdint>
#include <filesystem>

#include "base/progress.h"
#include "base/result.h"

namespace glisson::studies {

struct ExampleSequenceOptions {
  int frames = 40;
  int landmarks = 70;
  int step_px = 10;  // between the clouds' points: about 2,000 a frame
  double cloud_noise_mm = 0.3;
  double tracking_noise_mm = 0.3;
  double lost_share = 0.03;     // of the sightings
  double outlier_share = 0.03;  // of the landmarks, which jump half way
  double fault_mm = 20;         // of the registration that it gives, at its worst
  double fault_radius_mm = 32;
  std::uint64_t patient = 1;  // seed of the generated liver; 1 is the demo patient's
  std::uint64_t seed = 2026;  // of noise
  bool stereo = false;        // the video itself too, as a stereo laparoscope would take it
};

// Writes folder/sequence.json, the frames' pictures and clouds, tracks.csv and model.ply. For the method "given" it
// writes the clouds as registered, with one known fault that comes and goes. Where that is stands in truth.json, with
// how the patient lies in the camera's frame at rest. Places inside the liver, which no picture shows, are in
// hidden.csv (patient coordinates). Where each is in each frame is in hidden-truth.csv (camera). With `stereo`,
// video/left and video/right hold both eyes' pictures and video/camera.json their calibration: a video to begin with.
// The folder must not exist or be empty ("sequence-folder-not-empty"). Other failures: those of writing files;
// "cancelled". After a failure the folder is gone, or as empty as it was. Returns sequence.json.
Result<std::filesystem::path> write_example_sequence(const std::filesystem::path& folder,
                                                     const ExampleSequenceOptions& options = {},
                                                     const Progress& progress = {});

}  // namespace glisson::studies
