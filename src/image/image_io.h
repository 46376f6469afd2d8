#pragma once

#include "image/image.h"

#include <array>
#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>

namespace orbs::image {

/// An EXR, HDR, PNG, JPEG, BMP, TGA, PFM, PPM or PGM file, known by its ending; of several images in it the
/// first. Channel names are kept ("R", "G", "B" come first), values are as stored (no colour conversion: an
/// 8-bit 255 is 1.0), of the attributes those that are text and not empty. InputError with the reason when
/// the file is missing, torn, too large to be meant, cropped, or no image, or has colours that are 32-bit
/// integers; nothing is printed. EXR, HDR, PFM and PNG are read by the program itself, all others by a shared
/// module beside it, which is loaded when it is needed.
Image read_image(const std::filesystem::path& file);

struct Header {
  int width_px = 0;
  int height_px = 0;
  std::map<std::string, std::string> attributes;  // those that are text and not empty
};

/// What the file's header states, without decoding a pixel. InputError as read_image.
Header read_header(const std::filesystem::path& file);

/// An EXR file whose bytes are at hand, read as read_image does; `name` is for messages.
Image read_exr(const std::string& name, std::string_view bytes);

/// OpenEXR, attributes in the header; written beside and renamed into place. Equal images
/// give equal files. InputError when two channels share a name, a finite value is beyond the largest half, or
/// the disk refuses.
void write_exr(const Image& image,
               const std::filesystem::path& file,
               Precision precision = Precision::Float,
               Compression compression = Compression::Zip);

/// 8-bit PNG of the first three channels (or the first, as grey) of an image that is ready to show: nearest
/// of 256 steps, what lies outside [0, 1] at its end. Written like an EXR. InputError for NaN, which no PNG
/// can show.
void write_png(const Image& image, const std::filesystem::path& file);

/// The bytes of the PNG that write_png writes. InputError for NaN.
std::string png_bytes(const Image& image);

/// Where an image that serves as a texture has R, G and B; of a grey one, whose only colour is "Y", three
/// times that. Alpha ("A") is left out, as is all that stands beside R, G and B. InputError with the names
/// found for anything else, such as normals or depths.
std::array<std::size_t, 3> texture_channels(const Image& image);

/// An image that serves as a texture, as channels R, G, B in linear values: 8- and 16-bit files are sRGB and
/// decoded per pixel, unless they hold plain numbers in [0, 1]; float files are linear already. InputError as
/// read_image and texture_channels.
enum class Encoded { Srgb, Numbers };
Image read_linear_rgb(const std::filesystem::path& file, Encoded encoded = Encoded::Srgb);

/// As read_linear_rgb of a float file; of a Radiance picture with the channels kRgbeSteps, too.
Image read_rgb_with_steps(const std::filesystem::path& file);

/// Whether read_image knows the ending, in any case: "a.EXR".
bool is_image_name(const std::filesystem::path& file);

/// Whether the ending is one of images, of those too that read_image does not know: "a.tif".
bool looks_like_image(const std::filesystem::path& file);

/// Whether files of this ending hold floats, whose values may be any. InputError for an ending that is not
/// known.
bool is_float_format(const std::filesystem::path& file);

/// True for a file whose numbers are display-encoded (sRGB): 8- and 16-bit integer pixels. InputError as
/// read_image.
bool is_ldr_file(const std::filesystem::path& file);

}  // namespace orbs::image
