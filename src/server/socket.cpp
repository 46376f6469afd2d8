#include "server/socket.h"

#include "base/error.h"

#include <cerrno>
#include <cstdint>
#include <cstring>
#include <memory>

#include <arpa/inet.h>
#include <fmt/format.h>
#include <netdb.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

namespace orbs::server {

namespace {

using Addresses = std::unique_ptr<addrinfo, decltype(&::freeaddrinfo)>;

// Of the address as a number, or of a name such as localhost.
Addresses resolved(const std::string& address, int port) {
  addrinfo wanted{};
  wanted.ai_family = AF_UNSPEC;
  wanted.ai_socktype = SOCK_STREAM;
  wanted.ai_flags = AI_PASSIVE | AI_NUMERICSERV;
  addrinfo* found = nullptr;
  if (const int error = ::getaddrinfo(address.c_str(), std::to_string(port).c_str(), &wanted, &found);
      error != 0)
    throw InputError(fmt::format("cannot listen on {}: it is no address of this machine: {}", address,
                                 ::gai_strerror(error)));
  return {found, &::freeaddrinfo};
}

void set_option(int sock, int level, int name, int value) {
  ::setsockopt(sock, level, name, &value, sizeof(value));
}

bool binds(int sock, const addrinfo& to, int backlog) {
  // After a restart the port may be taken again at once. SO_REUSEPORT would let a second program share it,
  // and take some of the clients.
  set_option(sock, SOL_SOCKET, SO_REUSEADDR, 1);
  if (to.ai_family == AF_INET6) set_option(sock, IPPROTO_IPV6, IPV6_V6ONLY, 0);
  return ::bind(sock, to.ai_addr, to.ai_addrlen) == 0 && ::listen(sock, backlog) == 0;
}

int port_of(int sock) {
  sockaddr_storage bound{};
  socklen_t size = sizeof(bound);
  // The interface of sockets takes every kind of address as this one.
  ::getsockname(sock, reinterpret_cast<sockaddr*>(&bound), &size);
  std::uint16_t port = 0;  // lies at the same place in both kinds
  static_assert(offsetof(sockaddr_in, sin_port) == offsetof(sockaddr_in6, sin6_port));
  std::memcpy(&port, reinterpret_cast<const char*>(&bound) + offsetof(sockaddr_in, sin_port), sizeof(port));
  return ntohs(port);
}

}  // namespace

Descriptor::~Descriptor() {
  if (number_ >= 0) ::close(number_);
}

ListeningSocket listen_on(const std::string& address, int port, int backlog) {
  const auto addresses = resolved(address, port);
  int error = 0;
  for (const addrinfo* to = addresses.get(); to != nullptr; to = to->ai_next) {
    Descriptor sock(::socket(to->ai_family, to->ai_socktype | SOCK_CLOEXEC | SOCK_NONBLOCK, to->ai_protocol));
    if (sock.number() >= 0 && binds(sock.number(), *to, backlog)) {
      const int bound = port_of(sock.number());
      return {std::move(sock), bound};
    }
    error = errno;
  }
  throw InputError(
      fmt::format("cannot listen on {}:{}: {}; is another program there? --port takes another one", address,
                  port, std::strerror(error)));
}

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

}  // namespace orbs::server
