#include "server/reception.h"

#include "server/http.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <utility>

#include <sys/eventfd.h>
#include <sys/socket.h>
#include <unistd.h>

namespace orbs::server {

namespace {

// How often it looks whether it shall stop, and whether somebody's time is up.
constexpr std::chrono::milliseconds kTick{50};
// If a socket is closed with unread bytes, the system discards what it has not sent yet (RFC 9112, section
// 9.6). Therefore some of them are read first.
constexpr std::chrono::milliseconds kMostLeaving{300};
constexpr std::size_t kMostUnread = 1U << 20U;

Response response_of(const Refusal& refusal) {
  Response response;
  refuse(response, refusal.status, refusal.reason);
  response.headers.emplace_back("X-Content-Type-Options", "nosniff");
  if (refusal.status == 405) response.headers.emplace_back("Allow", refusal.allow);
  return response;
}

}  // namespace

Reception::Reception(Descriptor listener, GateSettings gate, ConnectionLimits limits)
    : listener_(std::move(listener)),
      gate_(std::move(gate)),
      limits_(limits),
      bell_(::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)) {}

void Reception::give_back(Descriptor sock) {
  {
    const std::lock_guard lock(mutex_);
    given_back_.push_back(std::move(sock));
  }
  const std::uint64_t one = 1;
  // It is full only if it rings already.
  [[maybe_unused]] const auto written = ::write(bell_.number(), &one, sizeof(one));
}

void Reception::run(const std::atomic<bool>& stop, const std::function<void(Visitor)>& answer) {
  while (!stop.load()) {
    auto sockets = watched();
    ::poll(sockets.data(), sockets.size(), static_cast<int>(kTick.count()));
    is_out_of_files_ = false;
    // First those that were watched, which clients that come now are not.
    for (std::size_t i = 0; i < clients_.size(); ++i)
      if ((sockets[i].revents != 0 && !receive(clients_[i], answer)) || !is_in_time(clients_[i]))
        clients_[i].sock = Descriptor(-1);
    std::erase_if(clients_, [](const Client& client) { return client.sock.number() < 0; });
    if (sockets.back().revents != 0) take_back();
    if (sockets[sockets.size() - 2].revents != 0) accept_clients();
  }
}

// The clients, the listener, the bell. poll ignores negative numbers.
std::vector<pollfd> Reception::watched() const {
  std::vector<pollfd> all;
  all.reserve(clients_.size() + 2);
  for (const auto& client : clients_) all.push_back({client.sock.number(), POLLIN, 0});
  const bool may_come = answered_ < limits_.most_answered && !is_out_of_files_;
  all.push_back({may_come ? listener_.number() : -1, POLLIN, 0});
  all.push_back({bell_.number(), POLLIN, 0});
  return all;
}

void Reception::take_back() {
  std::uint64_t rung = 0;
  [[maybe_unused]] const auto count = ::read(bell_.number(), &rung, sizeof(rung));
  std::vector<Descriptor> back;
  {
    const std::lock_guard lock(mutex_);
    back.swap(given_back_);
  }
  answered_ -= back.size();
  for (auto& sock : back) {
    make_room();
    clients_.push_back({std::move(sock), {}});
    leave(clients_.back());
  }
}

void Reception::accept_clients() {
  for (;;) {
    Descriptor sock(::accept4(listener_.number(), nullptr, nullptr, SOCK_CLOEXEC | SOCK_NONBLOCK));
    if (sock.number() < 0) {
      is_out_of_files_ = errno == EMFILE || errno == ENFILE || errno == ENOBUFS || errno == ENOMEM;
      return;
    }
    make_room();
    clients_.push_back({std::move(sock), Clock::now() + limits_.request_timeout});
  }
}

// Whoever has been here for longest goes: an honest client sends its request at once.
void Reception::make_room() {
  if (clients_.size() < limits_.most_received) return;
  if (!clients_.front().is_leaving)
    send_away(clients_.front(), {503, "too many clients have sent half a request"});
  clients_.erase(clients_.begin());
}

// False when the connection is to be closed, here and below.
bool Reception::receive(Client& client, const std::function<void(Visitor)>& answer) {
  std::array<char, 16384> piece{};
  const auto count = ::recv(client.sock.number(), piece.data(), piece.size(), 0);
  if (count < 0) return errno == EAGAIN || errno == EINTR;
  if (count == 0) return false;
  if (client.is_leaving) {
    client.unread += static_cast<std::size_t>(count);
    return client.unread < kMostUnread;
  }
  client.bytes.append(piece.data(), static_cast<std::size_t>(count));
  return advance(client, answer);
}

bool Reception::advance(Client& client, const std::function<void(Visitor)>& answer) {
  if (!client.admitted) {
    const auto end = client.bytes.find("\r\n\r\n");
    if (end == std::string::npos)
      return client.bytes.size() <= kMostHeadBytes || send_away(client, {431, "the headers are too long"});
    auto checked = check_request(std::string_view(client.bytes).substr(0, end + 4), gate_);
    if (const auto* refusal = std::get_if<Refusal>(&checked)) return send_away(client, *refusal);
    client.admitted = std::move(std::get<Admitted>(checked));
    client.bytes.erase(0, end + 4);
  }
  if (client.bytes.size() < client.admitted->body_bytes) return true;
  client.bytes.resize(client.admitted->body_bytes);
  auto& request = client.admitted->request;
  request.body = std::move(client.bytes);
  ++answered_;
  answer({std::move(client.sock), std::move(request)});
  return false;  // the connection is the visitor's now
}

bool Reception::send_away(Client& client, const Refusal& refusal) {
  // Nothing was sent yet, so that the system takes these few bytes at once or never.
  send_response({client.sock.number(), {}}, "GET", response_of(refusal));
  leave(client);
  return true;
}

void Reception::leave(Client& client) {
  ::shutdown(client.sock.number(), SHUT_WR);
  client.is_leaving = true;
  client.deadline = Clock::now() + kMostLeaving;
}

bool Reception::is_in_time(Client& client) {
  if (client.sock.number() < 0 || Clock::now() < client.deadline) return true;
  return !client.is_leaving && send_away(client, {408, "the request took too long"});
}

}  // namespace orbs::server
