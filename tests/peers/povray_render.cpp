#include "peers/povray_render.h"

#include "adapters/process/process.h"
#include "adapters/process/programs.h"

#include <filesystem>
#include <stdexcept>

#include <fmt/format.h>

namespace orbs::peers {

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
  if (!result.start_error.empty() || result.cause != supervisor::Cause::Nothing || result.signal != 0 ||
      result.exit_code != 0)
    throw std::runtime_error(fmt::format("povray failed ({}, exit code {}):\n{}", result.start_error,
                                         result.exit_code, result.output));
  return image::read_image(folder / "out.exr");
}

}  // namespace orbs::peers
