// CSS of an untrusted SVG that becomes part of another document: its ids get a prefix, its rules a scope, and nothing
// in it can load anything.
//
// A small reader of CSS's outer syntax, not a style engine: rules, declarations, url(). What it cannot be sure of, it
// drops; a lost hover effect is the smaller evil.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace tessera::io {

/// A property's or presentation attribute's value with url(#id) made url(#PREFIXid). Nothing where the value refers to
/// anything but an id of its own document, or hides behind escapes.
std::optional<std::string> local_css_value(std::string_view value, const std::string& id_prefix);

/// The declarations of a style attribute or rule, less those without a local value and those of other programs
/// (-x-...).
std::string local_declarations(std::string_view declarations, const std::string& id_prefix);

/// The rules of a <style> element for the descendants of element `scope_id` only. At-rules are dropped.
std::string scoped_style_sheet(std::string_view css, const std::string& scope_id, const std::string& id_prefix);

}  // namespace tessera::io
