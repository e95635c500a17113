#pragma once
// One run of the reader over any bytes: scan them as a file, read every volume that is found.

#include <cstddef>
#include <cstdint>

// The entry that libFuzzer calls; tests/fuzz/mutate.cpp calls it too.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
