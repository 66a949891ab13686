#include "core/geometry/bit_grid.h"

#include <algorithm>
#include <bit>
#include <cstring>

namespace tessera {
namespace {

constexpr std::uint64_t kAllBits = ~std::uint64_t(0);

/// Extends every run of nodes by one at both ends.
void widen(BitGrid& set) {
  const int last = set.words() - 1;
  const std::uint64_t within = kAllBits >> (63 & -set.width());
  for (int y = 0; y < set.height(); ++y) {
    std::uint64_t* row = set.row(y);
    std::uint64_t before = 0;
    for (int k = 0; k <= last; ++k) {
      const std::uint64_t here = row[k];
      const std::uint64_t after = k < last ? row[k + 1] : 0;
      row[k] = here | here << 1 | before >> 63 | here >> 1 | after << 63;
      before = here;
    }
    row[last] &= within;
  }
}

/// Adds the rows of `set`, moved by `down` rows.
void add_moved(BitGrid& sum, const BitGrid& set, int down) {
  const int begin = std::max(0, down);
  const int end = std::min(sum.height(), sum.height() + down);
  for (int y = begin; y < end; ++y) {
    const std::uint64_t* from = set.row(y - down);
    std::uint64_t* to = sum.row(y);
    for (int k = 0; k < sum.words(); ++k) to[k] |= from[k];
  }
}

/// Calls f(k, bits) for the words of a row that hold nodes [x0, x1), with the bits of these.
template <class F>
void each_word_of_run(int x0, int x1, F f) {
  for (int x = x0; x < x1;) {
    const int end = std::min(x1, (x | 63) + 1);
    f(x >> 6, kAllBits >> (64 - (end - x)) << (x & 63));
    x = end;
  }
}

/// The bits of eight bytes that are 0 or 1; the first byte gives the lowest bit.
std::uint64_t bits_of_bytes(const std::uint8_t* byte) {
  static_assert(std::endian::native == std::endian::little);
  std::uint64_t bytes;
  std::memcpy(&bytes, byte, sizeof bytes);
  return bytes * 0x0102040810204080ull >> 56;
}

/// One bit for each of `count` values, at most 64. Works in two steps, as the compiler vectorises the first one.
std::uint64_t bits_above(const float* value, int count, float threshold) {
  std::uint8_t above[64] = {};
  for (int i = 0; i < count; ++i) above[i] = value[i] > threshold;
  std::uint64_t bits = 0;
  for (int i = 0; i < 64; i += 8) bits |= bits_of_bytes(above + i) << i;
  return bits;
}

}  // namespace

BitGrid::BitGrid(int width, int height)
    : width_(width),
      height_(height),
      words_((width + 63) / 64),
      bits_(std::size_t(words_) * height, 0) {}

void BitGrid::set_run(int y, int x0, int x1) {
  std::uint64_t* words = row(y);
  each_word_of_run(x0, x1, [&](int k, std::uint64_t run) { words[k] |= run; });
}

void BitGrid::set(const Window& window) {
  for (int y = window.y0; y < window.y1; ++y) set_run(y, window.x0, window.x1);
}

bool BitGrid::any(const Window& window) const {
  std::uint64_t found = 0;
  for (int y = window.y0; y < window.y1; ++y) {
    const std::uint64_t* words = row(y);
    each_word_of_run(window.x0, window.x1, [&](int k, std::uint64_t run) { found |= words[k] & run; });
  }
  return found != 0;
}

BitGrid nodes_above(const Grid<float>& field, const Window& window, float threshold) {
  BitGrid above(window.width(), window.height());
  for (int y = 0; y < above.height(); ++y) {
    const float* value = field.row(window.y0 + y) + window.x0;
    for (int x = 0; x < above.width(); x += 64) {
      above.row(y)[x >> 6] = bits_above(value + x, std::min(64, above.width() - x), threshold);
    }
  }
  return above;
}

BitGrid dilated_by_disc(const BitGrid& set, float squared_radius) {
  const auto within = [&](int dx, int dy) { return float(dx * dx + dy * dy) <= squared_radius; };
  int dy = 0;
  while (within(0, dy + 1)) ++dy;
  BitGrid dilated(set.width(), set.height());
  if (set.words() == 0) return dilated;
  // The disc's rows from its rim to its middle: each at least as wide as the one before.
  BitGrid widened = set;
  for (int half_width = 0; dy >= 0; --dy) {
    for (; within(half_width + 1, dy); ++half_width) widen(widened);
    add_moved(dilated, widened, dy);
    if (dy > 0) add_moved(dilated, widened, -dy);
  }
  return dilated;
}

}  // namespace tessera
