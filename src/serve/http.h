// A request of a browser and its answer.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "text/utf8_text.h"

namespace tessera::serve {

/// A request of a browser, as far as the server looks at it. Headers are empty where they are missing.
struct HttpRequest {
  std::string method = {};        // "GET"
  std::string path = {};          // decoded, without the query: "/TOKEN/data"
  std::string result = {};        // "result" of the query
  std::string host = {};          // header Host
  std::string origin = {};        // header Origin
  std::string fetch_site = {};    // header Sec-Fetch-Site
  std::string content_type = {};  // header Content-Type
  std::string mark = {};          // header X-Tessera
  std::string body = {};
};

struct HttpAnswer {
  int status = 200;
  std::string type = "application/json";
  std::string body = {};
};

/// {"error": TEXT}; bytes of `text` that cannot be shown are replaced.
inline HttpAnswer error_answer(int status, const std::string& text) {
  return {.status = status, .body = nlohmann::json{{"error", printable_utf8(text)}}.dump()};
}

}  // namespace tessera::serve
