#include "importer/source.h"

#include "base/files.h"
#include "base/files_inside.h"
#include "importer/property_types.h"
#include "json/document.h"
#include "json/object_reader.h"

#include <cstdint>
#include <cstring>
#include <limits>
#include <set>
#include <stdexcept>
#include <string_view>
#include <type_traits>
#include <utility>

namespace orbs::importer {

namespace {

constexpr std::string_view kMagic = "glTF";
constexpr std::size_t kHeader = 12;      // magic, version, length
constexpr std::size_t kChunkHeader = 8;  // length, type

std::uint32_t number_at(std::string_view bytes, std::size_t offset) {
  std::uint32_t number = 0;
  std::memcpy(&number, bytes.data() + offset, sizeof number);
  return number;
}

struct Parts {
  std::string json;
  std::optional<std::size_t> binary_length;  // of the second chunk of a .glb
};

[[noreturn]] void torn(const std::filesystem::path& file, const std::string& problem) {
  throw InputError(
      fmt::format("{}: is a torn .glb file: {}; copy or export it again", file.string(), problem));
}

Parts parts_of(const std::filesystem::path& file, const std::string& bytes) {
  if (!bytes.starts_with(kMagic)) return {bytes, std::nullopt};
  if (bytes.size() < kHeader + kChunkHeader)
    torn(file, fmt::format("it ends after {} bytes, within its header", bytes.size()));
  if (const auto version = number_at(bytes, 4); version != 2)
    throw InputError(fmt::format("{}: has version {} of glTF; 2 is read", file.string(), version));
  if (const auto length = number_at(bytes, 8); length > bytes.size())
    torn(file, fmt::format("its header says {} bytes, and it has {}", length, bytes.size()));
  const std::size_t json_length = number_at(bytes, kHeader);
  if (bytes.substr(kHeader + 4, 4) != "JSON") torn(file, "its first chunk is no JSON");
  const std::size_t json_end = kHeader + kChunkHeader + json_length;
  if (json_end > bytes.size())
    torn(file, fmt::format("its JSON of {} bytes goes beyond its end", json_length));
  Parts parts{bytes.substr(kHeader + kChunkHeader, json_length), std::nullopt};
  if (json_end + kChunkHeader > bytes.size()) return parts;
  parts.binary_length = number_at(bytes, json_end);
  if (json_end + kChunkHeader + *parts.binary_length > bytes.size())
    torn(file, fmt::format("its buffer of {} bytes goes beyond its end", *parts.binary_length));
  return parts;
}

// Extensions that pack meshes, of which the file holds no numbers then.
const std::set<std::string>& packing_extensions() {
  static const std::set<std::string> names{"KHR_draco_mesh_compression", "EXT_meshopt_compression",
                                           "KHR_meshopt_compression", "MESHOPT_compression"};
  return names;
}

// A buffer of unpacked meshes that the file may name without having it (EXT_meshopt_compression, "Fallback
// buffers").
void check_fallback(json::ObjectReader& buffer) {
  if (!buffer.has("extensions")) return;
  for (const auto& name : buffer.object("extensions").keys())
    if (packing_extensions().contains(name)) buffer.fail("", "stands for meshes that " + packed_text(name));
}

// The library takes the following on trust, and an image from where no buffer is.
void check_buffers(const json::Document& document, const Parts& parts) {
  constexpr int kMost = std::numeric_limits<int>::max();
  json::ObjectReader in(document);
  std::vector<int> lengths;
  for (auto& buffer : in.objects_or_none("buffers")) {
    lengths.push_back(buffer.integer("byteLength", 1, kMost));
    const bool is_chunk = lengths.size() == 1 && !buffer.has("uri");
    if (!buffer.has("uri") && (!is_chunk || !parts.binary_length)) check_fallback(buffer);
    if (is_chunk && !parts.binary_length) buffer.fail("", "has no 'uri', and the file has no second chunk");
    if (is_chunk && *parts.binary_length < static_cast<std::size_t>(lengths.back()))
      buffer.fail("byteLength", fmt::format("is more than the {} bytes that the second chunk of the file has",
                                            *parts.binary_length));
    if (!is_chunk && !buffer.has("uri")) buffer.fail("", "has no 'uri': only the first buffer of a .glb may");
  }
  std::size_t views = 0;
  for (auto& view : in.objects_or_none("bufferViews")) {
    ++views;
    const int buffer = view.integer("buffer", 0, kMost);
    if (static_cast<std::size_t>(buffer) >= lengths.size())
      view.fail("buffer", fmt::format("{} is none: there are {}, counted from 0", buffer, lengths.size()));
    const std::int64_t end =
        std::int64_t{view.integer_or("byteOffset", 0, 0, kMost)} + view.integer("byteLength", 1, kMost);
    if (end > lengths[static_cast<std::size_t>(buffer)])
      view.fail("byteLength", fmt::format("ends at byte {} of a buffer of {}", end,
                                          lengths[static_cast<std::size_t>(buffer)]));
  }
  for (auto& image : in.objects_or_none("images")) {
    if (!image.has("bufferView")) continue;
    const int view = image.integer("bufferView", 0, kMost);
    if (static_cast<std::size_t>(view) >= views)
      image.fail("bufferView", fmt::format("{} is none: there are {}, counted from 0", view, views));
  }
}

// What the JSON of a file asks of its reader. Without these its meshes are no numbers that could be read.
void check_asked(const json::Document& document) {
  json::ObjectReader in(document);
  auto asset = in.object("asset");
  if (const auto version = asset.text("version"); !version.starts_with("2."))
    asset.fail("version", fmt::format("is '{}'; 2.0 is read", version));
  if (!in.has("extensionsRequired")) return;
  for (const auto& name : in.texts("extensionsRequired"))
    if (packing_extensions().contains(name)) in.fail("extensionsRequired", "its meshes " + packed_text(name));
}

int digit_of(char letter) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  const auto at = kDigits.find(static_cast<char>(std::tolower(static_cast<unsigned char>(letter))));
  return at == std::string_view::npos ? -1 : static_cast<int>(at);
}

// The file at `path`, which must lie beside `file` or below, with no link on the way.
OpenFile opened_beside(const std::filesystem::path& file, const std::string& path, const std::string& what) {
  const auto bad = [&](const std::string& problem) {
    throw InputError(fmt::format("{}: {} is '{}': {}", file.string(), what, path, problem));
  };
  if (const auto colon = path.find(':'); colon != std::string::npos && path.find('/') > colon)
    bad("only files beside the scene are read, nothing is fetched; download it, and name it there");
  if (path.empty() || !leads_inside(path))
    bad("that leads out of the folder of the scene; copy the file into it, and name it there");
  const auto folder = std::filesystem::absolute(file).parent_path();
  auto opened = open_inside(folder, path);
  if (!opened)
    bad(fmt::format("there is no such file in {} (symbolic links are not followed); copy it there",
                    folder.string()));
  return std::move(*opened);
}

// What the library's functions for files know. They are called for buffers alone, with the path that the URI
// means.
struct Files {
  const std::filesystem::path& file;
  std::string problem;
};

// Hands the file at `path` to `use`; false if it may not be read.
template <typename Use>
bool open_for_library(const std::string& path, std::string* error, void* user_data, Use use) {
  auto& files = *static_cast<Files*>(user_data);
  try {
    use(opened_beside(files.file, path, "a buffer"));
    return true;
  } catch (const InputError& e) {
    files.problem = e.what();
    if (error != nullptr) *error = e.what();
    return false;
  }
}

// The library calls these for every file that it looks for, reads or writes. Set by name, since from 2.8.8 on
// there is a sixth.
template <typename Callbacks>
Callbacks callbacks_of(Files& files) {
  Callbacks callbacks{};
  callbacks.FileExists = [](const std::string&, void*) { return true; };
  callbacks.ExpandFilePath = [](const std::string& path, void*) { return path; };
  callbacks.ReadWholeFile = [](std::vector<unsigned char>* out, std::string* error, const std::string& path,
                               void* user_data) {
    return open_for_library(path, error, user_data, [&](const OpenFile& file) {
      const auto bytes = file.read(0, file.size());
      out->assign(bytes.begin(), bytes.end());
    });
  };
  callbacks.WriteWholeFile = [](std::string*, const std::string&, const std::vector<unsigned char>&, void*) {
    return false;
  };
  if constexpr (requires { callbacks.GetFileSizeInBytes; })
    callbacks.GetFileSizeInBytes = [](std::size_t* size, std::string* error, const std::string& path,
                                      void* user_data) {
      return open_for_library(path, error, user_data, [&](const OpenFile& file) { *size = file.size(); });
    };
  callbacks.user_data = &files;
  return callbacks;
}

// From 2.9 on the library says whether it took the callbacks. If not it would keep its own, which open any
// path of the disk.
template <typename Reader>
void open_files_by(Reader& reader, const tinygltf::FsCallbacks& callbacks) {
  if constexpr (std::is_void_v<decltype(reader.SetFsCallbacks(callbacks))>)
    reader.SetFsCallbacks(callbacks);
  else if (!reader.SetFsCallbacks(callbacks))
    throw std::logic_error(
        "tinygltf did not take our functions for files; expected: one for each that its FsCallbacks has. "
        "src/importer/source.cpp sets those of the versions 2.7 to 2.9");
}

// NOLINTNEXTLINE(readability-function-size): the parameters are those of the library's callback.
bool keep_encoded(tinygltf::Image* image,
                  int,
                  std::string*,
                  std::string*,
                  int,
                  int,
                  const unsigned char* bytes,
                  int size,
                  void*) {
  image->image.assign(bytes, bytes + size);
  image->as_is = true;
  return true;
}

}  // namespace

