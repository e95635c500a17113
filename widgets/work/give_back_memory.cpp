#include "widgets/work/give_back_memory.h"

#include <malloc.h>

namespace glisson::widgets {

void give_back_memory() {
#ifdef __GLIBC__
  malloc_trim(0);
#endif
}

}  // namespace glisson::widgets
