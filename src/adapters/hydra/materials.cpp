#include "adapters/hydra/materials.h"

#include "adapters/hydra/xml.h"
#include "adapters/kind_support.h"
#include "adapters/xml_comment.h"

#include <set>

namespace orbs::adapters::hydra {

namespace {

constexpr const char* kName = "HydraCore3";
constexpr double kSmoothAlpha = 1e-4;
constexpr double kLeastAlpha = 1e-3;  // its rough conductor takes smaller ones for smooth

std::string node(int position, const char* type, const std::string& attributes, const std::string& inner) {
  return fmt::format("<material id=\"{}\" type=\"{}\"{}>{}</material>\n", position, type, attributes, inner);
}

struct MaterialLimits {
  const std::string& name;

  std::string operator()(const scene::Ggx& m) const { return alpha_limit(name, m.alpha, kName, kLeastAlpha); }
  std::string operator()(const scene::Glass& m) const {
    if (m.colour == scene::RgbColour{1, 1, 1}) return "";
    return fmt::format("material '{}' is tinted glass: HydraCore3's dielectrics have no colour", name);
  }
  std::string operator()(const scene::RoughGlass&) const {
    return fmt::format(
        "material '{}' is rough glass: HydraCore3 reads a glossiness of transparency and does not use it",
        name);
  }
};

struct MaterialWriter {
  const scene::Scene& scene;
  const TextureLibrary& textures;
  int position = 0;

  std::string diffuse(const std::string& bsdf,
                      scene::RgbColour reflectance,
                      const std::optional<scene::TextureUse>& use) const {
    return node(
        position, "diffuse", "",
        bsdf + value_node("reflectance", reflectance, use ? texture_node(scene, textures, *use) : ""));
  }
  std::string operator()(const scene::Lambert& m) const {
    return diffuse("<bsdf type=\"lambert\"/>", m.reflectance, m.texture);
  }
  // Its roughness is ours. hydra_material has one, too, and renders Lambert's law whatever it says.
  std::string operator()(const scene::OrenNayar& m) const {
    return diffuse("<bsdf type=\"oren-nayar\"/>" + value_node("roughness", m.roughness), m.reflectance,
                   m.texture);
  }
  // Shines from both sides, as ours.
  std::string operator()(const scene::Emission& m) const {
    return node(
        position, "hydra_material", "",
        "<emission>" +
            value_node("color", m.radiance, m.texture ? texture_node(scene, textures, *m.texture) : "") +
            "</emission>");
  }
  // Without "fresnel" its reflectance is the same at all angles; metals of its type gltf add Schlick's term.
  std::string operator()(const scene::Mirror& m) const {
    return node(position, "hydra_material", "",
                "<reflectivity>" + value_node("color", m.reflectance) + value_node("glossiness", 1.0) +
                    "</reflectivity>");
  }
  // With eta 0 and k 1 all light is reflected at all angles, and the colour is what is left of it.
  std::string operator()(const scene::Ggx& m) const {
    return node(position, "rough_conductor", "",
                value_node("alpha", m.alpha) + value_node("eta", 0.0) + value_node("k", 1.0) +
                    value_node("reflectance", m.colour));
  }
  // The identifiers of materials are their places in the scene.
  std::string operator()(const scene::Blend& m) const {
    const std::string texture = m.texture ? texture_node(scene, textures, *m.texture) : "";
    return node(position, "blend", "",
                fmt::format("<weight val=\"{}\">{}</weight><bsdf_1 id=\"{}\"/><bsdf_2 id=\"{}\"/>", m.weight,
                            texture, m.parts[0].material, m.parts[1].material));
  }
  // Takes an alpha of 1e-4 and less for smooth.
  std::string operator()(const scene::Plastic& m) const {
    return node(
        position, "plastic", "",
        value_node("reflectance", m.reflectance, m.texture ? texture_node(scene, textures, *m.texture) : "") +
            value_node("int_ior", m.ior) + value_node("ext_ior", 1.0) +
            value_node("alpha", m.alpha.value_or(kSmoothAlpha)) +
            value_node("nonlinear", m.is_nonlinear ? 1.0 : 0.0));
  }
  // Its default for the outside is air, 1.00028. The transparency of hydra_material knows no second body.
  std::string operator()(const scene::Glass& m) const {
    return node(position, "dielectric", "", value_node("int_ior", m.ior) + value_node("ext_ior", 1.0));
  }
};

}  // namespace

const BeyondOrbs& beyond_orbs() {
  static const BeyondOrbs kLevels{
      {"B4", "B5", "B6", "C1", "D1", "D2", "D3", "D4", "D5", "D6", "N4"},
      {{"B1", "HydraCore3's material called gltf is another model"},
       {"B2", "the exporter writes HydraCore3's meshes without tangents"},
       {"B3",
        "HydraCore3's rough conductor takes one alpha from a texture by another rule: the exporter does not write it"},
       {"B9", "the exporter writes one material of HydraCore3 for each of the scene"},
       {"B7", "HydraCore3's material called gltf has a coat with reflections inside"},
       {"B8", "HydraCore3 has no Phong reflection"},
       {"C2", "HydraCore3's cameras are perspectives"},
       {"C3", "HydraCore3's images are centred on the axis"},
       {"C4", "HydraCore3's cameras are perspectives"},
       {"E1", "HydraCore3's metals have one n and k for all three colours, and its lights reflect nothing"},
       {"E2", "HydraCore3's mode of wavelengths has no spectra for colours"},
       {"E3", "HydraCore3 carries no polarisation"},
       {"E4", "HydraCore3 has no fluorescence"},
       {"E5", "HydraCore3's thin films are tables for three colours"},
       {"E6", "HydraCore3 refracts three colours alike"},
       {"N2", "HydraCore3 has normal maps and no heights"},
       {"N3", "HydraCore3 has no surfaces that let a share of the rays pass"},
       {"N5", "HydraCore3's nearest texel is the same one everywhere"},
       {"N6", "HydraCore3's meshes have one set of texture coordinates"},
       {"S7", "a plug-in is machine code for the built-in tracer"},
       {"T1", "the exporter writes HydraCore3's instances at rest"},
       {"T2", "HydraCore3 has no meshes that change their shape"},
       {"T3", "HydraCore3's camera rests"},
       {"V1", "HydraCore3's layers have eight bits, and absolute values of normals"}}};
  return kLevels;
}

std::string material_limit(const scene::Material& material) {
  return limit_of_material<MaterialWriter>(material, kName, beyond_orbs(), MaterialLimits{material.name});
}

std::string material_nodes(const scene::Scene& scene, const TextureLibrary& textures) {
  const auto visible = scene::visible_materials(scene);
  std::string text;
  for (int i = 0; i < static_cast<int>(scene.materials.size()); ++i) {
    const MaterialWriter writer{scene, textures, i};
    const auto& material = material_at(scene, i);
    text += xml_comment(material.name);
    text += visible.contains(i) ? text_of_material(material, kName, writer) : writer(scene::Lambert{});
  }
  return text;
}

// Its radiance counts in lights_lib; where the two differ, HydraCore3 says so.
std::string light_material_node(const scene::Light& light, int position, int light_id) {
  return node(position, "hydra_material", fmt::format(" light_id=\"{}\"", light_id),
              "<emission>" + value_node("color", light.radiance) + "</emission>");
}

}  // namespace orbs::adapters::hydra
