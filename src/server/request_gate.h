#pragma once

#include "server/http.h"
#include "server/refusal.h"

#include <optional>
#include <string>
#include <string_view>
#include <variant>

/// Decides on the bytes of a request whether it is allowed, before anything else sees them.

namespace orbs::server {

constexpr std::size_t kMostHeadBytes = 16384;
constexpr std::size_t kMostTargetBytes = 2048;
constexpr std::size_t kMostHeaders = 64;
/// A request that may pass. Of the client's headers it holds only whether gzip is read, so that nothing
/// behind the gate sees a byte that was not checked.
struct Admitted {
  Request request;
  std::size_t body_bytes = 0;  // that follow the head: of a request that changes something
};

struct GateSettings {
  /// Compares the name in Host with those of this machine's loopback. Off if the user binds to another
  /// address, whose names are unknown.
  bool only_loopback_names = true;
  std::optional<EditGate> edit{};  // without it nothing can be changed
};

/// `head` is everything up to and with the empty line. Allowed: GET and HEAD of HTTP/1.0 and 1.1, an absolute
/// path of printable ASCII whose percent codes hold UTF-8 and no separator, dot or control character, without
/// empty, "." and ".." segments; one Host of this machine (DNS rebinding is refused); no body. With `edit`
/// also POST of a path below /edit/ with a body, if check_edit lets it pass; no other method of such a path.
std::variant<Admitted, Refusal> check_request(std::string_view head, const GateSettings& settings);

}  // namespace orbs::server
