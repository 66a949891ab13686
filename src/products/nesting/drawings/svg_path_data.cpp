#include "products/nesting/drawings/svg_path_data.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>
#include <string>

#include "core/base/count_text.h"
#include "core/base/error.h"
#include "core/base/too_many.h"
#include "products/nesting/drawings/nest_contours.h"
#include "text/utf8_text.h"

namespace tessera {
namespace {

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

/// Reads numbers, flags and letters one after the other.
class Scanner {
 public:
  explicit Scanner(std::string_view text) : text_(text), rest_(text) {}

  bool at_end() {
    skip();
    return rest_.empty();
  }
  bool at_number() {
    skip();
    return !rest_.empty() &&
           (rest_[0] == '-' || rest_[0] == '+' || rest_[0] == '.' || (rest_[0] >= '0' && rest_[0] <= '9'));
  }
  char letter() {
    skip();
    if (rest_.empty() || !is_letter(rest_[0])) fail();
    const char c = rest_[0];
    rest_.remove_prefix(1);
    return c;
  }
  double number() {
    skip();
    if (!rest_.empty() && rest_[0] == '+') rest_.remove_prefix(1);
    double value = 0;
    const auto [end, error] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), value);
    if (error != std::errc() || !std::isfinite(value)) fail();
    rest_.remove_prefix(std::size_t(end - rest_.data()));
    return value;
  }
  bool flag() {
    skip();
    if (rest_.empty() || (rest_[0] != '0' && rest_[0] != '1')) fail();
    const bool set = rest_[0] == '1';
    rest_.remove_prefix(1);
    return set;
  }
  [[noreturn]] void fail() const {
    const std::string near(rest_.substr(0, 20));
    throw InputError("found \"" + printable_utf8(near.empty() ? std::string(text_.substr(0, 20)) : near) +
                     "\", which cannot be read there");
  }

 private:
  void skip() {
    while (!rest_.empty() && (is_space(rest_[0]) || rest_[0] == ',')) rest_.remove_prefix(1);
  }

  std::string_view text_, rest_;
};

class PathReader {
 public:
  PathReader(std::string_view data, const SvgMatrix& matrix) : in_(data), matrix_(matrix) {
    flatness_ = kFlatness_mm / std::max(matrix.scale(), 1e-12);
  }

  std::vector<SvgSubpath> read() {
    char command = 0;
    while (!in_.at_end()) {
      if (!in_.at_number()) {
        command = in_.letter();
        if (lists_.empty() && upper(command) != 'M') in_.fail();
        if (upper(command) == 'Z') {
          close();
          last_ = 'Z';
          continue;
        }
        if (!in_.at_number()) in_.fail();
      } else if (command == 0 || upper(command) == 'Z') {
        in_.fail();
      }
      draw(command);
      last_ = upper(command);
      if (command == 'M') command = 'L';
      if (command == 'm') command = 'l';
      if (points_ > kMostDrawingPoints) throw InputError(too_many(kMostDrawingPoints, "points"));
    }
    for (SvgSubpath& path : lists_) {
      for (NestPoint& p : path.points) p = matrix_.apply(p);
    }
    return std::move(lists_);
  }

 private:
  static char upper(char c) { return c >= 'a' ? char(c - 'a' + 'A') : c; }

  NestPoint point(bool relative) {
    const double x = in_.number(), y = in_.number();
    return relative ? at_ + NestPoint{x, y} : NestPoint{x, y};
  }

  void begin(NestPoint p) {
    lists_.push_back({{p}, false});
    at_ = first_ = p;
    ++points_;
  }

  NestRing& ring() {
    if (lists_.back().closed) lists_.push_back({{first_}, false});  // after Z without M
    return lists_.back().points;
  }

  void close() {
    lists_.back().closed = true;
    at_ = first_;
  }

  void line_to(NestPoint p) {
    ring().push_back(p);
    at_ = p;
    ++points_;
  }

  void cubic_to(NestPoint b, NestPoint c, NestPoint d) {
    NestRing& points = ring();
    const std::size_t before = points.size();
    add_cubic(b, c, d, flatness_, points);
    points_ += points.size() - before;
    control_ = c;
    at_ = d;
  }

  void quadratic_to(NestPoint b, NestPoint c) {
    const NestPoint from = at_;
    cubic_to(from + (b - from) * (2.0 / 3), c + (b - c) * (2.0 / 3), c);
    control_ = b;
  }

  /// SVG 1.1, appendix F.6.
  void arc_to(double rx, double ry, double angle_deg, bool large, bool sweep, NestPoint to) {
    rx = std::abs(rx);
    ry = std::abs(ry);
    if (!(rx > 0 && ry > 0)) return line_to(to);
    if (to == at_) return;
    const NestTurn turn = turn_of(angle_deg);
    const NestTurn back{turn.cosine, -turn.sine};
    const NestPoint half = back.apply((at_ - to) * 0.5);
    const double size = half.x * half.x / (rx * rx) + half.y * half.y / (ry * ry);
    if (size > 1) {
      rx *= std::sqrt(size);
      ry *= std::sqrt(size);
    }
    const double k = std::sqrt(std::max(0.0, 1 / std::max(size, 1e-300) - 1)) * (large == sweep ? -1 : 1);
    const NestPoint centre_back = size > 1 ? NestPoint{} : NestPoint{k * rx * half.y / ry, -k * ry * half.x / rx};
    const NestPoint centre = turn.apply(centre_back) + (at_ + to) * 0.5;
    const double first = std::atan2((half.y - centre_back.y) / ry, (half.x - centre_back.x) / rx);
    double last = std::atan2((-half.y - centre_back.y) / ry, (-half.x - centre_back.x) / rx);
    if (sweep && last < first) last += 2 * std::numbers::pi;
    if (!sweep && last > first) last -= 2 * std::numbers::pi;
    NestRing& points = ring();
    const std::size_t before = points.size();
    const double scale = std::max(matrix_.scale(), 1e-12);
    NestRing in_mm;  // steps are by the flatness in mm
    add_arc(centre * scale, turn.apply({rx * scale, 0}), turn.apply({0, ry * scale}), first, last, in_mm);
    for (const NestPoint p : in_mm) points.push_back(p * (1 / scale));
    points.back() = to;
    points_ += points.size() - before;
    at_ = to;
  }

