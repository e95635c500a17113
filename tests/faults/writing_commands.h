#pragma once
// Every command that writes, in a room small enough that each can be run some thousand times.

#include <filesystem>
#include <string>
#include <vector>

namespace glisson::test {

struct WritingCommand {
  std::string name;
  std::vector<std::string> words;  // "@x" is x in the room that the command works in
  bool resumes = false;            // what it has done stays, each file whole, and the next run goes on from there
  bool replaces = false;           // files of before, outside of a case
};

std::vector<WritingCommand> writing_commands();

// What they start from: a case with a model, vessels, territories and a plan, results, a video, experiments.
void prepare_room(const std::filesystem::path& room);

}  // namespace glisson::test
