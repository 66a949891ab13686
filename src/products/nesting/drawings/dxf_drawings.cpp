#include "products/nesting/drawings/dxf_drawings.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>

#include "core/base/error.h"
#include "core/base/split_text.h"
#include "core/base/too_many.h"
#include "products/nesting/drawings/contour_chains.h"
#include "text/utf8_text.h"

namespace tessera {
namespace {

constexpr std::size_t kMostLines = 20'000;

/// A code and its value: two lines of the file.
struct Pair {
  int code = 0;
  std::string_view value;
  int line = 0;
};

class PairReader {
 public:
  PairReader(std::string_view text, const std::string& path) : rest_(text), path_(path) {}

  /// False at the end of the file.
  bool next(Pair& pair) {
    std::string_view code;
    if (!next_line(code) || (trimmed(code).empty() && rest_.empty())) return false;
    pair.line = line_;
    const std::string_view number = trimmed(code);
    const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), pair.code);
    if (error != std::errc() || end != number.data() + number.size())
      fail(line_, "found \"" + std::string(number.substr(0, 20)) + "\", allowed: the number of a group code");
    if (!next_line(pair.value)) fail(line_, "ends within a pair of lines");
    pair.value = trimmed(pair.value);
    return true;
  }

  [[noreturn]] void fail(int line, const std::string& what) const {
    throw InputError(path_ + ": line " + std::to_string(line) + ": " + printable_utf8(what));
  }

 private:
  bool next_line(std::string_view& line) {
    if (rest_.empty()) return false;
    const std::size_t end = std::min(rest_.find('\n'), rest_.size());
    line = rest_.substr(0, end);
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    ++line_;
    return true;
  }

  std::string_view rest_;
  const std::string& path_;
  int line_ = 0;
};

double number_of(const Pair& pair, const PairReader& in) {
  double value = 0;
  const std::string_view text = pair.value.starts_with('+') ? pair.value.substr(1) : pair.value;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || !std::isfinite(value) || std::abs(value) > 1e12)
    in.fail(pair.line + 1,
            "found \"" + std::string(pair.value.substr(0, 20)) + "\", allowed: a number from -1e12 to 1e12");
  return value;
}

/// By $INSUNITS: none, inch, foot, mile, mm, cm, m, km, microinch, mil, yard, angstrom, nm, um, dm, dam, hm, Gm,
/// astronomical unit, light year, parsec.
constexpr std::array<double, 21> kMmOfUnit = {1,
                                              25.4,
                                              304.8,
                                              1609344,
                                              1,
                                              10,
                                              1000,
                                              1e6,
                                              2.54e-5,
                                              0.0254,
                                              914.4,
                                              1e-7,
                                              1e-6,
                                              1e-3,
                                              100,
                                              1e4,
                                              1e5,
                                              1e12,
                                              1.495978707e14,
                                              9.4607304725808e18,
                                              3.0856775814913673e19};

struct Vertex {
  NestPoint at;
  double bulge = 0;  // tangent of a quarter of the arc's angle to the next vertex
};

/// What an entity has, in the order of the file.
struct Entity {
  std::string_view kind;
  std::vector<Vertex> vertices;  // of polylines
  NestPoint from, to;
  double radius = 0, first_deg = 0, last_deg = 0;
  bool closed = false;
  bool mirrored = false;  // its plane is seen from below
  bool in_paper = false;
};

NestPoint at_angle(double radius, double angle_rad) {
  return {radius * std::cos(angle_rad), radius * std::sin(angle_rad)};
}

/// From ring.back() to `to`.
void add_bulge(double bulge, NestPoint to, NestRing& ring) {
  const NestPoint from = ring.back(), chord = to - from;
  if (std::abs(bulge) < 1e-9 || from == to) {
    ring.push_back(to);
    return;
  }
  const double height = (1 - bulge * bulge) / (4 * bulge);  // of the centre above the chord, in chords
  const NestPoint centre = (from + to) * 0.5 + NestPoint{-chord.y, chord.x} * height;
  const NestPoint u = from - centre, v{-u.y, u.x};
  add_arc(centre, u, v, 0, 4 * std::atan(bulge), ring);
  ring.back() = to;
}

