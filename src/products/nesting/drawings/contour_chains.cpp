#include "products/nesting/drawings/contour_chains.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <utility>

namespace tessera {
namespace {

struct End {
  std::size_t line = 0;
  bool last = false;
};

/// The free ends of lines, by cells of the plane.
class Ends {
 public:
  Ends(const std::vector<NestRing>& lines, double reach) : lines_(lines), reach_(reach), used_(lines.size(), false) {
    for (std::size_t i = 0; i < lines.size(); ++i) {
      cells_[cell(lines[i].front())].ends.push_back({i, false});
      cells_[cell(lines[i].back())].ends.push_back({i, true});
    }
  }

  bool is_used(std::size_t line) const { return used_[line]; }
  void use(std::size_t line) { used_[line] = true; }

  /// The end of an unused line at that place, the first by number.
  bool find(NestPoint p, End& found) {
    const auto [x, y] = cell(p);
    bool any = false;
    for (std::int64_t dy = -1; dy <= 1; ++dy) {
      for (std::int64_t dx = -1; dx <= 1; ++dx) {
        const auto at = cells_.find({x + dx, y + dy});
        if (at == cells_.end()) continue;
        Cell& ends = at->second;
        while (ends.first < ends.ends.size() && used_[ends.ends[ends.first].line]) ++ends.first;
        for (std::size_t i = ends.first; i < ends.ends.size(); ++i) {
          const End& end = ends.ends[i];
          const NestRing& line = lines_[end.line];
          if (used_[end.line] || (any && end.line >= found.line)) continue;
          if (norm((end.last ? line.back() : line.front()) - p) > reach_) continue;
          found = end;
          any = true;
          break;
        }
      }
    }
    return any;
  }

 private:
  using Place = std::pair<std::int64_t, std::int64_t>;
  struct Cell {
    std::vector<End> ends;
    std::size_t first = 0;  // all before are used
  };
  Place cell(NestPoint p) const {
    constexpr double kMost = 1e15;
    const auto of = [&](double x) { return std::int64_t(std::floor(std::clamp(x / reach_, -kMost, kMost))); };
    return {of(p.x), of(p.y)};
  }

  const std::vector<NestRing>& lines_;
  double reach_;
  std::vector<bool> used_;
  std::map<Place, Cell> cells_;
};

/// Of each line whether there is none like it before, in either direction.
std::vector<bool> first_ones(const std::vector<NestRing>& lines) {
  const auto less = [](const NestRing& a, const NestRing& b) {
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end(), [](NestPoint p, NestPoint q) {
      return p.x < q.x || (p.x == q.x && p.y < q.y);
    });
  };
  std::set<NestRing, decltype(less)> seen(less);
  std::vector<bool> first;
  for (const NestRing& line : lines) {
    const NestRing back(line.rbegin(), line.rend());
    first.push_back(seen.insert(less(back, line) ? back : line).second);
  }
  return first;
}

bool encloses_something(const NestRing& ring) {
  if (ring.size() < 3) return false;
  const NestBox box = box_of(ring);
  const double longest = std::max(box.width(), box.height());
  // A bow tie of equal halves has no signed area: it is for check_contour to refuse.
  return std::abs(signed_area(ring)) > 1e-9 * longest * longest || crosses_itself(ring);
}

}  // namespace

std::vector<JoinedContour> joined_contours(const std::vector<NestRing>& lines, double reach, int& open) {
  std::vector<JoinedContour> contours;
  Ends ends(lines, reach);
  const std::vector<bool> first = first_ones(lines);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (!first[i]) ends.use(i);
  }
  const auto closes = [&](const NestRing& ring) {
    return ring.size() > 2 && norm(ring.front() - ring.back()) <= reach;
  };
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (ends.is_used(i)) continue;
    ends.use(i);
    NestRing chain = lines[i];
    std::vector<JoinedLine> parts = {{i, false}};
    End next;
    while (!closes(chain) && ends.find(chain.back(), next)) {
      ends.use(next.line);
      parts.push_back({next.line, next.last});
      NestRing line = lines[next.line];
      if (next.last) std::reverse(line.begin(), line.end());
      chain.insert(chain.end(), line.begin() + 1, line.end());
    }
    const bool closed = closes(chain);
    if (closed) chain.pop_back();
    if (closed && encloses_something(chain))
      contours.push_back({std::move(chain), std::move(parts)});
    else
      ++open;
  }
  return contours;
}

}  // namespace tessera
