#pragma once
// Fourier and cosine transforms of images, through FFTW.

#include <array>
#include <complex>
#include <memory>
#include <vector>

namespace glisson::elastography {

// Of a complex image of a fixed size, i running fastest. Both directions may be called on several threads at once.
class FourierTransform {
 public:
  explicit FourierTransform(const std::array<int, 3>& size);
  ~FourierTransform();
  FourierTransform(const FourierTransform&) = delete;
  FourierTransform& operator=(const FourierTransform&) = delete;

  void forward(std::vector<std::complex<float>>& image) const;
  void inverse(std::vector<std::complex<float>>& image) const;  // divided by the number of voxels

  [[nodiscard]] const std::array<int, 3>& size() const { return size_; }

 private:
  struct Plans;
  std::array<int, 3> size_;
  std::unique_ptr<Plans> plans_;
};

// The next length at or above `length` that is a product of 2, 3 and 5: fast to transform.
[[nodiscard]] int fast_length(int length);

// The cosine transform (type II) that diagonalises the Laplacian with no flow through the edges, and its inverse.
class CosineTransform {
 public:
  explicit CosineTransform(const std::array<int, 3>& size);
  ~CosineTransform();
  CosineTransform(const CosineTransform&) = delete;
  CosineTransform& operator=(const CosineTransform&) = delete;

  void forward(std::vector<float>& image) const;
  void inverse(std::vector<float>& image) const;  // scaled so that it undoes forward()

 private:
  struct Plans;
  std::array<int, 3> size_;
  std::unique_ptr<Plans> plans_;
};

}  // namespace glisson::elastography
