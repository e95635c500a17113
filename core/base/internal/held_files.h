#pragma once
// Which files and folders a living program works in: it holds a lock on each, and the lock ends with the program.

#include <filesystem>

namespace glisson {

// Takes the file for this process as long as the descriptor is open; false while another holds it. Where a file system
// knows no locks, each writer takes the file for its own.
bool locked(int descriptor);

// False where another file has the name by now, or none.
bool stands_at(int descriptor, const std::filesystem::path& path);

// Removes what is open there if it is this person's and nobody living holds it. Where a file system knows no locks,
// nobody can tell, and it stays.
void remove_if_abandoned(int descriptor, const std::filesystem::path& path);

}  // namespace glisson
