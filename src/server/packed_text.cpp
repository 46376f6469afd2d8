#include "server/packed_text.h"

#include "report/gzip.h"
#include "server/request_gate.h"

#include <utility>

namespace orbs::server {

PackedText packed_text(std::string plain) {
  // JSON of an overview shrinks to a tenth at any level; the fastest takes 5 ms per megabyte.
  constexpr int kFast = 1;
  auto gzipped = report::gzip(plain, kFast);
  return {std::move(plain), std::move(gzipped)};
}

void send_text(const httplib::Request& request,
               const PackedText& text,
               const char* type,
               httplib::Response& response) {
  response.set_header("Vary", "Accept-Encoding");
  if (!request.has_header(kReadsGzip)) return response.set_content(text.plain, type);
  response.set_header("Content-Encoding", "gzip");
  response.set_content(text.gzipped, type);
}

}  // namespace orbs::server
