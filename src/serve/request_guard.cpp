#include "serve/request_guard.h"

#include <algorithm>

#include "serve/token.h"

namespace tessera::serve {
namespace {

/// Whether the header names this machine, at any port: a tunnel (ssh -L) may have another one at its other end.
bool is_this_machine(std::string_view host) {
  for (const std::string_view name : {"127.0.0.1", "localhost", "[::1]"}) {
    if (!host.starts_with(name)) continue;
    const std::string_view rest = host.substr(name.size());
    if (rest.empty()) return true;
    if (rest.size() < 2 || rest.size() > 6 || rest[0] != ':') continue;
    if (std::all_of(rest.begin() + 1, rest.end(), [](char c) { return c >= '0' && c <= '9'; })) return true;
  }
  return false;
}

bool begins_with_token(std::string_view path, std::string_view token) {
  const std::size_t slash = path.find('/', 1);
  return path.starts_with('/') && slash != path.npos && same_token(path.substr(1, slash - 1), token);
}

/// Browsers send Sec-Fetch-Site with every request; "none": typed or opened by the user. Other programs do not send it.
bool is_from_own_page(const HttpRequest& request) {
  const std::string& site = request.fetch_site;
  if (!site.empty() && site != "same-origin" && site != "none") return false;
  return request.origin.empty() || request.origin == "http://" + request.host;
}

bool is_json(const std::string& content_type) {
  constexpr std::string_view kJson = "application/json";
  return content_type.starts_with(kJson) && (content_type.size() == kJson.size() || content_type[kJson.size()] == ';');
}

}  // namespace

std::optional<HttpAnswer> refusal(const HttpRequest& request, std::string_view token) {
  if (!is_this_machine(request.host)) return error_answer(403, "the header Host names another machine");
  if (!begins_with_token(request.path, token)) return error_answer(404, "there is nothing at this address");
  if (!is_from_own_page(request)) return error_answer(403, "the request comes from another site");
  if (request.method == "GET" || request.method == "HEAD") return {};
  if (request.method != "POST") return error_answer(405, "allowed methods: GET, POST");
  if (request.mark != "1") return error_answer(403, "the header X-Tessera: 1 is missing");
  if (!is_json(request.content_type)) return error_answer(415, "allowed: Content-Type: application/json");
  return {};
}

std::string path_below_token(const HttpRequest& request, std::string_view token) {
  return request.path.substr(token.size() + 2);
}

}  // namespace tessera::serve
