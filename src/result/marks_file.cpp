#include "result/marks_file.h"

#include <cstddef>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "files/regular_file.h"
#include "result/placed_pieces.h"
#include "text/json_bounds.h"

namespace tessera {
namespace {

using nlohmann::json;

constexpr std::size_t kMostBytes = std::size_t(16) << 20;
constexpr JsonBounds kBounds{.values = 2 * kMostPieces + 100, .levels = 4, .members = 100};

[[noreturn]] void refuse(const char* key, const json& found, const std::string& allowed) {
  const std::string text = found.is_null() ? "nothing" : found.dump(-1, ' ', true, json::error_handler_t::replace);
  throw InputError(std::string(key) + ": found " + text.substr(0, 60) + ", allowed: " + allowed);
}

json value_at(const json& marks, const char* key) { return marks.is_object() ? marks.value(key, json()) : json(); }

std::vector<int> numbers_at(const json& marks, const char* key) {
  const json list = value_at(marks, key);
  const std::string allowed = "a list of numbers of pieces, from 0";
  if (!list.is_array()) refuse(key, list, allowed);
  std::vector<int> numbers;
  for (const json& number : list) {
    if (!number.is_number_unsigned() || number.get<std::uint64_t>() >= kMostPieces) refuse(key, number, allowed);
    numbers.push_back(number.get<int>());
  }
  return numbers;
}

Marks marks_of(const json& marks, const std::string& pieces_digest) {
  if (value_at(marks, "format") != 1) refuse("format", value_at(marks, "format"), "1");
  if (value_at(marks, "pieces_digest") != pieces_digest) {
    refuse("pieces_digest", value_at(marks, "pieces_digest"),
           "\"" + pieces_digest + "\", as in the manifest.json of the result: the marks were made on another result");
  }
  const json action = value_at(marks, "action");
  if (action != "erase" && action != "swap") refuse("action", action, "\"erase\" or \"swap\"");
  Marks read{.swaps = action == "swap", .pieces = numbers_at(marks, "pieces"), .locked = numbers_at(marks, "lock")};
  if (read.pieces.empty()) refuse("pieces", value_at(marks, "pieces"), "at least one piece to erase or to swap");
  return read;
}

}  // namespace

Marks read_marks(const std::string& path, const std::string& pieces_digest) {
  const std::vector<std::uint8_t> bytes = read_regular_file(path, kMostBytes);
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  try {
    check_json(text, kBounds);
    const json marks = json::parse(text, nullptr, false);
    if (marks.is_discarded()) throw InputError("not JSON; allowed: a file that a report's page saved");
    return marks_of(marks, pieces_digest);
  } catch (const InputError& error) {
    throw InputError(path + ": " + error.what());
  }
}

}  // namespace tessera
