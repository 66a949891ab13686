// Limits for a foreign JSON text, checked on its characters before a parser sees them: two bytes of the file can take
// some hundred bytes of memory in a parser.
#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <string_view>
#include <vector>

namespace tessera {

struct JsonBounds {
  static constexpr std::size_t kAny = std::numeric_limits<std::size_t>::max();

  std::size_t values = kAny;                       // in total: a tree takes 200 bytes for each, or less
  std::size_t levels = kAny;                       // depth of lists and objects in each other
  std::size_t members = kAny;                      // of one object: an ordered tree compares each with each
  std::size_t token_bytes = std::size_t(1) << 20;  // of one text or number
};

/// Checks a text that comes in parts.
class JsonScan {
 public:
  explicit JsonScan(const JsonBounds& bounds) : bounds_(bounds) {}

  /// Throws InputError with what was found and what is allowed, without the name of the file.
  void take(std::span<const char> part);

 private:
  /// A list or an object that is not closed yet.
  struct Level {
    bool is_object = false;
    std::size_t members = 1;
  };

  void take_in_text(char c);
  void take_between(char c);
  void open(bool is_object);
  void count_value();

  JsonBounds bounds_;
  std::vector<Level> levels_;
  std::size_t values_ = 0;
  std::size_t token_bytes_ = 0;
  bool in_text_ = false;
  bool escaped_ = false;
};

/// Checks a whole text. Throws as JsonScan does.
void check_json(std::string_view text, const JsonBounds& bounds);

}  // namespace tessera
