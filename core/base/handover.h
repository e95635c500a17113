#pragma once
// What one thread wrote before give() is there for the one that calls take(). The library that carries the work between
// them (TBB, Qt) sees to that; this tells the thread sanitizer, which libraries of the system were built without. Other
// builds do nothing here.

#if defined(__SANITIZE_THREAD__)
#include <sanitizer/tsan_interface.h>
#endif

namespace glisson {

class Handover {
 public:
  void give() {
#if defined(__SANITIZE_THREAD__)
    __tsan_release(this);
#endif
  }
  void take() {
#if defined(__SANITIZE_THREAD__)
    __tsan_acquire(this);
#endif
  }
};

}  // namespace glisson
