#include "adapters/mitsuba/integrator.h"

#include "adapters/mitsuba/stokes_frame.h"
#include "scene/camera_frame.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace orbs::adapters::mitsuba {

namespace {

bool holds(const std::vector<std::string>& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

// max_depth counts the segments of a path, one more than its scatterings. Russian roulette would only add
// noise to paths of limited length, so it begins behind the last scattering; paths of unlimited length get
// Mitsuba's default.
// The type "path" takes what lets rays pass for opaque where it looks for lights, and counts the passes.
std::string path_text(const scene::Scene& scene, const std::string& blocks) {
  const int trace_depth = scene.trace_depth;
  const auto shown = scene::visible_materials(scene);
  const bool has_openings = std::any_of(shown.begin(), shown.end(), [&](int material) {
    return lets_rays_pass(material_at(scene, material).detail);
  });
  constexpr int kRouletteFrom = 5;
  const bool is_unlimited = trace_depth >= scene::kUnlimitedDepth;
  return fmt::format(
      "<integrator type=\"{}\">{}<integer name=\"max_depth\" value=\"{}\"/><integer name=\"rr_depth\" "
      "value=\"{}\"/></integrator>\n",
      has_openings ? "volpath" : "path", blocks, is_unlimited ? -1 : trace_depth + 1,
      is_unlimited ? kRouletteFrom : trace_depth + 1);
}

// Mitsuba seeds each pixel by its place in a square block, and takes smaller blocks for more threads. A size
// that follows from the image alone gives the same image for any number: Mitsuba's own, 32, or what leaves 64
// blocks to share among threads.
std::string block_size_text(const scene::Camera& camera) {
  const auto blocks = [&](int size) {
    return ((camera.width_px + size - 1) / size) * ((camera.height_px + size - 1) / size);
  };
  int size = 32;
  while (size > 1 && blocks(size) < 64) size /= 2;
  return fmt::format("<integer name=\"block_size\" value=\"{}\"/>", size);
}

// The layers of surfaces that Mitsuba knows as we do, with its words for them.
constexpr std::array<std::pair<std::string_view, std::string_view>, 3> kLayers{
    {{"position", "position"}, {"normal", "sh_normal"}, {"albedo", "albedo"}}};

// The words for them, whose channels get our names: "normal.X".
std::string aovs_of(const scene::Scene& scene) {
  std::vector<std::string> aovs;
  for (const auto& [ours, theirs] : kLayers)
    if (holds(scene.outputs.layers, ours)) aovs.push_back(fmt::format("{}:{}", ours, theirs));
  return fmt::format("{}", fmt::join(aovs, ","));
}

}  // namespace

// The layers of Stokes vectors are named S0.R to S3.B, as ours.
std::string integrator_text(const scene::Scene& scene) {
  const std::string hides =
      scene.environment.visible_to_camera ? "" : "<boolean name=\"hide_emitters\" value=\"true\"/>";
  const std::string blocks = block_size_text(scene.camera);
  if (!scene.outputs.layers.empty())
    return fmt::format("<integrator type=\"aov\"><string name=\"aovs\" value=\"{}\"/>{}{}</integrator>\n",
                       aovs_of(scene), path_text(scene, hides), blocks);
  if (!scene.outputs.stokes) return path_text(scene, blocks + hides);
  return fmt::format("<integrator type=\"stokes\">{}{}</integrator>\n", path_text(scene, hides), blocks);
}

std::string layer_limit(const scene::Outputs& outputs) {
  if (outputs.layers.empty()) return "";
  if (outputs.stokes)
    return "the image holds Stokes vectors and layers of surfaces: one integrator makes each of them";
  for (const auto& layer : outputs.layers) {
    const bool is_known =
        std::any_of(kLayers.begin(), kLayers.end(), [&](const auto& known) { return known.first == layer; });
    if (layer == "depth") return "the image holds depths: Mitsuba's are lengths of rays";
    if (layer == "uv")
      return "the image holds texture coordinates: Mitsuba counts the rows of textures from the top, so the "
             "exporter turns them";
    if (!is_known) return fmt::format("the image holds the layer '{}', which Mitsuba does not have", layer);
  }
  return "";
}

std::string stokes_limit(const scene::Scene& scene) {
  if (scene.outputs.stokes && !scene::is_plain_pinhole(scene.camera))
    return "the image holds Stokes vectors: the exporter knows Mitsuba's frames for a centred pinhole alone";
  const double turn_deg = stokes_frame_turn_deg(scene.camera);
  if (!scene.outputs.stokes || turn_deg <= kMostFrameTurn_deg) return "";
  return fmt::format(
      "the image holds Stokes vectors: Mitsuba measures them from the direction across ray and camera's "
      "up, which in the corners lies {:.1f} degrees from the camera's horizontal",
      turn_deg);
}

}  // namespace orbs::adapters::mitsuba
