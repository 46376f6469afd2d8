#include "image/exr_check.h"

#include "base/error.h"
#include "image/contents.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>

#include <fmt/format.h>

namespace orbs::image {

namespace {

// "OpenEXR File Layout", https://openexr.com/en/latest/OpenEXRFileLayout.html
constexpr std::string_view kMagic{"\x76\x2f\x31\x01", 4};
constexpr std::uint32_t kVersion = 2;
constexpr std::uint32_t kTiled = 0x200;
constexpr std::uint32_t kLongNames = 0x400;
constexpr std::uint32_t kDeep = 0x800;
constexpr std::uint32_t kMultipart = 0x1000;
constexpr std::size_t kLongestName = 255;

// What the library keeps of the headers of a file, several times over. The largest that are meant are
// manifests of a few megabytes and previews.
constexpr std::size_t kMostHeaderBytes = std::size_t{16} << 20;
constexpr std::size_t kMostAttributes = 10000;
constexpr std::size_t kMostInList = 4096;  // channels, or texts of one attribute

// Bytes of an attribute's value by its type. The library reads as many for every size that the file states,
// and then goes on at another place than we.
std::optional<std::size_t> size_of_type(std::string_view type) {
  const auto is_one_of = [&](std::initializer_list<std::string_view> names) {
    return std::find(names.begin(), names.end(), type) != names.end();
  };
  if (is_one_of({"compression", "deepImageState", "envmap", "lineOrder"})) return 1;
  if (is_one_of({"int", "float"})) return 4;
  if (is_one_of({"double", "rational", "timecode", "v2i", "v2f"})) return 8;
  if (type == "tiledesc") return 9;
  if (is_one_of({"v3i", "v3f"})) return 12;
  if (is_one_of({"box2i", "box2f", "v2d"})) return 16;
  if (type == "v3d") return 24;
  if (type == "keycode") return 28;
  if (type == "chromaticities") return 32;
  if (type == "m33f") return 36;
  if (type == "m44f") return 64;
  if (type == "m33d") return 72;
  if (type == "m44d") return 128;
  return std::nullopt;
}

// Lines that are compressed together, by the number of the compression: none, RLE, ZIPS, ZIP, PIZ, PXR24,
// B44, B44A, DWAA, DWAB.
constexpr std::array<int, 10> kLinesOfBlock{1, 1, 1, 16, 32, 16, 32, 32, 32, 256};

class Reader {
 public:
  explicit Reader(std::string_view bytes) : bytes_(bytes) {}

  std::size_t left() const { return bytes_.size(); }
  bool skip_zero() {
    if (bytes_.empty() || bytes_.front() != '\0') return false;
    bytes_.remove_prefix(1);
    return true;
  }
  std::string_view take(std::size_t length) {
    if (length > bytes_.size()) throw InputError("the file ends inside its EXR header");
    const auto taken = bytes_.substr(0, length);
    bytes_.remove_prefix(length);
    return taken;
  }
  // Four bytes, the least significant first.
  std::uint32_t word() {
    const auto four = take(4);
    std::uint32_t value = 0;
    for (std::size_t i = 4; i-- > 0;) value = value << 8 | static_cast<unsigned char>(four[i]);
    return value;
  }
  std::int32_t number() { return static_cast<std::int32_t>(word()); }
  std::string_view name() {
    const auto text = bytes_.substr(0, bytes_.find('\0'));
    if (text.empty() || text.size() > kLongestName || text.size() == bytes_.size())
      throw InputError("a name in the EXR header is empty or does not end");
    take(text.size() + 1);
    return text;
  }

