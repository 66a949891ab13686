#include <glib.h>

#include <cstdint>
#include <string_view>
#include <vector>

#include "artwork/images/png_picture.h"
#include "artwork/images/png_uri.h"
#include "artwork/svg/svg_values.h"
#include "artwork/warping/svg_warper.h"
#include "artwork/warping/warped_bitmap.h"
#include "text/number_text.h"

namespace tessera {

const xmlNode* SvgWarper::bitmap_of_pattern(const std::string& fill) const {
  const std::string id = local_id(fill);
  const xmlNode* pattern = id.empty() ? nullptr : node_of(id);
  if (!pattern || name_of(pattern) != "pattern") return nullptr;
  const xmlNode* shown = only_child(pattern);
  if (shown && name_of(shown) == "use") shown = node_of(reference(shown));
  return shown && name_of(shown) == "image" ? shown : nullptr;
}

void SvgWarper::write_bitmap_fill(const xmlNode* pattern, const xmlNode* bitmap, const PathSteps& page_path,
                                  const Style& style, Frame frame, XmlWriter& to) {
  const std::optional<cv::Rect2d> box = level_rectangle(page_path);
  const std::string opacity = value_of(style, "fill-opacity");
  to.start("g");
  if (!box || *box != page_) {
    to.attribute("clip-path", url(clip_copy(page_path, value_of(style, "fill-rule"), frame)));
  }
  if (!opacity.empty()) to.attribute("opacity", significant(svg_number(opacity), kPageDigits));
  frame.page_from_user = product(frame.page_from_user, svg_matrix(attribute(pattern, "patternTransform")));
  write_bitmap(bitmap, frame, true, to);
  to.end();
}

void SvgWarper::write_bitmap(const xmlNode* node, const Frame& frame, bool goes_on, XmlWriter& to) {
  PageBitmap bitmap{decoded(node), frame.page_from_user};
  if (frame.in_mask) bitmap.bgra.forEach<cv::Vec4b>([](cv::Vec4b& p, const int*) { p = {255, 255, 255, p[3]}; });
  if (frame.in_pattern) {
    to.start("image").attribute("transform", svg_text(frame.page_from_user));
    return write_picture(bitmap.bgra, {0, 0, double(bitmap.bgra.cols), double(bitmap.bgra.rows)}, to);
  }
  const cv::Rect2d own(0, 0, bitmap.bgra.cols, bitmap.bgra.rows);
  const cv::Rect2d box = box_of(transformed(frame.page_from_user, rectangle_steps(own)));
  note_box(box, 0, frame);
  const WarpedBitmap warped =
      warped_bitmap(bitmap, warp_, page_.size(), goes_on || holds(box, page_, kClipSlack * unit_));
  if (warped.bgra.empty()) return;
  to.start("image");
  write_picture(warped.bgra, warped.box, to);
}

void SvgWarper::write_picture(const cv::Mat& bgra, const cv::Rect2d& box, XmlWriter& to) {
  limits_.count_pixels(double(bgra.total()));
  write_box(box, to);
  const std::string uri = png_uri(bgra);
  limits_.count_bytes(uri.size());
  to.attribute("preserveAspectRatio", "none").attribute("xlink:href", uri).end();
}

cv::Mat SvgWarper::decoded(const xmlNode* node) {
  static constexpr std::string_view kStart = "data:image/png;base64,";
  const std::string uri = hyperlink(node);
  if (!uri.starts_with(kStart)) throw_unknown("a bitmap", uri);
  gsize size = 0;
  guchar* bytes = g_base64_decode(uri.c_str() + kStart.size(), &size);
  const std::vector<std::uint8_t> png(bytes, bytes + size);
  g_free(bytes);
  const cv::Mat bgra = png_picture(png, "a bitmap", int(WarpingLimits::kMostPixels));
  limits_.count_pixels(double(bgra.total()));
  return bgra;
}

}  // namespace tessera
