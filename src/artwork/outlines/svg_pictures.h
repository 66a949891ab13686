// The visible images and foreign objects of a foreign SVG. librsvg reports the extent of other elements, but not of
// these two: in the drawer images have none, and foreign objects are never drawn.
#pragma once

#include <libxml/tree.h>

#include <string>
#include <unordered_set>

namespace tessera {

class SvgPictures {
 public:
  /// Finds the pictures that are displayed, visible, not transparent and not of size 0. `path` names the file in errors
  /// of style sheets. Where these exceed a limit (svg_style.h), only attributes and style attributes count.
  SvgPictures(const xmlNode* root, const std::string& path);

  /// Whether the element is such a picture, has one in it, or refers to one as a <use>.
  bool shown_by(const xmlNode* element) const { return showing_.contains(element); }

 private:
  std::unordered_set<const xmlNode*> showing_;
};

}  // namespace tessera