[[noreturn]] void fail_points(const std::string& path) {
  throw InputError(path + ": " + too_many(kMostDrawingPoints, "points in a file"));
}

/// Has little more points than `most` where it would have more.
NestRing outline_of(const Entity& entity, double mm, std::size_t most) {
  NestRing ring;
  for (std::size_t i = 0; i < entity.vertices.size() && ring.size() <= most; ++i) {
    const NestPoint at = entity.vertices[i].at * mm;
    if (i == 0)
      ring.push_back(at);
    else
      add_bulge(entity.vertices[i - 1].bulge, at, ring);
  }
  if (entity.closed && !ring.empty()) add_bulge(entity.vertices.back().bulge, ring.front(), ring);
  if (entity.kind == "LINE") ring = {entity.from * mm, entity.to * mm};
  if (entity.kind == "CIRCLE" || entity.kind == "ARC") {
    const double r = entity.radius * mm;
    const bool whole = entity.kind == "CIRCLE";
    double first = whole ? 0 : entity.first_deg * std::numbers::pi / 180,
           last = whole ? 2 * std::numbers::pi : entity.last_deg * std::numbers::pi / 180;
    if (last <= first) last += 2 * std::numbers::pi * std::ceil((first - last) / (2 * std::numbers::pi) + 1e-12);
    const NestPoint centre = entity.from * mm;
    ring = {centre + at_angle(r, first)};
    if (r > 0) add_arc(centre, {r, 0}, {0, r}, first, last, ring);
    if (whole) ring.back() = ring.front();
  }
  if (entity.mirrored) {
    for (NestPoint& p : ring) p.x = -p.x;
  }
  for (NestPoint& p : ring) p.y = -p.y;  // a DXF's y goes up
  return ring;
}

bool is_polyline(std::string_view kind) { return kind == "LWPOLYLINE" || kind == "POLYLINE"; }
bool is_read(std::string_view kind) { return is_polyline(kind) || kind == "LINE" || kind == "CIRCLE" || kind == "ARC"; }

class DxfReader {
 public:
  DxfReader(std::string_view text, const std::string& path) : in_(text, path), path_(path) {}

  void read() {
    Pair pair;
    bool any = false;
    while (in_.next(pair)) {
      any = true;
      if (pair.code == 0 && pair.value == "EOF") break;
      if (pair.code == 0)
        begin(pair);
      else
        value(pair);
    }
    finish();
    if (!any || !saw_section_) throw InputError(path_ + ": not an ASCII DXF file");
  }

  std::vector<NestRing> rings;  // closed where the last point is the first
  int unread = 0;
  bool says_unit = false;

 private:
  void begin(const Pair& pair) {
    if (entity_.kind == "POLYLINE" && pair.value == "VERTEX") {
      if (points_ >= kMostDrawingPoints) fail_points(path_);
      ++points_;
      in_vertex_ = true;
      entity_.vertices.push_back({});
      return;
    }
    if (entity_.kind == "POLYLINE" && pair.value == "SEQEND") return;
    finish();
    if (pair.value == "SECTION") {
      section_ = "?";
      saw_section_ = true;
    } else if (pair.value == "ENDSEC") {
      section_ = {};
    } else if (section_ == "ENTITIES") {
      entity_.kind = pair.value;
      if (!is_read(pair.value)) ++unread;
    }
  }

  void finish() {
    if (is_read(entity_.kind) && !entity_.in_paper) {
      NestRing ring = outline_of(entity_, mm_, kMostDrawingPoints - points_);
      points_ += ring.size();
      if (points_ > kMostDrawingPoints) fail_points(path_);
      if (ring.size() > 1) rings.push_back(std::move(ring));
    }
    entity_ = {};
    in_vertex_ = false;
  }

