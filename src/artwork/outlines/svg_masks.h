// Masks of a foreign SVG. What a mask hides is decided by pixels, so that no outline says it: the elements are drawn
// without it, and somebody is told.
#pragma once

#include <libxml/tree.h>

#include <string>
#include <unordered_set>
#include <vector>

namespace tessera {

class SvgMasks {
 public:
  /// Finds the elements that have a mask, by attribute, style attribute or style sheet. Throws InputError, beginning with
  /// `path`, where the declarations of all elements break a limit of svg_style.h.
  SvgMasks(xmlNode* root, const std::string& path);

  /// Whether a mask is on the element, on one around it, or in what it shows as a <use>.
  bool touch(const xmlNode* element) const;

  /// Takes all of them off, whatever style sheets say.
  void take_off() const;

 private:
  void find(xmlNode* root, const std::string& path);

  std::vector<xmlNode*> masked_;
  std::unordered_set<const xmlNode*> below_;  // in a masked element, or one itself
  std::unordered_set<const xmlNode*> above_;  // with a masked element inside, or in what a <use> inside shows
};

}  // namespace tessera