 private:
  std::string_view bytes_;
};

struct Lengths {
  double width = 0;  // a double holds the product of two int32 lengths well enough to compare it
  double height = 0;
};

struct Part {
  std::optional<Lengths> data;
  std::optional<Lengths> tile;
  std::size_t compression = 0;
  double channels = 0;
  double chunks = 0;  // stated
};

Lengths lengths_of(std::string_view value) {
  Reader in(value);
  std::array<double, 4> box{};
  for (double& bound : box) bound = in.number();
  return {box[2] - box[0] + 1, box[3] - box[1] + 1};
}

void check_count(std::size_t count, const char* what) {
  if (count > kMostInList)
    throw InputError(
        fmt::format("the EXR header has more than {} {}; write it with fewer", kMostInList, what));
}

double channels_of(std::string_view value) {
  Reader in(value);
  std::size_t count = 0;
  for (; !in.skip_zero(); ++count) {
    constexpr std::size_t kBytesOfChannel = 16;  // type, a flag, and the sampling
    in.name();
    in.take(kBytesOfChannel);
    check_count(count + 1, "channels");
  }
  if (in.left() != 0 || count == 0) throw InputError("the list of EXR channels does not hold together");
  return static_cast<double>(count);
}

void check_string_vector(std::string_view value) {
  std::size_t count = 0;
  for (Reader in(value); in.left() > 0; check_count(++count, "texts in one attribute")) in.take(in.word());
}

void check_preview(std::string_view value) {
  Reader in(value);
  const double pixels = static_cast<double>(in.word()) * in.word();
  if (pixels * 4 != static_cast<double>(in.left()))
    throw InputError("the EXR preview is not as large as it says");
}

void check_attribute(std::string_view name, std::string_view type, std::string_view value) {
  if (const auto size = size_of_type(type); size && *size != value.size())
    throw InputError(fmt::format("the EXR attribute '{}' of type {} has {} bytes, expected {}", name, type,
                                 value.size(), *size));
  // Lists are read by their contents, wherever they stand.
  if (type == "chlist") channels_of(value);
  if (type == "floatvector" && value.size() % 4 != 0)
    throw InputError(fmt::format("the EXR attribute '{}' ends inside a number", name));
  if (type == "stringvector") check_string_vector(value);
  if (type == "preview") check_preview(value);
  // Compressed by its own length. Images that we compare need none.
  if (type == "idmanifest") throw InputError("the EXR file has an id manifest, which is not read");
}

void note_attribute(Part& part, std::string_view name, std::string_view type, std::string_view value) {
  const auto is = [&](std::string_view wanted_name, std::string_view wanted_type) {
    if (name == wanted_name && type != wanted_type)
      throw InputError(
          fmt::format("the EXR attribute '{}' is of type {}, expected {}", name, type, wanted_type));
    return name == wanted_name;
  };
  if (is("dataWindow", "box2i")) part.data = lengths_of(value);
  is("displayWindow", "box2i");
  if (is("channels", "chlist")) part.channels = channels_of(value);
  if (is("compression", "compression")) part.compression = static_cast<unsigned char>(value[0]);
  if (is("chunkCount", "int")) part.chunks = Reader(value).number();
  if (is("tiles", "tiledesc")) {
    Reader in(value);
    const double width = in.word();
    part.tile = Lengths{width, static_cast<double>(in.word())};
  }
  if (is("type", "string") && value.starts_with("deep"))
    throw InputError("holds deep pixels, expected a flat image");
}

// Of all parts: what a reader may still take of their headers.
struct HeaderLimit {
  std::size_t attributes = kMostAttributes;
  std::size_t end;  // bytes of the file that are left where the headers must have ended
};

void check_limit(HeaderLimit& limit, const Reader& in) {
  if (limit.attributes-- == 0 || in.left() < limit.end)
    throw InputError(
        fmt::format("its EXR header has more than {} MiB or {} attributes, which no image needs; "
                    "write it without what is not about the image",
                    kMostHeaderBytes >> 20U, kMostAttributes));
}

Part read_part(Reader& in, HeaderLimit& limit) {
  Part part;
  while (!in.skip_zero()) {
    const auto name = in.name();
    const auto type = in.name();
    const auto value = in.take(in.word());
    check_limit(limit, in);
    check_attribute(name, type, value);
    note_attribute(part, name, type, value);
  }
  if (!part.data || part.channels == 0) throw InputError("the EXR header lacks the size or the channels");
  if (part.compression >= kLinesOfBlock.size())
    throw InputError(fmt::format("the EXR compression {} is not known", part.compression));
  return part;
}

// Blocks of pixels that are read as a whole. The file holds a place of eight bytes for each.
double blocks_of(const Part& part, Lengths block) {
  const double blocks =
      std::ceil(part.data->width / block.width) * std::ceil(part.data->height / block.height);
  return std::max(blocks, part.chunks);
}

void check_memory(const Part& part, std::size_t file_bytes, double& places_left) {
  const auto [width, height] = *part.data;
  const auto block = part.tile.value_or(Lengths{width, static_cast<double>(kLinesOfBlock[part.compression])});
  if (width < 1 || height < 1 || block.width < 1 || block.height < 1)
    throw InputError(fmt::format("the EXR header says {} x {} px in blocks of {} x {}", width, height,
                                 block.width, block.height));
  const double most = kMostValuesPerByte * static_cast<double>(file_bytes);
  if (width * height * part.channels > most || block.width * block.height * part.channels > most)
    throw InputError(
        fmt::format("the EXR header says {} x {} px with {} channels, which is more than {} bytes can hold",
                    width, height, part.channels, file_bytes));
  places_left -= blocks_of(part, block);
  if (places_left < 0) throw InputError("the file is too short for the blocks that the EXR header speaks of");
}

}  // namespace

void check_exr(std::string_view bytes) {
  if (!bytes.starts_with(kMagic)) throw InputError("is no readable .exr image: it does not start as one");
  Reader in(bytes.substr(kMagic.size()));
  const auto version = in.word();
  if ((version & 0xffU) != kVersion || (version & ~(0xffU | kTiled | kLongNames | kDeep | kMultipart)) != 0)
    throw InputError(fmt::format("is an EXR file of an unknown version, {:#x}", version));
  if ((version & kDeep) != 0) throw InputError("holds deep pixels, expected a flat image");
  double places_left = static_cast<double>(bytes.size()) / 8;
  HeaderLimit limit{.end = bytes.size() - std::min(bytes.size(), kMostHeaderBytes)};
  do {
    const Part part = read_part(in, limit);
    if (part.tile.has_value() != ((version & kTiled) != 0) && (version & kMultipart) == 0)
      throw InputError("the EXR header does not agree with itself on whether there are tiles");
    check_memory(part, bytes.size(), places_left);
  } while ((version & kMultipart) != 0 && !in.skip_zero());
}

}  // namespace orbs::image
