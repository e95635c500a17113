#pragma once
// A number about hardware never goes without where it comes from.

#include <string>

namespace glisson::hardware {

enum class Source {
  measured,      // by somebody with an instrument; the note says who and where
  computed,      // by this project's own engine; the note says with which command
  dissertation,  // stated in chapter 6, mostly table 6.2
  assumed,       // ours: read off a maker's figure and derated, or estimated; shown as such wherever it is used
};

struct Figure {
  double value = 0;
  Source source = Source::assumed;
  std::string note;  // one clause: which trace, which table, which reasoning
};

}  // namespace glisson::hardware
