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
  const auto& head = std::get<server::Admitted>(answer).head;
  require(head.starts_with("GET /") || head.starts_with("HEAD /"), "only GET and HEAD of a path pass");
  require(head.ends_with("\r\n\r\n") && head.find("\r\n\r\n") + 4 == head.size(), "one head passes");
  require(std::all_of(head.begin(), head.end(),
                      [](unsigned char c) { return std::isprint(c) != 0 || c == '\r' || c == '\n'; }),
          "only printable characters pass");
  const auto target = head.substr(head.find(' ') + 1, head.find(" HTTP/") - head.find(' ') - 1);
  const auto path = server::decoded(target.substr(0, target.find('?')));
  require((path + "/").find("/../") == std::string::npos && path.find('\0') == std::string::npos,
          "no path leads up");
  return "";
}

}  // namespace orbs::fuzz
