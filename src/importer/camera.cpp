#include "importer/camera.h"

#include "base/text.h"
#include "importer/values.h"
#include "scene/geometry/world_bounds.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include <fmt/ranges.h>

namespace orbs::importer {

namespace {

struct PlacedCamera {
  const tinygltf::Camera* camera = nullptr;
  std::string name;
  std::set<std::string> names;  // by which one may choose it
  Mat4 matrix;
};

std::vector<PlacedCamera> placed_cameras(const Source& source, const std::vector<PlacedNode>& nodes) {
  std::vector<PlacedCamera> found;
  for (const PlacedNode& placed : nodes) {
    const auto& node = source.model.nodes[static_cast<std::size_t>(placed.node)];
    if (node.camera < 0) continue;
    const auto where = place("node", node.name, static_cast<std::size_t>(placed.node));
    const auto& camera = item(source, source.model.cameras, node.camera, "camera", where);
    const auto name = !node.name.empty()     ? node.name
                      : !camera.name.empty() ? camera.name
                                             : fmt::format("camera {}", node.camera);
    found.push_back({&camera, name, {name, camera.name}, placed.matrix});
  }
  return found;
}

// The size of the image for a width over height. Of a shape without one, a square.
void set_size(scene::Camera& camera, double aspect, int longer_side) {
  if (!(aspect > 0) || !std::isfinite(aspect)) aspect = 1;
  const auto shorter = [&](double ratio) {
    return std::max(1, static_cast<int>(std::lround(longer_side * ratio)));
  };
  camera.width_px = aspect >= 1 ? longer_side : shorter(aspect);
  camera.height_px = aspect >= 1 ? shorter(1 / aspect) : longer_side;
}

std::optional<int> own_number(const Source& source,
                              const tinygltf::Value& said,
                              const std::string& key,
                              double most) {
  if (!said.IsObject()) refuse(source, "extras/orbs of its scene is no object");
  if (!said.Has(key)) return std::nullopt;
  const auto number = number_in(said, key);
  if (!number || !(*number >= 1 && *number <= most))
    refuse(source,
           fmt::format("extras/orbs/{} of its scene is not as expected: a number of 1 to {}", key, most));
  return static_cast<int>(*number);
}

// What our exporter says of the image, for which glTF has no words.
void set_extras(Import& import) {
  const auto& model = import.source.model;
  if (model.scenes.empty()) return;
  const auto& scene = model.scenes[static_cast<std::size_t>(std::max(0, model.defaultScene))];
  if (!scene.extras.IsObject() || !scene.extras.Has("orbs")) return;
  const auto& said = scene.extras.Get("orbs");
  constexpr double kLargest_px = 16384;
  auto& camera = import.scene.camera;
  const auto width = own_number(import.source, said, "width", kLargest_px);
  const auto height = own_number(import.source, said, "height", kLargest_px);
  if (width && height) {
    camera.width_px = *width;
    camera.height_px = *height;
  }
  if (said.Has("trace_depth") && said.Get("trace_depth").IsString())
    import.scene.trace_depth = scene::kUnlimitedDepth;
  else if (const auto depth = own_number(import.source, said, "trace_depth", 1000))
    import.scene.trace_depth = *depth;
}

void take_lens(Import& import, const tinygltf::Camera& from, const std::string& where, const View& view) {
  auto& camera = import.scene.camera;
  if (from.type == "orthographic") {
    const auto& lens = from.orthographic;
    if (!(std::abs(lens.xmag) > 0) || !(std::abs(lens.ymag) > 0))
      refuse(import.source,
             fmt::format("{} is {} by {} m large; expected more than 0", where, lens.xmag, lens.ymag));
    camera.projection = scene::Orthographic{2 * std::abs(lens.ymag)};
    set_size(camera, std::abs(lens.xmag / lens.ymag), view.longer_side);
    return;
  }
  if (from.type != "perspective")
    refuse(import.source,
           fmt::format("{} is of the type '{}'; there are perspective and orthographic", where, from.type));
  const auto& lens = from.perspective;
  camera.fov_y_deg = lens.yfov * 180 / std::numbers::pi;
  if (!(camera.fov_y_deg > 0) || !(camera.fov_y_deg < 180))
    refuse(import.source, fmt::format("{} has a field of view of {} degrees; expected between 0 and 180",
                                      where, camera.fov_y_deg));
  if (!(lens.aspectRatio > 0))
    import.report.chosen(
        fmt::format("The file does not say the shape of the image of {}. It is a square.", where));
  set_size(camera, lens.aspectRatio, view.longer_side);
}

void take_camera(Import& import, const PlacedCamera& from, const View& view) {
  const auto where = fmt::format("camera '{}'", from.name);
  auto& camera = import.scene.camera;
  const Vec3d forward = transform_direction(from.matrix, {0, 0, -1});
  const Vec3d up = transform_direction(from.matrix, {0, 1, 0});
  camera.position_m = transform_point(from.matrix, {});
  if (!is_finite(camera.position_m) || !is_finite(forward) || !(length(cross(forward, up)) > 0))
    refuse(import.source,
           where + " stands in a node that is flattened by a scale of 0, or at no finite place");
  camera.look_at_m = camera.position_m + normalised(forward);
  camera.up = normalised(up);
  take_lens(import, *from.camera, where, view);
  set_extras(import);
}

// From the front of a model, which is +Z in glTF, a little from the right and from above; so far away that
// the sphere around all that is drawn touches the edges.
void frame_all(Import& import, const View& view) {
  auto& camera = import.scene.camera;
  const auto bounds = scene::rough_bounds(import.scene);
  if (!bounds) {
    std::string left_out;
    for (const auto& remark : import.report.remarks()) left_out += fmt::format("\n  {}", text_of(remark));
    refuse(import.source, fmt::format("draws nothing: there is no triangle in its scene{}{}",
                                      left_out.empty() ? "" : "; not as in the file:", left_out));
  }
  const Vec3d centre = (bounds->low + bounds->high) * 0.5;
  const double radius = std::max(scene::radius_of(*bounds), 1e-6);
  camera.fov_y_deg = 35;
  camera.look_at_m = centre;
  camera.position_m = centre + normalised(Vec3d{0.35, 0.3, 1}) *
                                   (radius / std::sin(0.5 * camera.fov_y_deg * std::numbers::pi / 180));
  camera.width_px = camera.height_px = view.longer_side;
  set_extras(import);
  import.report.chosen("The file has no camera. One in front of the model frames all of it.");
}

}  // namespace

void set_camera(Import& import, const std::vector<PlacedNode>& nodes, const View& view) {
  const auto cameras = placed_cameras(import.source, nodes);
  if (cameras.empty() && view.camera.empty()) return frame_all(import, view);
  std::set<std::string> names;
  for (const auto& camera : cameras) names.insert(camera.name);
  const auto chosen = std::find_if(cameras.begin(), cameras.end(), [&](const auto& camera) {
    return view.camera.empty() || camera.names.contains(view.camera);
  });
  if (chosen == cameras.end())
    refuse(import.source, fmt::format("has no camera '{}'{}; its cameras are: {}", view.camera,
                                      closest(view.camera, names), fmt::join(names, ", ")));
  take_camera(import, *chosen, view);
  for (const auto& camera : cameras)
    if (&camera != &*chosen)
      import.report.not_understood("further cameras", "the one that was chosen; --camera NAME takes another",
                                   fmt::format("'{}'", camera.name));
}

}  // namespace orbs::importer
