#include "image/image_io.h"

#include "base/error.h"
#include "base/files.h"
#include "image/exr_check.h"
#include "image/png_check.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <exception>
#include <memory>
#include <system_error>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace orbs::image {

namespace {

// Only these readers are asked. OpenImageIO would hand a file that its own reader refuses to each of its
// others in turn, video and raw-photo libraries included: slow on broken input, and some of those libraries
// write to stderr. TIFF is left out because version 2.4 returns a torn float TIFF as if it were whole.
constexpr std::array kFormats{"exr", "hdr", "png", "jpg", "jpeg", "bmp", "tga", "pfm", "ppm", "pgm"};

// A header can claim any size in a few bytes. 2^29 floats (2 GiB) hold an 8192 x 8192 image with eight
// channels.
constexpr double kMostValues = 536870912.0;

// Checks and readers take a file as a whole. No format needs more than 8 bytes for a value: a 16-bit number
// in text has 6, a float 4.
constexpr std::uintmax_t kMostBytes = 8 * static_cast<std::uintmax_t>(kMostValues) + (1U << 20);

[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& problem) {
  throw InputError(fmt::format("{}: {}", file.string(), problem));
}

// OpenImageIO keeps errors per object and per thread and prints those that nobody fetched to stderr at the
// end of the program, so both are always fetched.
std::string reason_of(const std::string& error_of_object) {
  const std::string global = OIIO::geterror();
  const std::string& text = error_of_object.empty() ? global : error_of_object;
  const auto line = text.substr(0, text.find('\n'));
  return line.empty() ? "torn, or the contents are of another format" : line;
}

std::string format_of(const std::filesystem::path& file) {
  std::string extension = file.extension().string();
  if (!extension.empty()) extension.erase(0, 1);
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (std::find(kFormats.begin(), kFormats.end(), extension) == kFormats.end())
    refuse(file,
           fmt::format("no image format is known by this name; known are .{}", fmt::join(kFormats, " .")));
  return extension;
}

void check_file(const std::filesystem::path& file) {
  std::error_code failed;
  const auto status = std::filesystem::status(file, failed);
  if (status.type() == std::filesystem::file_type::not_found) refuse(file, "there is no such image file");
  if (failed) refuse(file, fmt::format("cannot be read: {}", failed.message()));
  if (!std::filesystem::is_regular_file(status)) refuse(file, "is not a file, expected an image");
  const auto bytes = std::filesystem::file_size(file, failed);
  if (bytes == 0 && !failed) refuse(file, "is empty, expected an image");
  if (bytes > kMostBytes && !failed)
    refuse(file, fmt::format("has {} bytes; no image that is read has more than {}", bytes, kMostBytes));
}

void check_size(const OIIO::ImageSpec& spec, std::uintmax_t file_bytes, const std::filesystem::path& file) {
  if (spec.deep) refuse(file, "holds deep pixels, expected a flat image");
  if (spec.width < 1 || spec.height < 1 || spec.nchannels < 1 || spec.depth > 1)
    refuse(file, fmt::format("the header says {} x {} px with {} channels, which is no image", spec.width,
                             spec.height, spec.nchannels));
  const double values = static_cast<double>(spec.width) * spec.height * spec.nchannels;
  if (values > kMostValues)
    refuse(file, fmt::format("the header says {} x {} px with {} channels; at most {} values are read",
                             spec.width, spec.height, spec.nchannels, static_cast<long long>(kMostValues)));
  if (values > kMostValuesPerByte * static_cast<double>(file_bytes))
    refuse(file,
           fmt::format("the header says {} x {} px with {} channels, which is more than {} bytes can hold",
                       spec.width, spec.height, spec.nchannels, file_bytes));
  if (spec.x != spec.full_x || spec.y != spec.full_y || spec.width != spec.full_width ||
      spec.height != spec.full_height)
    refuse(file, fmt::format("the stored pixels ({} x {} at {}, {}) are not the whole image ({} x {} at {}, "
                             "{}); write it without a crop or overscan window",
                             spec.width, spec.height, spec.x, spec.y, spec.full_width, spec.full_height,
                             spec.full_x, spec.full_y));
}

// A torn JPEG is filled up with grey and reported as read. In entropy-coded data 0xff is always followed by
// 0x00 or a restart marker, so the end marker after the last start of scan is there only in a whole file
// (ITU-T T.81, B.1.1).
void check_jpeg_end(const std::filesystem::path& file) {
  const std::string bytes = read_file(file);
  const auto scan = bytes.rfind("\xff\xda");
  const auto end = bytes.rfind("\xff\xd9");
  if (scan == std::string::npos || end == std::string::npos || end < scan)
    refuse(file, "is no whole JPEG: the end marker is missing");
}

void check_bytes(void (*check)(std::string_view), std::string_view bytes, const std::filesystem::path& file) {
  try {
    check(bytes);
  } catch (const InputError& e) {
    refuse(file, e.what());
  }
}

void check_contents(const std::string& format, const std::filesystem::path& file) {
  if (format == "jpg" || format == "jpeg") check_jpeg_end(file);
  if (format == "png") check_bytes(check_png, read_file(file), file);
  if (format == "exr") check_bytes(check_exr, read_file(file), file);
}

std::unique_ptr<OIIO::ImageInput> open_image(const std::filesystem::path& file) {
  check_file(file);
  const std::string format = format_of(file);
  check_contents(format, file);
  auto input = OIIO::ImageInput::create(format);
  if (!input) refuse(file, fmt::format("this build reads no .{} files: {}", format, reason_of("")));
  OIIO::ImageSpec hints;
  hints["oiio:UnassociatedAlpha"] = 1;  // else colours with alpha come back multiplied by it, not as stored
  OIIO::ImageSpec ignored;
  if (!input->open(file.string(), ignored, hints))
    refuse(file, fmt::format("is no readable .{} image: {}", format, reason_of(input->geterror())));
  check_size(input->spec(), std::filesystem::file_size(file), file);
  return input;
}

// What the library itself says about a file, as opposed to what stands in its header.
bool is_invented(const std::string& name) {
  return name.starts_with("oiio:") || name.starts_with("openexr:") || name == "compression";
}

std::map<std::string, std::string> text_attributes(const OIIO::ImageSpec& spec) {
  std::map<std::string, std::string> attributes;
  for (const auto& attribute : spec.extra_attribs)
    if (attribute.type() == OIIO::TypeString && !is_invented(attribute.name().string()))
      attributes[attribute.name().string()] = attribute.get_string();
  return attributes;
}

// The libraries below report some damage by exceptions of their own (and memory that a torn header asks for
// by bad_alloc); for the caller all of it is an image that cannot be read.
template <typename F>
auto guarded(const std::filesystem::path& file, F&& work) {
  try {
    return work();
  } catch (const InputError&) {
    throw;
  } catch (const std::exception& e) {
    OIIO::geterror();
    refuse(file, e.what());
  }
}

void check_names(const Image& image, const std::filesystem::path& file) {
  for (std::size_t i = 0; i < image.channel_count(); ++i)
    if (image.channels[i].empty() || channel_index(image, image.channels[i]) != static_cast<int>(i))
      refuse(file, fmt::format("channel {} cannot be named '{}': names must be there and differ", i,
                               image.channels[i]));
}

// Beyond it a half is infinite; 65520 is halfway between the largest half and the next power of two and
// rounds up.
constexpr float kFirstBeyondHalf = 65520.0F;

void check_range_of_half(const Image& image, const std::filesystem::path& file) {
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    const float value = image.pixels[i];
    if (!std::isfinite(value) || std::fabs(value) < kFirstBeyondHalf) continue;
    if (is_variance(image.channels[i % image.channel_count()])) continue;  // stays a float
    const std::size_t pixel = i / image.channel_count();
    const auto width = static_cast<std::size_t>(image.width);
    refuse(file, fmt::format("{} in channel {} at pixel ({}, {}) does not fit into half floats; write floats",
                             value, image.channels[i % image.channel_count()], pixel % width, pixel / width));
  }
}

