#pragma once
// The inverse warps S^-1(.; t) of all frames at once: of a registration, and of the benchmark that it is judged by.

#include <Eigen/Core>
#include <Eigen/LU>
#include <optional>
#include <vector>

#include "registration_quality/sirgn.h"

namespace glisson::registration_quality {

// Thin-plate splines that share their centres: displacement(p) = affine + sum of w_i |p - c_i| for each frame.
class SharedCentreWarps {
 public:
  // displacements_mm: centres x (3 frames): what each centre's displacement is in each frame.
  SharedCentreWarps(std::vector<Eigen::Vector3d> centres_mm, const Eigen::MatrixXd& displacements_mm,
                    double stiffness_mm);

  // Displacements at some points in all frames: points x (3 frames).
  [[nodiscard]] Eigen::MatrixXd displacements_mm(const std::vector<Eigen::Vector3d>& points_mm) const;

 private:
  [[nodiscard]] Eigen::MatrixXd kernel_rows(const std::vector<Eigen::Vector3d>& points_mm) const;

  std::vector<Eigen::Vector3d> centres_mm_;
  Eigen::Vector3d center_mm_;
  double size_mm_;
  Eigen::MatrixXd coefficients_;  // (centres + 4) x (3 frames)
};

// At most `count` of the candidates, which lie as far from one another as can be: their places in the list.
[[nodiscard]] std::vector<std::size_t> spread(const std::vector<Eigen::Vector3d>& candidates, int count);

// S^-1 of a sequence's benchmark, and the frames that it holds; nothing where the sequence has none.
struct BenchmarkWarps {
  SharedCentreWarps warps;
  std::vector<bool> holds;
};
[[nodiscard]] std::optional<BenchmarkWarps> benchmark_warps(const RegisteredSequence& sequence,
                                                            const SirgnOptions& options);

}  // namespace glisson::registration_quality