void refuse(const Source& source, const std::string& problem) {
  throw InputError(fmt::format("{}: {}", source.file.string(), problem));
}

std::string packed_text(const std::string& extension) {
  return fmt::format(
      "are packed with {}, which is not read; export the scene without compression, or unpack it "
      "with 'npx @gltf-transform/cli copy PACKED.glb PLAIN.glb'",
      extension);
}

std::string place(const char* kind, const std::string& name, std::size_t index) {
  return name.empty() ? fmt::format("{} {}", kind, index) : fmt::format("{} '{}'", kind, name);
}

std::string decoded_uri(std::string_view uri) {
  std::string path;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    if (uri[i] == '%' && i + 2 < uri.size() && digit_of(uri[i + 1]) >= 0 && digit_of(uri[i + 2]) >= 0) {
      path += static_cast<char>(16 * digit_of(uri[i + 1]) + digit_of(uri[i + 2]));
      i += 2;
    } else {
      path += uri[i];
    }
  }
  return path;
}

std::string read_beside(const std::filesystem::path& file, const std::string& path, const std::string& what) {
  const auto opened = opened_beside(file, path, what);
  return opened.read(0, opened.size());
}

Source read_source(const std::filesystem::path& file) {
  if (const auto problem = no_file_problem(file); !problem.empty())
    throw InputError(fmt::format("{}: {}", file.string(), problem));
  const auto bytes = read_file(file);
  if (bytes.size() > std::numeric_limits<std::uint32_t>::max())
    throw InputError(
        fmt::format("{}: has {} bytes; glTF files of at most 4 GiB are read", file.string(), bytes.size()));
  const auto parts = parts_of(file, bytes);
  const auto document = json::parse(file.string(), parts.json);
  check_asked(document);
  check_property_types(document);
  check_buffers(document, parts);
  Source source{file, {}};
  Files files{file, {}};
  tinygltf::TinyGLTF reader;
  reader.SetImageLoader(keep_encoded, nullptr);
  open_files_by(reader, callbacks_of<tinygltf::FsCallbacks>(files));
  std::string error;
  std::string warning;
  const auto size = static_cast<unsigned>(bytes.size());
  const bool is_read =
      parts.binary_length || bytes.starts_with(kMagic)
          ? reader.LoadBinaryFromMemory(&source.model, &error, &warning,
                                        reinterpret_cast<const unsigned char*>(bytes.data()), size, "")
          : reader.LoadASCIIFromString(&source.model, &error, &warning, bytes.data(), size, "");
  if (!files.problem.empty()) throw InputError(files.problem);
  if (!is_read) refuse(source, fmt::format("is no glTF 2.0 that can be read: {}", error));
  return source;
}

}  // namespace orbs::importer
