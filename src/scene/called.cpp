#include "scene/called.h"

#include <fmt/format.h>

namespace orbs::scene {

std::string called(const char* kind, const std::string& name, std::size_t place) {
  return name.empty() ? fmt::format("{} {}", kind, place) : fmt::format("{} '{}'", kind, name);
}

}  // namespace orbs::scene
