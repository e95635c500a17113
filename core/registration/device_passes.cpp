#include "registration/internal/device_passes.h"

#include <numeric>

namespace glisson::registration {
namespace {

// What is computed is what trwls_plain.h says, a word a work item. Totals are summed by whichever item comes first:
// whole numbers do not mind. A group's messages share each row of distances that is read.
constexpr const char* passes_source = R"(
#define TARGETS 2
#define GROUP 256
#define NEVER 0x7fff
#define TOGETHER 16

// The minimum of each of two numbers over the group.
int2 minimum_of_group(int2 mine, __local int2* seen) {
  const int lane = get_local_id(0);
  barrier(CLK_LOCAL_MEM_FENCE);
  seen[lane] = mine;
  for (int half_of_them = GROUP / 2; half_of_them > 0; half_of_them /= 2) {
    barrier(CLK_LOCAL_MEM_FENCE);
    if (lane < half_of_them) seen[lane] = min(seen[lane], seen[lane + half_of_them]);
  }
  barrier(CLK_LOCAL_MEM_FENCE);
  return seen[0];
}

__kernel void begin_sweep(__global const uint* seed, __global uint* totals, const uint count) {
  if (get_global_id(0) < count) totals[get_global_id(0)] = seed[get_global_id(0)];
}

// The messages to node s, a few for each item.
__kernel void gather(__global const ushort* messages, __global uint* totals, const int nodes, const int stride,
                     const int s) {
  const int l = get_global_id(0);
  if (l >= stride) return;
  const int first = get_global_id(1) * 16;
  const int end = min(first + 16, nodes);
  __global const ushort* message = messages + ((size_t)s * nodes + first) * stride + l;
  uint sum = 0;
  for (int t = first; t < end; ++t, message += stride) sum += *message;
  atomic_add(totals + (size_t)s * stride + l, sum);
}

// From the node at a position to those at the next ones, two for each group. A pair's or a label's weight is the upper
// half of its word, so that mad_hi multiplies, takes the upper half and adds in one instruction.
__kernel void send(__global const uint* pairs, __global const uint* costs, __global const uint* totals,
                   __global ushort* messages, __global uint* node_taken, __global int* message_taken, const int nodes,
                   const int labels, const int stride, const uint tau, const uint cut, const int position,
                   const int back, __local ushort2* offsets, __local int2* seen) {
  const int lane = get_local_id(0);
  const int first = position + 1 + (int)get_group_id(0) * TARGETS;
  const int s = back ? nodes - 1 - position : position;
  const uint chains = max(s, nodes - 1 - s);
  totals += (size_t)s * stride;

  // As if signed: the smallest of all comes first.
  int least_signed = 0x7fffffff;
  for (int k = lane; k < labels; k += GROUP) least_signed = min(least_signed, as_int(totals[k] ^ 0x80000000));
  const uint least = as_uint(minimum_of_group((int2)(least_signed), seen).x) ^ 0x80000000;
  if (get_group_id(0) == 0 && lane == 0) node_taken[position] = least;

  const int target0 = min(first, nodes - 1), target1 = min(first + 1, nodes - 1);
  const int t0 = back ? nodes - 1 - target0 : target0, t1 = back ? nodes - 1 - target1 : target1;
  __global const ushort* reverse0 = messages + ((size_t)s * nodes + t0) * stride;
  __global const ushort* reverse1 = messages + ((size_t)s * nodes + t1) * stride;
  __global ushort* updated0 = messages + ((size_t)t0 * nodes + s) * stride;
  __global ushort* updated1 = messages + ((size_t)t1 * nodes + s) * stride;
  const uint pair0 = pairs[(size_t)s * nodes + t0], pair1 = pairs[(size_t)s * nodes + t1];
  const int x0 = pair0 & 0xffff, x1 = pair1 & 0xffff;
  const uint weight0 = pair0 & 0xffff0000, weight1 = pair1 & 0xffff0000;

  // Shares of the belief, less the reverse messages.
  const int sent = first - position - 1;
  int2 lowest = (int2)(0x7fffffff);
  for (int turn = 0; turn < 2; ++turn) {
    for (int k = lane; k < labels; k += GROUP) {
      const uint whole = totals[k] - least;
      const uint quotient = whole / chains;
      const int one_more_from = quotient >= cut ? NEVER : (int)(chains - (whole - quotient * chains));
      const int share = min(quotient, cut);
      const int2 difference = (int2)(share + (sent >= one_more_from) - reverse0[k],
                                     share + (sent + 1 >= one_more_from) - reverse1[k]);
      if (turn == 0) lowest = min(lowest, difference);
      else offsets[k] = convert_ushort2(difference - lowest);
    }
    if (turn == 0) lowest = minimum_of_group(lowest, seen);
  }
  for (int k = labels + lane; k < labels + TOGETHER; k += GROUP) offsets[k] = (ushort2)(0xffff);  // never the cheapest
  barrier(CLK_LOCAL_MEM_FENCE);

  int2 cheapest = (int2)(0xffff);
  for (int l = lane; l < labels; l += GROUP) {
    uint best0 = 0xffff, best1 = 0xffff;
    __global const uint* column = costs + l;
    // Many distances are asked for before the first is used: one alone would be waited for.
    for (int begin = 0; begin < labels; begin += TOGETHER) {
      uint cost[TOGETHER];
#pragma unroll
      for (int j = 0; j < TOGETHER; ++j) cost[j] = column[(size_t)(begin + j) * stride];
#pragma unroll
      for (int j = 0; j < TOGETHER; ++j) {
        const int y = cost[j] & 0xffff;
        const uint y_weight = cost[j] & 0xffff0000;
        const uint2 offset = convert_uint2(offsets[begin + j]);
        best0 = min(best0, mad_hi(max(weight0, y_weight), min(abs(x0 - y), tau), offset.x));
        best1 = min(best1, mad_hi(max(weight1, y_weight), min(abs(x1 - y), tau), offset.y));
      }
    }
    cheapest = min(cheapest, (int2)(best0, best1));
    if (first < nodes) updated0[l] = best0;
    if (first + 1 < nodes) updated1[l] = best1;
  }
  cheapest = minimum_of_group(cheapest, seen);
  for (int l = lane; l < labels; l += GROUP) {
    if (first < nodes) updated0[l] -= cheapest.x;
    if (first + 1 < nodes) updated1[l] -= cheapest.y;
  }
  if (lane == 0) {
    const int2 taken = lowest + cheapest;
    if (first < nodes) message_taken[(size_t)position * nodes + first] = taken.x;
    if (first + 1 < nodes) message_taken[(size_t)position * nodes + first + 1] = taken.y;
  }
}

// The messages to each node from those after it.
__kernel void sum_later(__global const ushort* messages, __global uint* later, const int nodes, const int stride) {
  const int l = get_global_id(0);
  const int s = get_global_id(1);
  if (l >= stride) return;
  uint sum = 0;
  __global const ushort* message = messages + ((size_t)s * nodes + s + 1) * stride + l;
  for (int t = s + 1; t < nodes; ++t, message += stride) sum += *message;
  later[(size_t)s * stride + l] = sum;
})";
constexpr std::size_t items_of_group = 256;
constexpr int targets_of_group = 2;
constexpr std::size_t labels_together = 16;
constexpr int messages_of_item = 16;

// Distances and weights of pairs, each two words in one.
std::vector<std::uint32_t> together(const AlignedVector<std::uint16_t>& distances,
                                    const AlignedVector<std::uint16_t>& weights) {
  std::vector<std::uint32_t> both(distances.size());
  for (std::size_t i = 0; i < both.size(); ++i) both[i] = std::uint32_t{weights[i]} << 16 | distances[i];
  return both;
}

}  // namespace

