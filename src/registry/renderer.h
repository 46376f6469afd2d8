#pragma once

#include "base/process_limits.h"
#include "json/fields.h"
#include "registry/features.h"
#include "registry/image_size.h"
#include "registry/limits.h"
#include "registry/run_settings.h"
#include "registry/version_range.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

/// The entry of a renderer in configuration.json.
namespace orbs::registry {

/// Words of "scene_format". Neutral: scenes as the suite holds them. Native: a format of the renderer's own,
/// of which there are hand-written scenes only. All other words are those of the exporters, who check them.
inline constexpr const char* kNeutralFormat = "orbs-scene";
inline constexpr const char* kNativeFormat = "native";

/// How a program is called that takes no seed, but renders several images in one run, each with the random
/// numbers that follow those of the image before. A render of `n` samples with seed `s` is then the `s`-th
/// image of such a run.
struct ImageSequence {
  std::vector<std::string> words;  // in the place of {images} in the command, once for each image
  std::string suffix;              // of the name of an image, before its ending, where a run makes several
};

template <class Visitor, json::RecordOf<ImageSequence> Record>
void fields(Visitor& visit, Record& sequence) {
  visit.required(
      "words", sequence.words,
      {.help =
           "Words that ask for one image: they stand in the place of `{images}` in the command as often as "
           "the seed says, and the last image counts"});
  visit.required(
      "suffix", sequence.suffix,
      {.help = "What the program puts before the ending of `{output}` where it renders several images"});
}

/// How the program is called. No shell is involved.
struct Command {
  std::string executable;  // a path with placeholders, or a program on PATH
  std::vector<std::string> words;
  std::vector<std::string> arguments;  // of the variant, in the place of {arguments} in the words
  std::vector<std::string> plugins{};  // with {root} and {build}, relative to the folder of the configuration
  std::vector<std::string> environment;
  std::vector<std::string> readable{};  // in a sandbox; as plugins
  std::vector<std::string> version_command;
  std::string version_pattern;                  // "" for the whole first line
  ImageSequence sequence{};                     // without words: it takes a seed, or none at all
  std::vector<std::string> fails_on{};          // patterns for lines of its output
  std::vector<std::string> double_precision{};  // none: it has no double precision
  bool is_elsewhere = false;  // on no machine of ours: its scenes are exported, and its images come back
};

template <class Visitor, json::RecordOf<Command> Record>
void fields(Visitor& visit, Record& command) {
  visit.required("executable", command.executable,
                 {.help = "A program on PATH, or a path that may begin with `{root}`, the folder of "
                          "`configuration.json`, or `{build}`"});
  visit("elsewhere", command.is_elsewhere,
        {.help =
             "`true`: the program is on no machine that `orbs` knows. `orbs export` writes its scenes and "
             "`orbs judge` judges the images that come back; all else leaves it out unless `--exec` names a "
             "program",
         .changes_image = false});
  visit.required(
      "command", command.words,
      {.help = "Program and arguments, each word one argument; must use `{scene}` and `{output}`"});
  visit("plugins", command.plugins,
        {.help = "Files of plug-ins, relative to `configuration.json`; they may begin with `{root}` or "
                 "`{build}`. The command needs a word with `{plugin}`, which stands there once for each"});
  visit("environment", command.environment, {.help = "`NAME`, passed on from the caller, or `NAME=value`"});
  visit(
      "readable", command.readable,
      {.help = "Files and folders that it reads under `--sandbox` beside what its command and `environment` "
               "name, relative to `configuration.json`; they may begin with `{root}` or `{build}`",
       .changes_image = false});
  visit("version_command", command.version_command,
        {.help =
             "Prints its version: it must end within 5 s, and with exit status 0 unless the pattern matches",
         .changes_image = false});
  visit("version_pattern", command.version_pattern,
        {.help =
             "POSIX extended regular expression with one group, which holds the version in the first line of "
             "the output that matches",
         .unset = "the whole first line",
         .changes_image = false});
  visit("image_sequence", command.sequence,
        {.help =
             "For a program that takes no seed, but renders several images in one run, each with the random "
             "numbers that follow those of the one before: they take the place of seeds"});
  visit(
      "fails_on", command.fails_on,
      {.help =
           "POSIX extended regular expressions: a render with a line of output that matches one has failed, "
           "whatever its exit code"});
  visit(
      "double_precision", command.double_precision,
      {.help = "Arguments that follow the command where it is to work in double precision; `orbs stability` "
               "and runs of cases that bound it then compare both",
       .changes_image = false});
}

using SceneSettings = std::map<std::string, double>;

/// What the renderer reads.
struct SceneFormat {
  std::string name = kNeutralFormat;
  SceneSettings settings;  // numbers for the exporter of the format; which, it says itself
  std::map<SizeDivisor, SceneSettings> settings_of_sizes;
  std::map<std::string, SceneSettings> settings_of_scenes;
  /// What {transport} stands for, by the name of what the light paths of a scene must carry ("spectral");
  /// these names themselves where it is empty.
  std::map<std::string, std::string> transports;
  std::string native_scenes;  // ending of scenes written by hand for it, "xml"; "" when it has none
};

template <class Visitor, json::RecordOf<SceneFormat> Record>
void fields(Visitor& visit, Record& format) {
  visit(
      "scene_format", format.name,
      {.help =
           "`orbs-scene`, `povray`, `mitsuba`, `pbrt`, `hydra`, `gltf`, `obj`, `ply`, or `native` for hand-written scenes only"});
  visit(
      "scene_settings", format.settings,
      {.help =
           "Numbers for the exporter of the scene format, such as POV-Ray's `photons`. Every format has "
           "`origin_near_camera`: 1 moves the origin of the coordinates of a scene that is far from it and leaves out whole repetitions "
           "of textures, 0 "
           "leaves it; without it `orbs-scene` is left as it is, and the others are moved"});
  // Those that a render gets are in scene_settings by then, see at_size() and for_scene().
  visit("scene_settings_of_sizes", format.settings_of_sizes,
        {.help = "Numbers in place of those at a reduced size: `{\"1/4\": {\"photons\": 800000}}`",
         .changes_image = false});
  visit("scene_settings_of_scenes", format.settings_of_scenes,
        {.help = "Numbers in place of both for single scenes: `{\"124\": {\"area_grid\": 16}}`",
         .changes_image = false});
  visit("transports", format.transports,
        {.help = "What `{transport}` stands for in the command, by the transport that the scene calls for "
                 "(`orbs effects` says it). A scene whose transport is not listed is unsupported",
         .unset = "the name of the transport"});
  visit("native_scenes", format.native_scenes,
        {.help =
             "Ending of scenes written by hand for it: `<case>/<renderer>/<scene>.<ending>` is used in place "
             "of an exported scene",
         .changes_image = false});  // the hash of the scene has the file
}

/// Requirements that a renderer cannot meet, and why; the reason stands in the report.
struct KnownLimit {
  std::vector<std::string> requirements;
  std::string reason;
  VersionRange version{};  // of which it was found
};

template <class Visitor, json::RecordOf<KnownLimit> Record>
void fields(Visitor& visit, Record& limit) {
  visit.required("requirements", limit.requirements, {.help = "Requirements such as M7"});
  visit.required("reason", limit.reason, {.help = "Why it cannot meet them"});
  visit(
      "version", limit.version,
      {.help =
           "The versions of the renderer of which this is known, such as `>=3.4 <4`; it stands in the report",
       .unset = "every version"});
}

/// What the renderer says that it can do.
struct Support {
  FeatureSet declares;
  std::vector<KnownLimit> known_limits;
};

template <class Visitor, json::RecordOf<Support> Record>
void fields(Visitor& visit, Record& support) {
  visit.required(
      "declares", support.declares,
      {.help = "ORB.S feature numbers: `G5/M8-(7)/L3/A3` is all of G1 to G5, M1 to M8 without M7, L1 to "
               "L3, A1 to A3. A scene that needs more is reduced to what is declared, or `unsupported` "
               "where that is not possible"});
  visit("known_limits", support.known_limits,
        {.help = "`requirements` that it cannot meet, each with the `reason` for the report",
         .changes_image = false});
}

/// How many samples and seeds a render gets, and what is known of its noise.
struct Sampling {
  double spp_scale = 1;  // samples of this renderer for one sample of the case
  int seeds = 1;
  int seed_stride = 1;
  int least_spp = 1;               // of one render
  bool has_fixed_samples = false;  // further renders with other seeds are no more samples
  std::string biased;          // why no quality of it is right to the last digit; "" where nothing is known
  bool is_noise_free = false;  // draws no random samples: what differs from a reference is an error
  bool has_box_filter = true;  // only then is an image of fewer pixels the average of the full one
};

template <class Visitor, json::RecordOf<Sampling> Record>
void fields(Visitor& visit, Record& sampling) {
  // The id of a render has its samples.
  visit("spp_scale", sampling.spp_scale,
        {.help = "Its samples for one sample of the case", .range = json::kPositive, .changes_image = false});
  visit("seeds", sampling.seeds,
        {.help =
             "So many renders with consecutive seeds in place of one, which share the samples: their scatter "
             "gives the variance; needs `{seed}`",
         .range = {1, kMostSeeds}});
  visit(
      "seed_stride", sampling.seed_stride,
      {.help = "`{seed}` is the seed times this: for renderers whose neighbouring seeds draw the same random "
               "numbers in neighbouring pixels, such as Mitsuba",
       .range = {1, kLargestSeed}});
  visit("least_spp", sampling.least_spp,
        {.help =
             "The fewest samples that one of its renders has: more where its start takes longer than they do",
         .range = {1, 1 << 20},
         .changes_image = false});
  visit(
      "fixed_samples", sampling.has_fixed_samples,
      {.help =
           "`true`: the mean of its renders with several seeds is no image of more samples, as of a photon map "
           "or a denoiser, so one render with the samples of the case decides",
       .changes_image = false});
  visit("biased", sampling.biased,
        {.help = "Why it converges to another image than the right one, in a few words: `irradiance cache`, "
                 "`denoised`; `orbs cost` labels its curves with it",
         .changes_image = false});
  // What was judged is judged anew, see judged_hash().
  visit(
      "noise_free", sampling.is_noise_free,
      {.help =
           "It draws no random samples, so whatever differs from a reference is an error of the image; must "
           "not use `{seed}`",
       .changes_image = false});
  visit("box_filter", sampling.has_box_filter,
        {.help = "`false`: a pixel is not the plain mean over its square, so an image of fewer pixels is no "
                 "average of the full one, and its targets are `unsupported` at a reduced size",
         .changes_image = false});
}

/// What its images hold.
struct ImageNames {
  std::map<std::string, std::string> channels;  // by our name, "depth.Z"; empty: it has our names
};

template <class Visitor, json::RecordOf<ImageNames> Record>
void fields(Visitor& visit, Record& names) {
  visit("channels", names.channels,
        {.help = "What its images call channels by another name: `{\"R\": \"beauty.R\", \"depth.Z\": "
                 "\"z.V\"}`. One that an image holds by our name stays, and one that it lacks is left out"});
}

/// Where a renderer says how long it has rendered, start and files not counted: in its output or in a file.
/// Nothing is looked for where both are "".
struct RenderSeconds {
  std::string pattern{};
  std::string file{};
  std::string key{};
  double unit_seconds = 1;
};

template <class Visitor, json::RecordOf<RenderSeconds> Record>
void fields(Visitor& visit, Record& seconds) {
  visit(
      "pattern", seconds.pattern,
      {.help =
           "POSIX extended regular expression for its output, the last match counts; groups: seconds, or "
           "minutes and seconds, or hours, minutes and seconds; or a number and its unit (us, ms, s, m, min, "
           "h, d)"});
  visit("file", seconds.file, {.help = "JSON file that it writes into the folder of the render"});
  visit("key", seconds.key,
        {.help = "Number in the file: `seconds`, or `timing/render` for one in an object"});
  visit("unit_seconds", seconds.unit_seconds, {.help = "0.001 for milliseconds", .range = json::kPositive});
}

/// One quality of a renderer whose accuracy does not follow from its samples alone.
struct SweepSetting {
  std::string name;
  int spp = 1;  // that the renderer gets
  SceneSettings scene_settings;
};

template <class Visitor, json::RecordOf<SweepSetting> Record>
void fields(Visitor& visit, Record& setting) {
  visit.required("name", setting.name);
  visit("spp", setting.spp, {.help = "Samples per pixel that the renderer gets", .range = {1, 1 << 24}});
  visit("scene_settings", setting.scene_settings, {.help = "In place of those of the entry"});
}

/// How its time is known, and what is rendered to see what accuracy costs.
struct Timing {
  RenderSeconds render_seconds;
  RenderSeconds trial_seconds;           // of what it tries before it renders, which render_seconds holds
  std::vector<SweepSetting> cost_sweep;  // from cheap to accurate; none: more and more samples
};

template <class Visitor, json::RecordOf<Timing> Record>
void fields(Visitor& visit, Record& timing) {
  visit("render_seconds", timing.render_seconds,
        {.help =
             "Where it says its own render time: a `pattern` for its output, or a `file` and `key` in JSON"});
  visit("trial_seconds", timing.trial_seconds,
        {.help = "Likewise, where it says how much of its render time trial renderings took, by which it "
                 "chooses its algorithms; `orbs cost` shows them beside its render time",
         .changes_image = false});
  visit("cost_sweep", timing.cost_sweep,
        {.help =
             "Qualities that `orbs cost` renders, from cheap to accurate, for a renderer whose accuracy does "
             "not follow from its samples alone: each has a `name`, `spp` and `scene_settings`",
         .unset = "more and more samples",
         .changes_image = false});
}

struct Renderer {
  std::string name;        // of a variant: "<entry>-<variant>"
  std::string variant_of;  // name of the entry that lists it as a variant; "" for an entry without variants
  std::string place;       // file:line of the entry, for messages; "" when it comes from no file
  Command command;
  SceneFormat format;
  Support support;
  Sampling sampling;
  ImageNames image_names;
  Timing timing;
  ProcessLimits limits;             // those of the file, with the entry's own in their place
  bool is_only_when_named = false;  // it is none of all renderers
};

/// What an entry of the file and the renderer that it stands for have in common: what a variant adds, and the
/// limits, come from elsewhere.
template <class Visitor, json::RecordOf<Renderer> Record>
void fields(Visitor& visit, Record& renderer) {
  visit.required("name", renderer.name, {.help = "In lists, tables and folders", .changes_image = false});
  visit(
      "only_when_named", renderer.is_only_when_named,
      {.help = "`true`: it takes part only where `-r` names it, or a pattern that is more than `*` fits its "
               "name: a second way to one program, which need not be in every run",
       .changes_image = false});
  fields(visit, renderer.command);
  fields(visit, renderer.support);
  fields(visit, renderer.format);
  fields(visit, renderer.sampling);
  fields(visit, renderer.image_names);
  fields(visit, renderer.timing);
}

/// A way to call the same program, as another renderer.
struct Variant {
  std::string name;
  std::vector<std::string> arguments;
  std::optional<std::string> biased;  // in place of that of the entry
  SceneSettings scene_settings{};     // in place of those of the entry
};

template <class Visitor, json::RecordOf<Variant> Record>
void fields(Visitor& visit, Record& variant) {
  visit.required("name", variant.name, {.help = "The renderer is called `<entry>-<name>`"});
  visit.required("arguments", variant.arguments,
                 {.help = "In the place of `{arguments}` in the command, or at its end"});
  visit("biased", variant.biased, {.help = "In place of that of the entry"});
  visit("scene_settings", variant.scene_settings, {.help = "In place of those of the entry, one by one"});
}

struct RendererEntry {
  Renderer renderer;
  LimitSettings limits;
  std::vector<Variant> variants;
};

template <class Visitor, json::RecordOf<RendererEntry> Record>
void fields(Visitor& visit, Record& entry) {
  fields(visit, entry.renderer);
  visit("limits", entry.limits,
        {.help = "Of all processes of a render together, in place of those of the file"});
  visit("variants", entry.variants,
        {.help = "Ways to call the same program, each another renderer in every table: `name`, `arguments`, "
                 "and `biased` and `scene_settings` in place of the entry's"});
}

/// The renderers that an entry stands for: one for each of its variants, or the entry itself without any.
/// `limits` are those of the file, and `in` is where the entry was read. InputError with file, line and key
/// for what does not fit together: unknown placeholders, a command without {scene} or {output}, and the like.
std::vector<Renderer> renderers_of(json::ObjectReader& in, RendererEntry entry, const ProcessLimits& limits);

/// The reason, with the versions of which it is known where the entry says them: "... (version <4)".
std::string limit_text(const KnownLimit& limit);

/// The text of the limit that `renderer` gives for not meeting a requirement; nothing when it gives none.
std::optional<std::string> limit_reason(const Renderer& renderer, const std::string& requirement);

/// Whether two renders with other seeds differ, so that several of them are more samples.
bool takes_seed(const Command& command);

/// "configuration.json:14: renderer 'pbrt'", as messages about the entry begin.
std::string entry_name(const Renderer& renderer);

}  // namespace orbs::registry
