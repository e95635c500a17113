#pragma once
// What a fuzzer's program brings to the driver: readers, each with a name, good files and one run over any bytes.
//
// A program is a file that defines targets(), and a line glisson_fuzz(...) in CMakeLists.txt.

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace glisson::fuzz {

struct Target {
  std::string name;  // of the reader: "ply", "scenario"
  // Good files, one of each way in which the reader takes what it reads. Called in an empty folder of their own.
  std::function<std::vector<std::string>(const std::filesystem::path& folder)> seeds;
  // Reads these bytes, as a file in the folder where the reader wants one, and holds it to its promises. A refusal is
  // an answer; what is not: a crash, an exception, a broken promise, more than 10 s, more memory than the driver
  // allows.
  std::function<void(const std::string& bytes, const std::filesystem::path& folder)> run;
};

// Defined by each program.
std::vector<Target> targets();

// Ends the run, saying what was promised.
void promise(bool kept, const char* what);

// The bytes as a file of that name in the folder, in place of what was there.
std::filesystem::path file_of(const std::string& bytes, const std::filesystem::path& folder, const std::string& name);

}  // namespace glisson::fuzz
