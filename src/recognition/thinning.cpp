#include "recognition/thinning.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "recognition/pixel.h"

namespace tessera {
namespace {

/// The eight neighbours in the paper's order, P2 to P9: clockwise from the one above.
constexpr std::array<Pixel, 8> kAround{{{0, -1}, {1, -1}, {1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}}};

std::array<bool, 8> neighbours(const Grid<std::uint8_t>& image, Pixel p) {
  std::array<bool, 8> set{};
  for (std::size_t k = 0; k < 8; ++k) {
    const int x = p.x + kAround[k].x, y = p.y + kAround[k].y;
    set[k] = image.bounds().contains(x, y) && image(x, y);
  }
  return set;
}

int count_of(const std::array<bool, 8>& set) {
  int count = 0;
  for (const bool is_set : set) count += is_set;
  return count;
}

/// A(P1) of the paper: how often a clear neighbour is followed by a set one.
int rises(const std::array<bool, 8>& set) {
  int count = 0;
  for (std::size_t k = 0; k < 8; ++k) count += !set[k] && set[(k + 1) % 8];
  return count;
}

/// The number of connected parts of the set neighbours; corners connect (Yokoi's connectivity number).
int connected_parts(const std::array<bool, 8>& set) {
  int parts = 0;
  for (std::size_t k = 0; k < 8; k += 2) parts += !set[k] && (set[(k + 1) % 8] || set[(k + 2) % 8]);
  return parts;
}

/// Whether the first or second half of an iteration takes the pixel away.
bool is_taken(const std::array<bool, 8>& set, bool first_half) {
  const int count = count_of(set);
  if (count < 2 || count > 6 || rises(set) != 1) return false;
  const bool up = set[0], right = set[2], down = set[4], left = set[6];
  return first_half ? !(up && right && down) && !(right && down && left)
                    : !(up && right && left) && !(up && down && left);
}

/// The pixels that may be taken, which lie beside a clear one. All others have eight set neighbours.
class Border {
 public:
  explicit Border(const Grid<std::uint8_t>& image) : listed_(image.width(), image.height(), 0) {
    for (int y = 0; y < image.height(); ++y) {
      for (int x = 0; x < image.width(); ++x) {
        if (image(x, y) && count_of(neighbours(image, {x, y})) < 8) add({x, y});
      }
    }
  }

  /// One half of an iteration. Returns whether any pixel was taken.
  bool take_half(Grid<std::uint8_t>& image, bool first_half) {
    std::vector<Pixel> taken, left;
    for (const Pixel p : pixels_) (is_taken(neighbours(image, p), first_half) ? taken : left).push_back(p);
    pixels_ = std::move(left);
    for (const Pixel p : taken) image(p.x, p.y) = 0;
    for (const Pixel p : taken) add_around(image, p);
    return !taken.empty();
  }

  /// The pixels, row by row.
  std::vector<Pixel> sorted_pixels() const {
    std::vector<Pixel> sorted = pixels_;
    std::sort(sorted.begin(), sorted.end(),
              [](const Pixel& a, const Pixel& b) { return a.y != b.y ? a.y < b.y : a.x < b.x; });
    return sorted;
  }

 private:
  void add(Pixel p) {
    listed_(p.x, p.y) = 1;
    pixels_.push_back(p);
  }
  void add_around(const Grid<std::uint8_t>& image, Pixel p) {
    for (const Pixel& step : kAround) {
      const Pixel q{p.x + step.x, p.y + step.y};
      if (image.bounds().contains(q.x, q.y) && image(q.x, q.y) && !listed_(q.x, q.y)) add(q);
    }
  }

  Grid<std::uint8_t> listed_;
  std::vector<Pixel> pixels_;
};

/// Removes stairs two pixels wide, which the method leaves. One pixel after the other is taken, so that lines stay
/// connected.
void take_stairs(Grid<std::uint8_t>& image, const std::vector<Pixel>& pixels) {
  for (const Pixel p : pixels) {
    const std::array<bool, 8> set = neighbours(image, p);
    if (count_of(set) >= 2 && connected_parts(set) == 1) image(p.x, p.y) = 0;
  }
}

}  // namespace

Grid<std::uint8_t> thinned(const Grid<std::uint8_t>& filled) {
  Grid<std::uint8_t> image = filled;
  Border border(image);
  for (bool taken = true; taken;) {
    taken = border.take_half(image, true);
    taken = border.take_half(image, false) || taken;
  }
  take_stairs(image, border.sorted_pixels());
  return image;
}

}  // namespace tessera
