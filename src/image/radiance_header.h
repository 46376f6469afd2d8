#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <string>
#include <string_view>

namespace orbs::image {

/// In which order a Radiance picture stores its pixels: in lines along one axis, line by line along the
/// other.
struct RadianceOrder {
  int width_px = 0;
  int height_px = 0;
  bool has_columns = false;  // lines are columns: the X of its resolution comes first
  bool is_left_to_right = true;
  bool is_top_to_bottom = true;
};

/// What stands before the pixels of a Radiance picture (.hdr).
struct RadianceHeader {
  RadianceOrder order;
  /// What the numbers of red, green and blue were multiplied by before they were stored: the product of all
  /// EXPOSURE and COLORCORR.
  std::array<double, 3> multiplied_by{1, 1, 1};
  std::map<std::string, std::string> attributes;  // its other variables, by name
  std::size_t length = 0;                         // in bytes; the pixels follow
};

/// InputError, without the name of a file, for a header that is none, and for pixels that are no linear
/// Rec.709: of another FORMAT, PRIMARIES, GAMMA or PIXASPECT.
RadianceHeader radiance_header(std::string_view bytes);

}  // namespace orbs::image
