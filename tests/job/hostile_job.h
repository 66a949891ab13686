// Job files as an attacker or a broken program would write them. They follow from a seed, the same on every machine.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "job/job_tables.h"

namespace tessera::test {

class HostileJob {
 public:
  explicit HostileJob(std::uint32_t seed) : random_(seed) {}

  /// The text of a whole file. `library` and `canvas` are the values of those two keys in an otherwise valid file.
  std::string make(const std::string& library, const std::string& canvas = "") {
    std::string text = "[library]\nfile = '" + library + "'\n";
    if (!canvas.empty()) text += "[canvas]\nfile = '" + canvas + "'\n";
    if (below(4) == 0) return with_extreme(text);
    for (std::uint32_t i = 1 + below(2); i > 0; --i) text = with_assignment(text);
    return below(4) == 0 ? damaged(text) : text;
  }

  /// "section.key=value" with a value that the key may accept or refuse.
  std::string make_override() {
    const JobKey& key = any_key();
    return key.full_name() + "=" + value_for(key);
  }

 private:
  std::uint32_t below(std::uint32_t end) { return std::uint32_t(random_() % end); }

  template <class Item>
  const Item& any(const std::vector<Item>& items) {
    return items[below(std::uint32_t(items.size()))];
  }

  const JobKey& any_key() { return any(job_keys()); }

  static std::string repeated(const std::string& text, std::size_t times) {
    std::string result;
    for (std::size_t i = 0; i < times; ++i) result += text;
    return result;
  }

  static std::string number_text(double value) {
    std::ostringstream text;
    text.precision(17);
    text << value;
    return text.str();
  }

  static std::string with_line(const std::string& text, const JobKey& key, const std::string& line) {
    return key.section.empty() ? line + text : text + "[" + key.section + "]\n" + line;
  }

  /// A file with one extreme but legal value, so that some jobs stay legal, however many keys there are.
  std::string with_extreme(const std::string& text) {
    const JobKey& key = any_key();
    return with_line(text, key, key.name + " = " + extreme_of(key) + "\n");
  }

  std::string with_assignment(const std::string& text) {
    switch (below(8)) {
      case 0: return text + "[" + any(strange_names()) + "]\n" + any(strange_names()) + " = 1\n";
      case 1: return any(strange_names()) + " = " + any(wrong_types()) + "\n" + text;
      case 2: return text + any(structures()) + "\n";
      default: break;
    }
    if (below(4) == 0) return text + row();
    const JobKey& key = any_key();
    std::string name = below(12) == 0 ? any(strange_names()) : key.name;
    if (name.ends_with("_px") && below(6) == 0) name.replace(name.size() - 3, 3, "_mm");
    return with_line(text, key, name + " = " + value_for(key) + "\n");
  }

