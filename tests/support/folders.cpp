#include "support/folders.h"

namespace glisson::test {

std::filesystem::path source_folder() { return GLISSON_SOURCE_DIR; }

std::filesystem::path build_folder() { return GLISSON_BINARY_DIR; }

}  // namespace glisson::test
