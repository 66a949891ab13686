#include "serve/refine_request.h"

#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "text/json_members.h"

namespace tessera::serve {
namespace {

using nlohmann::json;

std::string text_of(const json& request, const char* key) {
  const json text = member(request, key);
  if (!text.is_string()) refuse_member(key, text, "a text");
  return text;
}

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
  return {.result = text_of(request, "result"),
          .pieces_digest = text_of(request, "pieces_digest"),
          .marks = marks_in(request),
          .seed = seed_of(request)};
}

}  // namespace tessera::serve
