#include "job/key_reference.h"

#include <utility>
#include <vector>

#include "job/job_value.h"
#include "job/key_lookup.h"
#include "job/millimetres.h"
#include "text/text_table.h"

namespace tessera {
namespace {

/// From the folder of docs/reference/job-keys.md.
constexpr const char* kExplanations = "../job-format.md";

/// The kind of the value in a word or two, for a column.
std::string kind_text(JobKind kind) {
  switch (kind) {
    case JobKind::number: return "number";
    case JobKind::integer: return "whole number";
    case JobKind::flag: return "flag";
    case JobKind::intervals: return "intervals";
    case JobKind::point: return "[x, y]";
    case JobKind::uses: return "count, or [least, most]";
    case JobKind::size:
    case JobKind::paper_size: return "[width, height]";
    case JobKind::word: return "word";
    case JobKind::name: return "text";
    case JobKind::file: return "path";
    case JobKind::texts: return "texts";
    case JobKind::files: return "paths";
    case JobKind::palette: return "palette";
    case JobKind::colour: return "colour";
    case JobKind::devices: return "devices";
    case JobKind::indices: return "whole numbers";
  }
  return {};
}

std::string kind_and_unit(const JobKey& key) { return kind_text(key.kind) + (key.unit.empty() ? "" : ", " + key.unit); }

/// The allowed values of a key, short enough for a column. The column beside it has the kind of the value.
std::string short_allowed(const JobKey& key) {
  switch (key.kind) {
    case JobKind::number:
    case JobKind::integer:
    case JobKind::intervals:
    case JobKind::point:
    case JobKind::uses:
    case JobKind::size:
    case JobKind::paper_size:
    case JobKind::indices: return range_text(key);
    case JobKind::name:
    case JobKind::file:
    case JobKind::texts:
    case JobKind::files: return "any";
    case JobKind::palette: return "a palette's name or file, or colours";
    case JobKind::flag:
    case JobKind::word:
    case JobKind::colour:
    case JobKind::devices: return allowed_values(key);
  }
  return {};
}

/// Keys of job_keys() have a default. The columns of a list have none: a row without the key says nothing about it.
std::string default_text(const JobKey& key) {
  if (key.required) return "required";
  return key.get ? job_value_to_toml(key, Job()) : "none";
}

std::string explained_at(const std::string& table_name) { return table_name.empty() ? "top-level" : table_name; }

using Fact = std::pair<std::string, std::string>;

/// All there is to say about a key.
std::vector<Fact> facts_of(const JobKey& key) {
  std::vector<Fact> facts = {{"meaning", key.meaning}, {"type", kind_text(key.kind)}};
  if (!key.unit.empty()) facts.emplace_back("unit", key.unit);
  facts.emplace_back("allowed", allowed_values(key));
  facts.emplace_back("default", default_text(key));
  if (!key.or_list.empty()) facts.back().second += ", or " + key.section + "." + key.or_list + " in its place";
  if (is_canvas_length(key)) {
    facts.emplace_back("in mm", key_in_mm(key, 1).full_name() + ", where canvas.size_mm says how large the canvas is");
  }
  facts.emplace_back(
      "collage", key.decides
                     ? "another value gives another collage; an interrupted run can only continue with the same value"
                     : "the key may have another value when an interrupted run goes on");
  return facts;
}

std::string table_as_text(const KeyTable& table) {
  TextTable lines({"key", "type, unit", "allowed", "default", "meaning"}, TextTable::Cells::words);
  for (const JobKey* key : table.keys) {
    lines.add({key->full_name(), kind_and_unit(*key), short_allowed(*key), default_text(*key), key->meaning});
  }
  return table.heading() + (table.is_list ? ", any number of times: " + table.meaning : "") + "\n" + lines.text();
}

std::string key_as_text(const JobKey& key, const std::string& heading) {
  std::string text = key.full_name() + "\n";
  std::vector<Fact> facts = facts_of(key);
  facts.emplace_back("more", "docs/job-format.md, " + heading);
  for (const auto& [label, value] : facts) {
    constexpr std::size_t kLabelWidth = 9;
    text += "  " + label + std::string(kLabelWidth - label.size(), ' ') + value + "\n";
  }
  return text;
}

/// A bar would end the cell.
std::string markdown_cell(const std::string& text) {
  std::string cell;
  for (const char c : text) cell += c == '|' ? std::string("\\|") : std::string(1, c);
  return cell;
}

std::string markdown_row(const std::vector<std::string>& cells) {
  std::string row = "|";
  for (const std::string& cell : cells) row += " " + markdown_cell(cell) + " |";
  return row + "\n";
}

std::string in_code(const std::string& text) { return "`" + text + "`"; }

std::string linked(const std::string& text, const std::string& table_name) {
  return "[" + text + "](" + kExplanations + "#" + explained_at(table_name) + ")";
}

std::string table_as_markdown(const KeyTable& table) {
  std::string text = "## " + linked(table.name.empty() ? "Top level" : table.name, table.name) + "\n\n";
  if (table.is_list) {
    text += in_code(table.heading()) + ", any number of times: " + table.meaning + ".\n\n";
  } else if (!table.name.empty()) {
    text += in_code(table.heading()) + "\n\n";
  }
  text += markdown_row({"key", "type", "unit", "allowed", "default", "meaning", "decides"});
  text += markdown_row(std::vector<std::string>(7, "---"));
  for (const JobKey* key : table.keys) {
    const std::string otherwise = default_text(*key);
    text += markdown_row({in_code(key->full_name()), kind_text(key->kind), key->unit, allowed_values(*key),
                          key->get && !key->required ? in_code(otherwise) : otherwise, key->meaning,
                          key->decides ? "yes" : "no"});
  }
  return text;
}

std::string key_as_markdown(const JobKey& key) {
  std::string text = "## " + linked(key.full_name(), key.section) + "\n\n";
  text += markdown_row({"", ""}) + markdown_row({"---", "---"});
  for (const auto& [label, value] : facts_of(key)) text += markdown_row({label, value});
  return text;
}

constexpr const char* kPageBegin =
    "# Keys of a job\n"
    "\n"
    "All keys of a job file, table by table. `tessera keys` prints the same in a terminal, `tessera keys pieces` "
    "prints one\n"
    "table, and `tessera keys pieces.scale_px` prints all about one key. The heading of a table leads to the page "
    "that\n"
    "explains it.\n"
    "\n"
    "`scripts/reference.sh` makes this page from the program, and a test compares both. Do not edit it.\n"
    "\n"
    "The column *decides* says whether a key decides about the collage. An interrupted run goes on with the same "
    "values of\n"
    "these keys alone. The others may have another value then. A number may be either end of its range. A length of "
    "the canvas\n"
    "whose name ends in `_px` may be given in mm by a name that ends in `_mm` "
    "([millimetres](../job-format.md#millimetres)).\n";

std::string page_of(const std::vector<KeyTable>& tables) {
  std::string page = kPageBegin;
  for (const KeyTable& table : tables) page += "\n" + table_as_markdown(table);
  return page;
}

std::string text_of(const std::vector<KeyTable>& tables) {
  std::string text;
  for (const KeyTable& table : tables) text += (text.empty() ? "" : "\n") + table_as_text(table);
  return text;
}

/// "pieces" for "[pieces]" and "[[pieces]]".
std::string without_brackets(const std::string& name) {
  const auto first = name.find_first_not_of('[');
  const auto last = name.find_last_not_of(']');
  return first == std::string::npos || last == std::string::npos ? "" : name.substr(first, last + 1 - first);
}

}  // namespace

std::string key_reference(const std::string& name, ReferenceForm form) {
  const bool markdown = form == ReferenceForm::markdown;
  const std::vector<KeyTable> tables = key_tables();
  if (name.empty()) return markdown ? page_of(tables) : text_of(tables);
  const std::string bare = without_brackets(name);
  const KeyTable* table = bare.empty() ? nullptr : find_key_table(tables, bare);
  if (table) return markdown ? table_as_markdown(*table) : table_as_text(*table);
  const JobKey* key = find_full_key(tables, bare);
  if (!key) fail_unknown_name(tables, name);
  return markdown ? key_as_markdown(*key) : key_as_text(*key, find_key_table(tables, key->section)->heading());
}

}  // namespace tessera
