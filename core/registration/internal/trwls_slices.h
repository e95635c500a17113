#pragma once
// The fixed-point field of TRWL-S and what is computed from it a slice at a time, for each width of word.
//
// Ranges, which is why nothing saturates. Let C be the largest cost. Costs lie in 0..C by construction. A message is a
// minimum over one index of something plus a cost, so it varies by at most C. Less its minimum it lies in 0..C. A
// belief (the sum of messages) less its minimum is divided among chains and cut at 2 C. The offset of a message is its
// share of the belief - reverse message, in -C..2C. Its minimum is at most 0, at the label whose belief is 0. Hence a
// label with offset >= C never wins. Cutting the belief lets its offset stay >= 2C - C, and so changes nothing. Less
// its minimum the offset lies in 0..3C, and with a cost added in 0..4C. So with 2C below the signed half of the word's
// range and 4C below its whole range every step is exact. Distances may fill the word up to its range less tau. A
// difference that leaves the signed half comes out wrong, but as tau or more, which is where it is cut anyway. What is
// not exact is dividing a belief among the chains that run through the node. What is left over is dealt out, one step a
// message, to the messages that are sent last (error feedback). All shares together are the belief, so that the bound
// stays one.

#include <algorithm>
#include <cstdint>
#include <limits>
#include <new>
#include <type_traits>
#include <vector>

namespace glisson::registration {

template <typename T>
struct CacheLineAllocator {
  using value_type = T;
  CacheLineAllocator() = default;
  template <typename U>
  explicit CacheLineAllocator(const CacheLineAllocator<U>&) {}
  T* allocate(std::size_t count) {
    return static_cast<T*>(::operator new (count * sizeof(T), std::align_val_t{alignment}));
  }
  void deallocate(T* memory, std::size_t) { ::operator delete (memory, std::align_val_t{alignment}); }
  bool operator==(const CacheLineAllocator&) const { return true; }
  static constexpr std::size_t alignment = 128;
};
template <typename T>
using AlignedVector = std::vector<T, CacheLineAllocator<T>>;

// How costs are computed in words of one width: cost = weight x difference, high part.
template <typename Word>
struct Arithmetic {
  static_assert(std::is_unsigned_v<Word>);
  using Difference = std::conditional_t<sizeof(Word) == 4, std::int64_t, std::int32_t>;
  using Total = std::conditional_t<sizeof(Word) == 4, std::uint64_t, std::uint32_t>;  // of as many words as nodes
  using Bound = std::int64_t;
  static constexpr int bits = 8 * sizeof(Word);
  static constexpr Word largest_word = std::numeric_limits<Word>::max();
  static constexpr Word largest_cost = largest_word / 4;
  static constexpr double weight_of_one = largest_word;
  static constexpr double cost_of_one = static_cast<double>(largest_word) / (static_cast<double>(largest_word) + 1.0);

  static Word cost(Word weight, Word difference) {
    return static_cast<Word>((std::uint64_t{weight} * difference) >> bits);
  }
  static_assert(2 * std::uint64_t{largest_cost} <= largest_word / 2);
  static_assert(4 * std::uint64_t{largest_cost} <= largest_word);
};
template <>
struct Arithmetic<double> {
  using Difference = double;
  using Total = double;
  using Bound = double;
  static constexpr double largest_word = std::numeric_limits<double>::infinity();
  static constexpr double weight_of_one = 1;
  static constexpr double cost_of_one = 1;
  static double cost(double weight, double difference) { return weight * difference; }
};

// The 2 n^2 numbers that the field is made of.
template <typename Word>
struct Slices {
  int nodes = 0;
  int labels = 0;
  int stride = 0;                // labels, and words of padding up to a whole number of vectors
  AlignedVector<Word> x;         // x[s * nodes + t]: distance of two nodes
  AlignedVector<Word> x_weight;  // a of eq. 3.2
  AlignedVector<Word> y;         // y[k * stride + l]: distance of two labels
  AlignedVector<Word> y_weight;  // b of eq. 3.2
  Word tau = 0;
  Word largest_cost = 0;  // C

  [[nodiscard]] std::size_t pair_of_nodes(int s, int t) const {
    return static_cast<std::size_t>(s) * static_cast<std::size_t>(nodes) + static_cast<std::size_t>(t);
  }
  [[nodiscard]] std::size_t row(int label) const {
    return static_cast<std::size_t>(label) * static_cast<std::size_t>(stride);
  }
};

// What each of a node's messages gets of its belief: `share`, and one more from the turn on that `one_more_from` says.
// Both are `stride` long.
template <typename Word>
struct SharedBelief {
  const Word* share;
  const std::uint16_t* one_more_from;
};
inline constexpr std::uint16_t never_one_more = 0x7fff;  // no node sends so many messages

// A message on its way from node s to node t.
template <typename Word>
struct Message {
  const Word* reverse;  // the message from t to s
  Word* updated;        // where the message goes
  Word x;               // of the pair
  Word x_weight;
  int turn;  // the how-manieth message of s in this sweep, from 0
};

// The three things done with slices, by whichever instructions. All arrays are `stride` words long.
template <typename Word>
struct SliceKernels {
  using Total = typename Arithmetic<Word>::Total;
  using Bound = typename Arithmetic<Word>::Bound;

  // Sends `count` messages from a node whose belief is given in shares; `scratch` holds four arrays. Returns the sum of
  // the minima that were taken off the messages. Words beyond `labels` become 0.
  Bound (*send)(const Slices<Word>& slices, const SharedBelief<Word>& belief, const Message<Word>* messages, int count,
                Word* scratch);

  // totals[l] += the sum of `count` messages that lie one after the other.
  void (*add_messages)(const Slices<Word>& slices, const Word* first, int count, Total* totals);

  // totals[l] += what it costs a node to take label l when a neighbour, with the pair's x, has taken `label`.
  void (*add_costs)(const Slices<Word>& slices, Word x, Word x_weight, int label, Total* totals);
};

}  // namespace glisson::registration
