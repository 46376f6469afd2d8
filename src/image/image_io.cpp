#include "image/image_io.h"

#include "base/error.h"
#include "base/files.h"
#include "image/colour.h"
#include "image/contents.h"
#include "image/exr.h"
#include "image/format_module.h"
#include "image/image.h"
#include "image/pfm.h"
#include "image/png.h"
#include "image/radiance.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <exception>
#include <filesystem>
#include <set>
#include <string>
#include <system_error>

#include <dlfcn.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace orbs::image {

namespace {

// What is read of a file, and whether its numbers are display-encoded (8- or 16-bit integers).
struct Contents {
  Image image;
  bool is_ldr = false;
};

// The module stays loaded until the program ends.
ReadImage loaded_module(const std::string& format) {
  const auto file = beside_program(kFormatModule);
  void* module = ::dlopen(file.c_str(), RTLD_LAZY | RTLD_LOCAL);
  void* function = module == nullptr ? nullptr : ::dlsym(module, kReadImage);
  if (function == nullptr)
    throw InputError(
        fmt::format(".{} files are read by {}, expected at {}, which cannot be loaded ({}); install orbs "
                    "again, or convert the file to .exr or .png",
                    format, kFormatModule, file.string(), ::dlerror()));
  return reinterpret_cast<ReadImage>(function);
}

struct Reading {
  std::uintmax_t file_bytes;
  Wanted wanted;
  Contents contents{};
  std::string refusal{};
};

Reading& reading_of(void* to) { return *static_cast<Reading*>(to); }

float* pixels_of(Reading& reading, const StatedSize& size) {
  check_size(size, reading.file_bytes);
  auto& image = reading.contents.image;
  image.width = size.stored.width;
  image.height = size.stored.height;
  if (reading.wanted == Wanted::Header) return nullptr;
  image.pixels.resize(image.pixel_count() * image.channel_count());
  return image.pixels.data();
}

FormatReceiver receiver_of(Reading& reading) {
  return {
      &reading,
      [](void* to, const char* name) { reading_of(to).contents.image.channels.emplace_back(name); },
      [](void* to, const char* name, const char* text) {
        reading_of(to).contents.image.attributes[name] = text;
      },
      [](void* to, bool is_ldr) { reading_of(to).contents.is_ldr = is_ldr; },
      [](void* to, const StatedSize& size) { return pixels_of(reading_of(to), size); },
      [](void* to, const char* problem) { reading_of(to).refusal = problem; },
  };
}

// A file of one of the formats that are rare here, by the shared module of image/format_module.h: it is
// loaded by the first such file, because loading OpenImageIO with its 260 libraries takes half a second.
// Errors say what is wrong, without the file's name. InputError as read_image, and when the module is not
// beside the program.
Contents read_other_format(const std::filesystem::path& file, const std::string& format, Wanted wanted) {
  static const ReadImage read = loaded_module(format);
  Reading reading{std::filesystem::file_size(file), wanted};
  const auto receiver = receiver_of(reading);
  read(file.c_str(), format.c_str(), &receiver);
  if (!reading.refusal.empty()) throw InputError(reading.refusal);
  return std::move(reading.contents);
}

// TIFF is left out because OpenImageIO 2.4 returns a torn float TIFF as if it were whole.
constexpr std::array kFormats{"exr", "hdr", "png", "jpg", "jpeg", "bmp", "tga", "pfm", "ppm", "pgm"};

// Checks and readers take a file as a whole. No format needs more than 8 bytes for a value: a 16-bit number
// in text has 6, a float 4.
constexpr std::uintmax_t kMostBytes = 8 * static_cast<std::uintmax_t>(kMostValues) + (1U << 20);

[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& problem) {
  throw InputError(fmt::format("{}: {}", file.string(), problem));
}

std::string lower_extension(const std::filesystem::path& file) {
  std::string extension = file.extension().string();
  if (!extension.empty()) extension.erase(0, 1);
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

std::string format_of(const std::filesystem::path& file) {
  const auto extension = lower_extension(file);
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

// What the readers and the libraries below say of a file, some of it by exceptions of their own (and memory
// that a torn header asks for by bad_alloc), is for the caller an image that cannot be read.
template <typename F>
auto guarded(const std::filesystem::path& file, F&& work) {
  try {
    return work();
  } catch (const std::exception& e) {
    refuse(file, e.what());
  }
}

Contents contents_of(const std::filesystem::path& file, Wanted wanted) {
  check_file(file);
  const std::string format = format_of(file);
  static const std::set<std::string> kOwn{"exr", "hdr", "pfm", "png"};
  if (!kOwn.contains(format)) return guarded(file, [&] { return read_other_format(file, format, wanted); });
  const std::string bytes = read_file(file);
  return guarded(file, [&]() -> Contents {
    if (format == "exr") return {decoded_exr(file.string(), bytes, wanted), false};
    if (format == "hdr") return {decoded_radiance(bytes, wanted), false};
    if (format == "pfm") return {decoded_pfm(bytes, wanted), false};
    return {decoded_png(bytes, wanted), true};
  });
}

void check_names(const Image& image) {
  for (std::size_t i = 0; i < image.channel_count(); ++i)
    if (image.channels[i].empty() || channel_index(image, image.channels[i]) != static_cast<int>(i))
      throw InputError(fmt::format("channel {} cannot be named '{}': names must be there and differ", i,
                                   image.channels[i]));
}

// Beyond it a half is infinite; 65520 is halfway between the largest half and the next power of two and
// rounds up.
constexpr float kFirstBeyondHalf = 65520.0F;

void check_range_of_half(const Image& image) {
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    const float value = image.pixels[i];
    if (!std::isfinite(value) || std::fabs(value) < kFirstBeyondHalf) continue;
    if (stays_float(image.channels[i % image.channel_count()])) continue;
    const std::size_t pixel = i / image.channel_count();
    const auto width = static_cast<std::size_t>(image.width);
    throw InputError(
        fmt::format("{} in channel {} at pixel ({}, {}) does not fit into half floats; write floats", value,
                    image.channels[i % image.channel_count()], pixel % width, pixel / width));
  }
}

}  // namespace

Image read_image(const std::filesystem::path& file) { return contents_of(file, Wanted::Pixels).image; }

Header read_header(const std::filesystem::path& file) {
  auto image = contents_of(file, Wanted::Header).image;
  return {image.width, image.height, std::move(image.attributes)};
}

Image read_exr(const std::string& name, std::string_view bytes) {
  if (bytes.empty()) refuse(name, "is empty, expected an image");
  return guarded(name, [&] { return decoded_exr(name, bytes, Wanted::Pixels); });
}

std::array<std::size_t, 3> texture_channels(const Image& image) {
  const auto place = [&](const char* name) { return channel_index(image, name); };
  const std::array colours{place("R"), place("G"), place("B")};
  if (std::all_of(colours.begin(), colours.end(), [](int at) { return at >= 0; }))
    return {static_cast<std::size_t>(colours[0]), static_cast<std::size_t>(colours[1]),
            static_cast<std::size_t>(colours[2])};
  // Beside a Y of positions or of luminance and chroma, there are others.
  const bool is_grey = std::all_of(image.channels.begin(), image.channels.end(), [](const auto& name) {
    return name == "Y" || name == "A" || name.find('.') != std::string::npos;
  });
  const int grey = place("Y");
  if (grey < 0 || !is_grey)
    throw InputError(fmt::format("has the channels {}; expected R, G and B, or Y alone, and alpha as A",
                                 fmt::join(image.channels, ", ")));
  const auto at = static_cast<std::size_t>(grey);
  return {at, at, at};
}

Image read_linear_rgb(const std::filesystem::path& file, Encoded encoded) {
  const auto [image, is_ldr] = contents_of(file, Wanted::Pixels);
  const bool is_encoded = is_ldr && encoded == Encoded::Srgb;
  const auto channels = guarded(file, [&image = image] { return texture_channels(image); });
  Image linear = make_image(image.width, image.height, {"R", "G", "B"});
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      for (std::size_t c = 0; c < 3; ++c) {
        const float value = image.at(x, y, channels.at(c));
        linear.at(x, y, c) = is_encoded ? srgb_decode(value) : value;
      }
  return linear;
}

Image read_rgb_with_steps(const std::filesystem::path& file) {
  if (format_of(file) != "hdr") return read_linear_rgb(file);
  check_file(file);
  const std::string bytes = read_file(file);
  return guarded(file, [&] { return decoded_radiance_with_steps(bytes); });
}

void write_exr(const Image& image,
               const std::filesystem::path& file,
               Precision precision,
               Compression compression) {
  const auto bytes = guarded(file, [&] {
    check_names(image);
    if (precision == Precision::Half) check_range_of_half(image);
    return encoded_exr(image, precision, compression);
  });
  write_file(file, bytes);
}

void write_png(const Image& image, const std::filesystem::path& file) {
  write_file(file, guarded(file, [&] { return encoded_png(image); }));
}

std::string png_bytes(const Image& image) {
  return guarded("image.png", [&] { return encoded_png(image); });
}

bool is_image_name(const std::filesystem::path& file) {
  const auto extension = lower_extension(file);
  return std::find(kFormats.begin(), kFormats.end(), extension) != kFormats.end();
}

bool looks_like_image(const std::filesystem::path& file) {
  static const std::set<std::string> kOthers{"avif", "cin", "dds",  "dpx",  "gif",  "heic", "jfif", "jp2",
                                             "jpe",  "jxl", "ktx",  "ktx2", "pam",  "phm",  "pic",  "pnm",
                                             "psd",  "qoi", "rgb",  "rgba", "rgbe", "sgi",  "sxr",  "tif",
                                             "tiff", "tx",  "webp", "xyze", "zfile"};
  return is_image_name(file) || kOthers.contains(lower_extension(file));
}

bool is_float_format(const std::filesystem::path& file) {
  const auto format = format_of(file);
  return format == "exr" || format == "hdr" || format == "pfm";
}

bool is_ldr_file(const std::filesystem::path& file) { return contents_of(file, Wanted::Header).is_ldr; }

}  // namespace orbs::image
