// The images and foreign objects of a foreign SVG that are seen. librsvg tells the extent of an element, but not of these
// two: in the drawer it gives images none, and it never draws foreign objects.
#pragma once

#include <libxml/tree.h>

#include <string>
#include <unordered_set>

namespace tessera {

class SvgPictures {
 public:
  /// Finds the pictures that are displayed, visible, not transparent and not of size 0. `path` is for style sheets that break a
  /// limit (svg_style.h): then attributes and style attributes alone count.
  SvgPictures(const xmlNode* root, const std::string& path);

  /// Whether the element is such a picture, has one in it, or refers to one as a <use>.
  bool shown_by(const xmlNode* element) const { return showing_.contains(element); }

 private:
  std::unordered_set<const xmlNode*> showing_;
};

}  // namespace tessera
