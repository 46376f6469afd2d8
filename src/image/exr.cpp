#include "image/exr.h"

#include "base/error.h"
#include "image/exr_check.h"
#include "image/rec709.h"
#include "image/reduced_precision.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstring>
#include <exception>
#include <tuple>

#include <OpenEXR/Iex.h>
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfChromaticities.h>
#include <OpenEXR/ImfEnvmap.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfInputPart.h>
#include <OpenEXR/ImfMultiPartInputFile.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfPartType.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <OpenEXR/ImfTiledInputPart.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace orbs::image {

namespace {

constexpr int kNoThreads = 0;  // blocks are decoded by who asks for them

class MemoryReader : public Imf::IStream {
 public:
  MemoryReader(const std::string& name, std::string_view bytes) : Imf::IStream(name.c_str()), bytes_(bytes) {}

  bool read(char* to, int count) override {
    const auto wanted = static_cast<std::uint64_t>(count);
    if (count < 0 || at_ > bytes_.size() || wanted > bytes_.size() - at_)
      throw Iex::InputExc("the file ends too early");  // the library catches no others
    std::memcpy(to, bytes_.data() + at_, wanted);
    at_ += wanted;
    return at_ < bytes_.size();
  }
  std::uint64_t tellg() override { return at_; }
  void seekg(std::uint64_t at) override { at_ = at; }

 private:
  std::string_view bytes_;
  std::uint64_t at_ = 0;
};

class MemoryWriter : public Imf::OStream {
 public:
  MemoryWriter() : Imf::OStream("image.exr") {}

  void write(const char* from, int count) override {
    const auto end = at_ + static_cast<std::uint64_t>(count);
    if (bytes.size() < end) bytes.resize(end);
    std::memcpy(&bytes[at_], from, static_cast<std::size_t>(count));
    at_ = end;
  }
  std::uint64_t tellp() override { return at_; }
  void seekp(std::uint64_t at) override { at_ = at; }

  std::string bytes;

