// The numbers of elements among their siblings, for selectors such as :nth-child(3).
#pragma once

#include <libxml/tree.h>

#include <unordered_map>

namespace tessera {

/// Numbers of an element among its siblings, from 1 on.
struct SiblingNumber {
  int from_start = 0;
  int from_end = 0;
};

/// Counts the children of each parent once. The document must not change meanwhile.
class SiblingNumbers {
 public:
  /// Among all siblings that are elements.
  const SiblingNumber& among_all(const xmlNode* element) { return both(element).among_all; }
  /// Among those with the element's name and name space alone. Elements without a name space are SVG's.
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
