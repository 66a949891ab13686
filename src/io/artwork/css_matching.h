// Which elements of a parsed SVG a selector selects.
#pragma once

#include <libxml/tree.h>

#include "io/artwork/css_selector.h"

namespace tessera::io {

/// `element` is one of the SVG's own document, all of whose elements count, also those that draw nothing. Elements
/// without a name space are SVG's, as for librsvg.
bool selects(const CssSelector& selector, const xmlNode* element);

}  // namespace tessera::io
