#pragma once

#include "scene/scene.h"

#include <map>
#include <set>
#include <string>
#include <vector>

/// Limits that Mitsuba and pbrt share: one reason that begins with the thing in the scene, "" when it can
/// be drawn. `renderer` is the name in the reason.
namespace orbs::adapters {

/// What an exporter does with the levels that go beyond ORB.S ("E6"): it writes them, or it does not for a
/// reason that follows what calls for the level, after a colon.
struct BeyondOrbs {
  std::set<std::string> written;
  std::map<std::string, std::string> why_not;
};
/// Everything in the scene that goes beyond ORB.S and that the exporter does not write.
std::vector<std::string> beyond_orbs_limits(const scene::Scene& scene,
                                            const char* renderer,
                                            const BeyondOrbs& levels);
/// `called`: how the reason calls the light.
std::string light_limit(const scene::Light& light, const std::string& called, const char* renderer);
std::string oren_nayar_limit(const std::string& material, double roughness, const char* renderer);
/// `form` says what the renderer has: "a product" or "height-correlated".
std::string masking_limit(const std::string& material, double alpha, const char* renderer, const char* form);
/// As above, of an interface by its indices; `has_separable` says which form of masking the renderer has.
std::string masking_limit(const std::string& material,
                          const scene::Roughness& roughness,
                          const char* renderer,
                          bool has_separable);
/// A roughness that the renderer takes for another one: below `least_alpha`.
std::string alpha_limit(const std::string& material, double alpha, const char* renderer, double least_alpha);
/// Colours of images in a scene for wavelengths: each renderer makes spectra of them by its own model.
std::string spectral_texture_limit(const scene::Texture& texture, const char* renderer);
std::string wrap_limit(const scene::Texture& texture, const char* renderer);

}  // namespace orbs::adapters
