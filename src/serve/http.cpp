#include "serve/http.h"

#include <nlohmann/json.hpp>

#include "text/utf8_text.h"

namespace tessera::serve {

HttpAnswer error_answer(int status, const std::string& text) {
  return {.status = status, .body = nlohmann::json{{"error", printable_utf8(text)}}.dump()};
}

}  // namespace tessera::serve
