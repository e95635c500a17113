// Which places of a registered video are not to be trusted, without any truth to compare with?
//
// A patch of tissue breathes through 24 frames. Its registration is perfect but for a disc of 25 mm, where it slips now
// and then by up to 12 mm. SIRGn sees landmarks alone, and is asked where the slip is.

#include <cmath>

#include "or_stop.h"
#include "registration_quality/sirgn.h"

using namespace glisson;

const Eigen::Vector3d slipping_mm(30, 30, 0);
bool in_disc(const Eigen::Vector3d& at_mm) { return (at_mm - slipping_mm).head<2>().norm() < 25; }

// What the registration says of a place that is really at rest_mm.
Eigen::Vector3d registered(const Eigen::Vector3d& rest_mm, int frame) {
  const double slip_mm = frame % 5 < 2 ? 12.0 * ((frame * 7) % 4) / 3 : 0;
  return in_disc(rest_mm) ? Eigen::Vector3d(rest_mm + Eigen::Vector3d(slip_mm, 0, 0)) : rest_mm;
}

int main() {
  registration_quality::RegisteredSequence sequence;
  for (int frame = 0; frame < 24; ++frame) {
    const Eigen::Vector3d breath_mm(0, 0, 8 * std::sin(0.7 * frame));
    auto& seen = sequence.frames.emplace_back();
    for (int i = -60; i <= 60; i += 4)
      for (int j = -60; j <= 60; j += 4) {
        const Eigen::Vector3d rest_mm(i, j, 0.002 * (i * i + j * j));
        seen.cloud_mm.emplace_back(rest_mm + breath_mm);
        seen.registered_mm.push_back(registered(rest_mm, frame));
        if (i % 12 || j % 12) continue;  // every third point is also a landmark
        if (frame == 0) sequence.landmarks.push_back({fmt::format("{},{}", i, j), {}});
        const auto place = static_cast<std::size_t>((i + 60) / 12 * 11 + (j + 60) / 12);
        sequence.landmarks[place].positions_mm.emplace_back(rest_mm + breath_mm);
      }
  }
  const auto judged = or_stop(registration_quality::sirgn(sequence));
  double worst_doubt_mm = 0, sum[2] = {0, 0};
  int triangles[2] = {0, 0};
  Eigen::Vector3d worst_at_mm(0, 0, 0);
  for (std::size_t k = 0; k < judged.mesh.triangles.size(); ++k) {
    Eigen::Vector3d middle_mm(0, 0, 0);
    for (const int corner : judged.mesh.triangles[k]) middle_mm += judged.mesh.points_mm[std::size_t(corner)] / 3;
    sum[in_disc(middle_mm)] += judged.correlation[k];
    ++triangles[in_disc(middle_mm)];
    if (judged.doubt_mm[k] <= worst_doubt_mm) continue;
    worst_doubt_mm = judged.doubt_mm[k];
    worst_at_mm = middle_mm;
  }
  fmt::print("SIRGn is {:.2f} on average where the registration slips, {:.2f} elsewhere.\n", sum[1] / triangles[1],
             sum[0] / triangles[0]);
  fmt::print("Most doubtful is the place {:.0f} mm from the middle of the slip.\n",
             (worst_at_mm - slipping_mm).head<2>().norm());
}
