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

  /// Finds the end of an unused line that is nearest to that place; of equal ones that of the first line.
  bool find(NestPoint p, End& found) {
    const auto [x, y] = cell(p);
    bool any = false;
    double nearest = reach_;
    for (std::int64_t dy = -1; dy <= 1; ++dy) {
      for (std::int64_t dx = -1; dx <= 1; ++dx) {
        const auto at = cells_.find({x + dx, y + dy});
        if (at == cells_.end()) continue;
        Cell& ends = at->second;
        while (ends.first < ends.ends.size() && used_[ends.ends[ends.first].line]) ++ends.first;
        for (std::size_t i = ends.first; i < ends.ends.size(); ++i) {
          const End& end = ends.ends[i];
          const NestRing& line = lines_[end.line];
          if (used_[end.line]) continue;
          const double distance = norm((end.last ? line.back() : line.front()) - p);
          if (distance > nearest || (any && distance == nearest && end.line >= found.line)) continue;
          found = end;
          nearest = distance;
          any = true;
        }
      }
    }
    return any;
  }

 private:
  using Place = std::pair<std::int64_t, std::int64_t>;
  struct Cell {
    std::vector<End> ends;
    std::size_t first = 0;  // all lines before are used
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

/// Says for each line whether it is the first of its kind: no earlier line has the same points, in either direction.
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
  // A bow tie with equal halves has no signed area; check_contour() refuses it.
  return std::abs(signed_area(ring)) > 1e-9 * longest * longest || crosses_itself(ring);
}

/// The length of the line from point `first` on.
double length_of(const NestRing& line, std::size_t first) {
  double sum = 0;
  for (std::size_t i = first + 1; i < line.size(); ++i) sum += norm(line[i] - line[i - 1]);
  return sum;
}

/// A chain of joined lines.
struct Chain {
  NestRing points;
  std::vector<JoinedLine> lines;
  std::vector<std::size_t> starts;  // of each line, among the points

  void add(const NestRing& line, JoinedLine which) {
    starts.push_back(points.empty() ? 0 : points.size() - 1);
    points.insert(points.end(), line.begin() + (points.empty() ? 0 : 1), line.end());
    lines.push_back(which);
  }
  /// The chain's last line that begins where the chain ends: it and the lines after it are a loop. lines.size() where there
  /// is none. Pieces of a finely divided line that are all shorter than the reach are no loop.
  std::size_t loop(double reach) const {
    for (std::size_t i = lines.size(); i-- > 0;) {
      const bool meets = norm(points[starts[i]] - points.back()) <= reach;
      if (meets && points.size() - starts[i] > 2 && length_of(points, starts[i]) > 4 * reach) return i;
    }
    return lines.size();
  }
  /// Takes the loop that begins with that line off the chain.
  JoinedContour take_from(std::size_t line) {
    const auto at = points.begin() + std::ptrdiff_t(starts[line]);
    JoinedContour loop{NestRing(at, points.end() - 1), {lines.begin() + std::ptrdiff_t(line), lines.end()}};
    points.erase(line == 0 ? at : at + 1, points.end());
    lines.resize(line);
    starts.resize(line);
    return loop;
  }
};

}  // namespace

std::vector<JoinedContour> joined_contours(const std::vector<NestRing>& lines, double reach, int& open) {
  std::vector<JoinedContour> contours;
  Ends ends(lines, reach);
  const std::vector<bool> first = first_ones(lines);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (!first[i]) ends.use(i);
  }
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (ends.is_used(i)) continue;
    ends.use(i);
    Chain chain;
    chain.add(lines[i], {i, false});
    End next;
    while (true) {
      if (const std::size_t loop = chain.loop(reach); loop < chain.lines.size()) {
        JoinedContour contour = chain.take_from(loop);
        if (encloses_something(contour.ring))
          contours.push_back(std::move(contour));
        else
          ++open;
        if (chain.lines.empty()) break;
      }
      if (!ends.find(chain.points.back(), next)) break;
      ends.use(next.line);
      NestRing line = lines[next.line];
      if (next.last) std::reverse(line.begin(), line.end());
      chain.add(line, {next.line, next.last});
    }
    if (!chain.lines.empty()) ++open;
  }
  return contours;
}

}  // namespace tessera
