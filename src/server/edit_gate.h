#pragma once

#include "server/refusal.h"

#include <map>
#include <optional>
#include <string>
#include <string_view>

/// Which requests may change a file: those that only the page of this server can send, opened by who reads
/// this terminal.

namespace orbs::server {

constexpr std::size_t kMostBodyBytes = 65536;
constexpr std::string_view kEditPath = "/edit/";

/// 32 bytes of the system's random generator as 64 hexadecimal digits. InputError if it has none.
std::string new_token();

/// Whether the texts are equal; takes the same time wherever they differ, so that time tells nothing of the
/// token.
bool is_token_equal(std::string_view given, std::string_view token);

/// By name in lower case.
using Headers = std::map<std::string, std::string>;

/// Why a POST with these headers may not pass. It must name this server's own address as Host and as Origin,
/// which a page of another server cannot; carry the token, which another program or user of the machine does
/// not know; and be JSON, which no form of another page sends without asking first.
std::optional<Refusal> check_edit(const Headers& headers, const EditGate& gate);

}  // namespace orbs::server
