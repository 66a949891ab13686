// The style sheets of an untrusted SVG that becomes part of another document.
//
// Whatever a selector says, it would be tried on the elements of the other drawings, too, and each program reads
// selectors in its own way. So no style sheet is copied: each element gets the declarations that its own document's
// sheets have for it, as a style attribute.
#pragma once

#include <libxml/tree.h>

#include <cstddef>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "io/artwork/css_declarations.h"
#include "io/artwork/css_selector.h"

namespace tessera::io {

class SvgStyle {
 public:
  /// Reads all <style> elements below `root`, of any type and medium, as librsvg does. Throws InputError, which begins
  /// with `path`, where a sheet loads another one from a data: address (@import, <?xml-stylesheet?>): librsvg applies
  /// that, and here it would be lost. Other addresses librsvg does not load either.
  SvgStyle(const xmlNode* root, const std::string& path, const std::string& id_prefix);

  /// For the element's style attribute: what the sheets say of it, in the order in which it counts, and then what its own
  /// style attribute says. All values are local (css_declarations.h).
  std::vector<CssDeclaration> declarations_of(const xmlNode* element) const;

 private:
  struct Rule {
    CssSelector selector;
    std::size_t block = 0;  // index in blocks_
  };

  void add_sheets_below(const xmlNode* node, const std::string& path);
  void add_sheet(std::string_view css, const std::string& path);
  void add_rule(CssTokens selectors, CssTokens block);
  std::vector<const Rule*> rules_of(const xmlNode* element) const;

  const std::string id_prefix_;
  std::vector<std::vector<CssDeclaration>> blocks_;
  std::vector<Rule> rules_;  // in the order of the sheets
  /// Indices of rules by what their last compound asks for: "#id", ".class", a type, or "" for anything.
  std::unordered_map<std::string, std::vector<std::size_t>> rules_by_key_;
};

}  // namespace tessera::io
