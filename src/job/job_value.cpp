#include "job/job_value.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <set>
#include <sstream>

#include "core/base/split_text.h"
#include "job/palette.h"
#include "job/toml_string.h"

namespace tessera {
namespace {

using Result = std::optional<JobValue>;

constexpr std::size_t kLongestName = 400;  // bytes

std::optional<double> number_in_range(const JobKey& key, const toml::node& node, bool whole) {
  if (!node.is_integer() && (whole || !node.is_floating_point())) return {};
  const double value = node.is_integer() ? double(node.as_integer()->get()) : node.as_floating_point()->get();
  if (!(value >= key.min && value <= key.max)) return {};  // NaN fails too
  return value;
}

using Numbers = std::optional<std::vector<double>>;

/// All numbers of an array; nullopt where one is out of range.
Numbers numbers_in_range(const JobKey& key, const toml::array& array, bool whole) {
  std::vector<double> numbers;
  for (const toml::node& item : array) {
    const auto number = number_in_range(key, item, whole);
    if (!number) return {};
    numbers.push_back(*number);
  }
  return numbers;
}

Result read_one(const JobKey& key, const toml::node& node) {
  const auto value = number_in_range(key, node, key.kind == JobKind::integer);
  return value ? Result(JobValue{{*value}, {}}) : Result();
}

Result read_flag(const toml::node& node) {
  const auto value = node.value_exact<bool>();
  return value ? Result(JobValue{{}, *value ? "true" : "false"}) : Result();
}

Result read_two(const JobKey& key, const toml::node& node) {
  const toml::array* array = node.as_array();
  if (!array || array->size() != 2) return {};
  const Numbers both = numbers_in_range(key, *array, key.kind == JobKind::size);
  if (!both) return {};
  if (key.kind == JobKind::size && (*both)[0] * (*both)[1] > kMaxCanvas_px2) return {};
  return JobValue{*both, {}};
}

/// Two sizes, or two zeros.
Result read_paper_size(const JobKey& key, const toml::node& node) {
  const JobKey none{.section = {}, .name = {}, .kind = JobKind::point, .unit = {}};
  const Result absent = read_two(none, node);
  return absent ? absent : read_two(key, node);
}

/// Appends [min, max] to `pairs`; [value] and a single value become the interval from the value to itself.
bool read_interval(const JobKey& key, const toml::node& node, std::vector<double>& pairs) {
  Numbers numbers;
  if (const toml::array* array = node.as_array()) {
    numbers = numbers_in_range(key, *array, false);
  } else if (const auto number = number_in_range(key, node, false)) {
    numbers = std::vector{*number};
  }
  if (!numbers || numbers->empty() || numbers->size() > 2 || numbers->front() > numbers->back()) return false;
  pairs.insert(pairs.end(), {numbers->front(), numbers->back()});
  return true;
}

/// Two plain numbers are one interval; any other count of plain numbers is that many single values.
Result read_intervals(const JobKey& key, const toml::node& node) {
  std::vector<double> pairs;
  const toml::array* array = node.as_array();
  const bool one = !array || (array->size() == 2 && !array->get(0)->is_array() && !array->get(1)->is_array());
  if (one) return read_interval(key, node, pairs) ? Result(JobValue{pairs, {}}) : Result();
  if (array->empty() || array->size() > kMostIntervals) return {};
  for (const toml::node& item : *array) {
    if (!read_interval(key, item, pairs)) return {};
  }
  return JobValue{pairs, {}};
}

/// [at least, at most] as numbers; at most 0: no limit.
Result read_uses(const JobKey& key, const toml::node& node) {
  if (const auto most = number_in_range(key, node, true)) return JobValue{{0, *most}, {}};
  const toml::array* array = node.as_array();
  if (!array || array->size() != 2) return {};
  const Numbers both = numbers_in_range(key, *array, true);
  if (!both || ((*both)[1] != 0 && (*both)[0] > (*both)[1])) return {};
  return JobValue{*both, {}};
}

bool is_name(const std::string& text) {
  return !text.empty() && text.size() <= kLongestName && text.find('\0') == std::string::npos;
}

Result read_word(const JobKey& key, const std::string& text) {
  const bool known = std::find(key.words.begin(), key.words.end(), text) != key.words.end();
  return known ? Result(JobValue{{}, text}) : Result();
}

Result read_file_name(const std::string& text) {
  return text.find('\0') == std::string::npos ? Result(JobValue{{}, text}) : Result();
}

Result read_colour(std::string text) {
  const bool right = text.size() == 7 && text[0] == '#' &&
                     std::all_of(text.begin() + 1, text.end(), [](unsigned char c) { return std::isxdigit(c); });
  if (!right) return {};
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return char(std::tolower(c)); });
  return JobValue{{}, text};
}

