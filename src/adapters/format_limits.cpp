#include "adapters/format_limits.h"

#include "adapters/light_frame.h"
#include "adapters/masking.h"
#include "scene/lower.h"

#include <string_view>

#include <fmt/format.h>

namespace orbs::adapters {

std::vector<std::string> beyond_orbs_limits(const scene::Scene& scene, const char* renderer) {
  constexpr std::string_view kOrbsGroups = "GMLA";
  std::vector<std::string> reasons;
  for (const auto& [requirement, what] : scene::features_called_for(scene))
    if (kOrbsGroups.find(requirement.front()) == std::string_view::npos)
      reasons.push_back(fmt::format("{}, which the exporter to {} does not write", what, renderer));
  return reasons;
}

std::string light_limit(const scene::Light& light, const char* renderer) {
  if (light.ies)
    return fmt::format("light '{}' has an IES profile: {} has them for points without size only", light.name,
                       renderer);
  if (std::holds_alternative<scene::DiskShape>(light.shape) && !is_round(light_frame(light.matrix)))
    return fmt::format("light '{}' is a disk stretched into an ellipse, whose area {} does not know",
                       light.name, renderer);
  return "";
}

std::string oren_nayar_limit(const std::string& material, double roughness, const char* renderer) {
  if (roughness == 0) return "";
  return fmt::format(
      "material '{}' is Oren-Nayar with roughness {}: {}'s diffuse reflection is Lambert's law", material,
      roughness, renderer);
}

std::string masking_limit(const std::string& material, double alpha, const char* renderer, const char* form) {
  const double difference = masking_difference(alpha);
  if (difference <= kMostMaskingDifference) return "";
  return fmt::format(
      "material '{}' is GGX with alpha {}: {}'s masking is {}, which differs by {:.1f} % at 80 degrees",
      material, alpha, renderer, form, 100 * difference);
}

std::string alpha_limit(const std::string& material, double alpha, const char* renderer, double least_alpha) {
  if (alpha >= least_alpha) return "";
  return fmt::format("material '{}' has alpha {}: {} changes what is below {}", material, alpha, renderer,
                     least_alpha);
}

std::string wrap_limit(const scene::Texture& texture, const char* renderer) {
  if (texture.wrap_u == texture.wrap_v) return "";
  return fmt::format("texture '{}' is clamped along one axis only: {} has one rule for both", texture.name,
                     renderer);
}

}  // namespace orbs::adapters
