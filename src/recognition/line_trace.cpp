#include "recognition/line_trace.h"

#include <algorithm>
#include <array>
#include <utility>

#include "core/geometry/polygon.h"
#include "recognition/pixel.h"

namespace tessera {
namespace {

/// Smoothing that removes the stairs of pixels.
constexpr float kSmoothing_px = 1.5f;
constexpr float kShortest_px = 3;
constexpr int kNone = -1;

Vec2 middle_of(Pixel p) { return {float(p.x) + 0.5f, float(p.y) + 0.5f}; }

/// Adjacent pixels where lines meet, as one place.
struct Junction {
  Vec2 sum;
  int pixels = 0;
  float width_px = 0;

  Vec2 middle() const { return sum * (1 / float(pixels)); }
};

/// A line between two junctions; kNone stands for a free end.
struct Branch {
  std::vector<Vec2> points;
  int from = kNone;
  int to = kNone;
  bool closed = false;

  float length() const { return length_of({points, closed}); }
  void turn_round() {
    std::reverse(points.begin(), points.end());
    std::swap(from, to);
  }
};

class LineTrace {
 public:
  LineTrace(const Grid<std::uint8_t>& thin, const Grid<float>& half_width_px)
      : thin_(thin),
        half_width_px_(half_width_px),
        junction_of_(thin.width(), thin.height(), kNone),
        visited_(thin.width(), thin.height(), 0) {
    find_junctions();
    find_branches();
    drop_spurs();
    join_branches();
  }

  const std::vector<Branch>& branches() const { return branches_; }

 private:
  template <class Take>
  void for_each_neighbour(Pixel p, Take take) const {
    for (int y = std::max(p.y - 1, 0); y <= std::min(p.y + 1, thin_.height() - 1); ++y) {
      for (int x = std::max(p.x - 1, 0); x <= std::min(p.x + 1, thin_.width() - 1); ++x) {
        if ((x != p.x || y != p.y) && thin_(x, y)) take(Pixel{x, y});
      }
    }
  }
  template <class Take>
  void for_each_pixel(Take take) const {
    for (int y = 0; y < thin_.height(); ++y) {
      for (int x = 0; x < thin_.width(); ++x) {
        if (thin_(x, y)) take(Pixel{x, y});
      }
    }
  }

  bool meets_lines(Pixel p) const {
    int count = 0;
    for_each_neighbour(p, [&](Pixel) { ++count; });
    return count >= 3;
  }

  void find_junctions() {
    for_each_pixel([&](Pixel first) {
      if (junction_of_(first.x, first.y) != kNone || !meets_lines(first)) return;
      const int number = int(junctions_.size());
      Junction junction;
      std::vector<Pixel> open{first};
      junction_of_(first.x, first.y) = number;
      while (!open.empty()) {
        const Pixel p = open.back();
        open.pop_back();
        junction.sum = junction.sum + middle_of(p);
        ++junction.pixels;
        junction.width_px = std::max(junction.width_px, 2 * half_width_px_(p.x, p.y));
        for_each_neighbour(p, [&](Pixel q) {
          if (junction_of_(q.x, q.y) != kNone || !meets_lines(q)) return;
          junction_of_(q.x, q.y) = number;
          open.push_back(q);
        });
      }
      junctions_.push_back(junction);
    });
  }

  bool is_on_branch(Pixel p) const { return junction_of_(p.x, p.y) == kNone; }

  /// Finds branches that end somewhere, then lines that return to their start.
  void find_branches() {
    for_each_pixel([&](Pixel p) {
      int on_branch = 0;
      for_each_neighbour(p, [&](Pixel q) { on_branch += is_on_branch(q); });
      if (is_on_branch(p) && !visited_(p.x, p.y) && on_branch < 2) add_branch(p, false);
    });
    for_each_pixel([&](Pixel p) {
      if (is_on_branch(p) && !visited_(p.x, p.y)) add_branch(p, true);
    });
  }

