#pragma once

#include "report/packed_image.h"
#include "server/http.h"

#include <string>
#include <utility>

namespace orbs::server {

/// A text that is sent to many clients, and its gzip.
struct PackedText {
  std::string plain;
  std::string gzipped;
};

inline PackedText packed_text(std::string plain) {
  // zlib's default: 12 % smaller than the fastest level for the script of the page, made once per text.
  constexpr int kUsual = 6;
  auto gzipped = report::gzip(plain, kUsual);
  return {std::move(plain), std::move(gzipped)};
}

/// Answers with the gzip if the client reads it, otherwise with the text.
inline void send_text(const Request& request, const PackedText& text, const char* type, Response& response) {
  response.headers.emplace_back("Vary", "Accept-Encoding");
  if (request.reads_gzip) response.headers.emplace_back("Content-Encoding", "gzip");
  set_content(response, request.reads_gzip ? text.gzipped : text.plain, type);
}

}  // namespace orbs::server
