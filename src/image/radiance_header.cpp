#include "image/radiance_header.h"

#include "base/error.h"
#include "base/text.h"
#include "image/rec709.h"

#include <cmath>
#include <optional>
#include <vector>

#include <fmt/format.h>

namespace orbs::image {

namespace {

// "The RADIANCE Picture File Format", https://radsite.lbl.gov/radiance/refer/filefmts.pdf
constexpr std::string_view kMagic = "#?";
constexpr std::size_t kMostBytes = 1U << 20;  // of a header: command lines of filters pile up in it

// The next line, without its end. Some writers end lines with a carriage return, too.
std::string_view take_line(std::string_view bytes, RadianceHeader& header) {
  const auto rest = bytes.substr(header.length);
  const auto end = rest.find('\n');
  if (end == std::string_view::npos || header.length + end > kMostBytes)
    throw InputError("its header does not end: expected an empty line, and one such as '-Y 480 +X 640'");
  header.length += end + 1;
  auto line = rest.substr(0, end);
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

std::vector<double> numbers_of(const std::string& name, std::string_view text, std::size_t count) {
  std::vector<double> numbers;
  for (const auto& word : words_of(text)) {
    const auto number = to_number(word);
    if (!number || !std::isfinite(*number))
      throw InputError(fmt::format("its {} is '{}'; expected {}", name, clean_line(text),
                                   count == 1 ? "a number" : fmt::format("{} numbers", count)));
    numbers.push_back(*number);
  }
  if (numbers.size() != count)
    throw InputError(fmt::format("its {} has {} numbers; expected {}", name, numbers.size(), count));
  return numbers;
}

void check_format(std::string_view format) {
  if (format == "32-bit_rle_rgbe") return;
  throw InputError(
      fmt::format("its FORMAT is {}; expected 32-bit_rle_rgbe; 'ra_xyze -r' of Radiance "
                  "converts 32-bit_rle_xyze",
                  clean_line(format)));
}

void check_one(const std::string& name, std::string_view text, const char* otherwise) {
  if (const auto number = numbers_of(name, text, 1)[0]; number != 1)
    throw InputError(fmt::format("its {} is {}, expected {}", name, number, otherwise));
}

// As an EXR with other chromaticities is. Photoshop writes zeros, which say nothing.
void check_primaries(std::string_view text) {
  const auto numbers = numbers_of("PRIMARIES", text, 8);
  bool are_zero = true;
  std::array<float, 8> found{};
  for (std::size_t i = 0; i < found.size(); ++i) {
    found.at(i) = static_cast<float>(numbers[i]);
    are_zero = are_zero && numbers[i] == 0;
  }
  if (!are_zero) check_rec709("PRIMARIES", found);
}

// Both may stand there several times, and their product counts.
void divide_later(const std::string& name, std::string_view text, RadianceHeader& header) {
  const auto factors = numbers_of(name, text, name == "EXPOSURE" ? 1 : 3);
  for (std::size_t c = 0; c < 3; ++c) {
    const double factor = factors[factors.size() == 1 ? 0 : c];
    auto& product = header.multiplied_by.at(c);
    product *= factor;
    if (!(factor > 0) || !std::isnormal(product))
      throw InputError(fmt::format("its {} is {}; expected a factor above 0", name, clean_line(text)));
  }
}

void take_variable(std::string_view line, RadianceHeader& header) {
  const auto sign = line.find('=');
  if (line.starts_with('#') || sign == std::string_view::npos) return;  // a comment, or a command line
  const std::string name(trim(line.substr(0, sign)));
  const auto text = trim(line.substr(sign + 1));
  if (name == "FORMAT") return check_format(text);
  if (name == "GAMMA") return check_one(name, text, "linear values (1)");
  if (name == "PIXASPECT") return check_one(name, text, "square pixels (1)");
  if (name == "PRIMARIES") return check_primaries(text);
  if (name == "EXPOSURE" || name == "COLORCORR") return divide_later(name, text, header);
  if (!name.empty() && !text.empty()) header.attributes[name] = std::string(text);
}

[[noreturn]] void refuse_resolution(std::string_view line) {
  throw InputError(fmt::format("its resolution is '{}'; expected a line such as '-Y 480 +X 640'",
                               clean_line(line.substr(0, 80))));
}

// "-Y 480 +X 640": the axis of the lines' number, then that within a line; "+Y" counts from the bottom.
RadianceOrder order_of(std::string_view line) {
  const auto words = words_of(line);
  if (words.size() != 4 || words[0].size() != 2 || words[2].size() != 2) refuse_resolution(line);
  RadianceOrder order;
  const auto take = [&](const std::string& axis, const std::string& text) {
    const auto length = to_integer(text);
    constexpr long long kMost = 1 << 24;
    if (!length || *length < 1 || *length > kMost || (axis[0] != '+' && axis[0] != '-'))
      refuse_resolution(line);
    if (axis[1] == 'X') {
      order.width_px = static_cast<int>(*length);
      order.is_left_to_right = axis[0] == '+';
    } else if (axis[1] == 'Y') {
      order.height_px = static_cast<int>(*length);
      order.is_top_to_bottom = axis[0] == '-';
    }
  };
  take(words[0], words[1]);
  take(words[2], words[3]);
  order.has_columns = words[0][1] == 'X';
  if (order.width_px == 0 || order.height_px == 0) refuse_resolution(line);
  return order;
}

}  // namespace

RadianceHeader radiance_header(std::string_view bytes) {
  if (!bytes.starts_with(kMagic))
    throw InputError("is no readable .hdr image: it does not start with '#?RADIANCE'");
  RadianceHeader header;
  take_line(bytes, header);
  for (auto line = take_line(bytes, header); !line.empty(); line = take_line(bytes, header))
    take_variable(line, header);
  header.order = order_of(take_line(bytes, header));
  return header;
}

}  // namespace orbs::image
