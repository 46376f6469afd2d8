#pragma once

#include "base/error.h"

#include <stdexcept>
#include <string>
#include <string_view>

/// What strangers write, given to the reader that meets it. Each function returns the reader's complaint, ""
/// when the bytes were read; whatever else comes out of it is a bug of ours: another exception, a promise of
/// the reader that does not hold (std::logic_error), a crash, no end.
namespace orbs::fuzz {

std::string feed_scene(std::string_view bytes);          // orbs-scene/1
std::string feed_configuration(std::string_view bytes);  // configuration.json
std::string feed_case(std::string_view bytes);           // case.json
std::string feed_obj(std::string_view bytes);
std::string feed_ply(std::string_view bytes);
std::string feed_ies(std::string_view bytes);
std::string feed_exr(std::string_view bytes);
std::string feed_image(std::string_view bytes);  // PNG, JPEG, HDR, BMP, TGA, PFM, PPM, PGM

std::string feed_expression(std::string_view bytes);  // a formula of an implicit surface or a displacement
std::string feed_table(std::string_view bytes);       // a measured spectrum, CSV
std::string feed_record(std::string_view bytes);      // files of runs, studies and suites: results.json, ...
std::string feed_request(std::string_view bytes);     // the head of an HTTP request

/// For promises that a reader's own checks are to keep.
inline void require(bool holds, const std::string& promise) {
  if (!holds) throw std::logic_error("not kept: " + promise);
}

/// The InputError of `read`, which must name the file and stay readable; "" when there is none.
template <typename F>
std::string complaint_of(const std::string& file, F&& read) {
  constexpr std::size_t kLongest = 10000;  // some complaints quote a word of the file
  try {
    read();
  } catch (const InputError& e) {
    const std::string text = e.what();
    require(text.starts_with(file + ":"), "a complaint names the file: " + text);
    require(text.size() < kLongest, "a complaint is no copy of the file");
    return text;
  }
  return "";
}

}  // namespace orbs::fuzz
