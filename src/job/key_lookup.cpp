#include "job/key_lookup.h"

#include <algorithm>
#include <utility>

#include "core/base/error.h"
#include "core/base/split_text.h"
#include "job/job_entry.h"
#include "job/job_tables.h"
#include "job/millimetres.h"
#include "text/nearest_name.h"

namespace tessera {
namespace {

using Names = std::vector<std::string>;

/// {"pieces", "scale_px"}; the first is empty where the name has no dot.
std::pair<std::string, std::string> table_and_key(const std::string& full_name) {
  const auto dot = full_name.find('.');
  if (dot == std::string::npos) return {"", full_name};
  return {full_name.substr(0, dot), full_name.substr(dot + 1)};
}

const JobKey* find_key(const KeyTable& table, const std::string& name) {
  const auto at =
      std::find_if(table.keys.begin(), table.keys.end(), [&](const JobKey* key) { return key->name == name; });
  return at == table.keys.end() ? nullptr : *at;
}

Names key_names(const KeyTable& table) {
  Names names;
  for (const JobKey* key : table.keys) names.push_back(key->name);
  return names;
}

Names table_names(const std::vector<KeyTable>& tables) {
  Names names;
  for (const KeyTable& table : tables) {
    if (!table.name.empty()) names.push_back(table.name);
  }
  return names;
}

/// The full names of all keys that are called so, in whichever table.
Names full_names_of(const std::vector<KeyTable>& tables, const std::string& key_name) {
  Names names;
  for (const KeyTable& table : tables) {
    if (const JobKey* key = find_key(table, key_name)) names.push_back(key->full_name());
  }
  return names;
}

/// The names of all tables and all keys, in full.
Names all_names(const std::vector<KeyTable>& tables) {
  Names names = table_names(tables);
  for (const KeyTable& table : tables) {
    for (const JobKey* key : table.keys) names.push_back(key->full_name());
  }
  return names;
}

/// The nearest key of the name's own table first, then keys of just this name, then the nearest of all names.
Names near_names(const std::vector<KeyTable>& tables, const std::string& name) {
  const auto [table_name, key_name] = table_and_key(name);
  const KeyTable* table = find_key_table(tables, table_name);
  if (table && !table_name.empty()) {
    const std::string nearest = nearest_name(key_name, key_names(*table));
    if (!nearest.empty()) return {find_key(*table, nearest)->full_name()};
  }
  if (Names same = full_names_of(tables, key_name); !same.empty()) return same;
  const std::string nearest = nearest_name(name, all_names(tables));
  return nearest.empty() ? Names{} : Names{nearest};
}

/// "pieces.scale_px, shapes.scale_px or regions.scale_px"
std::string alternatives(Names names) {
  if (names.size() < 2) return joined(names);
  const std::string last = names.back();
  names.pop_back();
  return joined(names) + " or " + last;
}

/// The names that a message suggests in place of an unknown one: the keys of its table if the table is known, else all tables.
std::string allowed_names(const std::vector<KeyTable>& tables, const std::string& name) {
  const std::string table_name = table_and_key(name).first;
  const KeyTable* table = find_key_table(tables, table_name);
  if (table && !table_name.empty()) return " in " + table->heading() + ": " + joined(key_names(*table));
  return ": " + joined(key_names(tables.front())) + ", TABLE.KEY, and the tables " + joined(table_names(tables));
}

}  // namespace

std::string KeyTable::heading() const {
  if (name.empty()) return "Top level";
  return is_list ? "[[" + name + "]]" : "[" + name + "]";
}

std::vector<KeyTable> key_tables() {
  std::vector<KeyTable> tables;
  for (const JobKey& key : job_keys()) {
    if (tables.empty() || tables.back().name != key.section) tables.push_back({key.section, false, {}, {}});
    tables.back().keys.push_back(&key);
  }
  for (const JobTable& list : job_tables()) {
    tables.push_back({list.name, true, list.meaning, {}});
    for (const JobKey& column : list.columns) tables.back().keys.push_back(&column);
  }
  return tables;
}

const KeyTable* find_key_table(const std::vector<KeyTable>& tables, const std::string& name) {
  const auto at = std::find_if(tables.begin(), tables.end(), [&](const KeyTable& table) { return table.name == name; });
  return at == tables.end() ? nullptr : &*at;
}

const JobKey* find_full_key(const std::vector<KeyTable>& tables, const std::string& full_name) {
  const auto [table_name, key_name] = table_and_key(full_name);
  const KeyTable* table = find_key_table(tables, table_name);
  if (!table) return nullptr;
  if (const JobKey* key = find_key(*table, key_name)) return key;
  const JobKey* in_px = find_key(*table, name_in_px(key_name));
  return in_px && is_canvas_length(*in_px) ? in_px : nullptr;
}

void fail_unknown_name(const std::vector<KeyTable>& tables, const std::string& name) {
  const Names near = near_names(tables, name);
  throw InputError("unknown key or table " + printable(name) +
                   (near.empty() ? "" : " (did you mean " + alternatives(near) + "?)") + "; allowed" +
                   allowed_names(tables, name));
}

}  // namespace tessera
