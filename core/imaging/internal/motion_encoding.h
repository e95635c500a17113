#pragma once
// What the header of an elastography image says of the motion that it was encoded for. The
// outcome is Series::motion.

#include <string>
#include <vector>

#include "imaging/internal/dicom_image.h"
#include "imaging/study.h"

namespace glisson::imaging {

// Read from
// - ImageComments of the Charité's sequence for Siemens scanners, "MRE: fI[0]dI[2]az[180]po[88]tI[7]VP[50000]". These
//   are the index of the frequency, of the direction and of the time step. Then come the direction's azimuth and polar
//   angle in degrees, and the period of the vibration in us. The angles' x runs against the patient's. That was found
//   by comparing all three directions of a measured series with its ImageOrientationPatient. They match to the rounding
//   of the angles;
// - "60 Hz" in a description, a protocol's name or the comments;
// - TemporalPositionIndex, as the offset;
// - VelocityEncodingDirection of an enhanced image's frames, which are read as classic images are otherwise, comments
//   of the frame before those of the file.
[[nodiscard]] MotionEncoding motion_encoding_of(const DicomImage& image, const Picture& picture);

// Counts the directions of a series whose header gives them as vectors alone. A series of one direction is left as it
// is: others may hold the rest.
void number_directions(std::vector<MotionEncoding>& motions);

// The parts of such text, for tests.
[[nodiscard]] MotionEncoding motion_in_comments(const std::string& comments);
[[nodiscard]] std::optional<double> frequency_in_text_Hz(const std::string& text);

}  // namespace glisson::imaging
