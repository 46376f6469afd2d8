#pragma once

#include "scene/scene.h"

#include <string>
#include <vector>

/// Limits that Mitsuba and pbrt share: one sentence that begins with the thing in the scene, "" when it can
/// be drawn. `renderer` is the name in the sentence.
namespace orbs::adapters {

/// Everything that goes beyond ORB.S, which the exporters do not write.
std::vector<std::string> beyond_orbs_limits(const scene::Scene& scene, const char* renderer);
std::string light_limit(const scene::Light& light, const char* renderer);
std::string oren_nayar_limit(const std::string& material, double roughness, const char* renderer);
/// `form` says what the renderer has: "a product" or "height-correlated".
std::string masking_limit(const std::string& material, double alpha, const char* renderer, const char* form);
/// A roughness that the renderer takes for another one: below `least_alpha`.
std::string alpha_limit(const std::string& material, double alpha, const char* renderer, double least_alpha);
std::string wrap_limit(const scene::Texture& texture, const char* renderer);

}  // namespace orbs::adapters