  /// Damages the bytes of a file: cuts it, changes bytes, or uses another encoding.
  std::string damaged(std::string text) {
    switch (below(8)) {
      case 0: return text.substr(0, below(std::uint32_t(text.size())));
      case 1: return text.insert(below(std::uint32_t(text.size())), 1, '\0');
      case 2:
        return text.insert(below(std::uint32_t(text.size())),
                           any(std::vector<std::string>{"\xff", "\xc0\xaf", "\xed\xa0\x80", "\xf5\x80\x80\x80",
                                                        "\xe2\x80\xae", "\x1b[2J", "\r"}));
      case 3: return "\xef\xbb\xbf" + text;
      case 4: return "\xff\xfe" + text;
      case 5: return text + repeated("# padding\n", 300'000);
      case 6: return text + "\nseed = \"" + std::string(3'000'000, 'x') + "\"\n";
      default: break;
    }
    for (std::uint32_t i = 1 + below(8); i > 0; --i) text[below(std::uint32_t(text.size()))] = char(below(256));
    return text;
  }

  /// A row of a table that may occur any number of times.
  std::string row() {
    const JobTable& table = any(job_tables());
    std::string text = "[[" + table.name + "]]\n";
    for (const JobKey& column : table.columns) {
      if (below(3) == 0) continue;
      text += (below(12) == 0 ? any(strange_names()) : column.name) + " = " + value_for(column) + "\n";
    }
    return text;
  }

  std::string value_for(const JobKey& key) {
    const std::string min = number_text(key.min);
    const std::string max = number_text(key.max);
    switch (below(12)) {
      case 0: return any(wrong_types());
      case 1: return any(numbers());
      case 2: return min;
      case 3: return max;
      case 4: return number_text(std::nextafter(key.max, 1e300));
      case 5: return number_text(key.min - 1);
      case 6: return "[" + max + ", " + min + "]";
      case 7: return "[" + min + ", " + max + "]";
      case 8: return "[" + any(numbers()) + ", " + any(numbers()) + "]";
      default: return extreme_of(key);
    }
  }

  /// A value at the limit of the allowed range.
  std::string extreme_of(const JobKey& key) {
    const std::string end = number_text(below(2) == 0 ? key.min : key.max);
    switch (key.kind) {
      case JobKind::number:
      case JobKind::integer: return end;
      case JobKind::flag: return "true";
      case JobKind::intervals:
        return any(std::vector<std::string>{"[" + number_text(key.min) + ", " + number_text(key.max) + "]", end,
                                            "[[" + end + "], [" + end + ", " + end + "]]",
                                            "[" + repeated(end + ", ", 15) + end + "]"});
      case JobKind::point: return "[" + end + ", " + end + "]";
      case JobKind::uses: return "[" + number_text(key.min) + ", " + end + "]";
      case JobKind::name: return "\"" + std::string(400, '*') + "\"";
      case JobKind::paper_size: return "[" + end + ", " + end + "]";
      case JobKind::size: return "[16, " + end + "]";
      case JobKind::devices:
      case JobKind::word: return "\"" + any(key.words) + "\"";
      case JobKind::file: return "\"" + std::string(2000, 'f') + "/../own.h5\"";
      case JobKind::texts:
        if (key.name == "not_anew") return "[]";  // all other keys take patterns
        return "[\"*\", \"" + std::string(2000, '*') + "[\", \"[[:alpha:]]\"]";
      case JobKind::indices: return "[" + end + "]";
      case JobKind::files: return "[\"own.h5\", \"own.h5\"]";
      case JobKind::palette: return "[\"#FFFFFF\", \"#000000\"]";
      case JobKind::colour: return "\"#FFFFFF\"";
    }
    return {};
  }

  static const std::vector<std::string>& numbers() {
    static const std::vector<std::string> list = {"0",
                                                  "-0.0",
                                                  "1",
                                                  "-1",
                                                  "16",
                                                  "1e308",
                                                  "-1e308",
                                                  "1e999",
                                                  "5e-324",
                                                  "nan",
                                                  "-nan",
                                                  "inf",
                                                  "-inf",
                                                  "9223372036854775807",
                                                  "9223372036854775808",
                                                  "-9223372036854775808",
                                                  "0x7fffffffffffffff",
                                                  "2147483648",
                                                  "4294967296",
                                                  "18446744073709551616",
                                                  "1_0",
                                                  "1.",
                                                  "0o777",
                                                  "1e-7",
                                                  "20000",
                                                  "99999999999999999999999999"};
    return list;
  }

  static const std::vector<std::string>& wrong_types() {
    static const std::vector<std::string> list = {"true",
                                                  "1979-05-27T07:32:00Z",
                                                  "07:32:00",
                                                  "{}",
                                                  "{a = {b = 1}}",
                                                  "\"\"",
                                                  "[]",
                                                  "[[]]",
                                                  "[[1], [2]]",
                                                  "[1]",
                                                  "[1, 2, 3]",
                                                  "[\"a\", 1]",
                                                  "[nan, nan]",
                                                  "[1, true]",
                                                  "\"a\\u0000b\"",
                                                  "\"\\uFFFF\\U0010FFFF\"",
                                                  "\"\\n\\t\\r\\u001b[31m\"",
                                                  "\"" + std::string(9000, 'x') + "\"",
                                                  "\"#12345\"",
                                                  "\"#ffffff\"",
                                                  "\"0,0\"",
                                                  "\"all\"",
                                                  "'''\nlines\n'''",
                                                  "[" + repeated("1, ", 3000) + "1]"};
    return list;
  }

  static const std::vector<std::string>& strange_names() {
    static const std::vector<std::string> list = {"\"\"",
                                                  "seed",
                                                  "pieces",
                                                  "piecse",
                                                  "canvas.size_px",
                                                  "\"a.b\"",
                                                  "\"new\\nline\"",
                                                  "\"\\u0000\"",
                                                  "\"ключ\"",
                                                  "a",
                                                  std::string(5000, 'k'),
                                                  repeated("a.", 7000) + "a",
                                                  "\"" + std::string(3000, '.') + "\"",
                                                  "-",
                                                  "1",
                                                  "__proto__"};
    return list;
  }

  /// Structures that break parsers: duplicate keys, deep nesting, unclosed brackets.
  static const std::vector<std::string>& structures() {
    static const std::vector<std::string> list = {
        "[pieces]\nuses = 1\nuses = 2",
        "[pieces]\nuses = 1\n[pieces]\nuses = 2",
        "[[pieces]]\nuses = 1",
        "[stop]\npieces = " + std::string(15000, '['),
        "[stop]\npieces = " + std::string(200, '[') + std::string(200, ']'),
        "[stop]\npieces = " + repeated("{a = ", 2500) + "1" + std::string(2500, '}'),
        "[stop]\npieces = " + repeated("{a = ", 100) + "1" + std::string(100, '}'),
        "[" + repeated("a.", 7500) + "a]",
        "[stop]\n" + repeated("a.", 7500) + "a = 1",
        "[stop",
        "pieces = \"",
        "pieces = '''",
        "= 1",
        "[]",
        "[[]]",
        "stop = {pieces = 1}\n[stop]\ncoverage = 0.5",
        "[stop]\npieces.more = 1",
        repeated("[a]\n", 3),
        repeated("[[a]]\n", 2500)};
    return list;
  }

  std::mt19937 random_;
};

}  // namespace tessera::test
