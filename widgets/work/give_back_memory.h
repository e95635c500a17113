#pragma once
// What the program took for a while and no longer needs: the allocator would keep it, 140 MB after a report.

namespace glisson::widgets {

void give_back_memory();

}  // namespace glisson::widgets
