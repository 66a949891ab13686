#include "serve/served_results.h"

#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <filesystem>
#include <map>
#include <optional>
#include <system_error>

#include "core/base/error.h"
#include "result/folder/finished_result.h"
#include "result/folder/folder_name.h"
#include "run/refined_result.h"
#include "text/utf8_text.h"

namespace tessera::serve {
namespace {

namespace fs = std::filesystem;

/// The number N of "NAME-N", from 2, written as add() writes it.
std::optional<int> number_in(const std::string& name, const std::string& first) {
  if (!name.starts_with(first + "-")) return {};
  const std::string digits = name.substr(first.size() + 1);
  int number = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  const bool is_number = error == std::errc() && number >= 2 && std::to_string(number) == digits;
  return is_number ? std::optional(number) : std::nullopt;
}

/// The result in a folder; empty where the folder holds none that is whole.
std::optional<ServedResult> found_result(const std::string& folder, const std::vector<ServedResult>& earlier) {
  const EarlierResult found = find_earlier_result(folder);
  if (!found.whole) return {};
  const std::string& path = found.whole->job.start.pieces;
  const std::string start = path.empty() ? "" : folder_name(path);
  const bool is_known =
      std::any_of(earlier.begin(), earlier.end(), [&](const ServedResult& result) { return result.name == start; });
  return ServedResult{
      .name = folder_name(folder), .folder = folder, .from = is_known ? start : "", .finished = found.finished()};
}

}  // namespace

ServedResults::ServedResults(const std::string& folder) {
  const WholeResult first = read_result(folder);
  const std::string name = folder_name(folder);
  if (!is_utf8(name) || printable_utf8(name) != name) {
    throw InputError(folder + ": the folder's name cannot stand in an address, allowed: printable characters in UTF-8");
  }
  all_.push_back({.name = name, .folder = folder, .from = "", .finished = first.manifest.finished});
  std::map<int, std::string> numbers;
  for (const auto& entry : fs::directory_iterator(fs::absolute(folder_of(2)).parent_path())) {
    const std::optional<int> number = number_in(entry.path().filename().string(), name);
    if (!number) continue;
    last_number_ = std::max(last_number_, *number);
    numbers.emplace(*number, folder_of(*number));
  }
  for (const auto& [number, path] : numbers) {
    if (std::optional<ServedResult> result = found_result(path, all_)) all_.push_back(std::move(*result));
  }
}

const ServedResult& ServedResults::named(const std::string& name) const {
  for (const ServedResult& result : all_) {
    if (result.name == name) return result;
  }
  throw InputError("found no result of the name \"" + cut_utf8(printable_utf8(name), 60) + "\"");
}

ServedResult ServedResults::add(const std::string& from) {
  std::string folder;
  do {
    folder = folder_of(++last_number_);
    if (::mkdir(folder.c_str(), 0777) == 0) break;
    if (errno != EEXIST) throw EnvironmentError(folder + ": " + std::generic_category().message(errno));
  } while (true);
  all_.push_back({.name = folder_name(folder), .folder = folder, .from = from, .finished = false});
  return all_.back();
}

void ServedResults::set_finished(const std::string& name) {
  for (ServedResult& result : all_) {
    if (result.name == name) result.finished = true;
  }
}

std::string ServedResults::folder_of(int number) const {
  return folder_beside(all_.front().folder, "-" + std::to_string(number));
}

}  // namespace tessera::serve
