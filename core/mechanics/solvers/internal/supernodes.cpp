#include "mechanics/solvers/internal/supernodes.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <vector>

#include "base/result.h"

namespace glisson::mechanics {
namespace {

// As cholmod_factor has them: where each supernode's columns begin, its rows and its numbers, and all rows.
struct Pattern {
  std::vector<int> first_column, first_row, first_value, rows;

  [[nodiscard]] std::size_t supernodes() const { return first_column.size() - 1; }
};

Pattern pattern_of(const cholmod_factor& factor) {
  const auto list = [](const void* numbers, std::size_t count) {
    const auto* first = static_cast<const int*>(numbers);
    return std::vector<int>(first, first + count);
  };
  return {list(factor.super, factor.nsuper + 1), list(factor.pi, factor.nsuper + 1), list(factor.px, factor.nsuper + 1),
          list(factor.s, factor.ssize)};
}

// A panel's rows are its own columns, those of the panels after it, and those below.
Pattern in_panels(const Pattern& whole, int widest) {
  Pattern panels;
  std::size_t values = 0;
  for (std::size_t s = 0; s < whole.supernodes(); ++s) {
    const int columns = whole.first_column[s + 1] - whole.first_column[s];
    const int rows = whole.first_row[s + 1] - whole.first_row[s];
    const int count = (columns + widest - 1) / widest, width = (columns + count - 1) / count;
    for (int begin = 0; begin < columns; begin += width) {
      panels.first_column.push_back(whole.first_column[s] + begin);
      panels.first_row.push_back(static_cast<int>(panels.rows.size()));
      panels.first_value.push_back(static_cast<int>(values));
      panels.rows.insert(panels.rows.end(), whole.rows.begin() + whole.first_row[s] + begin,
                         whole.rows.begin() + whole.first_row[s + 1]);
      values += static_cast<std::size_t>(rows - begin) * static_cast<std::size_t>(std::min(width, columns - begin));
    }
  }
  panels.first_column.push_back(whole.first_column.back());
  panels.first_row.push_back(static_cast<int>(panels.rows.size()));
  panels.first_value.push_back(static_cast<int>(values));
  return panels;
}

// What CHOLMOD works in: the largest block that one supernode adds to another, and the most rows below one.
struct Workspace {
  std::size_t block = 1, below = 1;
};

Workspace workspace_for(const Pattern& pattern) {
  std::vector<int> supernode_of;  // of each column
  for (std::size_t s = 0; s < pattern.supernodes(); ++s) {
    supernode_of.resize(static_cast<std::size_t>(pattern.first_column[s + 1]), static_cast<int>(s));
  }
  Workspace needed;
  for (std::size_t s = 0; s < pattern.supernodes(); ++s) {
    const auto end = static_cast<std::size_t>(pattern.first_row[s + 1]);
    auto row = static_cast<std::size_t>(pattern.first_row[s] + pattern.first_column[s + 1] - pattern.first_column[s]);
    needed.below = std::max(needed.below, end - row);
    while (row < end) {
      const int target = supernode_of[static_cast<std::size_t>(pattern.rows[row])];
      std::size_t after = row;
      while (after < end && supernode_of[static_cast<std::size_t>(pattern.rows[after])] == target) ++after;
      needed.block = std::max(needed.block, (after - row) * (end - row));
      row = after;
    }
  }
  return needed;
}

}  // namespace

void split_wide_supernodes(cholmod_factor& factor, int widest, cholmod_common& common) {
  GLISSON_ASSERT(factor.is_super != 0 && factor.xtype == CHOLMOD_PATTERN && widest > 0);
  const Pattern whole = pattern_of(factor), panels = in_panels(whole, widest);
  if (panels.supernodes() == whole.supernodes()) return;
  const std::array lists{&panels.first_column, &panels.first_row, &panels.first_value, &panels.rows};
  std::array<void*, 4> made{};
  bool enough = true;
  for (std::size_t i = 0; i < lists.size(); ++i) {
    made[i] = cholmod_malloc(lists[i]->size(), sizeof(int), &common);
    enough = enough && made[i] != nullptr;
    if (made[i] != nullptr) std::memcpy(made[i], lists[i]->data(), lists[i]->size() * sizeof(int));
  }
  const std::array kept{&factor.super, &factor.pi, &factor.px, &factor.s};
  const std::array<std::size_t, 4> before{factor.nsuper + 1, factor.nsuper + 1, factor.nsuper + 1, factor.ssize};
  for (std::size_t i = 0; i < lists.size(); ++i) {
    if (enough) std::swap(made[i], *kept[i]);
    cholmod_free(enough ? before[i] : lists[i]->size(), sizeof(int), made[i], &common);
  }
  if (!enough) {
    common.status = CHOLMOD_OK;
    return;
  }
  const Workspace needed = workspace_for(panels);
  factor.nsuper = panels.supernodes();
  factor.ssize = panels.rows.size();
  factor.xsize = static_cast<std::size_t>(panels.first_value.back());
  factor.maxcsize = needed.block;
  factor.maxesize = needed.below;
}

}  // namespace glisson::mechanics
