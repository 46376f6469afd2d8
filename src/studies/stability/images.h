#pragma once

#include "image/image.h"
#include "run/plan/plan.h"
#include "scene/relations/relation.h"
#include "studies/context.h"
#include "studies/stability/record.h"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace orbs::studies {

/// What is rendered differently where the scene stays as it is.
enum class RenderChange {
  None,
  Threads,    // three threads instead of those of the study
  Seed,       // other seeds
  TwoHalves,  // the mean of two renders with half the samples, of other seeds
  Precision   // with the arguments that the entry names for double precision
};

/// A relation of scenes, or of two ways to render one scene.
struct StabilityRelation {
  scene::Relation of_scenes;
  RenderChange render = RenderChange::None;
};

/// All relations of a study whose names match one of the patterns ("translate_*"); without patterns all.
/// InputError when a pattern matches none.
std::vector<StabilityRelation> stability_relations(const std::vector<std::string>& patterns);

/// The images of one scene by one renderer, one per seed; images of the same original scene are rendered
/// once.
class StabilityImages {
 public:
  StabilityImages(const run::Plan& plan,
                  const run::ChosenRenderer& renderer,
                  const StabilitySettings& settings,
                  const StudyContext& context)
      : plan_(plan), renderer_(renderer), settings_(settings), context_(context) {}

  /// Colours of the images of `scene`, whose file is written into `folder`. Nothing when the user interrupts;
  /// InputError when there is no image.
  std::optional<std::vector<image::Image>> render(const scene::Scene& scene,
                                                  const std::filesystem::path& folder,
                                                  RenderChange change = RenderChange::None) const;

  /// Likewise of an original scene. Its images are kept.
  std::optional<std::vector<image::Image>> original(const scene::Scene& scene,
                                                    const std::filesystem::path& folder);

 private:
  struct Kept {
    scene::Scene scene;
    std::vector<image::Image> images;
  };
  const run::Plan& plan_;
  const run::ChosenRenderer& renderer_;
  const StabilitySettings& settings_;
  const StudyContext& context_;
  std::vector<Kept> kept_;
};

}  // namespace orbs::studies
