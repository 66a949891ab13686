#include "artwork/css/css_variables.h"

#include <algorithm>
#include <map>
#include <set>
#include <string_view>
#include <vector>

#include "artwork/css/css_tokens.h"
#include "artwork/css/svg_style.h"
#include "artwork/xml/xml_tree.h"
#include "core/base/error.h"
#include "core/base/too_many.h"

namespace tessera {
namespace {

/// Whether the text contains "var(". Makes no copy: the text may be a whole document.
bool has_variable(std::string_view text) {
  constexpr std::string_view kVar = "var(";
  const auto is_same = [](char a, char b) { return (a >= 'A' && a <= 'Z' ? char(a - 'A' + 'a') : a) == b; };
  return std::search(text.begin(), text.end(), kVar.begin(), kVar.end(), is_same) != text.end();
}

/// The values of the variables ("--name") that an element declares; other variables have the value of an outer element.
struct Scope {
  std::map<std::string, std::optional<std::string>> values;  // nullopt: declared without a value
  const Scope* outer = nullptr;

  const std::string* find(const std::string& name, const Scope*& found_in) const {
    for (const Scope* scope = this; scope; scope = scope->outer) {
      const auto found = scope->values.find(name);
      if (found == scope->values.end()) continue;
      found_in = scope;
      return found->second ? &*found->second : nullptr;
    }
    return nullptr;
  }
};

class Resolver {
 public:
  explicit Resolver(const std::string& path) : path_(path) {}

  /// The value with each var() replaced. Nullopt where a variable without a value is needed, or the value becomes too
  /// long. A variable that refers to itself has no value.
  std::optional<std::string> resolved(std::string_view value, const Scope& scope) {
    const std::vector<CssToken> tokens = css_tokens(value);
    std::vector<CssToken> to;
    if (!put(tokens, scope, 0, to)) return std::nullopt;
    return css_text(to);
  }

 private:
  static constexpr std::size_t kMostTokens = 20'000;
  static constexpr std::size_t kMostUses = 1'000'000;
  static constexpr int kDeepest = 100;

  bool put(CssTokens tokens, const Scope& scope, int depth, std::vector<CssToken>& to) {
    while (!tokens.empty()) {
      if (to.size() > kMostTokens) return false;
      if (!tokens.front().is_function("var")) {
        to.push_back(tokens.front());
        tokens = tokens.subspan(1);
        continue;
      }
      const std::size_t end = find_css_mark(tokens, ")", 1);
      if (!put_variable(trimmed_css(tokens.subspan(1, end - 1)), scope, depth, to)) return false;
      tokens = tokens.subspan(std::min(end + 1, tokens.size()));
    }
    return true;
  }

  /// Replaces one var(); `call`: the tokens in its brackets.
  bool put_variable(CssTokens call, const Scope& scope, int depth, std::vector<CssToken>& to) {
    if (++uses_ > kMostUses) throw InputError(path_ + ": " + too_many(kMostUses, "var() in its styles"));
    if (depth > kDeepest || call.empty() || call.front().kind != CssKind::identifier) return false;
    const std::string& name = call.front().text;
    if (std::find(being_put_.begin(), being_put_.end(), name) != being_put_.end()) {
      cycle_ = name;  // all variables of a cycle have no value; their fallbacks do not count
      return false;
    }
    const Scope* found_in = nullptr;
    if (const std::string* value = scope.find(name, found_in)) {
      const std::vector<CssToken> tokens = css_tokens(*value);
      const std::size_t before = to.size();
      being_put_.push_back(name);
      const bool is_put = put(tokens, *found_in, depth + 1, to);
      being_put_.pop_back();
      if (is_put) return true;
      to.resize(before);
      if (cycle_ && *cycle_ != name) return false;
      cycle_.reset();
    }
    const CssTokens rest = trimmed_css(call.subspan(1));
    if (rest.empty() || !rest.front().is_mark(',')) return false;
    return put(trimmed_css(rest.subspan(1)), scope, depth + 1, to);
  }

