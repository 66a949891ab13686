// Tests which requests the server answers and which it refuses.
#include <gtest/gtest.h>

#include "serve/request_guard.h"
#include "serve/token.h"

namespace tessera::serve {
namespace test_request_guard {

constexpr const char* kToken = "0123456789abcdef0123456789abcdef";

HttpRequest get(const std::string& path) { return {.method = "GET", .path = path, .host = "127.0.0.1:8123"}; }
HttpRequest from_page() { return get("/" + std::string(kToken) + "/state"); }
HttpRequest post() {
  HttpRequest request = from_page();
  request.method = "POST";
  request.origin = "http://127.0.0.1:8123";
  request.fetch_site = "same-origin";
  request.content_type = "application/json";
  request.mark = "1";
  return request;
}

int status(const HttpRequest& request) {
  const std::optional<HttpAnswer> refused = refusal(request, kToken);
  return refused ? refused->status : 200;
}

template <class Change>
int status_of_changed(HttpRequest request, Change change) {
  change(request);
  return status(request);
}

TEST(RequestGuard, answers_the_page_of_this_machine) {
  EXPECT_EQ(status(from_page()), 200);
  EXPECT_EQ(status(post()), 200);
  EXPECT_EQ(status_of_changed(from_page(), [](HttpRequest& r) { r.method = "HEAD"; }), 200);
  EXPECT_EQ(path_below_token(from_page(), kToken), "state");
  EXPECT_EQ(path_below_token(get("/" + std::string(kToken) + "/"), kToken), "");
}

TEST(RequestGuard, host_must_be_this_machine) {
  for (const char* host : {"127.0.0.1", "localhost", "localhost:80", "127.0.0.1:65535", "[::1]:9"}) {
    EXPECT_EQ(status_of_changed(from_page(), [&](HttpRequest& r) { r.host = host; }), 200) << host;
  }
  for (const char* host : {"", "evil.com", "localhost.evil.com", "127.0.0.1.evil.com", "127.0.0.1:", "localhost:80a",
                           "localhost:123456", "evil.com:8123", "127.0.0.1@evil.com", "LOCALHOST.x", "10.0.0.1:8123"}) {
    EXPECT_EQ(status_of_changed(from_page(), [&](HttpRequest& r) { r.host = host; }), 403) << host;
  }
}

TEST(RequestGuard, path_must_begin_with_the_token) {
  const std::string token = kToken, other = "1" + token.substr(1);
  for (const std::string& path : {std::string("/"), std::string(), std::string("/state"), "/" + token, token + "/state",
                                  "/" + other + "/state", "/" + token + "0/state", "/" + token.substr(1) + "/state",
                                  "//" + token + "/state", "/../" + token + "/state"}) {
    EXPECT_EQ(status(get(path)), 404) << path;
  }
}

TEST(RequestGuard, other_sites_are_refused) {
  for (const char* origin : {"http://evil.com", "null", "https://127.0.0.1:8123", "http://127.0.0.1:1",
                             "http://localhost:8123", "http://127.0.0.1:8123.evil.com"}) {
    EXPECT_EQ(status_of_changed(post(), [&](HttpRequest& r) { r.origin = origin; }), 403) << origin;
    EXPECT_EQ(status_of_changed(from_page(), [&](HttpRequest& r) { r.origin = origin; }), 403) << origin;
  }
  for (const char* site : {"cross-site", "same-site", "anything"}) {
    EXPECT_EQ(status_of_changed(from_page(), [&](HttpRequest& r) { r.fetch_site = site; }), 403) << site;
  }
  EXPECT_EQ(status_of_changed(from_page(), [](HttpRequest& r) { r.fetch_site = "none"; }), 200);
}

TEST(RequestGuard, a_post_is_json_with_the_mark) {
  EXPECT_EQ(status_of_changed(post(), [](HttpRequest& r) { r.mark = ""; }), 403);
  EXPECT_EQ(status_of_changed(post(), [](HttpRequest& r) { r.mark = "2"; }), 403);
  EXPECT_EQ(status_of_changed(post(), [](HttpRequest& r) { r.content_type = "text/plain"; }), 415);
  EXPECT_EQ(status_of_changed(post(), [](HttpRequest& r) { r.content_type = ""; }), 415);
  EXPECT_EQ(status_of_changed(post(), [](HttpRequest& r) { r.content_type = "application/jsonx"; }), 415);
  EXPECT_EQ(status_of_changed(post(), [](HttpRequest& r) { r.content_type = "application/json; charset=utf-8"; }), 200);
}

TEST(RequestGuard, other_methods_are_refused) {
  for (const char* method : {"PUT", "DELETE", "OPTIONS", "TRACE", "CONNECT", "PATCH", "get"}) {
    EXPECT_EQ(status_of_changed(post(), [&](HttpRequest& r) { r.method = method; }), 405) << method;
  }
}

TEST(Token, has_128_bits_that_differ_each_time) {
  const std::string a = random_token(), b = random_token();
  EXPECT_EQ(a.size(), 32u);
  EXPECT_EQ(a.find_first_not_of("0123456789abcdef"), a.npos);
  EXPECT_NE(a, b);
  EXPECT_TRUE(same_token(a, a));
  EXPECT_FALSE(same_token(a, b));
  EXPECT_FALSE(same_token(a, a + "0"));
  EXPECT_FALSE(same_token(a, ""));
}

}  // namespace test_request_guard
}  // namespace tessera::serve
