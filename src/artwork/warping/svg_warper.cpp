#include "artwork/warping/svg_warper.h"

#include <algorithm>
#include <set>

#include "artwork/svg/svg_values.h"

namespace tessera {
namespace {

/// Largest distance of a curve from the true image, relative to the page's longest side: a quarter px in a piece of
/// 1000 px.
constexpr double kCurveTolerance = 1 / 4000.;

/// cairo's names of blend modes that CSS has, too.
bool is_blend_mode(const std::string& name) {
  static const std::set<std::string> kModes = {"multiply",   "screen",      "overlay",    "darken",
                                               "lighten",    "color-dodge", "color-burn", "hard-light",
                                               "soft-light", "difference",  "exclusion"};
  return kModes.contains(name);
}

}  // namespace

SvgWarper::SvgWarper(const xmlNode* root, const FlattenedSvg& flattened, const std::string& scope_id, const Warp& warp)
    : root_(root),
      page_({0, 0}, flattened.page),
      unit_(flattened.page_from_unit),
      scope_id_(scope_id),
      warp_(warp),
      tolerance_(kCurveTolerance * std::max(page_.width, page_.height)) {
  list_ids(root);
}

std::string SvgWarper::warped() {
  XmlWriter drawing, whole;
  Frame frame{.page_from_user = identity()};
  cairo_matrix_scale(&frame.page_from_user, unit_, unit_);
  write_children(root_, frame, drawing);
  const std::string page_clip = leaves_page_ ? clip_copy(rectangle_steps(page_), "", frame) : "";
  whole.start("g").attribute("id", scope_id_);
  if (blends_) whole.attribute("style", "isolation:isolate");
  if (leaves_page_) whole.attribute("clip-path", url(page_clip));
  whole.start("defs").raw(definitions_).end().raw(drawing.finish());
  return whole.end().finish();
}

void SvgWarper::list_ids(const xmlNode* node) {
  for (const xmlNode* child = first_child(node); child; child = next_sibling(child)) {
    const std::string id = attribute(child, "id");
    if (!id.empty()) nodes_.emplace(id, child);
    list_ids(child);
  }
}

const xmlNode* SvgWarper::node_of(const std::string& id) const {
  const auto found = nodes_.find(id);
  if (found == nodes_.end()) throw_unknown("a reference to", id);
  return found->second;
}

void SvgWarper::add_definition(const std::string& xml) {
  definitions_ += xml;
  limits_.count_bytes(xml.size());
}

void SvgWarper::write_children(const xmlNode* node, Frame frame, XmlWriter& to) {
  ++frame.depth;
  for (const xmlNode* child = first_child(node); child; child = next_sibling(child)) write(child, frame, to);
}

void SvgWarper::write(const xmlNode* node, Frame frame, XmlWriter& to) {
  limits_.count_element(frame.depth);
  if (name_of(node) == "defs") return;
  frame.page_from_user = product(frame.page_from_user, svg_matrix(attribute(node, "transform")));
  const Attributes around = attributes_around(node, frame);
  if (!around.empty()) to.start("g");
  for (const auto& [name, value] : around) to.attribute(name, value);
  write_inside(node, frame, to);
  if (!around.empty()) to.end();
}

void SvgWarper::write_inside(const xmlNode* node, Frame frame, XmlWriter& to) {
  const std::string_view name = name_of(node);
  if (name == "path" || name == "rect") return write_path(node, frame, to);
  if (name == "image") return write_bitmap(node, frame, false, to);
  if (name == "g" || name == "symbol") return write_children(node, frame, to);
  if (name != "use") throw_unknown("an element", name);
  const cairo_matrix_t place = translation(number_of(node, "x", 0), number_of(node, "y", 0));
  frame.page_from_user = product(frame.page_from_user, place);
  ++frame.depth;
  write(node_of(reference(node)), frame, to);
}

SvgWarper::Attributes SvgWarper::attributes_around(const xmlNode* node, const Frame& frame) {
  Attributes around;
  if (const std::string clip = local_id(attribute(node, "clip-path")); !clip.empty()) {
    const PathSteps steps = clip_steps(clip, frame);
    if (!cuts_nothing(node, steps, frame)) {
      const std::string rule = attribute(node, "clip-rule");
      const std::string id =
          copy_of(clip, rule, frame.page_from_user, frame,
                  [&](const std::string& id, XmlWriter& to) { write_clip(id, steps, rule, frame, to); });
      around.emplace_back("clip-path", url(id));
    }
  }
  if (const std::string mask = local_id(attribute(node, "mask")); !mask.empty()) {
    around.push_back(attribute_of_mask(mask, frame));
  }
  if (const std::string operation = attribute(node, "comp-op"); !operation.empty() && operation != "src-over") {
    if (!is_blend_mode(operation)) throw_unknown("an operator", operation);
    around.emplace_back("style", "mix-blend-mode:" + operation);
    blends_ = true;
  }
  return around;
}

}  // namespace tessera
