#include "server/serve.h"

#include "base/error.h"
#include "server/edit.h"
#include "server/edit_gate.h"
#include "server/request_gate.h"
#include "server/served.h"
#include "server/site.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <exception>
#include <optional>
#include <thread>
#include <utility>

#include <arpa/inet.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

namespace orbs::server {

namespace {

using Clock = std::chrono::steady_clock;

bool wait_for(int sock, short what, std::chrono::milliseconds time) {
  pollfd wanted{sock, what, 0};
  return ::poll(&wanted, 1, static_cast<int>(std::max<std::int64_t>(time.count(), 0))) > 0;
}

// httplib reads the head that the gate has written, and writes to the socket.
class CheckedStream : public httplib::Stream {
 public:
  CheckedStream(int sock, std::string head, std::chrono::milliseconds write_timeout)
      : sock_(sock), head_(std::move(head)), write_timeout_(write_timeout) {}

  bool is_readable() const override { return at_ < head_.size(); }
  // Also false if the client has gone: a client sends nothing after its head, so readable means closed.
  bool is_writable() const override {
    pollfd wanted{sock_, POLLOUT | POLLRDHUP, 0};
    return ::poll(&wanted, 1, static_cast<int>(write_timeout_.count())) > 0 &&
           (wanted.revents & POLLOUT) != 0 && (wanted.revents & (POLLRDHUP | POLLHUP | POLLERR)) == 0;
  }
  ssize_t read(char* data, size_t size) override {
    const auto count = std::min(size, head_.size() - at_);
    std::memcpy(data, head_.data() + at_, count);
    at_ += count;
    return static_cast<ssize_t>(count);
  }
  ssize_t write(const char* data, size_t size) override {
    if (!wait_for(sock_, POLLOUT, write_timeout_)) return -1;
    return ::send(sock_, data, size, MSG_NOSIGNAL | MSG_DONTWAIT);
  }
  void get_remote_ip_and_port(std::string& ip, int& port) const override { ip.clear(), port = 0; }
  void get_local_ip_and_port(std::string& ip, int& port) const override { ip.clear(), port = 0; }
  socket_t socket() const override { return sock_; }

 private:
  int sock_;
  std::string head_;
  std::size_t at_ = 0;
  std::chrono::milliseconds write_timeout_;
};

struct Received {
  std::string head;  // up to and with the empty line
  std::string rest;  // what has come after it
};

// The request up to its empty line, or the reason why there is none; "" if the client went away.
std::variant<Received, Refusal> read_head(int sock, Clock::time_point deadline) {
  std::string head;
  std::array<char, 4096> piece{};
  while (head.size() <= kMostHeadBytes) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now());
    if (left.count() <= 0 || !wait_for(sock, POLLIN, left)) return Refusal{408, "the request took too long"};
    const auto count = ::recv(sock, piece.data(), piece.size(), 0);
    if (count <= 0) return Refusal{0, ""};
    const auto searched = head.size() < 3 ? 0 : head.size() - 3;
    head.append(piece.data(), static_cast<std::size_t>(count));
    if (const auto end = head.find("\r\n\r\n", searched); end != std::string::npos)
      return Received{head.substr(0, end + 4), head.substr(end + 4)};
  }
  return Refusal{431, "the headers are too long"};
}

// The body of that many bytes, which begins with `body`; none if it does not come in time.
std::optional<std::string> read_body(int sock,
                                     std::string body,
                                     std::size_t bytes,
                                     Clock::time_point deadline) {
  std::array<char, 4096> piece{};
  while (body.size() < bytes) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now());
    if (left.count() <= 0 || !wait_for(sock, POLLIN, left)) return std::nullopt;
    const auto count = ::recv(sock, piece.data(), piece.size(), 0);
    if (count <= 0) return std::nullopt;
    body.append(piece.data(), static_cast<std::size_t>(count));
  }
  body.resize(bytes);
  return body;
}

void send_refusal(int sock, const Refusal& refusal, std::chrono::milliseconds time) {
  const auto text = fmt::format(
      "HTTP/1.1 {}\r\n"
      "Content-Type: text/plain; charset=utf-8\r\n"
      "Content-Length: {}\r\n"
      "X-Content-Type-Options: nosniff\r\n"
      "{}Connection: close\r\n"
      "\r\n"
      "{}\n",
      status_text(refusal.status), refusal.reason.size() + 1,
      refusal.status == 405 ? fmt::format("Allow: {}\r\n", refusal.allow) : "", refusal.reason);
  if (wait_for(sock, POLLOUT, time)) ::send(sock, text.data(), text.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
}

// If a socket is closed with unread bytes, the system discards what it has not sent yet (RFC 9112, section
// 9.6). Therefore some of them are read first.
void close_gently(int sock) {
  constexpr std::chrono::milliseconds kMost{300};
  constexpr std::size_t kMostBytes = 1U << 20U;
  ::shutdown(sock, SHUT_WR);
  const auto deadline = Clock::now() + kMost;
  std::array<char, 4096> piece{};
  for (std::size_t seen = 0; seen < kMostBytes;) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now());
    if (left.count() <= 0 || !wait_for(sock, POLLIN, left)) break;
    const auto count = ::recv(sock, piece.data(), piece.size(), 0);
    if (count <= 0) break;
    seen += static_cast<std::size_t>(count);
  }
  ::close(sock);
}

}  // namespace

