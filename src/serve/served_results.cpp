#include "serve/served_results.h"

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <filesystem>
#include <optional>
#include <set>
#include <stdexcept>
#include <system_error>
#include <utility>

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
  constexpr std::size_t kMostDigits = 6;
  if (!name.starts_with(first + "-")) return {};
  const std::string digits = name.substr(first.size() + 1);
  if (digits.size() > kMostDigits) return {};
  int number = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  const bool is_number = error == std::errc() && number >= 2 && std::to_string(number) == digits;
  return is_number ? std::optional(number) : std::nullopt;
}

bool have_one_owner(const std::string& a, const std::string& b) {
  struct stat of_a = {}, of_b = {};
  return ::stat(a.c_str(), &of_a) == 0 && ::stat(b.c_str(), &of_b) == 0 && of_a.st_uid == of_b.st_uid;
}

/// The result in a folder; empty where the folder holds none that is whole, or cannot be read.
std::optional<ServedResult> found_result(const std::string& folder, const std::vector<ServedResult>& earlier) {
  std::optional<WholeResult> whole;
  try {
    whole = read_result(folder);
  } catch (const std::runtime_error&) {  // another program's, or another user's
    return {};
  }
  const std::string& path = whole->job.start.pieces;
  const std::string start = path.empty() ? "" : folder_name(path);
  const bool is_known =
      std::any_of(earlier.begin(), earlier.end(), [&](const ServedResult& result) { return result.name == start; });
  const bool finished = whole->manifest.finished;
  return ServedResult{.name = folder_name(folder),
                      .folder = folder,
                      .from = is_known ? start : "",
                      .finished = finished,
                      .stopped = !finished,
                      .message = finished ? "" : "the command in its run.log goes on with --resume=auto"};
}

}  // namespace

ServedResults::ServedResults(const std::string& folder) {
  const WholeResult first = read_result(folder);
  const std::string name = folder_name(folder);
  if (!is_utf8(name) || printable_utf8(name) != name) {
    throw InputError(folder + ": the folder's name cannot stand in an address, allowed: printable characters in UTF-8");
  }
  all_.push_back({.name = name,
                  .folder = folder,
                  .from = "",
                  .finished = first.manifest.finished,
                  .stopped = false,
                  .message = ""});
  find_earlier();
}

void ServedResults::find_earlier() {
  std::set<int> numbers;
  std::error_code unreadable;  // then there are none
  const fs::path parent = fs::absolute(folder_of(2)).parent_path();
  for (fs::directory_iterator entry(parent, unreadable); !unreadable && entry != fs::directory_iterator();
       entry.increment(unreadable)) {
    if (const std::optional<int> number = number_in(entry->path().filename().string(), all_.front().name)) {
      numbers.insert(*number);
    }
  }
  for (const int number : numbers) {
    const std::string folder = folder_of(number);
    if (!have_one_owner(folder, all_.front().folder)) continue;
    if (std::optional<ServedResult> result = found_result(folder, all_)) {
      all_.push_back(std::move(*result));
      last_number_ = number;
    }
  }
}

ServedResult& ServedResults::named(const std::string& name) {
  for (ServedResult& result : all_) {
    if (result.name == name) return result;
  }
  throw InputError("found no result of the name \"" + cut_utf8(printable_utf8(name), 60) + "\"");
}

ServedResult& ServedResults::add(const std::string& from) {
  std::string folder = folder_of(++last_number_);
  while (::mkdir(folder.c_str(), 0777) != 0) {
    if (errno != EEXIST) throw EnvironmentError(folder + ": " + std::generic_category().message(errno));
    folder = folder_of(++last_number_);
  }
  all_.push_back({.name = folder_name(folder),
                  .folder = folder,
                  .from = from,
                  .finished = false,
                  .stopped = false,
                  .message = ""});
  return all_.back();
}

void ServedResults::remove_last() {
  ::rmdir(all_.back().folder.c_str());
  all_.pop_back();
}

std::string ServedResults::folder_of(int number) const {
  return folder_beside(all_.front().folder, "-" + std::to_string(number));
}

}  // namespace tessera::serve
