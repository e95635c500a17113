#include "elastography/internal/fourier.h"

#include <fftw3.h>
#include <mutex>
#include <new>

#include "base/result.h"

namespace glisson::elastography {
namespace {

// FFTW's planner keeps tables that all plans share; only executing is safe on several threads.
std::mutex& planner() {
  static std::mutex mutex;
  return mutex;
}

std::size_t voxels(const std::array<int, 3>& size) {
  return static_cast<std::size_t>(size[0]) * static_cast<std::size_t>(size[1]) * static_cast<std::size_t>(size[2]);
}

fftwf_complex* raw(std::vector<std::complex<float>>& image) { return reinterpret_cast<fftwf_complex*>(image.data()); }

// Estimated plans leave the arrays that they are made with alone; unaligned ones serve any array afterwards.
constexpr unsigned flags = FFTW_ESTIMATE | FFTW_UNALIGNED;

}  // namespace

struct FourierTransform::Plans {
  fftwf_plan forward = nullptr;
  fftwf_plan inverse = nullptr;
};

FourierTransform::FourierTransform(const std::array<int, 3>& size) : size_(size), plans_(std::make_unique<Plans>()) {
  std::vector<std::complex<float>> scratch(voxels(size));
  const std::lock_guard lock(planner());
  plans_->forward = fftwf_plan_dft_3d(size[2], size[1], size[0], raw(scratch), raw(scratch), FFTW_FORWARD, flags);
  plans_->inverse = fftwf_plan_dft_3d(size[2], size[1], size[0], raw(scratch), raw(scratch), FFTW_BACKWARD, flags);
  GLISSON_ASSERT(plans_->forward != nullptr && plans_->inverse != nullptr);
}

FourierTransform::~FourierTransform() {
  const std::lock_guard lock(planner());
  fftwf_destroy_plan(plans_->forward);
  fftwf_destroy_plan(plans_->inverse);
}

void FourierTransform::forward(std::vector<std::complex<float>>& image) const {
  GLISSON_ASSERT(image.size() == voxels(size_));
  fftwf_execute_dft(plans_->forward, raw(image), raw(image));
}

void FourierTransform::inverse(std::vector<std::complex<float>>& image) const {
  GLISSON_ASSERT(image.size() == voxels(size_));
  fftwf_execute_dft(plans_->inverse, raw(image), raw(image));
  const float scale = 1.0F / static_cast<float>(image.size());
  for (std::complex<float>& value : image) value *= scale;
}

int fast_length(int length) {
  for (int candidate = std::max(length, 1);; ++candidate) {
    int rest = candidate;
    for (const int prime : {2, 3, 5}) {
      while (rest % prime == 0) rest /= prime;
    }
    if (rest == 1) return candidate;
  }
}

struct CosineTransform::Plans {
  fftwf_plan forward = nullptr;
  fftwf_plan inverse = nullptr;
};

CosineTransform::CosineTransform(const std::array<int, 3>& size) : size_(size), plans_(std::make_unique<Plans>()) {
  std::vector<float> scratch(voxels(size));
  const std::lock_guard lock(planner());
  plans_->forward = fftwf_plan_r2r_3d(size[2], size[1], size[0], scratch.data(), scratch.data(), FFTW_REDFT10,
                                      FFTW_REDFT10, FFTW_REDFT10, flags);
  plans_->inverse = fftwf_plan_r2r_3d(size[2], size[1], size[0], scratch.data(), scratch.data(), FFTW_REDFT01,
                                      FFTW_REDFT01, FFTW_REDFT01, flags);
  GLISSON_ASSERT(plans_->forward != nullptr && plans_->inverse != nullptr);
}

CosineTransform::~CosineTransform() {
  const std::lock_guard lock(planner());
  fftwf_destroy_plan(plans_->forward);
  fftwf_destroy_plan(plans_->inverse);
}

void CosineTransform::forward(std::vector<float>& image) const {
  GLISSON_ASSERT(image.size() == voxels(size_));
  fftwf_execute_r2r(plans_->forward, image.data(), image.data());
}

void CosineTransform::inverse(std::vector<float>& image) const {
  GLISSON_ASSERT(image.size() == voxels(size_));
  fftwf_execute_r2r(plans_->inverse, image.data(), image.data());
  const float scale = 1.0F / (8.0F * static_cast<float>(image.size()));
  for (float& value : image) value *= scale;
}

}  // namespace glisson::elastography
