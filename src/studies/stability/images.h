#pragma once

#include "image/image.h"
#include "run/plan/plan.h"
#include "studies/context.h"
#include "studies/stability/record.h"
#include "studies/stability/relation.h"

#include <filesystem>
#include <optional>
#include <vector>

namespace orbs::studies {

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
