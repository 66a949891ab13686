#include "job/job_difference.h"

#include <algorithm>
#include <vector>

#include "core/base/split_text.h"
#include "job/job_tables.h"
#include "job/job_value.h"
#include "text/utf8_text.h"

namespace tessera {

namespace {

/// The rows as TOML, without columns that do not count.
std::string rows_text(JobTable table, const Job& job, const std::function<bool(const JobKey&)>& counts) {
  std::erase_if(table.columns, [&](const JobKey& column) { return !counts(column); });
  return table_to_toml(table, job);
}

/// The texts that are not in `others`, in quotes.
std::string listed_without(const std::vector<std::string>& texts, const std::vector<std::string>& others) {
  std::vector<std::string> own;
  for (const std::string& text : texts)
    if (std::find(others.begin(), others.end(), text) == others.end()) own.push_back('"' + printable_utf8(text) + '"');
  return joined(own);
}

/// The texts that were added to a list and removed from it: the whole lists may be long.
std::string list_difference(const std::vector<std::string>& then, const std::vector<std::string>& now) {
  const std::string came = listed_without(now, then), went = listed_without(then, now);
  if (came.empty() && went.empty()) return "in another order now";
  return (came.empty() ? "" : "now with " + came) + (came.empty() || went.empty() ? "" : ", ") +
         (went.empty() ? "" : "now without " + went);
}

std::string difference(const JobKey& key, const Job& then, const Job& now) {
  const std::vector<std::string> list_then = key.get(then).texts, list_now = key.get(now).texts;
  if (!list_then.empty() && !list_now.empty()) return list_difference(list_then, list_now);
  return "then " + job_value_to_toml(key, then) + ", now " + job_value_to_toml(key, now);
}

}  // namespace

std::string job_differences(const Job& then, const Job& now, const std::function<bool(const JobKey&)>& counts) {
  std::string text;
  for (const JobKey& key : job_keys()) {
    if (!counts(key) || key.get(then) == key.get(now)) continue;
    text += "; " + key.full_name() + ": " + difference(key, then, now);
  }
  for (const JobTable& table : job_tables()) {
    if (rows_text(table, then, counts) != rows_text(table, now, counts))
      text += "; [[" + table.name + "]]: others than then";
  }
  return text;
}

}  // namespace tessera
