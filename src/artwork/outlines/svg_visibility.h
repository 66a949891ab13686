// Which elements of a foreign SVG are seen. librsvg tells the extent of an element, but none of images, which it may not
// load here, and none of foreign objects, which it does not draw.
#pragma once

#include <libxml/tree.h>

#include <optional>
#include <string>
#include <unordered_map>

#include "artwork/css/svg_style.h"

namespace tessera {

class SvgVisibility {
 public:
  /// `path` begins the message of an InputError: the declarations of all elements may break a limit of svg_style.h. Where
  /// the style sheets themselves break one, only attributes count.
  SvgVisibility(const xmlNode* root, const std::string& path);

  /// Whether an image or a foreign object is displayed, visible, not transparent, and not of size 0. Throws InputError.
  bool shows(const xmlNode* picture);

 private:
  struct State {
    bool displayed = true;  // with all elements around it, and opaque to some degree
    bool visible = true;
  };

  State state_of(const xmlNode* element);

  std::optional<SvgStyle> style_;
  std::unordered_map<const xmlNode*, State> states_;
};

}  // namespace tessera
