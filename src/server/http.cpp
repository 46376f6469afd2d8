#include "server/http.h"

#include "base/text.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>

#include <fmt/format.h>
#include <poll.h>
#include <sys/socket.h>

namespace orbs::server {

int hex_digit(char c) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  const auto at = kDigits.find(static_cast<char>(std::tolower(static_cast<unsigned char>(c))));
  return at == std::string_view::npos ? -1 : static_cast<int>(at);
}

std::string decoded(std::string_view text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '%' && i + 2 < text.size() && hex_digit(text[i + 1]) >= 0 && hex_digit(text[i + 2]) >= 0) {
      out += static_cast<char>(16 * hex_digit(text[i + 1]) + hex_digit(text[i + 2]));
      i += 2;
    } else {
      out += text[i];
    }
  }
  return out;
}

std::string path_of(const Request& request) {
  return decoded(std::string_view(request.target).substr(0, request.target.find('?')));
}

std::string parameter(const Request& request, std::string_view name) {
  const auto start = request.target.find('?');
  if (start == std::string::npos) return "";
  for (auto& pair : split(std::string_view(request.target).substr(start + 1), '&')) {
    std::replace(pair.begin(), pair.end(), '+', ' ');
    const auto equals = std::min(pair.find('='), pair.size());
    if (decoded(std::string_view(pair).substr(0, equals)) != name) continue;
    return decoded(std::string_view(pair).substr(std::min(equals + 1, pair.size())));
  }
  return "";
}

bool Connection::send(std::string_view bytes) const {
  while (!bytes.empty()) {
    pollfd wanted{sock, POLLOUT, 0};
    if (::poll(&wanted, 1, static_cast<int>(write_timeout.count())) <= 0) return false;
    const auto count = ::send(sock, bytes.data(), bytes.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
    if (count < 0 && (errno == EAGAIN || errno == EINTR)) continue;
    if (count < 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(count));
  }
  return true;
}

bool Connection::is_open() const {
  pollfd wanted{sock, POLLRDHUP, 0};
  return ::poll(&wanted, 1, 0) == 0;
}

void set_content(Response& response, std::string text, std::string type) {
  response.content = std::move(text);
  response.type = std::move(type);
}

void refuse(Response& response, int status, std::string_view reason) {
  response.status = status;
  set_content(response, fmt::format("{}\n", reason), "text/plain; charset=utf-8");
}

std::string_view status_text(int status) {
  struct Known {
    int status;
    std::string_view text;
  };
  constexpr std::array kKnown{Known{200, "200 OK"},
                              Known{204, "204 No Content"},
                              Known{400, "400 Bad Request"},
                              Known{403, "403 Forbidden"},
                              Known{404, "404 Not Found"},
                              Known{405, "405 Method Not Allowed"},
                              Known{408, "408 Request Timeout"},
                              Known{409, "409 Conflict"},
                              Known{411, "411 Length Required"},
                              Known{413, "413 Content Too Large"},
                              Known{414, "414 URI Too Long"},
                              Known{415, "415 Unsupported Media Type"},
                              Known{421, "421 Misdirected Request"},
                              Known{422, "422 Unprocessable Content"},
                              Known{431, "431 Request Header Fields Too Large"},
                              Known{503, "503 Service Unavailable"},
                              Known{505, "505 HTTP Version Not Supported"}};
  for (const auto& known : kKnown)
    if (known.status == status) return known.text;
  return "500 Internal Server Error";
}

std::string head_text(const Response& response) {
  auto head = fmt::format("HTTP/1.1 {}\r\nConnection: close\r\n", status_text(response.status));
  for (const auto& [name, value] : response.headers) head += fmt::format("{}: {}\r\n", name, value);
  const auto* const text = std::get_if<std::string>(&response.content);
  const auto bytes = text != nullptr ? text->size() : std::get<Streamed>(response.content).bytes;
  // RFC 9110, section 8.6: an answer 204 has no length.
  if (bytes && response.status != 204) head += fmt::format("Content-Length: {}\r\n", *bytes);
  if (!response.type.empty()) head += fmt::format("Content-Type: {}\r\n", response.type);
  return head + "\r\n";
}

void send_response(const Connection& connection, const std::string& method, const Response& response) {
  const auto* const text = std::get_if<std::string>(&response.content);
  const bool is_head_alone = method == "HEAD";
  // One piece where there is little: a client on this machine then needs one look.
  constexpr std::size_t kLittle = 65536;
  if (text != nullptr && !is_head_alone && text->size() < kLittle) {
    connection.send(head_text(response) + *text);
    return;
  }
  if (!connection.send(head_text(response)) || is_head_alone) return;
  if (text != nullptr)
    connection.send(*text);
  else
    std::get<Streamed>(response.content).write(connection);
}

}  // namespace orbs::server
