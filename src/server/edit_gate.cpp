#include "server/edit_gate.h"

#include "base/error.h"
#include "base/text.h"

#include <array>
#include <cerrno>
#include <cstring>

#include <fmt/format.h>
#include <sys/random.h>

namespace orbs::server {

namespace {

constexpr std::size_t kTokenBytes = 32;

std::string value_of(const Headers& headers, const std::string& name) {
  const auto found = headers.find(name);
  return found == headers.end() ? "" : found->second;
}

// Browsers leave out the port that http has without one.
bool has_port(std::string_view host, int port) {
  constexpr int kUsualPort = 80;
  const auto text = fmt::format(":{}", port);
  const bool names_none = host.ends_with(']') || host.find(':') == std::string_view::npos;
  return names_none ? port == kUsualPort : host.ends_with(text);
}

std::optional<Refusal> check_body(const Headers& headers) {
  const auto type = value_of(headers, "content-type");
  if (trim(type.substr(0, type.find(';'))) != "application/json")
    return Refusal{415, "Content-Type must be application/json"};
  const auto length = to_integer(value_of(headers, "content-length"));
  if (!length || *length < 0) return Refusal{411, "Content-Length is missing"};
  if (static_cast<std::size_t>(*length) > kMostBodyBytes) return Refusal{413, "the body is too long"};
  return std::nullopt;
}

}  // namespace

std::string new_token() {
  std::array<unsigned char, kTokenBytes> bytes{};
  // Up to 256 bytes come whole once the generator has been seeded (getrandom(2)).
  if (::getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size()))
    throw InputError(fmt::format("the system has no random numbers: {}", std::strerror(errno)));
  std::string text;
  for (const auto byte : bytes) text += fmt::format("{:02x}", byte);
  return text;
}

bool is_token_equal(std::string_view given, std::string_view token) {
  if (given.size() != token.size()) return false;  // its length is no secret
  unsigned difference = 0;
  for (std::size_t i = 0; i < token.size(); ++i)
    difference |= static_cast<unsigned>(static_cast<unsigned char>(given[i])) ^
                  static_cast<unsigned>(static_cast<unsigned char>(token[i]));
  return difference == 0;
}

std::optional<Refusal> check_edit(const Headers& headers, const EditGate& gate) {
  const auto host = value_of(headers, "host");
  if (!has_port(host, gate.port)) return Refusal{421, "Host is not the address of this server"};
  if (value_of(headers, "origin") != "http://" + host)
    return Refusal{403, "the request does not come from the page of this server"};
  if (const auto site = value_of(headers, "sec-fetch-site"); !site.empty() && site != "same-origin")
    return Refusal{403, "the request does not come from the page of this server"};
  if (gate.token.empty() || !is_token_equal(value_of(headers, "orbs-token"), gate.token))
    return Refusal{403, "the token is not that of the address that orbs serve has printed"};
  return check_body(headers);
}

}  // namespace orbs::server
