#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

/// Requests and responses of HTTP/1.1 (RFC 9110 and 9112) as plain data, as far as the page needs them.
namespace orbs::server {

/// A request that the gate has checked. Of the client's headers it holds only what was read out of them.
struct Request {
  std::string method;  // "GET", "HEAD" or "POST"
  std::string target;  // "/data/0/image/a%20b.exr?layer=S1"
  bool reads_gzip = false;
  std::string body{};
};

/// The target before '?', decoded.
std::string path_of(const Request& request);

/// The value of a parameter behind '?', decoded, in which '+' is a space as forms write it; "" without it.
std::string parameter(const Request& request, std::string_view name);

/// 0 to 15, or -1 for what is no hexadecimal digit.
int hex_digit(char c);

/// The text with each percent code replaced by its byte, once; broken codes stay.
std::string decoded(std::string_view text);

/// Where an answer goes: a connected socket, which does not block. It is not closed here.
struct Connection {
  int sock = -1;
  std::chrono::milliseconds write_timeout{};  // while the client takes no byte

  /// False if the client has gone, or takes no byte for too long.
  bool send(std::string_view bytes) const;
  /// False if the client has gone. It sends nothing after its request, so that a readable end means gone.
  bool is_open() const;
};

/// Content that is made while it is sent. `write` sends exactly `bytes` bytes, or, where there is no such
/// number, whatever it likes: the end of the connection is then the end of the content.
struct Streamed {
  std::optional<std::size_t> bytes;
  std::function<void(const Connection&)> write;
};

struct Response {
  int status = 200;
  std::vector<std::pair<std::string, std::string>> headers{};
  std::string type{};  // of the content
  std::variant<std::string, Streamed> content{};
};

void set_content(Response& response, std::string text, std::string type);
/// A plain answer with this status.
void refuse(Response& response, int status, std::string_view reason);

/// "404 Not Found"; an unknown status is a failure of the server.
std::string_view status_text(int status);

/// Up to and with the empty line. Each connection carries one request, and the head says so.
std::string head_text(const Response& response);

/// Sends the whole answer, to a HEAD its head alone.
void send_response(const Connection& connection, const std::string& method, const Response& response);

}  // namespace orbs::server