/// A single text is a list of one, an empty text an empty list: values of --set need no brackets.
Result read_texts(const toml::node& node) {
  std::vector<std::string> texts;
  const auto add = [&](const toml::node& item) {
    const auto* text = item.as_string();
    if (!text || text->get().empty() || text->get().find('\0') != std::string::npos) return false;
    texts.push_back(text->get());
    return true;
  };
  if (const auto* text = node.as_string(); text && text->get().empty()) return JobValue{};
  const toml::array* array = node.as_array();
  const bool right = array ? std::all_of(array->begin(), array->end(), add) : add(node);
  return right ? Result(JobValue{{}, {}, std::move(texts)}) : Result();
}

/// A list holds colours; a single text may also be a name or a path.
Result read_palette(const toml::node& node) {
  Result value = read_texts(node);
  if (!value || value->texts.empty()) return {};
  if (!node.is_array() && value->texts[0][0] != '#') return value;
  for (std::string& text : value->texts) {
    const Result colour = read_colour(text);
    if (!colour) return {};
    text = colour->text;
  }
  return value;
}

/// "0, 2" -> {0, 2}; nullopt where the text is no list of whole numbers.
std::optional<std::vector<double>> split_indices(const std::string& text) {
  std::vector<double> indices;
  for (const std::string_view part : split_outside(text, ',')) {
    int index = 0;
    const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), index);
    if (error != std::errc() || end != part.data() + part.size()) return {};
    indices.push_back(index);
  }
  return indices;
}

Result join_indices(const JobKey& key, const std::vector<double>& indices) {
  const bool in_range =
      std::all_of(indices.begin(), indices.end(), [&](double index) { return index >= key.min && index <= key.max; });
  const bool distinct = std::set<double>(indices.begin(), indices.end()).size() == indices.size();
  if (indices.empty() || !in_range || !distinct) return {};
  std::string text;
  for (const double index : indices) {
    if (!text.empty()) text += ',';
    text += std::to_string(int(index));
  }
  return JobValue{{}, text};
}

std::optional<std::vector<double>> read_indices(const JobKey& key, const toml::node& node) {
  if (const auto* text = node.as_string()) return split_indices(text->get());
  if (const auto index = number_in_range(key, node, true)) return std::vector{*index};
  std::vector<double> indices;
  if (!node.is_array()) return {};
  for (const toml::node& item : *node.as_array()) {
    const auto index = number_in_range(key, item, true);
    if (!index) return {};
    indices.push_back(*index);
  }
  return indices;
}

Result read_devices(const JobKey& key, const toml::node& node) {
  if (const auto* text = node.as_string()) {
    if (const Result word = read_word(key, text->get())) return word;
  }
  const auto indices = read_indices(key, node);
  return indices ? join_indices(key, *indices) : Result();
}

/// A single number is a list of one.
Result read_distinct_indices(const JobKey& key, const toml::node& node) {
  if (node.is_array() && node.as_array()->empty()) return JobValue{};
  const auto indices = read_indices(key, node);
  if (!indices || !join_indices(key, *indices)) return {};
  return JobValue{*indices, {}};
}

Result read_text(const JobKey& key, const toml::node& node) {
  const auto* text = node.as_string();
  if (!text) return {};
  if (key.kind == JobKind::word) return read_word(key, text->get());
  if (key.kind == JobKind::name) return is_name(text->get()) ? Result(JobValue{{}, text->get()}) : Result();
  if (key.kind == JobKind::colour) {
    const Result word = read_word(key, text->get());
    return word ? word : read_colour(text->get());
  }
  return read_file_name(text->get());
}

std::string with_unit(const JobKey& key, const std::string& text) {
  return key.unit.empty() ? text : text + " " + key.unit;
}

std::string number_text(double value, int digits = 15) {
  constexpr double kExactWhole = 1e16;
  if (value == std::floor(value) && std::abs(value) < kExactWhole) return std::to_string(std::int64_t(value));
  std::ostringstream text;
  text.precision(digits);
  text << value;
  return text.str();
}

std::string quoted_words(const JobKey& key, const std::string& separator) {
  std::string text;
  for (const auto& word : key.words) text += (text.empty() ? "" : separator) + '"' + word + '"';
  return text;
}

/// Number `i` with the fewest digits that give the same value in the job's own type (float, radians).
std::string shortest_number(const JobKey& key, const Job& job, std::size_t i) {
  const JobValue exact = key.get(job);
  int digits = 1;
  for (; digits < 17; ++digits) {
    JobValue rounded = exact;
    rounded.numbers[i] = std::stod(number_text(exact.numbers[i], digits));
    Job scratch;
    key.set(scratch, rounded);
    if (key.get(scratch) == exact) return number_text(rounded.numbers[i], digits);
  }
  return number_text(exact.numbers[i], digits);
}

