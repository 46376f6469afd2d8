#pragma once

#include "report/packed_image.h"
#include "server/request_gate.h"

#include <string>
#include <utility>

#include <httplib.h>

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
inline void send_text(const httplib::Request& request,
                      const PackedText& text,
                      const char* type,
                      httplib::Response& response) {
  response.set_header("Vary", "Accept-Encoding");
  if (!request.has_header(kReadsGzip)) return response.set_content(text.plain, type);
  response.set_header("Content-Encoding", "gzip");
  response.set_content(text.gzipped, type);
}

}  // namespace orbs::server
