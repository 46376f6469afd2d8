#include "server/request_gate.h"

#include "base/text.h"
#include "server/edit_gate.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <vector>

#include <fmt/format.h>

namespace orbs::server {

namespace {

using MaybeRefusal = std::optional<Refusal>;  // none if the request may pass

bool is_token(std::string_view text) {  // RFC 9110, section 5.6.2
  constexpr std::string_view kMarks = "!#$%&'*+-.^_`|~";
  return !text.empty() && std::all_of(text.begin(), text.end(), [&](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || kMarks.find(c) != std::string_view::npos;
  });
}

std::string lower(std::string_view text) {
  std::string out(text);
  std::transform(out.begin(), out.end(), out.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return out;
}

bool is_utf8(std::string_view text) {
  while (!text.empty()) {
    const auto length = utf8_length(text);
    if (length == 0) return false;
    text.remove_prefix(length);
  }
  return true;
}

MaybeRefusal check_characters(std::string_view target) {
  for (std::size_t i = 0; i < target.size(); ++i) {
    const auto c = static_cast<unsigned char>(target[i]);
    if (c <= 0x20 || c >= 0x7f || std::string_view("\"#<>\\^`{|}").find(target[i]) != std::string_view::npos)
      return Refusal{400, "the address holds a character that must be percent-encoded"};
    if (c != '%') continue;
    if (i + 2 >= target.size() || hex_digit(target[i + 1]) < 0 || hex_digit(target[i + 2]) < 0)
      return Refusal{400, "the address holds a broken percent code"};
    const int code = 16 * hex_digit(target[i + 1]) + hex_digit(target[i + 2]);
    // Honest clients never encode these; attackers do, hoping for a check that comes before the decoding.
    if (code < 0x20 || code == 0x7f || code == '/' || code == '\\' || code == '.')
      return Refusal{400, "the address holds an encoded separator, dot or control character"};
  }
  return std::nullopt;
}

MaybeRefusal check_segments(std::string_view path) {
  if (path == "/") return std::nullopt;
  for (const auto& segment : split(path.substr(1), '/'))
    if (segment.empty() || segment == "." || segment == "..")
      return Refusal{400, "the address holds an empty, '.' or '..' segment"};
  return std::nullopt;
}

MaybeRefusal check_target(std::string_view target) {
  if (target.size() > kMostTargetBytes) return Refusal{414, "the address is too long"};
  if (!target.starts_with('/')) return Refusal{400, "the address is no absolute path"};
  if (auto refusal = check_characters(target)) return refusal;
  if (!is_utf8(decoded(target))) return Refusal{400, "the address is not UTF-8"};
  return check_segments(target.substr(0, target.find('?')));
}

bool is_edit(const std::vector<std::string>& words, const GateSettings& settings) {
  return settings.edit && words.size() == 3 && words[0] == "POST" && words[1].starts_with(kEditPath);
}

MaybeRefusal check_request_line(const std::vector<std::string>& words, const GateSettings& settings) {
  if (words.size() != 3) return Refusal{400, "the request line is not 'METHOD address version'"};
  if (!is_token(words[0])) return Refusal{400, "the method is no word"};
  if (words[2] != "HTTP/1.1" && words[2] != "HTTP/1.0")
    return words[2].starts_with("HTTP/") ? Refusal{505, "only HTTP/1.0 and HTTP/1.1 are spoken here"}
                                         : Refusal{400, "the request line names no version of HTTP"};
  const bool may_edit = is_edit(words, settings);
  if (settings.edit && !may_edit && words[1].starts_with(kEditPath))
    return Refusal{405, "only POST changes something", "POST"};
  if (!may_edit && words[0] != "GET" && words[0] != "HEAD")
    return Refusal{405, "only GET and HEAD are answered"};
  return check_target(words[1]);
}

bool is_loopback_name(std::string_view host) {
  const auto name =
      host.starts_with('[') ? host.substr(0, host.find(']') + 1) : host.substr(0, host.find(':'));
  const auto port = host.substr(name.size());
  const bool is_port =
      port.empty() || (port.size() > 1 && port.size() <= 6 && to_integer(port.substr(1)).value_or(-1) >= 0);
  const auto known = lower(name);
  return is_port && (known == "localhost" || known == "127.0.0.1" || known == "[::1]");
}

MaybeRefusal check_header(std::string_view line, Headers& seen, bool has_body, const GateSettings& settings) {
  const auto colon = line.find(':');
  if (colon == std::string_view::npos || !is_token(line.substr(0, colon)))
    return Refusal{400, "a header is not 'name: value'"};
  const auto name = lower(line.substr(0, colon));
  const auto value = trim(line.substr(colon + 1));
  for (const char c : value)
    if ((static_cast<unsigned char>(c) < 0x20 && c != '\t') || c == 0x7f)
      return Refusal{400, "a header holds a control character"};
  const bool is_new = seen.emplace(name, value).second;
  if (has_body && !is_new) return Refusal{400, "a header is given twice"};
  if (name == "transfer-encoding" || name == "expect" ||
      (name == "content-length" && value != "0" && !has_body))
    return Refusal{413, "a request has no body here"};
  if (name != "host") return std::nullopt;
  if (!is_new) return Refusal{400, "Host is given twice"};
  if (settings.only_loopback_names && !is_loopback_name(value))
    return Refusal{421, "Host is not a name of this machine's loopback"};
  return std::nullopt;
}

MaybeRefusal check_headers(const std::vector<std::string_view>& lines,
                           bool has_body,
                           const GateSettings& settings,
                           Headers& seen) {
  if (lines.size() - 1 > kMostHeaders) return Refusal{431, "there are too many headers"};
  for (std::size_t i = 1; i < lines.size(); ++i)
    if (auto refusal = check_header(lines[i], seen, has_body, settings)) return refusal;
  if (!seen.contains("host")) return Refusal{400, "Host is missing"};
  return std::nullopt;
}

// RFC 9110, section 12.5.3: a list of codings, each perhaps with a weight; that of a refused one is 0.
// Clients that write "gzip;q=0.0" or "*" get plain bytes, which all of them read.
bool reads_gzip(const std::vector<std::string_view>& lines) {
  for (const auto line : lines) {
    const auto colon = line.find(':');
    if (colon == std::string_view::npos || lower(line.substr(0, colon)) != "accept-encoding") continue;
    for (const auto& coding : split(line.substr(colon + 1), ','))
      if (lower(trim(coding)) == "gzip") return true;
  }
  return false;
}

// Splits at CR LF. None if a CR or LF stands alone or the empty line is not the end.
std::optional<std::vector<std::string_view>> lines_of(std::string_view head) {
  if (!head.ends_with("\r\n\r\n")) return std::nullopt;
  head.remove_suffix(2);
  std::vector<std::string_view> lines;
  while (!head.empty()) {
    const auto end = head.find("\r\n");
    const auto line = head.substr(0, end);
    if (line.empty() || line.find_first_of(std::string_view("\r\n\0", 3)) != std::string_view::npos)
      return std::nullopt;
    lines.push_back(line);
    head.remove_prefix(end + 2);
  }
  return lines;
}

}  // namespace

std::variant<Admitted, Refusal> check_request(std::string_view head, const GateSettings& settings) {
  if (head.size() > kMostHeadBytes) return Refusal{431, "the headers are too long"};
  const auto lines = lines_of(head);
  if (!lines || lines->empty()) return Refusal{400, "the lines of the request do not end in CR LF"};
  const auto words = split(lines->front(), ' ');
  if (auto refusal = check_request_line(words, settings)) return *refusal;
  const bool has_body = is_edit(words, settings);
  Headers headers;
  if (auto refusal = check_headers(*lines, has_body, settings, headers)) return *refusal;
  Admitted admitted{{words[0], words[1], reads_gzip(*lines)}};
  if (has_body) {
    if (auto refusal = check_edit(headers, *settings.edit)) return *refusal;
    admitted.body_bytes = static_cast<std::size_t>(*to_integer(headers.at("content-length")));
  }
  return admitted;
}

}  // namespace orbs::server
