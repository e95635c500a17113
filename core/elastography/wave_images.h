#pragma once
// The phase images of an elastography scan, sorted. They go by frequency of the vibration, by direction of the motion
// that was encoded, and by instant ("offset") within one period.

#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "base/sentence.h"
#include "imaging/image.h"
#include "imaging/study.h"

namespace glisson::elastography {

// One volume of phase, or of a vendor's wave images, with what is known of it.
struct PhaseImage {
  imaging::Volume volume;  // rad, or in arbitrary units
  imaging::MotionEncoding motion;
  int series = 0;       // which series it came from; volumes of one series stand in their order
  bool wrapped = true;  // false: a vendor's waves, unwrapped already
};

// What a person says where the headers say nothing. What the headers say is believed, except that the frequency given
// here stands against theirs where one frequency was measured.
struct AskedFor {
  std::optional<double> frequency_Hz = {};
  std::optional<int> directions = {};  // how many there are in each series, one after the other
};

// Of one frequency. phase_rad[direction][instant][voxel]; the instants are evenly spread over one period and every
// direction has as many.
struct WaveImages {
  double frequency_Hz = 0;
  imaging::Grid grid;
  std::vector<std::vector<std::vector<float>>> phase_rad;
  std::vector<Eigen::Vector3d> along;  // of each direction: unit vector, patient LPS; empty where it is not known
  std::vector<double> slice_times_s;   // when each slice was acquired (imaging/study.h); empty: all at once
  std::vector<float> magnitude;        // mean magnitude, one a voxel; empty where there is none
  bool wrapped = true;                 // as PhaseImage says
};

struct SortedWaves {
  std::vector<WaveImages> frequencies;  // ascending
  std::vector<Sentence> notes;          // what was assumed
};

// Where the header gives neither direction nor instant, a series is taken to run through all instants of one direction,
// then of the next. Wrapped phase without a unit is scaled so that its full range is one turn, and a note says so.
//
// Fails with waves-none or waves-grids-differ. Fails with waves-no-frequency, and asks for it. Fails with
// waves-no-directions where a series has more volumes than one direction is ever measured at, and asks how many. Fails
// with waves-uneven where directions have different numbers of instants. Fails with waves-too-few-offsets below four,
// which leave nothing to tell noise from.
Result<SortedWaves> sort_waves(std::vector<PhaseImage> images, const AskedFor& asked = {});

}  // namespace glisson::elastography
