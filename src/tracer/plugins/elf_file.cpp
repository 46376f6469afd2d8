#include "tracer/plugins/elf_file.h"

#include "base/files.h"

#include <cstdint>
#include <cstring>
#include <optional>
#include <string_view>

#include <elf.h>
#include <fmt/format.h>

namespace orbs::tracer {

namespace {

// The structure at this offset, as elf(5) describes it; nothing beyond the end.
template <typename Header>
std::optional<Header> header_at(std::string_view bytes, std::uint64_t offset) {
  if (offset > bytes.size() || bytes.size() - offset < sizeof(Header)) return std::nullopt;
  Header header;
  std::memcpy(&header, bytes.data() + offset, sizeof header);
  return header;
}

bool holds(std::string_view bytes, std::uint64_t offset, std::uint64_t size) {
  return offset <= bytes.size() && size <= bytes.size() - offset;
}

std::string problem(std::string_view bytes, const char* what, std::uint64_t number, std::uint64_t end) {
  return fmt::format("it is cut off: its {} {} ends at byte {}, and the file has {}", what, number, end,
                     bytes.size());
}

}  // namespace

std::string missing_part(const std::filesystem::path& library) {
  const auto bytes = read_file(library);
  if (!bytes.starts_with(ELFMAG)) return "";
  const auto elf = header_at<Elf64_Ehdr>(bytes, 0);
  if (!elf) return fmt::format("it is cut off: it has {} bytes, not even a header", bytes.size());
  if (elf->e_ident[EI_CLASS] != ELFCLASS64) return "";
  for (std::uint64_t i = 0; i < elf->e_phnum; ++i) {
    const auto at = elf->e_phoff + i * elf->e_phentsize;
    const auto segment = header_at<Elf64_Phdr>(bytes, at);
    if (!segment) return problem(bytes, "header of segment", i, at + sizeof(Elf64_Phdr));
    if (!holds(bytes, segment->p_offset, segment->p_filesz))
      return problem(bytes, "segment", i, segment->p_offset + segment->p_filesz);
  }
  // The loader needs no sections; a file that ends before them is no whole copy all the same.
  for (std::uint64_t i = 0; elf->e_shoff != 0 && i < elf->e_shnum; ++i) {
    const auto at = elf->e_shoff + i * elf->e_shentsize;
    const auto section = header_at<Elf64_Shdr>(bytes, at);
    if (!section) return problem(bytes, "header of section", i, at + sizeof(Elf64_Shdr));
    if (section->sh_type != SHT_NOBITS && !holds(bytes, section->sh_offset, section->sh_size))
      return problem(bytes, "section", i, section->sh_offset + section->sh_size);
  }
  return "";
}

}  // namespace orbs::tracer
