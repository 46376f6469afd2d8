#pragma once

#include "scene/scene.h"

#include <map>
#include <set>
#include <string>
#include <vector>

/// Limits that several formats share: one reason that begins with the object in the scene, "" when it can be
/// drawn. `renderer` is the name in the reason.
namespace orbs::adapters {

/// What an exporter does with the levels that go beyond ORB.S ("E6"): it writes them, or it does not for a
/// reason that stands behind the object that calls for the level, after a colon.
struct BeyondOrbs {
  std::set<std::string> written;
  std::map<std::string, std::string> why_not;
};
/// Whether the level goes beyond ORB.S and is not written.
bool is_refused(const std::string& requirement, const BeyondOrbs& levels);
/// One reason for each level beyond ORB.S that the scene calls for and the exporter does not write.
std::vector<std::string> beyond_orbs_limits(const scene::Scene& scene,
                                            const char* renderer,
                                            const BeyondOrbs& levels);
/// `display_name`: the light in the reason. `ies` says what the renderer has instead of an IES profile on a
/// light with a size: "has no ...".
std::string light_limit(const scene::Light& light,
                        const std::string& display_name,
                        const char* renderer,
                        const char* ies);
std::string oren_nayar_limit(const std::string& material, double roughness, const char* renderer);
/// `form` names the masking of the renderer: "a product" or "height-correlated".
std::string masking_limit(const std::string& material, double alpha, const char* renderer, const char* form);
/// As above, of a boundary by its indices; `has_separable` says which form of masking the renderer has.
std::string masking_limit(const std::string& material,
                          const scene::Roughness& roughness,
                          const char* renderer,
                          bool has_separable);
/// Refuses a roughness below `least_alpha`, which the renderer would change.
std::string alpha_limit(const std::string& material, double alpha, const char* renderer, double least_alpha);
/// Refuses an axis that is not turned by quarters.
std::string rotation_limit(const std::string& material, const scene::AnisotropicGgx& m, const char* renderer);
/// Refuses a mix whose parts exceed 1 as those of a weighted mean.
std::string mix_limit(const std::string& material, const scene::GgxLambert& m, const char* renderer);
/// Refuses a texture in a scene that is rendered by wavelengths: each renderer makes spectra of its colours
/// by its own model.
std::string spectral_texture_limit(const scene::Texture& texture, const char* renderer);
std::string wrap_limit(const scene::Texture& texture, const char* renderer);

}  // namespace orbs::adapters
