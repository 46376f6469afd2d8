#include "adapters/format_limits.h"

#include "adapters/light_frame.h"
#include "scene/effects/features.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>

#include <fmt/format.h>

namespace orbs::adapters {

namespace {

// The largest masking_difference that an exporter accepts for the same material. It is reached at alpha
// 0.12; at 45 degrees that alpha makes a difference of 1.3e-5.
constexpr double kMostMaskingDifference = 0.01;

// Smith's masking-shadowing of GGX is written as a product of two sides, 1 / ((1 + Lo)(1 + Li)), or
// height-correlated, 1 / (1 + Lo + Li) (Heitz 2014, eq. 99), L = (sqrt(1 + alpha^2 tan^2) - 1) / 2. A
// renderer with one form draws a material of the other darker or brighter by the ratio of both minus 1,
// which this returns for both directions at 80 degrees from the normal; from beyond them comes 3 % (cos^2)
// of the light that a surface gets from an even surrounding.
double masking_difference(double alpha) {
  const double slope = alpha * std::tan(80 * std::numbers::pi / 180);
  const double lambda = (std::sqrt(1 + slope * slope) - 1) / 2;
  return lambda * lambda / (1 + 2 * lambda);  // (1 + L)^2 / (1 + 2 L) - 1
}

}  // namespace

bool is_refused(const std::string& requirement, const BeyondOrbs& levels) {
  constexpr std::string_view kOrbsGroups = "GMLA";
  return kOrbsGroups.find(requirement.front()) == std::string_view::npos &&
         !levels.written.contains(requirement);
}

std::vector<std::string> beyond_orbs_limits(const scene::Scene& scene,
                                            const char* renderer,
                                            const BeyondOrbs& levels) {
  std::vector<std::string> reasons;
  for (const auto& [requirement, what] : scene::features_called_for(scene)) {
    if (!is_refused(requirement, levels)) continue;
    const auto why = levels.why_not.find(requirement);
    reasons.push_back(why == levels.why_not.end()
                          ? fmt::format("{}, which the exporter to {} does not write", what, renderer)
                          : fmt::format("{}: {}", what, why->second));
  }
  return reasons;
}

std::string light_limit(const scene::Light& light,
                        const std::string& display_name,
                        const char* renderer,
                        const char* ies) {
  if (light.ies) return fmt::format("{} has an IES profile: {} {}", display_name, renderer, ies);
  if (std::holds_alternative<scene::DiskShape>(light.shape) && !is_round(light_frame(light.matrix)))
    return fmt::format("{} is a disk stretched into an ellipse, whose area {} does not know", display_name,
                       renderer);
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
      "material '{}' is rough, alpha {}: {}'s masking is {}, which differs by {:.1f} % at 80 degrees",
      material, alpha, renderer, form, 100 * difference);
}

std::string masking_limit(const std::string& material,
                          const scene::Roughness& roughness,
                          const char* renderer,
                          bool has_separable) {
  if ((roughness.masking == scene::Masking::Separable) == has_separable) return "";
  return masking_limit(material, roughness.alpha, renderer,
                       has_separable ? "a product of two sides" : "height-correlated");
}

std::string alpha_limit(const std::string& material, double alpha, const char* renderer, double least_alpha) {
  if (alpha >= least_alpha) return "";
  return fmt::format("material '{}' has alpha {}: {} changes what is below {}", material, alpha, renderer,
                     least_alpha);
}

std::string rotation_limit(const std::string& material,
                           const scene::AnisotropicGgx& m,
                           const char* renderer) {
  if (scene::alphas_unturned(m)) return "";
  return fmt::format("material '{}' turns its axis by {} degrees: {} has the direction of the texture alone",
                     material, m.rotation_deg, renderer);
}

std::string mix_limit(const std::string& material, const scene::GgxLambert& m, const char* renderer) {
  const auto mean = scene::mix_as_mean(m);
  const double largest =
      std::max({mean.glossy.x, mean.glossy.y, mean.glossy.z, mean.diffuse.x, mean.diffuse.y, mean.diffuse.z});
  // Each part has the larger of the two sums as its largest component, which is 1 but for rounding where one
  // of them gave way.
  if (largest <= 1 + 1e-12) return "";
  return fmt::format(
      "material '{}' is the sum of a glossy and a diffuse reflection of unlike hues: {} has weighted means, "
      "whose parts would reflect {:.2f}",
      material, renderer, largest);
}

std::string spectral_texture_limit(const scene::Texture& texture, const char* renderer) {
  return fmt::format(
      "texture '{}' is seen by wavelengths: {} makes spectra of the colours of images by a model of its "
      "own",
      texture.name, renderer);
}

std::string wrap_limit(const scene::Texture& texture, const char* renderer) {
  if (texture.wrap_u == texture.wrap_v) return "";
  const bool is_clamped = texture.wrap_u == scene::Wrap::Clamp || texture.wrap_v == scene::Wrap::Clamp;
  return fmt::format("texture '{}' is {} along one axis only: {} has one rule for both", texture.name,
                     is_clamped ? "clamped" : "mirrored", renderer);
}

}  // namespace orbs::adapters
