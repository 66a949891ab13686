#include "core/pad/pad_index.h"

#include <algorithm>

#include "core/base/rank_pool.h"

namespace tessera {
namespace {

constexpr std::size_t kNodePads = std::size_t(kIndexFanOut) * kIndexFanOut;

/// The rows of a PAD's bytes: its elements, then its scale.
constexpr std::size_t kScaleRow = kMaxPadElements;
constexpr std::size_t kRows = kMaxPadElements + 1;

/// A PAD on its way to its place in the order, with a copy of its bytes: looking them up elsewhere would take most of
/// the time.
struct Entry {
  std::array<std::uint8_t, kRows> row;
  std::uint32_t place;
};

/// Branches with more PADs than this are split on two threads.
constexpr std::size_t kOwnThread = 1 << 16;

/// Sums of the bytes and of their squares, per row.
struct Moments {
  std::array<std::uint64_t, kRows> sum{};
  std::array<std::uint64_t, kRows> squares{};
};

Moments moments_of(std::span<const Entry> entries) {
  constexpr std::size_t kMostSummed = 65536;  // their squares fit into 32 bits
  Moments moments;
  for (; !entries.empty(); entries = entries.subspan(std::min(entries.size(), kMostSummed))) {
    std::array<std::uint32_t, kRows> sum{};
    std::array<std::uint32_t, kRows> squares{};
    for (const Entry& entry : entries.first(std::min(entries.size(), kMostSummed))) {
      for (std::size_t row = 0; row < kRows; ++row) {
        const std::uint32_t byte = entry.row[row];
        sum[row] += byte;
        squares[row] += byte * byte;
      }
    }
    for (std::size_t row = 0; row < kRows; ++row) {
      moments.sum[row] += sum[row];
      moments.squares[row] += squares[row];
    }
  }
  return moments;
}

class Splitter {
 public:
  /// `all`: all PADs by place, the convex ones first. `scratch`: of the same size.
  Splitter(std::span<Entry> all, std::span<Entry> scratch, int elements, double scale_share)
      : all_(all),
        scratch_(scratch),
        elements_(std::size_t(elements)),
        scale_share_(scale_share) {}

  /// Orders PADs so that every whole block, and every whole node, is one branch of the tree.
  void split(std::span<Entry> order) const {
    const std::size_t whole = order.size() > kNodePads ? kNodePads : kIndexFanOut;
    if (order.size() <= whole) return;
    const std::size_t parts = (order.size() + whole - 1) / whole;
    const std::size_t middle = parts / 2 * whole;
    part(order, middle);
    if (order.size() > kOwnThread) {
      run_both([&] { split(order.first(middle)); }, [&] { split(order.subspan(middle)); });
    } else {
      split(order.first(middle));
      split(order.subspan(middle));
    }
  }

  /// The first `convex` PADs are convex. They get a tree of their own, the others (concave, flat) another; one `unit`
  /// in between contains both kinds.
  void split_by_sign(std::span<Entry> order, std::size_t convex, std::size_t unit) const {
    const std::size_t whole = convex / unit * unit;
    const std::size_t mixed_end = std::min(order.size(), whole + unit);
    split(order.first(whole));
    part(order.subspan(convex), mixed_end - convex);
    split(order.subspan(mixed_end));
    if (unit > kIndexFanOut) split_by_sign(order.subspan(whole, mixed_end - whole), convex - whole, kIndexFanOut);
  }

 private:
  /// Partitions the PADs at `middle` by the row that varies most: no PAD before has a larger byte there than one
  /// behind. Both parts keep their order, so PADs with equal bytes are ordered by place.
  void part(std::span<Entry> order, std::size_t middle) const {
    if (middle == 0 || middle >= order.size()) return;
    const std::size_t row = widest_row(order);
    std::array<std::size_t, 256> of_byte{};
    for (const Entry& entry : order) ++of_byte[entry.row[row]];
    std::size_t byte = 0;  // byte of the PAD at `middle`
    std::size_t smaller = 0;
    for (; smaller + of_byte[byte] <= middle; ++byte) smaller += of_byte[byte];
    std::size_t ties = middle - smaller;  // PADs with that byte that come before `middle`

    const std::span<Entry> parted = scratch_.subspan(std::size_t(order.data() - all_.data()), order.size());
    std::size_t before = 0;
    std::size_t behind = middle;
    for (const Entry& entry : order) {
      const bool tie = entry.row[row] == byte && ties > 0;
      ties -= tie;
      std::size_t& next = entry.row[row] < byte || tie ? before : behind;
      parted[next++] = entry;
    }
    std::copy(parted.begin(), parted.end(), order.begin());
  }

  /// The row whose bytes vary most, among the elements in use and the scale.
  std::size_t widest_row(std::span<const Entry> order) const {
    const Moments moments = moments_of(order);
    const auto count = double(order.size());
    const auto variance_of = [&](std::size_t row) {
      const double mean = double(moments.sum[row]) / count;
      return double(moments.squares[row]) / count - mean * mean;
    };
    std::size_t widest = 0;
    double most = -1;
    for (std::size_t row = 0; row < elements_; ++row) {
      const double variance = variance_of(row);
      if (variance > most) {
        most = variance;
        widest = row;
      }
    }
    return variance_of(kScaleRow) * scale_share_ > most ? kScaleRow : widest;
  }

  std::span<Entry> all_;
  std::span<Entry> scratch_;
  std::size_t elements_;
  double scale_share_;
};

/// The bounds of some PADs, with bytes side by side, so that one instruction compares them all.
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
  std::vector<Entry> entries(pads.size());
  for (std::size_t i = 0; i < pads.size(); ++i) {
    std::copy(pads[i].element.begin(), pads[i].element.end(), entries[i].row.begin());
    entries[i].row[kScaleRow] = pads[i].scale;
    entries[i].place = std::uint32_t(i);
  }
  const auto others = std::stable_partition(entries.begin(), entries.end(),
                                            [&](const Entry& entry) { return pads[entry.place].sign == sign_byte(1); });
  std::vector<Entry> scratch(entries.size());
  Splitter(entries, scratch, elements, scale_share)
      .split_by_sign(entries, std::size_t(others - entries.begin()), kNodePads);
  std::vector<std::uint32_t> order(entries.size());
  std::transform(entries.begin(), entries.end(), order.begin(), [](const Entry& entry) { return entry.place; });
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
