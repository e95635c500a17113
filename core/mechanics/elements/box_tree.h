#pragma once
// A balanced tree of axis-aligned boxes, to find the few items around a place without looking at all of them.

#include <algorithm>
#include <Eigen/Geometry>
#include <numeric>
#include <vector>

namespace glisson::mechanics {

class BoxTree {
 public:
  // One box an item; not empty.
  explicit BoxTree(const std::vector<Eigen::AlignedBox3d>& boxes) : items_(boxes.size()) {
    std::iota(items_.begin(), items_.end(), 0);
    nodes_.reserve(2 * boxes.size() / leaf_size + 2);
    build(boxes, 0, static_cast<int>(boxes.size()));
  }

  // Calls visit(item) for every item of the leaves whose boxes hold the place, until one gives back true.
  template <typename Visit>
  bool visit_containing(const Eigen::Vector3d& place, Visit visit) const {
    return descend_containing(0, place, visit);
  }

 private:
  static constexpr int leaf_size = 8;
  struct Node {
    Eigen::AlignedBox3d box;
    int begin, end;  // of items_
    int right;       // the left child follows its parent; 0: a leaf
  };

  int build(const std::vector<Eigen::AlignedBox3d>& boxes, int begin, int end) {
    const int self = static_cast<int>(nodes_.size());
    nodes_.push_back({{}, begin, end, 0});
    Eigen::AlignedBox3d box;
    for (int i = begin; i < end; ++i) box.extend(boxes[items_[i]]);
    nodes_[self].box = box;
    if (end - begin <= leaf_size) return self;
    Eigen::Index axis = 0;
    box.sizes().maxCoeff(&axis);
    const int middle = begin + (end - begin) / 2;
    std::nth_element(items_.begin() + begin, items_.begin() + middle, items_.begin() + end,
                     [&](int a, int b) { return boxes[a].center()[axis] < boxes[b].center()[axis]; });
    build(boxes, begin, middle);
    const int right = build(boxes, middle, end);
    nodes_[self].right = right;
    return self;
  }

  template <typename Visit>
  bool descend_containing(int index, const Eigen::Vector3d& place, Visit& visit) const {
    const Node& node = nodes_[index];
    if (!node.box.contains(place)) return false;
    if (node.right == 0) return std::any_of(items_.begin() + node.begin, items_.begin() + node.end, visit);
    return descend_containing(index + 1, place, visit) || descend_containing(node.right, place, visit);
  }

  std::vector<int> items_;
  std::vector<Node> nodes_;
};

}  // namespace glisson::mechanics
