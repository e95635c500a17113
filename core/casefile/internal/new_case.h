#pragma once
// A case that is there whole or not at all.

#include <filesystem>
#include <functional>

#include "casefile/case.h"

namespace glisson::casefile {

// Makes a case beside `folder`, hidden, calls fill with it, and puts it in its place when that succeeds. Killed at any
// moment, `folder` is as it was, and the next call for it clears what is left. Fails as Case::create does, with
// "case-being-made" where another is at it, or as fill does.
Result<Case> make_case(const std::filesystem::path& folder, const std::function<Result<void>(Case&)>& fill);

}  // namespace glisson::casefile
