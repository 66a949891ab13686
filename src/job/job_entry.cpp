#include "job/job_entry.h"

#include <algorithm>
#include <sstream>

#include "core/base/error.h"
#include "core/base/split_text.h"
#include "job/job_value.h"
#include "job/millimetres.h"
#include "job/palette.h"
#include "text/nearest_name.h"
#include "text/utf8_text.h"

namespace tessera {
namespace {

std::string found_text(const toml::node& node) {
  std::ostringstream text;
  node.visit([&](const auto& value) { text << toml::toml_formatter(value, toml::format_flags::none); });
  return printable(text.str());
}

std::vector<std::string> section_names() {
  std::vector<std::string> names;
  for (const auto& key : job_keys()) {
    if (!key.section.empty() && (names.empty() || names.back() != key.section)) names.push_back(key.section);
  }
  return names;
}

std::vector<std::string> key_names(const std::string& section) {
  std::vector<std::string> names;
  for (const auto& key : job_keys()) {
    if (key.section == section) names.push_back(key.name);
  }
  return names;
}

std::string full_name(const JobEntry& entry) {
  return entry.section.empty() ? entry.name : entry.section + "." + entry.name;
}

/// The nearest key name: first in the entry's own section, then the same or a similar name elsewhere.
std::string suggestion(const JobEntry& entry) {
  if (const auto name = nearest_name(entry.name, key_names(entry.section)); !name.empty()) {
    return find_job_key(entry.section, name)->full_name();
  }
  std::vector<std::string> full_names;
  for (const auto& key : job_keys()) {
    if (key.name == entry.name) return key.full_name();
    full_names.push_back(key.full_name());
  }
  return nearest_name(full_name(entry), full_names);
}

/// The names of all tables, for messages: ", [[shapes]], [[regions]]".
std::string table_names() {
  std::string text;
  for (const JobTable& table : job_tables()) text += ", [[" + table.name + "]]";
  return text;
}

std::vector<std::string> column_names(const JobTable& table) {
  std::vector<std::string> names;
  for (const JobKey& column : table.columns) names.push_back(column.name);
  return names;
}

std::string did_you_mean(const std::string& nearest) {
  return nearest.empty() ? "" : " (did you mean " + nearest + "?)";
}

[[noreturn]] void fail_unknown_section(const JobEntry& entry) {
  if (find_job_table(entry.section)) {
    throw InputError(entry.where + ": [" + entry.section + "] is a table that may come several times; " +
                     "allowed: [[" + entry.section + "]], with two brackets on each side");
  }
  const std::string nearest = nearest_name(entry.section, section_names());
  throw InputError(entry.where + ": unknown section [" + printable(entry.section) + "]" +
                   did_you_mean(nearest.empty() ? "" : "[" + nearest + "]") + "; allowed: " + joined(section_names()) +
                   table_names());
}

[[noreturn]] void fail_unknown_key(const JobEntry& entry) {
  if (entry.section.empty() && find_job_table(entry.name)) {
    throw InputError(entry.where + ": " + entry.name + ": found " + found_text(*entry.value) +
                     ", allowed: tables that begin with [[" + entry.name + "]]");
  }
  if (entry.section.empty() && is_job_section(entry.name)) {
    throw InputError(entry.where + ": " + entry.name + " is a section with the keys " + joined(key_names(entry.name)) +
                     ", found " + found_text(*entry.value));
  }
  if (entry.section.empty() && entry.value->is_array_of_tables()) {
    std::vector<std::string> names;
    for (const JobTable& table : job_tables()) names.push_back(table.name);
    const std::string nearest = nearest_name(entry.name, names);
    throw InputError(entry.where + ": unknown tables [[" + printable(entry.name) + "]]" +
                     did_you_mean(nearest.empty() ? "" : "[[" + nearest + "]]") +
                     "; allowed: " + table_names().substr(2));
  }
  const std::string place = entry.section.empty() ? "at top level" : "in [" + entry.section + "]";
  throw InputError(entry.where + ": unknown key " + printable(full_name(entry)) + did_you_mean(suggestion(entry)) +
                   "; allowed " + place + ": " + joined(key_names(entry.section)));
}

/// The canvas length in px for a name in mm, searched with `find`; null where there is no such length.
template <class Find>
const JobKey* length_in_mm(const std::string& name, Find find) {
  const std::string in_px = name_in_px(name);
  const JobKey* key = in_px.empty() || find(name) ? nullptr : find(in_px);
  return key && is_canvas_length(*key) ? key : nullptr;
}

const JobKey* length_in_mm(const JobEntry& entry) {
  return length_in_mm(entry.name, [&](const std::string& name) { return find_job_key(entry.section, name); });
}

/// A length in mm, converted to px. `about` begins the message.
JobValue length_in_px(const JobKey& key, const toml::node& node, const CanvasSpec& canvas, const std::string& about) {
  const double px = px_per_mm(canvas);
  if (px == 0) {
    throw InputError(about + ": found " + found_text(node) + "; needed: canvas.size_mm, the canvas' size on paper");
  }
  const JobKey in_mm = key_in_mm(key, px);
  const auto value = read_job_value(in_mm, node);
  if (!value) throw InputError(about + ": found " + found_text(node) + ", allowed: " + allowed_values(in_mm));
  return value_in_px(key, *value, px);
}

}  // namespace

bool is_length_in_mm(const JobEntry& entry) { return length_in_mm(entry) != nullptr; }

std::string printable(std::string text, std::size_t max_bytes) {
  std::replace_if(
      text.begin(), text.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; }, ' ');
  return text.size() <= max_bytes ? text : cut_utf8(text, max_bytes) + "...";
}

