#include "peers/povray_scenes.h"

#include "adapters/process.h"
#include "adapters/programs.h"

#include <cmath>
#include <filesystem>
#include <numbers>
#include <stdexcept>

#include <fmt/format.h>

namespace orbs::peers {

Vec3d pixel_direction(const scene::Camera& camera, double x_px, double y_px) {
  const Vec3d forward = normalised(camera.look_at_m - camera.position_m);
  const Vec3d right = normalised(cross(forward, camera.up));
  const Vec3d up = cross(right, forward);
  const double half = std::tan(camera.fov_y_deg * std::numbers::pi / 360);
  const double x = (2 * (x_px + 0.5) / camera.width_px - 1) * half * camera.width_px / camera.height_px;
  const double y = (1 - 2 * (y_px + 0.5) / camera.height_px) * half;
  return normalised(forward + right * x + up * y);
}

image::Image render_with_povray(const scene::Scene& scene,
                                const std::string& name,
                                const adapters::PovraySettings& settings,
                                const std::vector<std::string>& options) {
  const auto program = adapters::find_program("povray");
  if (!program)
    throw std::runtime_error(
        "povray is not on PATH; the exporter is tested on the real program: install the package povray");
  // Not below /tmp, where POV-Ray's I/O restrictions allow everything: the folder of the job has to do.
  const std::filesystem::path folder = std::filesystem::path(ORBS_BINARY_DIR) / "povray tests" / name;
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  adapters::write_povray(scene, settings, folder / "scene.pov");
  adapters::ProcessRequest request;
  // POV-Ray splits each argument at blanks once more, unless the path stands in quotes of its own.
  request.argv = {program->string(),
                  "+I\"" + (folder / "scene.pov").string() + "\"",
                  "+O\"" + (folder / "out.exr").string() + "\"",
                  fmt::format("+W{}", scene.camera.width_px),
                  fmt::format("+H{}", scene.camera.height_px),
                  "+FE",
                  "-D",
                  "+WT1"};
  request.argv.insert(request.argv.end(), options.begin(), options.end());
  request.folder = folder;
  request.environment = adapters::child_environment({});
  const adapters::ProcessResult result = adapters::run_process(request);
  if (!result.start_error.empty() || result.timed_out || result.signal != 0 || result.exit_code != 0)
    throw std::runtime_error(fmt::format("povray failed ({}, exit code {}):\n{}", result.start_error,
                                         result.exit_code, result.output));
  return image::read_image(folder / "out.exr");
}

}  // namespace orbs::peers
