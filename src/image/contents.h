#pragma once

#include <cstdint>

/// What the readers of all formats have in common.
namespace orbs::image {

/// What is read of a file: its header alone, which takes no pixel, or all.
enum class Wanted { Header, Pixels };

struct Window {
  int x = 0;
  int y = 0;
  int width = 0;
  int height = 0;
};

/// What a file's header says of its pixels.
struct StatedSize {
  Window stored;  // the pixels that are there
  Window whole;   // the image that they belong to
  int channels = 0;
};

/// Headers can claim any size in a few bytes: this many floats (2 GiB) hold an 8192 x 8192 image with eight
/// channels.
constexpr double kMostValues = 536870912.0;

/// No format of ours packs more values into a byte. The densest is an OpenEXR file of one colour with DWA
/// compression: 4 bytes for each 8 x 8 block, by deflate at best 1032 times shorter, are 16512 values a byte.
constexpr double kMostValuesPerByte = 32768;

/// InputError, before memory is asked for, unless this is a whole image that a file of this length can hold.
void check_size(const StatedSize& size, std::uintmax_t file_bytes);

}  // namespace orbs::image