 private:
  std::uint64_t at_ = 0;
};

// OpenEXR keeps channels in the order of their names.
struct ChannelName {
  std::string layer;  // with its dot
  std::string suffix;
};

ChannelName split_name(const std::string& name) {
  const auto suffix = name.rfind('.') + 1;  // 0 without a dot
  return {name.substr(0, suffix), name.substr(suffix)};
}

// Within a layer, the names that people know come in the order that people expect: colour, then depth. A
// layer of positions has its "Y" behind "X" and before "Z".
std::size_t rank_of(const std::string& suffix, bool is_position) {
  constexpr std::array kColours{"r",     "red", "g",  "green", "b",  "blue", "y",  "real", "imag",  "a",
                                "alpha", "ar",  "ra", "ag",    "ga", "ab",   "ba", "z",    "depth", "zback"};
  constexpr std::array kPositions{"r",  "red", "g",    "green", "b",  "blue",  "x",
                                  "y",  "z",   "real", "imag",  "a",  "alpha", "ar",
                                  "ra", "ag",  "ga",   "ab",    "ba", "depth", "zback"};
  const auto rank_in = [&](const auto& names) {
    return static_cast<std::size_t>(std::find(names.begin(), names.end(), suffix) - names.begin());
  };
  return is_position ? rank_in(kPositions) : rank_in(kColours);
}

std::string lower_case(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

std::vector<std::string> sorted_channels(const Imf::ChannelList& list) {
  std::map<std::string, std::set<std::string>> suffixes;  // of a layer, in lower case
  std::vector<std::string> names;
  for (auto channel = list.begin(); channel != list.end(); ++channel) {
    names.emplace_back(channel.name());
    const auto [layer, suffix] = split_name(names.back());
    suffixes[layer].insert(lower_case(suffix));
  }
  const auto place = [&](const std::string& name) {
    const auto [layer, suffix] = split_name(name);
    const auto& beside = suffixes.at(layer);
    const bool is_position = beside.contains("x") && (beside.contains("y") || beside.contains("z"));
    return std::tuple(layer, rank_of(lower_case(suffix), is_position), suffix);
  };
  std::sort(names.begin(), names.end(),
            [&](const auto& one, const auto& other) { return place(one) < place(other); });
  return names;
}

// Of a layer, too: "variance.G". The first channel is what a grey image is made of, whatever its name.
bool is_colour(const std::vector<std::string>& channels, const std::string& name) {
  constexpr std::array kColours{"R", "G", "B", "A", "Y"};
  return name == channels.front() ||
         std::find(kColours.begin(), kColours.end(), split_name(name).suffix) != kColours.end();
}

// No number of a file of integers is meant as light; a channel of labels beside the colours is read by
// nobody.
void check_channels(const Imf::ChannelList& list, const std::vector<std::string>& names) {
  for (const auto& name : names) {
    const auto& channel = list[name.c_str()];
    if (channel.xSampling != 1 || channel.ySampling != 1)
      throw InputError(fmt::format("the EXR channel '{}' does not have all pixels", name));
    if (channel.type == Imf::UINT && is_colour(names, name))
      throw InputError(fmt::format("the EXR channel '{}' holds integers, expected half or float", name));
  }
}

void check_chromaticities(const Imf::Header& header) {
  if (!Imf::hasChromaticities(header)) return;
  const auto c = Imf::chromaticities(header);
  check_rec709("chromaticities",
               {c.red.x, c.red.y, c.green.x, c.green.y, c.blue.x, c.blue.y, c.white.x, c.white.y});
}

// Six faces below each other are no picture that texture coordinates or pixels could mean.
void check_environment(const Imf::Header& header) {
  if (Imf::hasEnvmap(header) && Imf::envmap(header) == Imf::ENVMAP_CUBE)
    throw InputError(
        "is a cube map by its attribute envmap; expected a flat image, such as one of its faces");
}

Window window_of(const Imath::Box2i& box) {
  return {box.min.x, box.min.y, box.max.x - box.min.x + 1, box.max.y - box.min.y + 1};
}

std::map<std::string, std::string> text_attributes(const Imf::Header& header) {
  std::map<std::string, std::string> attributes;
  for (auto attribute = header.begin(); attribute != header.end(); ++attribute) {
    const auto* text = dynamic_cast<const Imf::StringAttribute*>(&attribute.attribute());
    if (text == nullptr || std::string_view(attribute.name()) == "type") continue;  // of the part
    if (const std::string value = text->value().c_str(); !value.empty()) attributes[attribute.name()] = value;
  }
  return attributes;
}

void read_pixels(Imf::MultiPartInputFile& file, Image& image) {
  const auto& header = file.header(0);
  const auto& box = header.dataWindow();
  Imf::FrameBuffer places;
  const std::size_t pixel_bytes = sizeof(float) * image.channel_count();
  for (std::size_t c = 0; c < image.channel_count(); ++c)
    places.insert(image.channels[c], Imf::Slice::Make(Imf::FLOAT, &image.pixels[c], box, pixel_bytes,
                                                      pixel_bytes * static_cast<std::size_t>(image.width)));
  if (!Imf::isTiled(header.type())) {
    Imf::InputPart part(file, 0);
    part.setFrameBuffer(places);
    return part.readPixels(box.min.y, box.max.y);
  }
  Imf::TiledInputPart part(file, 0);
  part.setFrameBuffer(places);
  part.readTiles(0, part.numXTiles() - 1, 0, part.numYTiles() - 1);
}

// The library's own words for what is wrong begin with `doing`.
template <typename F>
auto said(const char* doing, F&& work) {
  try {
    return work();
  } catch (const std::exception& e) {
    const std::string_view problem = e.what();
    throw InputError(fmt::format("{}: {}", doing, problem.substr(0, problem.find('\n'))));
  }
}

}  // namespace

Image decoded_exr(const std::string& name, std::string_view bytes, Wanted wanted) {
  check_exr(bytes);
  MemoryReader stream(name, bytes);
  const auto file = said("is no readable .exr image",
                         [&] { return std::make_unique<Imf::MultiPartInputFile>(stream, kNoThreads); });
  const auto& header = file->header(0);
  const auto channels = sorted_channels(header.channels());
  check_channels(header.channels(), channels);
  check_chromaticities(header);
  check_environment(header);
  if (header.pixelAspectRatio() != 1)
    throw InputError(
        fmt::format("its pixelAspectRatio is {}, expected square pixels (1)", header.pixelAspectRatio()));
  const Window stored = window_of(header.dataWindow());
  check_size({stored, window_of(header.displayWindow()), static_cast<int>(channels.size())}, bytes.size());
  Image image{stored.width, stored.height, channels, {}, text_attributes(header)};
  if (wanted == Wanted::Header) return image;
  image.pixels.resize(image.pixel_count() * image.channel_count());
  said("the pixels cannot be read", [&] { read_pixels(*file, image); });
  return image;
}

std::string encoded_exr(const Image& image, Precision precision, Compression compression) {
  Imf::Header header(image.width, image.height);
  header.compression() = compression == Compression::Zip ? Imf::ZIP_COMPRESSION : Imf::NO_COMPRESSION;
  // Halves are for what is kept and published: the strongest deflate takes 8 % off the size of noise.
  if (precision == Precision::Half) header.zipCompressionLevel() = 9;
  for (const auto& [name, text] : image.attributes) header.insert(name, Imf::StringAttribute(text));
  const auto width = static_cast<std::size_t>(image.width);
  const std::size_t count = image.channel_count();
  std::vector<std::vector<std::uint16_t>> halves(count);
  Imf::FrameBuffer places;
  for (std::size_t c = 0; c < count; ++c) {
    const auto& name = image.channels[c];
    const float* floats = &image.pixels[c];
    const bool is_half = precision == Precision::Half && !stays_float(name);
    header.channels().insert(name, Imf::Channel(is_half ? Imf::HALF : Imf::FLOAT));
    if (is_half) {
      for (std::size_t i = 0; i < image.pixel_count(); ++i) halves[c].push_back(half_bits(floats[i * count]));
      places.insert(name, Imf::Slice::Make(Imf::HALF, halves[c].data(), header.dataWindow()));
    } else {
      places.insert(name, Imf::Slice::Make(Imf::FLOAT, floats, header.dataWindow(), sizeof(float) * count,
                                           sizeof(float) * count * width));
    }
  }
  MemoryWriter stream;
  said("cannot be encoded as exr", [&] {
    Imf::OutputFile file(stream, header, kNoThreads);  // its end writes the places of the blocks
    file.setFrameBuffer(places);
    file.writePixels(image.height);
  });
  return std::move(stream.bytes);
}

}  // namespace orbs::image