  void add_branch(Pixel first, bool closed) {
    Branch branch;
    branch.closed = closed;
    Pixel last = first;
    for (bool goes_on = true; goes_on;) {
      visited_(last.x, last.y) = 1;
      branch.points.push_back(middle_of(last));
      goes_on = false;
      Pixel next{};
      for_each_neighbour(last, [&](Pixel q) {
        if (goes_on || visited_(q.x, q.y) || !is_on_branch(q)) return;
        goes_on = true;
        next = q;
      });
      if (goes_on) last = next;
    }
    if (!closed) add_ends(first, last, branch);
    branches_.push_back(std::move(branch));
  }

  void add_ends(Pixel first, Pixel last, Branch& branch) const {
    const std::vector<int> at_first = junctions_at(first);
    const std::vector<int> at_last = junctions_at(last);
    if (!at_first.empty()) branch.from = at_first.front();
    if (branch.points.size() > 1) {
      if (!at_last.empty()) branch.to = at_last.front();
    } else if (at_first.size() > 1) {
      branch.to = at_first.back();
    }
    if (branch.from != kNone)
      branch.points.insert(branch.points.begin(), junctions_[std::size_t(branch.from)].middle());
    if (branch.to != kNone) branch.points.push_back(junctions_[std::size_t(branch.to)].middle());
  }

  std::vector<int> junctions_at(Pixel p) const {
    std::vector<int> found;
    for_each_neighbour(p, [&](Pixel q) {
      if (!is_on_branch(q)) found.push_back(junction_of_(q.x, q.y));
    });
    return found;
  }

  bool is_spur(const Branch& branch) const {
    if (branch.closed || (branch.from == kNone && branch.to == kNone)) return false;
    if (branch.from != kNone && branch.to != kNone && branch.from != branch.to) return false;
    const int at = branch.from != kNone ? branch.from : branch.to;
    return branch.length() < junctions_[std::size_t(at)].width_px;
  }

  void drop_spurs() {
    std::erase_if(branches_, [&](const Branch& branch) { return is_spur(branch); });
  }

  /// Joins branches at junctions where only two are left.
  void join_branches() {
    for (int number = 0; number < int(junctions_.size()); ++number) {
      std::vector<std::size_t> ends;
      for (std::size_t k = 0; k < branches_.size(); ++k) {
        if (branches_[k].from == number) ends.push_back(k);
        if (branches_[k].to == number) ends.push_back(k);
      }
      if (ends.size() == 2) join(number, ends[0], ends[1]);
    }
  }

  void join(int number, std::size_t first, std::size_t second) {
    Branch& branch = branches_[first];
    if (first == second) {
      branch.points.pop_back();
      branch.closed = true;
      branch.from = branch.to = kNone;
      return;
    }
    Branch& other = branches_[second];
    if (branch.to != number) branch.turn_round();
    if (other.from != number) other.turn_round();
    branch.points.insert(branch.points.end(), other.points.begin() + 1, other.points.end());
    branch.to = other.to;
    branches_.erase(branches_.begin() + std::ptrdiff_t(second));
  }

  const Grid<std::uint8_t>& thin_;
  const Grid<float>& half_width_px_;
  Grid<int> junction_of_;
  Grid<std::uint8_t> visited_;
  std::vector<Junction> junctions_;
  std::vector<Branch> branches_;
};

Curve curve_of(const Branch& branch) {
  Curve curve{branch.points, branch.closed};
  if (curve.closed && signed_area(curve.points) < 0) std::reverse(curve.points.begin(), curve.points.end());
  const int count = std::max(8, int(length_of(curve)));
  return smoothed(resampled(curve, count), kSmoothing_px);
}

}  // namespace

std::vector<Curve> traced_lines(const Grid<std::uint8_t>& thin, const Grid<float>& half_width_px) {
  std::vector<Curve> curves;
  const LineTrace trace(thin, half_width_px);
  for (const Branch& branch : trace.branches()) {
    if (branch.points.size() >= 2 && branch.length() >= kShortest_px) curves.push_back(curve_of(branch));
  }
  return curves;
}

}  // namespace tessera
