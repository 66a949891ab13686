#include "serve/http_server.h"

#include <arpa/inet.h>
#include <microhttpd.h>
#include <netinet/in.h>

#include <cerrno>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <string>
#include <system_error>
#include <utility>

#include "core/base/error.h"
#include "serve/own_peer.h"

namespace tessera::serve {
namespace {

// Bounds for clients that want to use up the machine. A browser opens six connections.
constexpr unsigned kMostConnections = 32;
constexpr unsigned kIdle_s = 30;
constexpr std::size_t kConnectionMemory_bytes = std::size_t(64) << 10;  // headers; longer ones are refused

std::string header(MHD_Connection* connection, MHD_ValueKind kind, const char* name) {
  const char* value = MHD_lookup_connection_value(connection, kind, name);
  return value ? value : "";
}

HttpRequest request_of(MHD_Connection* connection, const char* path, const char* method) {
  const auto get = [&](const char* name) { return header(connection, MHD_HEADER_KIND, name); };
  return {.method = method,
          .path = path,
          .result = header(connection, MHD_GET_ARGUMENT_KIND, "result"),
          .host = get("Host"),
          .origin = get("Origin"),
          .fetch_site = get("Sec-Fetch-Site"),
          .content_type = get("Content-Type"),
          .mark = get("X-Tessera"),
          .body = {}};
}

MHD_Result send(MHD_Connection* connection, const HttpAnswer& answer) {
  MHD_Response* response = MHD_create_response_from_buffer(answer.body.size(), const_cast<char*>(answer.body.data()),
                                                           MHD_RESPMEM_MUST_COPY);  // it only reads
  if (!response) return MHD_NO;
  const std::pair<const char*, const char*> headers[] = {{"Content-Type", answer.type.c_str()},
                                                         {"Cache-Control", "no-store"},
                                                         {"Content-Security-Policy", "frame-ancestors 'none'"},
                                                         {"Cross-Origin-Opener-Policy", "same-origin"},
                                                         {"Cross-Origin-Resource-Policy", "same-origin"},
                                                         {"Referrer-Policy", "no-referrer"},
                                                         {"X-Content-Type-Options", "nosniff"},
                                                         {"X-Frame-Options", "DENY"}};
  for (const auto& [name, value] : headers) MHD_add_response_header(response, name, value);
  const MHD_Result result = MHD_queue_response(connection, unsigned(answer.status), response);
  MHD_destroy_response(response);
  return result;
}

/// Whether the client says that its body is too long. libmicrohttpd has refused what is no number.
bool announces_too_much(MHD_Connection* connection) {
  const std::string length = header(connection, MHD_HEADER_KIND, "Content-Length");
  std::size_t bytes = 0;
  const auto [end, error] = std::from_chars(length.data(), length.data() + length.size(), bytes);
  return !length.empty() && (error != std::errc() || bytes > kMostBody_bytes);
}

HttpAnswer too_long() {
  return error_answer(413, "the body is too long, allowed: " + std::to_string(kMostBody_bytes) + " bytes");
}

}  // namespace

struct HttpServer::Daemon {
  Guard guard;
  Handler handler;
  MHD_Daemon* daemon = nullptr;

  HttpAnswer answer(const HttpRequest& request) const {
    try {
      return handler(request);
    } catch (const std::exception& error) {
      return error_answer(500, error.what());
    }
  }

  MHD_Result begin(MHD_Connection* connection, HttpRequest request, void** state) const {
    std::optional<HttpAnswer> refused = guard(request);
    if (!refused && announces_too_much(connection)) refused = too_long();
    if (refused) return send(connection, *refused);  // before its body is read: the connection ends
    *state = new HttpRequest(std::move(request));
    return MHD_YES;
  }

  static MHD_Result take_part(HttpRequest& request, const char* part, std::size_t& bytes) {
    if (request.body.size() + bytes > kMostBody_bytes) return MHD_NO;
    request.body.append(part, bytes);
    bytes = 0;
    return MHD_YES;
  }

  /// libmicrohttpd calls this first with the headers, then with each part of the body, then without a part. MHD_NO ends
  /// the connection.
  static MHD_Result on_request(void* self, MHD_Connection* connection, const char* path, const char* method,
                               const char* /*version*/, const char* part, std::size_t* part_bytes, void** state) {
    const auto& daemon = *static_cast<Daemon*>(self);
    try {
      if (!*state) return daemon.begin(connection, request_of(connection, path, method), state);
      auto& request = *static_cast<HttpRequest*>(*state);
      if (*part_bytes > 0) return take_part(request, part, *part_bytes);
      return send(connection, daemon.answer(request));
    } catch (...) {  // no memory; a C library called us
      return MHD_NO;
    }
  }

  /// Other users of the machine could otherwise take all connections.
  static MHD_Result on_connection(void* self, const sockaddr* peer, socklen_t /*bytes*/) {
    const MHD_DaemonInfo* bound = MHD_get_daemon_info(static_cast<Daemon*>(self)->daemon, MHD_DAEMON_INFO_BIND_PORT);
    return is_own_peer(*reinterpret_cast<const sockaddr_in*>(peer), bound->port) ? MHD_YES : MHD_NO;
  }

  static void on_end(void* /*self*/, MHD_Connection* /*connection*/, void** state, MHD_RequestTerminationCode /*why*/) {
    delete static_cast<HttpRequest*>(*state);
    *state = nullptr;
  }
};

HttpServer::HttpServer(int port, Guard guard, Handler handler)
    : daemon_(new Daemon{std::move(guard), std::move(handler)}) {
  sockaddr_in address = {};
  address.sin_family = AF_INET;
  address.sin_port = htons(std::uint16_t(port));
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  const unsigned flags = MHD_USE_INTERNAL_POLLING_THREAD | MHD_USE_THREAD_PER_CONNECTION | MHD_USE_POLL;
  daemon_->daemon = MHD_start_daemon(
      flags, 0, &Daemon::on_connection, daemon_.get(), &Daemon::on_request, daemon_.get(), MHD_OPTION_SOCK_ADDR,
      reinterpret_cast<const sockaddr*>(&address), MHD_OPTION_NOTIFY_COMPLETED, &Daemon::on_end, nullptr,
      MHD_OPTION_CONNECTION_LIMIT, kMostConnections, MHD_OPTION_CONNECTION_TIMEOUT, kIdle_s,
      MHD_OPTION_CONNECTION_MEMORY_LIMIT, kConnectionMemory_bytes, MHD_OPTION_STRICT_FOR_CLIENT, 1, MHD_OPTION_END);
  if (daemon_->daemon) return;
  throw EnvironmentError("127.0.0.1:" + std::to_string(port) + ": cannot listen: " +
                         std::generic_category().message(errno) + "; allowed: another --port, or none");
}

HttpServer::~HttpServer() { MHD_stop_daemon(daemon_->daemon); }

int HttpServer::port() const { return MHD_get_daemon_info(daemon_->daemon, MHD_DAEMON_INFO_BIND_PORT)->port; }

}  // namespace tessera::serve
