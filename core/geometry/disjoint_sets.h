#pragma once
// Which items hang together: union-find with path halving and union by size.

#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace glisson::geometry {

class DisjointSets {
 public:
  explicit DisjointSets(std::size_t items) : parent_(items), size_(items, 1) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }

  // The item that stands for the set which `item` is in.
  [[nodiscard]] std::size_t root(std::size_t item) {
    while (parent_[item] != item) item = parent_[item] = parent_[parent_[item]];
    return item;
  }

  void join(std::size_t a, std::size_t b) {
    a = root(a);
    b = root(b);
    if (a == b) return;
    if (size_[a] < size_[b]) std::swap(a, b);
    parent_[b] = a;
    size_[a] += size_[b];
  }

  // How many items are in the set which `item` is in.
  [[nodiscard]] std::size_t size_of(std::size_t item) { return size_[root(item)]; }

 private:
  std::vector<std::size_t> parent_;
  std::vector<std::size_t> size_;
};

}  // namespace glisson::geometry
