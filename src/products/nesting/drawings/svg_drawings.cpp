#include "products/nesting/drawings/svg_drawings.h"

#include <charconv>
#include <cmath>
#include <memory>
#include <optional>
#include <set>

#include "artwork/svg/xml_tree.h"
#include "core/base/error.h"
#include "core/base/too_many.h"
#include "products/nesting/drawings/svg_path_data.h"
#include "products/nesting/drawings/svg_tree.h"
#include "text/utf8_text.h"

namespace tessera {
namespace {

constexpr double kMm_px = 25.4 / 96;  // CSS
constexpr std::size_t kMostContours = 4'000;
constexpr double kTwoPi = 6.28318530717958647692;

/// Throws InputError where there are more up to here than a file may have.
void check_count(const char* what, std::size_t count, std::size_t allowed) {
  if (count > allowed) throw InputError(too_many(allowed, what + std::string(" in a file")));
}

/// Entities of the document's own are refused, and its defaults do not count: a few bytes of the file could be
/// megabytes in each of many attributes.
std::optional<std::string> plain_attribute(xmlNode* node, const char* name) {
  const xmlAttr* const found = xmlHasNsProp(node, xml(name), nullptr);
  if (!found || found->type != XML_ATTRIBUTE_NODE) return std::nullopt;
  for (const xmlNode* part = found->children; part; part = part->next) {
    if (part->type == XML_ENTITY_REF_NODE)
      throw InputError(std::string(name) + ": found an entity, allowed: what it stands for");
  }
  const std::unique_ptr<xmlChar, FreeXml> value(xmlGetNoNsProp(node, xml(name)));
  return value ? std::optional<std::string>(view(value.get())) : std::nullopt;
}

/// A length with its unit, in px; nothing for percentages and what is no length.
std::optional<double> length_px(std::string_view text) {
  while (!text.empty() && (text.front() == ' ' || text.front() == '+')) text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || !std::isfinite(value)) return std::nullopt;
  const std::string_view unit(end, std::size_t(text.data() + text.size() - end));
  if (unit.empty() || unit == "px") return value;
  if (unit == "mm") return value / kMm_px;
  if (unit == "cm") return value * 10 / kMm_px;
  if (unit == "in") return value * 96;
  if (unit == "pt") return value * 96 / 72;
  if (unit == "pc") return value * 16;
  return std::nullopt;
}

/// Whether the text is a length that names its unit.
bool has_unit(const std::optional<std::string>& text) {
  return text && length_px(*text) && text->find_first_of("mcipx") != std::string::npos;
}

/// Width or height of the page as its attribute says it, px; nothing: it has none, or none that says a length.
std::optional<double> page_side_px(xmlNode* root, const char* name) {
  const std::optional<std::string> text = plain_attribute(root, name);
  const std::optional<double> px = text ? length_px(*text) : std::nullopt;
  return px && *px > 0 ? px : std::nullopt;
}

/// The last two numbers of the viewBox; nothing: there is none.
std::optional<NestPoint> view_box(xmlNode* root, const std::string& path) {
  const std::optional<std::string> box = plain_attribute(root, "viewBox");
  if (!box) return std::nullopt;
  std::vector<double> view;
  try {
    view = svg_numbers(*box);
  } catch (const InputError&) {
  }
  if (view.size() != 4 || !(view[2] > 0 && view[3] > 0))
    throw InputError(path + ": viewBox: found \"" + printable_utf8(box->substr(0, 40)) +
                     "\", allowed: four numbers, the last two above 0");
  return NestPoint{view[2], view[3]};
}

/// mm of the page from user units: width and height against the viewBox, as "xMidYMid meet" or "none" have it; where the
/// page lies does not matter.
SvgMatrix mm_from_user(xmlNode* root, const std::optional<NestPoint>& view) {
  if (!view) return {kMm_px, 0, 0, kMm_px, 0, 0};
  const std::optional<double> width = page_side_px(root, "width"), height = page_side_px(root, "height");
  double scale_x = width ? *width / view->x : height ? *height / view->y : 1;
  double scale_y = height ? *height / view->y : scale_x;
  if (plain_attribute(root, "preserveAspectRatio").value_or("") != "none")
    scale_x = scale_y = std::min(scale_x, scale_y);
  return {scale_x * kMm_px, 0, 0, scale_y * kMm_px, 0, 0};
}

/// What the file says of its unit and its page.
void read_page(xmlNode* root, const std::optional<NestPoint>& view, const SvgMatrix& mm, SvgDrawings& found) {
  const std::optional<double> width = page_side_px(root, "width"), height = page_side_px(root, "height");
  found.says_unit = has_unit(plain_attribute(root, "width")) || has_unit(plain_attribute(root, "height"));
  found.page_width_mm = width ? *width * kMm_px : view ? mm.a * view->x : 0;
  found.page_height_mm = height ? *height * kMm_px : view ? mm.d * view->y : 0;
}

double number_of(xmlNode* node, const char* name) {
  const std::optional<std::string> text = plain_attribute(node, name);
  if (!text) return 0;
  const std::optional<double> value = length_px(*text);
  if (value && std::abs(*value) < 1e9) return *value;
  throw InputError(std::string(name) + ": found \"" + printable_utf8(text->substr(0, 20)) +
                   "\", allowed: a length below 1e9 px, in px, mm, cm, in, pt or pc");
}

std::vector<SvgSubpath> closed(NestRing ring, const SvgMatrix& matrix) {
  for (NestPoint& p : ring) p = matrix.apply(p);
  return {{std::move(ring), true}};
}

std::vector<SvgSubpath> ellipse(double cx, double cy, double rx, double ry, const SvgMatrix& m) {
  if (!(rx > 0 && ry > 0)) return {};
  NestRing ring;
  add_arc(m.apply({cx, cy}), {m.a * rx, m.b * rx}, {m.c * ry, m.d * ry}, 0, kTwoPi, ring);
  return {{std::move(ring), true}};
}

std::vector<SvgSubpath> rectangle(xmlNode* node, const SvgMatrix& m) {
  const double x = number_of(node, "x"), y = number_of(node, "y");
  const double w = number_of(node, "width"), h = number_of(node, "height");
  if (!(w > 0 && h > 0)) return {};
  double rx = number_of(node, "rx"), ry = number_of(node, "ry");
  if (!(rx > 0)) rx = ry;
  if (!(ry > 0)) ry = rx;
  rx = std::min(rx, w / 2);
  ry = std::min(ry, h / 2);
  if (!(rx > 0)) return closed({{x, y}, {x + w, y}, {x + w, y + h}, {x, y + h}}, m);
  NestRing ring;
  const NestPoint u{m.a * rx, m.b * rx}, v{m.c * ry, m.d * ry};
  for (int corner = 0; corner < 4; ++corner) {  // from the lower right one on, y down
    const NestPoint centre{corner == 0 || corner == 3 ? x + w - rx : x + rx, corner < 2 ? y + h - ry : y + ry};
    ring.push_back(m.apply(centre) + (corner == 0 ? u : corner == 1 ? v : corner == 2 ? u * -1 : v * -1));
    add_arc(m.apply(centre), u, v, kTwoPi / 4 * corner, kTwoPi / 4 * (corner + 1), ring);
  }
  return {{std::move(ring), true}};
}

std::vector<SvgSubpath> polygon(xmlNode* node, const SvgMatrix& m, bool is_closed) {
  const std::vector<double> numbers = svg_numbers(plain_attribute(node, "points").value_or(""));
  NestRing ring;
  for (std::size_t i = 0; i + 1 < numbers.size(); i += 2) ring.push_back({numbers[i], numbers[i + 1]});
  if (ring.empty()) return {};
  std::vector<SvgSubpath> one = closed(std::move(ring), m);
  one.front().closed = is_closed;
  return one;
}

std::vector<SvgSubpath> subpaths_of(xmlNode* node, const SvgMatrix& m) {
  const std::string_view name = name_of(node);
  if (name == "path") return svg_subpaths(plain_attribute(node, "d").value_or(""), m);
  if (name == "rect") return rectangle(node, m);
  if (name == "polygon" || name == "polyline") return polygon(node, m, name == "polygon");
  if (name == "line") return {{{{}}, false}};
  if (name == "circle") {
    const double r = number_of(node, "r");
    return ellipse(number_of(node, "cx"), number_of(node, "cy"), r, r, m);
  }
  if (name == "ellipse")
    return ellipse(number_of(node, "cx"), number_of(node, "cy"), number_of(node, "rx"), number_of(node, "ry"), m);
  return {};
}

bool is_hidden(xmlNode* node) {
  static const std::set<std::string_view> kNotDrawn = {"defs",   "clipPath",       "mask",     "pattern", "symbol",
                                                       "marker", "linearGradient", "metadata", "style",   "script",
                                                       "filter", "title",          "desc"};
  if (kNotDrawn.count(name_of(node))) return true;
  if (plain_attribute(node, "display").value_or("") == "none") return true;
  std::string style = plain_attribute(node, "style").value_or("");
  std::erase(style, ' ');
  return style.find("display:none") != std::string::npos;
}

class SvgReader {
 public:
  explicit SvgReader(const std::string& path) : path_(path) {}

