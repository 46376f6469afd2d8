#include "image/other_formats.h"

#include "base/error.h"
#include "base/files.h"
#include "image/format_module.h"

#include <dlfcn.h>
#include <fmt/format.h>

namespace orbs::image {

namespace {

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

}  // namespace

Contents read_other_format(const std::filesystem::path& file, const std::string& format, Wanted wanted) {
  static const ReadImage read = loaded_module(format);
  Reading reading{std::filesystem::file_size(file), wanted};
  const auto receiver = receiver_of(reading);
  read(file.c_str(), format.c_str(), &receiver);
  if (!reading.refusal.empty()) throw InputError(reading.refusal);
  return std::move(reading.contents);
}

}  // namespace orbs::image
