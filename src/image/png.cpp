#include "image/png.h"

#include "base/error.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <map>
#include <new>
#include <vector>

#include <fmt/format.h>
#include <png.h>

namespace orbs::image {

namespace {

// Where libpng's functions find what is ours.
struct Context {
  const char* failed;      // how an error begins
  std::string_view left;   // to read
  std::string* written{};  // to write
  std::string last_warning{};
};

Context& context_of(png_structp png) { return *static_cast<Context*>(png_get_io_ptr(png)); }

// The unwind tables that the ABI of x86-64 demands of C, too, carry the exception through libpng, which is
// done with the file then.
[[noreturn]] void fail(png_structp png, png_const_charp problem) {
  const auto* context = static_cast<const Context*>(png_get_error_ptr(png));
  throw InputError(fmt::format("{}: {}{}{}", context->failed, context->last_warning,
                               context->last_warning.empty() ? "" : "; ", problem));
}

// An error is often explained by the warning before it. Nothing is printed.
void note_warning(png_structp png, png_const_charp warning) {
  static_cast<Context*>(png_get_error_ptr(png))->last_warning = warning;
}

void read_bytes(png_structp png, png_bytep to, std::size_t count) {
  auto& left = context_of(png).left;
  if (count > left.size()) png_error(png, "the file ends too early");
  std::memcpy(to, left.data(), count);
  left.remove_prefix(count);
}

void write_bytes(png_structp png, png_bytep from, std::size_t count) {
  context_of(png).written->append(reinterpret_cast<const char*>(from), count);
}

void flush_nothing(png_structp) {}

std::uint32_t word_at(std::string_view bytes, std::size_t at) {
  std::uint32_t word = 0;
  for (const char byte : bytes.substr(at, 4)) word = word << 8 | static_cast<unsigned char>(byte);
  return word;
}

// libpng asks for as much memory as a chunk claims to have, up to 2 GiB, before it finds that the file ends.
// PNG specification (ISO/IEC 15948), section 5: a signature, then chunks of length, type, data and checksum.
void check_lengths(std::string_view bytes) {
  constexpr std::string_view kSignature{"\x89PNG\r\n\x1a\n", 8};
  constexpr std::size_t kFrame = 12;
  if (!bytes.starts_with(kSignature)) throw InputError("does not start as a PNG does");
  for (std::size_t at = kSignature.size(); at < bytes.size();) {
    const std::size_t length = word_at(bytes, at);
    if (bytes.size() - at < kFrame || bytes.size() - at - kFrame < length)
      throw InputError("the file ends inside a PNG chunk");
    if (bytes.substr(at + 4, 4) == "IEND") return;
    at += kFrame + length;
  }
  throw InputError("the PNG has no end");
}

struct Reader {
  explicit Reader(std::string_view bytes) : context{"is no readable .png image", bytes} {
    png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &context, fail, note_warning);
    info = png == nullptr ? nullptr : png_create_info_struct(png);
    if (info == nullptr) throw std::bad_alloc();
    png_set_read_fn(png, &context, read_bytes);
    // By itself it would go on behind a chunk of text whose checksum is wrong.
    png_set_crc_action(png, PNG_CRC_ERROR_QUIT, PNG_CRC_ERROR_QUIT);
  }
  ~Reader() { png_destroy_read_struct(&png, &info, nullptr); }
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;

  Context context;
  png_structp png = nullptr;
  png_infop info = nullptr;
};

struct Writer {
  explicit Writer(std::string& to) : context{"cannot be encoded as png", {}, &to} {
    png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &context, fail, note_warning);
    info = png == nullptr ? nullptr : png_create_info_struct(png);
    if (info == nullptr) throw std::bad_alloc();
    png_set_write_fn(png, &context, write_bytes, flush_nothing);
  }
  ~Writer() { png_destroy_write_struct(&png, &info); }
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;

  Context context;
  png_structp png = nullptr;
  png_infop info = nullptr;
};

