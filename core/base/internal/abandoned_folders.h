#pragma once
// What programs that were killed left among the temporary files.

#include <filesystem>

namespace glisson {

// Removes the folders of TemporaryFolder in `place` whose program was killed. What a living one works in stays, and so
// does what belongs to another person. The first TemporaryFolder of a program does this.
void remove_abandoned_folders(const std::filesystem::path& place);

}  // namespace glisson
