#pragma once

#include "base/files.h"
#include "json/document.h"
#include "json/object_reader.h"
#include "json/writer.h"

#include <filesystem>
#include <map>
#include <string>

namespace orbs::results {

/// Beside the references of a suite: the pixel hash of each, as it was accepted.
inline constexpr const char* kImageHashesFile = "image-hashes.json";

/// By name of the reference: the "image_hash" of its pixels (format "orbs-image-hashes/1"). Empty if there is
/// no such file. InputError if it is broken.
inline std::map<std::string, std::string> read_image_hashes(const std::filesystem::path& references) {
  const auto file = references / kImageHashesFile;
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored)) return {};
  const auto document = json::parse_file(file);
  json::ObjectReader in(document);
  in.one_of("format", {"orbs-image-hashes/1"});
  auto images = in.object("images");
  std::map<std::string, std::string> hashes;
  for (const auto& name : images.keys()) hashes[name] = images.text(name);
  in.finish();
  return hashes;
}

/// Writes the file. WriteError when the disk refuses.
inline void write_image_hashes(const std::map<std::string, std::string>& hashes,
                               const std::filesystem::path& references) {
  json::Writer out;
  out.begin_object().member("format", "orbs-image-hashes/1").key("images").begin_object();
  for (const auto& [name, hash] : hashes) out.member(name, hash);
  write_file(references / kImageHashesFile, out.end_object().end_object().text());
}

}  // namespace orbs::results
