// Properties and values of an untrusted SVG that becomes part of another document.
//
// Kept are values that name colours, numbers, transforms and filter functions as librsvg knows them, and url() of the
// SVG's own ids. A function that is not in that list could load something, so that its declaration is dropped.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "artwork/css/css_blocks.h"

namespace tessera {

struct CssDeclaration {
  std::string name;
  /// Read again, it gives the tokens that were read. All of its brackets and quotes are closed. With "!important" where
  /// the file says so.
  std::string value;
};

/// The value of a presentation attribute with url(#id) made url(#PREFIXid). Nothing where the value refers to anything
/// but an id of its own document.
std::optional<std::string> local_css_value(std::string_view value, const std::string& id_prefix);

/// The content of a style attribute or of a rule's block, with local values. Dropped are properties of other programs
/// (-x-...), what librsvg does not take for a declaration, and at-rules and blocks among them.
std::vector<CssDeclaration> local_css_declarations(CssTokens content, const std::string& id_prefix);

/// The same with all names and values as they are.
std::vector<CssDeclaration> css_declarations(CssTokens content);

/// Whether a value ends with "!important".
bool is_important(const std::string& value);
/// The value without its "!important", if it has one.
std::string without_important(std::string value);
/// For each property the value that counts: the last one, or the last one that is important.
std::map<std::string, std::string> counting_values(const std::vector<CssDeclaration>& declarations);

/// "name:value;name:value", for a style attribute.
std::string css_text_of(const std::vector<CssDeclaration>& declarations);

}  // namespace tessera
