#pragma once

#include "adapters/job.h"
#include "registry/cases.h"
#include "registry/configuration.h"
#include "results/record.h"
#include "scene/scene.h"

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <variant>
#include <vector>

/// What a run will do, settled and checked before anything is created or started.
namespace orbs::runner {

struct ChosenRenderer {
  registry::Renderer entry;
  std::filesystem::path executable;  // absolute, can be executed
};

struct PlannedScene {
  std::string name;
  std::filesystem::path file;
  int spp = 64;  // of the case
  std::shared_ptr<const scene::Scene> scene;
};

/// One render. Each pair of scene and renderer is rendered once, however many cases look at it.
struct PlannedJob {
  std::string id;
  std::size_t scene = 0;                 // of Plan::scenes
  std::size_t renderer = 0;              // of Plan::renderers
  int spp = 64;                          // that the renderer gets
  std::filesystem::path folder;          // relative to the run's
  std::filesystem::path native_scene{};  // hand-written for the renderer; "" when it is exported
  bool may_be_negative = false;          // its pixels: some case that looks at it allows that
};

/// One image to judge: an image of a case, by one renderer.
struct PlannedTarget {
  std::size_t one_case = 0;  // of Plan::cases
  std::size_t renderer = 0;
  std::string target;
  std::vector<std::size_t> jobs;  // one for a scene, `of` and `minus` for a difference; none when undeclared
  bool declared = false;
};

struct Plan {
  registry::Suite suite;
  registry::Defaults settings;  // after the command line
  int threads = 1;              // of one render
  std::filesystem::path root;   // {root}
  std::filesystem::path build;  // {build}
  std::vector<registry::Case> cases;
  std::vector<ChosenRenderer> renderers;
  std::vector<results::LeftOut> left_out;
  std::vector<PlannedScene> scenes;
  std::map<std::string, std::string>
      reference_hashes;  // by scene: hash of the one by whose reference it is judged
  std::vector<PlannedJob> jobs;
  std::vector<PlannedTarget> targets;
};

/// Reads everything that the settings choose. `program_folder` is where orbs itself lies. InputError for
/// whatever is wrong: files, filters that choose nothing, a renderer that is named but not there, an
/// executable that cannot be executed.
Plan make_plan(const registry::Configuration& configuration,
               const registry::Defaults& settings,
               const std::filesystem::path& program_folder);

/// The scene as the job's renderer can read it: prepared for its format, or as it is where somebody has
/// written it by hand for the renderer. Or the reason why there is none.
std::variant<scene::Scene, std::string> scene_for(const Plan& plan, const PlannedJob& job);

/// The job with all paths, in the run folder `run_folder`; where its renderer takes several seeds, the one of
/// that number from 0.
adapters::Job job_in(const Plan& plan,
                     const PlannedJob& job,
                     const std::filesystem::path& run_folder,
                     int turn = 0);

/// The renderer's program with its placeholders filled: a path or a name.
std::string program_name(const registry::Renderer& renderer,
                         const std::filesystem::path& root,
                         const std::filesystem::path& build);

/// What there is of a renderer's executable on this machine; nothing when there is none.
std::optional<std::filesystem::path> installed_executable(const registry::Renderer& renderer,
                                                          const std::filesystem::path& root,
                                                          const std::filesystem::path& build);

/// The plan for people: one line per job with its command, and why a scene is not rendered where that is
/// known now.
std::string plan_text(const Plan& plan);

}  // namespace orbs::runner
