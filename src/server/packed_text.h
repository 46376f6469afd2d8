#pragma once

#include <string>

#include <httplib.h>

namespace orbs::server {

/// A text that is sent to many clients, and its gzip.
struct PackedText {
  std::string plain;
  std::string gzipped;
};

PackedText packed_text(std::string plain);

/// Answers with the gzip if the client reads it, otherwise with the text.
void send_text(const httplib::Request& request,
               const PackedText& text,
               const char* type,
               httplib::Response& response);

}  // namespace orbs::server