/// The value with the fewest digits that give the same number.
std::string exact_number(double value) {
  int digits = 1;
  while (digits < 17 && std::stod(number_text(value, digits)) != value) ++digits;
  return number_text(value, digits);
}

std::string listed(const std::vector<std::string>& items) {
  std::string text = "[";
  for (const std::string& item : items) text += (text.size() > 1 ? ", " : "") + item;
  return text + "]";
}

std::string quoted_list(const std::vector<std::string>& texts) {
  std::vector<std::string> items;
  for (const std::string& text : texts) items.push_back(toml_string(text));
  return listed(items);
}

/// The value as TOML; `number(i)` writes value.numbers[i].
template <class Number>
std::string value_text(const JobKey& key, const JobValue& value, Number number) {
  if (key.kind == JobKind::texts || key.kind == JobKind::files) return quoted_list(value.texts);
  if (key.kind == JobKind::palette)
    return is_colour_list(value.texts) ? quoted_list(value.texts) : toml_string(value.texts[0]);
  if (key.kind == JobKind::flag) return value.text;
  if (key.kind == JobKind::indices) {
    std::vector<std::string> indices;
    for (const double index : value.numbers) indices.push_back(number_text(index));
    return listed(indices);
  }
  if (value.numbers.empty()) return toml_string(value.text);
  if (value.numbers.size() == 1) return number(0);
  if (key.kind == JobKind::uses && value.numbers[0] == 0) return number(1);
  std::vector<std::string> items;
  for (std::size_t i = 0; i + 1 < value.numbers.size(); i += 2) items.push_back(listed({number(i), number(i + 1)}));
  return items.size() == 1 ? items.front() : listed(items);
}

}  // namespace

std::optional<JobValue> read_job_value(const JobKey& key, const toml::node& node) {
  switch (key.kind) {
    case JobKind::number:
    case JobKind::integer: return read_one(key, node);
    case JobKind::flag: return read_flag(node);
    case JobKind::intervals: return read_intervals(key, node);
    case JobKind::point:
    case JobKind::size: return read_two(key, node);
    case JobKind::paper_size: return read_paper_size(key, node);
    case JobKind::uses: return read_uses(key, node);
    case JobKind::devices: return read_devices(key, node);
    case JobKind::indices: return read_distinct_indices(key, node);
    case JobKind::texts:
    case JobKind::files: return read_texts(node);
    case JobKind::palette: return read_palette(node);
    default: return read_text(key, node);
  }
}

std::string range_text(const JobKey& key) { return number_text(key.min) + " to " + number_text(key.max); }

std::string allowed_values(const JobKey& key) {
  const std::string range = range_text(key);
  switch (key.kind) {
    case JobKind::number: return with_unit(key, "a number from " + range);
    case JobKind::integer: return with_unit(key, "a whole number from " + range);
    case JobKind::flag: return "true or false";
    case JobKind::intervals:
      return "one value, [min, max] with the smaller one first, a list of three values or more, or a list of [min, "
             "max], from " +
             with_unit(key, range);
    case JobKind::point: return with_unit(key, "[x, y], numbers from " + range);
    case JobKind::uses:
      return "a whole number from " + range + ", or [at least, at most] of such; at most 0 = unlimited";
    case JobKind::name: return "a text";
    case JobKind::size:
      return with_unit(key, "[width, height], whole numbers from " + range) + ", " + number_text(kMaxCanvas_px2 / 1e6) +
             " million px or less in all";
    case JobKind::paper_size: return with_unit(key, "[width, height], numbers from " + range) + ", or [0, 0]";
    case JobKind::word: return quoted_words(key, " or ");
    case JobKind::file: return "a path";
    case JobKind::texts: return "a text, or a list of texts";
    case JobKind::files: return "a list of paths";
    case JobKind::palette:
      return quoted_words(key, ", ") +
             ", the path of a GIMP palette or of a file with a #rrggbb a line, or a list of "
             "\"#rrggbb\"";
    case JobKind::colour: return "\"#rrggbb\"" + (key.words.empty() ? "" : " or " + quoted_words(key, " or "));
    case JobKind::devices:
      return quoted_words(key, ", ") + " or distinct indices from " + range + " like \"0,2\" or [0, 2]";
    case JobKind::indices: return "a list of distinct whole numbers from " + range;
  }
  return {};
}

std::string job_value_to_toml(const JobKey& key, const Job& job) {
  return value_text(key, key.get(job), [&](std::size_t i) { return shortest_number(key, job, i); });
}

std::string cell_to_toml(const JobKey& column, const JobValue& value) {
  return value_text(column, value, [&](std::size_t i) { return exact_number(value.numbers[i]); });
}

}  // namespace tessera