  void draw(char command) {
    const bool relative = command >= 'a';
    switch (upper(command)) {
      case 'M': return begin(point(relative));
      case 'L': return line_to(point(relative));
      case 'H': return line_to({in_.number() + (relative ? at_.x : 0), at_.y});
      case 'V': return line_to({at_.x, in_.number() + (relative ? at_.y : 0)});
      case 'C': {
        const NestPoint b = point(relative), c = point(relative);
        return cubic_to(b, c, point(relative));
      }
      case 'S': {
        const NestPoint b = last_ == 'C' || last_ == 'S' ? at_ * 2 - control_ : at_, c = point(relative);
        return cubic_to(b, c, point(relative));
      }
      case 'Q': {
        const NestPoint b = point(relative);
        return quadratic_to(b, point(relative));
      }
      case 'T': {
        const NestPoint b = last_ == 'Q' || last_ == 'T' ? at_ * 2 - control_ : at_;
        return quadratic_to(b, point(relative));
      }
      case 'A': {
        const double rx = in_.number(), ry = in_.number(), angle_deg = in_.number();
        const bool large = in_.flag(), sweep = in_.flag();
        if (!(std::abs(angle_deg) < 1e6)) in_.fail();
        return arc_to(rx, ry, angle_deg, large, sweep, point(relative));
      }
      default: in_.fail();
    }
  }

  Scanner in_;
  SvgMatrix matrix_;
  double flatness_;
  std::vector<SvgSubpath> lists_;
  NestPoint at_, first_, control_;
  char last_ = 0;
  std::size_t points_ = 0;
};

SvgMatrix one_transform(std::string_view name, const std::vector<double>& v) {
  const std::size_t n = v.size();
  if (name == "matrix" && n == 6) return {v[0], v[1], v[2], v[3], v[4], v[5]};
  if (name == "translate" && (n == 1 || n == 2)) return {1, 0, 0, 1, v[0], n == 2 ? v[1] : 0};
  if (name == "scale" && (n == 1 || n == 2)) return {v[0], 0, 0, n == 2 ? v[1] : v[0], 0, 0};
  if (name == "rotate" && (n == 1 || n == 3) && std::abs(v[0]) < 1e6) {
    const NestTurn t = turn_of(v[0]);
    const SvgMatrix turn{t.cosine, t.sine, -t.sine, t.cosine, 0, 0};
    if (n == 1) return turn;
    return SvgMatrix{1, 0, 0, 1, v[1], v[2]}.after(turn).after({1, 0, 0, 1, -v[1], -v[2]});
  }
  if (name == "skewX" && n == 1) return {1, 0, std::tan(v[0] * std::numbers::pi / 180), 1, 0, 0};
  if (name == "skewY" && n == 1) return {1, std::tan(v[0] * std::numbers::pi / 180), 0, 1, 0, 0};
  throw InputError("transform: found " + printable_utf8(std::string(name.substr(0, 20))) + " of " +
                   count_text(n, "number") + ", allowed: SVG's matrix, translate, scale, rotate, skewX, skewY");
}

}  // namespace

SvgMatrix SvgMatrix::after(const SvgMatrix& o) const {
  return {a * o.a + c * o.b, b * o.a + d * o.b,     a * o.c + c * o.d,
          b * o.c + d * o.d, a * o.e + c * o.f + e, b * o.e + d * o.f + f};
}

double SvgMatrix::scale() const { return std::max(std::sqrt(a * a + b * b), std::sqrt(c * c + d * d)); }

SvgMatrix svg_transform(std::string_view text) {
  SvgMatrix all;
  for (;;) {
    while (!text.empty() && (is_space(text[0]) || text[0] == ',')) text.remove_prefix(1);
    if (text.empty()) return all;
    const std::size_t open = text.find('('), close = text.find(')');
    if (open == std::string_view::npos || close == std::string_view::npos || close < open)
      throw InputError("transform: found \"" + printable_utf8(std::string(text.substr(0, 20))) + "\", allowed: SVG's");
    std::string_view name = text.substr(0, open);
    while (!name.empty() && is_space(name.back())) name.remove_suffix(1);
    all = all.after(one_transform(name, svg_numbers(text.substr(open + 1, close - open - 1))));
    text.remove_prefix(close + 1);
  }
}

std::vector<SvgSubpath> svg_subpaths(std::string_view data, const SvgMatrix& mm_from_path) {
  return PathReader(data, mm_from_path).read();
}

std::vector<double> svg_numbers(std::string_view text) {
  Scanner in(text);
  std::vector<double> numbers;
  while (!in.at_end()) {
    numbers.push_back(in.number());
    if (numbers.size() > 2 * kMostContourPoints) throw InputError(too_many(2 * kMostContourPoints, "numbers"));
  }
  return numbers;
}

}  // namespace tessera
