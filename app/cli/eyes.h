#pragma once
// --eyes: how one picture or video shows both eyes, where there is one and not two.

#include "one_of.h"
#include "vision/stereo_source.h"

namespace glisson::cli {

// `right` names the right eye's; either it or --eyes is given (check_eyes).
inline CLI::Option* add_eyes(CLI::App& command, CLI::Option* right, vision::Shared& shared) {
  using vision::Shared;
  return command
      .add_option("--eyes", shared,
                  "Where one picture shows both eyes, and nothing is named for the right one: which is "
                  "where")
      ->transform(one_of(Words<Shared>{{"left-right", Shared::left_then_right},
                                       {"right-left", Shared::right_then_left},
                                       {"left-above", Shared::left_above_right}}))
      ->excludes(right);
}

inline void check_eyes(const CLI::Option& right, const CLI::Option& eyes) {
  if (right.empty() && eyes.empty()) throw CLI::RequiredError("The right eye's, or --eyes where one shows both,");
}

}  // namespace glisson::cli