Result<DevicePasses> DevicePasses::open(const Quantised<std::uint16_t>& field, const std::string& device_name) {
  auto session = opencl::Session::open(passes_source, device_name);
  if (!session) return failure(session.error());
  const auto nodes = static_cast<std::uint64_t>(field.slices.nodes);
  const std::uint64_t bytes = 2 * nodes * nodes * static_cast<std::uint64_t>(field.slices.stride);
  if (bytes > session->memory_bytes()) {
    return failure(
        "opencl-memory", GLISSON_TEXT("The matching takes {0} MB on {1}, which has {2} MB."),
        {std::to_string(bytes >> 20), session->device_name(), std::to_string(session->memory_bytes() >> 20)});
  }
  DevicePasses passes(field, std::move(*session));
  if (auto ready = passes.session_.finish(); !ready) return failure(ready.error());
  return passes;
}

DevicePasses::DevicePasses(const Quantised<std::uint16_t>& field, opencl::Session session)
    : field_(&field), session_(std::move(session)) {
  const Slices<std::uint16_t>& slices = field.slices;
  const auto nodes = static_cast<std::size_t>(slices.nodes);
  const auto stride = static_cast<std::size_t>(slices.stride);
  pairs_ = session_.buffer_of(together(slices.x, slices.x_weight));
  std::vector<std::uint32_t> costs = together(slices.y, slices.y_weight);
  costs.resize(costs.size() + labels_together * stride);  // read, and never the cheapest
  costs_ = session_.buffer_of(costs);
  seed_ = session_.buffer_of(field.seed);
  messages_ = session_.buffer(sizeof(std::uint16_t) * nodes * nodes * stride);
  totals_ = session_.buffer(sizeof(std::uint32_t) * nodes * stride);
  later_ = session_.buffer(sizeof(std::uint32_t) * nodes * stride);
  node_taken_ = session_.buffer(sizeof(std::uint32_t) * nodes);
  message_taken_ = session_.buffer(sizeof(std::int32_t) * nodes * nodes);
  later_sums_.resize(nodes * stride);
}

