#include "artwork/css/css_selector.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>
#include <utility>

namespace tessera {
namespace {

/// Largest value of each part of a specificity.
constexpr std::uint32_t kMostOfAKind = 1023;
constexpr std::uint32_t kIdWeight = 1u << 20;
constexpr std::uint32_t kClassWeight = 1u << 10;
/// Most levels of :not() in :not(): parsing and matching are recursive.
constexpr int kMostNested = 16;

constexpr CssPlace kFirstChild{.a = 0, .b = 1, .of_type = false, .from_end = false};
constexpr CssPlace kLastChild{.a = 0, .b = 1, .of_type = false, .from_end = true};
constexpr CssPlace kFirstOfType{.a = 0, .b = 1, .of_type = true, .from_end = false};
constexpr CssPlace kLastOfType{.a = 0, .b = 1, .of_type = true, .from_end = true};

/// Thrown for a selector that is not understood; the whole list is then invalid.
struct NotUnderstood {};

struct Counts {
  std::uint32_t ids = 0;
  std::uint32_t classes = 0;
  std::uint32_t types = 0;

  std::uint32_t specificity() const {
    return std::min(ids, kMostOfAKind) * kIdWeight + std::min(classes, kMostOfAKind) * kClassWeight +
           std::min(types, kMostOfAKind);
  }
  void add(std::uint32_t specificity) {
    ids += specificity / kIdWeight;
    classes += specificity % kIdWeight / kClassWeight;
    types += specificity % kClassWeight;
  }
};

int whole_number(const std::string& digits) {
  constexpr std::size_t kMostDigits = 9;
  if (digits.empty() || digits.size() > kMostDigits) throw NotUnderstood();
  return std::atoi(digits.c_str());
}

/// Parses "odd", "even", "3", "2n + 1", "-n+4".
CssPlace parsed_place(const std::string& text) {
  if (text == "odd") return {2, 1};
  if (text == "even") return {2, 0};
  std::size_t at = 0;
  const auto sign = [&] { return at < text.size() && (text[at] == '+' || text[at] == '-') ? text[at++] : '\0'; };
  const auto digits = [&] {
    const std::size_t begin = at;
    while (at < text.size() && text[at] >= '0' && text[at] <= '9') ++at;
    return text.substr(begin, at - begin);
  };
  const auto spaces = [&] {
    constexpr std::string_view kComment = "/**/";  // divides tokens (css_text)
    while (at < text.size()) {
      if (text[at] == ' ') {
        ++at;
      } else if (text.compare(at, kComment.size(), kComment) == 0) {
        at += kComment.size();
      } else {
        return;
      }
    }
  };
  const int first_sign = sign() == '-' ? -1 : 1;
  const std::string first = digits();
  if (at == text.size()) return {0, first_sign * whole_number(first)};
  if (text[at++] != 'n') throw NotUnderstood();
  CssPlace place{first_sign * (first.empty() ? 1 : whole_number(first)), 0};
  spaces();
  if (at == text.size()) return place;
  const char second_sign = sign();
  if (second_sign == '\0') throw NotUnderstood();
  spaces();
  place.b = (second_sign == '-' ? -1 : 1) * whole_number(digits());
  if (at != text.size()) throw NotUnderstood();
  return place;
}

std::string lower_text(CssTokens tokens) {
  const std::optional<std::string> text = css_text(trimmed_css(tokens));
  if (!text) throw NotUnderstood();
  return ascii_lower_case(*text);
}

std::vector<CssSelector> parsed_list(CssTokens tokens, int nested);

/// One selector, without commas.
class SelectorParser {
 public:
  SelectorParser(CssTokens tokens, int nested) : tokens_(trimmed_css(tokens)), nested_(nested) {}

  CssSelector parsed() {
    selector_.compounds.push_back(compound());
    while (!tokens_.empty()) {
      selector_.combinators.push_back(combinator());
      selector_.compounds.push_back(compound());
    }
    selector_.specificity = counts_.specificity();
    return std::move(selector_);
  }

