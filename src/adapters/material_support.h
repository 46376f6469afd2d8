#pragma once

#include "adapters/format_limits.h"
#include "base/error.h"
#include "scene/scene.h"

#include <concepts>
#include <string>
#include <type_traits>

#include <fmt/format.h>

/// What an exporter does with the types of materials. It has a writer, an object that is called with the
/// model of a material, for each type that it writes, and an object of limits, for each type that it writes
/// in part or refuses for a reason of its own. A type that the writer does not know is refused by its name.
namespace orbs::adapters {

template <typename Writer, typename Model>
concept WritesModel = requires(const Writer& writer, const Model& model) {
  { writer(model) } -> std::same_as<std::string>;
};

inline std::string no_such_type(const scene::Material& material, const char* renderer) {
  return fmt::format("material '{}': {} has no {}", material.name, renderer, type_name(material.model));
}

/// Why the exporter with that Writer cannot write the material; "" when it can, and when beyond_orbs_limits
/// of the same `levels` gives the reason.
template <typename Writer, typename Limits>
std::string limit_of_material(const scene::Material& material,
                              const char* renderer,
                              const BeyondOrbs& levels,
                              const Limits& limits) {
  return std::visit(
      [&](const auto& model) -> std::string {
        using Model = std::decay_t<decltype(model)>;
        if constexpr (WritesModel<Limits, Model>)
          if (std::string reason = limits(model); !reason.empty()) return reason;
        if constexpr (WritesModel<Writer, Model>) return "";
        return is_refused(requirement(model).code, levels) ? "" : no_such_type(material, renderer);
      },
      material.model);
}

/// The text of a material in the format of the writer. InputError for a type that it does not know.
template <typename Writer>
std::string text_of_material(const scene::Material& material, const char* renderer, const Writer& writer) {
  return std::visit(
      [&](const auto& model) -> std::string {
        if constexpr (WritesModel<Writer, std::decay_t<decltype(model)>>)
          return writer(model);
        else
          throw InputError(no_such_type(material, renderer));
      },
      material.model);
}

}  // namespace orbs::adapters