// `file` is for messages.
std::string encoded(const char* format,
                    const OIIO::ImageSpec& spec,
                    const OIIO::TypeDesc& type,
                    const void* pixels,
                    const std::filesystem::path& file) {
  auto output = OIIO::ImageOutput::create(format);
  if (!output) refuse(file, fmt::format("this build writes no {}: {}", format, reason_of("")));
  std::vector<unsigned char> bytes;
  OIIO::Filesystem::IOVecOutput memory(bytes);
  // The name only has to be there: the bytes go to memory.
  if (!output->set_ioproxy(&memory) || !output->open(fmt::format("memory.{}", format), spec) ||
      !output->write_image(type, pixels) || !output->close())
    refuse(file, fmt::format("cannot be encoded as {}: {}", format, reason_of(output->geterror())));
  return {bytes.begin(), bytes.end()};
}

}  // namespace

namespace {

// Of a layer, too: "variance.G". The first channel is what a grey image is made of, whatever its name.
bool is_colour(const OIIO::ImageSpec& spec, int channel) {
  const auto& name = spec.channelnames[static_cast<std::size_t>(channel)];
  const auto last = name.substr(name.rfind('.') + 1);
  constexpr std::array kColours{"R", "G", "B", "A", "Y"};
  return channel == 0 || std::find(kColours.begin(), kColours.end(), last) != kColours.end();
}

// Only EXR has such pixels. The library divides them by the largest integer, and no number of the file is
// meant so; a channel of labels beside the colours is read by nobody.
void check_no_integers(const OIIO::ImageSpec& spec, const std::filesystem::path& file) {
  for (int c = 0; c < spec.nchannels; ++c)
    if (is_colour(spec, c) && spec.channelformat(c) == OIIO::TypeUInt32)
      refuse(file, fmt::format("the EXR channel '{}' holds integers, expected half or float",
                               spec.channelnames[static_cast<std::size_t>(c)]));
}

Image read_pixels(OIIO::ImageInput& input, const std::filesystem::path& file) {
  const OIIO::ImageSpec& spec = input.spec();
  check_no_integers(spec, file);
  Image image = make_image(spec.width, spec.height, spec.channelnames);
  image.attributes = text_attributes(spec);
  if (!input.read_image(0, 0, 0, spec.nchannels, OIIO::TypeFloat, image.pixels.data()))
    refuse(file, fmt::format("the pixels cannot be read: {}", reason_of(input.geterror())));
  return image;
}

}  // namespace

