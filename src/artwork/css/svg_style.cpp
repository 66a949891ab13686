#include "artwork/css/svg_style.h"

#include <algorithm>
#include <set>
#include <utility>

#include "artwork/css/css_matching.h"
#include "artwork/css/css_tokens.h"
#include "artwork/xml/xml_tree.h"
#include "core/base/error.h"
#include "core/base/too_many.h"

namespace tessera {
namespace {

bool is_style(const xmlNode* node) { return name_of(node) == "style" && is_in_svg_namespace(node); }

/// The text of the element, without the text of elements inside it.
std::string text_of(const xmlNode* style) {
  std::string text;
  for (const xmlNode* child = style->children; child; child = child->next) {
    if (child->type == XML_TEXT_NODE || child->type == XML_CDATA_SECTION_NODE) text += view(child->content);
  }
  return text;
}

[[noreturn]] void throw_loads_sheet(const std::string& path) {
  throw InputError(path + ": a style sheet that loads another one from a data: address");
}

void check_instructions(const xmlDoc* doc, const std::string& path) {
  for (const xmlNode* node = doc->children; node; node = node->next) {
    if (node->type != XML_PI_NODE || name_of(node) != "xml-stylesheet") continue;
    if (view(node->content).find("data:") != std::string_view::npos) throw_loads_sheet(path);
  }
}

/// Whether an at-rule (without its end) is an @import of a data: address.
bool imports_data(CssTokens rule) {
  if (ascii_lower_case(rule.front().text) != "import") return false;
  return std::any_of(rule.begin() + 1, rule.end(), [](const CssToken& token) {
    const bool is_address = token.kind == CssKind::string || token.kind == CssKind::url;
    return is_address && ascii_lower_case(token.text).find("data:") != std::string::npos;
  });
}

/// The key of a rule: what an element must have so that the compound can match.
std::string key_of(const CssCompound& compound) {
  std::string key = compound.type;
  for (const CssCondition& condition : compound.conditions) {
    if (const auto* id = std::get_if<CssId>(&condition)) return "#" + id->id;
    if (const auto* one_class = std::get_if<CssClass>(&condition)) key = "." + one_class->name;
  }
  return key;
}

/// All keys that an element has, each once.
std::vector<std::string> keys_of(const xmlNode* element, const std::string& id, std::string_view classes) {
  std::vector<std::string> keys = {"", std::string(name_of(element)), "#" + id};
  for (std::string_view word = take_word(classes); !word.empty(); word = take_word(classes)) {
    keys.push_back("." + std::string(word));
  }
  std::sort(keys.begin(), keys.end());
  keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
  return keys;
}

}  // namespace

SvgStyle::SvgStyle(const xmlNode* root, const std::string& path, ReadDeclarations read)
    : path_(path),
      read_(std::move(read)),
      matcher_(path) {
  check_instructions(root->doc, path);
  add_sheets_below(root);
}

/// Adds all sheets below the node. The recursion is as deep as the document, which parsed_foreign_svg limits.
void SvgStyle::add_sheets_below(const xmlNode* node) {
  if (is_style(node)) return add_sheet(text_of(node));
  for (const xmlNode* child = node->children; child; child = child->next) {
    if (child->type == XML_ELEMENT_NODE) add_sheets_below(child);
  }
}

void SvgStyle::add_sheet(std::string_view css) {
  const std::vector<CssToken> tokens = css_tokens(css);
  CssTokens rest = tokens;
  while (!rest.empty()) {
    const CssKind kind = rest.front().kind;
    if (kind == CssKind::space || kind == CssKind::comment) {
      rest = rest.subspan(1);
      continue;
    }
    const bool is_at_rule = kind == CssKind::at_keyword;
    const std::size_t head = find_css_mark(rest, is_at_rule ? "{;" : "{");
    const bool has_block = head < rest.size() && rest[head].is_mark('{');
    const std::size_t end = has_block ? find_css_mark(rest, "}", head + 1) : head;
    if (is_at_rule && imports_data(rest.first(head))) throw_loads_sheet(path_);
    if (!is_at_rule && has_block) add_rule(rest.first(head), rest.subspan(head + 1, end - head - 1));
    rest = rest.subspan(std::min(end + 1, rest.size()));
  }
}

void SvgStyle::add_rule(CssTokens selectors, CssTokens block) {
  std::optional<std::vector<CssSelector>> list = parse_css_selectors(selectors);
  if (!list) return;
  blocks_.push_back(read_(block));
  for (CssSelector& selector : *list) {
    rules_by_key_[key_of(selector.compounds.back())].push_back(rules_.size());
    rules_.push_back({std::move(selector), blocks_.size() - 1});
  }
}

/// The rules that match, in the order of precedence, the strongest last. Of rules with the same block only the
/// strongest is kept.
std::vector<const SvgStyle::Rule*> SvgStyle::rules_of(const xmlNode* element) {
  std::vector<const Rule*> rules;
  if (rules_.empty()) return rules;
  const std::string id = counted(attribute(element, "id")), classes = counted(attribute(element, "class"));
  count_bytes(classes.size() / 2 * sizeof(std::string));  // there may be as many keys as words
  for (const std::string& key : keys_of(element, id, classes)) {
    const auto found = rules_by_key_.find(key);
    if (found == rules_by_key_.end()) continue;
    for (const std::size_t i : found->second) {
      if (matcher_.selects(rules_[i].selector, element)) rules.push_back(&rules_[i]);
    }
  }
  std::sort(rules.begin(), rules.end(), [](const Rule* a, const Rule* b) {
    return std::pair(a->selector.specificity, a) > std::pair(b->selector.specificity, b);
  });
  std::set<std::size_t> blocks;
  std::erase_if(rules, [&](const Rule* rule) { return !blocks.insert(rule->block).second; });
  std::reverse(rules.begin(), rules.end());
  return rules;
}

std::vector<CssDeclaration> SvgStyle::declarations_of(const xmlNode* element) {
  std::vector<CssDeclaration> declarations;
  for (const Rule* rule : rules_of(element)) append(declarations, blocks_[rule->block]);
  const std::vector<CssToken> own = css_tokens(counted(attribute(element, "style")));
  append(declarations, read_(own));
  return declarations;
}

std::string SvgStyle::counted(std::string value) {
  count_bytes(value.size());
  return value;
}

void SvgStyle::append(std::vector<CssDeclaration>& to, const std::vector<CssDeclaration>& more) {
  for (const CssDeclaration& declaration : more) {
    count_bytes(sizeof declaration + declaration.name.size() + declaration.value.size());
    to.push_back(declaration);
  }
}

void SvgStyle::count_bytes(std::size_t bytes) {
  bytes_ += bytes;
  if (bytes_ <= kMostDeclarationBytes) return;
  throw InputError(path_ + ": its style sheets and attributes: " +
                   too_many(kMostDeclarationBytes >> 20, "MiB of declarations for its elements") +
                   "; write fewer declarations into each rule");
}

}  // namespace tessera
