#include "tracer/plugins/plugin_shape.h"

#include "base/error.h"
#include "base/text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

namespace orbs::tracer {

namespace {

void create(const scene::PluginForm& form, const std::string& name, PluginShape& out) {
  const PluginLibrary& library = *out.library;
  std::vector<orbs_shape_number> numbers;
  for (const auto& [key, value] : form.numbers) numbers.push_back({key.c_str(), value});
  constexpr std::size_t kRoom = 512;
  std::array<char, kRoom> problem{};
  out.shape = {library.create(numbers.data(), numbers.size(), problem.data(), problem.size()),
               library.destroy};
  if (out.shape != nullptr) return;
  problem.back() = '\0';  // the plug-in may have filled the buffer
  const auto text = clean_line(problem.data());
  throw InputError(fmt::format("{}: the plug-in '{}' makes no shape of its numbers: {}", name, library.name,
                               text.empty() ? "it does not say why" : text));
}

void read_bounds(const std::string& name, PluginShape& out) {
  std::array<double, 3> low{};
  std::array<double, 3> high{};
  out.library->bounds(out.shape.get(), low.data(), high.data());
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (!std::isfinite(low[axis]) || !std::isfinite(high[axis]) || low[axis] > high[axis])
      throw InputError(fmt::format(
          "{}: the plug-in '{}' says that the shape extends from {} to {} along {}; bounds must be finite, "
          "the low one first",
          name, out.library->name, low[axis], high[axis], "xyz"[axis]));
  out.local_low = {low[0], low[1], low[2]};
  out.local_high = {high[0], high[1], high[2]};
}

// The box around the corners of the local one, with room for the rounding of bounds and rays to floats, as
// that of other shapes (build_solids.cpp).
void place_bounds(PluginShape& out) {
  constexpr double kInf = std::numeric_limits<double>::infinity();
  Vec3d low{kInf, kInf, kInf};
  Vec3d high = -low;
  for (const double x : {out.local_low.x, out.local_high.x})
    for (const double y : {out.local_low.y, out.local_high.y})
      for (const double z : {out.local_low.z, out.local_high.z}) {
        const Vec3d p = transform_point(out.to_world, {x, y, z});
        low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
      }
  const double size = std::max(largest_magnitude(low), largest_magnitude(high));
  const Vec3d room{size * 1e-6, size * 1e-6, size * 1e-6};
  out.low = low - room;
  out.high = high + room;
}

}  // namespace

PluginShape make_plugin_shape(const scene::Shape& shape,
                              const std::string& name,
                              Vec3d origin,
                              const PluginLibraries& libraries) {
  const auto& form = std::get<scene::PluginForm>(shape.form);
  const auto library = libraries.find(form.plugin);
  if (library == libraries.end())
    throw InputError(fmt::format("{} is by the plug-in '{}', which is not open", name, form.plugin));
  PluginShape out;
  out.library = library->second;
  create(form, name, out);
  read_bounds(name, out);
  out.to_world = translation(-origin) * shape.matrix;
  out.to_local = inverse(out.to_world).value();  // the loader lets only invertible matrices through
  out.material = shape.material;
  place_bounds(out);
  return out;
}

PluginFaultTotals plugin_faults(const std::vector<PluginShape>& shapes) {
  struct Kind {
    std::atomic<std::uint64_t> PluginFaults::*count;
    const char* what;
  };
  constexpr std::array kKinds{
      Kind{&PluginFaults::distance, "distances outside of the ray's range"},
      Kind{&PluginFaults::normal, "normals without a direction"},
      Kind{&PluginFaults::uv, "texture coordinates that are no numbers"},
      Kind{&PluginFaults::place, "points outside of the bounds"},
      Kind{&PluginFaults::sample, "random points outside of the bounds or without normal or density"},
      Kind{&PluginFaults::change, "answers that change when the same ray asks again"}};
  PluginFaultTotals totals;
  for (const auto& shape : shapes)
    for (const auto& [count, what] : kKinds) {
      const std::uint64_t n = *shape.faults.*count;
      if (n == 0) continue;
      totals.count += n;
      totals.what +=
          fmt::format("{}{} {} of '{}'", totals.what.empty() ? "" : ", ", n, what, shape.library->name);
    }
  return totals;
}

}  // namespace orbs::tracer