toml::table parse_value(const std::string& text) {
  try {
    toml::table table = toml::parse("value = " + text);
    if (table.size() == 1 && table.contains("value")) return table;
  } catch (const toml::parse_error&) {
  }
  return toml::table{{"value", text}};
}

bool is_job_section(const std::string& name) {
  const auto names = section_names();
  return std::find(names.begin(), names.end(), name) != names.end();
}

void apply_entry(const JobEntry& entry, Job& job) {
  if (!entry.section.empty() && !is_job_section(entry.section)) fail_unknown_section(entry);
  if (const JobKey* length = length_in_mm(entry)) {
    length->set(job, length_in_px(*length, *entry.value, job.canvas, entry.where + ": " + full_name(entry)));
    return;
  }
  const JobKey* key = find_job_key(entry.section, entry.name);
  if (!key) fail_unknown_key(entry);
  auto value = read_job_value(*key, *entry.value);
  if (!value) {
    throw InputError(entry.where + ": " + key->full_name() + ": found " + found_text(*entry.value) +
                     ", allowed: " + allowed_values(*key));
  }
  if (key->kind == JobKind::file && !value->text.empty()) {
    value->text = (entry.base / value->text).lexically_normal().string();
  }
  if (key->kind == JobKind::files) {
    for (std::string& path : value->texts) path = (entry.base / path).lexically_normal().string();
  }
  const auto is_word = [&](const std::string& text) {
    return std::find(key->words.begin(), key->words.end(), text) != key->words.end();
  };
  if (key->kind == JobKind::palette && !is_colour_list(value->texts) && !is_word(value->texts[0])) {
    value->texts[0] = (entry.base / value->texts[0]).lexically_normal().string();
  }
  key->set(job, *value);
}

const JobKey* length_in_mm(const JobTable& table, const std::string& name) {
  return length_in_mm(name, [&](const std::string& column) { return find_column(table, column); });
}

void add_row(const JobTable& table, const toml::table& row, const std::function<std::string(const toml::node&)>& where,
             Job& job) {
  JobRow cells;
  for (const auto& [name, node] : row) {
    const std::string text(name.str());
    const std::string about = where(node) + ": [[" + table.name + "]] " + text;
    if (const JobKey* length = length_in_mm(table, text)) {
      if (row.contains(length->name)) throw InputError(about + " and " + length->name + kBothAreGiven);
      cells[length->name] = length_in_px(*length, node, job.canvas, about);
      continue;
    }
    const JobKey* column = find_column(table, text);
    if (!column) {
      throw InputError(where(node) + ": unknown key " + printable(text) +
                       did_you_mean(nearest_name(text, column_names(table))) + "; allowed in [[" + table.name +
                       "]]: " + joined(column_names(table)));
    }
    const auto value = read_job_value(*column, node);
    if (!value || (column->required && *value == JobValue{})) {
      throw InputError(about + ": found " + found_text(node) + ", allowed: " + allowed_values(*column));
    }
    cells[text] = *value;
  }
  for (const JobKey& column : table.columns) {
    if (!column.required || cells.contains(column.name)) continue;
    throw InputError(where(row) + ": " + column.name + " is missing in [[" + table.name +
                     "]]; needed: " + column.meaning);
  }
  job.tables[table.name].push_back(std::move(cells));
}

}  // namespace tessera
