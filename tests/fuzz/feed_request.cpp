#include "fuzz/feed.h"
#include "server/request_gate.h"

#include <algorithm>
#include <cctype>

namespace orbs::fuzz {

// The head of an HTTP request, as the server reads it from the network.
std::string feed_request(std::string_view bytes) {
  const auto answer = server::check_request(bytes, {});
  if (const auto* refused = std::get_if<server::Refusal>(&answer)) {
    require(refused->status >= 400 && refused->status < 600, "a refusal has a status");
    require(!refused->reason.empty(), "a refusal has a reason");
    return refused->reason;
  }
  const auto& [request, body_bytes] = std::get<server::Admitted>(answer);
  require(request.method == "GET" || request.method == "HEAD", "only GET and HEAD pass");
  require(body_bytes == 0, "no body passes");
  require(
      request.target.starts_with('/') && std::all_of(request.target.begin(), request.target.end(),
                                                     [](unsigned char c) { return std::isgraph(c) != 0; }),
      "only a path of printable characters passes");
  server::parameter(request, "layer");
  const auto path = server::path_of(request);
  require((path + "/").find("/../") == std::string::npos && path.find('\0') == std::string::npos,
          "no path leads up");
  return "";
}

}  // namespace orbs::fuzz
