#include "registry/configuration.h"

#include "base/files.h"
#include "base/pattern.h"
#include "base/plain_name.h"
#include "base/text.h"
#include "json/document.h"
#include "json/object_reader.h"
#include "registry/image_size.h"
#include "registry/limits.h"
#include "registry/placeholders.h"
#include "registry/plain_name.h"
#include "registry/run_settings.h"

#include <algorithm>

#include <fmt/format.h>

namespace orbs::registry {

namespace {

using json::ObjectReader;

constexpr int kMostRungSpp = 1 << 24;

// `known`: what may stand in braces.
std::string template_text(ObjectReader& in, const std::string& key, const std::set<std::string>& known) {
  auto text = in.system_text(key);
  if (const auto problem = placeholder_problem(text, known)) in.fail(key, *problem);
  if (text.empty()) in.fail(key, "must not be empty");
  return text;
}

std::vector<std::string> template_texts(ObjectReader& in,
                                        const std::string& key,
                                        const std::set<std::string>& known) {
  auto texts = in.system_texts(key);
  for (std::size_t i = 0; i < texts.size(); ++i)
    if (const auto problem = placeholder_problem(texts[i], known)) in.fail_at(key, i, *problem);
  if (texts.empty())
    in.fail(key, key == "plugins" ? "must hold at least one file; leave it out for none"
                                  : "must hold at least the program");
  return texts;
}

Suite load_suite_entry(ObjectReader in, const std::filesystem::path& root) {
  Suite suite;
  suite.name = plain_name(in, "name");
  suite.cases = resolve_path(root, in.system_text("cases"));
  suite.references = resolve_path(root, in.system_text("references"));
  suite.data = {suite.cases, root / "data/common"};
  // A configuration may name the cases of another place, whose common data lies as in this repository.
  if (const auto cases = suite.cases.parent_path(); cases.filename() == "cases")
    suite.data.push_back(cases.parent_path() / "common");
  if (in.has("data"))
    for (const auto& folder : in.system_texts("data")) suite.data.push_back(resolve_path(root, folder));
  in.finish();
  return suite;
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

KnownLimit load_limit(ObjectReader in, const FeatureSet& declares) {
  KnownLimit limit{in.texts("requirements"), in.text("reason")};
  for (std::size_t i = 0; i < limit.requirements.size(); ++i)
    if (const auto problem = limit_problem(limit.requirements[i], declares); !problem.empty())
      in.fail_at("requirements", i, problem);
  if (limit.reason.empty()) in.fail("reason", "must say why");
  in.finish();
  return limit;
}

FeatureSet load_features(ObjectReader& in, const std::string& key) {
  const auto text = in.text(key);
  try {
    auto features = parse_features(text);
    refuse_unknown(features);
    return features;
  } catch (const InputError& e) {
    in.fail(key, e.what());
  }
}

std::vector<std::string> load_environment(ObjectReader& in) {
  if (!in.has("environment")) return {};
  auto names = in.system_texts("environment");
  for (std::size_t i = 0; i < names.size(); ++i)
    if (names[i].empty() || names[i].front() == '=')
      in.fail_at("environment", i, "must be NAME or NAME=value");
  return names;
}

std::vector<std::string> load_command(ObjectReader& in) {
  auto command = template_texts(in, "command", command_placeholders());
  if (const auto& program = command.front(); program.empty() || program.starts_with('-'))
    in.fail_at("command", 0, fmt::format("must be a program or {{executable}}, is '{}'", program));
  for (std::size_t i = 0; i < command.size(); ++i)
    if (uses_placeholder(command[i], "arguments") && (i == 0 || command[i] != "{arguments}"))
      in.fail_at("command", i,
                 "{arguments} stands for words of their own: it must be a word after the program");
  for (const char* needed : {"scene", "output"})
    if (!uses_placeholder(command, needed))
      in.fail("command", fmt::format("must use {{{}}}, or the renderer cannot know its {}", needed, needed));
  if (!uses_placeholder(command.front(), "plugin")) return command;
  in.fail_at("command", 0, "{plugin} stands for words that may be several or none, and here is the program");
}

std::vector<std::string> load_plugins(ObjectReader& in, const std::vector<std::string>& command) {
  if (!in.has("plugins")) return {};
  auto plugins = template_texts(in, "plugins", {"root", "build"});
  if (!uses_placeholder(command, "plugin"))
    in.fail("plugins",
            "needs a word with {plugin} in the command, such as \"--plugin={plugin}\", or the renderer "
            "cannot know them");
  return plugins;
}

std::string load_native_scenes(ObjectReader& in, const std::string& format) {
  auto ending = in.text_or("native_scenes", "");
  if (format == kNativeFormat && ending.empty())
    in.fail("", "a renderer of the scene_format native needs 'native_scenes', the ending of its scenes");
  const bool plain = ending.find_first_of("/\\*? \t\n") == std::string::npos && !ending.starts_with('.');
  if (!plain) in.fail("native_scenes", fmt::format("'{}' is no ending such as \"xml\"", ending));
  return ending;
}

// `needed`: what the message says about the groups.
void check_pattern(ObjectReader& in,
                   const std::string& key,
                   const std::string& text,
                   std::size_t most_groups,
                   const char* needed) {
  try {
    const auto groups = Pattern(text).group_count();
    if (groups < 1 || groups > most_groups)
      in.fail(key, fmt::format("has {} groups in parentheses, needs {}", groups, needed));
  } catch (const InputError& e) {
    if (std::string(e.what()).starts_with(in.file())) throw;
    in.fail(key, e.what());
  }
}

RenderSeconds load_render_seconds(ObjectReader in) {
  RenderSeconds place;
  if (in.has("pattern") == in.has("file"))
    in.fail("", "needs either 'pattern', for the renderer's output, or 'file' and 'key', for a JSON file");
  if (in.has("pattern")) {
    place.pattern = in.text("pattern");
    check_pattern(
        in, "pattern", place.pattern, 3,
        "1 (seconds), 2 (minutes, seconds; or a number and its unit) or 3 (hours, minutes, seconds)");
  } else {
    place.file = in.text("file");
    const auto path = std::filesystem::path(place.file);
    if (path.empty() || path.is_absolute() || *path.lexically_normal().begin() == "..")
      in.fail("file", "must lie in the folder of the render: a relative path without '..'");
    place.key = in.text("key");
    if (place.key.empty()) in.fail("key", "must name a number in the file");
  }
  place.unit_seconds = in.number_or("unit_seconds", place.unit_seconds, json::kPositive);
  in.finish();
  return place;
}

std::map<std::string, double> load_scene_settings(ObjectReader settings) {
  std::map<std::string, double> numbers;
  for (const auto& key : settings.keys()) numbers[key] = settings.number(key);
  return numbers;
}

// The full size has the settings of the entry itself.
int divisor_of(ObjectReader& sizes, const std::string& size) {
  for (const int divisor : kSizeDivisors)
    if (divisor != 1 && size == size_text(divisor)) return divisor;
  sizes.fail(size, "is no reduced size; expected 1/2, 1/4 or 1/8");
}

std::vector<QualityRung> load_cost_ladder(ObjectReader& in) {
  std::vector<QualityRung> ladder;
  std::set<std::string> names;
  for (auto& entry : in.objects_or_none("cost_ladder")) {
    QualityRung rung;
    rung.name = plain_name(entry, "name");
    if (!names.insert(rung.name).second) entry.fail("name", "is the name of an earlier rung");
    rung.spp = entry.integer_or("spp", rung.spp, 1, kMostRungSpp);
    if (entry.has("scene_settings"))
      rung.scene_settings = load_scene_settings(entry.object("scene_settings"));
    entry.finish();
    ladder.push_back(std::move(rung));
  }
  return ladder;
}

void load_all_scene_settings(ObjectReader& in, Renderer& renderer) {
  if (in.has("scene_settings")) renderer.scene_settings = load_scene_settings(in.object("scene_settings"));
  if (in.has("scene_settings_of_sizes")) {
    auto sizes = in.object("scene_settings_of_sizes");
    for (const auto& size : sizes.keys())
      renderer.scene_settings_of_sizes[divisor_of(sizes, size)] = load_scene_settings(sizes.object(size));
  }
  if (in.has("scene_settings_of_scenes")) {
    auto scenes = in.object("scene_settings_of_scenes");
    for (const auto& scene : scenes.keys())
      renderer.scene_settings_of_scenes[scene] = load_scene_settings(scenes.object(scene));
  }
}

Renderer load_renderer(ObjectReader& in, const ProcessLimits& limits) {
  Renderer renderer;
  renderer.name = plain_name(in, "name");
  renderer.place = in.place("name");
  const std::set<std::string> places{"root", "build"};
  renderer.executable = template_text(in, "executable", places);
  if (in.has("version_command"))
    renderer.version_command = template_texts(in, "version_command", executable_placeholders());
  if (in.has("version_pattern")) {
    renderer.version_pattern = in.text("version_pattern");
    check_pattern(in, "version_pattern", renderer.version_pattern, 1, "1, which holds the version");
  }
  renderer.scene_format = in.text_or("scene_format", kNeutralFormat);
  load_all_scene_settings(in, renderer);
  if (in.has("transports")) {
    auto words = in.object("transports");
    for (const auto& name : words.keys()) {
      renderer.transports[name] = words.system_text(name);
      if (renderer.transports[name].empty()) words.fail(name, "must not be empty");
    }
    words.finish();
  }
  renderer.native_scenes = load_native_scenes(in, renderer.scene_format);
  renderer.declares = load_features(in, "declares");
  for (auto& limit : in.objects_or_none("known_limits"))
    renderer.known_limits.push_back(load_limit(std::move(limit), renderer.declares));
  renderer.command = load_command(in);
  renderer.plugins = load_plugins(in, renderer.command);
  renderer.limits = limits;
  if (in.has("limits")) read_limits(in.object("limits"), renderer.limits);
  renderer.spp_scale = in.number_or("spp_scale", renderer.spp_scale, json::kPositive);
  if (in.has("spp_scale_of_scenes")) {
    auto scenes = in.object("spp_scale_of_scenes");
    for (const auto& name : scenes.keys())
      renderer.spp_scale_of_scenes[name] = scenes.number(name, json::kPositive);
  }
  renderer.seeds = in.integer_or("seeds", renderer.seeds, 1, kMostSeeds);
  if (renderer.seeds > 1 && !uses_placeholder(renderer.command, "seed"))
    in.fail("seeds", "needs {seed} in the command, or all renders would be the same");
  renderer.seed_stride = in.integer_or("seed_stride", renderer.seed_stride, 1, kLargestSeed);
  if (renderer.seed_stride > 1 && !uses_placeholder(renderer.command, "seed"))
    in.fail("seed_stride", "needs {seed} in the command, which it multiplies");
  renderer.biased = in.text_or("biased", "");
  renderer.is_noise_free = in.boolean_or("noise_free", renderer.is_noise_free);
  if (renderer.is_noise_free && uses_placeholder(renderer.command, "seed"))
    in.fail("noise_free", "contradicts {seed} in the command: what depends on a seed has noise");
  renderer.has_box_filter = in.boolean_or("box_filter", renderer.has_box_filter);
  if (in.has("double_precision")) renderer.double_precision = in.system_texts("double_precision");
  if (in.has("render_seconds")) renderer.render_seconds = load_render_seconds(in.object("render_seconds"));
  renderer.cost_ladder = load_cost_ladder(in);
  renderer.environment = load_environment(in);
  return renderer;
}

Renderer load_variant(ObjectReader in, const Renderer& entry) {
  auto variant = entry;
  variant.variant_of = entry.name;
  variant.name = fmt::format("{}-{}", entry.name, plain_name(in, "name"));
  if (variant.name.size() > kMostNameCharacters)
    in.fail("name", fmt::format("'{}' has {} characters, may have {}", variant.name, variant.name.size(),
                                kMostNameCharacters));
  variant.place = in.place("name");
  variant.arguments = in.system_texts("arguments");
  for (std::size_t i = 0; i < variant.arguments.size(); ++i)
    if (const auto problem = placeholder_problem(variant.arguments[i], argument_placeholders()))
      in.fail_at("arguments", i, *problem);
  variant.biased = in.text_or("biased", entry.biased);
  in.finish();
  return variant;
}

// Appends the renderers that an entry stands for: one for each of its variants, or the entry itself without
// any.
void add_variants(ObjectReader& entry, const Renderer& renderer, std::vector<Renderer>& renderers) {
  const auto add = [&](ObjectReader& place, Renderer added) {
    if (std::any_of(renderers.begin(), renderers.end(),
                    [&](const auto& earlier) { return earlier.name == added.name; }))
      place.fail("name", fmt::format("'{}' is the name of an earlier renderer", added.name));
    renderers.push_back(std::move(added));
  };
  if (!entry.has("variants")) {
    add(entry, renderer);
    return;
  }
  auto variants = entry.objects("variants");
  if (variants.empty()) entry.fail("variants", "must hold at least one; leave it out for none");
  for (auto& variant : variants) add(variant, load_variant(variant, renderer));
}

// The reader of an entry is used up by loading it, so names given twice are looked for beforehand.
void refuse_doubles(std::vector<ObjectReader> entries) {
  std::set<std::string> names;
  for (auto& entry : entries)
    if (const auto name = entry.text("name"); !names.insert(name).second)
      entry.fail("name", fmt::format("'{}' is the name of an earlier entry", name));
}

}  // namespace

Configuration parse_configuration(const std::filesystem::path& file, const std::string& text) {
  const auto document = json::parse(file.string(), text);
  ObjectReader in(document);
  in.one_of("format", {"orbs-configuration/1"});
  Configuration configuration;
  configuration.file = std::filesystem::absolute(file).lexically_normal();
  configuration.root = configuration.file.parent_path();
  if (in.has("defaults")) configuration.defaults = read_run_settings(in.object("defaults"));
  refuse_doubles(in.objects("suites"));
  for (auto& entry : in.objects("suites"))
    configuration.suites.push_back(load_suite_entry(std::move(entry), configuration.root));
  ProcessLimits limits;
  if (in.has("limits")) read_limits(in.object("limits"), limits);
  refuse_doubles(in.objects("renderers"));
  for (auto& entry : in.objects("renderers")) {
    const auto renderer = load_renderer(entry, limits);
    add_variants(entry, renderer, configuration.renderers);
    entry.finish();
  }
  std::vector<std::string> names;
  for (const auto& renderer : configuration.renderers) names.push_back(renderer.name);
  configuration.expected = load_expected(in, names);
  if (in.has("slurm")) configuration.slurm = load_slurm(in.object("slurm"));
  in.finish();
  return configuration;
}

Configuration load_configuration(const std::filesystem::path& file) {
  return parse_configuration(file, read_file(file));
}

const Suite& find_suite(const Configuration& configuration, const std::string& name) {
  std::set<std::string> names;
  for (const auto& suite : configuration.suites) {
    if (suite.name == name) return suite;
    names.insert(suite.name);
  }
  throw InputError(
      fmt::format("{}: has no suite '{}'{}", configuration.file.string(), name, closest(name, names)));
}

std::optional<std::string> limit_reason(const Renderer& renderer, const std::string& requirement) {
  for (const auto& limit : renderer.known_limits)
    if (std::find(limit.requirements.begin(), limit.requirements.end(), requirement) !=
        limit.requirements.end())
      return limit.reason;
  return std::nullopt;
}

std::string entry_name(const Renderer& renderer) {
  const auto name = fmt::format("renderer '{}'", renderer.name);
  return renderer.place.empty() ? name : fmt::format("{}: {}", renderer.place, name);
}

std::optional<std::filesystem::path> nearest_configuration(std::filesystem::path from) {
  for (;;) {
    std::error_code ignored;
    if (std::filesystem::is_regular_file(from / "configuration.json", ignored))
      return from / "configuration.json";
    if (!from.has_relative_path()) return std::nullopt;
    from = from.parent_path();
  }
}

}  // namespace orbs::registry