Image read_image(const std::filesystem::path& file) {
  return guarded(file, [&] { return read_pixels(*open_image(file), file); });
}

Header read_header(const std::filesystem::path& file) {
  return guarded(file, [&] {
    const auto input = open_image(file);
    const auto& spec = input->spec();
    return Header{spec.width, spec.height, text_attributes(spec)};
  });
}

Image read_exr(const std::string& name, std::string_view bytes) {
  return guarded(name, [&] {
    if (bytes.empty()) refuse(name, "is empty, expected an image");
    check_bytes(check_exr, bytes, name);
    // The library's reader takes bytes that it does not change as ones that it could.
    OIIO::Filesystem::IOMemReader memory(const_cast<char*>(bytes.data()), bytes.size());
    auto input = OIIO::ImageInput::create("exr");
    OIIO::ImageSpec ignored;
    if (!input || !input->set_ioproxy(&memory) || !input->open("memory.exr", ignored))
      refuse(name, fmt::format("is no readable .exr image: {}", reason_of(input ? input->geterror() : "")));
    check_size(input->spec(), bytes.size(), name);
    return read_pixels(*input, name);
  });
}

namespace {

void write_channels(const Image& image,
                    const std::filesystem::path& file,
                    OIIO::TypeDesc colour_format,
                    const char* compression) {
  guarded(file, [&] {
    OIIO::ImageSpec spec(image.width, image.height, static_cast<int>(image.channel_count()), colour_format);
    spec.channelnames = image.channels;
    for (const auto& channel : image.channels)
      spec.channelformats.push_back(is_variance(channel) ? OIIO::TypeFloat : colour_format);
    // Without a DateTime the library writes the time of writing, and equal images would be unequal files.
    spec.attribute("DateTime", "");
    for (const auto& [name, text] : image.attributes) spec.attribute(name, text);
    spec.attribute("compression", compression);
    write_file(file, encoded("exr", spec, OIIO::TypeFloat, image.pixels.data(), file));
  });
}

}  // namespace

void write_exr(const Image& image, const std::filesystem::path& file, Precision precision) {
  check_names(image, file);
  if (precision == Precision::Half) {
    check_range_of_half(image, file);
    // Halves are for what is kept and published: the strongest deflate takes 8 % off the size of noise.
    return write_channels(image, file, OIIO::TypeHalf, "zip:9");
  }
  write_channels(image, file, OIIO::TypeFloat, "zip");
}

namespace {

std::string png_of(const Image& image, const std::filesystem::path& file) {
  const std::size_t kept = image.channel_count() >= 3 ? 3 : 1;
  std::vector<unsigned char> values;
  values.reserve(image.pixel_count() * kept);
  for (std::size_t pixel = 0; pixel < image.pixel_count(); ++pixel)
    for (std::size_t c = 0; c < kept; ++c) {
      const float value = image.pixels[pixel * image.channel_count() + c];
      if (std::isnan(value)) refuse(file, "a PNG cannot show NaN; mark such pixels before writing");
      values.push_back(static_cast<unsigned char>(std::lround(std::clamp(value, 0.0F, 1.0F) * 255.0F)));
    }
  return guarded(file, [&] {
    OIIO::ImageSpec spec(image.width, image.height, static_cast<int>(kept), OIIO::TypeUInt8);
    spec.attribute("oiio:ColorSpace", "sRGB");
    return encoded("png", spec, OIIO::TypeUInt8, values.data(), file);
  });
}

}  // namespace

void write_png(const Image& image, const std::filesystem::path& file) {
  write_file(file, png_of(image, file));
}

std::string png_bytes(const Image& image) { return png_of(image, "image.png"); }

bool is_ldr_file(const std::filesystem::path& file) {
  return guarded(file, [&] {
    const auto format = open_image(file)->spec().format;
    return format == OIIO::TypeUInt8 || format == OIIO::TypeUInt16;
  });
}

}  // namespace orbs::image
