// The server as clients see it, well-behaved and others.
#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <ifaddrs.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <atomic>

#include "core/base/error.h"
#include "files/file_descriptor.h"
#include "serve/http_server.h"

namespace tessera::serve {
namespace test_http_server {

/// A connection to a port; not open where nobody listens there.
FileDescriptor connected(int port, in_addr_t address = htonl(INADDR_LOOPBACK)) {
  FileDescriptor connection(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0));
  sockaddr_in to = {};
  to.sin_family = AF_INET;
  to.sin_port = htons(std::uint16_t(port));
  to.sin_addr.s_addr = address;
  if (::connect(connection.number(), reinterpret_cast<const sockaddr*>(&to), sizeof to) != 0) connection.close();
  return connection;
}

/// Sends these bytes to the server and returns its answer, up to the end of the connection.
std::string talk(int port, const std::string& request) {
  const FileDescriptor connection = connected(port);
  std::size_t sent = 0;
  while (sent < request.size()) {
    const ssize_t bytes = ::send(connection.number(), request.data() + sent, request.size() - sent, MSG_NOSIGNAL);
    if (bytes <= 0) break;
    sent += std::size_t(bytes);
  }
  std::string answer;
  char part[4096];
  for (;;) {
    const ssize_t bytes = ::recv(connection.number(), part, sizeof part, 0);
    if (bytes <= 0) return answer;
    answer.append(part, std::size_t(bytes));
  }
}

int status(const std::string& answer) { return answer.size() < 12 ? 0 : std::stoi(answer.substr(9, 3)); }

class HttpServerTest : public ::testing::Test {
 protected:
  std::string get(const std::string& target, const std::string& headers = "") {
    return talk(server_.port(),
                "GET " + target + " HTTP/1.1\r\nHost: 127.0.0.1\r\nConnection: close\r\n" + headers + "\r\n");
  }
  std::string post(const std::string& headers, const std::string& body) {
    return talk(server_.port(),
                "POST /echo HTTP/1.1\r\nHost: 127.0.0.1\r\nConnection: close\r\n" + headers + "\r\n" + body);
  }

