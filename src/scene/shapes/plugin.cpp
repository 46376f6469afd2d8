#include "scene/shapes/plugin.h"

#include "base/text.h"
#include "json/writer.h"
#include "scene/load/entry.h"

#include <fmt/format.h>

namespace orbs::scene {

namespace {

// Scenes come from strangers: with a slash or a point, the name would be a place on the machine of the user.
std::string load_plugin_name(json::ObjectReader& in) {
  auto name = in.text("plugin");
  if (!is_plain_name(name))
    in.fail("plugin",
            fmt::format("'{}' is no plain name: at most 100 letters, digits, '-' and '_'; where the plug-in "
                        "lies, --plugin or --plugin-folder of orbs-tracer says, and never a scene",
                        clean_line(name)));
  return name;
}

}  // namespace

void load(ShapeEntry& entry, PluginForm& loaded) {
  constexpr std::size_t kMostNumbers = 64;
  auto& in = entry.in;
  loaded.plugin = load_plugin_name(in);
  if (!in.has("numbers")) return;
  auto numbers = in.object("numbers");
  for (const auto& name : numbers.keys()) {
    if (!is_plain_name(name))
      numbers.fail(name, "is no plain name: at most 100 letters, digits, '-' and '_'");
    loaded.numbers[name] = numbers.number(name);
  }
  if (loaded.numbers.size() > kMostNumbers)
    in.fail("numbers", fmt::format("are {}; a shape has at most {}", loaded.numbers.size(), kMostNumbers));
  numbers.finish();
}

void write(json::Writer& out, const MaterialList&, const PluginForm& form) {
  out.member("plugin", form.plugin).key("numbers").begin_object();
  for (const auto& [name, value] : form.numbers) out.member(name, value);
  out.end_object();
}

}  // namespace orbs::scene
