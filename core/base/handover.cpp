#include "base/handover.h"

#if defined(__SANITIZE_THREAD__)
#include <sanitizer/tsan_interface.h>
#endif

namespace glisson {

#if defined(__SANITIZE_THREAD__)
void Handover::give() { __tsan_release(this); }
void Handover::take() { __tsan_acquire(this); }
#else
void Handover::give() {}
void Handover::take() {}
#endif

}  // namespace glisson
