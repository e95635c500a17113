#pragma once
// The checkout that is tested and the folder that it was built in. One file is compiled with their paths, so that every
// other test compiles to the same bytes wherever the checkout lies, and the compiler's cache serves them all.

#include <filesystem>

namespace glisson::test {

std::filesystem::path source_folder();
std::filesystem::path build_folder();

}  // namespace glisson::test
