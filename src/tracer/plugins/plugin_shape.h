#pragma once

#include "base/matrix.h"
#include "scene/shapes/shape.h"
#include "tracer/plugins/plugin_library.h"

#include <atomic>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace orbs::tracer {

/// Answers of a plug-in that break the rules of orbs/shape_plugin.h. Each counts as a miss: the ray needs an
/// answer, and a place without a distance or a normal cannot be shaded. Sums of all rays, so that they do not
/// depend on threads.
struct PluginFaults {
  std::atomic<std::uint64_t> distance{0};  // t outside of the ray's range, or no number
  std::atomic<std::uint64_t> normal{0};    // of length zero, or no numbers
  std::atomic<std::uint64_t> uv{0};        // no numbers
  std::atomic<std::uint64_t> place{0};     // outside of the bounds
  std::atomic<std::uint64_t> sample{0};  // a random point outside of the bounds, or without normal or density
  std::atomic<std::uint64_t> change{0};  // the same ray got another answer later
};

/// A shape of the scene that a plug-in has made.
struct PluginShape {
  std::shared_ptr<const PluginLibrary> library;
  std::unique_ptr<orbs_shape, decltype(&orbs_shape_destroy)> shape{nullptr, nullptr};
  Mat4 to_local;
  Mat4 to_world;
  Vec3d local_low;  // as the plug-in says
  Vec3d local_high;
  Vec3d low;  // in world space
  Vec3d high;
  int material = 0;
  std::unique_ptr<PluginFaults> faults = std::make_unique<PluginFaults>();
};

/// The shape, whose form is a PluginForm, in coordinates relative to `origin`. `name` is that for messages.
/// InputError if its plug-in is not among the libraries, refuses the numbers, or has bounds that are none.
PluginShape make_plugin_shape(const scene::Shape& shape,
                              const std::string& name,
                              Vec3d origin,
                              const PluginLibraries& libraries);

/// Sums over all shapes; `what` says which faults there were, "" without any.
struct PluginFaultTotals {
  std::uint64_t count = 0;
  std::string what;
};
PluginFaultTotals plugin_faults(const std::vector<PluginShape>& shapes);

}  // namespace orbs::tracer
