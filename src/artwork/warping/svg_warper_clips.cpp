#include "artwork/svg/svg_values.h"
#include "artwork/warping/svg_warper.h"
#include "text/number_text.h"

namespace tessera {

PathSteps SvgWarper::clip_steps(const std::string& id, const Frame& frame) {
  const xmlNode* shape = only_child(node_of(id));
  if (!shape) throw_unknown("a clip of several parts", id);
  return transformed(frame.page_from_user, steps_of(shape));
}

bool SvgWarper::cuts_nothing(const xmlNode* node, const PathSteps& steps, const Frame& frame) {
  const std::optional<cv::Rect2d> box = level_rectangle(steps);
  if (!box) return false;
  if (!frame.in_pattern && holds(*box, page_, kClipSlack * unit_)) return true;
  const xmlNode* inner = only_child(node);
  if (!inner || name_of(inner) != "g" || !attribute(inner, "transform").empty()) return false;
  const std::string clip = local_id(attribute(inner, "clip-path"));
  return !clip.empty() && holds(*box, box_of(clip_steps(clip, frame)), 0);
}

void SvgWarper::write_clip(const std::string& id, const PathSteps& steps, const std::string& rule, const Frame& frame,
                           XmlWriter& to) {
  to.start("clipPath").attribute("id", id).start("path").attribute("d", data_of(placed(steps, frame), kPageDigits));
  if (rule == "evenodd") to.attribute("clip-rule", rule);
  to.end().end();
}

std::string SvgWarper::clip_copy(const PathSteps& steps, const std::string& rule, const Frame& frame) {
  const std::string id = new_id();
  XmlWriter definition;
  write_clip(id, steps, rule, frame, definition);
  add_definition(definition.finish());
  return id;
}

std::pair<std::string, std::string> SvgWarper::attribute_of_mask(const std::string& mask, const Frame& frame) {
  const xmlNode* group = only_child(node_of(mask));
  if (!group || name_of(group) != "g" || local_id(attribute(group, "filter")) != "alpha") {
    throw_unknown("a mask of another kind", mask);
  }
  const xmlNode* shown = only_child(group);
  if (shown && name_of(shown) == "rect" && attribute(shown, "mask").empty()) {
    const Style style = svg_style(attribute(shown, "style"));
    const std::string opacity = value_of(style, "fill-opacity");
    if (value_of(style, "fill").starts_with("rgb(") && !opacity.empty())
      return {"opacity", significant(svg_number(opacity), kPageDigits)};
  }
  if (frame.in_pattern) throw_unknown("a mask in a pattern", mask);
  const std::string id = copy_of(mask, "", frame.page_from_user, frame,
                                 [&](const std::string& id, XmlWriter& to) { write_mask(id, group, frame, to); });
  return {"mask", url(id)};
}

void SvgWarper::write_mask(const std::string& id, const xmlNode* group, Frame frame, XmlWriter& to) {
  frame.in_mask = true;
  const cv::Rect2d box = box_of(placed(rectangle_steps(page_), frame));
  to.start("mask").attribute("id", id).attribute("maskUnits", "userSpaceOnUse");
  write_box(box, to);
  write_children(group, frame, to);
  to.end();
}

void SvgWarper::write_box(const cv::Rect2d& box, XmlWriter& to) {
  to.attribute("x", significant(box.x, kFrameDigits)).attribute("y", significant(box.y, kFrameDigits));
  to.attribute("width", significant(box.width, kFrameDigits));
  to.attribute("height", significant(box.height, kFrameDigits));
}

}  // namespace tessera
