// The style sheets of an untrusted SVG that becomes part of another document.
//
// Selectors of a copied style sheet would also be tried on elements of other drawings, and programs read selectors in
// different ways. Therefore no style sheet is copied: each element gets the declarations that the sheets of its own
// document have for it, as a style attribute.
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

/// Most bytes of declarations for one drawing, counted for each element that gets them.
inline constexpr std::size_t kMostDeclarationBytes = std::size_t(256) << 20;

/// A function that reads the content of a style attribute or of a rule's block.
using ReadDeclarations = std::function<std::vector<CssDeclaration>(CssTokens)>;

class SvgStyle {
 public:
  /// Reads all <style> elements below `root`, of any type and medium, as librsvg does. Throws InputError, which begins
  /// with `path`, where a sheet loads another one from a data: address (@import, <?xml-stylesheet?>): librsvg applies
  /// that sheet, and here it would be lost. Librsvg does not load other addresses either.
  SvgStyle(const xmlNode* root, const std::string& path, ReadDeclarations read);

  /// The declarations for the element's style attribute: those of the sheets in the order of precedence, then those of
  /// its own style attribute. Throws InputError where all calls together give more than kMostDeclarationBytes, or need
  /// more than kMostCssComparisons: a few bytes of a sheet could go to each of many elements.
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
  /// Counts the bytes of an attribute's value and returns it; many elements may share one as a default.
  std::string counted(std::string value);
  void append(std::vector<CssDeclaration>& to, const std::vector<CssDeclaration>& more);
  void count_bytes(std::size_t bytes);

  const std::string path_;
  const ReadDeclarations read_;
  std::vector<std::vector<CssDeclaration>> blocks_;
  std::vector<Rule> rules_;  // in the order of the sheets
  /// Indices of rules by what their last compound requires: "#id", ".class", a type, or "" for anything.
  std::unordered_map<std::string, std::vector<std::size_t>> rules_by_key_;
  CssMatcher matcher_;
  std::size_t bytes_ = 0;
};

}  // namespace tessera