std::map<std::string, std::string> texts_of(const Reader& reader) {
  std::map<std::string, std::string> attributes;
  png_textp texts = nullptr;
  const int count = png_get_text(reader.png, reader.info, &texts, nullptr);
  for (int i = 0; i < count; ++i)
    if (texts[i].text != nullptr && *texts[i].text != '\0') attributes[texts[i].key] = texts[i].text;
  return attributes;
}

// Reads what stands before the pixels. Afterwards libpng gives each pixel 8 or 16 bits a channel.
Image read_header(const Reader& reader) {
  const auto& [context, png, info] = reader;
  const std::size_t file_bytes = context.left.size();
  png_read_info(png, info);
  png_set_expand(png);  // fewer bits to 8, palettes to colours, a transparent colour to alpha
  png_set_swap(png);    // files have the high byte first
  png_set_interlace_handling(png);
  png_read_update_info(png, info);
  const int channels = png_get_channels(png, info);
  const auto width = static_cast<int>(png_get_image_width(png, info));  // libpng allows a million
  const auto height = static_cast<int>(png_get_image_height(png, info));
  const Window stored{static_cast<int>(png_get_x_offset_pixels(png, info)),
                      static_cast<int>(png_get_y_offset_pixels(png, info)), width, height};
  check_size({stored, {0, 0, width, height}, channels}, file_bytes);
  std::vector<std::string> names =
      channels < 3 ? std::vector<std::string>{"Y", "A"} : std::vector<std::string>{"R", "G", "B", "A"};
  names.resize(static_cast<std::size_t>(channels));
  return {width, height, names, {}, texts_of(reader)};
}

void read_pixels(const Reader& reader, Image& image) {
  const auto& [context, png, info] = reader;
  const std::size_t row_bytes = png_get_rowbytes(png, info);
  std::vector<png_byte> bytes(row_bytes * static_cast<std::size_t>(image.height));
  std::vector<png_bytep> rows;
  for (std::size_t at = 0; at < bytes.size(); at += row_bytes) rows.push_back(&bytes[at]);
  png_read_image(png, rows.data());
  png_read_end(png, nullptr);
  const std::size_t count = image.pixel_count() * image.channel_count();
  image.pixels.reserve(count);
  if (png_get_bit_depth(png, info) == 8) {
    for (const png_byte value : bytes) image.pixels.push_back(static_cast<float>(value) * (1.0F / 255.0F));
    return;
  }
  for (std::size_t i = 0; i < count; ++i) {
    std::uint16_t value = 0;
    std::memcpy(&value, &bytes[2 * i], sizeof value);
    image.pixels.push_back(static_cast<float>(value) * (1.0F / 65535.0F));
  }
}

}  // namespace

Image decoded_png(std::string_view bytes, Wanted wanted) {
  check_lengths(bytes);
  const Reader reader(bytes);
  Image image = read_header(reader);
  if (wanted == Wanted::Pixels) read_pixels(reader, image);
  return image;
}

std::string encoded_png(const Image& image) {
  const std::size_t kept = image.channel_count() >= 3 ? 3 : 1;
  std::string bytes;
  const Writer writer(bytes);
  const auto& [context, png, info] = writer;
  png_set_IHDR(png, info, static_cast<png_uint_32>(image.width), static_cast<png_uint_32>(image.height), 8,
               kept == 1 ? PNG_COLOR_TYPE_GRAY : PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_set_sRGB(png, info, PNG_sRGB_INTENT_ABSOLUTE);
  png_write_info(png, info);
  std::vector<png_byte> row;
  for (int y = 0; y < image.height; ++y) {
    row.clear();
    for (int x = 0; x < image.width; ++x)
      for (std::size_t c = 0; c < kept; ++c) {
        const float value = image.at(x, y, c);
        if (std::isnan(value)) throw InputError("a PNG cannot show NaN; mark such pixels before writing");
        row.push_back(static_cast<png_byte>(std::lround(std::clamp(value, 0.0F, 1.0F) * 255.0F)));
      }
    png_write_row(png, row.data());
  }
  png_write_end(png, info);
  return bytes;
}

}  // namespace orbs::image
