#pragma once

#include "adapters/format_limits.h"
#include "base/error.h"
#include "scene/scene.h"

#include <string>
#include <type_traits>

#include <fmt/format.h>

/// What an exporter does with the types of materials and the kinds of lights. It has a writer, an object that
/// is called with the model of a material or the shape of a light, for each one that it writes, and an object
/// of limits, for each type of material that it writes in part or refuses for its own reason. What the
/// writer does not know is refused by its name.
namespace orbs::adapters {

template <typename Writer, typename Kind>
concept WritesKind = requires(const Writer& writer, const Kind& kind) {
  writer(kind);
};

inline std::string no_such_type(const scene::Material& material, const char* renderer) {
  return fmt::format("material '{}': {} has no {}", material.name, renderer, type_name(material.model));
}
inline std::string no_such_light(const scene::LightShape& shape,
                                 const std::string& display_name,
                                 const char* renderer) {
  return fmt::format("{}: {} has no light of type {}", display_name, renderer, type_name(shape));
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
        if constexpr (WritesKind<Limits, Model>)
          if (std::string reason = limits(model); !reason.empty()) return reason;
        if constexpr (WritesKind<Writer, Model>) return "";
        return is_refused(requirement(model).code, levels) ? "" : no_such_type(material, renderer);
      },
      material.model);
}

/// What the writer makes of a material: text in its format, or data for one that is written as a whole.
/// InputError for a type that it does not know.
template <typename Writer>
auto written_material(const scene::Material& material, const char* renderer, const Writer& writer) {
  using Written = std::invoke_result_t<const Writer&, const scene::Lambert&>;
  return std::visit(
      [&](const auto& model) -> Written {
        if constexpr (WritesKind<Writer, std::decay_t<decltype(model)>>)
          return writer(model);
        else
          throw InputError(no_such_type(material, renderer));
      },
      material.model);
}

/// The text of a material in the format of the writer. InputError for a type that it does not know.
template <typename Writer>
std::string text_of_material(const scene::Material& material, const char* renderer, const Writer& writer) {
  return written_material(material, renderer, writer);
}

/// Why the exporter with that Writer cannot write the shape of the light; "" when it can.
template <typename Writer>
std::string limit_of_shape(const scene::Light& light, const std::string& display_name, const char* renderer) {
  return std::visit(
      [&](const auto& shape) -> std::string {
        if constexpr (WritesKind<Writer, std::decay_t<decltype(shape)>>) return "";
        return no_such_light(light.shape, display_name, renderer);
      },
      light.shape);
}

/// The text of a light's shape in the format of the writer. InputError for one that it does not know.
template <typename Writer>
std::string text_of_shape(const scene::Light& light, const char* renderer, const Writer& writer) {
  return std::visit(
      [&](const auto& shape) -> std::string {
        if constexpr (WritesKind<Writer, std::decay_t<decltype(shape)>>)
          return writer(shape);
        else
          throw InputError(no_such_light(light.shape, "light '" + light.name + "'", renderer));
      },
      light.shape);
}

}  // namespace orbs::adapters
