#pragma once
// What one thread wrote before give() is there for the one that calls take(). The library that carries the work between
// them (TBB, Qt) sees to that. This tells the thread sanitizer so, since libraries of the system were built without it.
// Other builds do nothing here.

namespace glisson {

class Handover {
 public:
  void give();
  void take();
};

}  // namespace glisson
