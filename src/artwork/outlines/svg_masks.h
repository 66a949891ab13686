// Masks of a foreign SVG. Pixels decide what a mask hides, so no outline can show it: the elements are drawn without
// their masks, and the user is told.
#pragma once

#include <libxml/tree.h>

#include <string>
#include <unordered_set>
#include <vector>

namespace tessera {

class SvgMasks {
 public:
  /// Finds the elements that have a mask, by attribute, style attribute or style sheet. Throws InputError, which begins
  /// with `path`, where the declarations of all elements exceed a limit of svg_style.h.
  SvgMasks(xmlNode* root, const std::string& path);

  /// Whether the element has a mask, lies in an element with one, or shows one as a <use>.
  bool touch(const xmlNode* element) const;

  /// Removes all masks, whatever style sheets say.
  void take_off() const;

 private:
  void find(xmlNode* root, const std::string& path);

  std::vector<xmlNode*> masked_;
  std::unordered_set<const xmlNode*> below_;  // masked elements and the elements inside them
  std::unordered_set<const xmlNode*> above_;  // elements that hold a masked one, or hold a <use> that shows one
};

}  // namespace tessera
