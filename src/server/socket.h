#pragma once

#include <string>
#include <utility>

namespace orbs::server {

/// A file descriptor that is closed with this object.
class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  ~Descriptor();
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  int number() const { return number_; }

 private:
  int number_;
};

struct ListeningSocket {
  Descriptor sock;  // does not block
  int port = 0;
};

/// Binds and listens; port 0 takes a free one. `backlog` clients may wait to be received. InputError with the
/// reason if that fails.
ListeningSocket listen_on(const std::string& address, int port, int backlog);

/// True for the addresses that only this machine can reach: 127.0.0.0/8 and ::1.
bool is_loopback_address(const std::string& address);

}  // namespace orbs::server
