#include "text/json_bounds.h"

#include <string>

#include "core/base/error.h"
#include "core/base/too_many.h"

namespace tessera {
namespace {

[[noreturn]] void fail(std::size_t most, const char* what) { throw InputError(too_many(most, what)); }

}  // namespace

void JsonScan::take(std::span<const char> part) {
  for (const char c : part) {
    if (in_text_)
      take_in_text(c);
    else
      take_between(c);
    if (token_bytes_ > bounds_.token_bytes) fail(bounds_.token_bytes, "bytes in a text or number");
  }
}

void JsonScan::take_in_text(char c) {
  ++token_bytes_;
  if (escaped_) {
    escaped_ = false;
  } else if (c == '\\') {
    escaped_ = true;
  } else if (c == '"') {
    in_text_ = false;
    token_bytes_ = 0;
  }
}

void JsonScan::take_between(char c) {
  ++token_bytes_;
  switch (c) {
    case '"':
      in_text_ = true;
      token_bytes_ = 0;
      break;
    case '[': open(false); break;
    case '{': open(true); break;
    case ']':
    case '}':
      if (!levels_.empty()) levels_.pop_back();
      token_bytes_ = 0;
      break;
    case ',':
      count_value();
      if (!levels_.empty() && levels_.back().is_object && ++levels_.back().members > bounds_.members)
        fail(bounds_.members, "members of one object");
      token_bytes_ = 0;
      break;
    case ':':
    case ' ':
    case '\t':
    case '\n':
    case '\r': token_bytes_ = 0; break;
    default: break;
  }
}

void JsonScan::open(bool is_object) {
  count_value();
  token_bytes_ = 0;
  if (levels_.size() >= bounds_.levels) fail(bounds_.levels, "levels of lists and objects in each other");
  levels_.push_back({is_object});
}

/// Counts a value: one stands behind each comma, and at the beginning of each list and object.
void JsonScan::count_value() {
  if (++values_ > bounds_.values) fail(bounds_.values, "values");
}

void check_json(std::string_view text, const JsonBounds& bounds) { JsonScan(bounds).take(text); }

}  // namespace tessera
