#pragma once
// What one thread wrote before give() is there for the one that calls take(). The library that carries the work between
// them (TBB, Qt) sees to that; this tells the thread sanitizer, which libraries of the system were built without. Other
// builds do nothing here.

namespace glisson {

class Handover {
 public:
  void give();
  void take();
};

}  // namespace glisson
