// Kernels run on whatever device there is (PoCL where no other), and what a driver refuses is said once, at the end.

#include "opencl/session.h"

#include <gmock/gmock.h>
#include <numeric>

#include "support/opencl.h"

namespace glisson::opencl {
namespace {

constexpr const char* source = R"(
__kernel void scale(__global float* x, const float factor, const int count) {
  const int i = get_global_id(0);
  if (i < count) x[i] *= factor;
}
// Each group's sum, in its own memory.
__kernel void sums(__global const float* x, __global float* sums, __local float* seen) {
  const int lane = get_local_id(0);
  seen[lane] = x[get_global_id(0)];
  for (int half_of_them = get_local_size(0) / 2; half_of_them > 0; half_of_them /= 2) {
    barrier(CLK_LOCAL_MEM_FENCE);
    if (lane < half_of_them) seen[lane] += seen[lane + half_of_them];
  }
  if (lane == 0) sums[get_group_id(0)] = seen[0];
})";

TEST(Session, RunsKernelsInTheOrderOfTheCalls) {
  GLISSON_NEEDS_OPENCL();
  auto session = Session::open(source).value();
  std::vector<float> x(256);
  std::iota(x.begin(), x.end(), 0.0F);
  const Buffer numbers = session.buffer(sizeof(float) * x.size());
  const Buffer sums = session.buffer(sizeof(float) * 4);
  session.write(numbers, x.data(), sizeof(float) * x.size());
  session.run("scale", {x.size(), 64}, {&numbers, 2.0F, std::int32_t{256}});
  session.run("sums", {x.size(), 64}, {&numbers, &sums, LocalBytes{64 * sizeof(float)}});
  std::vector<float> found(4);
  session.read(sums, found.data(), sizeof(float) * found.size());
  ASSERT_TRUE(session.finish());
  for (std::size_t group = 0; group < 4; ++group) {
    const auto first = static_cast<float>(64 * group);
    EXPECT_EQ(found[group], 2 * (64 * first + 63 * 64 / 2));  // whole numbers, exact in floats
  }
}

TEST(Session, ABufferBeginsAsZeros) {
  GLISSON_NEEDS_OPENCL();
  auto session = Session::open(source).value();
  const Buffer buffer = session.buffer(100);
  std::vector<char> bytes(100, 'x');
  session.read(buffer, bytes.data(), bytes.size());
  ASSERT_TRUE(session.finish());
  EXPECT_THAT(bytes, testing::Each('\0'));
}

TEST(Session, SaysAtTheEndWhatTheDriverRefused) {
  GLISSON_NEEDS_OPENCL();
  auto session = Session::open(source).value();
  const Buffer buffer = session.buffer(64);
  session.run("no_such_kernel", {64, 64}, {&buffer});
  session.run("scale", {16, 16}, {&buffer, 1.0F, std::int32_t{16}});
  const auto refused = session.finish();
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, "opencl-failed");
  EXPECT_THAT(refused.error().message(), testing::HasSubstr("clCreateKernel"));
  EXPECT_TRUE(session.finish()) << "said once";
}

TEST(Session, ASourceThatDoesNotCompileIsRefused) {
  GLISSON_NEEDS_OPENCL();
  const auto session = Session::open("__kernel void broken( {");
  ASSERT_FALSE(session);
  EXPECT_EQ(session.error().code, "opencl-source");
}

TEST(Session, AnUnknownDeviceIsRefusedWithThoseThereAre) {
  GLISSON_NEEDS_OPENCL();
  const auto session = Session::open(source, "no such device");
  ASSERT_FALSE(session);
  EXPECT_EQ(session.error().code, "opencl-no-device");
  EXPECT_THAT(session.error().advice(), testing::HasSubstr(devices().front()));
}

TEST(Session, WithoutOpenClTheReasonIsSaid) {
  if (built()) GTEST_SKIP() << "built with OpenCL";
  EXPECT_EQ(Session::open(source).error().code, "opencl-not-built");
  EXPECT_THAT(devices(), testing::IsEmpty());
}

}  // namespace
}  // namespace glisson::opencl
