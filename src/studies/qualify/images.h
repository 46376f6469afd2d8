#pragma once

#include "image/image.h"
#include "results/record.h"
#include "run/plan/plan.h"

#include <array>
#include <atomic>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

/// The images that a qualification starts from.
namespace orbs::studies {

/// The image of a target that a renderer made in a run. InputError where the run has none that could be
/// judged.
image::Image control_image(const results::RunRecord& run,
                           const std::string& renderer,
                           const std::string& case_name,
                           const std::string& target);

/// Two renders of a scene with a fault, of different seeds, and two without it of the same samples. What a
/// fault changes shows in them however noisy the scene is, and the two tell the noise of the change.
struct FaultBySamples {
  std::array<image::Image, 2> faulty;
  std::shared_ptr<const std::array<image::Image, 2>> right;
};

/// A scene rendered anew with a fault that no change of an image can make.
struct RenderedMutant {
  std::string name;  // "without light 'turned'", "raw-textures"
  image::Image image;
  /// What is accepted by these is no fault of this scene, as one bounce less of ten. Nothing where the fault
  /// is one of every scene.
  std::optional<FaultBySamples> by_samples = std::nullopt;
};

/// With the mean of both renders as its image; `spp` is the samples of each.
RenderedMutant mutant_of_renders(std::string name, FaultBySamples by_samples, int spp);

/// Why no light of the scene can be left out such that another one still lights it: another light, a visible
/// emitter or the environment. "" when one can.
std::string why_no_light_can_miss(const scene::Scene& scene);

/// The scene with one light left out, for each light, rendered by the plan's first renderer in `scratch`.
/// Nothing when stopped. InputError when the renderer fails.
std::optional<std::vector<RenderedMutant>> without_each_light(const run::Plan& plan,
                                                              const run::PlannedScene& scene,
                                                              int spp,
                                                              const std::filesystem::path& scratch,
                                                              const std::atomic<bool>* stop);

/// Whether a renderer is the built-in one, which makes the faults of scene/render_fault.h.
bool makes_faults(const run::ChosenRenderer& renderer);

/// The scene with each of these faults that can change it. Nothing when stopped. InputError when the
/// renderer, the plan's first, fails.
std::optional<std::vector<RenderedMutant>> with_each_fault(const run::Plan& plan,
                                                           const run::PlannedScene& scene,
                                                           int spp,
                                                           const std::filesystem::path& scratch,
                                                           const std::atomic<bool>* stop);

}  // namespace orbs::studies
