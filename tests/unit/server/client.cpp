#include "unit/server/client.h"

#include "base/files.h"
#include "base/text.h"

#include <array>

#include <arpa/inet.h>
#include <fmt/format.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

namespace orbs::server_tests {

namespace fs = std::filesystem;

RunningServer::RunningServer(const fs::path& run,
                             std::chrono::milliseconds request_timeout,
                             std::optional<server::Editor> editor) {
  for (const char* name : {"index.html", "page.js", "page.css", "icon.svg"})
    write_file(bundle_.path() / name, name);
  thread_ = std::thread([this, run, request_timeout, editor] {
    server::serve({{run}, bundle_.path(), "127.0.0.1", 0, request_timeout, editor}, stop_,
                  [this](const std::string& url) {
                    constexpr std::string_view kBefore = "#edit=";
                    if (const auto at = url.find(kBefore); at != std::string::npos)
                      token_ = url.substr(at + kBefore.size());
                    const auto digits = url.substr(url.rfind(':') + 1);
                    port_ = static_cast<int>(to_integer(digits.substr(0, digits.find('/'))).value_or(0));
                    port_.notify_all();
                  });
  });
  port_.wait(0);
}

RunningServer::~RunningServer() {
  stop_ = true;
  thread_.join();
}

int connect_to(int port) {
  const int sock = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<std::uint16_t>(port));
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  // The interface of sockets takes every kind of address as this one.
  ::connect(sock, reinterpret_cast<const sockaddr*>(&address), sizeof(address));
  return sock;
}

std::string answer_to(int sock, const std::string& bytes) {
  ::send(sock, bytes.data(), bytes.size(), MSG_NOSIGNAL);
  std::string answer;
  std::array<char, 4096> piece{};
  for (;;) {
    const auto count = ::recv(sock, piece.data(), piece.size(), 0);
    if (count <= 0) return answer;
    answer.append(piece.data(), static_cast<std::size_t>(count));
  }
}

std::string RunningServer::talk(const std::string& bytes) const {
  const int sock = connect_to(port_);
  const auto answer = answer_to(sock, bytes);
  ::close(sock);
  return answer;
}

std::string RunningServer::get(const std::string& target) const {
  return talk(fmt::format("GET {} HTTP/1.1\r\nHost: localhost:{}\r\n\r\n", target, port_.load()));
}

int status_of(const std::string& answer) {
  constexpr std::size_t kAt = 9;  // behind "HTTP/1.1 "
  return answer.starts_with("HTTP/1.1 ") ? static_cast<int>(to_integer(answer.substr(kAt, 3)).value_or(0))
                                         : 0;
}

std::string body_of(const std::string& answer) {
  const auto end = answer.find("\r\n\r\n");
  return end == std::string::npos ? "" : answer.substr(end + 4);
}

}  // namespace orbs::server_tests
