#pragma once

#include <string>
#include <string_view>

namespace orbs::server {

/// Why a request may not pass.
struct Refusal {
  int status = 400;
  std::string reason;
  std::string_view allow = "GET, HEAD";  // the methods, for 405
};

/// What a request must know that changes something.
struct EditGate {
  std::string token;
  int port = 0;  // of the server
};

}  // namespace orbs::server
