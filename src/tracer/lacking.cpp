#include "tracer/lacking.h"

#include "scene/effects.h"
#include "scene/lower.h"

#include <ranges>
#include <string_view>

#include <fmt/format.h>

namespace orbs::tracer {

std::string lacking_for(const scene::Scene& scene) {
  const auto found = scene::effects(scene);
  const auto needed = scene::transport(found);
  // The last finding in the order of effects is what makes the transport as rich as it is.
  for (const auto& finding : std::views::reverse(found.called_for))
    if (scene::transport_for(finding.effect) != scene::LightTransport::Colour)
      return fmt::format("scene '{}' calls for {} transport because {} {}, which this build does not have",
                         scene.name, scene::transport_name(needed), finding.thing, finding.reason);
  // What RGB could carry, but no kernel of this build scatters by.
  constexpr std::string_view kBuiltGroups = "GMLA";
  for (const auto& [requirement, what] : scene::features_called_for(scene))
    if (kBuiltGroups.find(requirement.front()) == std::string_view::npos)
      return fmt::format("scene '{}': {}, which this build does not have", scene.name, what);
  return "";
}

}  // namespace orbs::tracer
