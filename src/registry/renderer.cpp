#include "registry/renderer.h"

#include "base/pattern.h"
#include "base/text.h"
#include "registry/placeholders.h"
#include "registry/plain_name.h"

#include <algorithm>
#include <filesystem>
#include <set>

#include <fmt/format.h>

namespace orbs::registry {

namespace {

using json::ObjectReader;

// {data} has been put in its place by now, and is named in complaints alone.
std::set<std::string> with_data(std::set<std::string> known) {
  known.insert("data");
  return known;
}

// `known`: what may stand in braces.
void check_words(ObjectReader& in,
                 const std::string& key,
                 const std::vector<std::string>& words,
                 const std::set<std::string>& known,
                 const char* needed) {
  for (std::size_t i = 0; i < words.size(); ++i)
    if (const auto problem = placeholder_problem(words[i], with_data(known))) in.fail_at(key, i, *problem);
  if (words.empty() && in.has(key)) in.fail(key, fmt::format("must hold at least {}", needed));
}

void check_command(ObjectReader& in, const Command& command) {
  const std::set<std::string> places{"root", "build"};
  if (const auto problem = placeholder_problem(command.executable, places)) in.fail("executable", *problem);
  if (command.executable.empty()) in.fail("executable", "must not be empty");
  const auto& words = command.words;
  check_words(in, "command", words, command_placeholders(), "the program");
  if (words.front().empty() || words.front().starts_with('-'))
    in.fail_at("command", 0, fmt::format("must be a program or {{executable}}, is '{}'", words.front()));
  for (const char* name : {"arguments", "images"})
    for (std::size_t i = 0; i < words.size(); ++i)
      if (uses_placeholder(words[i], name) && (i == 0 || words[i] != fmt::format("{{{}}}", name)))
        in.fail_at(
            "command", i,
            fmt::format("{{{}}} stands for words of their own: it must be a word after the program", name));
  for (const char* needed : {"scene", "output"})
    if (!uses_placeholder(words, needed))
      in.fail("command", fmt::format("must use {{{}}}, or the renderer cannot know its {}", needed, needed));
  if (uses_placeholder(words.front(), "plugin"))
    in.fail_at("command", 0,
               "{plugin} stands for words that may be several or none, and here is the program");
  check_words(in, "plugins", command.plugins, places, "one file; leave it out for none");
  if (!command.plugins.empty() && !uses_placeholder(words, "plugin"))
    in.fail("plugins",
            "needs a word with {plugin} in the command, such as \"--plugin={plugin}\", or the renderer "
            "cannot know them");
  check_words(in, "readable", command.readable, places, "one file or folder; leave it out for none");
  for (std::size_t i = 0; i < command.environment.size(); ++i)
    if (command.environment[i].empty() || command.environment[i].front() == '=')
      in.fail_at("environment", i, "must be NAME or NAME=value");
}

void check_image_sequence(ObjectReader& in, const Command& command) {
  const bool has_place = uses_placeholder(command.words, "images");
  if (!in.has("image_sequence")) {
    if (has_place) in.fail("command", "uses {images}, for which there is no 'image_sequence'");
    return;
  }
  if (!has_place)
    in.fail("image_sequence", "needs {images} as a word of the command, where its words can stand");
  if (uses_placeholder(command.words, "seed"))
    in.fail("image_sequence",
            "contradicts {seed} in the command: what takes a seed needs no sequence of images");
  auto sequence = in.object("image_sequence");
  const auto& of_image = command.sequence.words;
  if (of_image.empty()) sequence.fail("words", "must hold at least one word");
  for (std::size_t i = 0; i < of_image.size(); ++i)
    if (const auto problem = placeholder_problem(of_image[i], {})) sequence.fail_at("words", i, *problem);
  if (command.sequence.suffix.find('/') != std::string::npos)
    sequence.fail("suffix", fmt::format("'{}' must be a part of a file's name", command.sequence.suffix));
}

std::string pattern_problem(const std::string& text) {
  try {
    return Pattern(text).matches("") ? "matches an empty line, and so every output" : "";
  } catch (const InputError& e) {
    return e.what();
  }
}

void check_failing_words(ObjectReader& in, const Command& command) {
  for (std::size_t i = 0; i < command.fails_on.size(); ++i)
    if (const auto problem = pattern_problem(command.fails_on[i]); !problem.empty())
      in.fail_at("fails_on", i, problem);
}

// `needed`: what the message says about the groups.
void check_pattern(ObjectReader& in,
                   const std::string& key,
                   const std::string& text,
                   std::size_t most_groups,
                   const char* needed) {
  std::size_t groups = 0;
  try {
    groups = Pattern(text).group_count();
  } catch (const InputError& e) {
    in.fail(key, e.what());
  }
  if (groups < 1 || groups > most_groups)
    in.fail(key, fmt::format("has {} groups in parentheses, needs {}", groups, needed));
}

void check_version(ObjectReader& in, const Command& command) {
  check_words(in, "version_command", command.version_command, executable_placeholders(), "the program");
  if (in.has("version_pattern"))
    check_pattern(in, "version_pattern", command.version_pattern, 1, "1, which holds the version");
}

void check_format(ObjectReader& in, const SceneFormat& format) {
  if (format.settings_of_sizes.contains(FullSize))
    in.object("scene_settings_of_sizes")
        .fail("1", "is no reduced size, and has the settings of the entry itself; expected 1/2, 1/4 or 1/8");
  for (const auto& [name, word] : format.transports)
    if (word.empty()) in.object("transports").fail(name, "must not be empty");
  const auto& ending = format.native_scenes;
  if (format.name == kNativeFormat && ending.empty())
    in.fail("", "a renderer of the scene_format native needs 'native_scenes', the ending of its scenes");
  if (ending.find_first_of("/\\*? \t\n") != std::string::npos || ending.starts_with('.'))
    in.fail("native_scenes", fmt::format("'{}' is no ending such as \"xml\"", ending));
}

std::string limit_problem(const std::string& requirement, const FeatureSet& declares) {
  try {
    const auto code = parse_requirement(requirement);
    refuse_unknown(code);
    return has_feature(declares, code)
               ? fmt::format("'declares' has {}; leave it out there, or here", requirement)
               : "";
  } catch (const InputError& e) {
    return e.what();
  }
}

void check_support(ObjectReader& in, const Support& support) {
  auto entries = in.objects_or_none("known_limits");
  for (std::size_t k = 0; k < entries.size(); ++k) {
    const auto& limit = support.known_limits[k];
    for (std::size_t i = 0; i < limit.requirements.size(); ++i)
      if (const auto problem = limit_problem(limit.requirements[i], support.declares); !problem.empty())
        entries[k].fail_at("requirements", i, problem);
    if (limit.reason.empty()) entries[k].fail("reason", "must say why");
  }
}

void check_sampling(ObjectReader& in, const Sampling& sampling, const Command& command) {
  const bool has_seed = uses_placeholder(command.words, "seed");
  if (sampling.seeds > 1 && !takes_seed(command))
    in.fail("seeds", "needs {seed} in the command, or all renders would be the same");
  if (sampling.seed_stride > 1 && !has_seed)
    in.fail("seed_stride", "needs {seed} in the command, which it multiplies");
  if (sampling.is_noise_free && takes_seed(command))
    in.fail("noise_free", "contradicts {seed} in the command: what depends on a seed has noise");
}

void check_render_seconds(ObjectReader in, const RenderSeconds& seconds) {
  if (in.has("pattern") == in.has("file"))
    in.fail("", "needs either 'pattern', for the renderer's output, or 'file' and 'key', for a JSON file");
  if (in.has("pattern")) {
    check_pattern(
        in, "pattern", seconds.pattern, 3,
        "1 (seconds), 2 (minutes, seconds; or a number and its unit) or 3 (hours, minutes, seconds)");
    if (in.has("key")) in.fail("key", "belongs to 'file', and here is a 'pattern'");
    return;
  }
  const auto path = std::filesystem::path(seconds.file);
  if (path.empty() || path.is_absolute() || *path.lexically_normal().begin() == "..")
    in.fail("file", "must lie in the folder of the render: a relative path without '..'");
  if (in.text("key").empty()) in.fail("key", "must name a number in the file");
}

void check_timing(ObjectReader& in, const Timing& timing) {
  if (in.has("render_seconds")) check_render_seconds(in.object("render_seconds"), timing.render_seconds);
  if (in.has("trial_seconds")) check_render_seconds(in.object("trial_seconds"), timing.trial_seconds);
  std::set<std::string> names;
  for (auto& setting : in.objects_or_none("cost_sweep"))
    if (!names.insert(plain_name(setting, "name")).second)
      setting.fail("name", "is the name of an earlier setting");
}

Renderer variant_of(ObjectReader in, const Variant& variant, const Renderer& entry) {
  auto renderer = entry;
  renderer.variant_of = entry.name;
  renderer.name = fmt::format("{}-{}", entry.name, plain_name(in, "name"));
  if (renderer.name.size() > kMostNameCharacters)
    in.fail("name", fmt::format("'{}' has {} characters, may have {}", renderer.name, renderer.name.size(),
                                kMostNameCharacters));
  renderer.place = in.place("name");
  renderer.command.arguments = variant.arguments;
  for (std::size_t i = 0; i < variant.arguments.size(); ++i)
    if (const auto problem = placeholder_problem(variant.arguments[i], argument_placeholders()))
      in.fail_at("arguments", i, *problem);
  renderer.sampling.biased = variant.biased.value_or(entry.sampling.biased);
  for (const auto& [setting, value] : variant.scene_settings) renderer.format.settings[setting] = value;
  return renderer;
}

}  // namespace

std::vector<Renderer> renderers_of(ObjectReader& in, RendererEntry entry, const ProcessLimits& limits) {
  auto& renderer = entry.renderer;
  plain_name(in, "name");
  renderer.place = in.place("name");
  check_command(in, renderer.command);
  check_image_sequence(in, renderer.command);
  check_failing_words(in, renderer.command);
  check_version(in, renderer.command);
  check_format(in, renderer.format);
  check_support(in, renderer.support);
  check_sampling(in, renderer.sampling, renderer.command);
  check_timing(in, renderer.timing);
  renderer.limits = limits;
  apply(entry.limits, renderer.limits);
  if (!in.has("variants")) return {renderer};
  if (entry.variants.empty()) in.fail("variants", "must hold at least one; leave it out for none");
  const auto places = in.objects("variants");
  std::vector<Renderer> renderers;
  for (std::size_t i = 0; i < places.size(); ++i)
    renderers.push_back(variant_of(places[i], entry.variants[i], renderer));
  return renderers;
}

std::string limit_text(const KnownLimit& limit) {
  return is_absent(limit.version) ? limit.reason
                                  : fmt::format("{} (version {})", limit.reason, to_text(limit.version));
}

std::optional<std::string> limit_reason(const Renderer& renderer, const std::string& requirement) {
  for (const auto& limit : renderer.support.known_limits)
    if (std::find(limit.requirements.begin(), limit.requirements.end(), requirement) !=
        limit.requirements.end())
      return limit_text(limit);
  return std::nullopt;
}

bool takes_seed(const Command& command) {
  return uses_placeholder(command.words, "seed") || !command.sequence.words.empty();
}

std::string entry_name(const Renderer& renderer) {
  const auto name = fmt::format("renderer '{}'", renderer.name);
  return renderer.place.empty() ? name : fmt::format("{}: {}", renderer.place, name);
}

}  // namespace orbs::registry
