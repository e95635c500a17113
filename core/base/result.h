#pragma once
// What can go wrong outside us, said once, where it happened.
//
// A function that depends on anything from outside returns Result<T>: the value, or an Error that a person can act on.
// From outside come files, headers, a person's numbers, and solvers that may not converge. Broken invariants of our own
// are not Errors: they assert (GLISSON_ASSERT).

#include <filesystem>
#include <string>
#include <tl/expected.hpp>
#include <utility>
#include <vector>

namespace glisson {

// One failure. `text` says what is wrong and where, `hint` what to do. Both are English sentences with the placeholders
// {0}, {1}, ... for `arguments`. So the desktop can translate the sentence and keep the values. `code` is stable and
// meant for scripts ("dicom-truncated").
struct Error {
  std::string code;
  std::string text;
  std::vector<std::string> arguments;
  std::string hint;
  std::filesystem::path file;

  // The sentence with its arguments filled in; the same for the hint.
  [[nodiscard]] std::string message() const;
  [[nodiscard]] std::string advice() const;

  [[nodiscard]] Error with_hint(std::string sentence) && {
    hint = std::move(sentence);
    return std::move(*this);
  }
  [[nodiscard]] Error in_file(std::filesystem::path path) && {
    file = std::move(path);
    return std::move(*this);
  }
};

template <typename T>
using Result = tl::expected<T, Error>;

using Failure = tl::unexpected<Error>;

// Marks a sentence as one that a person reads, for the translation tools (lupdate) to find.
#define GLISSON_TEXT(sentence) sentence

// return failure("mesh-empty", GLISSON_TEXT("The structure {0} holds no voxels."), {name});
[[nodiscard]] Failure failure(std::string code, std::string text, std::vector<std::string> arguments = {});
[[nodiscard]] Failure failure(Error error);

// The error of a cancelled computation; its code is "cancelled".
[[nodiscard]] Failure cancelled();

// Replaces {0}, {1}, ... in a sentence. A placeholder without an argument stays as it is.
[[nodiscard]] std::string fill_in(const std::string& sentence, const std::vector<std::string>& arguments);

[[noreturn]] void assertion_failed(const char* condition, const char* file, int line);

}  // namespace glisson

// A broken invariant of ours: ends the program (exit code 3 in glisson-cli), in every build.
#define GLISSON_ASSERT(condition) ((condition) ? void(0) : ::glisson::assertion_failed(#condition, __FILE__, __LINE__))
