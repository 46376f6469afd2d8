#pragma once

#include "base/error.h"
#include "importer/library.h"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

namespace orbs::importer {

/// A file of glTF 2.0 with the bytes of its buffers. Indices in it may lead anywhere: see item().
struct Source {
  std::filesystem::path file;
  tinygltf::Model model;
};

/// Reads a .gltf or .glb file and the buffers that it names, which must lie in its folder. InputError with
/// what was expected, found and where, if the file is torn, no glTF 2.0, or names what is not there.
Source read_source(const std::filesystem::path& file);

/// "a%20b.png" as the path "a b.png" (RFC 3986, 2.1).
std::string decoded_uri(std::string_view uri);

/// The bytes of the file at `path`, which must lie beside the glTF file or below; nothing may lead out of
/// that folder, and nothing is fetched. `what`: "buffer 0". InputError if there is none.
std::string read_beside(const std::filesystem::path& file, const std::string& path, const std::string& what);

[[noreturn]] void refuse(const Source& source, const std::string& problem);

/// list[index]. InputError if there is no such element; `kind`: "accessor"; `where` names it: "mesh 'box'".
/// By value, since GCC from 13 on takes a reference to a temporary for what the returned one may lead to.
template <typename Element>
const Element& item(const Source& source,
                    const std::vector<Element>& list,
                    int index,
                    const char* kind,
                    std::string_view where) {
  if (index >= 0 && static_cast<std::size_t>(index) < list.size())
    return list[static_cast<std::size_t>(index)];
  refuse(source, fmt::format("{} names {} {}, and the file has {} of them, counted from 0; the program that "
                             "wrote the file may write a whole one",
                             where, kind, index, list.size()));
}

/// "are packed with KHR_draco_mesh_compression, which is not read; ...", and what to do.
std::string packed_text(const std::string& extension);

/// "mesh 'box'", or "mesh 3" where it has no name.
std::string place(const char* kind, const std::string& name, std::size_t index);

}  // namespace orbs::importer
