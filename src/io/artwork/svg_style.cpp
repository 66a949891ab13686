#include "io/artwork/svg_style.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <vector>

#include "core/base/split_text.h"

namespace tessera::io {
namespace {

std::string lower_case(std::string_view text) {
  std::string lower(text);
  std::transform(lower.begin(), lower.end(), lower.begin(), [](unsigned char c) { return char(std::tolower(c)); });
  return lower;
}

/// Without /* */, <!-- and -->.
std::string without_comments(std::string_view css) {
  std::string plain;
  while (!css.empty()) {
    if (css.starts_with("/*")) {
      const std::size_t end = css.find("*/", 2);
      css.remove_prefix(end == std::string_view::npos ? css.size() : end + 2);
      plain += ' ';
    } else if (css.starts_with("<!--")) {
      css.remove_prefix(4);
    } else if (css.starts_with("-->")) {
      css.remove_prefix(3);
    } else {
      plain += css.front();
      css.remove_prefix(1);
    }
  }
  return plain;
}

/// Functions that load, other than url(); and the escape that could spell any of them.
bool may_load_something(const std::string& lower) {
  static constexpr std::array<std::string_view, 5> kLoaders = {"\\", "image(", "image-set(", "src(", "javascript:"};
  return std::any_of(kLoaders.begin(), kLoaders.end(),
                     [&](std::string_view loader) { return lower.find(loader) != std::string::npos; });
}

/// The id in what stands between "url(" and ")"; nothing where it is another address.
std::optional<std::string> local_id(std::string_view address) {
  address = trimmed(address);
  if (address.size() >= 2 && (address.front() == '"' || address.front() == '\'') && address.back() == address.front()) {
    address = trimmed(address.substr(1, address.size() - 2));
  }
  if (address.size() < 2 || address.front() != '#') return std::nullopt;
  if (address.find_first_of("\"'()") != std::string_view::npos) return std::nullopt;
  return std::string(address.substr(1));
}

bool is_property_name(std::string_view name) {
  return !name.empty() && name.front() != '-' &&
         std::all_of(name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) || c == '-'; });
}

bool is_plain_selector(std::string_view selector) {
  return !selector.empty() && selector.find_first_of("\\\"'<@;") == std::string_view::npos;
}

std::string scoped_selector(std::string_view selector, const std::string& scope_id, const std::string& id_prefix) {
  std::string scoped = std::string("#") + scope_id + " ";
  for (const char c : selector) {
    scoped += c;
    if (c == '#') scoped += id_prefix;
  }
  return scoped;
}

std::string scoped_selectors(std::string_view selectors, const std::string& scope_id, const std::string& id_prefix) {
  std::string scoped;
  for (const std::string_view selector : split_outside(selectors, ',')) {
    if (!is_plain_selector(selector)) continue;
    if (!scoped.empty()) scoped += ',';
    scoped += scoped_selector(selector, scope_id, id_prefix);
  }
  return scoped;
}

}  // namespace

std::optional<std::string> local_css_value(std::string_view value, const std::string& id_prefix) {
  const std::string lower = lower_case(value);
  if (may_load_something(lower)) return std::nullopt;
  std::string local;
  std::size_t done = 0;
  for (std::size_t at = lower.find("url("); at != std::string::npos; at = lower.find("url(", done)) {
    const std::size_t end = value.find(')', at);
    if (end == std::string_view::npos) return std::nullopt;
    const std::optional<std::string> id = local_id(value.substr(at + 4, end - at - 4));
    if (!id) return std::nullopt;
    local += std::string(value.substr(done, at - done)) + "url(#" + id_prefix + *id + ")";
    done = end + 1;
  }
  return local + std::string(value.substr(done));
}

std::string local_declarations(std::string_view declarations, const std::string& id_prefix) {
  const std::string plain = without_comments(declarations);
  std::string local;
  for (const std::string_view declaration : split_outside(plain, ';')) {
    const std::size_t colon = declaration.find(':');
    if (colon == std::string_view::npos || declaration.find_first_of("{}") != std::string_view::npos) continue;
    const std::string_view name = trimmed(declaration.substr(0, colon));
    const std::optional<std::string> value = local_css_value(trimmed(declaration.substr(colon + 1)), id_prefix);
    if (!is_property_name(name) || !value) continue;
    if (!local.empty()) local += ';';
    local += std::string(name) + ":" + *value;
  }
  return local;
}

std::string scoped_style_sheet(std::string_view css, const std::string& scope_id, const std::string& id_prefix) {
  const std::string plain = without_comments(css);
  std::string_view rest = trimmed(plain);
  std::string sheet;
  while (!rest.empty()) {
    const std::size_t open = find_outside(rest, rest.front() == '@' ? "{;" : "{");
    if (open == rest.size()) break;
    const std::size_t close = rest[open] == '{' ? find_outside(rest, "}", open + 1) : open;
    if (close == rest.size()) break;
    if (rest.front() != '@') {
      const std::string selectors = scoped_selectors(rest.substr(0, open), scope_id, id_prefix);
      const std::string declarations = local_declarations(rest.substr(open + 1, close - open - 1), id_prefix);
      if (!selectors.empty() && !declarations.empty()) sheet += selectors + "{" + declarations + "}\n";
    }
    rest = trimmed(rest.substr(close + 1));
  }
  return sheet;
}

}  // namespace tessera::io