  std::string path_;
  std::size_t uses_ = 0;
  std::vector<std::string> being_put_;  // the variables that are being replaced, the outermost first
  std::optional<std::string> cycle_;    // the variable at which a cycle was found
};

/// The value of a property whose var() has no value: an inherited property takes that of the outer element, any other
/// its initial value.
std::string unset_value(const std::string& name) {
  // clang-format off
  static const std::map<std::string, std::string> kInitial = {
      {"opacity", "1"}, {"display", "inline"}, {"clip-path", "none"}, {"mask", "none"}, {"filter", "none"},
      {"transform", "none"}, {"stop-color", "#000"}, {"stop-opacity", "1"}, {"flood-color", "#000"},
      {"flood-opacity", "1"}, {"lighting-color", "#fff"}, {"overflow", "visible"}, {"mix-blend-mode", "normal"},
      {"isolation", "auto"}};
  // clang-format on
  const auto found = kInitial.find(name);
  return found == kInitial.end() ? "inherit" : found->second;
}

/// Attributes that are CSS properties; in other attributes var() has no meaning.
bool is_property(const std::string& name) {
  // clang-format off
  static const std::set<std::string> kProperties = {
      "clip-path", "clip-rule", "color", "display", "fill", "fill-opacity", "fill-rule", "filter", "flood-color",
      "flood-opacity", "font-family", "font-size", "font-style", "font-weight", "lighting-color", "marker-end",
      "marker-mid", "marker-start", "mask", "opacity", "overflow", "paint-order", "stop-color", "stop-opacity", "stroke",
      "stroke-dasharray", "stroke-dashoffset", "stroke-linecap", "stroke-linejoin", "stroke-miterlimit",
      "stroke-opacity", "stroke-width", "text-anchor", "transform", "visibility"};
  // clang-format on
  return kProperties.contains(name);
}

/// The document; null where it cannot be read. The code that draws it reports what is wrong, or can read it anyway.
XmlDocPtr parsed_or_null(std::span<const std::uint8_t> svg, const std::string& path) try {
  return parsed_foreign_svg(svg, path);
} catch (const InputError&) {
  return nullptr;
}

bool uses_variables(const xmlNode* element) {
  if (name_of(element) == "style" && has_variable(content_of(element))) return true;
  for (const xmlAttr* a = element->properties; a; a = a->next) {
    const std::string name(view(a->name));
    const bool is_css = !a->ns && (name == "style" || is_property(name));
    if (is_css && has_variable(content_of(reinterpret_cast<const xmlNode*>(a)))) return true;
  }
  for (const xmlNode* child = element->children; child; child = child->next) {
    if (child->type == XML_ELEMENT_NODE && uses_variables(child)) return true;
  }
  return false;
}

class VariableWriter {
 public:
  VariableWriter(const xmlNode* root, const std::string& path)
      : style_(root, path, css_declarations),
        resolver_(path) {}

  /// Finds all changes before any element is changed, as selectors test attributes. The recursion is as deep as the
  /// document (see parsed_foreign_svg).
  void find(xmlNode* element, const Scope* outer) {
    Scope scope{.values = {}, .outer = outer};
    const std::map<std::string, std::string> declared = counting_values(style_.declarations_of(element));
    for (const auto& [name, value] : declared) {
      if (!name.starts_with("--")) continue;
      const std::string plain = without_important(value);
      std::string_view rest = plain;
      const std::string word = ascii_lower_case(take_word(rest));
      if (word == "inherit" || word == "unset") continue;
      scope.values[name] = word == "initial" ? std::nullopt : std::optional(plain);
    }
    std::string style;
    for (const auto& [name, value] : declared) {
      if (name.starts_with("--") || !has_variable(value)) continue;
      const std::string mark = is_important(value) ? "!important" : "";
      const std::optional<std::string> found = resolver_.resolved(without_important(value), scope);
      style += ";" + name + ":" + (found ? *found : unset_value(name)) + mark;
    }
    if (!style.empty()) {
      const std::vector<CssToken> own = css_tokens(attribute(element, "style"));
      changes_.push_back({element, "style", css_text_of(css_declarations(own)) + style});
    }
    for (const xmlAttr* a = element->properties; a; a = a->next) {
      const std::string name(view(a->name));
      if (a->ns || !is_property(name)) continue;
      const std::string value = attribute(element, name.c_str());
      if (has_variable(value)) changes_.push_back({element, name, resolver_.resolved(value, scope)});
    }
    for (xmlNode* child = xmlFirstElementChild(element); child; child = xmlNextElementSibling(child))
      find(child, &scope);
  }

  void write() const {
    for (const Change& change : changes_) {
      if (change.value)
        xmlSetProp(change.element, xml(change.name.c_str()), xml(change.value->c_str()));
      else
        xmlUnsetProp(change.element, xml(change.name.c_str()));
    }
  }

 private:
  struct Change {
    xmlNode* element;
    std::string name;                  // of the attribute
    std::optional<std::string> value;  // nullopt: the attribute is removed
  };

  SvgStyle style_;
  Resolver resolver_;
  std::vector<Change> changes_;
};

}  // namespace

std::optional<std::string> with_css_variables(std::span<const std::uint8_t> svg, const std::string& path) {
  const std::string_view text(reinterpret_cast<const char*>(svg.data()), svg.size());
  if (!has_variable(text)) return std::nullopt;
  const XmlDocPtr doc = parsed_or_null(svg, path);
  xmlNode* const root = doc ? xmlDocGetRootElement(doc.get()) : nullptr;
  if (!root || !uses_variables(root)) return std::nullopt;
  VariableWriter writer(root, path);
  writer.find(root, nullptr);
  writer.write();
  return text_of(*doc);
}

}  // namespace tessera
