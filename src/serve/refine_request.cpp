#include "serve/refine_request.h"

#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "text/json_members.h"

namespace tessera::serve {
namespace {

using nlohmann::json;

std::optional<std::uint64_t> seed_of(const json& request) {
  const json seed = member(request, "seed");
  if (seed.is_null()) return {};
  if (!seed.is_number_unsigned()) refuse_member("seed", seed, "a whole number from 0, or null");
  return seed.get<std::uint64_t>();
}

}  // namespace

RefineRequest parse_refine_request(const std::string& body) {
  check_json(body, kMarksBounds);
  const json request = json::parse(body, nullptr, false);
  if (!request.is_object()) throw InputError("the body is no JSON object");
  const json result = member(request, "result"), action = member(request, "action");
  if (!result.is_string()) refuse_member("result", result, "the name of a result");
  if (action != "erase" && action != "swap" && action != "relax") {
    refuse_member("action", action, "\"erase\", \"swap\" or \"relax\"");
  }
  RefineRequest read{.result = result,
                     .relaxes = action == "relax",
                     .marks = listed_marks(request, action == "swap"),
                     .seed = seed_of(request)};
  if (!read.relaxes && read.marks.pieces.empty()) {
    refuse_member("pieces", member(request, "pieces"), "at least one piece to erase or to swap");
  }
  return read;
}

}  // namespace tessera::serve
