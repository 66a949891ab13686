// A small HTTP server for the browser of one user on this machine. The only file that knows GNU libmicrohttpd.
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "serve/http.h"

namespace tessera::serve {

/// A request with a longer body is refused: with 413 where it says its length, otherwise its connection ends.
inline constexpr std::size_t kMostBody_bytes = std::size_t(8) << 20;

class HttpServer {
 public:
  /// Called for each request as soon as its headers are there: the answer that refuses it, or nothing.
  using Guard = std::function<std::optional<HttpAnswer>(const HttpRequest&)>;
  /// Called for each request that is not refused, with its body. What it throws is answered with 500.
  using Handler = std::function<HttpAnswer(const HttpRequest&)>;

  /// Listens at 127.0.0.1 only; port 0: a free one. Both functions are called from several threads. Throws
  /// EnvironmentError where the port is taken.
  HttpServer(int port, Guard guard, Handler handler);
  /// Ends all connections; waits for handlers that run.
  ~HttpServer();
  HttpServer(const HttpServer&) = delete;
  HttpServer& operator=(const HttpServer&) = delete;

  int port() const;

 private:
  struct Daemon;
  std::unique_ptr<Daemon> daemon_;
};

}  // namespace tessera::serve
