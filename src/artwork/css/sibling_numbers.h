// The numbers of elements among their siblings, for selectors like :nth-child(3).
#pragma once

#include <libxml/tree.h>

#include <unordered_map>

namespace tessera {

/// The number of an element among its siblings, from 1, counted from both ends.
struct SiblingNumber {
  int from_start = 0;
  int from_end = 0;
};

/// Numbers the children of each parent once. The document must not change meanwhile.
class SiblingNumbers {
 public:
  /// The number among all sibling elements.
  const SiblingNumber& among_all(const xmlNode* element) { return both(element).among_all; }
  /// The number among siblings with the same name and name space. Elements without a name space are SVG elements.
  const SiblingNumber& among_same_type(const xmlNode* element) { return both(element).among_same_type; }

 private:
  struct Both {
    SiblingNumber among_all;
    SiblingNumber among_same_type;
  };

  const Both& both(const xmlNode* element);
  void count_siblings_of(const xmlNode* element);

  std::unordered_map<const xmlNode*, Both> numbers_;
};

}  // namespace tessera
