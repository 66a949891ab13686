// Decides which requests are answered at all: those of the user's own browser, from the page itself.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "serve/http.h"

namespace tessera::serve {

/// The answer that refuses a request; empty where it may be answered. The body is not looked at. Refused are:
/// - a header Host that names another machine (403): the name of a foreign site may be made to lead to this machine;
/// - a path that does not begin with /TOKEN/ (404), so that other users of the machine learn nothing;
/// - requests that a browser makes for another site, by Origin or Sec-Fetch-Site (403);
/// - methods other than GET, HEAD and POST (405), and a POST that is no JSON (415) or lacks "X-Tessera: 1" (403), which
///   no other site can add without asking first.
std::optional<HttpAnswer> refusal(const HttpRequest& request, std::string_view token);

/// The path behind /TOKEN/ of a request that is not refused: "" is the page itself.
std::string path_below_token(const HttpRequest& request, std::string_view token);

}  // namespace tessera::serve
