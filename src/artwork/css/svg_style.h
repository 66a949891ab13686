// The style sheets of an untrusted SVG that becomes part of another document.
//
// Whatever a selector says, it would be tried on the elements of the other drawings, too, and each program reads
// selectors in its own way. So no style sheet is copied: each element gets the declarations that its own document's
// sheets have for it, as a style attribute.
#pragma once

#include <libxml/tree.h>

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "artwork/css/css_declarations.h"
#include "artwork/css/css_matching.h"
#include "artwork/css/css_selector.h"

namespace tessera {

/// Bytes that the declarations of one drawing may take, counted for each element that gets them.
inline constexpr std::size_t kMostDeclarationBytes = std::size_t(256) << 20;

/// How the content of a style attribute or of a rule's block is read.
using ReadDeclarations = std::function<std::vector<CssDeclaration>(CssTokens)>;

class SvgStyle {
 public:
  /// Reads all <style> elements below `root`, of any type and medium, as librsvg does. Throws InputError, which begins
  /// with `path`, where a sheet loads another one from a data: address (@import, <?xml-stylesheet?>): librsvg applies
  /// that, and here it would be lost. Other addresses librsvg does not load either.
  SvgStyle(const xmlNode* root, const std::string& path, ReadDeclarations read);

  /// For the element's style attribute: what the sheets say of it, in the order in which it counts, and then what its own
  /// style attribute says. Throws InputError where all calls together find
  /// more than kMostDeclarationBytes, or need more than kMostCssComparisons: a few bytes of a sheet could go to each of
  /// many elements.
  std::vector<CssDeclaration> declarations_of(const xmlNode* element);

 private:
  struct Rule {
    CssSelector selector;
    std::size_t block = 0;  // index in blocks_
  };

  void add_sheets_below(const xmlNode* node);
  void add_sheet(std::string_view css);
  void add_rule(CssTokens selectors, CssTokens block);
  std::vector<const Rule*> rules_of(const xmlNode* element);
  /// A value of one of the document's attributes; many elements may share one as a default.
  std::string counted(std::string value);
  void append(std::vector<CssDeclaration>& to, const std::vector<CssDeclaration>& more);
  void count_bytes(std::size_t bytes);

  const std::string path_;
  const ReadDeclarations read_;
  std::vector<std::vector<CssDeclaration>> blocks_;
  std::vector<Rule> rules_;  // in the order of the sheets
  /// Indices of rules by what their last compound asks for: "#id", ".class", a type, or "" for anything.
  std::unordered_map<std::string, std::vector<std::size_t>> rules_by_key_;
  CssMatcher matcher_;
  std::size_t bytes_ = 0;
};

}  // namespace tessera
