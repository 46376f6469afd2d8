#pragma once

#include <string>
#include <string_view>

namespace orbs::report {

/// One gzip member (RFC 1952) without name and time: equal bytes give equal files. `level` is zlib's, 1
/// (fast) to 9 (small).
std::string gzip(std::string_view bytes, int level);

/// Base64 of RFC 4648, section 4, on one line.
std::string base64(std::string_view bytes);

}  // namespace orbs::report