GatedServer::GatedServer(GateSettings gate, ConnectionLimits limits)
    : gate_(std::move(gate)), limits_(limits) {
  // httplib's own options would let a second program share the port and take some of the clients.
  set_socket_options([](socket_t sock) {
    const int yes = 1;
    ::setsockopt(sock, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof(yes));
  });
  new_task_queue = [this] { return new httplib::ThreadPool(limits_.threads); };  // httplib deletes it
}

int GatedServer::open(const std::string& address, int port) {
  const int bound = port == 0 ? bind_to_any_port(address) : (bind_to_port(address, port) ? port : -1);
  if (bound < 0)
    throw InputError(
        fmt::format("cannot listen on {}:{}: {}; is another program there? --port takes another one", address,
                    port, std::strerror(errno)));
  // httplib listens with a backlog of 5; beyond that the system lets each client wait for a second.
  ::listen(svr_sock_, limits_.backlog);
  if (gate_.edit) gate_.edit->port = bound;
  return bound;
}

void GatedServer::answer(socket_t sock) {
  const auto deadline = Clock::now() + limits_.head_timeout;
  auto read = read_head(sock, deadline);
  if (const auto* refusal = std::get_if<Refusal>(&read)) {
    if (refusal->status != 0) send_refusal(sock, *refusal, limits_.write_timeout);
    return;
  }
  auto& received = std::get<Received>(read);
  auto checked = check_request(received.head, gate_);
  if (const auto* refusal = std::get_if<Refusal>(&checked)) {
    send_refusal(sock, *refusal, limits_.write_timeout);
    return;
  }
  const auto& admitted = std::get<Admitted>(checked);
  const auto body = admitted.body_bytes > 0
                        ? read_body(sock, std::move(received.rest), admitted.body_bytes, deadline)
                        : std::string();
  if (!body) return send_refusal(sock, {408, "the request took too long"}, limits_.write_timeout);
  CheckedStream stream(sock, admitted.head + *body, limits_.write_timeout);
  bool closed = false;
  process_request(stream, true, closed, nullptr);
}

bool GatedServer::process_and_close_socket(socket_t sock) {
  answer(sock);
  close_gently(sock);
  return true;
}

namespace {

// Stops the server when the flag is set; ends when its own thread is told to.
class Watch {
 public:
  Watch(const std::atomic<bool>& stop, httplib::Server& server)
      : thread_([&](const std::stop_token& end) {
          constexpr std::chrono::milliseconds kPause{50};
          while (!stop.load() && !end.stop_requested()) std::this_thread::sleep_for(kPause);
          // Repeats, because a server that does not listen yet ignores it.
          do {
            server.stop();
            std::this_thread::sleep_for(kPause);
          } while (!end.stop_requested());
        }) {}

 private:
  std::jthread thread_;
};

}  // namespace

bool is_loopback_address(const std::string& address) {
  in_addr four{};
  in6_addr six{};
  constexpr std::uint32_t kFirstByte = 0xff000000U;
  constexpr std::uint32_t kLoopback = 127U << 24U;
  if (::inet_pton(AF_INET, address.c_str(), &four) == 1)
    return (ntohl(four.s_addr) & kFirstByte) == kLoopback;
  if (::inet_pton(AF_INET6, address.c_str(), &six) == 1) return IN6_IS_ADDR_LOOPBACK(&six);
  return address == "localhost";
}

void serve(const ServeSettings& settings,
           const std::atomic<bool>& stop,
           const std::function<void(const std::string& url)>& ready) {
  if (settings.editor && !is_loopback_address(settings.address))
    throw InputError(
        fmt::format("{} is not this machine's loopback address: a page that writes files is "
                    "served there alone",
                    settings.address));
  Site site;
  if (settings.editor) site.editor = &*settings.editor;
  site.listeners.stop = &stop;
  site.bundle = load_bundle(settings.bundle);
  std::vector<std::filesystem::path> folders;
  for (const auto& folder : settings.runs) {
    site.runs.push_back(open_served(folder));
    folders.push_back(named(site.runs.back()));
  }
  site.names = run_names(folders);
  ConnectionLimits limits;
  limits.head_timeout = settings.head_timeout;
  GateSettings gate{is_loopback_address(settings.address)};
  if (settings.editor) gate.edit = EditGate{new_token()};
  GatedServer server(gate, limits);
  server.Get(".*", [&](const httplib::Request& request, httplib::Response& response) {
    answer(site, request, response);
  });
  if (settings.editor)
    server.Post(".*", [&](const httplib::Request& request, httplib::Response& response) {
      answer_edit(site, request, response);
    });
  server.set_exception_handler(
      [](const httplib::Request&, httplib::Response& response, const std::exception_ptr&) {
        refuse(response, 500, "the server failed; please report what was asked");
      });
  const int port = server.open(settings.address, settings.port);
  const bool is_six = settings.address.find(':') != std::string::npos;
  // Behind '#', where no browser sends it to anybody, no log notes it, and no link passes it on.
  ready(fmt::format("http://{}:{}/{}", is_six ? "[" + settings.address + "]" : settings.address, port,
                    gate.edit ? "#edit=" + gate.edit->token : ""));
  const Watch watch(stop, server);
  server.listen_after_bind();
}

}  // namespace orbs::server
