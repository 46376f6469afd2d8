#include "tracer/choose_light.h"

#include "tracer/learn_light_guides.h"
#include "tracer/learn_light_selection.h"
#include "tracer/trial_image.h"
#include "tracer/world/build_world.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace orbs::tracer {

namespace {

// Light paths and connections take up to twice the time of a plain path, so that about a tenth of the work is
// spent. Of the wall-clock time it is more on several cores, as a trial image is hardly more than one tile.
constexpr double kShareOfPaths = 0.07;

// A technique is kept if the variance falls by more than this factor.
//
// The tree takes a tenth to a third more time (scenes 201, 124 and 123 of ORB.S).
constexpr double kSelectionWorthwhile = 0.8;
// To look up what was learned takes up to a quarter on top of the tree (scene 124 of ORB.S).
constexpr double kLearningWorthwhile = 0.7;
// Light paths take a fifth to a half of the rendering time (mirror and glass scenes of ORB.S).
constexpr double kPathsWorthwhile = 0.78;
// A light path of one segment for each camera path, and one more shadow ray and two evaluations of BSDFs for
// each of its vertices make renders take 2 to 2.7 times as long, so the variance must fall by more. On scene
// 101 of ORB.S it falls to 0.4, which gains nothing, and on "secondary" of Smits and Jensen's scenes to 0.01.
constexpr double kConnectionsWorthwhile = 0.3;

// If the camera sees only a corner of what the emitters illuminate, hardly any light path contributes, and
// the trial shows no noise because it shows no light. Its noise is believed from this many contributions per
// pixel on; below that the technique is taken that finds more light.
constexpr double kFewestContributions = 0.25;

// What finds half as much light again is kept however noisy it is: the other one has missed a caustic.
constexpr double kMuchMoreLight = 1.5;

double light_of(const Trial& trial) {
  double light = 0;
  for (const auto& image : trial.images)
    for (const float value : image.pixels) light += static_cast<double>(value);
  return light;
}

// A trial that shows no light at all says nothing against light paths, which may be the only ones that find
// any: that of a prism behind a slit.
bool is_black(const Trial& trial) {
  const auto is_zero = [](float value) { return value == 0; };
  return std::ranges::all_of(trial.images,
                             [&](const auto& image) { return std::ranges::all_of(image.pixels, is_zero); });
}

}  // namespace

RenderTime choose_light(World& world, const RenderSettings& settings, LightChoices open) {
  LightBvh bvh;
  std::vector<BoundingSphere> casters;
  if (open.selection) std::swap(bvh, world.light_bvh);
  // What a mirror or glass makes of a light without an area is found by nothing else.
  if (open.paths && !world.has_lights_without_area) std::swap(casters, world.caustic_casters);
  if (open.connections) world.connects_light_vertices = false;
  bool connects = open.connections && supports_light_connections(world);
  const int questions = (bvh.empty() ? 0 : 2) + (casters.empty() ? 0 : 1) + (connects ? 1 : 0);
  const auto size = trial_size(world.camera, settings, kShareOfPaths, 2 * (1 + questions));
  if (questions == 0) return {};
  if (!size) {
    // A caustic may be most of the light, and camera paths of a small image may all miss it.
    if (!casters.empty()) std::swap(casters, world.caustic_casters);
    return {};
  }
  RenderTime time;
  const auto rendered = [&] {
    Trial trial = trial_of(world, *size, settings);
    add(time, trial.time);
    return trial;
  };
  Trial best = rendered();
  const auto keep_if = [&](auto& technique, auto& in_world, const auto& is_better) {
    std::swap(technique, in_world);
    Trial with = rendered();
    if (is_better(with))
      best = std::move(with);
    else
      std::swap(technique, in_world);
  };
  const auto is_lower = [&](const Trial& with, double worthwhile) {
    const auto errors = relative_errors(with, best);
    return errors.first < worthwhile * errors.second;
  };
  const auto keep_if_better = [&](auto& technique, auto& in_world, double worthwhile) {
    keep_if(technique, in_world, [&](const Trial& with) { return is_lower(with, worthwhile); });
  };
  if (!bvh.empty()) {
    LightBvh learned = bvh;
    add(time, learn_light_selection(learned, world, settings));
    keep_if_better(bvh, world.light_bvh, kSelectionWorthwhile);
    if (learned.has_learned())
      keep_if(learned, world.light_bvh, [&](const Trial& with) {
        const auto errors = relative_errors(with, best);
        return errors.first < errors.second && typical_variance_ratio(with, best) < kLearningWorthwhile;
      });
  }
  if (!casters.empty())
    keep_if(casters, world.caustic_casters, [&](const Trial& with) {
      if (is_black(best)) return true;
      if (with.light_path_contributions < kFewestContributions) return light_of(with) > light_of(best);
      return is_lower(with, kPathsWorthwhile) || light_of(with) > kMuchMoreLight * light_of(best);
    });
  if (connects) {
    add(time, learn_light_guides(world, settings));
    keep_if_better(connects, world.connects_light_vertices, kConnectionsWorthwhile);
  }
  return time;
}

}  // namespace orbs::tracer