 private:
  bool stands_at(char mark, std::size_t ahead = 0) const {
    return ahead < tokens_.size() && tokens_[ahead].is_mark(mark);
  }
  bool stands_at(CssKind kind, std::size_t ahead = 0) const {
    return ahead < tokens_.size() && tokens_[ahead].kind == kind;
  }
  CssToken take() {
    if (tokens_.empty()) throw NotUnderstood();
    const CssToken& token = tokens_.front();
    tokens_ = tokens_.subspan(1);
    return token;
  }
  std::string take_name() {
    if (!stands_at(CssKind::identifier)) throw NotUnderstood();
    return take().text;
  }
  bool take_mark(char mark) {
    if (!stands_at(mark)) return false;
    take();
    return true;
  }
  bool take_space() {
    const std::size_t before = tokens_.size();
    while (stands_at(CssKind::space)) take();
    return tokens_.size() < before;
  }
  /// Takes the tokens up to the closing bracket, and the bracket itself. The end of the text closes all brackets.
  CssTokens take_block(char closer) {
    const std::size_t end = find_css_mark(tokens_, std::string_view(&closer, 1));
    const CssTokens block = tokens_.first(end);
    tokens_ = tokens_.subspan(std::min(end + 1, tokens_.size()));
    return block;
  }

  CssCombinator combinator() {
    const bool spaced = take_space();
    constexpr std::array<std::pair<char, CssCombinator>, 3> kMarks = {
        {{'>', CssCombinator::child}, {'+', CssCombinator::next}, {'~', CssCombinator::later}}};
    for (const auto& [mark, combinator] : kMarks) {
      if (!take_mark(mark)) continue;
      take_space();
      return combinator;
    }
    if (!spaced) throw NotUnderstood();
    return CssCombinator::descendant;
  }

  CssCompound compound() {
    const std::size_t before = tokens_.size();
    CssCompound compound;
    take_type(compound);
    while (take_condition(compound)) {
    }
    if (tokens_.size() == before) throw NotUnderstood();
    return compound;
  }

  /// Takes "*|" or "|". Other prefixes are unknown, as librsvg does not read @namespace.
  CssSpace take_space_of_names(CssSpace without) {
    if (stands_at('|') && !stands_at('=', 1)) return take(), CssSpace::none;
    const bool has_prefix =
        (stands_at('*') || stands_at(CssKind::identifier)) && stands_at('|', 1) && !stands_at('=', 2);
    if (!has_prefix) return without;
    if (!take_mark('*')) throw NotUnderstood();
    return take(), CssSpace::any;
  }

  void take_type(CssCompound& compound) {
    const std::size_t before = tokens_.size();
    compound.space = take_space_of_names(CssSpace::svg);
    if (take_mark('*')) return;
    if (stands_at(CssKind::identifier)) {
      compound.type = take().text;
      ++counts_.types;
    } else if (tokens_.size() != before) {
      throw NotUnderstood();
    }
  }

  bool take_condition(CssCompound& compound) {
    if (stands_at(CssKind::hash)) {
      if (!tokens_.front().is_name) throw NotUnderstood();
      compound.conditions.push_back(CssId{take().text});
      ++counts_.ids;
    } else if (take_mark('.')) {
      compound.conditions.push_back(CssClass{take_name()});
      ++counts_.classes;
    } else if (take_mark('[')) {
      compound.conditions.push_back(SelectorParser(take_block(']'), nested_).attribute());
      ++counts_.classes;
    } else if (take_mark(':')) {
      take_pseudo_class(compound);
    } else {
      return false;
    }
    return true;
  }

  /// Reads the content of an attribute selector's brackets.
  CssAttribute attribute() {
    CssAttribute attribute;
    attribute.space = take_space_of_names(CssSpace::none);
    attribute.name = take_name();
    take_space();
    if (tokens_.empty()) return attribute;
    attribute.test = attribute_test();
    take_space();
    if (!stands_at(CssKind::identifier) && !stands_at(CssKind::string)) throw NotUnderstood();
    attribute.value = take().text;
    take_space();
    if (tokens_.empty()) return attribute;
    const std::string flag = ascii_lower_case(take_name());
    if (!tokens_.empty() || (flag != "i" && flag != "s")) throw NotUnderstood();
    attribute.ignores_case = flag == "i";
    return attribute;
  }

