// Reads a flattened drawing (flattened_svg.h) and writes it deformed. It is one class, as definitions, ids and limits
// belong to the whole drawing. The members are in files by what they write: groups in svg_warper.cpp, and clips and
// masks, paths, paints and bitmaps in files of their own.
#pragma once

#include <cairo.h>

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <unordered_map>
#include <utility>
#include <vector>

#include "artwork/svg/flattened_nodes.h"
#include "artwork/svg/flattened_svg.h"
#include "artwork/svg/path_steps.h"
#include "artwork/warping/warping_limits.h"
#include "artwork/xml/xml_tree.h"
#include "core/deform/warp.h"
#include "text/xml_writer.h"

namespace tessera {

/// Tolerance for clips, as cairo rounds clips and layers; units of the flattened drawing.
inline constexpr double kClipSlack = 1;
/// Digits of coordinates: a millionth of the page; more in frames of their own, which may be far from their origin.
inline constexpr int kPageDigits = 6, kFrameDigits = 9;

class SvgWarper {
 public:
  /// All arguments must outlive the object.
  SvgWarper(const xmlNode* root, const FlattenedSvg& flattened, const std::string& scope_id, const Warp& warp);

  /// The drawing as one group. Throws InputError where it exceeds a limit, or holds something that cairo is not known
  /// to write.
  std::string warped();

 private:
  /// The surroundings of a part of the flattened drawing.
  struct Frame {
    cairo_matrix_t page_from_user;
    bool in_mask = false;     // only its opacity matters: all is white
    bool in_pattern = false;  // the page is a pattern's tile, and nothing is deformed
    int depth = 0;
  };
  /// Identifies a definition, which is written once for each different use.
  using CopyKey = std::tuple<std::string, std::string, std::array<double, 6>, bool, bool>;
  using Attributes = std::vector<std::pair<std::string, std::string>>;

  void list_ids(const xmlNode* node);
  const xmlNode* node_of(const std::string& id) const;
  std::string url(const std::string& id) const { return "url(#" + id + ")"; }
  std::string new_id() { return scope_id_ + "-" + std::to_string(++ids_); }

  /// The id of a definition: an equal one that exists already, else a new one that `write` fills.
  template <class Write>
  std::string copy_of(const std::string& what, const std::string& how, const cairo_matrix_t& m, const Frame& frame,
                      Write write) {
    const CopyKey key{what, how, {m.xx, m.yx, m.xy, m.yy, m.x0, m.y0}, frame.in_mask, frame.in_pattern};
    const auto found = copies_.find(key);
    if (found != copies_.end()) return found->second;
    const std::string id = new_id();
    XmlWriter definition;
    write(id, definition);
    add_definition(definition.finish());
    return copies_[key] = id;
  }

  void add_definition(const std::string& xml);

  // Groups
  void write_children(const xmlNode* node, Frame frame, XmlWriter& to);
  void write(const xmlNode* node, Frame frame, XmlWriter& to);
  void write_inside(const xmlNode* node, Frame frame, XmlWriter& to);
  /// Attributes for a group round the element: clip, mask, opacity and blend mode.
  Attributes attributes_around(const xmlNode* node, const Frame& frame);

  // Clips and masks
  /// The clip's path on the page, before the deformation.
  PathSteps clip_steps(const std::string& id, const Frame& frame);
  /// Whether the clip is a rectangle round the page, or round another clip that holds all of the element. cairo writes
  /// such clips everywhere; deformed, their edges would be antialiased.
  bool cuts_nothing(const xmlNode* node, const PathSteps& steps, const Frame& frame);
  void write_clip(const std::string& id, const PathSteps& steps, const std::string& rule, const Frame& frame,
                  XmlWriter& to);
  std::string clip_copy(const PathSteps& steps, const std::string& rule, const Frame& frame);
  /// The attribute (name, value) for a mask that uses the alpha of what it shows. A mask that only sets an opacity
  /// becomes the attribute "opacity".
  std::pair<std::string, std::string> attribute_of_mask(const std::string& mask, const Frame& frame);
  void write_mask(const std::string& id, const xmlNode* group, Frame frame, XmlWriter& to);
  static void write_box(const cv::Rect2d& box, XmlWriter& to);

  // Paths
  /// The path on the page, deformed unless it is in a pattern.
  PathSteps placed(const PathSteps& page_path, const Frame& frame);
  std::string data_of(const PathSteps& steps, int digits);
  void write_path(const xmlNode* node, const Frame& frame, XmlWriter& to);
  /// The path, or the page where the path is a rectangle round it: where cairo has no shape to fill, it fills the page,
  /// rounded up to whole units.
  PathSteps within_page(PathSteps steps, const Frame& frame) const;
  /// The distance that a stroke reaches beyond its path, on the page.
  static double reach(const Style& style, const cairo_matrix_t& m);
  void note_box(cv::Rect2d box, double reach, const Frame& frame);
  void write_style(const Style& style, const cairo_matrix_t& out_from_path, const Frame& frame, XmlWriter& to);

  // Colours, gradients and patterns
  std::string colour(const std::string& rgb, const Frame& frame) const;
  std::string paint(const std::string& value, const cairo_matrix_t& out_from_path, const Frame& frame);
  void write_gradient(const xmlNode* node, const std::string& id, const cairo_matrix_t& out_from_path,
                      const Frame& frame, XmlWriter& to);
  void write_stop(const xmlNode* stop, const Frame& frame, XmlWriter& to);
  void write_pattern(const xmlNode* node, const std::string& id, const cairo_matrix_t& out_from_path,
                     const Frame& frame, XmlWriter& to);

  // Bitmaps
  /// The only bitmap of a pattern: librsvg paints a bitmap by filling its rectangle with such a pattern.
  const xmlNode* bitmap_of_pattern(const std::string& fill) const;
  void write_bitmap_fill(const xmlNode* pattern, const xmlNode* bitmap, const PathSteps& page_path, const Style& style,
                         Frame frame, XmlWriter& to);
  void write_bitmap(const xmlNode* node, const Frame& frame, bool goes_on, XmlWriter& to);
  void write_picture(const cv::Mat& bgra, const cv::Rect2d& box, XmlWriter& to);
  cv::Mat decoded(const xmlNode* node);

  const xmlNode* root_;
  cv::Rect2d page_;
  double unit_;  // size of a unit of the flattened drawing, on the page
  std::string scope_id_;
  const Warp& warp_;
  double tolerance_;
  std::unordered_map<std::string, const xmlNode*> nodes_;
  std::map<CopyKey, std::string> copies_;
  std::string definitions_;
  bool blends_ = false;
  bool leaves_page_ = false;
  std::size_t ids_ = 0;
  WarpingLimits limits_;
};

}  // namespace tessera
