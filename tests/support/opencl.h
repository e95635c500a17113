#pragma once
// Skips a test where OpenCL has no device, and says so.

#include <gtest/gtest.h>

#include "opencl/session.h"

#define GLISSON_NEEDS_OPENCL()                                                                               \
  if (!glisson::opencl::built()) GTEST_SKIP() << "built without OpenCL: configure with -DGLISSON_OPENCL=ON"; \
  if (glisson::opencl::devices().empty()) GTEST_SKIP() << "no OpenCL device: install pocl-opencl-icd"
