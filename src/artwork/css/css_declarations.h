// Properties and values of an untrusted SVG that becomes part of another document.
//
// Kept are values that name colours, numbers, transforms and filter functions that librsvg knows, and url() with ids of
// the same SVG. Any other function could load something, so its declaration is dropped.
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
  /// The value as text that gives the same tokens when it is read again. All its brackets and quotes are closed. It
  /// contains "!important" where the file has it.
  std::string value;
};

/// The value of a presentation attribute, with url(#id) changed to url(#PREFIXid). Nullopt where the value refers to
/// anything except ids of its own document.
std::optional<std::string> local_css_value(std::string_view value, const std::string& id_prefix);

/// The content of a style attribute or of a rule's block, with local values. Dropped are properties of other programs
/// (-x-...), text that librsvg does not take for a declaration, and at-rules and blocks between declarations.
std::vector<CssDeclaration> local_css_declarations(CssTokens content, const std::string& id_prefix);

/// Reads declarations like local_css_declarations, but keeps all names and values unchanged.
std::vector<CssDeclaration> css_declarations(CssTokens content);

/// Whether a value ends with "!important".
bool is_important(const std::string& value);
/// The value without its "!important", if it has one.
std::string without_important(std::string value);
/// The value that applies to each property: the last important one, else the last one.
std::map<std::string, std::string> counting_values(const std::vector<CssDeclaration>& declarations);

/// "name:value;name:value", for a style attribute.
std::string css_text_of(const std::vector<CssDeclaration>& declarations);

}  // namespace tessera