  void read(xmlNode* root) {
    try {
      const std::optional<NestPoint> view = view_box(root, path_);
      const SvgMatrix mm = mm_from_user(root, view);
      read_page(root, view, mm, found_);
      children(root, mm);
    } catch (const InputError& error) {
      const std::string text = error.what();
      throw InputError(text.starts_with(path_) ? text : path_ + ": " + text);
    }
  }
  SvgDrawings take() {
    found_.left_out = faults_text(contours_, path_);
    found_.drawings = drawings_of(std::move(contours_));
    if (found_.drawings.size() > kMostDrawings)
      throw InputError(path_ + ": found " + std::to_string(found_.drawings.size()) +
                       " shapes, allowed: " + std::to_string(kMostDrawings));
    return std::move(found_);
  }

 private:
  void children(xmlNode* parent, const SvgMatrix& matrix) {
    for (xmlNode* node = xmlFirstElementChild(parent); node; node = xmlNextElementSibling(node)) {
      if (!is_hidden(node)) element(node, matrix);
    }
  }

  /// Depth is libxml2's own limit: 256.
  void element(xmlNode* node, const SvgMatrix& outer) {
    const std::string_view kind = name_of(node);
    const std::string name = plain_attribute(node, "id").value_or(std::string(kind) + std::to_string(++count_));
    check_name(name, path_ + ": id");
    try {
      const SvgMatrix matrix = outer.after(svg_transform(plain_attribute(node, "transform").value_or("")));
      add(subpaths_of(node, matrix), name);
      if (kind == "g" || kind == "a" || kind == "svg") children(node, matrix);
      if (kind == "switch") first_choice(node, matrix);
      if (kind == "use" || kind == "image" || kind == "text" || kind == "foreignObject") ++found_.unread_elements;
    } catch (const InputError& error) {
      const std::string text = error.what();
      throw InputError(text.starts_with(path_) ? text : path_ + ": " + printable_utf8(name) + ": " + text);
    }
  }

