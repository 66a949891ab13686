#include "io/job/job_value.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <set>
#include <sstream>

#include "core/base/split_text.h"

namespace tessera::io {
namespace {

using Result = std::optional<JobValue>;

std::optional<double> number_in_range(const JobKey& key, const toml::node& node, bool whole) {
  if (!node.is_integer() && (whole || !node.is_floating_point())) return {};
  const double value = node.is_integer() ? double(node.as_integer()->get()) : node.as_floating_point()->get();
  if (!(value >= key.min && value <= key.max)) return {};  // NaN fails too
  return value;
}

Result read_one(const JobKey& key, const toml::node& node) {
  const auto value = number_in_range(key, node, key.kind == JobKind::integer);
  return value ? Result(JobValue{{*value}, {}}) : Result();
}

Result read_two(const JobKey& key, const toml::node& node) {
  const toml::array* array = node.as_array();
  if (!array || array->size() != 2) return {};
  const bool whole = key.kind == JobKind::size;
  const auto first = number_in_range(key, *array->get(0), whole);
  const auto second = number_in_range(key, *array->get(1), whole);
  if (!first || !second) return {};
  if (key.kind == JobKind::size && *first * *second > kMaxCanvas_px2) return {};
  if (key.kind == JobKind::interval && *first > *second) return {};
  if (key.kind == JobKind::proper_interval && *first >= *second) return {};
  return JobValue{{*first, *second}, {}};
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

/// "0, 2" -> {0, 2}; nothing where it is no list of whole numbers.
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
  const bool in_range = std::all_of(indices.begin(), indices.end(),
                                    [&](double index) { return index >= key.min && index <= key.max; });
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

Result read_text(const JobKey& key, const toml::node& node) {
  const auto* text = node.as_string();
  if (!text) return {};
  if (key.kind == JobKind::word) return read_word(key, text->get());
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

/// The fewest digits with which number `i` comes back from the job's own type (float, radians) unchanged.
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

std::string quoted(const std::string& text) {
  std::ostringstream out;
  out << toml::toml_formatter(toml::value<std::string>(text), toml::format_flags::none);
  return out.str();
}

}  // namespace

std::optional<JobValue> read_job_value(const JobKey& key, const toml::node& node) {
  switch (key.kind) {
    case JobKind::number:
    case JobKind::integer: return read_one(key, node);
    case JobKind::interval:
    case JobKind::proper_interval:
    case JobKind::offset:
    case JobKind::size: return read_two(key, node);
    case JobKind::devices: return read_devices(key, node);
    default: return read_text(key, node);
  }
}

std::string allowed_values(const JobKey& key) {
  const std::string min = number_text(key.min);
  const std::string max = number_text(key.max);
  switch (key.kind) {
    case JobKind::number: return with_unit(key, "a number from " + min + " to " + max);
    case JobKind::integer: return with_unit(key, "a whole number from " + min + " to " + max);
    case JobKind::interval: return with_unit(key, "[min, max] with " + min + " <= min <= max <= " + max);
    case JobKind::proper_interval: return with_unit(key, "[min, max] with " + min + " <= min < max <= " + max);
    case JobKind::size:
      return with_unit(key, "[width, height], whole numbers from " + min + " to " + max) + ", " +
             number_text(kMaxCanvas_px2 / 1e6) + " million px or less in all";
    case JobKind::offset: return with_unit(key, "[x, y], numbers from " + min + " to " + max);
    case JobKind::word: return quoted_words(key, " or ");
    case JobKind::file: return "a path";
    case JobKind::colour: return "\"#rrggbb\"" + (key.words.empty() ? "" : " or " + quoted_words(key, " or "));
    case JobKind::devices:
      return quoted_words(key, ", ") + " or distinct indices from " + min + " to " + max + " like \"0,2\" or [0, 2]";
  }
  return {};
}

std::string job_value_to_toml(const JobKey& key, const Job& job) {
  const JobValue value = key.get(job);
  if (value.numbers.empty()) return quoted(value.text);
  if (value.numbers.size() == 1) return shortest_number(key, job, 0);
  std::string text = "[";
  return text.append(shortest_number(key, job, 0)).append(", ").append(shortest_number(key, job, 1)).append("]");
}

}  // namespace tessera::io
