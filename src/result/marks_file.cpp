#include "result/marks_file.h"

#include <cstddef>
#include <nlohmann/json.hpp>
#include <utility>

#include "core/base/error.h"
#include "files/regular_file.h"
#include "text/json_members.h"

namespace tessera {
namespace {

using nlohmann::json;

constexpr std::size_t kMostBytes = std::size_t(16) << 20;

constexpr std::pair<Marks::Action, const char*> kActions[] = {
    {Marks::Action::erase, "erase"}, {Marks::Action::swap, "swap"}, {Marks::Action::relax, "relax"}};

Marks::Action action_in(const json& object) {
  const json found = member(object, "action");
  for (const auto& [action, name] : kActions) {
    if (found == name) return action;
  }
  refuse_member("action", found, "\"erase\", \"swap\" or \"relax\"");
}

Marks marks_of(const json& marks, const std::string& pieces_digest) {
  if (member(marks, "format") != 1) refuse_member("format", member(marks, "format"), "1");
  if (member(marks, "pieces_digest") != pieces_digest) {
    refuse_member(
        "pieces_digest", member(marks, "pieces_digest"),
        "\"" + pieces_digest + "\", as in the manifest.json of the result: the marks were made on another result");
  }
  return marks_in(marks);
}

}  // namespace

Marks read_marks(const std::string& path, const std::string& pieces_digest) {
  const std::vector<std::uint8_t> bytes = read_regular_file(path, kMostBytes);
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  try {
    check_json(text, kMarksBounds);
    const json marks = json::parse(text, nullptr, false);
    if (marks.is_discarded()) throw InputError("not JSON; allowed: a file that a report's page saved");
    return marks_of(marks, pieces_digest);
  } catch (const InputError& error) {
    throw InputError(path + ": " + error.what());
  }
}

std::string marks_text(const Marks& marks, const std::string& pieces_digest) {
  const nlohmann::ordered_json file = {{"format", 1},
                                       {"pieces_digest", pieces_digest},
                                       {"action", kActions[std::size_t(marks.action)].second},
                                       {"pieces", marks.pieces},
                                       {"lock", marks.locked}};
  return file.dump() + "\n";
}

Marks marks_in(const json& object) {
  const auto numbers = [&](const char* key) {
    return numbers_member(object, key, int(kMostPieces), "a list of numbers of pieces, from 0");
  };
  Marks marks{.action = action_in(object), .pieces = numbers("pieces"), .locked = numbers("lock")};
  const bool needs_pieces = marks.action != Marks::Action::relax;
  if (needs_pieces && marks.pieces.empty()) {
    refuse_member("pieces", member(object, "pieces"), "at least one piece to erase or to swap");
  }
  return marks;
}

}  // namespace tessera