  CssAttribute::Test attribute_test() {
    using Test = CssAttribute::Test;
    if (take_mark('=')) return Test::equals;
    constexpr std::array<std::pair<char, Test>, 5> kMarks = {{{'~', Test::has_word},
                                                              {'|', Test::has_language},
                                                              {'^', Test::begins},
                                                              {'$', Test::ends},
                                                              {'*', Test::contains}}};
    for (const auto& [mark, test] : kMarks) {
      if (take_mark(mark) && take_mark('=')) return test;
    }
    throw NotUnderstood();
  }

  void take_pseudo_class(CssCompound& compound) {
    if (stands_at(CssKind::function)) {
      compound.conditions.push_back(function(ascii_lower_case(take().text)));
      return;
    }
    static const std::map<std::string, std::vector<CssCondition>> kKnown = {
        {"root", {CssState::root}},
        {"scope", {CssState::root}},
        {"empty", {CssState::empty}},
        {"link", {CssState::link}},
        {"visited", {CssState::visited}},
        {"first-child", {kFirstChild}},
        {"last-child", {kLastChild}},
        {"only-child", {kFirstChild, kLastChild}},
        {"first-of-type", {kFirstOfType}},
        {"last-of-type", {kLastOfType}},
        {"only-of-type", {kFirstOfType, kLastOfType}}};
    const auto known = kKnown.find(ascii_lower_case(take_name()));
    if (known == kKnown.end()) throw NotUnderstood();
    compound.conditions.insert(compound.conditions.end(), known->second.begin(), known->second.end());
    ++counts_.classes;
  }

  CssCondition function(const std::string& name) {
    const CssTokens argument = take_block(')');
    if (name == "not") return negation(argument);
    ++counts_.classes;
    if (name == "lang") return languages(argument);
    if (!name.starts_with("nth-")) throw NotUnderstood();
    const std::string kind = name.substr(4);
    const bool from_end = kind.starts_with("last-");
    const bool of_type = kind.ends_with("of-type");
    if (kind != std::string(from_end ? "last-" : "") + (of_type ? "of-type" : "child")) throw NotUnderstood();
    CssPlace place = parsed_place(lower_text(argument));
    place.of_type = of_type;
    place.from_end = from_end;
    return place;
  }

  CssCondition negation(CssTokens argument) {
    if (nested_ == kMostNested) throw NotUnderstood();
    CssNot negated{parsed_list(argument, nested_ + 1)};
    std::uint32_t most = 0;
    for (const CssSelector& selector : negated.selectors) most = std::max(most, selector.specificity);
    counts_.add(most);
    return negated;
  }

  static CssCondition languages(CssTokens argument) {
    CssLanguages languages;
    while (true) {
      const std::size_t end = find_css_mark(argument, ",");
      const CssTokens range = trimmed_css(argument.first(end));
      if (range.size() != 1) throw NotUnderstood();
      if (range[0].kind != CssKind::identifier && range[0].kind != CssKind::string) throw NotUnderstood();
      languages.ranges.push_back(ascii_lower_case(range[0].text));
      if (end == argument.size()) return languages;
      argument = argument.subspan(end + 1);
    }
  }

  CssTokens tokens_;
  int nested_;
  CssSelector selector_;
  Counts counts_;
};

std::vector<CssSelector> parsed_list(CssTokens tokens, int nested) {
  std::vector<CssSelector> selectors;
  while (true) {
    const std::size_t end = find_css_mark(tokens, ",");
    selectors.push_back(SelectorParser(tokens.first(end), nested).parsed());
    if (end == tokens.size()) return selectors;
    tokens = tokens.subspan(end + 1);
  }
}

}  // namespace

std::optional<std::vector<CssSelector>> parse_css_selectors(CssTokens tokens) {
  try {
    return parsed_list(tokens, 0);
  } catch (const NotUnderstood&) {
    return std::nullopt;
  }
}

}  // namespace tessera
