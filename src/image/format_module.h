#pragma once

#include "image/contents.h"

/// What passes between image/other_formats.cpp and the shared module liborbs-image-formats.so, which reads by
/// OpenImageIO: plain data and functions, so that neither side frees what the other one allocated.
namespace orbs::image {

/// Takes what the module has read; `to` is the first argument of each. Texts are gone after the call.
struct FormatReceiver {
  void* to;
  void (*channel)(void* to, const char* name);  // in their order, before the pixels
  void (*attribute)(void* to, const char* name, const char* text);
  void (*is_ldr)(void* to, bool is_ldr);  // whether the pixels are 8- or 16-bit integers
  // Where the pixels go, channels interleaved; null when none are wanted. A size that is no image is refused
  // by an exception, which goes no further than the module.
  float* (*pixels)(void* to, const StatedSize& size);
  void (*refusal)(void* to, const char* problem);  // in place of all that has not come yet
};

/// The module's one function, `orbs_read_image`. `format` is the file's ending, "jpg". Throws nothing.
using ReadImage = void (*)(const char* file, const char* format, const FormatReceiver* receiver);

constexpr const char* kFormatModule = "liborbs-image-formats.so";
constexpr const char* kReadImage = "orbs_read_image";

}  // namespace orbs::image