  /// The first child that needs nothing of the program that draws it.
  void first_choice(xmlNode* parent, const SvgMatrix& matrix) {
    for (xmlNode* node = xmlFirstElementChild(parent); node; node = xmlNextElementSibling(node)) {
      if (xmlHasNsProp(node, xml("requiredExtensions"), nullptr)) continue;
      if (!is_hidden(node)) element(node, matrix);
      return;
    }
  }

  void add(std::vector<SvgSubpath> subpaths, const std::string& name) {
    for (SvgSubpath& subpath : subpaths) {
      NestRing& ring = subpath.points;
      while (ring.size() > 1 && norm(ring.back() - ring.front()) < kFlatness_mm / 10) {
        ring.pop_back();
        subpath.closed = true;
      }
      if (subpath.closed && ring.size() == 1) continue;  // a dot
      if (!subpath.closed) {
        ++found_.open_paths;
        continue;
      }
      std::string fault = contour_fault(ring);
      if (!fault.empty()) fault = printable_utf8(name) + ": " + fault;
      points_ += ring.size();
      contours_.push_back({name, std::move(ring), std::move(fault)});
      check_count("points", points_, kMostDrawingPoints);
      check_count("contours", contours_.size(), kMostContours);
    }
  }

  std::string path_;
  SvgDrawings found_;
  std::vector<NamedContour> contours_;
  std::size_t points_ = 0;
  int count_ = 0;
};

}  // namespace

SvgDrawings svg_drawings(std::span<const std::uint8_t> bytes, const std::string& path) {
  const SvgTree tree = svg_tree(bytes, path);
  SvgReader reader(path);
  reader.read(xmlDocGetRootElement(tree.get()));
  return reader.take();
}

}  // namespace tessera