  HttpRequest seen_;
  std::atomic<int> handled_ = 0;
  HttpServer server_{0,
                     [](const HttpRequest& request) -> std::optional<HttpAnswer> {
                       if (request.path.starts_with("/refused")) return error_answer(403, "no");
                       return {};
                     },
                     [this](const HttpRequest& request) -> HttpAnswer {
                       ++handled_;
                       seen_ = request;
                       if (request.path == "/broken") throw std::runtime_error("it broke");
                       return {.type = "text/plain", .body = "echo:" + request.body};
                     }};
};

TEST_F(HttpServerTest, answers_with_headers_that_keep_others_out) {
  const std::string answer = get("/some%20page?result=a%2F..%2Fb", "X-Tessera: 1\r\nSec-Fetch-Site: none\r\n");
  EXPECT_EQ(status(answer), 200);
  for (const char* header :
       {"Cache-Control: no-store", "X-Content-Type-Options: nosniff", "Referrer-Policy: no-referrer",
        "X-Frame-Options: DENY", "Cross-Origin-Resource-Policy: same-origin", "Cross-Origin-Opener-Policy: same-origin",
        "Content-Security-Policy: frame-ancestors 'none'"}) {
    EXPECT_NE(answer.find(header), answer.npos) << header;
  }
  EXPECT_EQ(answer.find("Access-Control"), answer.npos);
  EXPECT_EQ(seen_.path, "/some page");
  EXPECT_EQ(seen_.result, "a/../b");
  EXPECT_EQ(seen_.host, "127.0.0.1");
  EXPECT_EQ(seen_.mark, "1");
  EXPECT_EQ(seen_.fetch_site, "none");
}

TEST_F(HttpServerTest, gives_the_body_to_the_handler) {
  const std::string answer =
      post("Content-Length: 5\r\nContent-Type: application/json\r\nOrigin: http://x\r\n", "hello");
  EXPECT_NE(answer.find("echo:hello"), answer.npos);
  EXPECT_EQ(seen_.content_type, "application/json");
  EXPECT_EQ(seen_.origin, "http://x");
}

TEST_F(HttpServerTest, refuses_before_the_body_comes) {
  const std::string answer =
      talk(server_.port(), "POST /refused HTTP/1.1\r\nHost: x\r\nContent-Length: 1000000\r\n\r\nabc");
  EXPECT_EQ(status(answer), 403);
  EXPECT_EQ(handled_, 0);
}

TEST_F(HttpServerTest, refuses_a_body_that_is_too_long) {
  const std::string length = std::to_string(kMostBody_bytes + 1);
  EXPECT_EQ(status(post("Content-Length: " + length + "\r\n", "abc")), 413);
  EXPECT_EQ(handled_, 0);
  EXPECT_EQ(
      status(post("Content-Length: " + std::to_string(kMostBody_bytes) + "\r\n", std::string(kMostBody_bytes, 'x'))),
      200);
  handled_ = 0;
  EXPECT_EQ(status(post("Content-Length: 99999999999999999999999999\r\n", "abc")) / 100, 4);
  EXPECT_EQ(status(post("Content-Length: -1\r\n", "abc")) / 100, 4);
  EXPECT_EQ(handled_, 0);
}

TEST_F(HttpServerTest, ends_a_connection_whose_parts_are_too_long_together) {
  std::string body;
  const std::string megabyte(1 << 20, 'x');
  for (int i = 0; i < 9; ++i) body += "100000\r\n" + megabyte + "\r\n";
  EXPECT_NE(status(post("Transfer-Encoding: chunked\r\n", body + "0\r\n\r\n")), 200);
  EXPECT_EQ(handled_, 0);
}

TEST_F(HttpServerTest, refuses_endless_headers) {
  std::string headers;
  for (int i = 0; i < 20'000; ++i) headers += "X-" + std::to_string(i) + ": 0123456789\r\n";
  EXPECT_NE(status(get("/", headers)), 200);
  EXPECT_NE(status(get("/" + std::string(200'000, 'a'))), 200);
  EXPECT_EQ(handled_, 0);
}

TEST_F(HttpServerTest, survives_what_is_no_http) {
  for (const std::string& bytes :
       {std::string("\0\xff\x16\x03\x01", 5), std::string("GET\r\n\r\n"), std::string("\r\n\r\n\r\n"),
        std::string("GET / HTTP/9.9\r\n\r\n"), std::string(100'000, '\r')}) {
    const FileDescriptor connection = connected(server_.port());
    EXPECT_GE(::send(connection.number(), bytes.data(), bytes.size(), MSG_NOSIGNAL), 0);
  }
  EXPECT_EQ(status(get("/")), 200);
}

TEST_F(HttpServerTest, tells_what_a_handler_throws) {
  const std::string answer = get("/broken");
  EXPECT_EQ(status(answer), 500);
  EXPECT_NE(answer.find("{\"error\":\"it broke\"}"), answer.npos);
}

TEST_F(HttpServerTest, listens_at_the_loopback_address_only) {
  ifaddrs* all = nullptr;
  ASSERT_EQ(::getifaddrs(&all), 0);
  for (const ifaddrs* one = all; one; one = one->ifa_next) {
    if (!one->ifa_addr || one->ifa_addr->sa_family != AF_INET) continue;
    const in_addr_t address = reinterpret_cast<const sockaddr_in*>(one->ifa_addr)->sin_addr.s_addr;
    EXPECT_EQ(connected(server_.port(), address).is_open(), address == htonl(INADDR_LOOPBACK)) << one->ifa_name;
  }
  ::freeifaddrs(all);
  EXPECT_FALSE(connected(server_.port(), htonl(INADDR_LOOPBACK + 1)).is_open());
}

TEST_F(HttpServerTest, a_taken_port_is_an_error) { EXPECT_THROW(HttpServer(server_.port(), {}, {}), EnvironmentError); }

}  // namespace test_http_server
}  // namespace tessera::serve
