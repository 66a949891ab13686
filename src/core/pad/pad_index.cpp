#include "core/pad/pad_index.h"

#include <algorithm>
#include <numeric>

namespace tessera {
namespace {

constexpr std::size_t kNodePads = std::size_t(kIndexFanOut) * kIndexFanOut;

class Splitter {
 public:
  Splitter(std::span<const PadBytes> pads, int elements, double scale_share)
      : pads_(pads),
        elements_(elements),
        scale_share_(scale_share) {}

  /// Orders PADs so that every whole block, and every whole node, is one branch of the tree.
  void split(std::span<std::uint32_t> order) const {
    const std::size_t whole = order.size() > kNodePads ? kNodePads : kIndexFanOut;
    if (order.size() <= whole) return;
    const std::size_t parts = (order.size() + whole - 1) / whole;
    const std::size_t middle = parts / 2 * whole;
    part(order, middle);
    split(order.first(middle));
    split(order.subspan(middle));
  }

  /// The first `convex` of them are: convex ones have a tree of their own, the others (concave, flat) another,
  /// but for one `unit` in which both meet.
  void split_by_sign(std::span<std::uint32_t> order, std::size_t convex, std::size_t unit) const {
    const std::size_t whole = convex / unit * unit;
    const std::size_t mixed_end = std::min(order.size(), whole + unit);
    split(order.first(whole));
    part(order.subspan(convex), mixed_end - convex);
    split(order.subspan(mixed_end));
    if (unit > kIndexFanOut) split_by_sign(order.subspan(whole, mixed_end - whole), convex - whole, kIndexFanOut);
  }

 private:
  /// Those before `middle` have no larger byte than the others, of the row that varies most.
  void part(std::span<std::uint32_t> order, std::size_t middle) const {
    if (middle == 0 || middle >= order.size()) return;
    const int row = widest_row(order);
    std::nth_element(order.begin(), order.begin() + std::ptrdiff_t(middle), order.end(),
                     [&](std::uint32_t a, std::uint32_t b) {
                       const int byte_a = byte(pads_[a], row);
                       const int byte_b = byte(pads_[b], row);
                       return byte_a != byte_b ? byte_a < byte_b : a < b;
                     });
  }

  int byte(const PadBytes& pad, int row) const { return row < elements_ ? pad.element[std::size_t(row)] : pad.scale; }

  /// The row (an element, or the scale behind them) whose bytes vary most.
  int widest_row(std::span<const std::uint32_t> order) const {
    std::array<std::uint64_t, kMaxPadElements + 1> sum{};
    std::array<std::uint64_t, kMaxPadElements + 1> squares{};
    for (const std::uint32_t i : order) {
      for (int row = 0; row <= elements_; ++row) {
        const auto b = std::uint64_t(byte(pads_[i], row));
        sum[std::size_t(row)] += b;
        squares[std::size_t(row)] += b * b;
      }
    }
    int widest = 0;
    double most = -1;
    for (int row = 0; row <= elements_; ++row) {
      const double mean = double(sum[std::size_t(row)]) / double(order.size());
      double variance = double(squares[std::size_t(row)]) / double(order.size()) - mean * mean;
      if (row == elements_) variance *= scale_share_;
      if (variance > most) {
        most = variance;
        widest = row;
      }
    }
    return widest;
  }

  std::span<const PadBytes> pads_;
  int elements_;
  double scale_share_;
};

/// Of some PADs; bytes side by side, so that one instruction compares them all.
class BoxOfPads {
 public:
  void enclose(const PadBytes& pad) {
    Bytes bytes{};
    std::copy(pad.element.begin(), pad.element.end(), bytes.begin());
    bytes[kMaxPadElements] = pad.scale;
    for (std::size_t e = 0; e < bytes.size(); ++e) {
      low_[e] = std::min(low_[e], bytes[e]);
      high_[e] = std::max(high_[e], bytes[e]);
    }
    signs_ |= pad.sign;
  }

  PadBox box() const {
    PadBox box;
    std::copy_n(low_.begin(), kMaxPadElements, box.low.begin());
    std::copy_n(high_.begin(), kMaxPadElements, box.high.begin());
    box.scale_low = low_[kMaxPadElements];
    box.scale_high = high_[kMaxPadElements];
    box.signs = signs_;
    return box;
  }

 private:
  using Bytes = std::array<std::uint8_t, 16>;
  static_assert(kMaxPadElements < std::tuple_size_v<Bytes>);
  static constexpr Bytes kLargest = [] {
    Bytes bytes;
    bytes.fill(255);
    return bytes;
  }();

  Bytes low_ = kLargest;
  Bytes high_{};
  std::uint8_t signs_ = 0;
};

void enclose(PadBox& box, const PadBox& part) {
  for (std::size_t e = 0; e < box.low.size(); ++e) {
    box.low[e] = std::min(box.low[e], part.low[e]);
    box.high[e] = std::max(box.high[e], part.high[e]);
  }
  box.scale_low = std::min(box.scale_low, part.scale_low);
  box.scale_high = std::max(box.scale_high, part.scale_high);
  box.signs |= part.signs;
}

}  // namespace

PadBytes pad_bytes(const QuantisedPad& pad, float scale_length, float convexity) {
  PadBytes bytes;
  std::transform(pad.element.begin(), pad.element.end(), bytes.element.begin(), pad_byte);
  bytes.scale = scale_byte(scale_length);
  bytes.sign = sign_byte(convexity);
  return bytes;
}

std::vector<std::uint32_t> pad_order(std::span<const PadBytes> pads, int elements, double scale_share) {
  std::vector<std::uint32_t> order(pads.size());
  std::iota(order.begin(), order.end(), 0u);
  const auto others =
      std::stable_partition(order.begin(), order.end(), [&](std::uint32_t i) { return pads[i].sign == sign_byte(1); });
  Splitter(pads, elements, scale_share).split_by_sign(order, std::size_t(others - order.begin()), kNodePads);
  return order;
}

PadIndex boxed(std::vector<std::uint32_t> order, std::span<const PadBytes> pads) {
  PadIndex index;
  index.order = std::move(order);
  for (std::size_t first = 0; first < pads.size(); first += kIndexFanOut) {
    BoxOfPads box;
    const std::size_t end = std::min<std::size_t>(pads.size(), first + kIndexFanOut);
    for (std::size_t i = first; i < end; ++i) box.enclose(pads[index.order[i]]);
    index.blocks.push_back(box.box());
  }
  index.nodes.resize((index.blocks.size() + kIndexFanOut - 1) / kIndexFanOut);
  for (std::size_t b = 0; b < index.blocks.size(); ++b) enclose(index.nodes[b / kIndexFanOut], index.blocks[b]);
  return index;
}

PadIndex make_pad_index(std::span<const PadBytes> pads, int elements, double scale_share) {
  return boxed(pad_order(pads, elements, scale_share), pads);
}

}  // namespace tessera