  void value(const Pair& pair) {
    if (section_ == "?" && pair.code == 2) section_ = pair.value;
    if (section_ == "HEADER") header(pair);
    if (section_ != "ENTITIES" || entity_.kind.empty()) return;
    if (pair.code == 67 && number_of(pair, in_) == 1) entity_.in_paper = true;
    if (pair.code == 230 && !in_vertex_ && number_of(pair, in_) < 0 && entity_.kind != "LINE") entity_.mirrored = true;
    if (is_polyline(entity_.kind))
      polyline_value(pair);
    else if (is_read(entity_.kind))
      simple_value(pair);
  }

  void header(const Pair& pair) {
    if (pair.code == 9) variable_ = pair.value;
    if (variable_ != "$INSUNITS" || pair.code != 70) return;
    const double unit = number_of(pair, in_);
    if (!(unit >= 0 && unit < double(kMmOfUnit.size()) && unit == std::floor(unit)))
      in_.fail(pair.line + 1,
               "$INSUNITS: found " + std::string(pair.value.substr(0, 20)) + ", allowed: a whole number from 0 to 20");
    mm_ = kMmOfUnit[std::size_t(unit)];
    says_unit = unit > 0;
  }

  void polyline_value(const Pair& pair) {
    const bool light = entity_.kind == "LWPOLYLINE";
    if (pair.code == 70 && !in_vertex_) entity_.closed = (int(std::clamp(number_of(pair, in_), 0.0, 1e6)) & 1) != 0;
    if (light && pair.code == 10) {
      if (points_ >= kMostDrawingPoints) fail_points(path_);
      ++points_;
      entity_.vertices.push_back({});
    }
    if ((!light && !in_vertex_) || entity_.vertices.empty()) return;
    Vertex& vertex = entity_.vertices.back();
    if (pair.code == 10) vertex.at.x = number_of(pair, in_);
    if (pair.code == 20) vertex.at.y = number_of(pair, in_);
    if (pair.code == 42) vertex.bulge = number_of(pair, in_);
  }

  void simple_value(const Pair& pair) {
    switch (pair.code) {
      case 10: entity_.from.x = number_of(pair, in_); break;
      case 20: entity_.from.y = number_of(pair, in_); break;
      case 11: entity_.to.x = number_of(pair, in_); break;
      case 21: entity_.to.y = number_of(pair, in_); break;
      case 40: entity_.radius = number_of(pair, in_); break;
      case 50: entity_.first_deg = number_of(pair, in_); break;
      case 51: entity_.last_deg = number_of(pair, in_); break;
      default: break;
    }
  }

  PairReader in_;
  const std::string& path_;
  std::string_view section_, variable_;
  Entity entity_;
  bool in_vertex_ = false;
  bool saw_section_ = false;
  double mm_ = 1;
  std::size_t points_ = 0;
};

}  // namespace

DxfDrawings dxf_drawings(std::string_view text, const std::string& path, const std::string& name) {
  DxfReader reader(text, path);
  reader.read();
  DxfDrawings found;
  found.unread_entities = reader.unread;
  found.says_unit = reader.says_unit;
  if (reader.rings.size() > kMostLines)
    throw InputError(path + ": found " + std::to_string(reader.rings.size()) +
                     " lines and arcs, allowed: " + std::to_string(kMostLines));
  std::vector<NestRing> contours = joined_contours(std::move(reader.rings), kFlatness_mm, found.open_chains);
  if (contours.size() > kMostDrawings) {
    throw InputError(path + ": found " + std::to_string(contours.size()) +
                     " contours, allowed: " + std::to_string(kMostDrawings) + " in a file");
  }
  for (std::size_t i = 0; i < contours.size(); ++i)
    check_contour(contours[i], path + ": contour " + std::to_string(i + 1));
  std::vector<NamedContour> named;
  for (NestRing& contour : contours) named.push_back({name, std::move(contour)});
  found.drawings = drawings_of(std::move(named));
  return found;
}

}  // namespace tessera