Result<void> DevicePasses::pass(int, const Progress& progress) {
  const Slices<std::uint16_t>& slices = field_->slices;
  for (const bool back : {false, true}) {
    if (progress.cancelled()) return cancelled();
    sweep(back);
  }
  const auto stride = static_cast<std::size_t>(slices.stride);
  const auto nodes = static_cast<std::size_t>(slices.nodes);
  session_.run("sum_later", {opencl::whole_groups(stride, 64), 64, nodes},
               {&messages_, &later_, slices.nodes, slices.stride});
  session_.read(later_, later_sums_.data(), sizeof(std::uint32_t) * later_sums_.size());
  std::vector<std::uint32_t> of_nodes(nodes);
  std::vector<std::int32_t> of_messages(nodes * nodes);
  session_.read(node_taken_, of_nodes.data(), sizeof(std::uint32_t) * of_nodes.size());
  session_.read(message_taken_, of_messages.data(), sizeof(std::int32_t) * of_messages.size());
  taken_ = static_cast<double>(std::accumulate(of_nodes.begin(), of_nodes.end(), std::int64_t{0}) +
                               std::accumulate(of_messages.begin(), of_messages.end(), std::int64_t{0}));
  return session_.finish();
}

void DevicePasses::sweep(bool back) {
  const Slices<std::uint16_t>& slices = field_->slices;
  const auto stride = static_cast<std::size_t>(slices.stride);
  const auto nodes = static_cast<std::size_t>(slices.nodes);
  const auto count = static_cast<std::uint32_t>(nodes * stride);
  session_.run("begin_sweep", {opencl::whole_groups(count, 64), 64}, {&seed_, &totals_, count});
  const auto labels = static_cast<std::size_t>(slices.labels);
  for (int position = 0; position < slices.nodes; ++position) {
    const int s = back ? slices.nodes - 1 - position : position;
    session_.run("gather", {opencl::whole_groups(stride, 64), 64, (nodes + messages_of_item - 1) / messages_of_item},
                 {&messages_, &totals_, slices.nodes, slices.stride, s});
    // The last node sends none, but what is taken off its belief counts.
    const int groups = std::max(1, (slices.nodes - 1 - position + targets_of_group - 1) / targets_of_group);
    session_.run("send", {items_of_group * static_cast<std::size_t>(groups), items_of_group},
                 {&pairs_, &costs_, &totals_, &messages_, &node_taken_, &message_taken_, slices.nodes, slices.labels,
                  slices.stride, std::uint32_t{slices.tau}, 2 * std::uint32_t{slices.largest_cost}, position,
                  std::int32_t{back}, opencl::LocalBytes{2 * sizeof(std::uint16_t) * (labels + labels_together)},
                  opencl::LocalBytes{2 * sizeof(std::int32_t) * items_of_group}});
  }
}

void DevicePasses::add_later_messages(int s, std::uint32_t* costs) const {
  const auto stride = static_cast<std::size_t>(field_->slices.stride);
  const std::uint32_t* sums = later_sums_.data() + static_cast<std::size_t>(s) * stride;
  for (std::size_t l = 0; l < stride; ++l) costs[l] += sums[l];
}

double DevicePasses::taken(int) const { return taken_; }

}  // namespace glisson::registration
