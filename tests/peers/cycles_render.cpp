#include "peers/cycles_render.h"

#include "adapters/export.h"
#include "adapters/job.h"
#include "adapters/process/process.h"
#include "adapters/process/programs.h"
#include "registry/configuration.h"
#include "run/outcome.h"

#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include <fmt/format.h>

namespace orbs::peers {

image::Image render_with_cycles(const scene::Scene& scene,
                                const std::string& name,
                                int spp,
                                const std::string& renderer_name) {
  const auto configuration = registry::load_configuration(ORBS_SOURCE_DIR "/configuration.json");
  auto renderer = *std::find_if(configuration.renderers.begin(), configuration.renderers.end(),
                                [&](const auto& entry) { return entry.name == renderer_name; });
  // A test knows what it can ask for; what is declared says which requirements are met whole.
  renderer.support.declares = registry::parse_features("G5/M8/L4/A4/N6");
  const auto program = adapters::find_program(renderer.command.executable);
  if (!program)
    throw std::runtime_error(
        "blender is not on PATH; the adapter is tested on the real program: install the package blender");
  const auto folder = std::filesystem::path(ORBS_BINARY_DIR) / (renderer_name + " tests") / name;
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  const auto prepared = adapters::prepare_scene(renderer, scene);
  const auto job =
      adapters::make_job(renderer, scene, {spp, 1, 1, configuration.root, ORBS_BINARY_DIR, *program}, folder);
  adapters::export_scene(renderer, std::get<scene::Scene>(prepared), job.scene_file);
  adapters::ProcessRequest request;
  request.argv = job.argv;
  request.folder = folder;
  request.environment = adapters::child_environment(renderer.command.environment);
  const auto process = adapters::run_process(request);
  auto outcome = run::classify(process, job, request.limits);
  if (!outcome.image)
    throw std::runtime_error(fmt::format("{} {}:\n{}", renderer_name, outcome.reason, process.output));
  return std::move(*outcome.image);
}

}  // namespace orbs::peers
