#pragma once

#include "server/refusal.h"

#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include <httplib.h>

/// Decides on the bytes of a request whether it is allowed, before anything else sees them.

namespace orbs::server {

/// A plain answer with this status.
void refuse(httplib::Response& response, int status, const std::string& reason);

constexpr std::size_t kMostHeadBytes = 16384;
constexpr std::size_t kMostTargetBytes = 2048;
constexpr std::size_t kMostHeaders = 64;
/// In an admitted head if the client reads gzip.
constexpr const char* kReadsGzip = "Orbs-Reads-Gzip";

/// A request that may pass. `head` is rewritten from the parsed request without the client's headers, so that
/// httplib reads no byte that the gate has not checked. What a client says about gzip is passed on as a
/// header of ours: httplib, whose library may be built with or without zlib, must not pack a second time.
struct Admitted {
  std::string head;
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

/// Decodes the percent codes of an admitted path or query value, once.
std::string decoded(std::string_view text);

/// "404 Not Found".
std::string_view status_text(int status);

}  // namespace orbs::server
