#pragma once
// The slice kernels in portable C++, for every width of word.

#include "registration/internal/trwls_slices.h"

namespace glisson::registration {

template <typename Word>
struct PlainKernels {
  using Difference = typename Arithmetic<Word>::Difference;
  using Total = typename Arithmetic<Word>::Total;
  using Bound = typename Arithmetic<Word>::Bound;

  static constexpr SliceKernels<Word> table() { return {send, add_messages, add_costs}; }

 private:
  static Word cost(const Slices<Word>& slices, Word x, Word x_weight, std::size_t cell) {
    const auto difference = static_cast<Difference>(x) - static_cast<Difference>(slices.y[cell]);
    return Arithmetic<Word>::cost(std::max(x_weight, slices.y_weight[cell]),
                                  std::min(static_cast<Word>(difference < 0 ? -difference : difference), slices.tau));
  }

  static Bound send(const Slices<Word>& slices, const SharedBelief<Word>& belief, const Message<Word>* messages,
                    int count, Word* scratch) {
    Bound taken = 0;
    for (const Message<Word>* message = messages; message != messages + count; ++message) {
      taken += send_one(slices, belief, *message, scratch);
    }
    return taken;
  }

  static Bound send_one(const Slices<Word>& slices, const SharedBelief<Word>& belief, const Message<Word>& message,
                        Word* offset) {
    const auto difference = [&](int k) {
      const Difference one_more = message.turn >= belief.one_more_from[k] ? 1 : 0;
      return static_cast<Difference>(belief.share[k]) + one_more - static_cast<Difference>(message.reverse[k]);
    };
    Difference minimum_offset = std::numeric_limits<Difference>::max();
    for (int k = 0; k < slices.labels; ++k) minimum_offset = std::min(minimum_offset, difference(k));
    for (int k = 0; k < slices.labels; ++k) offset[k] = static_cast<Word>(difference(k) - minimum_offset);

    Word* updated = message.updated;
    std::fill(updated, updated + slices.labels, Arithmetic<Word>::largest_word);
    for (int k = 0; k < slices.labels; ++k) {
      std::size_t cell = slices.row(k);
      for (int l = 0; l < slices.labels; ++l, ++cell) {
        updated[l] =
            std::min(updated[l], static_cast<Word>(offset[k] + cost(slices, message.x, message.x_weight, cell)));
      }
    }
    const Word minimum = *std::min_element(updated, updated + slices.labels);
    for (int l = 0; l < slices.labels; ++l) updated[l] = static_cast<Word>(updated[l] - minimum);
    return static_cast<Bound>(minimum_offset) + static_cast<Bound>(minimum);
  }

  static void add_messages(const Slices<Word>& slices, const Word* first, int count, Total* totals) {
    for (int message = 0; message < count; ++message, first += slices.stride) {
      for (int l = 0; l < slices.labels; ++l) totals[l] += first[l];
    }
  }

  static void add_costs(const Slices<Word>& slices, Word x, Word x_weight, int label, Total* totals) {
    std::size_t cell = slices.row(label);
    for (int l = 0; l < slices.labels; ++l, ++cell) totals[l] += cost(slices, x, x_weight, cell);
  }
};

}  // namespace glisson::registration
