// Four messages of one node at a time, or two where registers are few: the row of target distances that is loaded
// serves all. So it runs at 95 % of what the same operations reach in registers alone (bench_registration, roofline).

#include "registration/internal/trwls_simd.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "registration/trwls_simd.cpp"
// Vectors whose length the compiler does not know cannot be kept in arrays.
#define HWY_DISABLED_TARGETS (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)
#include <hwy/cache_control.h>
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace glisson::registration {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using Word = std::uint16_t;
using Tag = hn::ScalableTag<Word>;
using SignedTag = hn::RebindToSigned<Tag>;
using Vector = hn::Vec<Tag>;
using Row = Arithmetic<Word>;

constexpr bool many_registers = HWY_TARGET == HWY_AVX3 || HWY_TARGET == HWY_AVX3_DL || HWY_TARGET == HWY_NEON;
constexpr int maximum_together = many_registers ? 4 : 2;  // messages
// Vectors of labels in flight for each of so many messages.
constexpr int columns_of(int messages) { return std::min(4, (many_registers ? 8 : 4) / messages); }

constexpr int words_in_cache_line = 32;

template <class D>
HWY_INLINE hn::Vec<D> cost(D tag, hn::Vec<D> y, hn::Vec<D> y_weight, hn::Vec<D> x, hn::Vec<D> x_weight,
                           hn::Vec<D> tau) {
  const hn::RebindToSigned<D> signed_tag;
  const auto difference = hn::Sub(hn::BitCast(signed_tag, y), hn::BitCast(signed_tag, x));
  return hn::MulHigh(hn::Max(y_weight, x_weight), hn::Min(hn::BitCast(tag, hn::Abs(difference)), tau));
}

// offset[k] = share[k], or one more, - reverse[k], less its minimum, which is returned. Padding never is the minimum:
// its share is the largest there is and its message 0.
HWY_INLINE int take_offset(const Slices<Word>& slices, const SharedBelief<Word>& belief, const Message<Word>& message,
                           Word* offset) {
  const Tag tag;
  const SignedTag signed_tag;
  const auto lanes = hn::Lanes(tag);
  const auto stride = static_cast<std::size_t>(slices.stride);
  const auto next_turn = hn::Set(signed_tag, static_cast<std::int16_t>(message.turn + 1));
  auto minimum = hn::Set(signed_tag, hwy::LimitsMax<std::int16_t>());
  for (std::size_t k = 0; k < stride; k += lanes) {
    const auto from = hn::BitCast(signed_tag, hn::Load(tag, belief.one_more_from + k));
    const auto minus_one = hn::VecFromMask(signed_tag, hn::Gt(next_turn, from));  // where one more is due
    const auto share = hn::Sub(hn::BitCast(signed_tag, hn::Load(tag, belief.share + k)), minus_one);
    const auto difference = hn::Sub(share, hn::BitCast(signed_tag, hn::Load(tag, message.reverse + k)));
    hn::Store(hn::BitCast(tag, difference), tag, offset + k);
    minimum = hn::Min(minimum, difference);
  }
  minimum = hn::MinOfLanes(signed_tag, minimum);
  const auto subtrahend = hn::BitCast(tag, minimum);
  for (std::size_t k = 0; k < stride; k += lanes) {
    hn::Store(hn::Sub(hn::Load(tag, offset + k), subtrahend), tag, offset + k);
  }
  return hn::GetLane(minimum);
}

// updated[m][l] = min over k of offset[m][k] + cost(k, l), for `columns` vectors of labels l from `first`.
template <int messages, int columns>
HWY_INLINE void minimise_columns(const Slices<Word>& slices, const Message<Word>* message, const Word* offset,
                                 std::size_t first) {
  const Tag tag;
  const auto lanes = hn::Lanes(tag);
  const auto stride = static_cast<std::size_t>(slices.stride);
  const Vector tau = hn::Set(tag, slices.tau);
  Vector x[messages];
  Vector x_weight[messages];
  Vector minimum[messages][columns];
  for (int m = 0; m < messages; ++m) {
    x[m] = hn::Set(tag, message[m].x);
    x_weight[m] = hn::Set(tag, message[m].x_weight);
    for (int c = 0; c < columns; ++c) minimum[m][c] = hn::Set(tag, Row::largest_word);
  }
  const Word* y = slices.y.data() + first;
  const Word* y_weight = slices.y_weight.data() + first;
  for (std::size_t k = 0; k < static_cast<std::size_t>(slices.labels); ++k, y += stride, y_weight += stride) {
    Vector start[messages];
    for (int m = 0; m < messages; ++m) start[m] = hn::Set(tag, offset[static_cast<std::size_t>(m) * stride + k]);
    for (int c = 0; c < columns; ++c) {
      const auto column = static_cast<std::size_t>(c) * lanes;
      const Vector distance = hn::Load(tag, y + column);
      const Vector weight = hn::Load(tag, y_weight + column);
      for (int m = 0; m < messages; ++m) {
        minimum[m][c] = hn::Min(minimum[m][c], hn::Add(start[m], cost(tag, distance, weight, x[m], x_weight[m], tau)));
      }
    }
  }
  for (int m = 0; m < messages; ++m) {
    for (int c = 0; c < columns; ++c) {
      hn::Store(minimum[m][c], tag, message[m].updated + first + static_cast<std::size_t>(c) * lanes);
    }
  }
}

template <int messages>
HWY_INLINE void minimise(const Slices<Word>& slices, const Message<Word>* message, const Word* offset) {
  const std::size_t lanes = hn::Lanes(Tag());
  const auto stride = static_cast<std::size_t>(slices.stride);
  constexpr int columns = columns_of(messages);
  const std::size_t step = columns * lanes;
  std::size_t first = 0;
  for (; first + step <= stride; first += step) minimise_columns<messages, columns>(slices, message, offset, first);
  if (columns > 2 && first + 2 * lanes <= stride) {
    minimise_columns<messages, 2>(slices, message, offset, first);
    first += 2 * lanes;
  }
  for (; first < stride; first += lanes) minimise_columns<messages, 1>(slices, message, offset, first);
}

// Takes the minimum over the labels off the message and returns it; the padding becomes 0.
HWY_INLINE int take_minimum(const Slices<Word>& slices, Word* message) {
  const Tag tag;
  const auto lanes = hn::Lanes(tag);
  const auto labels = static_cast<std::size_t>(slices.labels);
  const auto stride = static_cast<std::size_t>(slices.stride);
  const auto largest = hn::Set(tag, Row::largest_word);
  auto minimum = largest;
  std::size_t l = 0;
  for (; l + lanes <= labels; l += lanes) minimum = hn::Min(minimum, hn::Load(tag, message + l));
  if (l < labels) {
    minimum = hn::Min(minimum, hn::IfThenElse(hn::FirstN(tag, labels - l), hn::Load(tag, message + l), largest));
  }
  minimum = hn::MinOfLanes(tag, minimum);
  for (l = 0; l + lanes <= labels; l += lanes)
    hn::Store(hn::Sub(hn::Load(tag, message + l), minimum), tag, message + l);
  if (l < labels) {
    const auto rest = hn::Sub(hn::Load(tag, message + l), minimum);
    hn::Store(hn::IfThenElseZero(hn::FirstN(tag, labels - l), rest), tag, message + l);
    l += lanes;
  }
  for (; l < stride; l += lanes) hn::Store(hn::Zero(tag), tag, message + l);
  return hn::GetLane(minimum);
}

std::int64_t send(const Slices<Word>& slices, const SharedBelief<Word>& belief, const Message<Word>* message, int count,
                  Word* scratch) {
  std::int64_t taken = 0;
  for (const Message<Word>* end = message + count; message != end;) {
    const auto left = end - message;
    const int together = left >= maximum_together ? maximum_together : left >= 2 ? 2 : 1;
    for (const Message<Word>* next = message + together; next != std::min(end, message + 2 * together); ++next) {
      for (int word = 0; word < slices.stride; word += words_in_cache_line) {
        hwy::Prefetch(next->reverse + word);
        hwy::Prefetch(next->updated + word);
      }
    }
    for (int m = 0; m < together; ++m) {
      taken += take_offset(slices, belief, message[m], scratch + m * slices.stride);
    }
    together == 1   ? minimise<1>(slices, message, scratch)
    : together == 2 ? minimise<2>(slices, message, scratch)
                    : minimise<maximum_together>(slices, message, scratch);
    for (int m = 0; m < together; ++m) taken += take_minimum(slices, message[m].updated);
    message += together;
  }
  return taken;
}

void add_messages(const Slices<Word>& slices, const Word* first, int count, std::uint32_t* totals) {
  const hn::ScalableTag<std::uint32_t> wide;
  const hn::Rebind<Word, decltype(wide)> narrow;
  const auto lanes = hn::Lanes(wide);
  const auto stride = static_cast<std::size_t>(slices.stride);
  for (std::size_t l = 0; l < stride; l += lanes) {
    auto sum = hn::Load(wide, totals + l);
    const Word* message = first + l;
    for (int m = 0; m < count; ++m, message += stride)
      sum = hn::Add(sum, hn::PromoteTo(wide, hn::Load(narrow, message)));
    hn::Store(sum, wide, totals + l);
  }
}

void add_costs(const Slices<Word>& slices, Word x, Word x_weight, int label, std::uint32_t* totals) {
  const hn::ScalableTag<std::uint32_t> wide;
  const hn::Rebind<Word, decltype(wide)> narrow;
  const auto lanes = hn::Lanes(wide);
  const auto x_lanes = hn::Set(narrow, x);
  const auto x_weight_lanes = hn::Set(narrow, x_weight);
  const auto tau = hn::Set(narrow, slices.tau);
  const Word* y = slices.y.data() + slices.row(label);
  const Word* y_weight = slices.y_weight.data() + slices.row(label);
  for (std::size_t l = 0; l < static_cast<std::size_t>(slices.stride); l += lanes) {
    const auto costs =
        cost(narrow, hn::Load(narrow, y + l), hn::Load(narrow, y_weight + l), x_lanes, x_weight_lanes, tau);
    hn::Store(hn::Add(hn::Load(wide, totals + l), hn::PromoteTo(wide, costs)), wide, totals + l);
  }
}

SliceKernels<Word> kernels() { return {send, add_messages, add_costs}; }
const char* name() { return hwy::TargetName(HWY_TARGET); }

}  // namespace HWY_NAMESPACE
}  // namespace glisson::registration
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace glisson::registration {

HWY_EXPORT(kernels);
HWY_EXPORT(name);

SliceKernels<std::uint16_t> simd_kernels() { return HWY_DYNAMIC_DISPATCH(kernels)(); }
const char* simd_name() { return HWY_DYNAMIC_DISPATCH(name)(); }

}  // namespace glisson::registration
#endif
