// The shared module liborbs-image-formats.so: the formats that image/ does not read itself, by OpenImageIO.
#include "image/format_module.h"

#include <exception>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>

#include <OpenImageIO/imageio.h>

namespace orbs::image_formats {

namespace {

[[noreturn]] void refuse(const std::string& problem) { throw std::runtime_error(problem); }

// OpenImageIO keeps errors per object and per thread and prints those that nobody fetched to stderr at the
// end of the program, so both are always fetched.
std::string reason_of(const std::string& error_of_object) {
  const std::string global = OIIO::geterror();
  const std::string& text = error_of_object.empty() ? global : error_of_object;
  const auto line = text.substr(0, text.find('\n'));
  return line.empty() ? "torn, or the contents are of another format" : line;
}

// A torn JPEG is filled up with grey and reported as read. In entropy-coded data 0xff is always followed by
// 0x00 or a restart marker, so the end marker after the last start of scan is there only in a whole file
// (ITU-T T.81, B.1.1).
void check_jpeg_end(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(in), {}};
  const auto scan = bytes.rfind("\xff\xda");
  const auto end = bytes.rfind("\xff\xd9");
  if (scan == std::string::npos || end == std::string::npos || end < scan)
    refuse("is no whole JPEG: the end marker is missing");
}

std::unique_ptr<OIIO::ImageInput> open_image(const std::string& file, const std::string& format) {
  // Only the reader of this ending is asked. OpenImageIO would hand a file that it refuses to each of its
  // others in turn, video and raw-photo libraries included: slow on broken input, and some of those libraries
  // write to stderr.
  auto input = OIIO::ImageInput::create(format);
  if (!input) refuse("this OpenImageIO reads no ." + format + " files: " + reason_of(""));
  OIIO::ImageSpec hints;
  hints["oiio:UnassociatedAlpha"] = 1;  // else colours with alpha come back multiplied by it, not as stored
  OIIO::ImageSpec ignored;
  if (!input->open(file, ignored, hints))
    refuse("is no readable ." + format + " image: " + reason_of(input->geterror()));
  const auto& spec = input->spec();
  if (spec.deep || spec.depth > 1) refuse("holds deep pixels or a volume, expected a flat image");
  return input;
}

void hand_over(const OIIO::ImageSpec& spec, const image::FormatReceiver& receiver) {
  for (const auto& name : spec.channelnames) receiver.channel(receiver.to, name.c_str());
  for (const auto& attribute : spec.extra_attribs) {
    const auto name = attribute.name().string();
    // What the library itself says about a file, as opposed to what stands in its header.
    const bool is_invented = name.starts_with("oiio:") || name == "compression";
    if (attribute.type() == OIIO::TypeString && !is_invented)
      receiver.attribute(receiver.to, name.c_str(), attribute.get_string().c_str());
  }
  receiver.is_ldr(receiver.to, spec.format == OIIO::TypeUInt8 || spec.format == OIIO::TypeUInt16);
}

void read_image(const std::string& file, const std::string& format, const image::FormatReceiver& receiver) {
  if (format == "jpg" || format == "jpeg") check_jpeg_end(file);
  const auto input = open_image(file, format);
  const auto& spec = input->spec();
  hand_over(spec, receiver);
  const image::Window stored{spec.x, spec.y, spec.width, spec.height};
  const image::Window whole{spec.full_x, spec.full_y, spec.full_width, spec.full_height};
  float* pixels = receiver.pixels(receiver.to, {stored, whole, spec.nchannels});
  if (pixels != nullptr && !input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeFloat, pixels))
    refuse("the pixels cannot be read: " + reason_of(input->geterror()));
}

}  // namespace

// The libraries below report some damage by exceptions of their own (and memory that a torn header asks for
// by bad_alloc); for the caller all of it is an image that cannot be read.
extern "C" [[gnu::visibility("default")]] void orbs_read_image(const char* file,
                                                               const char* format,
                                                               const image::FormatReceiver* receiver) {
  try {
    read_image(file, format, *receiver);
  } catch (const std::exception& e) {
    OIIO::geterror();
    receiver->refusal(receiver->to, e.what());
  } catch (...) {
    receiver->refusal(receiver->to, "the image library has failed");
  }
}

}  // namespace orbs::image_formats
