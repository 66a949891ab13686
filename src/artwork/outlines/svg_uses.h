// Finds the elements of a foreign SVG that show other elements: those around them, and each <use> that refers to them.
#pragma once

#include <libxml/tree.h>

#include <unordered_set>
#include <vector>

namespace tessera {

/// The given elements, all elements around them, each <use> that refers to one of those, and so on.
std::unordered_set<const xmlNode*> elements_that_show(const std::vector<const xmlNode*>& shown, const xmlNode* root);

}  // namespace tessera
