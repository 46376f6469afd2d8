#include "registry/new_renderer.h"

#include "base/error.h"
#include "base/files.h"
#include "base/text.h"
#include "json/locate.h"
#include "json/writer.h"

#include <fmt/format.h>

namespace orbs::registry {

namespace {

// The first that reads the same format of a renderer; its command line will do for others of its kind.
const Renderer* of_same_format(const Configuration& configuration, const std::string& scene_format) {
  for (const auto& renderer : configuration.renderers)
    if (scene_format != kNeutralFormat && scene_format != kNativeFormat &&
        renderer.format.name == scene_format)
      return &renderer;
  return nullptr;
}

void write_command(const Renderer& alike, json::Writer& out) {
  if (!alike.format.transports.empty()) {
    out.key("transports").begin_object();
    for (const auto& [name, word] : alike.format.transports) out.member(name, word);
    out.end_object();
  }
  if (alike.sampling.seed_stride > 1) out.member("seed_stride", alike.sampling.seed_stride);
  if (!alike.command.sequence.words.empty()) {
    out.key("image_sequence").begin_object().member("words", alike.command.sequence.words);
    out.member("suffix", alike.command.sequence.suffix).end_object();
  }
  if (!alike.command.fails_on.empty()) out.member("fails_on", alike.command.fails_on);
  out.member("command", alike.command.words);
}

void write_command(const Configuration& configuration, const NewRenderer& added, json::Writer& out) {
  const auto* alike = of_same_format(configuration, added.scene_format);
  if (!added.command.empty())
    out.member("command", added.command);
  else if (alike != nullptr)
    write_command(*alike, out);
  else
    out.member("command", std::vector<std::string>{"{executable}", "{scene}", "--output", "{output}", "--spp",
                                                   "{spp}", "--seed", "{seed}", "--threads", "{threads}"});
}

// A path is meant from where the user stands, not from where renders are started.
std::string executable_text(const NewRenderer& added) {
  if (added.executable.empty()) return added.name;
  const bool is_plain_path =
      added.executable.find('/') != std::string::npos && added.executable.find('{') == std::string::npos;
  return is_plain_path ? std::filesystem::absolute(added.executable).lexically_normal().string()
                       : added.executable;
}

std::string entry_text(const Configuration& configuration, const NewRenderer& added) {
  json::Writer out;
  out.begin_object().member("name", added.name).member("executable", executable_text(added));
  if (!added.version.empty()) {
    std::vector<std::string> words{"{executable}"};
    words.insert(words.end(), added.version.begin(), added.version.end());
    out.member("version_command", words);
  }
  out.member("scene_format", added.scene_format);
  if (!added.native_scenes.empty()) out.member("native_scenes", added.native_scenes);
  out.member("declares", added.declares);
  write_command(configuration, added, out);
  return std::string(trim(out.end_object().text()));
}

struct Added {
  std::string text;  // of the whole file
  Renderer entry;
};

Added with_entry(const Configuration& configuration, const NewRenderer& added) {
  for (const auto& renderer : configuration.renderers)
    if (renderer.name == added.name)
      throw InputError(fmt::format("{}: has a renderer '{}' already; edit its entry, or choose another name",
                                   configuration.own_file.string(), added.name));
  const auto& own = configuration.own_file;
  auto text = own_text(own);
  if (!json::has_value(text, "/renderers")) text = json::with_member(text, "renderers", "[]");
  text = json::with_element(text, "/renderers", entry_text(configuration, added));
  const auto read =
      with_note(fmt::format("adding renderer '{}'; {} is as it was", added.name, own.string()), [&] {
        return load_configuration(with_own(configuration.files, own), EditedFile{own, text});
      });
  for (const auto& renderer : read.renderers)
    if (renderer.name == added.name) return {text, renderer};
  throw InputError(fmt::format("{}: is over the file that the entry was written to, {}, and takes it away",
                               read.file.string(), own.string()));
}

}  // namespace

Renderer entry_of(const Configuration& configuration, const NewRenderer& added) {
  return with_entry(configuration, added).entry;
}

Renderer add_renderer(const Configuration& configuration, const NewRenderer& added) {
  const auto made = with_entry(configuration, added);
  write_own(configuration.own_file, made.text);
  return made.entry;
}

}  // namespace orbs::registry
