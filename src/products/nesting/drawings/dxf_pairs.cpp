#include "products/nesting/drawings/dxf_pairs.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "core/base/error.h"
#include "core/base/split_text.h"
#include "text/utf8_text.h"

namespace tessera {

DxfPairs::DxfPairs(std::string_view text, const std::string& path) : rest_(text), path_(path) {
  if (text.starts_with("AutoCAD Binary DXF")) throw InputError(path + ": a binary DXF; save it as ASCII DXF");
  if (text.starts_with("AC10")) throw InputError(path + ": a DWG; save it as ASCII DXF");
}

bool DxfPairs::next(DxfPair& pair) {
  std::string_view code;
  if (!next_line(code) || (trimmed(code).empty() && rest_.empty())) return false;
  pair.line = line_;
  const std::string_view number = trimmed(code);
  const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), pair.code);
  if (error != std::errc() || end != number.data() + number.size())
    fail(line_, "found \"" + std::string(number.substr(0, 20)) + "\", allowed: the number of a group code");
  if (!next_line(pair.value)) fail(line_, "ends within a pair of lines");
  pair.value = trimmed(pair.value);
  return true;
}

double DxfPairs::number(const DxfPair& pair) const {
  double value = 0;
  const std::string_view text = pair.value.starts_with('+') ? pair.value.substr(1) : pair.value;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool is_whole = end == text.data() + text.size();  // false for "50,5"
  if (error != std::errc() || !is_whole || !std::isfinite(value) || std::abs(value) > 1e12)
    fail(pair.line + 1,
         "found \"" + std::string(pair.value.substr(0, 20)) + "\", allowed: a number from -1e12 to 1e12");
  return value;
}

void DxfPairs::fail(int line, const std::string& what) const {
  throw InputError(path_ + ": line " + std::to_string(line) + ": " + printable_utf8(what));
}

bool DxfPairs::next_line(std::string_view& line) {
  if (rest_.empty()) return false;
  const std::size_t end = std::min(rest_.find('\n'), rest_.size());
  line = rest_.substr(0, end);
  rest_.remove_prefix(std::min(end + 1, rest_.size()));
  ++line_;
  return true;
}

}  // namespace tessera
