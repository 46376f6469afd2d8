#pragma once

#include "registry/case.h"
#include "registry/configuration.h"
#include "results/record.h"
#include "scene/scene.h"

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

/// What a run will do: plain data, complete and checked before anything is created or started.
namespace orbs::run {

struct ChosenRenderer {
  registry::Renderer entry;
  std::filesystem::path executable;  // absolute, can be executed
};

struct PlannedScene {
  std::string name;
  std::filesystem::path file;
  int spp = 64;                               // of the case
  std::shared_ptr<const scene::Scene> scene;  // with the camera of the run's size
  int size_divisor = 1;                       // of that camera, see registry::divisor_of_image
  int camera_paths = 0;                       // of the whole image that its means need, see enough_spp
  double wall_seconds = 0;                    // of the case, for one render; 0: the renderer's limit alone
  std::map<std::string, std::vector<std::string>> arguments{};  // by the name of a renderer's entry
  std::uint64_t hash = 0;                                       // scene_content_hash
};

/// Two renders of a job that is rendered in looks, see run/looks.h.
struct PlannedLook {
  int spp = 1;  // of each of the two
  std::array<int, 2> seeds{};
};

/// One render. Each pair of scene and renderer is rendered once, however many cases look at it.
struct PlannedJob {
  std::string id;
  std::size_t scene = 0;                 // of Plan::scenes
  std::size_t renderer = 0;              // of Plan::renderers
  int spp = 64;                          // that the renderer gets; of one in looks, the first guess
  int first_spp = 0;                     // of the first look; 0: all samples at once
  std::optional<PlannedLook> look{};     // that is rendered now
  std::filesystem::path folder;          // relative to the run's
  std::filesystem::path native_scene{};  // hand-written for the renderer; "" when it is exported
  bool may_be_negative = false;          // some case that judges its image allows negative values
  bool has_condition = false;            // some case bounds what rounding decides, see run/condition.h
  double cpu_seconds = 1;                // that the render is expected to take, see estimated_cpu_seconds
};

/// One target of a case to be judged, rendered by one renderer.
struct PlannedTarget {
  std::size_t one_case = 0;  // of Plan::cases
  std::size_t renderer = 0;
  std::string target;
  std::vector<std::size_t>
      jobs;  // one for a scene, `of` and `minus` for a difference; none when not rendered
  bool declared = false;
  std::string unsupported{};  // why it is not rendered although it is declared; "" if it is
};

/// Whether the renderers of a plan are on this machine. Elsewhere: scenes are exported for them, and their
/// images judged; what they are called then is their program.
enum class RenderPlace { Here, Elsewhere };

struct Plan {
  std::string id{};  // hash of all that images and verdicts depend on but for programs and machines
  RenderPlace place = RenderPlace::Here;
  std::filesystem::path configuration{};  // the uppermost file
  std::vector<std::filesystem::path>
      below{};                     // its other files, the lowest first; none for a plan from a file
  std::filesystem::path images{};  // folder of orbs export that holds all images; "": they are rendered
  registry::Suite suite;
  registry::RunSettings settings;     // after the command line
  int threads = 1;                    // of one render
  std::filesystem::path root;         // {root}
  std::filesystem::path build;        // {build}
  std::vector<registry::Case> cases;  // for images of the run's size
  std::vector<ChosenRenderer> renderers;
  std::vector<results::LeftOut> left_out;
  std::vector<PlannedScene> scenes;
  /// By scene: hash of the scene by whose reference it is judged.
  std::map<std::string, std::string> reference_hashes;
  std::vector<PlannedJob> jobs;
  std::vector<PlannedTarget> targets;
  std::vector<registry::ExpectedFailure> expected;  // of the configuration
};

}  // namespace orbs::run
